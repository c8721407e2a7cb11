#include "radar/atmosphere/straight_path.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim::radar {

namespace {

// c (h - h_from) (2 + c (h + h_from))/c: by how much the square of 1 + c h grows between two heights, over c.
double growth_m(double from_m, double to_m, double curvature_per_m) {
  return (to_m - from_m) * (2.0 + curvature_per_m * (to_m + from_m));
}

}  // namespace

double Climb::height_at(double distance_m) const {
  const double grown = distance_m * (2.0 * rise + curvature_per_m * distance_m);
  return low_m + grown / (ratio + std::sqrt(ratio * ratio + curvature_per_m * grown));
}

double Climb::distance_to(double height_m) const {
  const double growth = growth_m(low_m, height_m, curvature_per_m);
  const double root = std::sqrt(rise * rise + curvature_per_m * growth);
  return rise < 0.0 ? (root - rise) / curvature_per_m : growth / (rise + root);
}

Climb climb_of(const StraightPath& path) {
  Climb climb;
  const double c = 1.0 / path.earth_radius_m;
  const bool rising = path.height_a_m <= path.height_b_m;
  climb.low_m = rising ? path.height_a_m : path.height_b_m;
  climb.high_m = rising ? path.height_b_m : path.height_a_m;
  climb.length_m = path.distance_m;
  climb.curvature_per_m = c;
  climb.ratio = 1.0 + c * climb.low_m;
  const double growth = growth_m(climb.low_m, climb.high_m, c);
  climb.rise = path.distance_m == 0.0 ? climb.ratio : 0.5 * (growth / path.distance_m - c * path.distance_m);
  return climb;
}

Climb endless_climb(double height_m, double sine, double earth_radius_m) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const double c = 1.0 / earth_radius_m;
  const double ratio = 1.0 + c * height_m;
  return {height_m, endless, endless, c, ratio, ratio * sine};
}

Climb climb_from_turn(const Climb& climb) {
  Climb above = climb;
  above.low_m = climb.height_at(climb.turn_m());
  above.length_m = climb.length_m - climb.turn_m();
  above.ratio = 1.0 + above.curvature_per_m * above.low_m;
  above.rise = 0.0;
  return above;
}

std::optional<StraightPath> path_at_elevation(double from_height_m, double elevation_rad, double to_height_m,
                                              double earth_radius_m) {
  const Climb start = endless_climb(from_height_m, std::sin(elevation_rad), earth_radius_m);
  const double growth = growth_m(from_height_m, to_height_m, start.curvature_per_m);
  const double square = start.rise * start.rise + start.curvature_per_m * growth;
  if (!(square >= 0.0)) return std::nullopt;
  const double root = std::sqrt(square);
  double distance_m = 0.0;
  if (growth > 0.0) {
    distance_m = start.distance_to(to_height_m);
  } else if (start.rise < 0.0) {
    distance_m = growth < 0.0 ? growth / (start.rise - root) : 2.0 * start.turn_m();
  } else if (growth < 0.0) {
    return std::nullopt;
  }
  if (!std::isfinite(distance_m) || distance_m < 0.0) return std::nullopt;
  return StraightPath{from_height_m, to_height_m, distance_m, earth_radius_m};
}

double low_elevation_rad(const StraightPath& path) { return std::asin(std::clamp(climb_of(path).sine(), -1.0, 1.0)); }

double length_below_m(const StraightPath& path, double height_m) {
  const Climb climb = climb_of(path);
  if (height_m >= climb.high_m) return climb.length_m;
  if (height_m <= climb.height_at(climb.turn_m())) return 0.0;
  if (climb.rise >= 0.0) return std::min(climb.length_m, climb.distance_to(height_m));
  const double c = climb.curvature_per_m;
  const double square = climb.rise * climb.rise + c * growth_m(climb.low_m, height_m, c);
  const double half = std::sqrt(std::max(0.0, square)) / c;
  return std::min(climb.length_m, climb.turn_m() + half) - std::max(0.0, climb.turn_m() - half);
}

}  // namespace sarsim::radar
