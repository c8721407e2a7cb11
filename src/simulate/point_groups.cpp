#include "simulate/point_groups.hpp"

#include <cmath>
#include <optional>

#include "simulate/impossible_echo.hpp"

namespace sarsim {

namespace {

bool is_plain(const Scatterer& s) { return !s.jittered && s.law != ReflectivityLaw::user; }

bool joins(const PointGroups::Run& run, const Scatterer& s) {
  return !run.sheet && run.platform == s.platform && run.plain == is_plain(s) &&
         (!run.plain || run.points.normal_x.empty() == (s.law == ReflectivityLaw::isotropic));
}

void add_point(PointArrays& points, const Vec3& at, double rcs_m2, const Vec3* normal) {
  points.x_m.push_back(at.x);
  points.y_m.push_back(at.y);
  points.z_m.push_back(at.z);
  points.root_rcs_m.push_back(std::sqrt(std::max(0.0, rcs_m2)));
  if (normal == nullptr) return;
  points.normal_x.push_back(normal->x);
  points.normal_y.push_back(normal->y);
  points.normal_z.push_back(normal->z);
}

bool simd_pattern(const AntennaPattern& pattern) { return pattern.kind != AntennaPattern::Kind::user; }

// The beam in the form that SIMD takes, where it has one; `isotropic` tells that none is needed.
std::optional<SinxBeam> simd_beam(const ResolvedScene& scene, const ResolvedRadar& radar, const Pointing& pointing) {
  if (scene.conventions.pattern != PatternRule::amplitude || scene.conventions.pointing != PointingRule::boresight)
    return std::nullopt;
  if (!simd_pattern(radar.transmit) || !simd_pattern(radar.receive)) return std::nullopt;
  SinxBeam beam;
  beam.antenna_from_world = pointing.antenna_from_world();
  const auto cut = [](const AntennaPattern& p, double beamwidth_rad) {
    return p.kind == AntennaPattern::Kind::sinx ? 0.44 / beamwidth_rad : 0.0;
  };
  beam.cut[0] = cut(radar.transmit, radar.transmit.azimuth_beamwidth_rad);
  beam.cut[1] = cut(radar.transmit, radar.transmit.elevation_beamwidth_rad);
  beam.cut[2] = cut(radar.receive, radar.receive.azimuth_beamwidth_rad);
  beam.cut[3] = cut(radar.receive, radar.receive.elevation_beamwidth_rad);
  return beam;
}

// Refuses what PulseGeometry::echoes refuses. The echoes of a run begin at `first` of the batch.
void expect_possible(const PointGroups::Run& run, const ResolvedScene& scene, const PulseGeometry& geometry,
                     EchoBatch& echoes, std::size_t first) {
  const double light_mps = scene.conventions.light_speed_mps;
  for (std::size_t k = first; k < echoes.size(); ++k) {
    const double distance_m = 0.5 * echoes.delay_s[k] * (light_mps - echoes.speed_mps[k]);
    const ScattererView view{distance_m, echoes.speed_mps[k], echoes.delay_s[k], echoes.amplitude_sqrt_w[k]};
    if (possible_echo({view.distance_m, view.speed_mps, std::abs(view.amplitude_sqrt_w)}, light_mps)) continue;
    if (run.sheet && !(distance_m > 0.0)) {
      // A plane through the radar shows it neither side.
      echoes.delay_s[k] = echoes.speed_mps[k] = echoes.amplitude_sqrt_w[k] = 0.0;
      continue;
    }
    if (run.sheet)
      geometry.expect_possible("surface", run.first_target, view);
    else
      geometry.expect_possible("target", run.first_target + (k - first), geometry.view(run.first_target + (k - first)));
  }
}

bool isotropic(const ResolvedRadar& radar) {
  return radar.transmit.kind == AntennaPattern::Kind::isotropic &&
         radar.receive.kind == AntennaPattern::Kind::isotropic;
}

}  // namespace

PointGroups group_points(const ResolvedScene& scene) {
  PointGroups groups;
  for (std::size_t i = 0; i < scene.scatterers.size(); ++i) {
    const Scatterer& s = scene.scatterers[i];
    if (groups.runs.empty() || !joins(groups.runs.back(), s))
      groups.runs.push_back({s.platform, i, 0, is_plain(s), false, {}});
    PointGroups::Run& run = groups.runs.back();
    ++run.count;
    const Vec3 normal = direction(s.azimuth_rad, s.elevation_rad);
    if (run.plain)
      add_point(run.points, s.position_m, s.rcs_m2, s.law == ReflectivityLaw::isotropic ? nullptr : &normal);
  }
  for (std::size_t i = 0; i < scene.sheets.size(); ++i) {
    const ScattererSheet& sheet = scene.sheets[i];
    groups.runs.push_back({sheet.platform, i, sheet.points_m.size(), true, true, {}});
    for (const Vec3& point : sheet.points_m)
      add_point(groups.runs.back().points, point, sheet.point_rcs_m2, &sheet.normal_platform);
  }
  return groups;
}

void fast_echoes(const PointGroups& groups, const ResolvedScene& scene, const ResolvedRadar& radar,
                 const PulseGeometry& geometry, EchoBatch& echoes) {
  const Pointing pointing = geometry.pointing();
  const bool plain_antenna = isotropic(radar);
  const std::optional<SinxBeam> beam = plain_antenna ? std::nullopt : simd_beam(scene, radar, pointing);
  if (!plain_antenna && !beam) {
    geometry.echoes(echoes);
    return;
  }
  echoes.clear();
  SightFrame frame;
  frame.light_speed_mps = scene.conventions.light_speed_mps;
  frame.amplitude_scale = geometry.amplitude_scale();
  frame.spreading = geometry.spreading();
  for (const PointGroups::Run& run : groups.runs) {
    const std::size_t old = echoes.size();
    if (run.plain) {
      const Pose& pose = geometry.pose(run.platform);
      frame.world_from_platform = pose.world_from_platform;
      frame.world_from_platform_rate = pose.world_from_platform_rate;
      frame.origin_m = pose.position_world_m - geometry.radar_pose().position_world_m;
      frame.velocity_mps = pose.velocity_world_mps - geometry.radar_pose().velocity_world_mps;
      append_echoes(run.points, 0, run.count, frame, beam ? &*beam : nullptr, echoes);
    } else {
      for (std::size_t i = run.first_target; i < run.first_target + run.count; ++i) {
        const ScattererView v = geometry.view(i, pointing);
        echoes.add(v.delay_s, v.amplitude_sqrt_w, v.speed_mps);
      }
    }
    expect_possible(run, scene, geometry, echoes, old);
  }
}

}  // namespace sarsim
