#include "simulate/sar_looks.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim {

SarLooks::SarLooks(const Plan& plan, const EchoRows& echoes) : plan_(plan), track_(fit_straight(echoes.track)) {
  constexpr std::size_t most = 2048;
  step_ = (echoes.track.size() + most - 1) / most;
  looks_.resize(plan.scene->scatterers.size());
  PulseGeometry geometry(*plan.scene, plan.radar);
  for (std::size_t p = 0; p < echoes.track.size(); p += step_) {
    geometry.set_pulse(plan.pulses.first + static_cast<std::int64_t>(p));
    const Pointing pointing = geometry.pointing();
    const double per_speed = 2.0 * geometry.carrier_hz() / plan.scene->conventions.light_speed_mps;
    for (std::size_t t = 0; t < looks_.size(); ++t) {
      const ScattererView view = geometry.view(t, pointing);
      SarLook look{.time_s = track_.time_s(static_cast<double>(p)),
                   .distance_m = view.distance_m,
                   .doppler_hz = -per_speed * view.speed_mps,
                   .delay_s = view.delay_s,
                   .amplitude = std::abs(view.amplitude_sqrt_w)};
      if (echoes.compensated) {
        const Scatterer& target = plan.scene->scatterers[t];
        look = from_line(look, geometry.radar_pose(), geometry.pose(target.platform), target.position_m);
      }
      looks_[t].push_back(look);
    }
  }
}

SarLook SarLooks::from_line(SarLook look, const Pose& radar, const Pose& platform, const Vec3& point_m) const {
  const double along_m = dot(radar.position_world_m - track_.origin_m, track_.along);
  const Vec3 sight_m = world_position_m(platform, point_m) - (track_.origin_m + along_m * track_.along);
  const Vec3 velocity_mps = world_velocity_mps(platform, point_m) - track_.speed_mps * track_.along;
  const double light_speed = plan_.scene->conventions.light_speed_mps;
  look.time_s = along_m / track_.speed_mps;
  look.distance_m = norm(sight_m);
  look.doppler_hz = -2.0 * plan_.radar.carrier.carrier_hz(plan_.pulses.first) / light_speed *
                    dot(sight_m, velocity_mps) / look.distance_m;
  look.delay_s = 2.0 * look.distance_m / light_speed;
  return look;
}

ImagePlace SarLooks::place(const SarLook& look, double doppler_hz) const {
  const double light_speed = plan_.scene->conventions.light_speed_mps;
  const double per_hz = light_speed / plan_.radar.carrier.carrier_hz(plan_.pulses.first) / (2.0 * track_.speed_mps);
  const double sine = std::clamp(per_hz * doppler_hz, -1.0, 1.0);
  return {track_.speed_mps * look.time_s + look.distance_m * sine, look.distance_m * std::sqrt(1.0 - sine * sine)};
}

}  // namespace sarsim
