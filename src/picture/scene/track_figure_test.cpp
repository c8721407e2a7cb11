#include "picture/scene/track_figure.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "core/report/invalid_request.hpp"

namespace sarsim::picture {
namespace track_figure_test {

// 1 km above the ground along +x at 100 m/s for 10 s, looking down.
scene::Scene flight() {
  scene::Scene scene;
  scene::Platform& plane = scene.platforms.emplace_back();
  plane.name = "Plane";
  plane.path = scene::Platform::Path::trajectory;
  plane.trajectory_m.part[0].knots = {{0.0, 0.0}, {10.0, 1000.0}};
  plane.trajectory_m.part[1].knots = {{0.0, 50.0}};
  plane.trajectory_m.part[2].knots = {{0.0, 1000.0}};
  scene.targets.emplace_back().position_m = {500.0, 60.0, 0.0};
  scene::Radar& radar = scene.radars.emplace_back();
  radar.platform = "Plane";
  radar.beam_elevation = core::Angle::from_deg(-90.0);
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(8.0);
  return scene;
}

double largest_of(const std::vector<double>& values) { return *std::ranges::max_element(values); }
double min_of(const std::vector<double>& values) { return *std::ranges::min_element(values); }

TEST(TrackFigure, ShowsPathsBeamsAndTargets) {
  const scene::Scene scene = flight();
  const Figure figure = track_figure(scene, simulate::resolve(scene), {0.0, 10.0});
  ASSERT_EQ(figure.panels.size(), 2U);
  const FigurePanel& map = figure.panels[0];
  ASSERT_EQ(map.curves.size(), 2U);
  EXPECT_EQ(map.curves[0].name, "Plane");
  EXPECT_EQ(map.curves[1].name, "beam of Radar1");
  for (const FigureCurve& curve : map.curves) {
    EXPECT_NEAR(curve.x.front(), 0.0, 1e-6);
    EXPECT_NEAR(curve.x.back(), 1000.0, 1e-6);
    EXPECT_NEAR(curve.y.front(), 50.0, 1e-6);
  }
  ASSERT_EQ(map.marks.size(), 2U);
  EXPECT_EQ(map.marks[0].text, "0 s");
  EXPECT_EQ(map.marks[1], (FigureMark{500.0, 60.0, "1"}));
  EXPECT_EQ(figure.panels[1].curves[0].y, std::vector<double>(601, 1000.0));
  EXPECT_EQ(figure.panels[1].x.label, "Time");
}

TEST(TrackFigure, LeavesOutBeamsThatMissTheGround) {
  scene::Scene scene = flight();
  scene.radars[0].beam_elevation = core::Angle::from_deg(10.0);
  const Figure figure = track_figure(scene, simulate::resolve(scene), {0.0, 10.0});
  EXPECT_EQ(figure.panels[0].curves.size(), 1U);
  EXPECT_EQ(figure.note, "");
}

TEST(TrackFigure, OverTheEarthHasLongitudesAndHeights) {
  scene::Scene scene = flight();
  scene.world.frame = scene::World::Frame::earth;
  scene.world.latitude = core::Angle::from_deg(60.0);
  scene.world.longitude = core::Angle::from_deg(10.0);
  scene.world.height_m = 200.0;
  scene.world.epoch = "2020-07-28T22:59:42Z";
  const Figure figure = track_figure(scene, simulate::resolve(scene), {0.0, 10.0});
  const FigureCurve& path = figure.panels[0].curves[0];
  EXPECT_NEAR(path.x.front(), 10.0, 1e-9);
  EXPECT_NEAR(path.x.back(), 10.0 + core::deg_per_rad * 1000.0 / (6.394e6 * 0.5), 1e-5);
  EXPECT_NEAR(figure.panels[1].curves[0].y.front(), 1200.0, 1e-3);
  EXPECT_EQ(figure.panels[1].x.label, "UTC on 2020-07-28");
}

TEST(FootprintFigure, IsAsWideAsTheBeamAtHalfItsPower) {
  const scene::Scene scene = flight();
  const Figure figure = footprint_figure(scene, simulate::resolve(scene), 0, {0.0, 10.0});
  ASSERT_EQ(figure.panels.size(), 1U);
  const auto& curves = figure.panels[0].curves;
  ASSERT_EQ(curves.size(), 10U);
  EXPECT_EQ(curves[0].name, "0 s");
  EXPECT_EQ(curves[8].name, "10 s");
  EXPECT_EQ(curves[9].name, "middle of the beam");
  // sin(x)/x = 1/sqrt(2) at x = 1.3916: sin(offset) = 1.3916 w/(0.88 pi). Along the beam's elevation, which points
  // ahead and behind or sideways, one of them; a circle has 181 points and so its ends within 2e-4.
  const auto reach_m = [](double width_deg) {
    return 1000.0 * std::tan(std::asin(1.39155738 * width_deg * core::rad_per_deg / (0.88 * core::pi)));
  };
  const double across_m = largest_of(curves[0].x) - min_of(curves[0].x);
  const double up_m = largest_of(curves[0].y) - min_of(curves[0].y);
  EXPECT_NEAR(std::min(across_m, up_m), 2.0 * reach_m(2.0), 3e-3 * reach_m(2.0));
  EXPECT_NEAR(std::max(across_m, up_m), 2.0 * reach_m(8.0), 3e-3 * reach_m(8.0));
  EXPECT_NEAR(0.5 * (largest_of(curves[8].x) + min_of(curves[8].x)), 1000.0, 0.1);
}

TEST(FootprintFigure, NeedsALobeOnTheGround) {
  scene::Scene scene = flight();
  scene.radars[0].beam_elevation = core::Angle::from_deg(40.0);
  EXPECT_THROW((void)footprint_figure(scene, simulate::resolve(scene), 0, {0.0, 10.0}), core::InvalidRequest);
  scene = flight();
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::isotropic;
  EXPECT_THROW((void)footprint_figure(scene, simulate::resolve(scene), 0, {0.0, 10.0}), core::InvalidRequest);
}

TEST(ShownTimes, AreThoseOfRecordingsOrOfPaths) {
  scene::Scene scene = flight();
  EXPECT_EQ(shown_times(scene), (radar::TimeSpan{0.0, 10.0}));
  scene.simulations.emplace_back().time_start_s = -2.0;
  scene.simulations[0].time_end_s = 3.0;
  EXPECT_EQ(shown_times(scene), (radar::TimeSpan{-2.0, 3.0}));
}

}  // namespace track_figure_test
}  // namespace sarsim::picture
