#pragma once

#include <string>
#include <vector>

namespace sarsim::picture {

/// One mark of an axis.
struct Tick {
  double value = 0.0;
  std::string label;  ///< "2.5"; the unit is the axis's.
};

/// Marks of an axis from `first` to `last` (either order): multiples of 1, 2 or 5 times a power of ten, as many as fit
/// `length_px` at `spacing_px` each, in the order from `first` to `last`; where that would be one mark alone, short
/// labels stand nearer together. Units of decibels, degrees, percent, square metres and kelvins, and no unit at all,
/// take no prefix. No marks for an empty or infinite span.
struct Ticks {
  std::vector<Tick> ticks;
  std::string unit;    ///< With its prefix, common to all labels: "km", "µs".
  double scale = 1.0;  ///< What values are divided by for the labels.
};
[[nodiscard]] Ticks axis_ticks(double first, double last, double length_px, double spacing_px, const std::string& unit);

/// Marks of an axis of seconds as times of day, "22:59:41" or, nearer together, "22:59:41.5": multiples of 1, 2, 5, 10,
/// 15 or 30 s or min, of 1, 2, 3, 6 or 12 h, of days, or of 1, 2 or 5 times a power of ten below a second. Every day
/// has 86400 s. Labels have no unit; no marks where `axis_ticks` has none.
/// @param clock_s  time of day at the value 0, s since midnight
[[nodiscard]] Ticks clock_ticks(double first, double last, double length_px, double spacing_px, double clock_s);

/// The largest of 1, 2, 5, 10, 20, 50 ... that is at most `value`; for scale bars and the marks of the scene's axes. 0
/// for anything but a positive number.
[[nodiscard]] double round_below(double value);

}  // namespace sarsim::picture
