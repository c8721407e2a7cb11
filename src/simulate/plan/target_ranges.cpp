#include "simulate/plan/target_ranges.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::int64_t max_pulses = 17;
constexpr std::size_t between_looks = 4096;
constexpr std::size_t max_cloud_points = 65'536;  // are looked at

void look_at(const core::StopFlag* stop) {
  if (stop != nullptr && stop->requested()) throw core::Interrupted();
}

void include(RangeExtent& extent, double range_m) {
  if (!std::isfinite(range_m)) return;
  extent.nearest_m = std::min(extent.nearest_m, range_m);
  extent.farthest_m = std::max(extent.farthest_m, range_m);
}

void include_pulse(RangeExtent& extent, const ResolvedScene& scene, const PulseGeometry& geometry,
                   const core::StopFlag* stop) {
  const double light_mps = scene.conventions.light_speed_mps;
  const radar::Pointing pointing = geometry.pointing();
  const ScattererList& all = scene.scatterers;
  const std::size_t step = (all.size() - all.targets()) / max_cloud_points + 1;
  for (std::size_t i = 0, n = 0; i < all.size(); i += i < all.targets() ? 1 : step, ++n) {
    if (n % between_looks == 0) look_at(stop);
    include(extent, radar::range_of(geometry.view(i, pointing).delay_s, light_mps));
  }
  for (const ScattererSheet& sheet : scene.sheets) {
    const radar::Pose& pose = geometry.pose(sheet.platform);
    for (std::size_t i = 0; i < sheet.points_m.size(); ++i) {
      if (i % between_looks == 0) look_at(stop);
      include(extent,
              core::norm(radar::world_position_m(pose, sheet.points_m[i]) - geometry.radar_pose().position_world_m));
    }
  }
}

}  // namespace

RangeExtent target_ranges(const ResolvedScene& scene, const Link& radar, const radar::PulseRange& pulses,
                          const core::StopFlag* stop) {
  CORE_EXPECT(radar.platform < scene.platforms.size());
  RangeExtent extent;
  PulseGeometry geometry(scene, radar);
  const std::int64_t looks = std::min(pulses.count(), max_pulses);
  for (std::int64_t n = 0; n < looks; ++n) {
    const double share = looks > 1 ? static_cast<double>(n) / static_cast<double>(looks - 1) : 0.0;
    geometry.set_pulse(pulses.first + std::llround(share * static_cast<double>(pulses.count() - 1)));
    include_pulse(extent, scene, geometry, stop);
  }
  return extent;
}

}  // namespace sarsim::simulate
