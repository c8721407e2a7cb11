#pragma once

#include <cmath>

#include "core/maths/vector.hpp"
#include "radar/orbit/orbit_state.hpp"

// Published states of radar satellites and a reference orbit for tests. Earth-fixed frame: z axis to the north pole, x
// to longitude 0.

namespace sarsim::radar::orbit_test {

inline constexpr double earth_rotation_rad_per_s = 7.292115e-5;

struct PublishedOrbitState {
  const char* name = "";
  OrbitState earth_fixed;
  double semi_major_axis_km = 0.0;  // osculating elements, computed independently (NumPy)
  double eccentricity = 0.0;
  double inclination_deg = 0.0;
  double yaw_to_zero_doppler_deg =
      0.0;  // between the inertial and the Earth-fixed direction of flight, about the nadir
  double yaw_formula_deg = 0.0;
};

inline constexpr PublishedOrbitState published_orbit_states[] = {
    {"Sentinel-1A 2024-04-01T22:59:42",
     {{1950200.216160, -4143460.384445, -5401629.615817}, {579.550068, -5889.842297, 4730.338429}},
     7069.302,
     0.00177,
     98.1832,
     2.4642,
     2.4563},
    {"Sentinel-1B 2020-07-28T22:59:42",
     {{2057735.247194, -6459802.571744, -2037501.319184}, {-886.585360, -2517.114487, 7108.167902}},
     7078.629,
     0.00089,
     98.1769,
     3.6919,
     3.6914},
    {"Sentinel-1A 2020-07-23T22:59:42",
     {{-1659308.501505, 6753819.113038, -1317158.267893}, {1875.247563, -954.537857, -7297.506531}},
     7079.470,
     0.00102,
     98.1756,
     3.7884,
     3.7897},
    {"Envisat 2006-07-20T02:38:29.989786",
     {{2500149.266, -6714929.064, 0.0}, {-1530.874437, -560.873432, 7377.493385}},
     7168.524,
     0.00123,
     98.5402,
     3.9214,
     3.9249},
    {"like NISAR, focus test of isce3",
     {{3610265.1977, -6139538.4368, 159314.0910}, {-1429.7297, -647.2513, 7405.3360}},
     7124.153,
     0.00015,
     97.9991,
     3.8958,
     3.8959},
};

// Acceleration in Earth-fixed axes under point mass and J2, with the forces of turning axes.
inline core::Vec3 j2_acceleration(const core::Vec3& r, const core::Vec3& v) {
  constexpr double mu = 3.986004418e14, radius = 6378137.0, j2 = 1.082626683e-3, w = earth_rotation_rad_per_s;
  const double r2 = core::dot(r, r);
  const double k = 1.5 * j2 * radius * radius / r2;
  const double z2 = 5.0 * r.z * r.z / r2;
  const double point = -mu / (r2 * std::sqrt(r2));
  return {point * r.x * (1.0 + k * (1.0 - z2)) + w * w * r.x + 2.0 * w * v.y,
          point * r.y * (1.0 + k * (1.0 - z2)) + w * w * r.y - 2.0 * w * v.x, point * r.z * (1.0 + k * (3.0 - z2))};
}

}  // namespace sarsim::radar::orbit_test
