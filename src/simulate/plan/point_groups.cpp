#include "simulate/plan/point_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/maths/random.hpp"
#include "core/report/expect.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::simulate {

namespace {

static_assert(radar::doubtful_amplitude < strongest_echo_v);

// What the points of a group have in common.
struct GroupKey {
  std::uint32_t platform = 0;
  radar::PointArrays::Law law = radar::PointArrays::Law::isotropic;
  bool level = false;  // random deviations in x or y
  bool height = false;
  bool rcs = false;
  bool pointing = false;

  [[nodiscard]] auto fields() const { return std::tie(platform, law, level, height, rcs, pointing); }
  friend bool operator<(const GroupKey& a, const GroupKey& b) { return a.fields() < b.fields(); }
};

radar::PointArrays::Law law_of(radar::ReflectivityLaw law) {
  switch (law) {
    case radar::ReflectivityLaw::isotropic: break;
    case radar::ReflectivityLaw::cosine: return radar::PointArrays::Law::cosine;
    case radar::ReflectivityLaw::user: return radar::PointArrays::Law::curve;
  }
  return radar::PointArrays::Law::isotropic;
}

GroupKey key_of(const Scatterer& s) {
  GroupKey key{s.platform, law_of(s.law), false, false, false, false};
  key.level = s.position_stddev_m.x != 0.0 || s.position_stddev_m.y != 0.0;
  key.height = s.position_stddev_m.z != 0.0;
  key.rcs = s.rcs_stddev_m2 != 0.0;
  key.pointing =
      s.law != radar::ReflectivityLaw::isotropic && (s.azimuth_stddev_rad != 0.0 || s.elevation_stddev_rad != 0.0);
  return key;
}

void add_point(radar::PointArrays& points, const core::Vec3& at, double rcs_m2, const core::Vec3& normal) {
  points.x_m.push_back(at.x);
  points.y_m.push_back(at.y);
  points.z_m.push_back(at.z);
  points.root_rcs_m.push_back(std::sqrt(std::max(0.0, rcs_m2)));
  if (points.law == radar::PointArrays::Law::isotropic) return;
  points.normal_x.push_back(normal.x);
  points.normal_y.push_back(normal.y);
  points.normal_z.push_back(normal.z);
}

// The deviations of target number `index` that its group has at all.
void add_jitter(radar::PointJitter& jitter, const Scatterer& s, const GroupKey& key, std::uint64_t seed,
                std::size_t index) {
  const auto stream = [&](core::RandomKind kind) { return core::RandomStream(seed, kind, index).key(); };
  if (key.level) {
    jitter.x_stddev_m.push_back(s.position_stddev_m.x);
    jitter.y_stddev_m.push_back(s.position_stddev_m.y);
  }
  if (key.height) jitter.z_stddev_m.push_back(s.position_stddev_m.z);
  if (key.level || key.height) jitter.position_key.push_back(stream(core::RandomKind::target_position));
  if (key.rcs) {
    jitter.rcs_m2.push_back(s.rcs_m2);
    jitter.rcs_stddev_m2.push_back(s.rcs_stddev_m2);
    jitter.rcs_key.push_back(stream(core::RandomKind::target_rcs));
  }
  if (key.pointing) {
    jitter.azimuth_rad.push_back(s.azimuth_rad);
    jitter.elevation_rad.push_back(s.elevation_rad);
    jitter.azimuth_stddev_rad.push_back(s.azimuth_stddev_rad);
    jitter.elevation_stddev_rad.push_back(s.elevation_stddev_rad);
    jitter.pointing_key.push_back(stream(core::RandomKind::target_pointing));
  }
}

// A gain of x dB is 10^(x/20) on the amplitude: 0.2 dB times the tolerance is 0.023 times it; there are five curves, a
// target's and two of each antenna.
double curve_error_db(const ResolvedScene& scene) { return 0.2 * scene.options.tolerance; }

double first_cell(const radar::CurveTables& tables, std::size_t curve) {
  return static_cast<double>(tables.number[curve]) * static_cast<double>(tables.cells);
}

radar::CurveTables reflectivity_tables(const ResolvedScene& scene) {
  std::vector<const core::Interpolator*> curves;
  curves.reserve(scene.gain_curves.size());
  for (const core::Interpolator& curve : scene.gain_curves) curves.push_back(&curve);
  return radar::tabulate(curves, curve_error_db(scene));
}

radar::AntennaView antenna_view(const ResolvedScene& scene, const Link& radar) {
  radar::AntennaView antenna;
  if (scene.conventions.pointing == radar::PointingRule::added_angles)
    antenna.offsets = radar::AntennaView::Offsets::world_angles;
  antenna.roots = scene.conventions.pattern == radar::PatternRule::power;
  std::vector<const core::AngleFunction*> curves;
  std::vector<std::size_t> cuts;
  std::size_t first = 0;
  for (const radar::AntennaPattern* pattern : {&radar.transmit, &radar.receive}) {
    if (pattern->kind == radar::AntennaPattern::Kind::sinx) {
      antenna.cut[first] = 0.44 / pattern->azimuth_beamwidth_rad;
      antenna.cut[first + 1] = 0.44 / pattern->elevation_beamwidth_rad;
    } else if (pattern->kind == radar::AntennaPattern::Kind::user) {
      curves.insert(curves.end(), {&pattern->azimuth_gain_db, &pattern->elevation_gain_db});
      cuts.insert(cuts.end(), {first, first + 1});
    }
    first += 2;
  }
  antenna.curves = radar::tabulate(curves, curve_error_db(scene));
  for (std::size_t i = 0; i < cuts.size(); ++i) antenna.curve_cell[cuts[i]] = first_cell(antenna.curves, i);
  return antenna;
}

// Finds the group of a key, or begins it.
class Grouping {
 public:
  explicit Grouping(PointGroups& groups) : groups_(groups) {}

  radar::PointArrays& of(const GroupKey& key) {
    const auto [place, is_new] = places_.try_emplace(key, nullptr);
    if (is_new) {
      auto points = std::make_shared<radar::PointArrays>();
      points->law = key.law;
      place->second = points.get();
      groups_.groups.push_back({key.platform, std::move(points)});
    }
    return *place->second;
  }

 private:
  PointGroups& groups_;
  std::map<GroupKey, radar::PointArrays*> places_;
};

// Room for the points of a scene that has one kind of targets, as large ones do.
void make_room(radar::PointArrays& points, std::size_t count) {
  for (std::vector<double>* column : {&points.x_m, &points.y_m, &points.z_m, &points.root_rcs_m})
    column->reserve(count);
}

// Adds scatterers [begin, end) of the scene.
void add_scatterers(const ResolvedScene& scene, std::size_t begin, std::size_t end, PointGroups& groups,
                    Grouping& grouping, const core::StopFlag* stop) {
  for (std::size_t i = begin; i < end; ++i) {
    constexpr std::size_t between_looks = 4096;
    if (i % between_looks == 0 && stop != nullptr && stop->requested()) throw core::Interrupted();
    const Scatterer s = scene.scatterers[i];
    const GroupKey key = key_of(s);
    radar::PointArrays& points = grouping.of(key);
    if (i == 0) make_room(points, end);
    add_point(points, s.position_m, s.rcs_m2, core::direction(s.azimuth_rad, s.elevation_rad));
    if (s.law == radar::ReflectivityLaw::user)
      points.curve_cell.push_back(first_cell(groups.reflectivity, s.gain_curve));
    add_jitter(points.jitter, s, key, scene.options.seed, i);
  }
}

}  // namespace

PointGroups group_points(const ResolvedScene& scene, const Link& radar, const core::StopFlag* stop) {
  CORE_EXPECT(radar.platform < scene.platforms.size());
  CORE_EXPECT(std::ranges::all_of(scene.scatterers.platforms(),
                                  [&](std::uint32_t platform) { return platform < scene.platforms.size(); }));
  PointGroups groups;
  groups.antenna = antenna_view(scene, radar);
  groups.reflectivity = reflectivity_tables(scene);
  Grouping grouping(groups);
  const ScattererList& scatterers = scene.scatterers;
  add_scatterers(scene, 0, scatterers.targets(), groups, grouping, stop);
  for (const ScattererCloud& cloud : scatterers.clouds()) {
    if (cloud.common.law == radar::ReflectivityLaw::isotropic && !cloud.common.jittered)
      groups.groups.push_back({cloud.common.platform, cloud.points});
    else
      add_scatterers(scene, cloud.first, cloud.first + cloud.points->size(), groups, grouping, stop);
  }
  for (const ScattererSheet& sheet : scene.sheets) {
    if (sheet.points_m.empty()) continue;
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    radar::PointArrays& points =
        grouping.of({sheet.platform, radar::PointArrays::Law::cosine, false, false, false, false});
    for (const core::Vec3& point_m : sheet.points_m)
      add_point(points, point_m, sheet.point_rcs_m2, sheet.normal_platform);
  }
  for (PointGroups::Group& group : groups.groups) {
    group.first = groups.count;
    groups.count += group.points->size();
  }
  return groups;
}

namespace {

// What the atmosphere adds to echoes that are otherwise complete.
void add_air(const AirPaths& air, const radar::PointArrays& points, const radar::PointSpan& run,
             const radar::ViewFrame& frame, const PulseGeometry& geometry, radar::EchoBatch& echoes,
             std::size_t first) {
  const core::Vec3& radar_m = geometry.radar_pose().position_world_m;
  const core::Vec3 origin_m = radar_m + frame.origin_m;
  for (std::size_t i = run.begin; i < run.end; ++i, ++first) {
    const core::Vec3 point_m =
        origin_m + frame.world_from_platform * core::Vec3{points.x_m[i], points.y_m[i], points.z_m[i]};
    const AirEffect effect = air.between(radar_m, point_m, geometry.carrier_hz());
    echoes.delay_s[first] += effect.delay_s;
    if (!echoes.ahead_turns.empty()) echoes.ahead_turns[first] = effect.ahead_turns;
    echoes.amplitude_sqrt_w[first] *= effect.factor;
  }
}

}  // namespace

bool certain_echoes(const PointGroups& groups, const PulseGeometry& geometry, const radar::PointSpan& run,
                    radar::EchoBatch& echoes) {
  CORE_EXPECT(run.begin <= run.end && run.end <= groups.count);
  if (!groups.sound()) return false;
  echoes.resize(run.size(), geometry.bends(), geometry.advances());
  if (run.size() == 0) return true;
  const radar::Pointing pointing = geometry.pointing();
  const core::Mat3 antenna_from_world = pointing.antenna_from_world();
  bool possible = true;
  std::size_t end = run.begin;
  auto group = std::prev(std::ranges::upper_bound(groups.groups, run.begin, {}, &PointGroups::Group::first));
  for (; end < run.end; ++group) {
    const std::size_t begin = group->first;
    end = begin + group->points->size();
    const radar::PointSpan part{std::max(run.begin, begin) - begin, std::min(run.end, end) - begin};
    radar::ViewFrame frame = geometry.frame(group->platform);
    frame.antenna_from_world = antenna_from_world;
    frame.axis_azimuth_rad = pointing.axis_azimuth_rad();
    frame.axis_elevation_rad = pointing.axis_elevation_rad();
    frame.amplitude_scale = geometry.amplitude_scale();
    frame.spreading = geometry.has_range_loss();
    possible = radar::write_echoes(*group->points, part, frame, groups.antenna, groups.reflectivity, echoes,
                                   begin + part.begin - run.begin) &&
               possible;
    if (geometry.air() != nullptr)
      add_air(*geometry.air(), *group->points, part, frame, geometry, echoes, begin + part.begin - run.begin);
  }
  return possible;
}

void fast_echoes(const PointGroups& groups, const PulseGeometry& geometry, radar::EchoBatch& echoes) {
  // Where in doubt the plain geometry decides, and says what is wrong with which target.
  if (!certain_echoes(groups, geometry, {0, groups.count}, echoes)) geometry.echoes(echoes);
}

}  // namespace sarsim::simulate
