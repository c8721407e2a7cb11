#include "picture/scene/scene_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "picture/scene/draw_scene.hpp"
#include "picture/scene/snapshot_maker.hpp"
#include "picture/scene/snapshot_symbol.hpp"

namespace sarsim::picture {
namespace {

// An aircraft flies north at 100 m/s, 3 km up, from 0 to 10 s; its radar looks down to the right.
scene::Scene flight() {
  scene::Scene scene;
  scene::Platform plane;
  plane.name = "Plane";
  plane.path = scene::Platform::Path::trajectory;
  plane.trajectory_m.part[0].knots = {{0.0, -8000.0}, {10.0, -8000.0}};
  plane.trajectory_m.part[1].knots = {{0.0, -500.0}, {10.0, 500.0}};
  plane.trajectory_m.part[2].knots = {{0.0, 3000.0}, {10.0, 3000.0}};
  scene.platforms = {plane};
  scene.targets.resize(1);
  scene.targets[0].position_m = {0.0, 0.0, 0.0};
  scene.targets[0].platform = "Earth";
  return scene;
}

TEST(Symbols, LieAlongTheWayAndAreChosenByHeightAndPath) {
  radar::Pose pose;
  pose.position_world_m = {0.0, 0.0, 3000.0};
  const auto plane = symbol_of(pose, {0.0, 100.0, 0.0}, false, std::nullopt);
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->symbol, Symbol::aircraft);
  EXPECT_NEAR(core::norm(plane->world_from_symbol * core::Vec3{1, 0, 0} - core::Vec3{0, 1, 0}), 0.0, 1e-12);
  EXPECT_NEAR(core::norm(plane->world_from_symbol * core::Vec3{0, 1, 0} - core::Vec3{-1, 0, 0}), 0.0, 1e-12);
  EXPECT_NEAR(core::norm(plane->world_from_symbol * core::Vec3{0, 0, 1} - core::Vec3{0, 0, 1}), 0.0, 1e-12);
  EXPECT_EQ(symbol_of(pose, {0.0, 7500.0, 0.0}, true, std::nullopt)->symbol, Symbol::satellite);
  pose.position_world_m.z = 2.0;
  EXPECT_EQ(symbol_of(pose, {5.0, 0.0, 0.0}, false, std::nullopt)->symbol, Symbol::vehicle);
  EXPECT_FALSE(symbol_of(pose, {}, false, std::nullopt));
  EXPECT_FALSE(symbol_of(pose, {std::nan(""), 0.0, 0.0}, false, std::nullopt));
  // Straight up there is no level: any axes will do, as long as they are of unit length.
  const auto rocket = symbol_of(pose, {0.0, 0.0, 9.0}, false, std::nullopt);
  ASSERT_TRUE(rocket);
  EXPECT_NEAR(core::norm(rocket->world_from_symbol * core::Vec3{0, 1, 0}), 1.0, 1e-12);
}

TEST(Symbols, LeanWithTheirPlatform) {
  radar::Pose pose;
  const double roll = 0.3;
  pose.world_from_platform = core::transposed(
      {{core::Vec3{std::cos(roll), 0, -std::sin(roll)}, {0, 1, 0}, {std::sin(roll), 0, std::cos(roll)}}});
  const auto ship = symbol_of(pose, {0.0, 5.0, 0.0}, false, std::nullopt);
  EXPECT_NEAR((ship->world_from_symbol * core::Vec3{0, 0, 1}).x, std::sin(roll), 1e-12);
}

TEST(Symbols, StandOnTheEllipsoidOfAnEarth) {
  const radar::EarthFrame earth({{0.3, 0.2, 0.0}, 0.0});
  radar::Pose pose;
  pose.position_world_m = earth.world_of({0.4, 0.2, 5.0});  // 638 km north of the anchor, 5 m up
  EXPECT_LT(pose.position_world_m.z, -30000.0);
  EXPECT_EQ(symbol_of(pose, {5.0, 0.0, 0.0}, false, earth)->symbol, Symbol::vehicle);
  EXPECT_NEAR(earth.geodetic_of(ground_below(pose.position_world_m, earth)).height_m, 0.0, 1e-6);
  EXPECT_EQ(ground_below({1.0, 2.0, 3.0}, std::nullopt), (core::Vec3{1.0, 2.0, 0.0}));
}

TEST(Snapshots, KnowWhereAPlatformGoesEvenWhereItStands) {
  const SnapshotMaker maker(flight());
  for (const double time_s : {-5.0, 0.0, 4.0, 10.0, 20.0}) {
    const Snapshot snapshot = maker.at(time_s, 10.0);
    ASSERT_TRUE(snapshot.platforms.at(0).symbol) << time_s;
    EXPECT_NEAR((snapshot.platforms[0].symbol->world_from_symbol * core::Vec3{1, 0, 0}).y, 1.0, 1e-9);
    EXPECT_EQ(snapshot.platforms[0].trail_s.size(), snapshot.platforms[0].trail_world_m.size());
  }
}

TEST(Snapshots, IlluminateTheGroundFromTheFirstPulseToNow) {
  scene::Scene scene = flight();
  scene::Radar radar;
  radar.name = "R";
  radar.platform = "Plane";
  radar.beam = scene::Radar::Beam::fixed;
  radar.beam_azimuth = core::Angle::from_deg(90.0);
  radar.beam_elevation = core::Angle::from_deg(-20.0);
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(10.0);
  scene.radars = {radar};
  scene::Simulation simulation;
  simulation.radar = "R";
  simulation.time_start_s = 2.0;
  simulation.time_end_s = 8.0;
  scene.simulations = {simulation};
  const SnapshotMaker maker(scene);
  const auto middle_y = [](const std::vector<std::optional<core::Vec3>>& outline) {
    double sum = 0.0;
    for (const auto& point : outline) sum += point.value().y;
    return sum / static_cast<double>(outline.size());
  };
  EXPECT_TRUE(maker.at(5.0).radars.at(0).illuminated_world_m.empty()) << "not asked for";
  EXPECT_TRUE(maker.at(1.0, 0.0, true).radars.at(0).illuminated_world_m.empty());
  for (const auto& [time_s, last_s] : {std::pair(5.0, 5.0), std::pair(9.5, 8.0)}) {
    const auto outlines = maker.at(time_s, 0.0, true).radars.at(0).illuminated_world_m;
    ASSERT_GT(outlines.size(), 10U);
    EXPECT_NEAR(middle_y(outlines.front()), -500.0 + 100.0 * 2.0, 10.0);
    EXPECT_NEAR(middle_y(outlines.back()), -500.0 + 100.0 * last_s, 10.0);
  }
}

TEST(SceneView, KeepsWhatIsThereInViewAtAllTimes) {
  SceneLook look;
  const PictureStyle style{400, 300, 1.0, false};
  SceneView view(flight(), look, style, {0.0, 10.0});
  for (const double time_s : {0.0, 5.0, 10.0}) {
    const Sheet sheet = view.at(time_s);
    ASSERT_TRUE(sheet.image);  // the symbol
    EXPECT_GT(sheet.image->left, 0.0);
    EXPECT_LT(sheet.image->left + sheet.image->width, 400.0);
    EXPECT_GE(std::ranges::count(sheet.texts, "Plane", &Sheet::Text::text), 1);
  }
}

TEST(SceneView, FollowsAPlatform) {
  SceneLook look;
  look.from = SceneLook::From::top;
  look.followed = 0;
  look.options.ground_grid = true;
  SceneView view(flight(), look, {400, 300, 1.0, false}, {0.0, 10.0});
  const Sheet first = view.at(0.0);
  const Sheet last = view.at(10.0);
  ASSERT_TRUE(first.image && last.image);
  EXPECT_NEAR(first.image->left, last.image->left, 1.0);
  EXPECT_NEAR(first.image->top, last.image->top, 1.0);
  EXPECT_NE(first.discs.front().y, last.discs.front().y) << "the target moves instead";
}

TEST(SceneView, IsTheSamePictureAtTwiceTheDots) {
  SceneView view(flight(), {}, {400, 300, 2.0, true}, {0.0, 10.0});
  SceneView coarse(flight(), {}, {400, 300, 1.0, true}, {0.0, 10.0});
  const Sheet fine_sheet = view.at(5.0);
  const Sheet sheet = coarse.at(5.0);
  ASSERT_EQ(fine_sheet.lines.size(), sheet.lines.size());
  for (std::size_t i = 0; i < sheet.lines.size(); ++i) EXPECT_NEAR(fine_sheet.lines[i].x0, sheet.lines[i].x0, 0.01);
  EXPECT_EQ(sheet.background, colour(Role::background, true));
}

TEST(SceneView, DrawsTheSameBytesForAnyNumberOfThreads) {
  const PictureStyle style{400, 300, 1.0, false};
  SceneLook look;
  std::string first;
  for (const unsigned threads : {1U, 3U}) {
    look.options.threads = threads;
    SceneView view(flight(), look, style, {0.0, 10.0});
    const std::string bytes = draw_sheet(view.at(5.0), PictureKind::png, style);
    EXPECT_TRUE(bytes.starts_with("\x89PNG"));
    if (first.empty()) first = bytes;
    EXPECT_TRUE(bytes == first);
  }
  for (const auto& [kind, beginning] : {std::pair(PictureKind::svg, "<?xml"), std::pair(PictureKind::pdf, "%PDF")}) {
    SceneView view(flight(), look, style, {0.0, 10.0});
    EXPECT_TRUE(draw_sheet(view.at(5.0), kind, style).starts_with(beginning));
  }
}

TEST(Drawing, ColoursTrailsBySpeedAndSaysTheLimits) {
  Snapshot snapshot;
  Snapshot::Platform car;
  car.name = "Car";
  car.trail_world_m = {{0, 0, 0}, {10, 0, 0}, {40, 0, 0}};
  car.trail_s = {0.0, 1.0, 2.0};
  snapshot.platforms = {car};
  DrawingOptions options;
  options.tracks = DrawingOptions::Tracks::by_speed;
  Camera camera = preset(Camera::start(400.0, 300.0), ViewPreset::top);
  camera.pixels_per_m = 2.0;
  Drawing drawing;
  draw_scene(snapshot, camera, options, drawing);
  std::vector<std::uint8_t> tones;
  for (const Drawing::Line& line : drawing.lines)
    if (line.role == Role::track && line.width_px == 2.0F) tones.push_back(line.tone);
  EXPECT_EQ(tones, (std::vector<std::uint8_t>{0, 255}));
  EXPECT_EQ(std::ranges::count(drawing.texts, "10 m/s to 30 m/s", &Drawing::Text::text), 1);
  options.tracks = DrawingOptions::Tracks::by_time;
  draw_scene(snapshot, camera, options, drawing);
  EXPECT_EQ(std::ranges::count(drawing.texts, "500 ms to 1.5 s", &Drawing::Text::text), 1);
}

TEST(Drawing, HasSkyAboveTheHorizonOfPerspectiveAlone) {
  Camera camera = Camera::start(400.0, 300.0);
  Drawing drawing;
  draw_scene({}, camera, {}, drawing);
  EXPECT_FALSE(drawing.horizon_px);
  camera.perspective = true;
  camera.elevation_rad = 0.1;
  draw_scene({}, camera, {}, drawing);
  // Level lines of sight: 0.1 rad above the middle, the eye two heights away.
  EXPECT_NEAR(drawing.horizon_px.value(), 150.0 - 600.0 * std::tan(0.1), 1e-9);
  const auto far = camera.project({-1e9 * std::sin(camera.azimuth_rad), -1e9 * std::cos(camera.azimuth_rad), 0.0});
  EXPECT_NEAR(far->y, *drawing.horizon_px, 0.01);
  DrawingOptions options;
  options.sky = false;
  draw_scene({}, camera, options, drawing);
  EXPECT_FALSE(drawing.horizon_px);
}

}  // namespace
}  // namespace sarsim::picture
