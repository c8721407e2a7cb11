#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

#include "picture/colour/colour_map.hpp"

namespace sarsim::picture {

/// What of a complex sample is shown.
enum class DisplayQuantity { real, imaginary, magnitude, phase, decibels };

/// "Real", "Imaginary", "Magnitude", "Phase", "dB power".
[[nodiscard]] std::string_view title_of(DisplayQuantity quantity);
/// The same where the unit stands behind it, at axes and colour bars: "Power" for "dB power".
[[nodiscard]] std::string_view axis_title_of(DisplayQuantity quantity);
/// The unit of its values: "V", "V", "V", "deg", "dB".
[[nodiscard]] std::string_view unit_of(DisplayQuantity quantity);
/// Kind of map that suits it: diverging for signed numbers, cyclic for the phase.
[[nodiscard]] ColourMapKind kind_for(DisplayQuantity quantity);

/// What decibels count from and where they end.
struct Decibels {
  enum class Reference {
    maximum,  ///< The largest magnitude in the picture is 0 dB.
    volts,    ///< `reference_v` is.
  };
  Reference reference = Reference::maximum;
  double reference_v = 1.0;
  double range_db = 60.0;  ///< Shown below the upper limit; values further below are at the floor.

  friend bool operator==(const Decibels&, const Decibels&) = default;
};

/// The lowest value that decibels have, whatever the range; what silence is shown as.
inline constexpr double lowest_db = -400.0;

/// The value of a quantity of one sample: V, degrees in (-180, 180], or 20 log10(|s|/reference), not below `lowest_db`.
/// Not a number where the sample is none.
/// @param reference_v  of decibels, positive
[[nodiscard]] double value_of(DisplayQuantity quantity, std::complex<double> sample, double reference_v = 1.0);

/// How the limits of the colours are found.
struct LimitRule {
  enum class Kind {
    automatic,  ///< By percentile of the magnitude; real and imaginary symmetric about 0.
    extremes,   ///< Smallest and largest value, as the original did.
    manual,     ///< `low` to `high`.
  };
  Kind kind = Kind::automatic;
  double percentile = 100.0;  ///< Of the samples at most this share lies within the limits; 100: all.
  double low = 0.0;
  double high = 1.0;

  friend bool operator==(const LimitRule&, const LimitRule&) = default;
};

/// How complex samples become colours: the choices that all windows of samples have in common.
struct ColourLook {
  DisplayQuantity quantity = DisplayQuantity::real;
  ColourMap map = ColourMap::balance_dark;
  bool inverted = false;  ///< The colours in the opposite order.
  ClassicSliders sliders;
  LimitRule limits;
  Decibels decibels;

  friend bool operator==(const ColourLook&, const ColourLook&) = default;
};

/// Values at the ends of the colours, low < high.
struct ColourLimits {
  double low = 0.0;
  double high = 1.0;

  friend bool operator==(const ColourLimits&, const ColourLimits&) = default;
};

/// What a picture's colours are made from.
struct SampleStatistics {
  std::size_t count = 0;   ///< Finite samples.
  double largest_v = 0.0;  ///< Magnitude.
  double lowest_real_v = 0.0, highest_real_v = 0.0;
  double lowest_imaginary_v = 0.0, highest_imaginary_v = 0.0;
  double smallest_v = 0.0;
  double percentile_v = 0.0;  ///< Of the magnitude, of the share asked for.
};

/// Statistics of one row, percentile_v being the largest magnitude.
[[nodiscard]] SampleStatistics statistics_of(std::span<const std::complex<double>> samples);
/// Statistics of two sets of samples together; percentile_v becomes the largest magnitude.
[[nodiscard]] SampleStatistics together(const SampleStatistics& a, const SampleStatistics& b);

/// Magnitude that a share of the samples does not exceed, looking at at most 65 536 of them, evenly spread; 0 where
/// there are none.
/// @param rows        how many, of the same length; `row(i)` gives them
/// @param percentile  0 to 100
[[nodiscard]] double magnitude_percentile(std::size_t rows,
                                          const std::function<std::span<const std::complex<double>>(std::size_t)>& row,
                                          double percentile);

/// Reference of decibels for samples with these statistics; 1 V where they are all 0.
[[nodiscard]] double reference_v(const Decibels& decibels, const SampleStatistics& statistics);

/// Limits of the colours. Automatic: real and imaginary part from -p to p, p the percentile of the magnitude; magnitude
/// from 0 to p; decibels from the percentile down by the range. The phase has its full turn whatever the rule, and
/// manual limits of decibels are in dB. Limits that coincide or are reversed are set apart or swapped.
[[nodiscard]] ColourLimits colour_limits(DisplayQuantity quantity, const LimitRule& rule, const Decibels& decibels,
                                         const SampleStatistics& statistics);

/// Number of the colour of a value: 0 at `low` and below, levels - 1 at `high` and above; equal shares between. The
/// first colour for what is not a number. A cyclic quantity wraps around instead of ending.
[[nodiscard]] std::size_t colour_index(double value, const ColourLimits& limits, std::size_t levels,
                                       bool cyclic = false);

}  // namespace sarsim::picture
