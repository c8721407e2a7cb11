#include "picture/figure/figure_axes.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace sarsim::picture {
namespace figure_axes_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(FigureAxes, LeaveATwentiethOnEitherSideOfTheFiniteValues) {
  FigureAxis axis;
  fit(axis, {3.0, nan, 1.0, std::numeric_limits<double>::infinity(), 2.0});
  EXPECT_DOUBLE_EQ(axis.first, 0.9);
  EXPECT_DOUBLE_EQ(axis.last, 3.1);
}

TEST(FigureAxes, HaveRoomWhereAllValuesAreTheSameOrThereAreNone) {
  FigureAxis axis;
  fit(axis, {5.0, 5.0});
  EXPECT_EQ(axis.first, 4.0);
  EXPECT_EQ(axis.last, 6.0);
  fit(axis, {});
  EXPECT_LT(axis.first, axis.last);
  EXPECT_LT(axis_along("Range", "m", {7.0}).first, 7.0);
}

TEST(FigureDecibels, EndBelowTheLargestAndKeepWhatIsNoNumber) {
  const std::vector<double> levels = decibels_of({10.0, 1.0, 0.0, nan}, 20.0, 40.0);
  EXPECT_DOUBLE_EQ(levels[0], 20.0);
  EXPECT_DOUBLE_EQ(levels[1], 0.0);
  EXPECT_DOUBLE_EQ(levels[2], -20.0);
  EXPECT_TRUE(std::isnan(levels[3]));
}

TEST(FigureDecibels, OfSilenceAreFinite) {
  for (const double level : decibels_of({0.0, 0.0}, 10.0)) EXPECT_TRUE(std::isfinite(level));
}

// A parabola about 2.3 and one about 7.6, sampled at 0, 1, 2, ...; the second is higher.
// Seen from 0 to 10.
FigurePanel two_peaks() {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i <= 10; ++i) {
    x.push_back(i);
    const double from = i < 5 ? 2.3 : 7.6;
    y.push_back((i < 5 ? 10.0 : 20.0) - (i - from) * (i - from));
  }
  return curve_panel("", {"Range", "m", 0.0, 10.0, {}}, {}, x, y);
}

TEST(PeakMarks, StandBetweenSamplesWhereAParabolaPeaksHighestFirst) {
  FigurePanel panel = two_peaks();
  const double top = panel.y.last;
  mark_peaks(panel, 5);
  EXPECT_GT(panel.y.last, top) << "the words need room";
  ASSERT_EQ(panel.marks.size(), 2U);
  EXPECT_NEAR(panel.marks[0].x, 7.6, 1e-12);
  EXPECT_NEAR(panel.marks[1].x, 2.3, 1e-12);
  EXPECT_EQ(panel.marks[0].text, "7.600 m");
}

TEST(PeakMarks, AreAtMostAsManyAsWanted) {
  FigurePanel panel = two_peaks();
  mark_peaks(panel, 1);
  EXPECT_EQ(panel.marks.size(), 1U);
  FigurePanel empty;
  mark_peaks(empty, 3);
  EXPECT_TRUE(empty.marks.empty());
}

TEST(PeakMarks, HaveNoWordsWhereThoseOfAHigherOneStand) {
  FigurePanel panel =
      curve_panel("", {"Range", "m", 0.0, 100.0, {}}, {}, {0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 5.0, 4.0, 5.01, 0.0});
  mark_peaks(panel, 2);
  ASSERT_EQ(panel.marks.size(), 2U);
  EXPECT_FALSE(panel.marks[0].text.empty());
  EXPECT_EQ(panel.marks[1].text, "");
}

TEST(PeakMarks, AreWrittenInTheUnitOfTheAxis) {
  FigurePanel panel =
      curve_panel("", {"Range", "m", 10'000.0, 10'500.0, {}}, {}, {10'100.0, 10'101.0, 10'102.0}, {0.0, 1.0, 0.0});
  mark_peaks(panel, 1);
  EXPECT_EQ(panel.marks.at(0).text, "10.10100 km");
}

TEST(BrokenCurves, AreBrokenWhereTheyTurnBackAndNowhereElse) {
  FigureCurve curve{"srp", Role::curve_2, false, {0.0, 1.0, 0.5, 1.5}, {1.0, 2.0, 3.0, 4.0}};
  break_where_it_turns_back(curve);
  ASSERT_EQ(curve.x.size(), 5U);
  EXPECT_TRUE(std::isnan(curve.y[2]));
  EXPECT_EQ(curve.y[3], 3.0);
  EXPECT_EQ(curve.name, "srp");
  FigureCurve whole{"", Role::curve, false, {0.0, 0.0, 1.0}, {1.0, 2.0, 3.0}};
  const FigureCurve before = whole;
  break_where_it_turns_back(whole);
  EXPECT_EQ(whole, before);
}

TEST(PeakMarks, AreNotOnSlopesOrAtEnds) {
  FigurePanel panel = curve_panel("", {}, {}, {0.0, 1.0, 2.0}, {1.0, 2.0, 3.0});
  mark_peaks(panel, 3);
  EXPECT_TRUE(panel.marks.empty());
}

TEST(PeakMarks, OnAFlatTopAreAtItsBeginning) {
  FigurePanel panel = curve_panel("", {}, {}, {0.0, 1.0, 2.0, 3.0}, {0.0, 2.0, 2.0, 0.0});
  mark_peaks(panel, 3);
  ASSERT_EQ(panel.marks.size(), 1U);
  EXPECT_DOUBLE_EQ(panel.marks[0].x, 1.5);
}

}  // namespace figure_axes_test
}  // namespace sarsim::picture
