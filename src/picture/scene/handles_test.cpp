#include "picture/scene/handles.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "picture/scene/snapshot_maker.hpp"

namespace sarsim::picture {
namespace handles_test {

constexpr double deg = core::rad_per_deg;
const scene::ObjectId ship_id{scene::ObjectKind::platform, 1};
const scene::ObjectId target_id{scene::ObjectKind::target, 0};
const scene::ObjectId radar_id{scene::ObjectKind::radar, 0};

// A ship that is turned, with a directional target and a radar on it.
scene::Scene turned_ship() {
  scene::Scene scene;
  scene.platforms.resize(2);
  scene::Platform& ship = scene.platforms[1];
  ship.name = "Ship";
  ship.position_m = {100.0, 200.0, 0.0};
  ship.rotation = {core::Angle::from_deg(10.0), core::Angle::from_deg(-20.0), core::Angle::from_deg(40.0)};
  scene::Target& target = scene.targets.emplace_back();
  target.platform = "Ship";
  target.position_m = {5.0, 0.0, 1.0};
  target.traits.edit().reflectivity = scene::Target::Reflectivity::directional;
  target.traits.edit().azimuth = core::Angle::from_deg(30.0);
  target.traits.edit().elevation = core::Angle::from_deg(15.0);
  scene::Radar& radar = scene.radars.emplace_back();
  radar.platform = "Ship";
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.beam_azimuth = core::Angle::from_deg(25.0);
  return scene;
}

core::Vec3 rotated(const core::Vec3& v, const core::Vec3& axis, double rad) {
  return std::cos(rad) * v + std::sin(rad) * core::cross(axis, v) + ((1.0 - std::cos(rad)) * core::dot(axis, v)) * axis;
}

// Each ring turns what it belongs to about its axis, right-handedly, by changing one angle.
void expect_rings_turn(const scene::ObjectId& id, std::size_t count,
                       const std::function<std::vector<core::Vec3>(const Snapshot&)>& directions_of) {
  const scene::Scene scene = turned_ship();
  const Snapshot before = SnapshotMaker(scene).at(0.0);
  const auto handles = handles_of(scene, before, id, false);
  ASSERT_TRUE(handles);
  ASSERT_EQ(handles->gizmo.rings.size(), count);
  ASSERT_EQ(handles->angles.size(), count);
  for (std::size_t ring = 0; ring < count; ++ring) {
    scene::Scene after = scene;
    const scene::AnyObject object = turned(scene::object_of(scene, id), ring, 33.0 * deg);
    if (const auto* platform = std::get_if<scene::Platform>(&object)) after.platforms[id.index] = *platform;
    if (const auto* target = std::get_if<scene::Target>(&object)) after.targets[id.index] = *target;
    if (const auto* radar = std::get_if<scene::Radar>(&object)) after.radars[id.index] = *radar;
    const std::vector<core::Vec3> from = directions_of(before);
    const std::vector<core::Vec3> to = directions_of(SnapshotMaker(after).at(0.0));
    for (std::size_t i = 0; i < from.size(); ++i)
      EXPECT_LT(core::norm(rotated(from[i], handles->gizmo.rings[ring].axis_world, 33.0 * deg) - to[i]), 1e-9)
          << handles->angles[ring].name;
  }
}

TEST(Handles, RingsOfAPlatformTurnItAboutTheirAxes) {
  expect_rings_turn(ship_id, 3, [](const Snapshot& snapshot) {
    const auto& columns = core::transposed(snapshot.platforms[1].pose.world_from_platform).row;
    return std::vector<core::Vec3>(columns.begin(), columns.end());
  });
}

TEST(Handles, RingsOfADirectionalTargetTurnItsNormal) {
  expect_rings_turn(target_id, 2, [](const Snapshot& s) { return std::vector{s.targets[0].normal_world}; });
}

TEST(Handles, RingsOfARadarTurnItsBeam) {
  expect_rings_turn(radar_id, 2, [](const Snapshot& s) { return std::vector{s.radars[0].axis_world}; });
}

TEST(Handles, AreThereForWhatAHandCanChangeAlone) {
  scene::Scene scene = turned_ship();
  const auto handles = [&](const scene::ObjectId& id) {
    return handles_of(scene, SnapshotMaker(scene).at(0.0), id, false);
  };
  EXPECT_FALSE(handles({scene::ObjectKind::platform, 0}));  // the world
  EXPECT_FALSE(handles({scene::ObjectKind::target, 7}));
  EXPECT_TRUE(handles(ship_id)->gizmo.moves);
  EXPECT_FALSE(handles(radar_id)->gizmo.moves);
  scene.targets[0].traits.edit().reflectivity = scene::Target::Reflectivity::isotropic;
  EXPECT_TRUE(handles(target_id)->gizmo.rings.empty());
  scene.radars[0].beam = scene::Radar::Beam::rotating;
  EXPECT_FALSE(handles(radar_id));
  scene.platforms[1].path = scene::Platform::Path::trajectory;
  scene.platforms[1].trajectory_m.part[0].knots = {{0.0, 0.0}, {1.0, 10.0}};
  EXPECT_FALSE(handles(ship_id)->gizmo.moves);
  EXPECT_EQ(handles(ship_id)->gizmo.rings.size(), std::size_t{3});
  scene.platforms[1].aligned = true;
  EXPECT_FALSE(handles(ship_id));
}

TEST(Handles, LieAlongTheWorldOrAlongTheTurnedPlatform) {
  const scene::Scene scene = turned_ship();
  const Snapshot snapshot = SnapshotMaker(scene).at(0.0);
  const auto own = core::transposed(snapshot.platforms[1].pose.world_from_platform).row;
  for (const scene::ObjectId& id : {ship_id, target_id}) {
    EXPECT_EQ(handles_of(scene, snapshot, id, false)->gizmo.axes_world, core::Mat3{}.row);
    EXPECT_EQ(handles_of(scene, snapshot, id, true)->gizmo.axes_world, own);
  }
}

TEST(Handles, ARingChangesOneAngleAndLeavesRoundNumbers) {
  const auto ship = std::get<scene::Platform>(turned(turned_ship().platforms[1], 2, 5.0 * deg));
  EXPECT_EQ(ship.rotation[0].deg(), 10.0);
  EXPECT_EQ(ship.rotation[1].deg(), -20.0);
  EXPECT_EQ(ship.rotation[2].deg(), 45.0);
}

}  // namespace handles_test
}  // namespace sarsim::picture
