#include "picture/figure/antenna_figure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::picture {
namespace antenna_figure_test {

simulate::Link radar_with(double azimuth_deg, double elevation_deg) {
  simulate::Link radar;
  radar.name = "Radar1";
  radar.transmit.kind = radar::AntennaPattern::Kind::sinx;
  radar.transmit.azimuth_beamwidth_rad = azimuth_deg * core::pi / 180.0;
  radar.transmit.elevation_beamwidth_rad = elevation_deg * core::pi / 180.0;
  radar.receive = radar.transmit;
  return radar;
}

double value_at(const FigureCurve& curve, double x) {
  const auto nearest =
      std::ranges::min_element(curve.x, {}, [x](double place) { return std::abs(place - x); }) - curve.x.begin();
  return curve.y[static_cast<std::size_t>(nearest)];
}

// Where sin(x)/x is 1/sqrt(2) or 1/2: x = 1.391557 and 1.895494.
double offset_deg(double x, double beamwidth_deg) {
  return std::asin(x * beamwidth_deg * core::pi / 180.0 / (0.88 * core::pi)) * 180.0 / core::pi;
}

TEST(AntennaFigure, OfEqualCutsIsOneCurve) {
  const Figure figure = antenna_figure(radar_with(10.0, 10.0), radar::PatternRule::amplitude, {});
  ASSERT_EQ(figure.panels.at(0).curves.size(), 1U);
  EXPECT_EQ(figure.panels[0].curves[0].name, "azimuth and elevation");
  EXPECT_DOUBLE_EQ(value_at(figure.panels[0].curves[0], 0.0), 1.0);
}

TEST(AntennaFigure, MarksWhereTheAmplitudeHasFallenToHalfThePower) {
  const Figure figure = antenna_figure(radar_with(10.0, 30.0), radar::PatternRule::amplitude, {});
  ASSERT_EQ(figure.panels[0].curves.size(), 2U);
  ASSERT_EQ(figure.panels[0].marks.size(), 4U);
  EXPECT_NEAR(figure.panels[0].marks[1].x, offset_deg(1.391557, 10.0), 1e-5);
  EXPECT_EQ(figure.panels[0].marks[1].text.substr(0, 14), "azimuth: half ");
  EXPECT_NEAR(figure.panels[0].marks[3].x, offset_deg(1.391557, 30.0), 1e-5);
  EXPECT_EQ(figure.panels[0].marks[3].text.substr(0, 16), "elevation: half ");
  EXPECT_NEAR(figure.panels[0].marks[1].y, std::sqrt(0.5), 1e-9);
  EXPECT_DOUBLE_EQ(figure.panels[0].marks[0].x, -figure.panels[0].marks[1].x);
}

TEST(AntennaFigure, TakesThePatternAsPowerWhereTheProfileDoes) {
  const Figure figure = antenna_figure(radar_with(10.0, 10.0), radar::PatternRule::power, {});
  EXPECT_NEAR(figure.panels[0].marks.at(1).x, offset_deg(1.895494, 10.0), 1e-5);
}

TEST(AntennaFigure, ShowsTheSignOfSidelobesWhereTheRealPartIsWanted) {
  AntennaLook look;
  look.quantity = DisplayQuantity::real;
  const double side_deg = offset_deg(4.4934, 10.0);
  EXPECT_NEAR(value_at(antenna_figure(radar_with(10.0, 10.0), radar::PatternRule::amplitude, look).panels[0].curves[0],
                       side_deg),
              -0.2172, 1e-3);
  look.quantity = DisplayQuantity::magnitude;
  EXPECT_NEAR(value_at(antenna_figure(radar_with(10.0, 10.0), radar::PatternRule::amplitude, look).panels[0].curves[0],
                       side_deg),
              0.2172, 1e-3);
}

TEST(AntennaFigure, InDecibelsEndsAtTheSpan) {
  AntennaLook look;
  look.quantity = DisplayQuantity::decibels;
  look.span_db = 40.0;
  const Figure figure = antenna_figure(radar_with(10.0, 10.0), radar::PatternRule::amplitude, look);
  const std::vector<double>& level = figure.panels[0].curves[0].y;
  EXPECT_DOUBLE_EQ(*std::ranges::min_element(level), -40.0);
  EXPECT_DOUBLE_EQ(*std::ranges::max_element(level), 0.0);
  EXPECT_NEAR(figure.panels[0].marks.at(1).y, -3.0103, 1e-3);
}

TEST(AntennaFigure, NamesBothAntennasWhereTheyDiffer) {
  simulate::Link radar = radar_with(10.0, 10.0);
  radar.receive = radar_with(3.0, 5.0).transmit;
  const Figure figure = antenna_figure(radar, radar::PatternRule::amplitude, {});
  ASSERT_EQ(figure.panels[0].curves.size(), 3U);
  EXPECT_EQ(figure.panels[0].curves[0].name, "transmit, azimuth and transmit, elevation");
  EXPECT_EQ(figure.panels[0].curves[2].name, "receive, elevation");
  EXPECT_NE(figure.note.find("receive: sin(x)/x, 3 deg"), std::string::npos) << figure.note;
}

TEST(AntennaFigure, OfAnIsotropicAntennaIsALineWithoutMarks) {
  simulate::Link radar;
  const Figure figure = antenna_figure(radar, radar::PatternRule::amplitude, {});
  EXPECT_TRUE(figure.panels[0].marks.empty());
  for (const double gain : figure.panels[0].curves.at(0).y) EXPECT_EQ(gain, 1.0);
}

TEST(AntennaFigure, LeavesOutMarksThatAreNotSeen) {
  AntennaLook look;
  look.first_deg = -2.0;
  look.last_deg = 20.0;
  EXPECT_EQ(antenna_figure(radar_with(10.0, 10.0), radar::PatternRule::amplitude, look).panels[0].marks.size(), 1U);
}

TEST(AntennaFigure, RefusesWhatAPatternDoesNotHave) {
  AntennaLook look;
  look.quantity = DisplayQuantity::phase;
  EXPECT_THROW((void)antenna_figure(radar_with(10.0, 10.0), radar::PatternRule::amplitude, look),
               std::invalid_argument);
}

}  // namespace antenna_figure_test
}  // namespace sarsim::picture
