#include "radar/target/reflectivity.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

double incidence_rad(const core::Vec3& normal_world, const core::Vec3& look_world) {
  if (look_world == core::Vec3{}) return 0.0;
  // Not the arc cosine, which turns a rounding into 1e-8 rad where a scatterer faces the radar.
  return std::atan2(core::norm(core::cross(normal_world, look_world)), -core::dot(normal_world, look_world));
}

double reflectivity(ReflectivityLaw law, const core::Interpolator& gain_db, double incidence_rad) {
  switch (law) {
    case ReflectivityLaw::isotropic: return 1.0;
    case ReflectivityLaw::cosine: return std::max(0.0, std::cos(incidence_rad));
    case ReflectivityLaw::user: return std::pow(10.0, gain_db.value(incidence_rad * core::deg_per_rad) / 10.0);
  }
  return 1.0;
}

}  // namespace sarsim::radar
