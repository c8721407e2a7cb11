#include "picture/figure/function_figure.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace sarsim::picture {
namespace function_figure_test {

// Figure 4.12 of the thesis in x, a constant in y and z.
scene::AnyObject mover() {
  scene::Platform platform;
  platform.name = "Mover";
  platform.path = scene::Platform::Path::trajectory;
  platform.trajectory_m.part[0] = {core::Interpolation::cubic,
                                   {{0.0, 0.0}, {1.0, 1.5}, {2.0, 0.0}, {3.0, -5.0}, {4.0, -3.5}}};
  platform.trajectory_m.part[1] = {core::Interpolation::linear, {{0.0, 7.0}}};
  platform.trajectory_m.part[2] = {core::Interpolation::linear, {{0.0, 8.0}}};
  return platform;
}

Figure figure_of(const scene::AnyObject& object, const char* field, bool compare) {
  return function_figure(scene::function_info(object, field), scene::function_of(object, field),
                         {core::LowPassRule::first_knot}, compare);
}

double value_at(const FigureCurve& curve, double x) {
  const auto nearest =
      std::ranges::min_element(curve.x, {}, [x](double place) { return std::abs(place - x); }) - curve.x.begin();
  return curve.y[static_cast<std::size_t>(nearest)];
}

TEST(FunctionFigure, ComparesThreeInterpolationsThatMeetInThePoints) {
  const Figure figure = figure_of(mover(), "trajectory_m", true);
  ASSERT_EQ(figure.panels.size(), 1U) << "constant parts are left out";
  const FigurePanel& panel = figure.panels[0];
  EXPECT_EQ(panel.y.label, "Position X");
  ASSERT_EQ(panel.curves.size(), 3U);
  EXPECT_EQ(panel.marks.size(), 5U);
  for (const FigureCurve& curve : panel.curves) {
    EXPECT_NEAR(value_at(curve, 3.0), -5.0, 1e-9) << curve.name;
    EXPECT_NEAR(value_at(curve, 1.0), 1.5, 1e-9) << curve.name;
  }
  EXPECT_NEAR(value_at(panel.curves[0], 0.5), 0.75, 1e-9);
  EXPECT_GT(std::abs(value_at(panel.curves[1], 0.5) - 0.75), 0.05);
}

TEST(FunctionFigure, ShowsTheChosenInterpolationAndSaysWhich) {
  const Figure figure = figure_of(mover(), "trajectory_m", false);
  ASSERT_EQ(figure.panels[0].curves.size(), 1U);
  EXPECT_EQ(figure.panels[0].title, "Chosen: cubic splines");
  EXPECT_EQ(figure.panels[0].curves[0].y, figure_of(mover(), "trajectory_m", true).panels[0].curves[1].y);
}

TEST(FunctionFigure, SeesALittleMoreThanThePoints) {
  const FigureAxis axis = figure_of(mover(), "trajectory_m", false).panels[0].x;
  EXPECT_DOUBLE_EQ(axis.first, -0.5);
  EXPECT_DOUBLE_EQ(axis.last, 4.5);
}

TEST(FunctionFigure, OfConstantsAloneShowsThemAll) {
  scene::AnyObject object = mover();
  std::get<scene::Platform>(object).trajectory_m.part[0].knots.resize(1);
  EXPECT_EQ(figure_of(object, "trajectory_m", true).panels.size(), 3U);
}

TEST(FunctionFigure, OfThePulseNumberIsBars) {
  scene::Radar radar;
  radar.repetition = scene::Radar::Repetition::user;
  radar.pri_s.part[0].knots = {{0.0, 1e-3}, {1.0, 2e-3}, {2.0, 1.5e-3}};
  const Figure figure = figure_of(radar, "pri_s", true);
  ASSERT_EQ(figure.panels.size(), 1U);
  ASSERT_EQ(figure.panels[0].curves.size(), 1U);
  EXPECT_TRUE(figure.panels[0].curves[0].bars);
  EXPECT_EQ(figure.panels[0].curves[0].y, (std::vector<double>{1e-3, 2e-3, 1.5e-3}));
  EXPECT_LT(figure.panels[0].y.first, 0.0);
}

}  // namespace function_figure_test
}  // namespace sarsim::picture
