#include "workflow/focus/target_aspects.hpp"

#include "simulate/plan/pulse_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "radar/path/path.hpp"
#include "simulate/resolve/air_paths.hpp"
#include "simulate/survey/derived.hpp"

namespace sarsim::workflow {

namespace {

// Looks at a target: all of these for so many targets, then as many in all, but no fewer than the least.
constexpr std::size_t looks_for_targets = 4096;
constexpr std::size_t min_looks = 65;

std::size_t step_of(std::size_t pulses, std::size_t targets, std::size_t max_looks) {
  const std::size_t affordable = max_looks * looks_for_targets / std::max(targets, looks_for_targets);
  const std::size_t looks = std::max(affordable, min_looks);
  return (pulses + looks - 1) / looks;
}

// Targets that are looked at together. Each pulse means a pose of every platform: with many of them it should serve
// many targets.
std::size_t targets_at_once(std::size_t platforms) { return std::clamp<std::size_t>(platforms, 8, 128); }

double peak_gain_of(const simulate::Acquisition& acquisition) {
  const bool keeps_peak = acquisition.scene->conventions.compression == simulate::Conventions::Compression::keeps_peak;
  return keeps_peak ? 1.0 : simulate::processing_gain(acquisition);
}

// d|r|/dt as the pulse leaves: without what the antenna's own flight adds to the Doppler shift until the echo is back,
// which focusing takes out.
double receding_mps(const radar::Pose& radar, const radar::Pose& platform, const core::Vec3& point_m) {
  const core::Vec3 sight_m = radar::world_position_m(platform, point_m) - radar.position_world_m;
  const core::Vec3 velocity_mps = radar::world_velocity_mps(platform, point_m) - radar.velocity_world_mps;
  const double distance_m = core::norm(sight_m);
  return distance_m > 0.0 ? core::dot(sight_m, velocity_mps) / distance_m : 0.0;
}

}  // namespace

TargetAspects::TargetAspects(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                             const signal::WindowFunction& weight, std::size_t max_looks)
    : acquisition_(acquisition),
      scene_(simulate::thinned(acquisition.scene, max_examined_targets)),
      track_(signal::fit_straight(echoes.track)),
      gain_(
          acquisition, echoes.columns, weight ? weight : [](double) { return 1.0; }),
      peak_gain_(peak_gain_of(acquisition)),
      carrier_hz_(echoes.waveform.carrier_hz),
      pulses_(echoes.track.size()),
      step_(step_of(echoes.track.size(), scene_->scatterers.size(), max_looks)),
      compensated_(echoes.compensated) {
  simulate::PulseGeometry geometry(*scene_, acquisition.link);
  const std::array looks{std::size_t{0}, count() / 2, count() - 1};
  for (std::size_t i = 0; i < looks.size(); ++i) {
    geometry.set_pulse(acquisition.timing.pulses.first + static_cast<std::int64_t>(pulse(looks[i])));
    first_middle_last_[i].resize(scene_->platforms.size());
    for (const std::uint32_t platform : simulate::reflecting_platforms(*scene_))
      first_middle_last_[i][platform] = geometry.pose(platform);
  }
}

void TargetAspects::each(const core::WorkControl& control,
                         const std::function<void(std::size_t target, std::span<const TargetAspect> seen)>& body,
                         std::size_t every) const {
  const std::size_t looks = count();
  core::parallel_ranges((targets() + every - 1) / every, targets_at_once(scene_->platforms.size()), control,
                        [&](std::size_t begin, std::size_t end) {
                          std::vector<TargetAspect> seen((end - begin) * looks);
                          simulate::PulseGeometry geometry(*scene_, acquisition_.link);
                          for (std::size_t i = 0; i < looks; ++i) {
                            geometry.set_pulse(acquisition_.timing.pulses.first + static_cast<std::int64_t>(pulse(i)));
                            const radar::Pointing pointing = geometry.pointing();
                            for (std::size_t t = begin; t < end; ++t)
                              seen[(t - begin) * looks + i] = look_at(t * every, pulse(i), geometry, pointing);
                          }
                          for (std::size_t t = begin; t < end; ++t)
                            body(t * every, std::span<const TargetAspect>(seen).subspan((t - begin) * looks, looks));
                        });
}

TargetAspect TargetAspects::look_at(std::size_t target, std::size_t pulse, const simulate::PulseGeometry& geometry,
                                    const radar::Pointing& pointing) const {
  const double per_speed = radar::turns_per_m(carrier_hz_, scene_->conventions.light_speed_mps);
  const simulate::ScattererView view = geometry.view(target, pointing);
  const simulate::Scatterer& scatterer = scene_->scatterers[target];
  const radar::Pose& platform = geometry.pose(scatterer.platform);
  TargetAspect look{.time_s = track_.time_s(static_cast<double>(pulse)),
                    .distance_m = view.distance_m,
                    .doppler_hz = -per_speed * receding_mps(geometry.radar_pose(), platform, scatterer.position_m),
                    .delay_s = view.delay_s,
                    .amplitude = std::abs(view.amplitude_sqrt_w * gain_.gain(view.delay_s)) * peak_gain_,
                    .share = gain_.share(view.delay_s)};
  if (compensated_) look = from_line(look, geometry.radar_pose(), platform, scatterer.position_m);
  if (geometry.air() == nullptr) return look;
  return through(*geometry.air(), look, geometry.radar_pose(), platform, scatterer.position_m);
}

TargetAspect TargetAspects::from_line(TargetAspect look, const radar::Pose& radar, const radar::Pose& platform,
                                      const core::Vec3& point_m) const {
  const double along_m = core::dot(radar.position_world_m - track_.origin_m, track_.along);
  const core::Vec3 sight_m = radar::world_position_m(platform, point_m) - (track_.origin_m + along_m * track_.along);
  const core::Vec3 velocity_mps = radar::world_velocity_mps(platform, point_m) - track_.speed_mps * track_.along;
  const double light_speed = scene_->conventions.light_speed_mps;
  look.time_s = along_m / track_.speed_mps;
  look.distance_m = core::norm(sight_m);
  look.doppler_hz = -radar::turns_per_m(carrier_hz_, light_speed) * core::dot(sight_m, velocity_mps) / look.distance_m;
  look.delay_s = radar::delay_of(look.distance_m, light_speed);
  return look;
}

// What the atmosphere adds on the way from where the antenna was, wherever its motion is compensated to: the distance
// grows with the delay of the group, the Doppler frequency is that of the phase.
TargetAspect TargetAspects::through(const simulate::AirPaths& air, TargetAspect look, const radar::Pose& radar,
                                    const radar::Pose& platform, const core::Vec3& point_m) const {
  const core::Vec3 antenna_m = radar.position_world_m;
  const core::Vec3 at_m = radar::world_position_m(platform, point_m);
  const core::Vec3 point_mps = radar::world_velocity_mps(platform, point_m);
  const simulate::AirEffect effect = air.between(antenna_m, at_m, carrier_hz_);
  look.late_m = radar::range_of(effect.delay_s, scene_->conventions.light_speed_mps);
  look.distance_m += look.late_m;
  look.ahead_turns = effect.ahead_turns;
  if (compensated_) look.delay_s += effect.delay_s;
  const double speed_mps = core::norm(point_mps - radar.velocity_world_mps);
  if (!(speed_mps > 0.0)) return look;
  // Until the way has changed by a hundredth: its effects are smooth.
  const double step_s = 0.01 * core::norm(at_m - antenna_m) / speed_mps;
  const auto late_turns = [&](double time_s) {
    const simulate::AirEffect then =
        air.between(antenna_m + time_s * radar.velocity_world_mps, at_m + time_s * point_mps, carrier_hz_);
    return carrier_hz_ * then.delay_s - then.ahead_turns;
  };
  look.air_doppler_hz = -(late_turns(step_s) - late_turns(-step_s)) / (2.0 * step_s);
  look.doppler_hz += look.air_doppler_hz;
  return look;
}

TargetAspect TargetAspect::in_vacuum() const {
  TargetAspect look = *this;
  look.distance_m -= look.late_m;
  look.doppler_hz -= look.air_doppler_hz;
  look.late_m = look.air_doppler_hz = look.ahead_turns = 0.0;
  return look;
}

std::vector<core::Vec3> TargetAspects::antennas() const {
  std::vector<core::Vec3> places_m;
  simulate::PulseGeometry geometry(*scene_, acquisition_.link);
  for (std::size_t i = 0; i < count(); ++i) {
    geometry.set_pulse(acquisition_.timing.pulses.first + static_cast<std::int64_t>(pulse(i)));
    places_m.push_back(geometry.radar_pose().position_world_m);
  }
  return places_m;
}

std::optional<core::Vec3> TargetAspects::resting_place(std::size_t target) const {
  constexpr double still_m = 1e-6;
  const simulate::Scatterer scatterer = scene_->scatterers[target];
  const auto at = [&](const std::vector<radar::Pose>& poses) {
    return radar::world_position_m(poses[scatterer.platform], scatterer.position_m);
  };
  const core::Vec3 first_m = at(first_middle_last_[0]);
  for (std::size_t i = 1; i < first_middle_last_.size(); ++i)
    if (core::norm(at(first_middle_last_[i]) - first_m) > still_m) return std::nullopt;
  return first_m;
}

signal::ImagePlace TargetAspects::place(const TargetAspect& look, double doppler_hz) const {
  const double light_speed = scene_->conventions.light_speed_mps;
  const double per_hz = radar::range_of_cycle(carrier_hz_, light_speed) / track_.speed_mps;
  const double sine = std::clamp(per_hz * doppler_hz, -1.0, 1.0);
  return {track_.speed_mps * look.time_s + look.distance_m * sine, look.distance_m * std::sqrt(1.0 - sine * sine)};
}

std::optional<double> line_doppler_centroid_hz(const simulate::Acquisition& acquisition, signal::EchoRows echoes,
                                               const core::WorkControl& control) {
  constexpr std::size_t max_looks = 65;
  echoes.compensated = true;
  const TargetAspects looks(acquisition, echoes, {}, max_looks);
  struct Sums {
    double power = 0.0;
    double moment = 0.0;
  };
  std::vector<Sums> sums(looks.targets());
  looks.each(control, [&](std::size_t t, std::span<const TargetAspect> seen) {
    for (const TargetAspect& look : seen) {
      const double power = look.amplitude * look.amplitude;
      sums[t].power += power;
      sums[t].moment += power * look.doppler_hz;
    }
  });
  Sums all;
  for (const Sums& sum : sums) {
    all.power += sum.power;
    all.moment += sum.moment;
  }
  if (!(all.power > 0.0)) return std::nullopt;
  return all.moment / all.power;
}

}  // namespace sarsim::workflow
