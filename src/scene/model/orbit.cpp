#include "scene/model/orbit.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "radar/earth/ellipsoid.hpp"

namespace sarsim::scene {

namespace {

constexpr double position_step_m = 1e-3;
constexpr double velocity_step_mps = 1e-6;
constexpr double angle_step_deg = 1e-8;  // 1 mm on a low orbit
constexpr double eccentricity_step = 1e-10;

core::Angle rounded_angle(double rad) {
  return core::Angle::from_deg(core::rounded_to(rad * core::deg_per_rad, angle_step_deg));
}

// What the turning of the Earth adds to a velocity over it.
core::Vec3 turning_mps(const core::Vec3& position_m) {
  return core::cross(core::Vec3{0.0, 0.0, radar::earth_rate_rad_per_s}, position_m);
}

}  // namespace

bool is_orbit(Platform::Path path) {
  return path == Platform::Path::ephemeris || path == Platform::Path::orbit || path == Platform::Path::state;
}

std::optional<radar::KeplerElements> elements_of(const Platform& platform) {
  const radar::KeplerElements elements{platform.semi_major_axis_m, platform.eccentricity,
                                       platform.inclination.rad(), platform.node_longitude.rad(),
                                       platform.perigee.rad(),     platform.anomaly.rad()};
  const bool ellipse = elements.semi_major_axis_m > 0.0 && std::isfinite(elements.semi_major_axis_m) &&
                       elements.eccentricity >= 0.0 && elements.eccentricity < 1.0;
  const double angles_rad =
      elements.inclination_rad + elements.ascending_node_rad + elements.perigee_rad + elements.mean_anomaly_rad;
  return ellipse && std::isfinite(angles_rad) ? std::optional(elements) : std::nullopt;
}

radar::OrbitState inertial_state_of(const Platform& platform) {
  return {platform.state_position_m, platform.state_velocity_mps + turning_mps(platform.state_position_m)};
}

void continue_orbit(const Platform& before, Platform& after) {
  if (before.path == Platform::Path::orbit && after.path == Platform::Path::state) {
    const auto elements = elements_of(before);
    if (!elements) return;
    const radar::OrbitMotion motion = radar::SecularOrbit(*elements).at(0.0);
    after.state_position_m = core::rounded_to(motion.position_m, position_step_m);
    after.state_velocity_mps =
        core::rounded_to(motion.velocity_mps - turning_mps(motion.position_m), velocity_step_mps);
  } else if (before.path == Platform::Path::state && after.path == Platform::Path::orbit) {
    const auto elements = radar::secular_elements(inertial_state_of(before));
    if (!elements) return;
    after.semi_major_axis_m = core::rounded_to(elements->semi_major_axis_m, position_step_m);
    after.eccentricity = core::rounded_to(elements->eccentricity, eccentricity_step);
    after.inclination = rounded_angle(elements->inclination_rad);
    after.node_longitude = rounded_angle(elements->ascending_node_rad);
    after.perigee = rounded_angle(elements->perigee_rad);
    after.anomaly = rounded_angle(elements->mean_anomaly_rad);
  }
}

}  // namespace sarsim::scene
