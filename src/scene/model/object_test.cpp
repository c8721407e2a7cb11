
#include <gtest/gtest.h>

#include "scene/model/object.hpp"

namespace sarsim::scene {

namespace object_test {

Scene harbour() {
  Scene scene;
  scene.platforms.resize(2);
  scene.platforms[0].name = "Earth";
  scene.platforms[1].name = "Ship";
  scene.targets.resize(3);
  scene.targets[0].platform = "SHIP";
  scene.targets[1].platform = "Sh";  // a beginning of the name
  scene.targets[2].platform = "nowhere";
  scene.targets[2].position_m = {1.0, -2.5, 1e7};
  scene.clouds.resize(1);
  scene.surfaces.resize(1);
  scene.radars.resize(1);
  scene.radars[0].platform = "Ship";
  scene.simulations.resize(1);
  scene.simulations[0].radar = "Radar1";
  scene.geometries.resize(1);
  return scene;
}

TEST(Object, KindsStandInTheOrderOfTheVariant) {
  for (const ObjectKind kind : all_object_kinds) {
    Scene scene = harbour();
    EXPECT_EQ(kind_of(object_of(scene, {kind, 0})), kind);
  }
}

TEST(Object, KindsHaveTheNamesOfSubjects) {
  std::string names;
  for (const ObjectKind kind : all_object_kinds) names += std::string(name_of(kind)) + " ";
  EXPECT_EQ(names, "platform target cloud surface radar simulation geometry ");
}

TEST(Object, IsThereUpToTheCount) {
  const Scene scene = harbour();
  EXPECT_EQ(count_of(scene, ObjectKind::target), 3U);
  EXPECT_TRUE(has_object(scene, {ObjectKind::target, 2}));
  EXPECT_FALSE(has_object(scene, {ObjectKind::target, 3}));
  EXPECT_THROW(static_cast<void>(object_of(scene, {ObjectKind::target, 3})), std::out_of_range);
  EXPECT_THROW(static_cast<void>(label_of(scene, {ObjectKind::radar, 1})), std::out_of_range);
}

TEST(Object, IsCalledByItsNameItsPlaceOrItsFile) {
  Scene scene = harbour();
  EXPECT_EQ(label_of(scene, {ObjectKind::platform, 1}), "Ship");
  EXPECT_EQ(label_of(scene, {ObjectKind::target, 2}), "Target 3 (1, -2.5, 1e+07) m");
  scene.targets[2].position_m = {-2.8e-10, 3.0, -0.0};
  EXPECT_EQ(label_of(scene, {ObjectKind::target, 2}), "Target 3 (0, 3, 0) m");
  EXPECT_EQ(label_of(scene, {ObjectKind::surface, 0}), "Surface 1");
  EXPECT_EQ(label_of(scene, {ObjectKind::radar, 0}), "Radar1");
  EXPECT_EQ(label_of(scene, {ObjectKind::simulation, 0}), "sim1.bin");
  EXPECT_EQ(label_of(scene, {ObjectKind::geometry, 0}), "geo1.txt");
}

TEST(Object, WithoutANameIsCalledByItsNumber) {
  Scene scene = harbour();
  scene.platforms[1].name.clear();
  scene.simulations[0].file.clear();
  EXPECT_EQ(label_of(scene, {ObjectKind::platform, 1}), "Platform 2");
  EXPECT_EQ(label_of(scene, {ObjectKind::simulation, 0}), "Simulation 1");
}

TEST(Object, IsCarriedByWhatItNames) {
  const Scene scene = harbour();
  EXPECT_EQ(carrier_of(scene, {ObjectKind::target, 0}), "SHIP");
  EXPECT_EQ(carrier_of(scene, {ObjectKind::radar, 0}), "Ship");
  EXPECT_EQ(carrier_of(scene, {ObjectKind::simulation, 0}), "Radar1");
  EXPECT_EQ(carrier_of(scene, {ObjectKind::platform, 0}), "");
}

TEST(ObjectsOn, AreThoseWhoseNamesMeanThePlatform) {
  const Scene scene = harbour();
  EXPECT_EQ(objects_on(scene, 1),
            (std::vector<ObjectId>{{ObjectKind::target, 0}, {ObjectKind::target, 1}, {ObjectKind::radar, 0}}));
  EXPECT_EQ(objects_on(scene, 0), (std::vector<ObjectId>{{ObjectKind::cloud, 0}, {ObjectKind::surface, 0}}));
}

TEST(ObjectsOn, TheWorldAreThoseThatNoPlatformCarries) {
  EXPECT_EQ(objects_on(harbour(), not_found), (std::vector<ObjectId>{{ObjectKind::target, 2}}));
}

}  // namespace object_test
}  // namespace sarsim::scene
