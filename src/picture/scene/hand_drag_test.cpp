#include "picture/scene/hand_drag.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::picture {
namespace hand_drag_test {

constexpr double deg = core::rad_per_deg;

// Seen along +y from an elevation, at 2 px/m.
Camera camera_at(double elevation_deg, bool perspective = false) {
  Camera camera = preset(Camera::start(800.0, 600.0), ViewPreset::front);
  camera.elevation_rad = elevation_deg * deg;
  camera.pixels_per_m = 2.0;
  camera.perspective = perspective;
  return camera;
}

HandDrag drag_of(const Camera& camera, const core::Vec3& place_m) {
  const auto at = camera.project(place_m);
  HandDrag drag;
  drag.camera = camera;
  drag.x_px = at->x;
  drag.y_px = at->y;
  drag.place_world_m = place_m;
  return drag;
}

void expect_near(const core::Vec3& a, const core::Vec3& b, double tolerance) {
  EXPECT_LT(core::norm(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(HandMove, OnTheLevelPlaneThingsStayUnderThePointerAndOnTheirLevel) {
  for (const bool perspective : {false, true}) {
    const Camera camera = camera_at(30.0, perspective);
    const core::Vec3 from{10.0, -20.0, 7.0};
    const core::Vec3 to{40.0, 35.0, 7.0};
    const auto end = camera.project(to);
    const HandMove move = hand_move(drag_of(camera, from), end->x, end->y, false);
    EXPECT_EQ(move.delta_world_m.z, 0.0);
    EXPECT_FALSE(move.upright);
    expect_near(from + move.delta_world_m, to, 2.0 * move.resolution_m);
  }
}

TEST(HandMove, AWayUpInAnOrthographicPictureIsLongerOnTheGroundByTheSineOfTheElevation) {
  const HandMove move = hand_move(drag_of(camera_at(30.0), {}), 400.0 + 50.0, 300.0 - 40.0, false);
  expect_near(move.delta_world_m, {25.0, 20.0 / std::sin(30.0 * deg), 0.0}, move.resolution_m);
}

TEST(HandMove, WhereTheGroundIsSeenFromItsEdgeThingsMoveUpright) {
  const HandMove move = hand_move(drag_of(camera_at(3.0), {}), 450.0, 260.0, false);
  EXPECT_TRUE(move.upright);
  EXPECT_EQ(move.delta_world_m.y, 0.0);
  expect_near(move.delta_world_m, {25.0, 0.0, 20.0 / std::cos(3.0 * deg)}, 2.0 * move.resolution_m);
}

TEST(HandMove, AboveTheHorizonAThingStaysFarAway) {
  const Camera camera = camera_at(10.0, true);
  const HandDrag drag = drag_of(camera, {});
  double before = 0.0;
  for (double y = 290.0; y > 0.0; y -= 10.0) {
    const double now = hand_move(drag, 400.0, y, false).delta_world_m.y;
    EXPECT_GE(now, 0.99 * before);
    before = now;
  }
  EXPECT_GT(before, 500.0);
}

TEST(HandMove, ALockedAxisIsTheOnlyOneThatMoves) {
  for (const bool perspective : {false, true})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Camera camera = camera_at(35.0, perspective);
      Camera turned_camera = turned(camera, 120.0, 0.0);
      const core::Vec3 from{5.0, 6.0, 7.0};
      HandDrag drag = drag_of(turned_camera, from);
      drag.lock = {HandLock::Kind::axis, axis};
      const core::Vec3 way = 30.0 * core::Mat3{}.row[axis];
      const auto end = turned_camera.project(from + way);
      const HandMove move = hand_move(drag, end->x, end->y, false);
      expect_near(move.delta_world_m, way, 2.0 * move.resolution_m);
      for (std::size_t other = 0; other < 3; ++other)
        if (other != axis) {
          EXPECT_EQ(core::dot(move.delta_world_m, core::Mat3{}.row[other]), 0.0);
        }
      // Beside the axis the nearest point of it counts.
      const HandMove beside = hand_move(drag, end->x + 3.0, end->y + 2.0, false);
      for (std::size_t other = 0; other < 3; ++other)
        if (other != axis) {
          EXPECT_EQ(core::dot(beside.delta_world_m, core::Mat3{}.row[other]), 0.0);
        }
    }
}

TEST(HandMove, AnAxisSeenEndOnFollowsTheWayUp) {
  HandDrag drag = drag_of(camera_at(0.0), {});
  drag.lock = {HandLock::Kind::axis, 1};
  EXPECT_NEAR(hand_move(drag, 400.0, 260.0, false).delta_world_m.y, 20.0, 0.3);
}

TEST(HandMove, APlaneKeepsTheCoordinateAcrossIt) {
  HandDrag drag = drag_of(camera_at(30.0), {1.0, 2.0, 3.0});
  drag.lock = {HandLock::Kind::plane, 1};
  const HandMove move = hand_move(drag, drag.x_px + 50.0, drag.y_px - 40.0, false);
  EXPECT_EQ(move.delta_world_m.y, 0.0);
  expect_near(move.delta_world_m, {25.0, 0.0, 20.0 / std::cos(30.0 * deg)}, 2.0 * move.resolution_m);
}

TEST(HandMove, SnappedCoordinatesAreRoundAndOthersKeepTheirDigits) {
  HandDrag drag = drag_of(camera_at(30.0), {1.234, 2.345, 3.456});
  const HandMove move = hand_move(drag, drag.x_px + 51.0, drag.y_px - 7.0, true);
  EXPECT_EQ(move.resolution_m, 5.0);
  EXPECT_DOUBLE_EQ(1.234 + move.delta_world_m.x, 25.0);
  EXPECT_DOUBLE_EQ(2.345 + move.delta_world_m.y, 10.0);
  EXPECT_EQ(move.delta_world_m.z, 0.0);
}

TEST(HandMove, ATypedNumberIsTheWayAlongTheAxis) {
  HandDrag drag = drag_of(camera_at(30.0), {1.234, 0.0, 0.0});
  drag.lock = {HandLock::Kind::axis, 0};
  const auto moved = [&](const char* typed) {
    drag.typed = typed;
    return hand_move(drag, 1.0, 2.0, true).delta_world_m;
  };
  EXPECT_EQ(moved("12.5"), (core::Vec3{12.5, 0.0, 0.0}));
  EXPECT_EQ(moved("-3"), (core::Vec3{-3.0, 0.0, 0.0}));
  EXPECT_EQ(moved("2 km"), (core::Vec3{2000.0, 0.0, 0.0}));
  EXPECT_EQ(moved("2 k"), (core::Vec3{2.0, 0.0, 0.0}));
  EXPECT_EQ(moved("-"), core::Vec3{});
}

TEST(HandMove, AlongTheAxesOfATurnedPlatformWaysAreMeasuredInIts) {
  HandDrag drag = drag_of(camera_at(40.0), {});
  const double c = std::cos(30.0 * deg);
  const double s = std::sin(30.0 * deg);
  drag.axes_world = {core::Vec3{c, s, 0.0}, core::Vec3{-s, c, 0.0}, core::Vec3{0.0, 0.0, 1.0}};
  drag.lock = {HandLock::Kind::axis, 0};
  drag.typed = "100";
  expect_near(hand_move(drag, 0.0, 0.0, false).delta_world_m, 100.0 * drag.axes_world[0], 1e-12);
  drag.typed.clear();
  const auto end = drag.camera.project(52.0 * drag.axes_world[0]);
  expect_near(hand_move(drag, end->x, end->y, true).delta_world_m, 50.0 * drag.axes_world[0], 1e-9);
}

TEST(HandMove, TheMainAxisIsTheOneOfTheLongestWay) {
  EXPECT_EQ(main_axis(HandDrag{}, {1.0, -5.0, 2.0}), std::size_t{1});
  EXPECT_EQ(main_axis(HandDrag{}, {}), std::size_t{0});
}

// The ring about z seen from above: a quarter turn of the pointer is one of the thing.
TEST(HandTurn, TheThingTurnsAsThePointerDoesAboutIt) {
  Camera camera = preset(Camera::start(800.0, 600.0), ViewPreset::top);
  HandDrag drag = drag_of(camera, {});
  drag.x_px += 70.0;
  const core::Vec3 z{0.0, 0.0, 1.0};
  EXPECT_NEAR(hand_turn(drag, z, 0.0, 400.0, 230.0, false), 90.0 * deg, 1e-9);
  EXPECT_NEAR(hand_turn(drag, z, 0.0, 400.0, 370.0, false), -90.0 * deg, 1e-9);
  EXPECT_NEAR(hand_turn(drag, -z, 0.0, 400.0, 230.0, false), -90.0 * deg, 1e-9);
  camera.perspective = true;
  drag.camera = camera;
  EXPECT_NEAR(hand_turn(drag, z, 0.0, 400.0, 230.0, false), 90.0 * deg, 1e-9);
}

TEST(HandTurn, SnapsTheAngleItselfToFiveDegrees) {
  HandDrag drag = drag_of(preset(Camera::start(800.0, 600.0), ViewPreset::top), {});
  drag.x_px += 70.0;
  const double by = hand_turn(drag, {0.0, 0.0, 1.0}, 12.0 * deg, 470.0, 300.0 - 70.0 * std::tan(20.0 * deg), true);
  EXPECT_NEAR(by, 18.0 * deg, 1e-12);
}

TEST(HandTurn, ARingSeenFromItsEdgeTurnsAlongIt) {
  HandDrag drag = drag_of(camera_at(0.0), {});
  // The near side of a thing that turns to the left as seen from above comes to the right.
  EXPECT_NEAR(hand_turn(drag, {0.0, 0.0, 1.0}, 0.0, 400.0 + ring_px * 30.0 * deg, 300.0, false), 30.0 * deg, 1e-9);
}

TEST(HandTurn, ATypedNumberIsInDegrees) {
  HandDrag drag = drag_of(camera_at(30.0), {});
  drag.typed = "270";
  EXPECT_DOUBLE_EQ(hand_turn(drag, {0.0, 0.0, 1.0}, 0.3, 0.0, 0.0, true), 270.0 * deg);
}

TEST(HandWords, SayWhereAThingIsAndHowFarItHasCome) {
  HandDrag drag = drag_of(camera_at(30.0), {1000.0, 0.0, 0.0});
  HandMove move{{250.0, -30.0, 0.0}, 1.0, false};
  EXPECT_EQ(move_words(drag, move, {1250.0, -30.0, 0.0}), "x 1.25 km  y −30 m  z 0 m\nΔ 250 m, −30 m, 0 m");
  drag.lock = {HandLock::Kind::axis, 0};
  EXPECT_EQ(move_words(drag, move, {1250.0, -30.0, 0.0}), "x 1.25 km  y −30 m  z 0 m\nΔ 250 m along x");
  drag.typed = "-2 k";
  EXPECT_NE(move_words(drag, move, {}).find("Δ −2 k along x: typed"), std::string::npos);
  drag = drag_of(camera_at(0.0), {});
  move.upright = true;
  EXPECT_NE(move_words(drag, move, {}).find("seen from its edge"), std::string::npos);
  EXPECT_EQ(turn_words(drag, "yaw", 30.0 * deg, -45.0 * deg), "yaw −15°\nΔ −45°");
}

}  // namespace hand_drag_test
}  // namespace sarsim::picture
