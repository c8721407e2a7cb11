#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>

#include "radar/atmosphere/straight_path.hpp"

namespace sarsim::radar {

/// A node of Gauss-Legendre quadrature on [-1, 1], with its mirror image at -x.
struct GaussNode {
  double x = 0.0;
  double weight = 0.0;
};

/// Half of the 16 nodes (Abramowitz and Stegun, table 25.4).
inline constexpr std::array<GaussNode, 8> gauss_nodes{{{0.095012509837637441, 0.18945061045506850},
                                                       {0.28160355077925891, 0.18260341504492359},
                                                       {0.45801677765722739, 0.16915651939500254},
                                                       {0.61787624440264375, 0.14959598881657673},
                                                       {0.75540440835500303, 0.12462897125553387},
                                                       {0.86563120238783174, 0.095158511682492785},
                                                       {0.94457502307323258, 0.062253523938647893},
                                                       {0.98940093499164993, 0.027152459411754095}}};

/// What lies in layers over the Earth: a value of each height, and where the next panel of a quadrature shall end above
/// a height; infinity where there is nothing any more. Within a panel the value is smooth.
template <class T>
concept Layered = requires(const T& layers, double height_m) {
  { layers.value(height_m) } -> std::same_as<double>;
  { layers.next_break_m(height_m) } -> std::same_as<double>;
};

/// Integral of a layered value over a path that never dips, from its lower end: 16 nodes for each panel.
template <Layered T>
[[nodiscard]] double integral_up(const Climb& climb, double length_m, const T& layers) {
  double sum = 0.0, begin_m = 0.0, height_m = climb.low_m;
  while (begin_m < length_m) {
    const double next_m = layers.next_break_m(height_m);
    if (!std::isfinite(next_m)) break;
    const double end_m = std::min(length_m, climb.distance_to(next_m));
    const double half = 0.5 * (end_m - begin_m), middle = 0.5 * (end_m + begin_m);
    double panel = 0.0;
    for (const auto& [x, weight] : gauss_nodes)
      panel += weight *
               (layers.value(climb.height_at(middle - half * x)) + layers.value(climb.height_at(middle + half * x)));
    sum += half * panel;
    begin_m = end_m;
    height_m = next_m;
  }
  return sum;
}

/// The same over any path, which may dip: it is cut at its lowest point. What is no path, with a NaN in it, gives NaN.
template <Layered T>
[[nodiscard]] double integral_along(const Climb& climb, const T& layers) {
  if (std::isnan(climb.rise)) return climb.rise;
  if (climb.rise >= 0.0) return integral_up(climb, climb.length_m, layers);
  const Climb above = climb_from_turn(climb);
  return integral_up(above, climb.turn_m(), layers) + integral_up(above, above.length_m, layers);
}

}  // namespace sarsim::radar
