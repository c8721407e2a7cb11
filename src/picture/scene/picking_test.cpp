#include <limits>

#include <gtest/gtest.h>

#include "picture/scene/draw_scene.hpp"
#include "picture/scene/drawing.hpp"

namespace sarsim::picture {
namespace picking_test {

// Looks along +y at 1 px/m: the world's (x, y, z) is seen at (400 + x, 300 - z).
Camera front_camera() {
  Camera camera = preset(Camera::start(800, 600), ViewPreset::front);
  camera.pixels_per_m = 1.0;
  return camera;
}

const scene::ObjectId platform_id{scene::ObjectKind::platform, 0};
const scene::ObjectId radar_id{scene::ObjectKind::radar, 0};
scene::ObjectId target_id(std::size_t index) { return {scene::ObjectKind::target, index}; }
scene::ObjectId surface_id(std::size_t index) { return {scene::ObjectKind::surface, index}; }

struct Picture {
  Snapshot snapshot;
  DrawingOptions options;

  void add_target(const core::Vec3& at_m) {
    snapshot.targets.push_back({target_id(snapshot.targets.size()), at_m, at_m, {}, false});
  }
  void add_radar(const core::Vec3& at_m) {
    snapshot.radars.push_back({radar_id, "Radar1", at_m, {0, 1, 0}, {1, 0, 0}, 0.1, 0.1, true, {}});
  }
  void add_platform(const core::Vec3& at_m) {
    Snapshot::Platform platform;
    platform.id = platform_id;
    platform.name = "Plane";
    platform.pose.position_world_m = at_m;
    snapshot.platforms.push_back(platform);
  }
  // A right triangle from (x, z) = (100, 0), 100 m wide and high, at depth y.
  void add_surface(double y) {
    const std::size_t index = snapshot.surfaces.size();
    snapshot.surfaces.push_back(
        {surface_id(index), {core::Vec3{100, y, 0}, core::Vec3{200, y, 0}, core::Vec3{100, y, 100}}, {0, -1, 0}});
  }
  [[nodiscard]] std::optional<scene::ObjectId> pick(double x_px, double y_px, double reach_px = 6.0) const {
    Drawing drawing;
    draw_scene(snapshot, front_camera(), options, drawing);
    return picked(drawing, snapshot, front_camera(), x_px, y_px, reach_px);
  }
};

TEST(Picking, FindsTheNearestTargetWithinReach) {
  Picture picture;
  picture.add_target({0, 0, 0});
  picture.add_target({8, 0, 0});
  EXPECT_EQ(picture.pick(403.0, 300.0), target_id(0));
  EXPECT_EQ(picture.pick(405.0, 300.0), target_id(1));
  EXPECT_EQ(picture.pick(413.9, 300.0), target_id(1));
  EXPECT_FALSE(picture.pick(414.1, 300.0));
  EXPECT_FALSE(picture.pick(400.0, 307.0));
  EXPECT_EQ(picture.pick(400.0, 307.0, 8.0), target_id(0));
}

TEST(Picking, TakesTheOneInFrontWhereTwoAreEquallyNear) {
  Picture picture;
  picture.add_target({0, 50, 0});
  picture.add_target({0.2, -50, 0});
  picture.add_target({0, 20, 0});
  EXPECT_EQ(picture.pick(400.0, 300.0), target_id(1));
}

TEST(Picking, TakesTargetsAndRadarsBeforeTheirPlatform) {
  Picture picture;
  picture.add_platform({0, 0, 0});
  picture.add_radar({4, 0, 0});
  EXPECT_EQ(picture.pick(400.0, 300.0), radar_id);
  EXPECT_EQ(picture.pick(397.0, 300.0), platform_id);
}

TEST(Picking, FindsAPlatformByItsNameWhereItsRadarCoversIt) {
  Picture picture;
  picture.add_platform({0, 0, 0});
  picture.add_radar({0, 0, 0});
  EXPECT_EQ(picture.pick(400.0, 300.0), radar_id);
  EXPECT_EQ(picture.pick(400.0, 286.0), platform_id);
}

TEST(Picking, FindsASurfaceInsideAndAlongItsRim) {
  Picture picture;
  picture.add_surface(0.0);
  EXPECT_EQ(picture.pick(520.0, 280.0), surface_id(0));
  EXPECT_EQ(picture.pick(550.0, 303.0), surface_id(0));
  EXPECT_FALSE(picture.pick(550.0, 307.0));
  EXPECT_FALSE(picture.pick(590.0, 220.0));
}

TEST(Picking, TakesTheSurfaceInFrontAndSmallObjectsBeforeSurfaces) {
  Picture picture;
  picture.add_surface(30.0);
  picture.add_surface(-30.0);
  picture.add_surface(10.0);
  EXPECT_EQ(picture.pick(520.0, 280.0), surface_id(1));
  picture.options.hidden = {surface_id(1)};
  EXPECT_EQ(picture.pick(520.0, 280.0), surface_id(2));
  picture.add_target({120, 900, 20});
  EXPECT_EQ(picture.pick(520.0, 280.0), target_id(0));
}

TEST(Picking, FindsNothingHiddenAndNothingInAnEmptyPicture) {
  Picture picture;
  EXPECT_FALSE(picture.pick(400.0, 300.0));
  picture.add_target({0, 0, 0});
  picture.options.hidden = {target_id(0)};
  EXPECT_FALSE(picture.pick(400.0, 300.0));
  EXPECT_FALSE(picture.pick(std::numeric_limits<double>::quiet_NaN(), 300.0));
}

}  // namespace picking_test
}  // namespace sarsim::picture
