#include "simulate/resolve/resolved.hpp"

#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "core/text/number_text.hpp"
#include "radar/target/surface.hpp"
#include "scene/check/check_names.hpp"
#include "scene/model/radar_pulse.hpp"

namespace sarsim {

namespace {

std::array<Interpolator, 3> three(const UserFunction<3>& function, LowPassRule rule, double scale = 1.0) {
  return {Interpolator(function.part[0], rule, scale), Interpolator(function.part[1], rule, scale),
          Interpolator(function.part[2], rule, scale)};
}

Interpolator constant(double value) { return Interpolator(SampledFunction{Interpolation::linear, {{0.0, value}}}); }

std::array<double, 3> radians(const std::array<Angle, 3>& angles) {
  return {angles[0].rad(), angles[1].rad(), angles[2].rad()};
}

Motion motion_of(const Platform& platform, LowPassRule rule) {
  Motion motion;
  if (platform.path == Platform::Path::trajectory)
    motion.position_m = three(platform.trajectory_m, rule);
  else
    motion.position_m = {constant(platform.position_m.x), constant(platform.position_m.y),
                         constant(platform.position_m.z)};
  motion.aligned = platform.path == Platform::Path::trajectory && platform.aligned;
  if (platform.rotation_kind == Platform::Rotation::user)
    motion.rotation_rad = three(platform.rotation_deg, rule, rad_per_deg);
  else
    for (std::size_t i = 0; i < 3; ++i) motion.rotation_rad[i] = constant(platform.rotation[i].rad());
  motion.rotation_rate_rad_per_s = radians(platform.rotation_rate);
  if (platform.position_error == Platform::MotionError::envelope)
    motion.position_envelope = three(platform.position_envelope, rule);
  else
    motion.position_stddev_m = {platform.position_stddev_m.x, platform.position_stddev_m.y,
                                platform.position_stddev_m.z};
  if (platform.rotation_error == Platform::MotionError::envelope)
    motion.rotation_envelope = three(platform.rotation_envelope, rule, rad_per_deg);
  else
    motion.rotation_stddev_rad = radians(platform.rotation_stddev);
  return motion;
}

Scatterer scatterer_of(const Target& target, std::uint32_t platform, ResolvedScene& resolved) {
  Scatterer s;
  s.platform = platform;
  s.position_m = target.position_m;
  s.position_stddev_m = target.position_stddev_m;
  s.rcs_m2 = target.rcs_m2;
  s.rcs_stddev_m2 = target.rcs_stddev_m2;
  if (target.reflectivity == Target::Reflectivity::directional) {
    s.law = target.gain == Target::Gain::cosine ? ReflectivityLaw::cosine : ReflectivityLaw::user;
    s.azimuth_rad = target.azimuth.rad();
    s.elevation_rad = target.elevation.rad();
    s.azimuth_stddev_rad = target.azimuth_stddev.rad();
    s.elevation_stddev_rad = target.elevation_stddev.rad();
    if (s.law == ReflectivityLaw::user) {
      s.gain_curve = static_cast<std::uint32_t>(resolved.gain_curves.size());
      resolved.gain_curves.emplace_back(target.gain_db.part[0], resolved.conventions.low_pass);
    }
  }
  s.jittered = s.position_stddev_m != Vec3{} || s.rcs_stddev_m2 != 0.0 || s.azimuth_stddev_rad != 0.0 ||
               s.elevation_stddev_rad != 0.0;
  return s;
}

std::vector<double> ordinates(const UserFunction<1>& function) {
  std::vector<double> values;
  for (const Knot& knot : function.part[0].knots) values.push_back(knot.y);
  return values;
}

CarrierPlan carrier_of(const Radar& radar) {
  switch (radar.carrier) {
    case Radar::Carrier::single: break;
    case Radar::Carrier::stepped:
      return CarrierPlan::stepped(radar.carrier_hz, radar.carrier_step_hz, radar.carrier_steps, radar.pulses_per_step);
    case Radar::Carrier::user: return CarrierPlan::list(ordinates(radar.carrier_list_hz));
  }
  return CarrierPlan::single(radar.carrier_hz);
}

AntennaPattern pattern_of(const Antenna& antenna, LowPassRule rule) {
  AntennaPattern pattern;
  switch (antenna.pattern) {
    case Antenna::Pattern::isotropic: break;
    case Antenna::Pattern::sinx:
      pattern.kind = AntennaPattern::Kind::sinx;
      pattern.azimuth_beamwidth_rad = antenna.azimuth_beamwidth.rad();
      pattern.elevation_beamwidth_rad = antenna.elevation_beamwidth.rad();
      break;
    case Antenna::Pattern::user:
      pattern.kind = AntennaPattern::Kind::user;
      pattern.azimuth_gain_db = Interpolator(antenna.gain_db.part[0], rule);
      pattern.elevation_gain_db = Interpolator(antenna.gain_db.part[1], rule);
      break;
  }
  return pattern;
}

Beam beam_of(const Radar& radar, LowPassRule rule) {
  Beam beam;
  beam.azimuth_rad = radar.beam_azimuth.rad();
  beam.elevation_rad = radar.beam_elevation.rad();
  beam.rate_rad_per_s = radar.beam_rate.rad();
  beam.spot_world_m = radar.spot_world_m;
  switch (radar.beam) {
    case Radar::Beam::fixed: beam.kind = Beam::Kind::fixed; break;
    case Radar::Beam::rotating: beam.kind = Beam::Kind::rotating; break;
    case Radar::Beam::spot: beam.kind = Beam::Kind::spot; break;
    case Radar::Beam::user:
      beam.kind = Beam::Kind::user;
      beam.target_world_m = three(radar.beam_target_world_m, rule);
      break;
  }
  return beam;
}

WindowFunction window_of(const Radar& radar, LowPassRule rule) {
  switch (radar.window) {
    case Radar::Window::rectangular: break;
    case Radar::Window::hanning:
      return [pedestal = radar.hanning_pedestal](double x) { return hanning_window(x, pedestal); };
    case Radar::Window::bartlett: return bartlett_window;
    case Radar::Window::hamming: return hamming_window;
    case Radar::Window::user:
      return [f = Interpolator(radar.window_gain.part[0], rule)](double x) { return f.value(x); };
  }
  return [](double) { return 1.0; };
}

// What names of platforms stand for: positions in ResolvedScene::platforms, of which the last is the world itself.
class PlatformNames {
 public:
  explicit PlatformNames(const Scene& scene) : table_(names_of(scene)) {}

  std::uint32_t find(std::string_view name) {
    // Targets that follow each other nearly always share a platform.
    if (last_ && name == last_->first) return last_->second;
    return last_.emplace(name, look_up(name)).second;
  }

 private:
  static std::vector<std::string_view> names_of(const Scene& scene) {
    std::vector<std::string_view> names;
    for (const Platform& platform : scene.platforms) names.emplace_back(platform.name);
    return names;
  }

  // As `find_platform` does, which takes too long for many platforms.
  [[nodiscard]] std::uint32_t look_up(std::string_view name) const {
    const NameTable::Result found = table_.find(name);
    const bool world = equal_ignoring_case(name, "Earth");
    if (found.match == NameTable::Match::exact || (found.match == NameTable::Match::prefix && !world))
      return static_cast<std::uint32_t>(found.index);
    if (world) return static_cast<std::uint32_t>(table_.names().size());
    throw std::invalid_argument("platform '" + std::string(name) + "' is not defined");
  }

  NameTable table_;
  std::optional<std::pair<std::string_view, std::uint32_t>> last_;
};

}  // namespace

ResolvedScene resolve(const Scene& scene, const WorkControl& control) {
  ResolvedScene resolved;
  resolved.conventions = conventions_of(scene.options.profile);
  resolved.options = scene.options;
  const LowPassRule rule = resolved.conventions.low_pass;
  for (const Platform& platform : scene.platforms)
    resolved.platforms.push_back({platform.name, Track(motion_of(platform, rule), scene.options.seed, platform.name)});
  // The world itself, last, for scripts that use "Earth" without defining it.
  resolved.platforms.push_back({"Earth", Track(motion_of(Platform{}, rule), scene.options.seed, "Earth")});

  PlatformNames platforms(scene);
  reserve_touched(resolved.scatterers, scene.targets.size(), control);
  for (const Target& target : scene.targets) {
    constexpr std::size_t between_looks = 4096;
    if (resolved.scatterers.size() % between_looks == 0 && control.stop != nullptr && control.stop->requested())
      throw Interrupted();
    resolved.scatterers.push_back(scatterer_of(target, platforms.find(target.platform), resolved));
  }
  resolved.sheets.resize(scene.surfaces.size());
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    resolved.sheets[i].platform = platforms.find(scene.surfaces[i].platform);
  parallel_ranges(scene.surfaces.size(), 1, control, [&](std::size_t i, std::size_t) {
    SurfaceLattice lattice = fill_triangle(scene.surfaces[i].corner_m, surface_points_per_m2);
    ScattererSheet& sheet = resolved.sheets[i];
    sheet.normal_platform = lattice.normal;
    sheet.point_rcs_m2 = lattice.point_rcs_m2;
    sheet.points_m = std::move(lattice.points_m);
  });
  return resolved;
}

ResolvedRadar resolve_radar(const Scene& scene, const ResolvedScene& resolved, std::size_t radar_index) {
  const Radar& radar = scene.radars.at(radar_index);
  const LowPassRule rule = resolved.conventions.low_pass;
  ResolvedRadar r;
  r.name = radar.name;
  r.platform = PlatformNames(scene).find(radar.platform);
  r.pulse = pulse_of(radar, rule);
  r.repetition = radar.repetition == Radar::Repetition::constant ? Repetition::constant(radar.prf_hz)
                                                                 : Repetition::intervals(ordinates(radar.pri_s));
  r.carrier = carrier_of(radar);
  r.radiated_w = radar.power_w * radar.transmit_gain.factor() * radar.receive_gain.factor() / radar.losses.factor();
  r.noise_temperature_k = radar.noise_temperature_k;
  r.transmit = pattern_of(radar.transmit_antenna, rule);
  r.receive = radar.same_antenna ? r.transmit : pattern_of(radar.receive_antenna, rule);
  r.beam = beam_of(radar, rule);
  r.window = window_of(radar, rule);
  r.stc = radar.stc;
  r.stc_gain = Interpolator(radar.stc_gain.part[0], rule);
  return r;
}

}  // namespace sarsim
