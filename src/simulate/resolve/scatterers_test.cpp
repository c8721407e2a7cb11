#include "simulate/resolve/scatterers.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/model/cloud_points.hpp"
#include "simulate/plan/point_groups.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace scatterers_test {

std::shared_ptr<const scene::CloudPoints> some_points(std::size_t count) {
  scene::CloudPoints read;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(i);
    read.arrays.x_m.push_back(x);
    read.arrays.y_m.push_back(1000.0 + x);
    read.arrays.z_m.push_back(-x);
    read.arrays.root_rcs_m.push_back(1.0 + x);
  }
  read.own_rcs = true;
  read.min_m = {0.0, 1000.0, 1.0 - static_cast<double>(count)};
  read.max_m = {static_cast<double>(count) - 1.0, 999.0 + static_cast<double>(count), 0.0};
  read.file = "points.npy";
  return std::make_shared<const scene::CloudPoints>(std::move(read));
}

scene::Scene scene_with_cloud(std::size_t points) {
  scene::Scene scene = one_target_scene();
  scene::Cloud cloud;
  cloud.platform = *scene.targets[0].platform;
  cloud.file = "points.npy";
  cloud.points = some_points(points);
  scene.clouds = {cloud};
  return scene;
}

TEST(ScattererList, GivesBackWhatItWasGiven) {
  Scatterer plain;
  plain.platform = 3;
  plain.position_m = {1.0, 2.0, 3.0};
  plain.rcs_m2 = 4.0;
  Scatterer shaken = plain;
  shaken.jittered = true;
  shaken.rcs_stddev_m2 = 0.5;
  shaken.position_stddev_m = {0.1, 0.2, 0.3};
  Scatterer faced = plain;
  faced.law = radar::ReflectivityLaw::user;
  faced.gain_curve = 7;
  faced.azimuth_rad = 0.25;
  const std::vector<Scatterer> given{plain, shaken, shaken, faced, plain, shaken};
  ScattererList list;
  for (const Scatterer& s : given) list.push_back(s);
  ASSERT_EQ(list.size(), given.size());
  EXPECT_EQ(list.targets(), given.size());
  std::size_t i = 0;
  for (const Scatterer& s : list) EXPECT_EQ(s, given[i++]);
  EXPECT_EQ(i, given.size());
  EXPECT_EQ(list.platforms(), std::vector<std::uint32_t>{3});
}

TEST(ScattererList, HasThePointsOfCloudsBehindItsTargets) {
  scene::Scene scene = scene_with_cloud(5);
  scene.clouds.push_back(scene.clouds[0]);
  scene.clouds[1].traits.position_stddev_m.x = 0.5;
  const ResolvedScene resolved = resolve(scene);
  const ScattererList& list = resolved.scatterers;
  ASSERT_EQ(list.size(), 11U);
  EXPECT_EQ(list.targets(), 1U);
  EXPECT_EQ(list[0].position_m, scene.targets[0].position_m);
  EXPECT_EQ(list[3].position_m, (core::Vec3{2.0, 1002.0, -2.0}));
  EXPECT_EQ(list[3].rcs_m2, 9.0);
  EXPECT_FALSE(list[3].jittered);
  EXPECT_EQ(list[10].position_m, (core::Vec3{4.0, 1004.0, -4.0}));
  EXPECT_TRUE(list[10].jittered);
}

TEST(ScattererList, ThinnedKeepsTheEndsOfClouds) {
  const auto whole = std::make_shared<const ResolvedScene>(resolve(scene_with_cloud(1000)));
  EXPECT_EQ(thinned(whole, 1000), whole);
  const auto few = thinned(whole, 4);
  ASSERT_EQ(few->scatterers.size(), 5U);
  EXPECT_EQ(few->scatterers[1].position_m.x, 0.0);
  EXPECT_EQ(few->scatterers[2].position_m.x, 333.0);
  EXPECT_EQ(few->scatterers[4].position_m.x, 999.0);
  EXPECT_EQ(few->platforms.size(), whole->platforms.size());
  EXPECT_EQ(few->platforms[0].radius_m, whole->platforms[0].radius_m);
}

TEST(ResolvedCloud, SharesItsPointsWithTheKernels) {
  const scene::Scene scene = scene_with_cloud(100);
  const ResolvedScene resolved = resolve(scene);
  const PointGroups groups = group_points(resolved, resolve_radar(scene, resolved, 0));
  ASSERT_EQ(groups.groups.size(), 2U);
  EXPECT_EQ(groups.groups[1].points.get(), &scene.clouds[0].points->arrays) << "no copy";
  EXPECT_EQ(groups.count, 101U);
}

TEST(ResolvedCloud, TakesTheCloudsCrossSectionWhereItHasChanged) {
  scene::Scene scene = scene_with_cloud(3);
  scene::CloudPoints alike = *scene.clouds[0].points;
  alike.own_rcs = false;
  alike.rcs_m2 = 1.0;
  alike.arrays.root_rcs_m.assign(3, 1.0);
  scene.clouds[0].points = std::make_shared<const scene::CloudPoints>(alike);
  scene.clouds[0].rcs_m2 = 6.25;
  EXPECT_EQ(resolve(scene).scatterers[2].rcs_m2, 6.25);
  scene.clouds[0].rcs_m2 = 1.0;
  EXPECT_EQ(resolve(scene).scatterers[2].rcs_m2, 1.0);
}

TEST(ResolvedCloud, HasToBeRead) {
  scene::Scene scene = scene_with_cloud(3);
  scene.clouds[0].file = "others.npy";
  EXPECT_THROW((void)resolve(scene), std::invalid_argument);
  scene.clouds[0].points = {};
  EXPECT_THROW((void)resolve(scene), std::invalid_argument);
}

}  // namespace scatterers_test
}  // namespace sarsim::simulate
