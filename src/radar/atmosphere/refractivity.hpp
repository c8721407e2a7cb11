#pragma once

#include <limits>

#include "radar/atmosphere/straight_path.hpp"

namespace sarsim::radar {

/// Mean radius of the Earth, m, of which ITU-R's formulas count.
inline constexpr double mean_earth_radius_m = 6'371'000.0;

/// Refractivity N = 1e6 (n - 1) that falls with height, N0 exp(-h/H). The numbers are the mean of the world, ITU-R
/// P.453 and P.835. It holds for all radio frequencies: the delay of group and phase are the same.
struct ExponentialRefractivity {
  double surface = 315.0;          ///< N0, at height 0.
  double scale_height_m = 7350.0;  ///< H; positive.

  /// N at a height; also below 0, where it goes on growing.
  [[nodiscard]] double value(double height_m) const;
  /// dN/dh at a height, 1/m.
  [[nodiscard]] double gradient_at_per_m(double height_m) const;
  /// End of a panel of quadrature, 3 H on; infinity above 40 H, where exp(-40) = 4e-18 is left.
  [[nodiscard]] double next_break_m(double height_m) const;
};

/// Refractivity that falls evenly until it is 0, and stays there: rays are nearly arcs of circles below.
struct LinearRefractivity {
  double surface = 315.0;             ///< N0, at height 0.
  double gradient_per_m = -39.24e-3;  ///< dN/dh; negative.

  /// N at a height.
  [[nodiscard]] double value(double height_m) const;
  /// dN/dh at a height, 1/m: 0 above the top.
  [[nodiscard]] double gradient_at_per_m(double height_m) const { return height_m < top_m() ? gradient_per_m : 0.0; }
  /// Where it has become 0, m: 8.03 km for the numbers above.
  [[nodiscard]] double top_m() const { return -surface / gradient_per_m; }
  /// The top from below it, then infinity.
  [[nodiscard]] double next_break_m(double height_m) const { return height_m < top_m() ? top_m() : no_break_m; }

  static constexpr double no_break_m = std::numeric_limits<double>::infinity();
};

/// Factor k of the effective radius of the Earth over which rays of low elevation are straight (ITU-R P.310, P.834):
/// k = 1/(1 + 1e-6 a dN/dh); a = 6371 km. 4/3 for -39.24 per km; 1.376 for the exponential at the ground.
[[nodiscard]] double k_factor(double gradient_per_m);

/// The gradient dN/dh that has a factor k, 1/m: 1e6 (1/k - 1)/a.
[[nodiscard]] double gradient_of_k_per_m(double k);

/// Excess path 1e-6 integral N ds, m: by how much light has farther to go over a straight path than in vacuum. Over the
/// flat Earth 1e-6 N0 H (exp(-h_a/H) - exp(-h_b/H))/sin(elevation), without cancellation; over the sphere by
/// quadrature, relative error 1e-13, 5e-12 m at the horizon.
///
/// The real ray is bent, and that between the same two points is quicker than the straight line (Fermat). Straight
/// minus bent for the default exponential, at true elevation (angle of the straight line) seen from the ground, m:
///
///     elevation, deg    0.5      1      2      3      5      10      20      30      45      60
///     to 3 km          0.18  0.079  0.021 0.0078 0.0019  2.5e-4  3.1e-5  8.3e-6  2.0e-6  5.3e-7
///     to 10 km         0.91   0.52   0.20  0.090  0.027  3.9e-3  4.8e-4  1.3e-4  3.1e-5  8.5e-6
///     to 700 km        3.28   2.11   0.97   0.50   0.17   0.029  3.8e-3  1.1e-3  2.5e-4  6.8e-5
///
/// that is 4.7 % of the excess at 0.5 deg to space, 0.7 % at 5 deg and 0.02 % at 30 deg.
[[nodiscard]] double excess_path_m(const ExponentialRefractivity& air, const StraightPath& path);
[[nodiscard]] double excess_path_m(const LinearRefractivity& air, const StraightPath& path);

/// Optical path along the straight line minus that along the bent ray between the same ends, m, one way, at least 0:
/// what `excess_path_m` neglects. Second order in the ray's deviation: 1/2 integral theta^2 ds, with theta the angle
/// between ray and line, d theta/ds = -1e-6 dN/dh cos(elevation), whose mean over the path is 0. Within 5 % of the
/// table above from 5 deg of elevation on, and 25 % at 2 deg, where higher orders count.
[[nodiscard]] double bending_gain_m(const ExponentialRefractivity& air, const StraightPath& path);
[[nodiscard]] double bending_gain_m(const LinearRefractivity& air, const StraightPath& path);

}  // namespace sarsim::radar
