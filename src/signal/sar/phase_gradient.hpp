#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"
#include "signal/sar/autofocus.hpp"

namespace sarsim::signal {

/// Columns of an image, each with its azimuth in one piece.
class AzimuthColumns {
 public:
  AzimuthColumns(std::size_t columns, std::size_t size) : size_(size), values_(columns * size) {}

  [[nodiscard]] std::size_t count() const { return size_ > 0 ? values_.size() / size_ : 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<std::complex<double>> column(std::size_t i) {
    return std::span(values_).subspan(i * size_, size_);
  }
  [[nodiscard]] std::span<const std::complex<double>> column(std::size_t i) const {
    return std::span(values_).subspan(i * size_, size_);
  }

 private:
  std::size_t size_;
  std::vector<std::complex<double>> values_;
};

/// Frequencies that an aperture may have, in steps of 1/size.
struct SpectrumBand {
  double centre = 0.0;  ///< Any fold of the spectrum.
  double width = 0.0;   ///< Full; 0: all.
};

/// What the phase gradient says about the spectra of columns.
struct GradientResult {
  long first_frequency = 0;       ///< In steps of 1/size; the middle lies within half the sampling rate of the band's.
  std::vector<double> phase_rad;  ///< From there on, within the aperture.
  std::vector<double> round_rad;
  std::vector<double> amplitude;  ///< Of the spectra there, root mean square: as long as phase_rad.
  double energy = 0.0;            ///< Of the columns.
};

/// Phase gradient autofocus of columns; signal/sar/autofocus.hpp says how.
/// @param[in,out] columns  corrected, and without what lies beyond the aperture
GradientResult phase_gradient(AzimuthColumns& columns, const SpectrumBand& band, const AutofocusOptions& options,
                              const core::WorkControl& control);

/// Turns every frequency of every column by `phase_rad(column, frequency)`; frequencies from -size/2 on.
void turn_spectra(AzimuthColumns& columns, const core::WorkControl& control,
                  const std::function<double(std::size_t, long)>& phase_rad);

/// Takes the straight line that fits best out of evenly spaced values.
void remove_line(std::span<double> values);

/// y = constant + slope x.
struct StraightLine {
  double constant = 0.0;
  double slope = 0.0;

  [[nodiscard]] double at(double x) const { return constant + slope * x; }
};

/// The line that fits best to values of different weights; level where they all lie at one place, 0 without weights.
/// @param x, y, weights  of one length
[[nodiscard]] StraightLine best_line(std::span<const double> x, std::span<const double> y,
                                     std::span<const double> weights);

}  // namespace sarsim::signal
