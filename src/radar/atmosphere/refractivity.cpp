#include "radar/atmosphere/refractivity.hpp"

#include <algorithm>
#include <cmath>

#include "radar/atmosphere/path_integral.hpp"

namespace sarsim::radar {

namespace {

constexpr double panel_scale_heights = 3.0;
constexpr double last_scale_heights = 40.0;

// (1 - exp(-x))/x, 1 at 0.
double mean_decay(double x) { return x == 0.0 ? 1.0 : -std::expm1(-x) / x; }

}  // namespace

double ExponentialRefractivity::value(double height_m) const { return surface * std::exp(-height_m / scale_height_m); }

double ExponentialRefractivity::gradient_per_m(double height_m) const { return -value(height_m) / scale_height_m; }

double ExponentialRefractivity::next_break_m(double height_m) const {
  return height_m < last_scale_heights * scale_height_m ? height_m + panel_scale_heights * scale_height_m
                                                        : std::numeric_limits<double>::infinity();
}

double LinearRefractivity::value(double height_m) const { return std::max(0.0, surface + gradient_per_m * height_m); }

double k_factor(double gradient_per_m) { return 1.0 / (1.0 + 1e-6 * mean_earth_radius_m * gradient_per_m); }

double gradient_of_k_per_m(double k) { return 1e6 * (1.0 / k - 1.0) / mean_earth_radius_m; }

double excess_path_m(const ExponentialRefractivity& air, const StraightPath& path) {
  const Climb climb = climb_of(path);
  if (climb.curvature_per_m > 0.0) return 1e-6 * integral_along(climb, air);
  return 1e-6 * air.value(climb.low_m) * climb.length_m * mean_decay((climb.high_m - climb.low_m) / air.scale_height_m);
}

double excess_path_m(const LinearRefractivity& air, const StraightPath& path) {
  return 1e-6 * integral_along(climb_of(path), air);
}

}  // namespace sarsim::radar
