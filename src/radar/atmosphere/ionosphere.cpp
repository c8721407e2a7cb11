#include "radar/atmosphere/ionosphere.hpp"

#include <cmath>

namespace sarsim::radar {

double ionosphere_group_m(double tec_per_m2, double carrier_hz) {
  return 40.3 * tec_per_m2 / (carrier_hz * carrier_hz);
}

double faraday_rad(double tec_per_m2, double field_t, double carrier_hz) {
  return 2.365e4 * field_t * tec_per_m2 / (carrier_hz * carrier_hz);
}

double shell_factor(const StraightPath& path, double shell_height_m) {
  const Climb climb = climb_of(path);
  if (!(climb.low_m < shell_height_m && shell_height_m <= climb.high_m)) return 0.0;
  const double c = climb.curvature_per_m;
  const double growth = (shell_height_m - climb.low_m) * (2.0 + c * (shell_height_m + climb.low_m));
  return (1.0 + c * shell_height_m) / std::sqrt(climb.rise * climb.rise + c * growth);
}

}  // namespace sarsim::radar
