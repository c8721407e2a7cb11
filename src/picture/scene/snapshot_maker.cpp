#include "picture/scene/snapshot_maker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "picture/scene/footprint.hpp"
#include "picture/scene/globe.hpp"
#include "picture/scene/half_power.hpp"
#include "picture/scene/snapshot_beam.hpp"
#include "picture/scene/snapshot_clean.hpp"
#include "picture/scene/snapshot_symbol.hpp"
#include "scene/edit/path_points.hpp"
#include "scene/model/cloud_points.hpp"
#include "scene/model/orbit.hpp"
#include "scene/model/route.hpp"
#include "scene/model/scene_index.hpp"
#include "scene/model/world_frame.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::picture {

namespace {

constexpr int trail_steps = 48;
constexpr int route_steps = 400;
constexpr int illuminated_steps = 64;
constexpr std::size_t max_trail_knots = 256;
constexpr std::size_t max_drawn_cloud_points = 5000;

// When the pulses of a radar leave; nothing where its description makes no sense yet.
std::optional<radar::Repetition> repetition_of(const scene::Radar& radar) {
  const auto sensible = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (radar.repetition == scene::Radar::Repetition::constant)
    return sensible(radar.prf_hz) ? std::optional(radar::Repetition::constant(radar.prf_hz)) : std::nullopt;
  std::vector<double> intervals_s;
  for (const core::Knot& knot : radar.pri_s.part[0].knots) {
    if (!sensible(knot.y)) return std::nullopt;
    intervals_s.push_back(knot.y);
  }
  return intervals_s.empty() ? std::nullopt : std::optional(radar::Repetition::intervals(std::move(intervals_s)));
}

// --- The span of times ----------------------------------------------------------------------------------------------

struct Span {
  double first = std::numeric_limits<double>::infinity();
  double last = -first;

  void add(double time_s) {
    if (!std::isfinite(time_s)) return;
    first = std::min(first, time_s);
    last = std::max(last, time_s);
  }
  void add(const scene::UserFunction<3>& function) {
    for (const core::SampledFunction& part : function.part)
      for (const core::Knot& knot : part.knots) add(knot.x);
  }
};

std::array<double, 2> span_of(const scene::Scene& scene) {
  Span span;
  for (const scene::Platform& platform : scene.platforms) {
    if (platform.path == scene::Platform::Path::trajectory) span.add(platform.trajectory_m);
    if (platform.path == scene::Platform::Path::legs || platform.path == scene::Platform::Path::waypoints) {
      const radar::PathResult route = scene::route_of(platform);
      span.add(route.path.start_s());
      span.add(route.path.start_s() + route.path.duration_s());
    }
    if (platform.rotation_kind == scene::Platform::Rotation::user) span.add(platform.rotation_deg);
  }
  for (const scene::Radar& radar : scene.radars)
    if (radar.beam == scene::Radar::Beam::user) span.add(radar.beam_target_world_m);
  for (const scene::Simulation& simulation : scene.simulations) {
    span.add(simulation.time_start_s);
    span.add(simulation.time_end_s);
  }
  for (const scene::GeometryTable& table : scene.geometries) {
    span.add(table.time_start_s);
    span.add(table.time_end_s);
  }
  if (!(span.first <= span.last)) return {0.0, 1.0};
  return {span.first, span.last > span.first ? span.last : span.first + 1.0};
}

// --- Paths ----------------------------------------------------------------------------------------------------------

// The path of legs or waypoints, in its own frame.
struct Route {
  std::vector<core::Vec3> points_m;
  std::vector<core::Vec3> line_m;
  std::size_t parent = 0;  // whose frame it is; of the world where there is none
};

struct Path {
  std::array<core::Interpolator, 3> position_m;
  std::vector<double> knots_s;  // of all three, ascending: where a path of straight lines bends
  bool moves = false;
  bool orbits = false;
  const radar::Track* track = nullptr;  // of a path that is no function of points

  [[nodiscard]] core::Vec3 at(double time_s) const {
    if (track != nullptr) return track->at(time_s, 0).position_world_m;
    return {position_m[0].value(time_s), position_m[1].value(time_s), position_m[2].value(time_s)};
  }
};

// @param platform  cleaned
Path path_of(const scene::Platform& platform, const radar::Track& track, core::InterpolationRules rule) {
  Path path;
  path.orbits = scene::is_orbit(platform.path);
  const bool of_points = platform.path == scene::Platform::Path::trajectory;
  if (!platform.parent.empty() || (!of_points && platform.path != scene::Platform::Path::stationary)) {
    path.track = &track;
    path.moves = !track.fixed();
    return path;
  }
  if (!of_points) return path;
  for (std::size_t i = 0; i < 3; ++i) {
    const core::SampledFunction& part = platform.trajectory_m.part[i];
    path.position_m[i] = core::Interpolator(part, rule);
    for (const core::Knot& knot : part.knots) {
      path.knots_s.push_back(knot.x);
      if (knot.y != part.knots.front().y) path.moves = true;
    }
  }
  std::ranges::sort(path.knots_s);
  path.knots_s.erase(std::unique(path.knots_s.begin(), path.knots_s.end()), path.knots_s.end());
  return path;
}

Route route_of(const scene::Platform& platform, const scene::World& world, std::size_t parent) {
  Route route{scene::path_points(platform, world), {}, parent};
  if (route.points_m.empty()) return route;
  if (platform.path == scene::Platform::Path::state) {
    route.line_m = route.points_m;
    return route;
  }
  const radar::SegmentPath path = scene::route_of(platform).path;
  for (int i = 0; i <= route_steps; ++i)
    route.line_m.push_back(path.at(path.start_s() + path.duration_s() * i / route_steps).position_world_m);
  if (!std::ranges::all_of(route.line_m, is_finite)) route.line_m.clear();
  return route;
}

// Legs and waypoints that cannot be flown: such a platform stays at the first of them.
void rest_unless_flown(scene::Platform& platform) {
  using enum scene::Platform::Path;
  if ((platform.path != legs && platform.path != waypoints) || scene::route_of(platform).fault.empty()) return;
  const std::vector<core::Vec3> points = scene::path_points(platform, {});
  platform.path = stationary;
  platform.position_m = points.empty() ? core::Vec3{} : finite_or_zero(points.front());
}

std::vector<double> trail_times_of(const Path& path, double time_s, double length_s) {
  std::vector<double> times_s;
  if (!path.moves || !(length_s > 0.0) || !std::isfinite(length_s)) return times_s;
  const double start_s = time_s - 0.5 * length_s;
  const double end_s = time_s + 0.5 * length_s;
  for (int i = 0; i <= trail_steps; ++i) times_s.push_back(start_s + length_s * i / trail_steps);
  const auto first = std::ranges::upper_bound(path.knots_s, start_s);
  const auto last = std::ranges::lower_bound(path.knots_s, end_s);
  if (first < last && static_cast<std::size_t>(last - first) <= max_trail_knots) {
    times_s.insert(times_s.end(), first, last);
    std::ranges::sort(times_s);
  }
  return times_s;
}

void put_trail(const Path& path, double time_s, double length_s, Snapshot::Platform& platform) {
  for (const double at_s : trail_times_of(path, time_s, length_s)) {
    const core::Vec3 point = path.at(at_s);
    if (!is_finite(point)) continue;
    platform.trail_world_m.push_back(point);
    platform.trail_s.push_back(at_s);
  }
}

// Which way a platform goes: now, or where it stands now, over all its time.
core::Vec3 way_of(const Path& path, double time_s, const std::array<double, 2>& span_s) {
  constexpr double step_s = 1e-3;
  if (!path.moves) return {};
  const core::Vec3 now = path.at(time_s + step_s) - path.at(time_s - step_s);
  if (core::norm(now) > 0.0 && is_finite(now)) return now;
  return path.at(span_s[1]) - path.at(span_s[0]);
}

// Positions in the list of resolved platforms; unknown names mean the world, which comes last.
class PlatformFinder {
 public:
  explicit PlatformFinder(const scene::Scene& scene) : world_(scene.platforms.size()), names_(scene) {}

  std::size_t operator()(const std::string& name) {
    const std::size_t found = names_.platform(name);
    return found == scene::not_found ? world_ : found;
  }

 private:
  std::size_t world_;
  scene::SceneIndex names_;
};

// Puts what is to be drawn of an object into a list by ascending indices, in place of what was drawn of it.
template <class Item>
void put_in_place(std::vector<Item>& list, std::size_t index, const std::optional<Item>& item) {
  const auto at = std::ranges::lower_bound(list, index, {}, &Item::index);
  const bool there = at != list.end() && at->index == index;
  if (there && item)
    *at = *item;
  else if (there)
    list.erase(at);
  else if (item)
    list.insert(at, *item);
}

}  // namespace

struct SnapshotMaker::Prepared {
  struct Target {
    std::size_t index;
    std::size_t platform;
    core::Vec3 position_m;
    core::Vec3 normal;
    bool directional;
  };
  struct Surface {
    std::size_t index;
    std::size_t platform;
    std::array<core::Vec3, 3> corner_m;
    core::Vec3 normal;
  };
  struct Radar {
    std::string name;
    std::size_t platform;
    radar::Beam beam;
    BeamShape shape;
    std::array<double, 2> recorded_m{};  // slant ranges of its first recording; 0: none
    std::array<double, 2> recorded_s{};  // and its times
  };
  // Where a platform is at the snapshot's time.
  struct Frame {
    radar::Pose pose;
    bool usable = false;
  };

  explicit Prepared(const scene::Scene& scene);
  void add_platforms(scene::Scene frames);
  void add_targets(const scene::Scene& scene, PlatformFinder& platform_of);
  void add_clouds(const scene::Scene& scene, PlatformFinder& platform_of);
  void add_surfaces(const scene::Scene& scene, PlatformFinder& platform_of);
  void add_radars(const scene::Scene& scene, PlatformFinder& platform_of);
  // Nothing where an object cannot be drawn.
  static std::optional<Target> target_of(const scene::Scene& scene, std::size_t index, PlatformFinder& platform_of);
  static std::optional<Surface> surface_of(const scene::Scene& scene, std::size_t index, PlatformFinder& platform_of);
  void follow(const scene::Scene& scene, const scene::SceneChange& change);

  [[nodiscard]] std::vector<Frame> frames_at(double time_s) const;
  void put_platforms(const std::vector<Frame>& frames, double trail_s, Snapshot& snapshot) const;
  void put_targets(const std::vector<Frame>& frames, Snapshot& snapshot) const;
  void put_clouds(const std::vector<Frame>& frames, Snapshot& snapshot) const;
  void put_surfaces(const std::vector<Frame>& frames, Snapshot& snapshot) const;
  void put_radars(const std::vector<Frame>& frames, bool illuminated, Snapshot& snapshot) const;
  void take_earth(std::optional<radar::EarthFrame> frame);
  [[nodiscard]] std::vector<std::optional<core::Vec3>> footprint_at(const Radar& radar, const radar::Pose& pose,
                                                                    double time_s) const;
  [[nodiscard]] std::vector<std::vector<std::optional<core::Vec3>>> illuminated_until(const Radar& radar,
                                                                                      double time_s) const;

  simulate::ResolvedScene resolved;
  std::vector<Path> paths;
  std::vector<Route> routes;
  std::vector<Target> targets;
  std::vector<Target> cloud_points;  // a few of each cloud, with its number
  std::vector<Surface> surfaces;
  std::vector<Radar> radars;
  std::optional<radar::Repetition> repetition;
  std::optional<radar::EarthFrame> earth;
  std::array<std::shared_ptr<const Mesh>, 2> globe;  // in light and in dark
  std::array<double, 2> span_s{};
};

SnapshotMaker::Prepared::Prepared(const scene::Scene& scene) : span_s(span_of(scene)) {
  add_platforms(frames_of(scene));
  PlatformFinder platform_of(scene);
  add_targets(scene, platform_of);
  add_clouds(scene, platform_of);
  add_surfaces(scene, platform_of);
  add_radars(scene, platform_of);
}

void SnapshotMaker::Prepared::add_platforms(scene::Scene frames) {
  // Before what cannot be flown is put to rest: the points are what mends it.
  routes.clear();
  PlatformFinder platform_of(frames);
  for (scene::Platform& platform : frames.platforms) {
    routes.push_back(route_of(platform, frames.world, platform_of(platform.parent)));
    rest_unless_flown(platform);
  }
  try {
    resolved = simulate::resolve(frames);
  } catch (const std::invalid_argument&) {
    put_to_rest(frames);
    resolved = simulate::resolve(frames);
  }
  paths.clear();
  for (std::size_t i = 0; i < frames.platforms.size(); ++i)
    paths.push_back(
        path_of(frames.platforms[i], resolved.platforms[i].track, simulate::interpolation_rules(resolved.options)));
}

void SnapshotMaker::Prepared::add_targets(const scene::Scene& scene, PlatformFinder& platform_of) {
  targets.reserve(scene.targets.size());
  for (std::size_t i = 0; i < scene.targets.size(); ++i)
    if (const auto target = target_of(scene, i, platform_of)) targets.push_back(*target);
}

std::optional<SnapshotMaker::Prepared::Target> SnapshotMaker::Prepared::target_of(const scene::Scene& scene,
                                                                                  std::size_t index,
                                                                                  PlatformFinder& platform_of) {
  const auto& target = scene.targets[index];
  if (!is_finite(target.position_m)) return std::nullopt;
  core::Vec3 normal;
  if (target.traits->reflectivity == sarsim::scene::Target::Reflectivity::directional)
    normal = core::direction(target.traits->azimuth.rad(), target.traits->elevation.rad());
  const bool directional = normal != core::Vec3{} && is_finite(normal);
  return Target{index, platform_of(*target.platform), target.position_m, directional ? normal : core::Vec3{},
                directional};
}

void SnapshotMaker::Prepared::add_clouds(const scene::Scene& scene, PlatformFinder& platform_of) {
  cloud_points.clear();
  for (std::size_t c = 0; c < scene.clouds.size(); ++c) {
    const std::size_t all = scene::point_count(scene.clouds[c]);
    if (all == 0) continue;
    const radar::PointArrays& points = scene.clouds[c].points->arrays;
    const std::size_t shown = std::min(all, max_drawn_cloud_points);
    for (std::size_t n = 0; n < shown; ++n) {
      const std::size_t i = shown > 1 ? n * (all - 1) / (shown - 1) : 0;
      cloud_points.push_back(
          {c, platform_of(scene.clouds[c].platform), {points.x_m[i], points.y_m[i], points.z_m[i]}, {}, false});
    }
  }
}

void SnapshotMaker::Prepared::add_surfaces(const scene::Scene& scene, PlatformFinder& platform_of) {
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    if (const auto surface = surface_of(scene, i, platform_of)) surfaces.push_back(*surface);
}

std::optional<SnapshotMaker::Prepared::Surface> SnapshotMaker::Prepared::surface_of(const scene::Scene& scene,
                                                                                    std::size_t index,
                                                                                    PlatformFinder& platform_of) {
  const auto& surface = scene.surfaces[index];
  const std::array<core::Vec3, 3>& c = surface.corner_m;
  if (!std::ranges::all_of(c, is_finite)) return std::nullopt;
  const core::Vec3 across = core::cross(c[1] - c[0], c[2] - c[0]);
  const double length = core::norm(across);
  const core::Vec3 normal = length > 0.0 && std::isfinite(length) ? (1.0 / length) * across : core::Vec3{};
  return Surface{index, platform_of(surface.platform), c, normal};
}

void SnapshotMaker::Prepared::add_radars(const scene::Scene& scene, PlatformFinder& platform_of) {
  scene::Scene drawn;  // The radars alone, as far as they are drawn.
  for (const auto& radar : scene.radars) drawn.radars.push_back(cleaned(radar));
  radars.clear();
  for (std::size_t i = 0; i < scene.radars.size(); ++i) {
    simulate::Link r = simulate::resolve_radar(drawn, resolved, i);
    radars.push_back({scene.radars[i].name, platform_of(scene.radars[i].platform), std::move(r.beam),
                      beam_shape(r.transmit, resolved.conventions.pattern)});
    const auto recording = std::ranges::find(scene.simulations, scene.radars[i].name, &scene::Simulation::radar);
    if (recording != scene.simulations.end())
      radars.back().recorded_m = {recording->range_start_m, recording->range_end_m};
    radars.back().recorded_s =
        recording != scene.simulations.end() ? std::array{recording->time_start_s, recording->time_end_s} : span_s;
  }
  take_earth(scene::earth_of(scene.world));
  repetition = scene.radars.empty() ? std::nullopt : repetition_of(scene.radars.front());
}

// The globe is made anew where it is seen from another anchor alone.
void SnapshotMaker::Prepared::take_earth(std::optional<radar::EarthFrame> frame) {
  const bool same = earth && frame && earth->anchor() == frame->anchor();
  earth = std::move(frame);
  if (same) return;
  for (const bool dark : {false, true})
    globe.at(dark ? 1 : 0) = earth ? std::make_shared<const Mesh>(globe_mesh(*earth, dark)) : nullptr;
}

// The scene has the same objects, which mean the same platforms by name or say so themselves.
void SnapshotMaker::Prepared::follow(const scene::Scene& scene, const scene::SceneChange& change) {
  PlatformFinder platform_of(scene);
  for (const scene::ChangedObject& object : change.changed) {
    const std::size_t index = object.id.index;
    if (object.id.kind == scene::ObjectKind::target)
      put_in_place(targets, index, target_of(scene, index, platform_of));
    else if (object.id.kind == scene::ObjectKind::surface)
      put_in_place(surfaces, index, surface_of(scene, index, platform_of));
  }
  if (change.concerns(scene::ObjectKind::cloud)) add_clouds(scene, platform_of);
  if (change.concerns(scene::ObjectKind::platform)) add_platforms(frames_of(scene));
  if (change.concerns(scene::ObjectKind::radar) || change.concerns(scene::ObjectKind::simulation))
    add_radars(scene, platform_of);
  span_s = span_of(scene);
}

std::vector<SnapshotMaker::Prepared::Frame> SnapshotMaker::Prepared::frames_at(double time_s) const {
  const std::int64_t pulse = repetition ? repetition->pulses_in(time_s, time_s).last : 0;
  std::vector<Frame> frames;
  for (const simulate::ResolvedPlatform& platform : resolved.platforms) {
    Frame frame{platform.track.at(time_s, pulse), false};
    frame.usable =
        is_finite(frame.pose.position_world_m) && std::ranges::all_of(frame.pose.world_from_platform.row, is_finite);
    frames.push_back(frame);
  }
  return frames;
}

void SnapshotMaker::Prepared::put_platforms(const std::vector<Frame>& frames, double trail_s,
                                            Snapshot& snapshot) const {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (!frames[i].usable) continue;
    const Route& route = routes[i];
    const auto in_world = [&](const std::vector<core::Vec3>& points_m) {
      if (!frames[route.parent].usable) return std::vector<core::Vec3>();
      std::vector<core::Vec3> points_world_m;
      for (const core::Vec3& point : points_m)
        points_world_m.push_back(radar::world_position_m(frames[route.parent].pose, point));
      return points_world_m;
    };
    Snapshot::Platform shown;
    shown.id = {scene::ObjectKind::platform, i};
    shown.name = resolved.platforms[i].name;
    shown.pose = frames[i].pose;
    put_trail(paths[i], snapshot.time_s, trail_s, shown);
    shown.foot_world_m = ground_below(shown.pose.position_world_m, earth);
    shown.symbol = symbol_of(shown.pose, way_of(paths[i], snapshot.time_s, span_s), paths[i].orbits, earth);
    shown.path_points_world_m = in_world(route.points_m);
    shown.path_world_m = in_world(route.line_m);
    snapshot.platforms.push_back(std::move(shown));
  }
}

void SnapshotMaker::Prepared::put_targets(const std::vector<Frame>& frames, Snapshot& snapshot) const {
  snapshot.targets.reserve(targets.size());
  for (const Target& target : targets) {
    const Frame& frame = frames[target.platform];
    if (!frame.usable) continue;
    const core::Vec3& p = target.position_m;
    Snapshot::Target shown;
    shown.id = {scene::ObjectKind::target, target.index};
    shown.position_world_m = radar::world_position_m(frame.pose, p);
    shown.foot_world_m = radar::world_position_m(frame.pose, {p.x, p.y, 0.0});
    shown.directional = target.directional;
    if (target.directional) shown.normal_world = frame.pose.world_from_platform * target.normal;
    snapshot.targets.push_back(shown);
  }
}

void SnapshotMaker::Prepared::put_clouds(const std::vector<Frame>& frames, Snapshot& snapshot) const {
  for (const Target& point : cloud_points) {
    const Frame& frame = frames[point.platform];
    if (!frame.usable) continue;
    Snapshot::Target shown;
    shown.id = {scene::ObjectKind::cloud, point.index};
    shown.position_world_m = radar::world_position_m(frame.pose, point.position_m);
    shown.foot_world_m = shown.position_world_m;  // Thousands of lines to the ground would hide the points.
    snapshot.cloud_points.push_back(shown);
  }
}

void SnapshotMaker::Prepared::put_surfaces(const std::vector<Frame>& frames, Snapshot& snapshot) const {
  for (const Surface& surface : surfaces) {
    const Frame& frame = frames[surface.platform];
    if (!frame.usable) continue;
    Snapshot::Surface shown;
    shown.id = {scene::ObjectKind::surface, surface.index};
    for (std::size_t i = 0; i < 3; ++i)
      shown.corner_world_m[i] = radar::world_position_m(frame.pose, surface.corner_m[i]);
    shown.normal_world = frame.pose.world_from_platform * surface.normal;
    snapshot.surfaces.push_back(shown);
  }
}

std::vector<std::optional<core::Vec3>> SnapshotMaker::Prepared::footprint_at(const Radar& radar,
                                                                             const radar::Pose& pose,
                                                                             double time_s) const {
  const radar::PointingRule rule = resolved.conventions.pointing;
  const radar::Pointing pointing(radar.beam, rule, time_s, pose.position_world_m, pose.world_from_platform,
                                 pose.rotation_rad);
  std::vector<std::optional<core::Vec3>> edges;
  for (const std::optional<radar::BeamOffset>& offset : radar.shape.outline)
    edges.push_back(offset ? std::optional(beam_direction(pointing, rule, *offset)) : std::nullopt);
  return ground_points(pose.position_world_m, edges, earth);
}

std::vector<std::vector<std::optional<core::Vec3>>> SnapshotMaker::Prepared::illuminated_until(const Radar& radar,
                                                                                               double time_s) const {
  std::vector<std::vector<std::optional<core::Vec3>>> footprints;
  const double first_s = radar.recorded_s[0];
  const double last_s = std::min(time_s, radar.recorded_s[1]);
  if (radar.shape.outline.empty() || !(last_s >= first_s)) return footprints;
  const radar::Track& track = resolved.platforms[radar.platform].track;
  for (int i = 0; i <= illuminated_steps; ++i) {
    const double at_s = first_s + (last_s - first_s) * i / illuminated_steps;
    const radar::Pose pose = track.at(at_s, 0);
    if (is_finite(pose.position_world_m)) footprints.push_back(footprint_at(radar, pose, at_s));
  }
  return footprints;
}

void SnapshotMaker::Prepared::put_radars(const std::vector<Frame>& frames, bool illuminated, Snapshot& snapshot) const {
  for (std::size_t i = 0; i < radars.size(); ++i) {
    const Radar& radar = radars[i];
    if (!frames[radar.platform].usable) continue;
    const radar::Pose& pose = frames[radar.platform].pose;
    const radar::Pointing pointing(radar.beam, resolved.conventions.pointing, snapshot.time_s, pose.position_world_m,
                                   pose.world_from_platform, pose.rotation_rad);
    Snapshot::Radar shown;
    shown.id = {scene::ObjectKind::radar, i};
    shown.name = radar.name;
    shown.position_world_m = pose.position_world_m;
    shown.axis_world = pointing.axis_world();
    if (!is_finite(shown.axis_world)) continue;
    // Offsets of the rule of added angles are angles of the world: its antenna is level.
    const double azimuth = core::azimuth_rad(shown.axis_world);
    shown.across_world = resolved.conventions.pointing == radar::PointingRule::boresight
                             ? pointing.antenna_from_world().row[0]
                             : core::Vec3{std::cos(azimuth), -std::sin(azimuth), 0.0};
    shown.azimuth_width_rad = radar.shape.azimuth_width_rad;
    shown.elevation_width_rad = radar.shape.elevation_width_rad;
    shown.beam_middle = radar.shape.middle;
    shown.isotropic = radar.shape.isotropic;
    const core::Mat3 antenna_from_world{
        {shown.across_world, shown.axis_world, core::cross(shown.across_world, shown.axis_world)}};
    const core::Mat3 world_from_antenna = core::transposed(antenna_from_world);
    shown.lobe_world = radar.shape.lobe_antenna;
    for (std::vector<core::Vec3>& row : shown.lobe_world)
      for (core::Vec3& point : row) point = world_from_antenna * point;
    shown.footprint_world_m = footprint_at(radar, pose, snapshot.time_s);
    for (std::size_t end = 0; end < 2; ++end)
      shown.swath_world_m.at(end) = range_on_ground(shown, radar.recorded_m.at(end), earth);
    if (illuminated) shown.illuminated_world_m = illuminated_until(radar, snapshot.time_s);
    snapshot.radars.push_back(std::move(shown));
  }
}

SnapshotMaker::SnapshotMaker(const scene::Scene& scene) : prepared_(std::make_unique<Prepared>(scene)) {}
void SnapshotMaker::follow(const scene::Scene& scene, const scene::SceneChange& change) {
  const bool renamed = std::ranges::any_of(change.changed, &scene::ChangedObject::name);
  if (change.same_objects() && !change.options && !renamed)
    prepared_->follow(scene, change);
  else
    prepared_ = std::make_unique<Prepared>(scene);
}

SnapshotMaker::~SnapshotMaker() = default;
SnapshotMaker::SnapshotMaker(SnapshotMaker&&) noexcept = default;
SnapshotMaker& SnapshotMaker::operator=(SnapshotMaker&&) noexcept = default;

Snapshot SnapshotMaker::at(double time_s, double trail_s, bool illuminated) const {
  Snapshot snapshot;
  snapshot.earth = prepared_->earth;
  snapshot.globe = prepared_->globe;
  snapshot.time_s = std::clamp(finite_or_zero(time_s), -longest_time_s, longest_time_s);
  const std::vector<Prepared::Frame> frames = prepared_->frames_at(snapshot.time_s);
  prepared_->put_platforms(frames, trail_s, snapshot);
  prepared_->put_targets(frames, snapshot);
  prepared_->put_clouds(frames, snapshot);
  prepared_->put_surfaces(frames, snapshot);
  prepared_->put_radars(frames, illuminated, snapshot);
  return snapshot;
}

std::array<double, 2> SnapshotMaker::time_span_s() const { return prepared_->span_s; }

}  // namespace sarsim::picture
