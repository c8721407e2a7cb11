#include "simulate/plan/pulse_geometry.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/random.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::simulate {

struct PulseGeometry::Sight {
  core::Vec3 look_world_m;        // radar to scatterer
  core::Vec3 velocity_world_mps;  // of the scatterer relative to the radar
};

PulseGeometry::PulseGeometry(const ResolvedScene& scene, const ResolvedRadar& radar)
    : scene_(&scene), radar_(&radar), poses_(scene.platforms.size()), used_(scene.platforms.size(), false) {
  CORE_EXPECT(radar.platform < scene.platforms.size());
  CORE_EXPECT(scene.conventions.light_speed_mps > 0.0);
  used_[radar.platform] = true;
  for (const Scatterer& s : scene.scatterers) used_[s.platform] = true;
  for (const ScattererSheet& sheet : scene.sheets) used_[sheet.platform] = true;
  for (std::size_t i = 0; i < poses_.size(); ++i) poses_[i] = scene.platforms[i].track.at(0.0, 0);
  spreading_ = !(radar.stc != scene::Radar::Stc::none && scene.conventions.stc == Conventions::Stc::no_spreading);
}

void PulseGeometry::set_pulse(std::int64_t pulse) {
  pulse_ = pulse;
  time_s_ = radar_->repetition.send_time_s(pulse);
  carrier_hz_ = radar_->carrier.carrier_hz(pulse);
  for (std::size_t i = 0; i < poses_.size(); ++i)
    if (used_[i] && !scene_->platforms[i].track.fixed()) poses_[i] = scene_->platforms[i].track.at(time_s_, pulse);
  const double wavelength_m = radar::wavelength_of(carrier_hz_, scene_->conventions.light_speed_mps);
  amplitude_scale_ = std::sqrt(radar_->radiated_w) * wavelength_m / std::pow(4.0 * core::pi, 1.5);
}

radar::Pointing PulseGeometry::pointing() const {
  const radar::Pose& pose = radar_pose();
  return {radar_->beam,          scene_->conventions.pointing, time_s_,
          pose.position_world_m, pose.world_from_platform,     pose.rotation_rad};
}

ScattererView PulseGeometry::seen(const Sight& sight, double rcs_m2, const radar::Pointing& pointing) const {
  ScattererView view;
  view.distance_m = core::norm(sight.look_world_m);
  view.speed_mps =
      view.distance_m > 0.0 ? core::dot(sight.look_world_m, sight.velocity_world_mps) / view.distance_m : 0.0;
  view.delay_s = radar::moving_delay_of(radar::there_and_back(view.distance_m), view.speed_mps,
                                        scene_->conventions.light_speed_mps);
  const bool isotropic = radar_->transmit.kind == radar::AntennaPattern::Kind::isotropic &&
                         radar_->receive.kind == radar::AntennaPattern::Kind::isotropic;
  double gain = 1.0;
  if (!isotropic) {
    const radar::BeamOffset offset = pointing.offset(sight.look_world_m);
    const radar::PatternRule rule = scene_->conventions.pattern;
    gain = radar::one_way_amplitude(radar_->transmit, offset.azimuth_rad, offset.elevation_rad, rule) *
           radar::one_way_amplitude(radar_->receive, offset.azimuth_rad, offset.elevation_rad, rule);
  }
  const double spreading = spreading_ ? view.distance_m * view.distance_m : 1.0;
  view.amplitude_sqrt_w = amplitude_scale_ * gain * std::sqrt(rcs_m2) / spreading;
  return view;
}

ScattererView PulseGeometry::view(std::size_t index) const { return view(index, pointing()); }

ScattererView PulseGeometry::view(std::size_t index, const radar::Pointing& pointing) const {
  const Scatterer& s = scene_->scatterers[index];
  const radar::Pose& pose = poses_[s.platform];
  core::Vec3 point_m = s.position_m;
  double rcs_m2 = s.rcs_m2;
  double azimuth = s.azimuth_rad;
  double elevation = s.elevation_rad;
  Sight sight;
  // Jitter moves positions, never speeds (decision 4): the velocity is that of the undisturbed point.
  sight.velocity_world_mps = radar::world_velocity_mps(pose, point_m) - radar_pose().velocity_world_mps;
  if (s.jittered) {
    const auto draw = [&](core::RandomKind kind, std::int64_t part) {
      return core::RandomStream(scene_->options.seed, kind, index).normals(pulse_, part);
    };
    const auto [dx, dy] = draw(core::RandomKind::target_position, 0);
    const double dz = draw(core::RandomKind::target_position, 1)[0];
    point_m = point_m + core::Vec3{s.position_stddev_m.x * dx, s.position_stddev_m.y * dy, s.position_stddev_m.z * dz};
    rcs_m2 += s.rcs_stddev_m2 * draw(core::RandomKind::target_rcs, 0)[0];
    const auto [da, de] = draw(core::RandomKind::target_pointing, 0);
    azimuth += s.azimuth_stddev_rad * da;
    elevation += s.elevation_stddev_rad * de;
  }
  sight.look_world_m = radar::world_position_m(pose, point_m) - radar_pose().position_world_m;
  rcs_m2 = std::max(0.0, rcs_m2);
  if (s.law != radar::ReflectivityLaw::isotropic) {
    const core::Vec3 normal_world = pose.world_from_platform * core::direction(azimuth, elevation);
    static const core::Interpolator none;
    const core::Interpolator& curve = s.law == radar::ReflectivityLaw::user ? scene_->gain_curves[s.gain_curve] : none;
    rcs_m2 *= radar::reflectivity(s.law, curve, radar::incidence_rad(normal_world, sight.look_world_m));
  }
  return seen(sight, rcs_m2, pointing);
}

void PulseGeometry::echoes(radar::EchoBatch& echoes) const {
  echoes.clear();
  const radar::Pointing axis = pointing();
  for (std::size_t i = 0; i < scene_->scatterers.size(); ++i) {
    const ScattererView v = view(i, axis);
    expect_possible("target", i, v);
    echoes.add(v.delay_s, v.amplitude_sqrt_w, v.speed_mps);
  }
  for (std::size_t i = 0; i < scene_->sheets.size(); ++i) add_sheet(i, axis, echoes);
}

void PulseGeometry::expect_possible(std::string_view kind, std::size_t index, const ScattererView& view) const {
  const EchoExtremes echo{view.distance_m, view.speed_mps, view.amplitude_sqrt_w};
  const double light_mps = scene_->conventions.light_speed_mps;
  if (possible_echo(echo, light_mps)) return;
  core::Problem problem = problem_of_echo(kind, index, radar_->name, echo, light_mps);
  problem.message += fmt::format(" (pulse {}, {:g} s)", pulse_, time_s_);
  throw ImpossibleEcho(std::move(problem));
}

std::optional<ScattererView> PulseGeometry::point_view(const ScattererSheet& sheet, const core::Vec3& normal_world,
                                                       const core::Vec3& point_m,
                                                       const radar::Pointing& pointing) const {
  static const core::Interpolator none;
  const radar::Pose& pose = poses_[sheet.platform];
  Sight sight;
  sight.look_world_m = radar::world_position_m(pose, point_m) - radar_pose().position_world_m;
  sight.velocity_world_mps = radar::world_velocity_mps(pose, point_m) - radar_pose().velocity_world_mps;
  const double law =
      radar::reflectivity(radar::ReflectivityLaw::cosine, none, radar::incidence_rad(normal_world, sight.look_world_m));
  if (law <= 0.0) return std::nullopt;
  const ScattererView view = seen(sight, sheet.point_rcs_m2 * law, pointing);
  // A plane through the radar shows it neither side.
  if (view.distance_m == 0.0) return std::nullopt;
  return view;
}

std::optional<ScattererView> PulseGeometry::sheet_view(std::size_t sheet, std::size_t point,
                                                       const radar::Pointing& pointing) const {
  const ScattererSheet& surface = scene_->sheets[sheet];
  const core::Vec3 normal_world = poses_[surface.platform].world_from_platform * surface.normal_platform;
  return point_view(surface, normal_world, surface.points_m[point], pointing);
}

void PulseGeometry::add_sheet(std::size_t index, const radar::Pointing& pointing, radar::EchoBatch& echoes) const {
  const ScattererSheet& sheet = scene_->sheets[index];
  const core::Vec3 normal_world = poses_[sheet.platform].world_from_platform * sheet.normal_platform;
  for (const core::Vec3& point_m : sheet.points_m) {
    const std::optional<ScattererView> v = point_view(sheet, normal_world, point_m, pointing);
    if (!v) continue;
    expect_possible("surface", index, *v);
    echoes.add(v->delay_s, v->amplitude_sqrt_w, v->speed_mps);
  }
}

}  // namespace sarsim::simulate
