#include "picture/image/cut_figure.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sarsim::picture {
namespace cut_figure_test {

// Two pulses of three samples.
EchoBlock block() {
  EchoBlock block;
  block.rows = 2;
  block.columns = 3;
  block.samples = {{0.0, 0.0}, {3.0, 4.0}, {0.0, -0.5}, {1.0, 0.0}, {2.0, 0.0}, {-3.0, 0.0}};
  block.time_s = {0.0, 0.001};
  block.range_m = {100.0, 101.5, 103.0};
  block.carrier_hz = {1e9, 1e9};
  block.light_speed_mps = 3e8;
  return block;
}

TEST(RowFigure, ShowsThePulseAgainstRangeWithDelayBesideIt) {
  const Figure figure = row_figure(block(), 0, {});
  ASSERT_EQ(figure.panels.size(), 1U);
  const FigurePanel& panel = figure.panels[0];
  EXPECT_EQ(panel.title, "Azimuth time 0 s");
  EXPECT_EQ(panel.curves[0].x, block().range_m);
  EXPECT_EQ(panel.curves[0].y, (std::vector<double>{0.0, 5.0, 0.5}));
  EXPECT_EQ(panel.y.unit, "V");
  ASSERT_TRUE(panel.x.twin);
  EXPECT_DOUBLE_EQ(panel.x.twin->factor, 2.0 / 3e8);
  EXPECT_EQ(figure.note, "Highest magnitude: 5 V");
}

TEST(RowFigure, OfMagnitudesIsSeenAgainstZero) { EXPECT_LT(row_figure(block(), 1, {}).panels[0].y.first, 0.0); }

TEST(RowFigure, InDecibelsCountsFromItsLargestAndEndsAtTheSpan) {
  CutLook look;
  look.quantity = DisplayQuantity::decibels;
  look.span_db = 30.0;
  const FigurePanel panel = row_figure(block(), 0, look).panels[0];
  EXPECT_EQ(panel.y.unit, "dB");
  EXPECT_DOUBLE_EQ(panel.curves[0].y[0], -30.0);
  EXPECT_DOUBLE_EQ(panel.curves[0].y[1], 0.0);
  EXPECT_DOUBLE_EQ(panel.curves[0].y[2], -20.0);
}

TEST(RowFigure, OfSilenceInDecibelsIsFinite) {
  EchoBlock silent = block();
  silent.samples.assign(6, 0.0);
  CutLook look;
  look.quantity = DisplayQuantity::decibels;
  const Figure figure = row_figure(silent, 0, look);
  for (const double level : figure.panels[0].curves[0].y) EXPECT_TRUE(std::isfinite(level));
}

TEST(RowFigure, MarksPeaksWhereWanted) {
  CutLook look;
  look.peaks = 1;
  EXPECT_EQ(row_figure(block(), 0, look).panels[0].marks.size(), 1U);
}

TEST(RowFigure, OfCountsByNumberHasNeitherVoltsNorDelay) {
  CutLook look;
  look.unit = "counts";
  look.rows = {"Pulse", ""};
  look.columns = {"Sample", ""};
  const Figure figure = row_figure(block(), 1, look);
  EXPECT_EQ(figure.panels[0].title, "Pulse 0.001");
  EXPECT_EQ(figure.panels[0].y.unit, "counts");
  EXPECT_FALSE(figure.panels[0].x.twin);
  EXPECT_EQ(figure.note, "Highest magnitude: 3 counts");
}

TEST(ColumnFigure, ShowsOneRangeAgainstTime) {
  CutLook look;
  look.quantity = DisplayQuantity::real;
  const FigurePanel panel = column_figure(block(), 2, look).panels[0];
  EXPECT_EQ(panel.title, "Slant range 103 m");
  EXPECT_EQ(panel.curves[0].x, block().time_s);
  EXPECT_EQ(panel.curves[0].y, (std::vector<double>{0.0, -3.0}));
}

TEST(SampleTable, NamesPlacesAndValuesWithUnits) {
  const std::string table = sample_table(block(), {}, true, true, ',');
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "azimuth time [s],slant range [m],I [V],Q [V],magnitude [V],phase [deg]");
  EXPECT_NE(table.find("\n0.001,103,-3,0,3,180\n"), std::string::npos);
}

TEST(SampleTable, LeavesOutThePlacesThatAllShare) {
  CutLook look;
  look.columns = {"Sample", ""};
  look.unit = "counts";
  const std::string table = sample_table(block(), look, false, true, ';');
  EXPECT_EQ(table.substr(0, table.find('\n')), "sample;I [counts];Q [counts];magnitude [counts];phase [deg]");
}

}  // namespace cut_figure_test
}  // namespace sarsim::picture
