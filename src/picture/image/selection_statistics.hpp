#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::picture {

/// What of a complex sample is looked at.
enum class SampleQuantity {
  real,
  imaginary,
  magnitude,
  decibels,  ///< 20 log10 of the magnitude; samples of 0 have none.
  phase,     ///< -pi to pi, radians; samples of 0 have none.
};
inline constexpr std::size_t sample_quantities = 5;

/// "real", "imaginary", "magnitude", "dB", "phase".
[[nodiscard]] std::string_view name_of(SampleQuantity quantity);

/// How often values fall between `low` and `high`, in bins of equal width.
struct Histogram {
  double low = 0.0;
  double high = 1.0;
  std::vector<std::uint64_t> bins;

  [[nodiscard]] double bin_width() const { return (high - low) / static_cast<double>(bins.size()); }
  /// The value below which the given part of the values lies, interpolated within its bin, so right to a bin's width;
  /// `low` where there are none.
  [[nodiscard]] double percentile(double part) const;
};

/// Of one quantity over a selection. All 0 where no sample has a value.
struct QuantityStatistics {
  std::uint64_t count = 0;
  double minimum = 0.0;
  double maximum = 0.0;
  double mean = 0.0;
  double rms = 0.0;
  double deviation = 0.0;  ///< Standard deviation, of all samples (divided by their number).
  Histogram histogram;     ///< Real and imaginary: symmetric about 0; magnitude: from 0; all 2048 bins or more.

  /// `part` and 1 - `part` as limits for colours, within minimum and maximum.
  struct Limits {
    double low = 0.0;
    double high = 0.0;
  };
  /// The limits that leave out a share of the values at either end.
  /// @param part  of the values, 0 to 0.5
  [[nodiscard]] Limits limits(double part) const;
};

/// Figures of a selection.
struct SelectionStatistics {
  std::uint64_t samples = 0;
  std::uint64_t not_finite = 0;  ///< Left out of everything.
  std::uint64_t zeros = 0;       ///< Left out of decibels and phase.
  std::array<QuantityStatistics, sample_quantities> of;

  [[nodiscard]] const QuantityStatistics& operator[](SampleQuantity quantity) const {
    return of[static_cast<std::size_t>(quantity)];
  }
};

/// Reads a window of any size once, a few MB at a time, and measures it. The number of threads does not change the
/// result. Means and deviations are gathered part by part (Chan, Golub, LeVeque: "Updating formulae and a pairwise
/// algorithm for computing sample variances", 1979), so that a small deviation of large values keeps its digits.
/// Throws Interrupted where asked to stop, and what reading the plane throws.
[[nodiscard]] SelectionStatistics measure_selection(const raster::Raster& plane, const raster::ImageWindow& window,
                                                    const core::WorkControl& control = {},
                                                    const core::ProgressReport& progress = {});

}  // namespace sarsim::picture
