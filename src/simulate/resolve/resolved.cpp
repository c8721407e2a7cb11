#include "simulate/resolve/resolved.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "core/report/expect.hpp"
#include "core/text/number_text.hpp"
#include "radar/target/surface.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/radar_pulse.hpp"
#include "scene/model/read_path.hpp"
#include "scene/model/scene_index.hpp"
#include "signal/sar/sar_window.hpp"
#include "simulate/resolve/platform_motion.hpp"

namespace sarsim::simulate {

namespace {

using scene::FunctionRole;

std::array<core::Interpolator, 3> three(const scene::UserFunction<3>& function, core::InterpolationRules rule,
                                        double scale = 1.0) {
  return {core::Interpolator(function.part[0], rule, scale), core::Interpolator(function.part[1], rule, scale),
          core::Interpolator(function.part[2], rule, scale)};
}

// What a target and a cloud have alike: all but platform, position and cross-section.
Scatterer scatterer_of(const scene::TargetTraits& traits, ResolvedScene& resolved) {
  using Traits = scene::TargetTraits;
  Scatterer s;
  s.position_stddev_m = traits.position_stddev_m;
  s.rcs_stddev_m2 = traits.rcs_stddev_m2;
  if (traits.reflectivity == Traits::Reflectivity::directional) {
    s.law = traits.gain == Traits::Gain::cosine ? radar::ReflectivityLaw::cosine : radar::ReflectivityLaw::user;
    s.azimuth_rad = traits.azimuth.rad();
    s.elevation_rad = traits.elevation.rad();
    s.azimuth_stddev_rad = traits.azimuth_stddev.rad();
    s.elevation_stddev_rad = traits.elevation_stddev.rad();
    if (s.law == radar::ReflectivityLaw::user) {
      s.gain_curve = static_cast<std::uint32_t>(resolved.gain_curves.size());
      resolved.gain_curves.emplace_back(traits.gain_db.part[0],
                                        interpolation_rules(resolved.options, FunctionRole::reflectivity));
    }
  }
  s.jittered = s.position_stddev_m != core::Vec3{} || s.rcs_stddev_m2 != 0.0 || s.azimuth_stddev_rad != 0.0 ||
               s.elevation_stddev_rad != 0.0;
  return s;
}

// The arrays of a cloud; a copy where the cross-section that all points share has changed since they were read.
std::shared_ptr<const radar::PointArrays> arrays_of(const scene::Cloud& cloud) {
  const std::shared_ptr<const scene::CloudPoints>& read = cloud.points;
  if (read->own_rcs || read->rcs_m2 == cloud.rcs_m2) return {read, &read->arrays};
  auto changed = std::make_shared<radar::PointArrays>(read->arrays);
  std::ranges::fill(changed->root_rcs_m, std::sqrt(std::max(0.0, cloud.rcs_m2)));
  return changed;
}

std::vector<double> ordinates(const scene::UserFunction<1>& function) {
  std::vector<double> values;
  for (const core::Knot& knot : function.part[0].knots) values.push_back(knot.y);
  return values;
}

radar::CarrierPlan carrier_of(const scene::Radar& radar) {
  switch (radar.carrier) {
    case scene::Radar::Carrier::single: break;
    case scene::Radar::Carrier::stepped:
      return radar::CarrierPlan::stepped(radar.carrier_hz, radar.carrier_step_hz, radar.carrier_steps,
                                         radar.pulses_per_step);
    case scene::Radar::Carrier::user: return radar::CarrierPlan::list(ordinates(radar.carrier_list_hz));
  }
  return radar::CarrierPlan::single(radar.carrier_hz);
}

core::AngleFunction cut_of(const core::SampledFunction& cut, FunctionRole role, const ResolvedScene& resolved) {
  return scene::angle_function(role, cut, interpolation_rules(resolved.options),
                               resolved.conventions.function_ends == Conventions::FunctionEnds::by_role);
}

radar::AntennaPattern pattern_of(const scene::Antenna& antenna, const ResolvedScene& resolved) {
  radar::AntennaPattern pattern;
  switch (antenna.pattern) {
    case scene::Antenna::Pattern::isotropic: break;
    case scene::Antenna::Pattern::sinx:
      pattern.kind = radar::AntennaPattern::Kind::sinx;
      pattern.azimuth_beamwidth_rad = antenna.azimuth_beamwidth.rad();
      pattern.elevation_beamwidth_rad = antenna.elevation_beamwidth.rad();
      break;
    case scene::Antenna::Pattern::user:
      pattern.kind = radar::AntennaPattern::Kind::user;
      pattern.azimuth_gain_db = cut_of(antenna.gain_db.part[0], FunctionRole::azimuth_cut, resolved);
      pattern.elevation_gain_db = cut_of(antenna.gain_db.part[1], FunctionRole::elevation_cut, resolved);
      break;
  }
  return pattern;
}

radar::Beam beam_of(const scene::Radar& radar, core::InterpolationRules rule) {
  radar::Beam beam;
  beam.azimuth_rad = radar.beam_azimuth.rad();
  beam.elevation_rad = radar.beam_elevation.rad();
  beam.rate_rad_per_s = radar.beam_rate.rad();
  beam.spot_world_m = radar.spot_world_m;
  switch (radar.beam) {
    case scene::Radar::Beam::fixed: beam.kind = radar::Beam::Kind::fixed; break;
    case scene::Radar::Beam::rotating: beam.kind = radar::Beam::Kind::rotating; break;
    case scene::Radar::Beam::spot: beam.kind = radar::Beam::Kind::spot; break;
    case scene::Radar::Beam::user:
      beam.kind = radar::Beam::Kind::user;
      beam.target_world_m = three(radar.beam_target_world_m, rule);
      break;
  }
  return beam;
}

signal::WindowFunction window_of(const scene::Radar& radar, core::InterpolationRules rule) {
  switch (radar.window) {
    case scene::Radar::Window::rectangular: break;
    case scene::Radar::Window::hanning:
      return [pedestal = radar.hanning_pedestal](double x) { return core::hanning_window(x, pedestal); };
    case scene::Radar::Window::bartlett: return core::bartlett_window;
    case scene::Radar::Window::hamming: return core::hamming_window;
    case scene::Radar::Window::blackman: return core::blackman_window;
    case scene::Radar::Window::kaiser:
      return [beta = radar.kaiser_beta](double x) { return core::kaiser_window(2.0 * x - 1.0, beta); };
    case scene::Radar::Window::taylor:
      return [weight = signal::weight_of({.kind = signal::SarWindow::Kind::taylor,
                                          .sidelobes_db = radar.taylor_sidelobes_db,
                                          .equal_sidelobes = radar.taylor_equal_sidelobes})](double x) {
        return weight(x - 0.5);
      };
    case scene::Radar::Window::user:
      return [f = core::Interpolator(radar.window_gain.part[0], rule)](double x) { return f.value(x); };
  }
  return [](double) { return 1.0; };
}

// Positions in ResolvedScene::platforms, of which the last is the world itself.
std::uint32_t platform_number(std::size_t found, const scene::Scene& scene, const std::string& name) {
  if (found != scene::not_found) return static_cast<std::uint32_t>(found);
  if (core::equal_ignoring_case(name, "Earth")) return static_cast<std::uint32_t>(scene.platforms.size());
  throw std::invalid_argument("platform '" + name + "' is not defined");
}

// Boxes around what each platform carries.
class Boxes {
 public:
  explicit Boxes(std::size_t platforms) : min_(platforms, {far, far, far}), max_(platforms, {-far, -far, -far}) {}

  void include(std::uint32_t platform, const core::Vec3& p) {
    core::Vec3& least = min_[platform];
    core::Vec3& most = max_[platform];
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }

  // Middle and radius of the balls around the boxes.
  void find_balls(std::vector<ResolvedPlatform>& platforms) const {
    for (std::size_t i = 0; i < platforms.size(); ++i) {
      if (!(min_[i].x <= max_[i].x)) continue;
      platforms[i].middle_m = 0.5 * (min_[i] + max_[i]);
      platforms[i].radius_m = 0.5 * core::norm(max_[i] - min_[i]);
    }
  }

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  std::vector<core::Vec3> min_;
  std::vector<core::Vec3> max_;
};

void find_balls(ResolvedScene& resolved) {
  Boxes boxes(resolved.platforms.size());
  for (std::size_t i = 0; i < resolved.scatterers.targets(); ++i) {
    const Scatterer s = resolved.scatterers[i];
    boxes.include(s.platform, s.position_m);
  }
  for (const ScattererCloud& cloud : resolved.scatterers.clouds())
    for (const core::Vec3& corner_m : {cloud.min_m, cloud.max_m}) boxes.include(cloud.common.platform, corner_m);
  for (const ScattererSheet& sheet : resolved.sheets)
    for (const core::Vec3& point_m : sheet.points_m) boxes.include(sheet.platform, point_m);
  boxes.find_balls(resolved.platforms);
}

void add_targets(const scene::Scene& scene, scene::SceneIndex& names, ResolvedScene& resolved,
                 const core::WorkControl& control) {
  resolved.scatterers.reserve(scene.targets.size(), control);
  const scene::TargetTraits* traits = nullptr;  // of the target before
  Scatterer s;
  for (const scene::Target& target : scene.targets) {
    constexpr std::size_t between_looks = 4096;
    if (resolved.scatterers.size() % between_looks == 0 && control.stop != nullptr && control.stop->requested())
      throw core::Interrupted();
    if (&*target.traits != traits) s = scatterer_of(*target.traits, resolved);
    traits = &*target.traits;
    s.platform = platform_number(names.platform(*target.platform), scene, *target.platform);
    s.position_m = target.position_m;
    s.rcs_m2 = target.rcs_m2;
    resolved.scatterers.push_back(s);
  }
  for (const scene::Cloud& cloud : scene.clouds) {
    if (!cloud.points || cloud.points->file != cloud.file)
      throw std::invalid_argument("the points of cloud '" + cloud.file + "' are not read");
    Scatterer common = scatterer_of(cloud.traits, resolved);
    common.platform = platform_number(names.platform(cloud.platform), scene, cloud.platform);
    resolved.scatterers.add_cloud({common, arrays_of(cloud), cloud.points->min_m, cloud.points->max_m});
  }
}

void include(radar::HeightSpan& span, double height_m) {
  span.low_m = std::min(span.low_m, height_m);
  span.high_m = std::max(span.high_m, height_m);
}

// The air between a radar and what it sees, with tables for the heights at which they are during the recordings.
std::shared_ptr<const AirPaths> air_of(const scene::Scene& scene, const ResolvedScene& resolved, const Link& radar) {
  if (!is_on(scene.atmosphere)) return nullptr;
  constexpr double looks = 16.0;
  constexpr double margin_m = 50.0;
  const double carrier_hz = 0.5 * (radar.carrier.lowest_hz() + radar.carrier.highest_hz());
  const auto made = [&](radar::HeightSpan scatterers, radar::HeightSpan radars) {
    return std::make_shared<const AirPaths>(scene.atmosphere, carrier_hz, resolved.conventions.light_speed_mps,
                                            resolved.turning, scatterers, radars);
  };
  const AirPaths heights(scene::Atmosphere{}, carrier_hz, resolved.conventions.light_speed_mps, resolved.turning, {},
                         {});
  constexpr double far = std::numeric_limits<double>::infinity();
  radar::HeightSpan scatterers{far, -far}, radars{far, -far};
  const radar::TimeSpan times = scene::needed_times(scene);
  for (double look = 0.0; look <= looks; look += 1.0) {
    const double time_s = times.first_s + look / looks * (times.last_s - times.first_s);
    include(radars, heights.height_m(resolved.platforms[radar.platform].track.at(time_s, 0).position_world_m));
    for (const ResolvedPlatform& platform : resolved.platforms) {
      const double middle_m =
          heights.height_m(radar::world_position_m(platform.track.at(time_s, 0), platform.middle_m));
      include(scatterers, middle_m - platform.radius_m);
      include(scatterers, middle_m + platform.radius_m);
    }
  }
  const auto wider = [&](const radar::HeightSpan& span) {
    constexpr double widest_m = 20e3;  // Tables of more take seconds; outside of them paths are computed one by one.
    return radar::HeightSpan{span.low_m - margin_m, std::min(span.high_m, span.low_m + widest_m) + margin_m};
  };
  return made(wider(scatterers), wider(radars));
}

}  // namespace

ResolvedScene resolve(const scene::Scene& scene, const core::WorkControl& control) {
  ResolvedScene resolved;
  resolved.conventions = conventions_of(scene.options.profile);
  resolved.options = scene.options;
  const core::InterpolationRules rule = interpolation_rules(scene.options);
  resolved.turning = turning_of(scene.world);
  std::vector<radar::Track> tracks = tracks_of(scene, rule);
  for (std::size_t i = 0; i < tracks.size(); ++i)
    resolved.platforms.push_back({scene.platforms[i].name, std::move(tracks[i]), {}, 0.0});
  // The world itself, last, for scripts that use "Earth" without defining it.
  resolved.platforms.push_back({"Earth", radar::Track({}, scene.options.seed, "Earth"), {}, 0.0});

  scene::SceneIndex names(scene);
  add_targets(scene, names, resolved, control);
  resolved.sheets.resize(scene.surfaces.size());
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    resolved.sheets[i].platform =
        platform_number(names.platform(scene.surfaces[i].platform), scene, scene.surfaces[i].platform);
  core::parallel_ranges(scene.surfaces.size(), 1, control, [&](std::size_t i, std::size_t) {
    radar::SurfaceLattice lattice = radar::fill_triangle(scene.surfaces[i].corner_m, surface_points_per_m2);
    ScattererSheet& sheet = resolved.sheets[i];
    sheet.normal_platform = lattice.normal;
    sheet.point_rcs_m2 = lattice.point_rcs_m2;
    sheet.points_m = std::move(lattice.points_m);
  });
  find_balls(resolved);
  return resolved;
}

std::vector<std::uint32_t> reflecting_platforms(const ResolvedScene& scene) {
  std::vector<std::uint32_t> platforms = scene.scatterers.platforms();
  for (const ScattererSheet& sheet : scene.sheets) platforms.push_back(sheet.platform);
  std::ranges::sort(platforms);
  platforms.erase(std::ranges::unique(platforms).begin(), platforms.end());
  return platforms;
}

std::shared_ptr<const ResolvedScene> thinned(std::shared_ptr<const ResolvedScene> scene, std::size_t max_points) {
  CORE_EXPECT(scene != nullptr);
  if (std::ranges::none_of(scene->scatterers.clouds(),
                           [&](const ScattererCloud& cloud) { return cloud.points->size() > max_points; }))
    return scene;
  auto some = std::make_shared<ResolvedScene>();
  some->conventions = scene->conventions;
  some->options = scene->options;
  some->turning = scene->turning;
  some->platforms = scene->platforms;
  some->scatterers = scene->scatterers.thinned(max_points);
  some->sheets = scene->sheets;
  some->gain_curves = scene->gain_curves;
  return some;
}

Link resolve_radar(const scene::Scene& scene, const ResolvedScene& resolved, std::size_t radar_index) {
  CORE_EXPECT(radar_index < scene.radars.size());
  const scene::Radar& radar = scene.radars.at(radar_index);
  const auto rules = [&](FunctionRole role) { return interpolation_rules(resolved.options, role); };
  Link r;
  r.name = radar.name;
  // A table of all names, for this one, would be made for each radar of a scene that has thousands.
  r.platform = platform_number(scene::find_platform(scene, radar.platform), scene, radar.platform);
  r.pulse = scene::pulse_of(radar, rules(FunctionRole::pulse));
  r.repetition = radar.repetition == scene::Radar::Repetition::constant
                     ? radar::Repetition::constant(radar.prf_hz)
                     : radar::Repetition::intervals(ordinates(radar.pri_s));
  r.carrier = carrier_of(radar);
  r.radiated_w = radar.power_w * radar.transmit_gain.factor() * radar.receive_gain.factor() / radar.losses.factor();
  r.noise_temperature_k = radar.noise_temperature_k;
  r.transmit = pattern_of(radar.transmit_antenna, resolved);
  r.receive = radar.same_antenna ? r.transmit : pattern_of(radar.receive_antenna, resolved);
  r.beam = beam_of(radar, rules(FunctionRole::beam_target));
  r.window = window_of(radar, rules(FunctionRole::window));
  r.stc = radar.stc;
  r.stc_gain = core::Interpolator(radar.stc_gain.part[0], rules(FunctionRole::stc));
  r.air = air_of(scene, resolved, r);
  return r;
}

}  // namespace sarsim::simulate
