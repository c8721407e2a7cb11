#include "picture/scene/gizmo.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "picture/scene/draw_scene.hpp"
#include "picture/scene/drawing.hpp"
#include "picture/scene/hand_drag.hpp"

namespace sarsim::picture {
namespace gizmo_test {

Gizmo gizmo_at(const core::Vec3& place_m) {
  Gizmo gizmo;
  gizmo.place_world_m = place_m;
  gizmo.rings = {{{1.0, 0.0, 0.0}, Role::x_axis}, {{0.0, 1.0, 0.0}, Role::y_axis}, {{0.0, 0.0, 1.0}, Role::z_axis}};
  return gizmo;
}

Camera slanted(bool perspective) {
  Camera camera = Camera::start(800.0, 600.0);
  camera.pixels_per_m = 0.5;
  camera.perspective = perspective;
  return camera;
}

using Kind = GizmoHandle::Kind;

TEST(Gizmo, EveryHandleIsFoundInItsMiddleWhateverTheCameraAndTheScreen) {
  for (const bool perspective : {false, true})
    for (const double pixel_scale : {1.0, 2.0}) {
      const Camera camera = slanted(perspective);
      Gizmo gizmo = gizmo_at({30.0, -50.0, 20.0});
      for (const Kind kind : {Kind::arrow, Kind::square, Kind::ring})
        for (std::size_t i = 0; i < 3; ++i) {
          gizmo.moves = kind != Kind::ring;  // Arrows cross the rings.
          const auto at = handle_point(gizmo, {kind, i}, camera, pixel_scale);
          ASSERT_TRUE(at);
          EXPECT_EQ(gizmo_handle_at(gizmo, camera, pixel_scale, at->x, at->y), (GizmoHandle{kind, i}));
        }
    }
}

TEST(Gizmo, TheThingItselfAndTheRestOfThePictureAreNoHandles) {
  const Camera camera = slanted(false);
  const Gizmo gizmo = gizmo_at({});
  EXPECT_FALSE(gizmo_handle_at(gizmo, camera, 1.0, 400.0, 300.0));
  EXPECT_FALSE(gizmo_handle_at(gizmo, camera, 1.0, 400.0, 300.0 - 140.0));
}

TEST(Gizmo, HasTheSameSizeWhateverTheScale) {
  Camera camera = slanted(false);
  const Gizmo gizmo = gizmo_at({});
  const auto near = handle_point(gizmo, {Kind::arrow, 2}, camera, 1.0);
  camera.pixels_per_m = 1e-3;
  const auto far = handle_point(gizmo, {Kind::arrow, 2}, camera, 1.0);
  EXPECT_DOUBLE_EQ(near->y, far->y);
  EXPECT_NEAR(300.0 - far->y, 58.0 * std::cos(camera.elevation_rad), 1e-9);
}

TEST(Gizmo, WhatIsSeenEndOnIsNoHandle) {
  const Camera above = preset(Camera::start(800.0, 600.0), ViewPreset::top);
  const Gizmo gizmo = gizmo_at({});
  EXPECT_FALSE(handle_point(gizmo, {Kind::arrow, 2}, above, 1.0));
  EXPECT_FALSE(handle_point(gizmo, {Kind::square, 0}, above, 1.0));
  EXPECT_TRUE(handle_point(gizmo, {Kind::square, 2}, above, 1.0));
  EXPECT_TRUE(handle_point(gizmo, {Kind::arrow, 0}, above, 1.0));
}

// Of a ring that is seen at an angle the half behind the thing is none.
TEST(Gizmo, OnlyTheNearHalfOfARingIsAHandle) {
  const Camera camera = slanted(false);
  Gizmo gizmo = gizmo_at({});
  gizmo.moves = false;
  gizmo.rings = {{{0.0, 0.0, 1.0}, Role::z_axis}};
  const auto near = handle_point(gizmo, {Kind::ring, 0}, camera, 1.0);
  EXPECT_GT(near->y, 300.0);
  EXPECT_FALSE(gizmo_handle_at(gizmo, camera, 1.0, near->x, 600.0 - near->y));
}

TEST(Gizmo, IsDrawnAboveTheSceneWithTheHandleUnderThePointerApart) {
  DrawingOptions options;
  options.coordinate_systems = options.corner_triad = false;
  Drawing drawing;
  const Camera camera = slanted(false);
  draw_scene({}, camera, options, drawing);
  EXPECT_TRUE(drawing.lines.empty());
  options.gizmo = gizmo_at({});
  draw_scene({}, camera, options, drawing);
  const auto lines_of = [&](Role role) {
    return std::ranges::count_if(drawing.lines, [&](const Drawing::Line& line) { return line.role == role; });
  };
  EXPECT_GT(lines_of(Role::x_axis), 0);
  EXPECT_EQ(lines_of(Role::hovered), 0);
  options.hovered_handle = GizmoHandle{Kind::arrow, 1};
  draw_scene({}, camera, options, drawing);
  EXPECT_GT(lines_of(Role::hovered), 0);
}

}  // namespace gizmo_test
}  // namespace sarsim::picture
