#include "picture/scene/camera.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::picture {
namespace camera_test {

constexpr double deg = core::pi / 180.0;

// Cameras of all directions, scales and both kinds.
std::vector<Camera> cameras() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-core::pi, core::pi), side(-2000.0, 2000.0), exponent(-3.0, 2.0);
  std::vector<Camera> all;
  for (int i = 0; i < 60; ++i) {
    Camera camera;
    camera.focus_world_m = {side(random), side(random), side(random)};
    camera.azimuth_rad = angle(random);
    camera.elevation_rad = 0.5 * angle(random);
    camera.pixels_per_m = std::pow(10.0, exponent(random));
    camera.perspective = i % 2 == 1;
    camera.width_px = 900.0;
    camera.height_px = 500.0;
    all.push_back(camera);
  }
  return all;
}

void expect_near(const core::Vec3& a, const core::Vec3& b, double tolerance) {
  EXPECT_LT(core::norm(a - b), tolerance);
}

TEST(Camera, AxesOfThePictureAreARightHandedRotation) {
  for (const Camera& camera : cameras()) {
    const core::Mat3 r = camera.picture_from_world();
    const core::Mat3 unit = r * core::transposed(r);
    for (std::size_t i = 0; i < 3; ++i) expect_near(unit.row[i], core::Mat3{}.row[i], 1e-14);
    expect_near(core::cross(r.row[0], r.row[1]), r.row[2], 1e-14);
    EXPECT_NEAR(r.row[0].z, 0.0, 1e-15);  // z is up: the horizon is level
    EXPECT_GE(r.row[1].z, 0.0);
  }
}

TEST(Camera, FocusIsTheMiddleOfThePicture) {
  for (const Camera& camera : cameras()) {
    const auto point = camera.project(camera.focus_world_m);
    ASSERT_TRUE(point);
    EXPECT_DOUBLE_EQ(point->x, 450.0);
    EXPECT_DOUBLE_EQ(point->y, 250.0);
    EXPECT_DOUBLE_EQ(point->depth_m, 0.0);
  }
}

TEST(Camera, ProjectIsTheInverseOfUnproject) {
  for (const Camera& camera : cameras())
    for (const double x : {0.0, 333.0, 900.0}) {
      const core::Vec3 world_m = camera.unproject(x, 100.0);
      const auto point = camera.project(world_m);
      ASSERT_TRUE(point);
      // Rounding of the world's coordinates, seen at this scale.
      const double tolerance = 1e-11 * (1.0 + core::norm(world_m) * camera.pixels_per_m);
      EXPECT_NEAR(point->x, x, tolerance);
      EXPECT_NEAR(point->y, 100.0, tolerance);
      EXPECT_NEAR(point->depth_m * camera.pixels_per_m, 0.0, tolerance);
    }
}

TEST(Camera, StartsWhereTheThesisStarts) {
  const Camera camera = Camera::start(640.0, 480.0);
  EXPECT_NEAR(camera.azimuth_rad, 60.0 * deg, 1e-15);
  EXPECT_NEAR(camera.elevation_rad, 30.0 * deg, 1e-15);
  EXPECT_EQ(camera.width_px, 640.0);
  EXPECT_EQ(camera.height_px, 480.0);
  // The viewer stands on the side of +x and +y, above the plane.
  expect_near(camera.picture_from_world().row[2], core::direction(60.0 * deg, 30.0 * deg), 1e-15);
}

TEST(Camera, PresetsLookAlongTheAxes) {
  const core::Mat3 top = preset(Camera{}, ViewPreset::top).picture_from_world();
  expect_near(top.row[0], {1, 0, 0}, 1e-15);
  expect_near(top.row[1], {0, 1, 0}, 1e-15);
  const core::Mat3 front = preset(Camera{}, ViewPreset::front).picture_from_world();
  expect_near(front.row[0], {1, 0, 0}, 1e-15);
  expect_near(front.row[1], {0, 0, 1}, 1e-15);
  expect_near(front.row[2], {0, -1, 0}, 1e-15);
  const core::Mat3 side = preset(Camera{}, ViewPreset::side).picture_from_world();
  expect_near(side.row[0], {0, 1, 0}, 1e-15);
  expect_near(side.row[2], {1, 0, 0}, 1e-15);
}

TEST(Camera, PresetKeepsFocusAndScale) {
  Camera camera;
  camera.focus_world_m = {1, 2, 3};
  camera.pixels_per_m = 7.0;
  const Camera top = preset(camera, ViewPreset::top);
  EXPECT_EQ(top.focus_world_m, camera.focus_world_m);
  EXPECT_EQ(top.pixels_per_m, 7.0);
}

TEST(Camera, HigherPointsAreHigherInThePicture) {
  for (const Camera& camera : cameras()) {
    if (std::abs(camera.elevation_rad) > 80.0 * deg) continue;
    const auto low = camera.project(camera.focus_world_m);
    const auto high = camera.project(camera.focus_world_m + core::Vec3{0, 0, 1.0 / camera.pixels_per_m});
    EXPECT_LT(high->y, low->y);
  }
}

TEST(Camera, FourPixelsTurnOneDegreeOfAzimuthAndTwoOneOfElevation) {
  const Camera before = Camera::start(800, 600);
  const Camera after = turned(before, 40.0, 20.0);
  EXPECT_NEAR(after.azimuth_rad, 70.0 * deg, 1e-14);
  EXPECT_NEAR(after.elevation_rad, 40.0 * deg, 1e-14);
  const Camera fine = turned(before, 40.0, 20.0, 2.0);
  EXPECT_NEAR(fine.azimuth_rad, 65.0 * deg, 1e-14);
  EXPECT_NEAR(fine.elevation_rad, 35.0 * deg, 1e-14);
}

TEST(Camera, TheNearSideFollowsATurningCursor) {
  const Camera before = Camera::start(800, 600);
  const core::Vec3 near_side = 1000.0 * before.picture_from_world().row[2];
  const auto moved = turned(before, 8.0, 8.0).project(near_side);
  EXPECT_GT(moved->x, 400.0);
  EXPECT_GT(moved->y, 300.0);
}

TEST(Camera, ElevationStaysWithin90DegreesAndAzimuthWraps) {
  const Camera before = Camera::start(800, 600);
  EXPECT_DOUBLE_EQ(turned(before, 0.0, 1e6).elevation_rad, 0.5 * core::pi);
  EXPECT_DOUBLE_EQ(turned(before, 0.0, -1e6).elevation_rad, -0.5 * core::pi);
  EXPECT_NEAR(turned(before, 4.0 * 130.0, 0.0).azimuth_rad, -170.0 * deg, 1e-12);
  EXPECT_NEAR(turned(before, 4.0 * 360.0, 0.0).azimuth_rad, before.azimuth_rad, 1e-12);
}

TEST(Camera, PanKeepsThePointUnderTheCursor) {
  for (const Camera& camera : cameras()) {
    const core::Vec3 held = camera.unproject(200.0, 320.0);
    const auto point = panned(camera, 57.0, -31.0).project(held);
    ASSERT_TRUE(point);
    const double tolerance = 1e-11 * (1.0 + core::norm(held) * camera.pixels_per_m);
    EXPECT_NEAR(point->x, 257.0, tolerance);
    EXPECT_NEAR(point->y, 289.0, tolerance);
  }
}

TEST(Camera, ZoomKeepsTheCursorsPoint) {
  for (const Camera& camera : cameras())
    for (const double factor : {0.3, 1.0, 7.0}) {
      const core::Vec3 held = camera.unproject(200.0, 320.0);
      const Camera after = zoomed(camera, factor, 200.0, 320.0);
      EXPECT_DOUBLE_EQ(after.pixels_per_m, camera.pixels_per_m * factor);
      const auto point = after.project(held);
      ASSERT_TRUE(point);
      const double tolerance = 1e-11 * (1.0 + core::norm(held) * after.pixels_per_m);
      EXPECT_NEAR(point->x, 200.0, tolerance);
      EXPECT_NEAR(point->y, 320.0, tolerance);
    }
}

TEST(Camera, ZoomStopsAtItsLimitsAndStillKeepsThePoint) {
  const Camera start = Camera::start(800, 600);
  const Camera far = zoomed(start, 1e-30, 100.0, 100.0);
  EXPECT_EQ(far.pixels_per_m, smallest_pixels_per_m);
  EXPECT_NEAR(far.project(start.unproject(100.0, 100.0))->x, 100.0, 1e-6);
  EXPECT_EQ(zoomed(start, 1e30, 100.0, 100.0).pixels_per_m, largest_pixels_per_m);
  for (const double factor : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(zoomed(start, factor, 100.0, 100.0).pixels_per_m, start.pixels_per_m);
    EXPECT_EQ(zoomed(start, factor, 100.0, 100.0).focus_world_m, start.focus_world_m);
  }
}

TEST(Camera, PerspectiveHasTheOrthographicScaleInTheFocusPlane) {
  Camera flat = Camera::start(800, 600);
  Camera deep = flat;
  deep.perspective = true;
  const core::Vec3 in_plane = flat.unproject(100.0, 500.0);
  EXPECT_NEAR(deep.project(in_plane)->x, 100.0, 1e-9);
  EXPECT_NEAR(deep.project(in_plane)->y, 500.0, 1e-9);
  EXPECT_DOUBLE_EQ(deep.scale_at(0.0), flat.pixels_per_m);
  EXPECT_DOUBLE_EQ(flat.scale_at(1e9), flat.pixels_per_m);
  // Twice as far from the viewer, half the scale.
  EXPECT_DOUBLE_EQ(deep.scale_at(deep.viewer_distance_m()), 0.5 * flat.pixels_per_m);
}

TEST(Camera, NothingBehindTheViewerOfAPerspectiveView) {
  Camera camera = Camera::start(800, 600);
  const core::Vec3 towards = camera.picture_from_world().row[2];
  const double viewer_m = camera.viewer_distance_m();
  EXPECT_TRUE(camera.project(1.5 * viewer_m * towards));
  camera.perspective = true;
  EXPECT_TRUE(camera.project(0.99 * viewer_m * towards));
  EXPECT_FALSE(camera.project(viewer_m * towards));
  EXPECT_FALSE(camera.project(1.5 * viewer_m * towards));
  EXPECT_EQ(camera.scale_at(-2.0 * viewer_m), 0.0);
}

TEST(Camera, NoNumberIsNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Camera{}.project({nan, 0, 0}));
  EXPECT_FALSE(Camera{}.project({0, 0, std::numeric_limits<double>::infinity()}));
}

TEST(Camera, FitShowsAllPointsAndFillsThePicture) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> side(-1.0, 1.0);
  for (Camera camera : cameras()) {
    std::vector<core::Vec3> points;
    for (int i = 0; i < 20; ++i)
      points.push_back({5000.0 + 300.0 * side(random), 900.0 * side(random), 40.0 * side(random)});
    camera = fitted(camera, points);
    double widest = 0.0;
    for (const core::Vec3& p : points) {
      const auto point = camera.project(p);
      ASSERT_TRUE(point);
      const double x = std::abs(point->x - 450.0) / 450.0;
      const double y = std::abs(point->y - 250.0) / 250.0;
      EXPECT_LT(std::max(x, y), 0.8 + 1e-9);
      widest = std::max({widest, x, y});
    }
    // In perspective the nearest point may stop the viewer before the picture is full.
    EXPECT_GT(widest, camera.perspective ? 0.5 : 0.8 - 1e-9);
  }
}

TEST(Camera, FitOfOnePointMovesTheFocusAndKeepsTheScale) {
  const Camera start = Camera::start(800, 600);
  const Camera one = fitted(start, {{3000, 4000, 50}});
  expect_near(one.focus_world_m, {3000, 4000, 50}, 1e-9);
  EXPECT_EQ(one.pixels_per_m, start.pixels_per_m);
  const Camera same = fitted(start, {{3000, 4000, 50}, {3000, 4000, 50}});
  EXPECT_EQ(same.pixels_per_m, start.pixels_per_m);
  const Camera none = fitted(start, {});
  EXPECT_EQ(none.focus_world_m, start.focus_world_m);
  EXPECT_EQ(none.pixels_per_m, start.pixels_per_m);
}

TEST(Camera, FitIgnoresWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Camera camera = fitted(Camera::start(800, 600), {{0, 0, 0}, {nan, 0, 0}, {100, 0, 0}});
  expect_near(camera.focus_world_m, {50, 0, 0}, 1e-9);
}

TEST(Camera, FitInPerspectiveKeepsNearPointsInFrontOfTheViewer) {
  Camera camera = preset(Camera::start(800, 600), ViewPreset::front);
  camera.perspective = true;
  // A line along the view: no width, all depth.
  camera = fitted(camera, {{0, -5000, 0}, {0, 5000, 0}});
  EXPECT_TRUE(camera.project({0, -5000, 0}));
  EXPECT_LE(camera.scale_at(-5000.0), 2.0 * camera.pixels_per_m * (1.0 + 1e-9));
}

}  // namespace camera_test
}  // namespace sarsim::picture
