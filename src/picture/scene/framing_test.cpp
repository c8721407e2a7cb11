#include "picture/scene/framing.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "picture/scene/draw_scene.hpp"

namespace sarsim::picture {
namespace framing_test {

scene::ObjectId target_id(std::size_t index) { return {scene::ObjectKind::target, index}; }

Snapshot targets_at(const std::vector<core::Vec3>& places_m) {
  Snapshot snapshot;
  for (const core::Vec3& place : places_m)
    snapshot.targets.push_back({target_id(snapshot.targets.size()), place, place, {}, false});
  return snapshot;
}

struct Box {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  void add(double x, double y) {
    left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
  }
};

// Everything that is drawn, words with an estimate of their width, without the corner triad and the scale bar.
Box drawn_box(const Drawing& drawing) {
  Box box;
  for (const Drawing::Line& line : drawing.lines)
    box.add(static_cast<double>(line.x0), static_cast<double>(line.y0)),
        box.add(static_cast<double>(line.x1), static_cast<double>(line.y1));
  for (const Drawing::Text& text : drawing.texts) {
    const double half = 0.5 * 7.0 * static_cast<double>(text.text.size());
    box.add(static_cast<double>(text.x) - half, static_cast<double>(text.y) - 10.0);
    box.add(static_cast<double>(text.x) + half, static_cast<double>(text.y));
  }
  return box;
}

TEST(Framing, ShowAllLeavesNoAxisAndNoNameCut) {
  for (const bool perspective : {false, true}) {
    Snapshot snapshot = targets_at({{0.0, 0.0, 0.0}, {3000.0, -2000.0, 0.0}});
    Snapshot::Platform plane;
    plane.id = {scene::ObjectKind::platform, 0};
    plane.name = "A plane with a long name";
    plane.pose.position_world_m = {-4000.0, 1000.0, 2500.0};
    snapshot.platforms = {plane};
    Camera camera = Camera::start(800.0, 600.0);
    camera.perspective = perspective;
    DrawingOptions options;
    options.corner_triad = false;
    options.elevation_lines = false;
    const Camera shown = showing_all(camera, snapshot, options);
    EXPECT_EQ(shown.azimuth_rad, camera.azimuth_rad);
    Drawing drawing;
    draw_scene(snapshot, shown, options, drawing);
    const Box box = drawn_box(drawing);
    EXPECT_GE(box.left, 0.0);
    EXPECT_GE(box.top, 0.0);
    EXPECT_LE(box.right, 800.0);
    EXPECT_LE(box.bottom, 600.0);
    // And it is no smaller than need be.
    EXPECT_GT(std::max((box.right - box.left) / 800.0, (box.bottom - box.top) / 600.0), 0.8);
  }
}

// A ship 8 km off, in pictures of many sizes.
TEST(Framing, ShowAllKeepsEverythingFromUnderTheCornerTriad) {
  const core::Vec3 ship_m{0.0, 8000.0, 0.0};
  const Snapshot snapshot = targets_at({{0.0, 0.0, 0.0}, ship_m, {30.0, 8003.0, 3.0}});
  int under = 0;
  for (const double scale : {1.0, 2.0})
    for (double width = 320.0; width < 900.0; width += 60.0)
      for (double height = 300.0; height < 1000.0; height += 50.0) {
        const Camera camera = Camera::start(scale * width, scale * height);
        DrawingOptions options;
        options.pixel_scale = scale;
        const auto is_under = [&](const Camera& shown) {
          const auto at = shown.project(ship_m);
          EXPECT_TRUE(at->x > 0.0 && at->x < camera.width_px && at->y > 0.0 && at->y < camera.height_px);
          return at->x > camera.width_px - 90.0 * scale && at->y > camera.height_px - 90.0 * scale;
        };
        options.corner_triad = false;
        if (is_under(showing_all(camera, snapshot, options))) ++under;
        options.corner_triad = true;
        EXPECT_FALSE(is_under(showing_all(camera, snapshot, options))) << width << " x " << height;
      }
  EXPECT_GT(under, 0);
}

// What Show All makes of pictures of many sizes, at both scales; told in pixels of the screen.
template <class Look>
void for_sizes(const Snapshot& snapshot, double narrowest, const Look& look) {
  for (const double scale : {1.0, 2.0})
    for (double width = narrowest; width < 1500.0; width += 50.0)
      for (double height = 350.0; height < 1000.0; height += 50.0) {
        SCOPED_TRACE(testing::Message() << width << " x " << height << ", " << scale);
        DrawingOptions options;
        options.pixel_scale = scale;
        Drawing drawing;
        draw_scene(snapshot, showing_all(Camera::start(scale * width, scale * height), snapshot, options), options,
                   drawing);
        look(drawing, scale, height);
      }
}

// A target behind the origin: the letter of an axis is at the lower left. In lower pictures there is no room for both.
TEST(Framing, ShowAllKeepsTheLettersOfAxesFromTheScaleBar) {
  for_sizes(targets_at({{0.0, 0.0, 0.0}, {-4000.0, 4000.0, 0.0}}), 500.0,
            [](const Drawing& drawing, double scale, double height) {
              for (const Drawing::Text& text : drawing.texts) {
                const bool letter = text.text == "X" || text.text == "Y" || text.text == "Z";
                const bool low = static_cast<double>(text.y) > scale * (height - 36.0);
                EXPECT_FALSE(letter && low && static_cast<double>(text.x) < 150.0 * scale) << text.text;
              }
            });
}

// The origin is at the right, and the letter of an axis would be among those of the triad, where it is left out.
TEST(Framing, ShowAllKeepsTheLettersOfAxesFromTheCornerTriad) {
  for_sizes(targets_at({{0.0, 0.0, 0.0}, {-2000.0, -8000.0, 3000.0}}), 700.0,
            [](const Drawing& drawing, double, double) {
              for (const char* const letter : {"X", "Y", "Z"})
                EXPECT_EQ(std::ranges::count(drawing.texts, letter, &Drawing::Text::text), 2) << letter;
            });
}

TEST(Framing, WhatIsSelectedFillsThePicture) {
  const Snapshot snapshot = targets_at({{0.0, 0.0, 0.0}, {9000.0, 0.0, 0.0}, {9010.0, 0.0, 0.0}, {9000.0, 10.0, 0.0}});
  const Camera above = preset(Camera::start(800.0, 600.0), ViewPreset::top);
  const Camera shown = showing(above, snapshot, {target_id(1), target_id(2), target_id(3)}, 1.0);
  const auto a = shown.project({9000.0, 0.0, 0.0});
  const auto b = shown.project({9010.0, 10.0, 0.0});
  EXPECT_NEAR(a->y - b->y, 0.8 * (600.0 - 80.0), 1.0);
  EXPECT_NEAR(a->x + b->x, 800.0, 1e-3);
}

TEST(Framing, ASinglePointIsShownWithWhatIsAboutIt) {
  const Snapshot snapshot = targets_at({{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {9000.0, 0.0, 0.0}});
  const Camera above = preset(Camera::start(800.0, 600.0), ViewPreset::top);
  const Camera shown = showing(above, snapshot, {target_id(0)}, 1.0);
  EXPECT_NEAR(shown.project({0.0, 0.0, 0.0})->x, 400.0, 1e-6);
  EXPECT_NEAR(shown.project({0.0, 50.0, 0.0})->y, 300.0 - 0.4 * (600.0 - 80.0), 1.0);
}

TEST(Framing, ALonelyPointAndNoneKeepTheScale) {
  const Camera camera = Camera::start(800.0, 600.0);
  const Camera shown = showing(camera, targets_at({{5.0, 6.0, 7.0}}), {target_id(0)}, 1.0);
  EXPECT_EQ(shown.pixels_per_m, camera.pixels_per_m);
  EXPECT_NEAR(shown.focus_world_m.z, 7.0, 1e-9);
  EXPECT_EQ(showing(camera, targets_at({{5.0, 6.0, 7.0}}), {target_id(8)}, 1.0).focus_world_m, camera.focus_world_m);
}

TEST(Framing, ADotInThePictureAndWhatIsOutsideAreNotShownWell) {
  Camera above = preset(Camera::start(800.0, 600.0), ViewPreset::top);
  above.pixels_per_m = 1.0;
  EXPECT_TRUE(shows_well(above, {{-100.0, 0.0, 0.0}, {100.0, 0.0, 0.0}}));
  EXPECT_FALSE(shows_well(above, {{-10.0, 0.0, 0.0}, {10.0, 0.0, 0.0}}));
  EXPECT_FALSE(shows_well(above, {{-100.0, 0.0, 0.0}, {500.0, 0.0, 0.0}}));
}

TEST(Framing, TheViewAlongABeamHasItsMiddleInTheMiddle) {
  const core::Vec3 antenna{0.0, -5000.0, 3000.0};
  const core::Vec3 axis = (1.0 / core::norm(antenna)) * -antenna;
  const double width = 10.0 * core::rad_per_deg;
  const Camera view = along_beam(Camera::start(800.0, 600.0), antenna, axis, width, core::norm(antenna));
  EXPECT_NEAR(view.project({})->x, 400.0, 1e-6);
  EXPECT_NEAR(view.project({})->y, 300.0, 1e-6);
  // The edge of the beam is a sixth of the height from there.
  const core::Vec3 across{1.0, 0.0, 0.0};
  const core::Vec3 edge = antenna + 1000.0 * axis + 1000.0 * std::tan(0.5 * width) * across;
  EXPECT_NEAR(std::abs(view.project(edge)->x - 400.0), 100.0, 0.1);
  const core::Vec3 eye =
      view.focus_world_m + view.viewer_distance_m() * core::direction(view.azimuth_rad, view.elevation_rad);
  EXPECT_LT(core::norm(eye - antenna), 1e-6);
  EXPECT_EQ(preset(view, ViewPreset::start).heights_away, distance_in_heights);
}

}  // namespace framing_test
}  // namespace sarsim::picture
