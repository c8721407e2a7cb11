#include "picture/scene/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "picture/scene/draw_scene.hpp"
#include "support/processor_time.hpp"

namespace sarsim::picture {
namespace drawing_test {

constexpr double deg = core::pi / 180.0;

// Looks along +y at 1 px/m: x to the right, z up, the origin at (400, 300).
Camera front_camera() {
  Camera camera = preset(Camera::start(800, 600), ViewPreset::front);
  camera.pixels_per_m = 1.0;
  return camera;
}

// Nothing but the objects.
DrawingOptions bare_options() {
  DrawingOptions options;
  options.coordinate_systems = false;
  options.corner_triad = false;
  options.labels = false;
  return options;
}

Drawing drawn(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options) {
  Drawing drawing;
  draw_scene(snapshot, camera, options, drawing);
  return drawing;
}

Snapshot::Target target_at(std::size_t index, const core::Vec3& position_m) {
  Snapshot::Target target;
  target.id = {scene::ObjectKind::target, index};
  target.position_world_m = position_m;
  target.foot_world_m = {position_m.x, position_m.y, 0.0};
  return target;
}

Snapshot::Radar radar_along_y(double azimuth_width, double elevation_width) {
  Snapshot::Radar radar{};
  radar.id = {scene::ObjectKind::radar, 0};
  radar.name = "Radar1";
  radar.axis_world = {0, 1, 0};
  radar.across_world = {1, 0, 0};
  radar.azimuth_width_rad = azimuth_width;
  radar.elevation_width_rad = elevation_width;
  radar.isotropic = false;
  return radar;
}

Snapshot::Platform platform_at(std::string name, const core::Vec3& position_m) {
  Snapshot::Platform platform;
  platform.id = {scene::ObjectKind::platform, 0};
  platform.name = std::move(name);
  platform.pose.position_world_m = position_m;
  return platform;
}

Snapshot::Surface surface_of(const std::array<core::Vec3, 3>& corners, const core::Vec3& normal,
                             std::size_t index = 0) {
  return {{scene::ObjectKind::surface, index}, corners, normal};
}

std::vector<Drawing::Line> lines_of(const Drawing& drawing, Role role) {
  std::vector<Drawing::Line> lines;
  for (const Drawing::Line& line : drawing.lines)
    if (line.role == role) lines.push_back(line);
  return lines;
}

const Drawing::Text* text_of(const Drawing& drawing, const std::string& words) {
  for (const Drawing::Text& text : drawing.texts)
    if (text.text == words) return &text;
  return nullptr;
}

double length_of(const Drawing::Line& line) {
  return std::hypot(static_cast<double>(line.x1 - line.x0), static_cast<double>(line.y1 - line.y0));
}

// --- Axes -----------------------------------------------------------------------------------------------------------

TEST(Drawing, MainAxesAre200PixelsLongWithAMarkAtARoundDistance) {
  DrawingOptions options = bare_options();
  options.coordinate_systems = true;
  options.labels = true;
  Camera camera = front_camera();
  camera.pixels_per_m = 0.01;  // 200 px are 20 km: the mark stands at 10 km
  const Drawing drawing = drawn({}, camera, options);
  const auto x = lines_of(drawing, Role::x_axis);
  ASSERT_EQ(x.size(), 1U);
  EXPECT_NEAR(x[0].x0, 400.0, 1e-3);
  EXPECT_NEAR(x[0].x1, 600.0, 1e-3);
  EXPECT_NEAR(x[0].y1, 300.0, 1e-3);
  EXPECT_EQ(x[0].width_px, 2.0F);
  EXPECT_NEAR(lines_of(drawing, Role::z_axis).at(0).y1, 100.0, 1e-3);
  ASSERT_EQ(drawing.discs.size(), 2U);  // y is seen end on
  EXPECT_NEAR(drawing.discs[0].x, 500.0, 1e-3);
  EXPECT_TRUE(text_of(drawing, "10 km"));
  ASSERT_TRUE(text_of(drawing, "X"));
  EXPECT_NEAR(text_of(drawing, "X")->x, 614.0, 1e-3);
  EXPECT_TRUE(text_of(drawing, "X")->bold);
  EXPECT_TRUE(text_of(drawing, "Z"));
  EXPECT_FALSE(text_of(drawing, "Y"));
}

TEST(Drawing, MainAxesMoveWithTheFocusAndTheTriadDoesNot) {
  DrawingOptions options = bare_options();
  options.corner_triad = true;
  Camera camera = front_camera();
  const Drawing before = drawn({}, camera, options);
  camera.focus_world_m = {50, 0, 0};
  const Drawing after = drawn({}, camera, options);
  ASSERT_EQ(before.lines.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(before.lines[i].x1, after.lines[i].x1);
  EXPECT_NEAR(length_of(before.lines[0]), 30.0, 1e-3);
  EXPECT_GT(before.lines[0].x0, 700.0F);
  EXPECT_GT(before.lines[0].y0, 500.0F);
  options.coordinate_systems = true;
  options.corner_triad = false;
  EXPECT_NEAR(lines_of(drawn({}, camera, options), Role::x_axis).at(0).x0, 350.0, 1e-3);
}

TEST(Drawing, ScaleBarHasARoundLength) {
  DrawingOptions options = bare_options();
  options.coordinate_systems = true;
  Camera camera = front_camera();
  camera.pixels_per_m = 0.7;  // 120 px are 171 m
  const Drawing drawing = drawn({}, camera, options);
  ASSERT_TRUE(text_of(drawing, "100 m"));
  EXPECT_NEAR(length_of(lines_of(drawing, Role::text).at(0)), 70.0, 1e-3);
}

// --- Targets --------------------------------------------------------------------------------------------------------

TEST(Drawing, TargetIsARimmedDiscWithItsDropLine) {
  Snapshot snapshot;
  snapshot.targets = {target_at(0, {100, 0, 50})};
  const Drawing drawing = drawn(snapshot, front_camera(), bare_options());
  ASSERT_EQ(drawing.discs.size(), 1U);
  EXPECT_NEAR(drawing.discs[0].x, 500.0, 1e-3);
  EXPECT_NEAR(drawing.discs[0].y, 250.0, 1e-3);
  EXPECT_EQ(drawing.discs[0].diameter_px, 7.0F);
  EXPECT_EQ(drawing.discs[0].role, Role::target);
  EXPECT_TRUE(drawing.discs[0].outlined);
  ASSERT_EQ(drawing.lines.size(), 1U);
  EXPECT_TRUE(drawing.lines[0].dotted);
  EXPECT_NEAR(drawing.lines[0].y1, 300.0, 1e-3);
  DrawingOptions options = bare_options();
  options.elevation_lines = false;
  EXPECT_TRUE(drawn(snapshot, front_camera(), options).lines.empty());
}

TEST(Drawing, DirectionalTargetCarriesItsNormal) {
  Snapshot snapshot;
  snapshot.targets = {target_at(0, {0, 0, 0})};
  snapshot.targets[0].directional = true;
  snapshot.targets[0].normal_world = {0.6, 0, 0.8};
  const auto lines = lines_of(drawn(snapshot, front_camera(), bare_options()), Role::target);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].x1, 412.0, 1e-3);
  EXPECT_NEAR(lines[0].y1, 284.0, 1e-3);
}

TEST(Drawing, SelectedAndHoveredTargetsAreLargerAndHaveTheirRole) {
  Snapshot snapshot;
  snapshot.targets = {target_at(0, {0, 0, 0}), target_at(1, {9, 0, 0}), target_at(2, {99, 0, 0})};
  DrawingOptions options = bare_options();
  options.selected = {snapshot.targets[1].id};
  options.hovered = snapshot.targets[2].id;
  const Drawing drawing = drawn(snapshot, front_camera(), options);
  ASSERT_EQ(drawing.discs.size(), 3U);
  EXPECT_EQ(drawing.discs[1].role, Role::selected);
  EXPECT_EQ(drawing.discs[2].role, Role::hovered);
  EXPECT_GT(drawing.discs[1].diameter_px, drawing.discs[0].diameter_px);
  EXPECT_GT(drawing.discs[2].diameter_px, drawing.discs[1].diameter_px);
}

TEST(Drawing, HiddenObjectsLeaveNoMarkAndNoHandle) {
  Snapshot snapshot;
  snapshot.targets = {target_at(3, {0, 0, 10})};
  snapshot.radars = {radar_along_y(0.1, 0.1)};
  snapshot.platforms = {platform_at("Plane", {0, 0, 10})};
  snapshot.surfaces = {surface_of({core::Vec3{0, 0, 0}, core::Vec3{9, 0, 0}, core::Vec3{0, 0, 9}}, {0, -1, 0})};
  DrawingOptions options = bare_options();
  options.hidden = {snapshot.targets[0].id, snapshot.radars[0].id, snapshot.platforms[0].id, snapshot.surfaces[0].id};
  const Drawing drawing = drawn(snapshot, front_camera(), options);
  EXPECT_TRUE(drawing.discs.empty());
  EXPECT_TRUE(drawing.lines.empty());
  EXPECT_TRUE(drawing.solids.empty());
  EXPECT_TRUE(drawing.texts.empty());
  EXPECT_TRUE(drawing.handles.empty());
}

TEST(Drawing, FartherTargetsAreDrawnFirst) {
  Snapshot snapshot;
  snapshot.targets = {target_at(0, {0, -50, 0}), target_at(1, {1, 70, 0}), target_at(2, {2, 10, 0})};
  const Drawing drawing = drawn(snapshot, front_camera(), bare_options());
  ASSERT_EQ(drawing.handles.size(), 3U);
  EXPECT_EQ(drawing.handles[0].id.index, 1U);
  EXPECT_EQ(drawing.handles[1].id.index, 2U);
  EXPECT_EQ(drawing.handles[2].id.index, 0U);
}

TEST(Drawing, CoarseDrawingLeavesOutTargetsButNoneThatIsSelected) {
  Snapshot snapshot;
  for (std::size_t i = 0; i < 10'001; ++i)
    snapshot.targets.push_back(target_at(i, {0.01 * static_cast<double>(i), 0, 5}));
  DrawingOptions options = bare_options();
  options.selected = {{scene::ObjectKind::target, 9'998}};
  options.coarse = true;
  const Drawing coarse = drawn(snapshot, front_camera(), options);
  EXPECT_LE(coarse.discs.size(), coarse_targets + 1);
  EXPECT_GT(coarse.discs.size(), coarse_targets / 2);
  EXPECT_TRUE(coarse.lines.empty());
  EXPECT_EQ(std::ranges::count(coarse.discs, Role::selected, &Drawing::Disc::role), 1);
  options.coarse = false;
  EXPECT_EQ(drawn(snapshot, front_camera(), options).discs.size(), 10'001U);
}

TEST(Drawing, PixelScaleScalesMarksAndNotPlaces) {
  Snapshot snapshot;
  snapshot.targets = {target_at(0, {100, 0, 0})};
  DrawingOptions options = bare_options();
  options.pixel_scale = 2.0;
  const Drawing drawing = drawn(snapshot, front_camera(), options);
  EXPECT_EQ(drawing.discs.at(0).diameter_px, 14.0F);
  EXPECT_NEAR(drawing.discs.at(0).x, 500.0, 1e-3);
}

// --- Radars ---------------------------------------------------------------------------------------------------------

TEST(Drawing, BeamIsAConeOf50PixelsWithSixteenPointsAndFourRibs) {
  Snapshot snapshot;
  snapshot.radars = {radar_along_y(20.0 * deg, 60.0 * deg)};
  const Drawing from_side = drawn(
      snapshot,
      [] {
        Camera camera = front_camera();
        return preset(camera, ViewPreset::side);
      }(),
      bare_options());
  const auto lines = lines_of(from_side, Role::beam);
  ASSERT_EQ(lines.size(), 16U + 4U + 1U);
  // Seen along -x, y runs to the right: the axis ends 50 px from the apex.
  EXPECT_NEAR(lines[20].x1, 450.0, 1e-3);
  EXPECT_NEAR(lines[20].y1, 300.0, 1e-3);
  // Seen along the beam the rim is an ellipse with half-axes 50 sin(width/2).
  const Drawing along = drawn(snapshot, front_camera(), bare_options());
  double widest = 0.0;
  double highest = 0.0;
  for (const Drawing::Line& line : lines_of(along, Role::beam)) {
    widest = std::max(widest, std::abs(static_cast<double>(line.x0) - 400.0));
    highest = std::max(highest, std::abs(static_cast<double>(line.y0) - 300.0));
  }
  EXPECT_NEAR(widest, 50.0 * std::sin(10.0 * deg), 1e-3);
  EXPECT_NEAR(highest, 50.0 * std::sin(30.0 * deg), 1e-3);
}

TEST(Drawing, IsotropicRadarHasACircleOf20Pixels) {
  Snapshot snapshot;
  snapshot.radars = {radar_along_y(1.0, 1.0)};
  snapshot.radars[0].isotropic = true;
  const Drawing drawing = drawn(snapshot, front_camera(), bare_options());
  for (const Drawing::Line& line : lines_of(drawing, Role::beam))
    EXPECT_NEAR(std::hypot(line.x0 - 400.0F, line.y0 - 300.0F), 10.0F, 1e-3F);
  EXPECT_EQ(drawing.discs.at(0).diameter_px, 10.0F);
  EXPECT_EQ(drawing.discs.at(0).role, Role::radar);
}

TEST(Drawing, LobesReplaceConesExceptInCoarseDrawings) {
  Snapshot snapshot;
  snapshot.radars = {radar_along_y(1.0, 1.0)};
  snapshot.radars[0].lobe_world.assign(25, std::vector<core::Vec3>(49, core::Vec3{0, 0, 1}));
  DrawingOptions options = bare_options();
  const std::size_t cone = drawn(snapshot, front_camera(), options).lines.size();
  options.lobes = true;
  const Drawing lobe = drawn(snapshot, front_camera(), options);
  EXPECT_GT(lobe.lines.size(), cone);
  EXPECT_NEAR(lobe.lines.front().y0, 240.0, 1e-3);  // 60 px up
  options.coarse = true;
  EXPECT_EQ(drawn(snapshot, front_camera(), options).lines.size(), cone);
}

// --- Platforms ------------------------------------------------------------------------------------------------------

TEST(Drawing, MainAxesEndBeforeTheCornerTriad) {
  DrawingOptions options = bare_options();
  options.coordinate_systems = true;
  Camera camera = front_camera();
  camera.focus_world_m = {-250.0, 0.0, 250.0};  // the origin at (650, 550), the triad's at (750, 550)
  const auto alone = lines_of(drawn({}, camera, options), Role::x_axis);
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_NEAR(alone[0].x1, 850.0, 1e-3);
  options.corner_triad = true;
  const Drawing drawing = drawn({}, camera, options);
  EXPECT_NEAR(lines_of(drawing, Role::x_axis).at(0).x1, 702.0, 1e-3);
  EXPECT_EQ(lines_of(drawing, Role::x_axis).size(), 2U);  // and its own
  EXPECT_NEAR(lines_of(drawing, Role::z_axis).at(0).y1, 350.0, 1e-3);
}

TEST(Drawing, TheEdgeOfThePictureCutsNoLetterOfAMainAxis) {
  DrawingOptions options = bare_options();
  options.coordinate_systems = true;
  Camera camera = front_camera();
  camera.focus_world_m = {-188.0, 0.0, 0.0};  // the origin at (588, 300), the letter of x at (802, 300)
  const Drawing near_edge = drawn({}, camera, options);
  ASSERT_TRUE(text_of(near_edge, "X"));
  EXPECT_NEAR(text_of(near_edge, "X")->x, 788.0, 1e-3);
  camera.focus_world_m = {-230.0, 0.0, 0.0};  // the letter at (844, 300), out of sight
  const Drawing beyond = drawn({}, camera, options);
  ASSERT_TRUE(text_of(beyond, "X"));
  EXPECT_NEAR(text_of(beyond, "X")->x, 844.0, 1e-3);
}

TEST(Drawing, LabelsOfMainAxesStandBesideTheirAxes) {
  DrawingOptions options = bare_options();
  options.coordinate_systems = true;
  options.labels = true;
  const Drawing drawing = drawn({}, front_camera(), options);
  std::vector<Drawing::Text> labels;
  for (const Drawing::Text& text : drawing.texts)
    if (text.text == "100 m" && text.role == Role::text) labels.push_back(text);
  ASSERT_EQ(labels.size(), 3U);  // x, z and the scale bar
  EXPECT_TRUE(labels[0].centred);
  EXPECT_NEAR(labels[0].x, 500.0, 1e-3);
  EXPECT_GT(labels[0].y, 315.0F);
  EXPECT_FALSE(labels[1].centred);
  EXPECT_GT(labels[1].x, 408.0F);
  EXPECT_NEAR(labels[1].y, 204.0, 1e-3);
}

TEST(Drawing, PlatformShowsItsOwnAxesAndItsNameAbove) {
  Snapshot snapshot;
  snapshot.platforms = {platform_at("Plane", {0, 0, 100})};
  snapshot.platforms[0].pose.world_from_platform = radar::world_from_platform({0.0, -90.0 * deg, 0.0});
  DrawingOptions options = bare_options();
  options.coordinate_systems = true;
  options.labels = true;
  const Drawing drawing = drawn(snapshot, front_camera(), options);
  const core::Vec3 x_axis = snapshot.platforms[0].pose.world_from_platform * core::Vec3{1, 0, 0};
  const Drawing::Line line = lines_of(drawing, Role::x_axis).back();
  EXPECT_NEAR(line.x1, 400.0 + 50.0 * x_axis.x, 1e-3);
  EXPECT_NEAR(line.y1, 200.0 - 50.0 * x_axis.z, 1e-3);
  const Drawing::Text* name = text_of(drawing, "Plane");
  ASSERT_TRUE(name);
  EXPECT_LT(name->y, 200.0F);
  EXPECT_TRUE(name->centred);
  const auto drops = lines_of(drawing, Role::faint);
  ASSERT_EQ(drops.size(), 1U);
  EXPECT_NEAR(drops[0].y1, 300.0, 1e-3);
}

TEST(Drawing, EarthShowsItsNameAlone) {
  Snapshot snapshot;
  snapshot.platforms = {platform_at("EARTH", {0, 0, 100})};
  DrawingOptions options = bare_options();
  options.labels = true;
  options.elevation_lines = false;
  const Drawing drawing = drawn(snapshot, front_camera(), options);
  EXPECT_TRUE(drawing.lines.empty());
  EXPECT_TRUE(drawing.discs.empty());
  EXPECT_EQ(drawing.texts.size(), 1U);
}

TEST(Drawing, TrailFollowsThePath) {
  Snapshot snapshot;
  snapshot.platforms = {platform_at("Plane", {})};
  snapshot.platforms[0].trail_world_m = {{-10, 0, 0}, {0, 0, 10}, {10, 0, 0}};
  DrawingOptions options = bare_options();
  const auto trail = lines_of(drawn(snapshot, front_camera(), options), Role::faint);
  ASSERT_EQ(trail.size(), 2U);
  EXPECT_NEAR(trail[0].x0, 390.0, 1e-3);
  EXPECT_NEAR(trail[0].y1, 290.0, 1e-3);
  options.trails = false;
  EXPECT_TRUE(lines_of(drawn(snapshot, front_camera(), options), Role::faint).empty());
}

// --- Surfaces -------------------------------------------------------------------------------------------------------

// The colour of solids at a pixel.
std::uint32_t solid_at(const Drawing& drawing, int x, int y) {
  const Rendering& r = drawing.solids;
  if (x < r.left || y < r.top || x >= r.left + r.width || y >= r.top + r.height) return 0;
  return r.argb.at(static_cast<std::size_t>(y - r.top) * static_cast<std::size_t>(r.width) +
                   static_cast<std::size_t>(x - r.left));
}

std::uint32_t opaque_grey(std::uint8_t shade) {
  const raster::Rgb grey = surface_fill(shade, false);
  return 0xFF000000U | (std::uint32_t{grey.red} << 16U) | (std::uint32_t{grey.green} << 8U) | grey.blue;
}

TEST(Drawing, FilledSurfaceIsGreyByTheElevationOfItsNormalAndWhiteFromBelow) {
  const std::array<core::Vec3, 3> corners{core::Vec3{0, 0, 0}, core::Vec3{50, 0, 0}, core::Vec3{0, 0, 50}};
  DrawingOptions options = bare_options();
  options.filled_surfaces = true;
  const auto seen = [&](const core::Vec3& normal) {
    Snapshot snapshot;
    snapshot.surfaces = {surface_of(corners, normal)};
    return solid_at(drawn(snapshot, front_camera(), options), 410, 290);
  };
  EXPECT_EQ(seen({0, 0, 1}), opaque_grey(254));
  EXPECT_EQ(seen({0, -1, 0}), opaque_grey(100));
  EXPECT_EQ(seen({0, -std::sqrt(0.5), std::sqrt(0.5)}), opaque_grey(177));
  EXPECT_EQ(seen({0, 0, -1}), opaque_grey(255));
  options.filled_surfaces = false;
  EXPECT_EQ(seen({0, 0, 1}), 0U);
}

TEST(Drawing, TheNearestSurfaceIsSeenWherePartsOfTwoAreInFrontOfEachOther) {
  // Two that cross along the line x = 20: no order of painting shows both parts.
  Snapshot snapshot;
  snapshot.surfaces = {
      surface_of({core::Vec3{0, -20, 0}, core::Vec3{40, 20, 0}, core::Vec3{20, 0, 40}}, {0, 0, 1}, 0),
      surface_of({core::Vec3{0, 20, 0}, core::Vec3{40, -20, 0}, core::Vec3{20, 0, 40}}, {0, -1, 0}, 1)};
  DrawingOptions options = bare_options();
  options.filled_surfaces = true;
  const Drawing drawing = drawn(snapshot, front_camera(), options);
  EXPECT_EQ(solid_at(drawing, 412, 294), opaque_grey(254));
  EXPECT_EQ(solid_at(drawing, 428, 294), opaque_grey(100));
  EXPECT_EQ(picked(drawing, snapshot, front_camera(), 412.5, 294.5, 0.5), snapshot.surfaces[0].id);
  EXPECT_EQ(picked(drawing, snapshot, front_camera(), 428.5, 294.5, 0.5), snapshot.surfaces[1].id);
}

TEST(Drawing, FilledSurfacesHideWhatIsBehindThemAndOutlinesDoNot) {
  Snapshot snapshot;
  snapshot.surfaces = {surface_of({core::Vec3{-50, 0, -50}, core::Vec3{50, 0, -50}, core::Vec3{0, 0, 50}}, {0, -1, 0})};
  snapshot.targets = {target_at(0, {0, 10, 0}), target_at(1, {0, -10, 0}), target_at(2, {0, 0, 0})};
  snapshot.platforms = {platform_at("Plane", {300, 0, 0})};
  snapshot.platforms[0].trail_world_m = {{-100, 10, 0}, {100, 10, 0}};
  DrawingOptions options = bare_options();
  options.elevation_lines = false;
  const auto targets_seen = [&] {
    const Drawing drawing = drawn(snapshot, front_camera(), options);
    return std::ranges::count_if(
        drawing.handles, [](const Drawing::Handle& handle) { return handle.id.kind == scene::ObjectKind::target; });
  };
  EXPECT_EQ(targets_seen(), 3);
  EXPECT_EQ(lines_of(drawn(snapshot, front_camera(), options), Role::faint).size(), 1U);
  options.filled_surfaces = true;
  EXPECT_EQ(targets_seen(), 2) << "that on the surface is seen";
  const auto trail = lines_of(drawn(snapshot, front_camera(), options), Role::faint);
  ASSERT_EQ(trail.size(), 2U);
  EXPECT_NEAR(trail[0].x0, 300.0, 1e-3);
  EXPECT_NEAR(trail[0].x1, 375.0, 4.0);  // the edge at half the height
  EXPECT_NEAR(trail[1].x0, 425.0, 4.0);
  EXPECT_NEAR(trail[1].x1, 500.0, 1e-3);
  options.selected = {snapshot.targets[0].id};
  EXPECT_EQ(targets_seen(), 3) << "what is selected is always seen";
}

TEST(Drawing, SurfaceCarriesItsNormalAtItsCentroid) {
  Snapshot snapshot;
  snapshot.surfaces = {surface_of({core::Vec3{0, 0, 0}, core::Vec3{30, 0, 0}, core::Vec3{0, 0, 30}}, {1, 0, 0})};
  const auto normal = lines_of(drawn(snapshot, front_camera(), bare_options()), Role::z_axis);
  ASSERT_EQ(normal.size(), 1U);
  EXPECT_NEAR(normal[0].x0, 410.0, 1e-3);
  EXPECT_NEAR(normal[0].y0, 290.0, 1e-3);
  EXPECT_NEAR(normal[0].x1, 430.0, 1e-3);
}

// --- Any scene ------------------------------------------------------------------------------------------------------

Snapshot random_snapshot(unsigned seed, double size_m) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> side(-size_m, size_m);
  const auto point = [&] { return core::Vec3{side(random), side(random), side(random)}; };
  Snapshot snapshot;
  for (std::size_t i = 0; i < 100; ++i) snapshot.targets.push_back(target_at(i, point()));
  for (std::size_t i = 0; i < 20; ++i)
    snapshot.surfaces.push_back(surface_of({point(), point(), point()}, {0, 0, 1}, i));
  snapshot.platforms = {platform_at("Plane", point())};
  snapshot.platforms[0].trail_world_m = {point(), point(), point(), point()};
  snapshot.radars = {radar_along_y(0.3, 0.2)};
  return snapshot;
}

TEST(Drawing, NoMarkIsFarOutsideThePicture) {
  const auto inside = [](double x, double y) {
    return x >= -64.01 && y >= -64.01 && x <= 864.01 && y <= 664.01;  // 0.01: float
  };
  for (const bool perspective : {false, true})
    for (unsigned seed = 0; seed < 20; ++seed)
      for (const double size_m : {10.0, 1e4, 1e12}) {
        Camera camera = turned(front_camera(), 37.0 * seed, 11.0 * seed);
        camera.perspective = perspective;
        DrawingOptions options;
        options.filled_surfaces = true;
        const Drawing drawing = drawn(random_snapshot(seed, size_m), camera, options);
        for (const Drawing::Disc& disc : drawing.discs) ASSERT_TRUE(inside(disc.x, disc.y));
        for (const Drawing::Text& text : drawing.texts) ASSERT_TRUE(inside(text.x, text.y));
        for (const Drawing::Line& line : drawing.lines)
          ASSERT_TRUE(inside(line.x0, line.y0) && inside(line.x1, line.y1));
        ASSERT_LE(drawing.solids.left + drawing.solids.width, 800);
        ASSERT_LE(drawing.solids.top + drawing.solids.height, 600);
      }
}

TEST(Drawing, ALinePastTheViewerIsDrawnAsFarAsItIsInFront) {
  Camera camera = front_camera();
  camera.perspective = true;
  Snapshot snapshot;
  snapshot.platforms = {platform_at("Plane", {})};
  // From behind the viewer, below the picture's middle, to far ahead.
  snapshot.platforms[0].trail_world_m = {{0, -5000, -10}, {0, 5000, -10}};
  const auto trail = lines_of(drawn(snapshot, camera, bare_options()), Role::faint);
  ASSERT_EQ(trail.size(), 1U);
  const auto end = camera.project({0, 5000, -10});
  EXPECT_NEAR(trail[0].y1, end->y, 1e-2);
  EXPECT_GT(trail[0].y0, trail[0].y1 + 100.0F);  // it runs down towards the viewer
}

TEST(Drawing, PerspectiveShowsWhatIsFartherNearerToTheMiddle) {
  Camera camera = front_camera();
  camera.perspective = true;
  Snapshot snapshot;
  snapshot.targets = {target_at(0, {100, 0, 0}), target_at(1, {100, 1200, 0})};
  const Drawing drawing = drawn(snapshot, camera, bare_options());
  EXPECT_NEAR(drawing.handles[1].x, 500.0, 1e-3);
  EXPECT_NEAR(drawing.handles[0].x, 450.0, 1e-3);  // viewer at 1200 m: half the scale
}

TEST(Drawing, TheGroundGridHasRoundStepsAtAnyZoomAndNoneFromItsEdge) {
  DrawingOptions options = bare_options();
  options.ground_grid = true;
  for (const double scale : {1e-5, 3.7e-3, 0.42, 55.0}) {
    Camera camera = preset(front_camera(), ViewPreset::top);
    camera.pixels_per_m = scale;
    const auto lines = lines_of(drawn({}, camera, options), Role::faint);
    ASSERT_GE(lines.size(), 14U) << scale;
    std::vector<float> upright;
    for (const Drawing::Line& line : lines)
      if (std::abs(line.x0 - line.x1) < 1e-3F) upright.push_back(line.x0);
    std::ranges::sort(upright);
    ASSERT_GE(upright.size(), 3U);
    for (std::size_t i = 1; i < upright.size(); ++i) {
      EXPECT_GT(upright[i] - upright[i - 1], 70.0F) << scale;
      EXPECT_LT(upright[i] - upright[i - 1], 181.0F) << scale;
    }
  }
  EXPECT_TRUE(lines_of(drawn({}, preset(front_camera(), ViewPreset::front), options), Role::faint).empty());
}

TEST(Drawing, DistancesOnTheGroundHaveASignOfMinus) {
  DrawingOptions options = bare_options();
  options.ground_grid = options.labels = true;
  Camera camera = Camera::start(800.0, 600.0);
  camera.pixels_per_m = 0.01;
  std::size_t negative = 0;
  for (const Drawing::Text& text : drawn({}, camera, options).texts) {
    EXPECT_EQ(text.text.find('-'), std::string::npos) << text.text;
    if (text.text.starts_with("−")) ++negative;
  }
  EXPECT_GT(negative, 0U);
}

// The line of 0 lies under an axis, where its words would be written across those of the axis.
TEST(Drawing, TheGroundGridSaysZeroOnceAndNotBesideTheMainAxes) {
  DrawingOptions options = bare_options();
  options.ground_grid = options.labels = true;
  Camera camera = Camera::start(800.0, 600.0);
  camera.pixels_per_m = 0.01;
  const auto zeros = [&] {
    const Drawing drawing = drawn({}, camera, options);
    return std::ranges::count(drawing.texts, "0 m", &Drawing::Text::text);
  };
  EXPECT_EQ(zeros(), 1);
  options.coordinate_systems = true;
  EXPECT_EQ(zeros(), 0);
}

TEST(Drawing, RoomIsUsedAgainAndNothingIsLeftOver) {
  Drawing drawing;
  draw_scene(random_snapshot(1, 100.0), front_camera(), {}, drawing);
  const std::size_t lines = drawing.lines.size();
  draw_scene(random_snapshot(1, 100.0), front_camera(), {}, drawing);
  EXPECT_EQ(drawing.lines.size(), lines);
  draw_scene({}, front_camera(), bare_options(), drawing);
  EXPECT_TRUE(drawing.lines.empty());
  EXPECT_TRUE(drawing.solids.empty());
}

TEST(Drawing, PointsToFitAreThoseOfObjects) {
  Snapshot snapshot = random_snapshot(1, 100.0);
  EXPECT_EQ(points_of(snapshot).size(), 100U + 3U * 20U + 1U + 1U);
  EXPECT_TRUE(points_of({}).empty());
}

// Goal: 3 ms on one core; the bound leaves room for slow machines and sanitizers.
TEST(Drawing, TenThousandTargetsAreQuick) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> side(-400.0, 400.0);
  Snapshot snapshot;
  for (std::size_t i = 0; i < 10'000; ++i)
    snapshot.targets.push_back(target_at(i, {side(random), side(random), side(random)}));
  DrawingOptions options;
  options.selected = {{scene::ObjectKind::target, 17}};
  Drawing drawing;
  double best_ms = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 20; ++i) {
    const Camera camera = turned(front_camera(), 10.0 * i, 3.0 * i);
    const sarsim::test::ProcessorTime time;
    draw_scene(snapshot, camera, options, drawing);
    best_ms = std::min(best_ms, 1e3 * time.seconds());
  }
  EXPECT_GT(drawing.discs.size(), 5'000U);
  std::cout << "drawing of 10 000 targets: " << best_ms << " ms\n";
  EXPECT_LT(best_ms, 60.0);
}

}  // namespace drawing_test
}  // namespace sarsim::picture
