#pragma once

#include <limits>
#include <optional>

namespace sarsim::radar {

/// A straight line between two points over a spherical Earth. The order of its ends does not matter to anything here.
struct StraightPath {
  double height_a_m = 0.0;  ///< Of one end above the sphere.
  double height_b_m = 0.0;  ///< Of the other one.
  double distance_m = 0.0;  ///< Between them, at least the difference of the heights.
  double earth_radius_m = std::numeric_limits<double>::infinity();  ///< Infinite: the Earth is flat.
};

/// The path that leaves a height at an elevation and ends where it first meets another height: the rising branch for a
/// higher one, the first crossing for a lower one (negative elevations), the second crossing for the same height.
/// Nothing where it never gets there.
/// @param elevation_rad  above the horizontal plane at its beginning, in [-pi/2, pi/2], without refraction
[[nodiscard]] std::optional<StraightPath> path_at_elevation(double from_height_m, double elevation_rad,
                                                            double to_height_m, double earth_radius_m);

/// A straight path as seen from its lower end, in quantities that a flat Earth has too: with the curvature c = 1/R the
/// height h at a distance s from the lower end obeys (1 + c h)^2 = (1 + c h_low)^2 + c s (2 rise + c s).
struct Climb {
  double low_m = 0.0;
  double high_m = 0.0;
  double length_m = 0.0;
  double curvature_per_m = 0.0;  ///< c; 0 for the flat Earth.
  double ratio = 1.0;            ///< 1 + c h_low.
  double rise = 0.0;             ///< (1 + c h_low) sin(elevation at the lower end); negative where it dips first.

  /// Height at a distance from the lower end, m; without cancellation.
  [[nodiscard]] double height_at(double distance_m) const;
  /// Distance from the lower end at which the path rises through a height of at least `low_m`, m; the path may be
  /// longer than it is. Infinite for a flat horizontal one.
  [[nodiscard]] double distance_to(double height_m) const;
  /// Distance from the lower end at which the path is lowest, m; 0 where it only rises.
  [[nodiscard]] double turn_m() const { return rise < 0.0 ? -rise / curvature_per_m : 0.0; }
  /// The lower end's own sine of elevation.
  [[nodiscard]] double sine() const { return rise / ratio; }
};

/// The path from its lower end. A distance of 0 makes a vertical path of length 0.
[[nodiscard]] Climb climb_of(const StraightPath& path);

/// The path that leaves a height at a sine of elevation for ever.
[[nodiscard]] Climb endless_climb(double height_m, double sine, double earth_radius_m);

/// What is above the lowest point of a path that dips: it leaves the lowest point horizontally.
[[nodiscard]] Climb climb_from_turn(const Climb& climb);

/// Elevation of the path at its lower end towards the higher one, rad.
[[nodiscard]] double low_elevation_rad(const StraightPath& path);

/// Length of the part of a path that lies below a height, m: in closed form.
[[nodiscard]] double length_below_m(const StraightPath& path, double height_m);

}  // namespace sarsim::radar
