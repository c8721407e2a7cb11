#pragma once

#include <cmath>
#include <cstddef>

#include "signal/sar/sar_image.hpp"

namespace sarsim::signal {

/// Coordinates of an image from one to another.
struct AxisInterval {
  double first_m = 0.0;
  double last_m = 0.0;
};

/// Leaves the samples of an axis within an interval, at the places that the axis has for them, beyond its ends too.
/// @return by how many samples the new axis begins after the old one; `count` is 0 where no sample is inside
inline std::ptrdiff_t cut_axis(ImageAxis& axis, const AxisInterval& interval) {
  constexpr double rounding = 1e-6;  // of a sample
  const double first = std::ceil(axis.index_of(interval.first_m) - rounding);
  const double last = std::floor(axis.index_of(interval.last_m) + rounding);
  axis.first_m = axis.at(first);
  axis.count = last >= first ? static_cast<std::size_t>(last - first) + 1 : 0;
  return static_cast<std::ptrdiff_t>(first);
}

}  // namespace sarsim::signal
