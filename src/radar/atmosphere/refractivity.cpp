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

// Steps of the trapezoidal rule along a path, crowded near its lower end, where the air is.
constexpr int bending_steps = 1024;

// At a share in [0, 1] of a path, crowded near its lowest point.
double crowded_m(const Climb& climb, double share) {
  const double turn_m = std::min(climb.turn_m(), climb.length_m);
  const double before = turn_m / climb.length_m;
  if (share < before) return turn_m * (1.0 - std::pow(1.0 - share / before, 3));
  return before >= 1.0 ? turn_m : turn_m + (climb.length_m - turn_m) * std::pow((share - before) / (1.0 - before), 3);
}

template <class Air>
double bending_gain_of(const Air& air, const StraightPath& path) {
  const Climb climb = climb_of(path);
  if (!(climb.length_m > 0.0)) return 0.0;
  double at_m = 0.0, turned = 0.0, sum = 0.0, squares = 0.0, last_rate = 0.0;
  for (int i = 0; i <= bending_steps; ++i) {
    const double next_m = crowded_m(climb, static_cast<double>(i) / bending_steps);
    const double height_m = climb.height_at(next_m);
    const double sine = (climb.rise + climb.curvature_per_m * next_m) / (1.0 + climb.curvature_per_m * height_m);
    const double rate = -1e-6 * air.gradient_at_per_m(height_m) * std::sqrt(std::max(0.0, 1.0 - sine * sine));
    if (i > 0) {
      const double step_m = next_m - at_m, before = turned;
      turned += 0.5 * step_m * (last_rate + rate);
      sum += 0.5 * step_m * (before + turned);
      squares += step_m * (before * before + before * turned + turned * turned) / 3.0;
    }
    at_m = next_m;
    last_rate = rate;
  }
  return 0.5 * std::max(0.0, squares - sum * sum / climb.length_m);
}

}  // namespace

double ExponentialRefractivity::value(double height_m) const { return surface * std::exp(-height_m / scale_height_m); }

double ExponentialRefractivity::gradient_at_per_m(double height_m) const { return -value(height_m) / scale_height_m; }

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

double bending_gain_m(const ExponentialRefractivity& air, const StraightPath& path) {
  return bending_gain_of(air, path);
}
double bending_gain_m(const LinearRefractivity& air, const StraightPath& path) { return bending_gain_of(air, path); }

}  // namespace sarsim::radar
