#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"
#include "signal/compress/range_compression.hpp"
#include "signal/stepped/stepped_band.hpp"

namespace sarsim::signal {

/// The ranges of a profile: first_m + k step_m, one way.
struct ProfileAxis {
  double first_m = 0.0;
  double step_m = 0.0;
  std::size_t count = 0;

  [[nodiscard]] double at(double index) const { return first_m + index * step_m; }
  [[nodiscard]] double index_of(double range_m) const { return (range_m - first_m) / step_m; }
};

/// Synthetic range profiles over any stretch of ranges, from the joined cells Z of a burst:
///
///     p(R) = sum over cells of w Z exp(+2 pi j (nu - centre) 2 R/c)/sum of w.
///
/// Each range is taken from the gate that shows it best, so that a profile is as long as the recording, not as its
/// c/(2 step). A resting target keeps the mean amplitude of its echoes, and has the phase -4 pi centre R/c. Bins
/// without a gate, and gates that hold nothing, are 0.
class ProfileMaker {
 public:
  /// @param band          is copied
  /// @param window        weight of cell k at k/(cells - 1); empty: none
  /// @param from_m, to_m  ranges that are covered
  /// @param oversampling  bins for each c/(2 B), at least 1
  ProfileMaker(const SteppedBand& band, const WindowFunction& window, double from_m, double to_m,
               std::size_t oversampling);

  [[nodiscard]] const ProfileAxis& axis() const { return axis_; }
  [[nodiscard]] const SteppedBand& band() const { return band_; }
  /// The weights of the cells, sum 1 over those that are filled.
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }

  /// @param values   of a burst, as SteppedBand::join takes them
  /// @param motion   as there
  /// @param[out] out axis().count bins
  void make(std::span<const std::complex<double>> values, std::span<const PulseMotion> motion,
            std::span<std::complex<double>> out) const;
  /// Adds the power of the burst over one whole period of ranges, c/(2 cell_hz): of the gates that are not much weaker
  /// than the strongest, each target in the bin of its range modulo the period, whichever gates see it. What a speed
  /// that is not compensated moves stays inside.
  /// @param[in,out] power  period() bins
  void add_power(std::span<const std::complex<double>> values, std::span<const PulseMotion> motion,
                 std::span<double> power) const;
  [[nodiscard]] std::size_t period() const { return fft_.size(); }
  /// The same as `make` from joined cells.
  void transform(std::span<const std::complex<double>> joined, std::span<std::complex<double>> out) const;

 private:
  [[nodiscard]] std::vector<std::size_t> strong_gates(std::span<const std::complex<double>> values) const;
  void transform_gate(std::span<const std::complex<double>> joined, std::size_t gate,
                      std::vector<std::complex<double>>& work) const;

  SteppedBand band_;
  ProfileAxis axis_;
  std::vector<double> weights_;
  std::vector<std::size_t> gate_;  // of each bin
  core::Fft fft_;
};

/// A peak of a profile, between its bins.
struct ProfilePeak {
  double range_m = 0.0;
  double amplitude = 0.0;
  double phase_rad = 0.0;  ///< Of the bin nearest to it.
  double width_m = 0.0;    ///< Between the points at half the power; 0 where the profile does not fall so far.
};

/// The largest peak within `search_m` of a range; nothing where there is none but the ends of that stretch.
[[nodiscard]] std::optional<ProfilePeak> peak_near(std::span<const std::complex<double>> profile,
                                                   const ProfileAxis& axis, double range_m, double search_m);

/// The highest peaks, at least `apart_m` from each other, strongest first.
/// @param least  of their amplitude, relative to the strongest
[[nodiscard]] std::vector<ProfilePeak> highest_peaks(std::span<const std::complex<double>> profile,
                                                     const ProfileAxis& axis, std::size_t most, double apart_m,
                                                     double least);

/// -ln of the sum of q^2, q the share of each bin in the energy of a profile (Renyi's entropy of order 2): the smaller,
/// the sharper. Strong peaks decide, so that noise in many bins hides little. 0 without energy.
[[nodiscard]] double entropy_of(std::span<const double> power);

}  // namespace sarsim::signal
