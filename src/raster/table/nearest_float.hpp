#pragma once

#include <cmath>
#include <limits>

namespace sarsim::raster {

/// The nearest float; what is beyond all floats becomes infinite.
inline float as_float(double value) {
  constexpr double most = static_cast<double>(std::numeric_limits<float>::max());
  if (std::abs(value) <= most || !std::isfinite(value)) return static_cast<float>(value);
  return std::copysign(std::numeric_limits<float>::infinity(), value < 0.0 ? -1.0F : 1.0F);
}

}  // namespace sarsim::raster
