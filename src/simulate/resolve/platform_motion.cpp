#include "simulate/resolve/platform_motion.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/maths/random.hpp"
#include "radar/motion/dryden.hpp"
#include "radar/motion/heave_response.hpp"
#include "radar/motion/sea.hpp"
#include "radar/motion/ship.hpp"
#include "scene/model/function_role.hpp"
#include "scene/model/read_path.hpp"
#include "scene/model/route.hpp"
#include "scene/model/scene_index.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::simulate {

namespace {

using scene::Platform;

std::array<core::Interpolator, 3> three_functions(const scene::UserFunction<3>& function, core::InterpolationRules rule,
                                                  double scale = 1.0) {
  return {core::Interpolator(function.part[0], rule, scale), core::Interpolator(function.part[1], rule, scale),
          core::Interpolator(function.part[2], rule, scale)};
}

core::Interpolator constant(double value) {
  return core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0.0, value}}});
}

std::array<double, 3> radians(const std::array<core::Angle, 3>& angles) {
  return {angles[0].rad(), angles[1].rad(), angles[2].rad()};
}

radar::SegmentPath sound(radar::PathResult made, const Platform& platform) {
  if (!made.fault.empty()) throw std::invalid_argument("the path of platform '" + platform.name + "': " + made.fault);
  return std::move(made.path);
}

core::RandomStream stream_of(const Platform& platform, core::RandomKind kind, std::uint64_t seed) {
  return {seed, kind, core::name_key(platform.name)};
}

void add_oscillations(const Platform& platform, std::vector<radar::Sine>& sines) {
  for (const scene::Oscillation& one : platform.oscillations) {
    const bool turns = one.axis >= scene::Oscillation::Axis::roll;
    sines.push_back({static_cast<radar::SineAxis>(one.axis), turns ? one.angle.rad() : one.amplitude_m,
                     one.frequency_hz, one.phase.rad()});
  }
}

// A ship at its heading and speed of time 0. The bow is the platform's x axis: along the velocity where it follows
// that.
void add_waves(const Platform& platform, const radar::MotionPath& path, std::uint64_t seed,
               std::vector<radar::Sine>& sines) {
  const core::Vec3 velocity = path.state(0.0).velocity_world_mps;
  const double speed_mps = std::hypot(velocity.x, velocity.y);
  const bool follows = platform.aligned || platform.rotation_kind == Platform::Rotation::coordinated;
  const double ahead_rad =
      follows && speed_mps > 0.0 ? core::azimuth_rad({velocity.x, velocity.y, 0.0}) : core::pi / 2.0;
  const double bow_rad = ahead_rad + platform.rotation[2].rad();
  const radar::Hull hull{platform.ship_length_m, platform.ship_beam_m, platform.ship_draught_m,
                         platform.metacentric_height_m, platform.roll_damping};
  // Azimuths count clockwise, the course of waves counterclockwise from the bow.
  const radar::Course course{speed_mps, bow_rad - platform.wave_heading.rad()};
  const auto motion = radar::ship_sines(hull, course, {platform.wave_height_m, platform.wave_period_s},
                                        platform.wave_count, stream_of(platform, core::RandomKind::wave, seed));
  sines.insert(sines.end(), motion.begin(), motion.end());
}

void add_gusts(const Platform& platform, radar::Motion& motion) {
  const radar::Turbulence air =
      radar::turbulence_at(platform.gust_height_m, static_cast<radar::TurbulenceSeverity>(platform.turbulence));
  const radar::HeaveResponse response{platform.response_s, 2.0 * core::pi / platform.hold_s, platform.hold_damping};
  const auto envelope = [&](radar::GustForm form, double sigma_mps, double length_m) {
    radar::GustMotion made = radar::gust_motion({form, sigma_mps, length_m, platform.airspeed_mps}, response);
    if (!made.fault.empty())
      throw std::invalid_argument("the gusts of platform '" + platform.name + "': " + made.fault);
    return std::move(made.displacement);
  };
  motion.errors_follow_path = true;
  motion.smooth_errors = true;
  motion.position_envelope = {envelope(radar::GustForm::along, air.sigma_u_mps, air.length_u_m),
                              envelope(radar::GustForm::across, air.sigma_v_mps, air.length_v_m),
                              envelope(radar::GustForm::across, air.sigma_w_mps, air.length_w_m)};
}

// An error process ends its envelope where the points do, within rounding: scene::FunctionRole::position_envelope.
void add_errors(const Platform& platform, core::InterpolationRules rule, radar::Motion& motion) {
  switch (platform.position_error) {
    case Platform::MotionError::gaussian:
      motion.position_stddev_m = {platform.position_stddev_m.x, platform.position_stddev_m.y,
                                  platform.position_stddev_m.z};
      break;
    case Platform::MotionError::envelope:
      motion.position_envelope = three_functions(platform.position_envelope, rule);
      break;
    case Platform::MotionError::gusts: add_gusts(platform, motion); break;
  }
  if (platform.rotation_error == Platform::MotionError::envelope)
    motion.rotation_envelope = three_functions(platform.rotation_envelope, rule, core::rad_per_deg);
  else
    motion.rotation_stddev_rad = radians(platform.rotation_stddev);
}

// Makes motions, those that others depend on first.
class TrackMaker {
 public:
  TrackMaker(const scene::Scene& scene, core::InterpolationRules rule)
      : scene_(scene),
        rule_(rule),
        turning_(turning_of(scene.world)),
        names_(scene),
        paths_(scene.platforms.size()),
        tracks_(scene.platforms.size()),
        under_way_(scene.platforms.size(), false) {}

  const radar::Track& track(std::size_t index) { return *shared_track(index); }

 private:
  // The platform that another one means; none for the world itself.
  std::optional<std::size_t> meant(const std::string& name) {
    if (name.empty()) return std::nullopt;
    const std::size_t found = names_.platform(name);
    return found == scene::not_found ? std::nullopt : std::optional(found);
  }

  // Those that carry it first, without recursion: a chain of parents at rest may be of any length.
  std::shared_ptr<const radar::Track> shared_track(std::size_t index) {
    std::vector<std::size_t> chain;
    for (std::optional<std::size_t> at = index; at && !tracks_[*at]; at = meant(scene_.platforms[*at].parent)) {
      if (under_way_[*at])
        throw std::invalid_argument("platform '" + scene_.platforms[*at].name + "' depends on itself");
      under_way_[*at] = true;
      chain.push_back(*at);
    }
    for (; !chain.empty(); chain.pop_back()) {
      const Platform& platform = scene_.platforms[chain.back()];
      tracks_[chain.back()] =
          std::make_shared<const radar::Track>(motion_of(platform, chain.back()), scene_.options.seed, platform.name);
      under_way_[chain.back()] = false;
    }
    return tracks_[index];
  }

  const radar::MotionPath& path(std::size_t index) {
    if (!paths_[index]) paths_[index] = std::make_shared<const radar::MotionPath>(path_of(index));
    return *paths_[index];
  }

  radar::MotionPath path_of(std::size_t index) {
    const Platform& platform = scene_.platforms[index];
    switch (platform.path) {
      case Platform::Path::stationary: break;
      case Platform::Path::trajectory:
        return radar::FunctionPath{
            three_functions(platform.trajectory_m, scene::rules_for(scene::FunctionRole::trajectory, rule_))};
      case Platform::Path::ephemeris:
      case Platform::Path::orbit:
      case Platform::Path::state:
        if (!platform.read_path)
          throw std::invalid_argument("the orbit of platform '" + platform.name + "' is not read");
        return radar::StatePath{platform.read_path->states};
      case Platform::Path::legs:
      case Platform::Path::waypoints: return sound(scene::route_of(platform), platform);
      case Platform::Path::relative: return relative_to(platform);
    }
    const core::Vec3& at = platform.position_m;
    return radar::FunctionPath{{constant(at.x), constant(at.y), constant(at.z)}};
  }

  radar::MotionPath relative_to(const Platform& platform) {
    const radar::PathOffset offset{platform.offset_m.x, platform.offset_m.y, platform.offset_m.z, platform.delay_s};
    const auto leader = meant(platform.leader);
    std::shared_ptr<const radar::MotionPath> lead;
    if (leader)
      lead = following(*leader);
    else
      lead = std::make_shared<const radar::MotionPath>();
    return radar::RelativePath{std::move(lead), offset};
  }

  std::shared_ptr<const radar::MotionPath> following(std::size_t leader) {
    constexpr int longest_chain = 64;
    if (++depth_ > longest_chain) throw std::invalid_argument("leaders of platforms follow each other in a circle");
    static_cast<void>(path(leader));
    --depth_;
    return paths_[leader];
  }

  radar::AttitudeLaw law_of(const Platform& platform) const {
    using Kind = radar::AttitudeLaw::Kind;
    radar::AttitudeLaw law;
    law.earth = turning_;
    switch (platform.rotation_kind) {
      case Platform::Rotation::constant:
      case Platform::Rotation::user: break;
      case Platform::Rotation::coordinated:
        law.kind = Kind::coordinated;
        law.attack_rad = platform.attack.rad();
        break;
      case Platform::Rotation::zero_doppler: law.kind = Kind::zero_doppler; break;
      case Platform::Rotation::nadir:
        law.kind = Kind::nadir;
        law.flight = static_cast<radar::FlightDirection>(platform.flight);
        break;
      case Platform::Rotation::look_at:
        law.kind = Kind::look_at;
        law.point_world_m = platform.look_at_m;
        break;
      case Platform::Rotation::quaternions:
        if (!platform.read_attitude)
          throw std::invalid_argument("the attitude of platform '" + platform.name + "' is not read");
        law.kind = Kind::quaternions;
        law.table = platform.read_attitude->attitudes;
        break;
    }
    return law;
  }

  radar::Motion motion_of(const Platform& platform, std::size_t index) {
    radar::Motion motion;
    motion.path = path(index);
    motion.aligned = platform.path != Platform::Path::stationary && platform.aligned;
    motion.attitude = law_of(platform);
    if (platform.rotation_kind == Platform::Rotation::user)
      motion.rotation_rad = three_functions(platform.rotation_deg,
                                            scene::rules_for(scene::FunctionRole::rotation, rule_), core::rad_per_deg);
    else
      for (std::size_t i = 0; i < 3; ++i) motion.rotation_rad[i] = constant(platform.rotation[i].rad());
    motion.rotation_rate_rad_per_s = radians(platform.rotation_rate);
    add_oscillations(platform, motion.sines);
    if (platform.waves == Platform::Waves::ship) add_waves(platform, motion.path, scene_.options.seed, motion.sines);
    add_errors(platform, rule_, motion);
    if (const auto parent = meant(platform.parent)) motion.parent = tracks_[*parent];
    return motion;
  }

  const scene::Scene& scene_;
  core::InterpolationRules rule_;
  radar::TurningAxes turning_;
  scene::SceneIndex names_;
  std::vector<std::shared_ptr<const radar::MotionPath>> paths_;
  std::vector<std::shared_ptr<const radar::Track>> tracks_;
  std::vector<bool> under_way_;
  int depth_ = 0;
};

}  // namespace

radar::TurningAxes turning_of(const scene::World& world) {
  const auto earth = scene::earth_of(world);
  return earth ? earth->turning() : radar::TurningAxes{};
}

std::vector<radar::Track> tracks_of(const scene::Scene& scene, core::InterpolationRules rule) {
  TrackMaker maker(scene, rule);
  std::vector<radar::Track> tracks;
  for (std::size_t i = 0; i < scene.platforms.size(); ++i) tracks.push_back(maker.track(i));
  return tracks;
}

}  // namespace sarsim::simulate
