#pragma once

#include <array>
#include <optional>

#include "core/maths/interpolator.hpp"

namespace sarsim::scene {

/// How far a path may be from the smooth one that its points are taken from, and when.
struct PathError {
  double error_m = 0.0;
  double time_s = 0.0;
};

/// Largest distance within a time between a path and the polynomials of degree five through the six points next to each
/// place: an estimate of what the method loses between the points (a h^2/8 with straight lines, 0.08 a h^2 at the chord
/// ends of a spline, h^4/384 times the fourth derivative inside it; a is the acceleration, h the spacing). With
/// fewer than six points, the polynomial is the one through all of them; places outside the points do not count. At
/// most a thousand segments of each coordinate are examined.
/// @param path  points against time in seconds, ascending, in metres
/// @return      nothing where no coordinate has points within the time
[[nodiscard]] std::optional<PathError> path_error(const std::array<core::SampledFunction, 3>& path,
                                                  const core::InterpolationRules& rules, double from_s, double to_s);

}  // namespace sarsim::scene
