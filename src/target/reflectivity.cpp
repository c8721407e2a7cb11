#include "target/reflectivity.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace sarsim {

double incidence_rad(const Vec3& normal_world, const Vec3& look_world) {
  const double distance = norm(look_world);
  if (distance == 0.0) return 0.0;
  return std::acos(std::clamp(-dot(normal_world, look_world) / distance, -1.0, 1.0));
}

double reflectivity(ReflectivityLaw law, const Interpolator& gain_db, double incidence_rad) {
  switch (law) {
    case ReflectivityLaw::isotropic: return 1.0;
    case ReflectivityLaw::cosine: return std::max(0.0, std::cos(incidence_rad));
    case ReflectivityLaw::user: return std::pow(10.0, gain_db.value(incidence_rad * (180.0 / pi)) / 10.0);
  }
  return 1.0;
}

}  // namespace sarsim
