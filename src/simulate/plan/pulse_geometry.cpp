#include "simulate/plan/pulse_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/random.hpp"
#include "core/report/expect.hpp"
#include "radar/earth/resting_axes.hpp"
#include "radar/path/light_time.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::simulate {

struct PulseGeometry::Sight {
  radar::Flight flight;
  double dilation_rate = 0.0;
  double speed_mps = 0.0;   // of the point, or of the radar: the faster one, in any direction
  double distance_m = 0.0;  // as the pulse leaves
};

namespace {

// No vector of unit length is turned into a longer one than this.
double turning_of(const core::Mat3& m) {
  return core::norm({core::norm(m.row[0]), core::norm(m.row[1]), core::norm(m.row[2])});
}

// Of amplitudes; one antenna for both ways is looked at once.
double two_way_gain(const Link& radar, radar::PatternRule rule, const radar::Pointing& pointing,
                    const core::Vec3& line_of_sight_m) {
  using Kind = radar::AntennaPattern::Kind;
  const radar::AntennaPattern& out = radar.transmit;
  const radar::AntennaPattern& back = radar.receive;
  if (out.kind == Kind::isotropic && back.kind == Kind::isotropic) return 1.0;
  const radar::BeamOffset offset = pointing.offset(line_of_sight_m);
  const double way_out = radar::one_way_amplitude(out, offset.azimuth_rad, offset.elevation_rad, rule);
  const bool same = out.kind == Kind::sinx && back.kind == Kind::sinx &&
                    out.azimuth_beamwidth_rad == back.azimuth_beamwidth_rad &&
                    out.elevation_beamwidth_rad == back.elevation_beamwidth_rad;
  if (same) return way_out * way_out;
  return way_out * radar::one_way_amplitude(back, offset.azimuth_rad, offset.elevation_rad, rule);
}

}  // namespace

PulseGeometry::PulseGeometry(const ResolvedScene& scene, const Link& radar)
    : scene_(&scene), radar_(&radar), platforms_(reflecting_platforms(scene)), reflecting_(platforms_.size()) {
  CORE_EXPECT(radar.platform < scene.platforms.size());
  CORE_EXPECT(scene.conventions.light_speed_mps > 0.0);
  if (!std::ranges::binary_search(platforms_, radar.platform)) platforms_.push_back(radar.platform);
  slot_of_.assign(scene.platforms.size(), std::numeric_limits<std::uint32_t>::max());
  for (std::size_t slot = 0; slot < platforms_.size(); ++slot)
    slot_of_[platforms_[slot]] = static_cast<std::uint32_t>(slot);
  for (const std::uint32_t platform : platforms_) poses_.push_back(scene.platforms[platform].track.at(0.0, 0));
  frames_.resize(platforms_.size());
  error_steps_.resize(platforms_.size());
  range_loss_ = !(radar.stc != scene::Radar::Stc::none && scene.conventions.stc == Conventions::Stc::no_spreading);
  set_pulse(0);
}

void PulseGeometry::set_pulse(std::int64_t pulse) {
  pulse_ = pulse;
  time_s_ = radar_->repetition.send_time_s(pulse);
  carrier_hz_ = radar_->carrier.carrier_hz(pulse);
  for (std::size_t slot = 0; slot < platforms_.size(); ++slot)
    if (const radar::Track& track = scene_->platforms[platforms_[slot]].track; !track.fixed())
      poses_[slot] = track.at(time_s_, pulse, error_steps_[slot]);
  bends_ = false;
  for (std::size_t slot = 0; slot < reflecting_; ++slot) set_frame(slot);
  const double wavelength_m = radar::wavelength_of(carrier_hz_, scene_->conventions.light_speed_mps);
  amplitude_scale_ = std::sqrt(radar_->radiated_w) * wavelength_m / std::pow(4.0 * core::pi, 1.5);
}

void PulseGeometry::set_frame(std::size_t slot) {
  radar::ViewFrame& frame = frames_[slot];
  const radar::Pose& pose = poses_[slot];
  const std::size_t platform = platforms_[slot];
  frame = {};
  frame.light_time = scene_->conventions.light_time;
  frame.light_speed_mps = scene_->conventions.light_speed_mps;
  frame.pulse = pulse_;
  frame.world_from_platform = pose.world_from_platform;
  frame.world_from_platform_rate = pose.world_from_platform_rate;
  frame.origin_m = pose.position_world_m - radar_pose().position_world_m;
  frame.velocity_mps = pose.velocity_world_mps - radar_pose().velocity_world_mps;
  if (frame.light_time == radar::LightTime::thesis) return;
  set_flight(platform, frame);
  set_bend(platform, frame);
  bends_ = bends_ || frame.bends;
}

// The platform is taken where the pulse meets its middle, the radar's velocity from where it is as that echo comes
// back.
void PulseGeometry::set_flight(std::size_t platform, radar::ViewFrame& frame) {
  const ResolvedPlatform& carrier = scene_->platforms[platform];
  const ResolvedPlatform& own = scene_->platforms[radar_->platform];
  const core::Vec3 middle_m = frame.origin_m + frame.world_from_platform * carrier.middle_m;
  const double out_s = core::norm(middle_m) / frame.light_speed_mps;
  frame.velocity_mps = {};
  const bool turns = scene_->turns();  // The Earth carries what rests on it.
  frame.moves = !carrier.track.fixed() || turns;
  if (frame.moves) {
    radar::Pose met = carrier.track.at(time_s_ + out_s, pulse_, error_steps_[slot_of_[platform]]);
    if (turns) met = at_rest(met, out_s);
    frame.world_from_platform = met.world_from_platform;
    frame.world_from_platform_rate = met.world_from_platform_rate;
    frame.origin_m = met.position_world_m - radar_pose().position_world_m;
    frame.velocity_mps = met.velocity_world_mps;
    frame.anchor_s = out_s;
  }
  frame.back_s = 2.0 * out_s;
  if (own.track.fixed() && !turns) return;
  radar::Travel back = own.track.travel_at(time_s_ + frame.back_s, pulse_, error_steps_[slot_of_[radar_->platform]]);
  core::Vec3 sent_mps = radar_pose().velocity_world_mps;
  if (turns) {
    sent_mps = radar::RestingAxes(scene_->turning, 0.0).velocity_mps(radar_pose().position_world_m, sent_mps);
    const radar::RestingAxes axes(scene_->turning, frame.back_s);
    back = {axes.position_m(back.position_world_m), axes.velocity_mps(back.position_world_m, back.velocity_world_mps)};
  }
  frame.radar_slope_mps = 0.5 * (sent_mps + back.velocity_world_mps);
  frame.radar_mps = out_s > 0.0 ? (1.0 / frame.back_s) * (back.position_world_m - radar_pose().position_world_m)
                                : frame.radar_slope_mps;
}

// A pose a while after the pulse left, as seen from axes that rest and agree with the world's as it leaves.
radar::Pose PulseGeometry::at_rest(const radar::Pose& pose, double elapsed_s) const {
  const radar::RestingAxes axes(scene_->turning, elapsed_s);
  radar::Pose rest = pose;
  rest.position_world_m = axes.position_m(pose.position_world_m);
  rest.velocity_world_mps = axes.velocity_mps(pose.position_world_m, pose.velocity_world_mps);
  rest.world_from_platform = axes.axes(pose.world_from_platform);
  rest.world_from_platform_rate = axes.axes_rate(pose.world_from_platform, pose.world_from_platform_rate);
  return rest;
}

// Accelerations are computed where their bounds say that they may count.
void PulseGeometry::set_bend(std::size_t platform, radar::ViewFrame& frame) {
  const ResolvedPlatform& carrier = scene_->platforms[platform];
  const ResolvedPlatform& own = scene_->platforms[radar_->platform];
  const double reach_m = core::norm(carrier.middle_m) + carrier.radius_m;
  const bool turns = carrier.track.turns() && reach_m > 0.0;
  if (!turns && !scene_->turns() &&
      !bend_counts(platform, frame, carrier.track.acceleration_bound_mps2(), own.track.acceleration_bound_mps2()))
    return;
  if (!carrier.track.fixed()) {
    const radar::PoseAcceleration of_carrier = carrier.track.acceleration_at(time_s_ + frame.anchor_s, pulse_);
    frame.acceleration_mps2 = of_carrier.acceleration_world_mps2;
    frame.world_from_platform_acceleration = of_carrier.world_from_platform_acceleration;
  }
  if (!own.track.fixed())
    frame.radar_mps2 =
        own.track.acceleration_at(time_s_, pulse_, radar_pose(), error_steps_[slot_of_[radar_->platform]])
            .acceleration_world_mps2;
  if (scene_->turns()) set_bend_at_rest(platform, frame);
  frame.bends =
      bend_counts(platform, frame,
                  core::norm(frame.acceleration_mps2) + turning_of(frame.world_from_platform_acceleration) * reach_m,
                  core::norm(frame.radar_mps2));
}

// The accelerations in axes that rest: of what the turning world carries too.
void PulseGeometry::set_bend_at_rest(std::size_t platform, radar::ViewFrame& frame) const {
  const radar::Pose met = scene_->platforms[platform].track.at(time_s_ + frame.anchor_s, pulse_);
  const radar::RestingAxes then(scene_->turning, frame.anchor_s);
  frame.acceleration_mps2 =
      then.acceleration_mps2(met.position_world_m, met.velocity_world_mps, frame.acceleration_mps2);
  frame.world_from_platform_acceleration = then.axes_acceleration(met.world_from_platform, met.world_from_platform_rate,
                                                                  frame.world_from_platform_acceleration);
  const radar::RestingAxes now(scene_->turning, 0.0);
  frame.radar_mps2 =
      now.acceleration_mps2(radar_pose().position_world_m, radar_pose().velocity_world_mps, frame.radar_mps2);
}

// Whether accelerations up to those given turn the ends of the pulse, or the echoes of points beside the platform's
// middle, by more than a twentieth of the tolerance.
bool PulseGeometry::bend_counts(std::size_t platform, const radar::ViewFrame& frame, double platform_mps2,
                                double radar_mps2) const {
  const ResolvedPlatform& carrier = scene_->platforms[platform];
  if (carrier.track.fixed() && scene_->platforms[radar_->platform].track.fixed() && !scene_->turns()) return false;
  const double light_mps = frame.light_speed_mps;
  const double reach_m = core::norm(carrier.middle_m) + carrier.radius_m;
  const double speed_mps =
      core::norm(frame.velocity_mps - frame.radar_slope_mps) + turning_of(frame.world_from_platform_rate) * reach_m;
  const double middle_m = core::norm(frame.origin_m + frame.world_from_platform * carrier.middle_m);
  const double nearest_m = std::max(middle_m - carrier.radius_m, 0.0);
  const double half_s = 0.5 * radar_->pulse.width_s;
  const double dilation_rate =
      radar::delay_of(speed_mps * speed_mps / nearest_m + platform_mps2 + radar_mps2, light_mps);
  const double beside_s = radar::delay_of(carrier.radius_m, light_mps);
  const double off_m = beside_s * (platform_mps2 * beside_s + radar_mps2 * (frame.back_s + beside_s));
  const double turn_rad = core::pi * carrier_hz_ * (dilation_rate * half_s * half_s + off_m / light_mps);
  return !(turn_rad <= 0.05 * scene_->options.tolerance);
}

radar::Pointing PulseGeometry::pointing() const {
  const radar::Pose& pose = radar_pose();
  return {radar_->beam,          scene_->conventions.pointing, time_s_,
          pose.position_world_m, pose.world_from_platform,     pose.rotation_rad};
}

PulseGeometry::Sight PulseGeometry::sight_of(std::size_t platform, const core::Vec3& point_m,
                                             const core::Vec3& undisturbed_m) const {
  const radar::ViewFrame& frame = this->frame(platform);
  const core::Vec3 line_of_sight_m = frame.origin_m + frame.world_from_platform * point_m;
  // Jitter moves positions, never speeds (decision 4): the velocity is that of the undisturbed point.
  const auto velocity_mps = [&] { return frame.velocity_mps + frame.world_from_platform_rate * undisturbed_m; };
  const auto distance_m = [&] {
    return core::norm(radar::world_position_m(pose(platform), point_m) - radar_pose().position_world_m);
  };
  Sight sight;
  if (frame.light_time == radar::LightTime::thesis) {
    sight.flight = radar::thesis_flight_of(line_of_sight_m, velocity_mps(), frame.light_speed_mps);
    sight.distance_m = distance_m();
    return sight;
  }
  sight.speed_mps = core::norm(frame.radar_mps);
  radar::FlightMotion motion{{}, frame.anchor_s, frame.radar_mps, frame.radar_slope_mps, {}, {}, 0.0};
  if (frame.moves) {
    motion.point_mps = velocity_mps();
    sight.speed_mps = std::max(core::norm(motion.point_mps), sight.speed_mps);
    sight.flight = radar::flight_of(line_of_sight_m, motion, frame.light_speed_mps);
    sight.distance_m = distance_m();
  } else {
    sight.flight =
        radar::flight_to_resting(line_of_sight_m, frame.radar_mps, frame.radar_slope_mps, frame.light_speed_mps);
    sight.distance_m = sight.flight.path.out_m;
  }
  if (sight.flight.path.out_m == 0.0) sight.flight.doppler = 0.0;
  if (sight.flight.path.out_m == 0.0 || !frame.bends) return sight;
  motion.point_mps2 = frame.acceleration_mps2 + frame.world_from_platform_acceleration * undisturbed_m;
  motion.radar_mps2 = frame.radar_mps2;
  motion.back_s = frame.back_s;
  sight.dilation_rate = radar::bend_of(sight.flight.line_of_sight_m, motion, frame.light_speed_mps);
  radar::bend(sight.flight, motion, frame.light_speed_mps);
  return sight;
}

// A normal of the platform's as the pulse meets the point.
core::Vec3 PulseGeometry::normal_at(const radar::ViewFrame& frame, const core::Vec3& normal_platform,
                                    const Sight& sight) const {
  const core::Vec3 at_anchor = frame.world_from_platform * normal_platform;
  if (!frame.moves) return at_anchor;
  const double early_s = sight.flight.path.out_m / frame.light_speed_mps - frame.anchor_s;
  return at_anchor + early_s * (frame.world_from_platform_rate * normal_platform);
}

ScattererView PulseGeometry::seen(const Sight& sight, double rcs_m2, const radar::Pointing& pointing) const {
  const double light_mps = scene_->conventions.light_speed_mps;
  const radar::Flight& flight = sight.flight;
  ScattererView view;
  view.distance_m = sight.distance_m;
  view.delay_s = flight.delay_s;
  view.clock = {flight.doppler, sight.dilation_rate};
  if (sight.speed_mps >= light_mps)
    view.speed_mps = sight.speed_mps;
  else if (scene_->conventions.light_time == radar::LightTime::thesis)
    view.speed_mps = 0.5 * flight.doppler * light_mps;
  else
    view.speed_mps = radar::speed_of_doppler_factor(flight.doppler, light_mps);
  const double gain = two_way_gain(*radar_, scene_->conventions.pattern, pointing, flight.line_of_sight_m);
  const double spreading = range_loss_ ? flight.path.out_m * flight.path.back_m : 1.0;
  view.amplitude_sqrt_w = amplitude_scale_ * gain * std::sqrt(rcs_m2) / spreading;
  if (radar_->air) {
    const core::Vec3& from_m = radar_pose().position_world_m;
    const AirEffect effect = radar_->air->between(from_m, from_m + flight.line_of_sight_m, carrier_hz_);
    view.delay_s += effect.delay_s;
    view.ahead_turns = effect.ahead_turns;
    view.amplitude_sqrt_w *= effect.factor;
  }
  return view;
}

ScattererView PulseGeometry::view(std::size_t index) const { return view(index, pointing()); }

ScattererView PulseGeometry::view(std::size_t index, const radar::Pointing& pointing) const {
  const Scatterer& s = scene_->scatterers[index];
  const radar::ViewFrame& frame = this->frame(s.platform);
  core::Vec3 point_m = s.position_m;
  double rcs_m2 = s.rcs_m2;
  double azimuth = s.azimuth_rad;
  double elevation = s.elevation_rad;
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
  const Sight sight = sight_of(s.platform, point_m, s.position_m);
  rcs_m2 = std::max(0.0, rcs_m2);
  double incidence_rad = 0.0;
  if (s.law != radar::ReflectivityLaw::isotropic) {
    const core::Vec3 normal_world = normal_at(frame, core::direction(azimuth, elevation), sight);
    static const core::Interpolator none;
    const core::Interpolator& curve = s.law == radar::ReflectivityLaw::user ? scene_->gain_curves[s.gain_curve] : none;
    incidence_rad = radar::incidence_rad(normal_world, sight.flight.line_of_sight_m);
    rcs_m2 *= radar::reflectivity(s.law, curve, incidence_rad);
  }
  ScattererView view = seen(sight, rcs_m2, pointing);
  view.incidence_rad = incidence_rad;
  return view;
}

void PulseGeometry::add(const ScattererView& view, radar::EchoBatch& echoes) const {
  if (bends_)
    echoes.add(view.delay_s, view.amplitude_sqrt_w, view.clock);
  else
    echoes.add(view.delay_s, view.amplitude_sqrt_w, view.clock.doppler);
  if (advances()) echoes.ahead_turns.push_back(view.ahead_turns);
}

void PulseGeometry::echoes(radar::EchoBatch& echoes) const {
  echoes.clear();
  const radar::Pointing axis = pointing();
  for (std::size_t i = 0; i < scene_->scatterers.size(); ++i) {
    const ScattererView v = view(i, axis);
    expect_possible("target", i, v);
    add(v, echoes);
  }
  for (std::size_t i = 0; i < scene_->sheets.size(); ++i) add_sheet(i, axis, echoes);
}

void PulseGeometry::expect_possible(std::string_view kind, std::size_t index, const ScattererView& view) const {
  const EchoExtremes echo{view.distance_m, view.speed_mps, view.amplitude_sqrt_w};
  const double light_mps = scene_->conventions.light_speed_mps;
  if (possible_echo(echo, light_mps)) return;
  core::Problem problem = problem_of_echo(kind, index, radar_->name, echo, light_mps);
  problem.message += text_of_pulse(pulse_, time_s_);
  throw ImpossibleEcho(std::move(problem));
}

std::optional<ScattererView> PulseGeometry::point_view(const ScattererSheet& sheet, const core::Vec3& point_m,
                                                       const radar::Pointing& pointing) const {
  static const core::Interpolator none;
  const Sight sight = sight_of(sheet.platform, point_m, point_m);
  const core::Vec3 normal_world = normal_at(frame(sheet.platform), sheet.normal_platform, sight);
  const double law = radar::reflectivity(radar::ReflectivityLaw::cosine, none,
                                         radar::incidence_rad(normal_world, sight.flight.line_of_sight_m));
  if (law <= 0.0) return std::nullopt;
  const ScattererView view = seen(sight, sheet.point_rcs_m2 * law, pointing);
  // A plane through the radar shows it neither side.
  if (view.distance_m == 0.0) return std::nullopt;
  return view;
}

std::optional<ScattererView> PulseGeometry::sheet_view(std::size_t sheet, std::size_t point,
                                                       const radar::Pointing& pointing) const {
  const ScattererSheet& surface = scene_->sheets[sheet];
  return point_view(surface, surface.points_m[point], pointing);
}

void PulseGeometry::add_sheet(std::size_t index, const radar::Pointing& pointing, radar::EchoBatch& echoes) const {
  const ScattererSheet& sheet = scene_->sheets[index];
  for (const core::Vec3& point_m : sheet.points_m) {
    const std::optional<ScattererView> v = point_view(sheet, point_m, pointing);
    if (!v) continue;
    expect_possible("surface", index, *v);
    add(*v, echoes);
  }
}

}  // namespace sarsim::simulate
