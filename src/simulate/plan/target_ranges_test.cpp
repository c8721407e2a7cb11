#include "simulate/plan/target_ranges.hpp"

#include <gtest/gtest.h>

#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace target_ranges_test {

RangeExtent extent_of(const scene::Scene& scene, const radar::PulseRange& pulses,
                      const core::StopFlag* stop = nullptr) {
  const ResolvedScene resolved = resolve(scene);
  return target_ranges(resolved, resolve_radar(scene, resolved, 0), pulses, stop);
}

TEST(TargetRanges, ReachFromTheNearestToTheFarthestEchoOfAllPulses) {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Car", {500.0, 0.0, 0.0}, {100.0, 0.0, 0.0}));
  scene.targets.push_back(target_on("Car", {0.0, 0.0, 0.0}));
  const RangeExtent first = extent_of(scene, {0, 0});
  EXPECT_NEAR(first.nearest_m, 500.0, 1e-3);
  EXPECT_NEAR(first.farthest_m, 1000.0, 1e-9);
  // 1 kHz: after 10 000 pulses the car is at 1500 m; at 0 and at 10 s both ends were looked at.
  const RangeExtent all = extent_of(scene, {0, 10000});
  EXPECT_NEAR(all.nearest_m, 500.0, 1e-3);
  EXPECT_NEAR(all.farthest_m, 1500.0, 1e-3);
}

TEST(TargetRanges, LookBetweenTheEndsToo) {
  scene::Scene scene = one_target_scene();
  scene.platforms[0] = moving("Earth", {-2000.0, 0.0, 0.0}, {1000.0, 0.0, 0.0});  // carries radar and target
  scene.platforms.push_back(resting("Pole", {0.0, 300.0, 0.0}));
  scene.targets[0].platform = "Pole";
  scene.targets[0].position_m = {};
  const RangeExtent extent = extent_of(scene, {0, 4000});  // passes at 2 s
  EXPECT_NEAR(extent.nearest_m, 300.0, 1.0);
  EXPECT_NEAR(extent.farthest_m, std::hypot(2000.0, 300.0), 1.0);
}

TEST(TargetRanges, IncludeSurfaces) {
  scene::Scene scene = one_target_scene();
  scene.targets.clear();
  scene.surfaces.push_back({});
  const RangeExtent extent = extent_of(scene, {0, 0});
  EXPECT_NEAR(extent.nearest_m, 1000.0, 1.0);
  EXPECT_NEAR(extent.farthest_m, 1000.0, 1.0);
}

TEST(TargetRanges, AreEmptyWithoutTargetsOrPulses) {
  scene::Scene scene = one_target_scene();
  EXPECT_TRUE(extent_of(scene, {1, 0}).empty());
  scene.targets.clear();
  EXPECT_TRUE(extent_of(scene, {0, 10}).empty());
}

TEST(TargetRanges, EndWhenAskedTo) {
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)extent_of(one_target_scene(), {0, 0}, &stop), core::Interrupted);
}

}  // namespace target_ranges_test
}  // namespace sarsim::simulate
