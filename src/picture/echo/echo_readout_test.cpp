#include "picture/echo/echo_readout.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "picture/echo/echo_curves.hpp"
#include "picture/echo/preview_test_scene.hpp"

namespace sarsim::picture {
namespace echo_readout_test {

// 11 pulses from 0 to 10 ms and 40 samples.
EchoWindow small_window() {
  EchoWindow window = flight_window();
  set_view(window, {2000.0, 2100.0, 0.0, 0.01});
  return window;
}

std::complex<double> numbered(std::size_t r, std::size_t k) {
  return {static_cast<double>(r) - 5.0, 0.1 * static_cast<double>(k)};
}

TEST(ReadOut, IsThatOfTheSampleNotOfTheCursor) {
  const EchoWindow window = small_window();
  const PlotSize size{400, 101};
  const auto matrix = filled_matrix(window, size, numbered);
  const EchoColours colours = colours_for(*matrix, window);
  // Pulse 3 at y = 70; sample 7 at x = 7 times 2.498 m over 0.25 m a pixel = 69.95.
  const auto r = read_out(*matrix, colours, 71.2, 72.4);
  ASSERT_TRUE(r);
  EXPECT_EQ(r->row, 3U);
  EXPECT_EQ(r->column, 7U);
  EXPECT_NEAR(r->range_m, 2000.0 + 7.0 * core::exact_light_speed_mps / 120e6, 1e-9);
  EXPECT_NEAR(r->delay_s, 2.0 * r->range_m / core::exact_light_speed_mps, 1e-18);
  EXPECT_NEAR(r->time_s, 0.003, 1e-15);
  EXPECT_EQ(r->pulse, 3);
  EXPECT_EQ(r->carrier_hz, 5e9);
  EXPECT_EQ(r->sample_v, numbered(3, 7));
  EXPECT_NEAR(r->magnitude_v, std::hypot(2.0, 0.7), 1e-12);
  EXPECT_NEAR(r->phase_deg, 180.0 - 19.29, 0.01);
  EXPECT_NEAR(r->level_db, 20.0 * std::log10(std::hypot(2.0, 0.7) / colours.reference_v), 1e-9);
  const auto lines = lines_of(*r);
  ASSERT_EQ(lines.size(), 10U);
  EXPECT_EQ(lines[2].value, "0.003000 s");
  EXPECT_EQ(lines[3].value, "3");
  EXPECT_EQ(lines[4].value, "5 GHz");
}

TEST(ReadOut, IsNothingOutsideThePlotOrWhereNothingIsReady) {
  const EchoWindow window = small_window();
  const PlotSize size{400, 101};
  const auto matrix = filled_matrix(window, size, numbered);
  const EchoColours colours = colours_for(*matrix, window);
  EXPECT_TRUE(read_out(*matrix, colours, 0.0, 0.0));
  EXPECT_TRUE(read_out(*matrix, colours, 399.4, 100.4));
  EXPECT_FALSE(read_out(*matrix, colours, 399.6, 50.0));
  EXPECT_FALSE(read_out(*matrix, colours, 5.0, 100.6));
  EXPECT_FALSE(read_out(*matrix, colours, -0.6, 50.0));
  EXPECT_FALSE(read_out(*matrix, colours, std::nan(""), 50.0));
  const EchoMatrix empty(std::make_shared<const simulate::Plan>(matrix->plan()), window, size);
  EXPECT_FALSE(read_out(empty, colours, 5.0, 5.0));
}

TEST(CursorDifference, IsFromTheFirstToTheSecond) {
  ReadOut a;
  a.range_m = 1000.0;
  a.delay_s = 6e-6;
  a.time_s = 1.0;
  a.pulse = 10;
  a.magnitude_v = 2.0;
  a.phase_deg = 170.0;
  ReadOut b = a;
  b.range_m = 1030.0;
  b.delay_s = 6.2e-6;
  b.time_s = 3.0;
  b.pulse = 30;
  b.magnitude_v = 20.0;
  b.phase_deg = -170.0;
  const CursorDifference d = difference(a, b);
  EXPECT_EQ(d.range_m, 30.0);
  EXPECT_NEAR(d.delay_s, 0.2e-6, 1e-18);
  EXPECT_EQ(d.time_s, 2.0);
  EXPECT_EQ(d.pulses, 20);
  EXPECT_NEAR(d.level_db, 20.0, 1e-12);
  EXPECT_NEAR(d.phase_deg, 20.0, 1e-12);
  EXPECT_EQ(d.range_rate_mps, 15.0);
  EXPECT_NEAR(difference(b, a).phase_deg, -20.0, 1e-12);
  b.time_s = a.time_s;
  a.magnitude_v = 0.0;
  EXPECT_TRUE(std::isnan(difference(a, b).range_rate_mps));
  EXPECT_TRUE(std::isnan(difference(a, b).level_db));
}

TEST(SideCut, HoldsTheValuesAlongARowOrAColumn) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {400, 101}, numbered);
  const EchoColours colours = colours_for(*matrix, window);
  const SideCut row = row_cut(*matrix, colours, 2);
  ASSERT_EQ(row.value.size(), 40U);
  EXPECT_EQ(row.value[9], -3.0);
  EXPECT_EQ(row.position[9], matrix->range_m(9));
  const SideCut column = column_cut(*matrix, colours, 9);
  ASSERT_EQ(column.value.size(), 11U);
  EXPECT_EQ(column.value[10], 5.0);
  EXPECT_NEAR(column.position[10], 0.01, 1e-15);
  const EchoMatrix empty(std::make_shared<const simulate::Plan>(matrix->plan()), window, {400, 101});
  EXPECT_TRUE(row_cut(empty, colours, 2).value.empty());
  EXPECT_TRUE(column_cut(empty, colours, 2).value.empty());
}

TEST(EchoCurves, OfPulsesRiseFromTheirTimesByThreeEighthsOfTheSpacing) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {400, 441}, numbered);
  const EchoColours colours = colours_for(*matrix, window);
  const EchoCurves curves = curves_per_pulse(*matrix, colours);
  ASSERT_EQ(curves.curves.size(), 11U);
  const double spacing = 441.0 / 11.0;
  EXPECT_NEAR(curves.spacing_px, spacing, 1e-12);
  EXPECT_NEAR(curves.scale_px, 0.375 * spacing, 1e-12);
  const EchoCurve& top = curves.curves[10];
  EXPECT_NEAR(top.base_from.y_px, 0.0, 1e-9);
  EXPECT_NEAR(curves.curves[3].base_from.y_px, 440.0 * 0.7, 1e-9);
  ASSERT_EQ(top.points.size(), 40U);
  // 5 V of the largest magnitude, hypot(5, 3.9).
  EXPECT_NEAR(top.points[0].y_px, -0.375 * spacing * 5.0 / std::hypot(5.0, 3.9), 1e-9);
  EXPECT_NEAR(top.points[20].x_px, 20.0 * core::exact_light_speed_mps / 120e6 / 0.25, 1e-9);
}

TEST(EchoCurves, AreDrawnForEveryNthPulseWhereTheyAreDense) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {400, 99}, numbered);  // 9 pixels apart
  const EchoCurves curves = curves_per_pulse(*matrix, colours_for(*matrix, window));
  ASSERT_EQ(curves.curves.size(), 4U);
  EXPECT_EQ(curves.curves[1].element, 3U);
  EXPECT_NEAR(curves.spacing_px, 27.0, 1e-9);
}

TEST(EchoCurves, OfDecibelsTakeNinePartsOfTenFromFloorToReference) {
  EchoWindow window = small_window();
  window.quantity = DisplayQuantity::decibels;
  const auto matrix = filled_matrix(window, {400, 440}, [](std::size_t, std::size_t k) {
    return k == 0 ? 1.0 : k == 1 ? 1e-9 : std::sqrt(1e-3);
  });
  const EchoCurves curves = curves_per_pulse(*matrix, colours_for(*matrix, window));
  const EchoCurve& c = curves.curves[0];
  EXPECT_NEAR(c.base_from.y_px - c.points[0].y_px, 36.0, 1e-9);
  EXPECT_NEAR(c.base_from.y_px - c.points[1].y_px, 0.0, 1e-9);   // below the floor of -60 dB
  EXPECT_NEAR(c.base_from.y_px - c.points[2].y_px, 18.0, 1e-9);  // -30 dB
}

TEST(EchoCurves, OfRangesStandTwentyPixelsApart) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {120, 99}, numbered);  // 3 pixels a sample
  const EchoCurves curves = curves_per_range(*matrix, colours_for(*matrix, window));
  EXPECT_NEAR(curves.spacing_px, 21.0, 1e-9);
  ASSERT_EQ(curves.curves.size(), 6U);
  EXPECT_EQ(curves.curves[1].element, 7U);
  const EchoCurve& c = curves.curves[1];
  ASSERT_EQ(c.points.size(), 11U);
  EXPECT_LT(c.points[0].x_px, c.base_from.x_px);  // -5 V
  EXPECT_GT(c.points[10].x_px, c.base_from.x_px);
  EXPECT_NEAR(c.points[10].y_px, 0.0, 1e-9);
}

TEST(EchoCurves, OfSilenceAreFlat) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {40, 440}, [](std::size_t, std::size_t) { return 0.0; });
  for (const EchoCurve& c : curves_per_pulse(*matrix, colours_for(*matrix, window)).curves)
    for (const EchoCurve::Point& p : c.points) EXPECT_EQ(p.y_px, c.base_from.y_px);
}

TEST(EchoCurves, OfAPlotWithoutPixelsAreFew) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {0, 0}, numbered);
  const EchoColours colours = colours_for(*matrix, window);
  EXPECT_EQ(curves_per_pulse(*matrix, colours).curves.size(), 1U);
  EXPECT_EQ(curves_per_range(*matrix, colours).curves.size(), 1U);
  EchoImage image;
  paint(*matrix, colours, RowPlacing::own_row, 1, image);
  EXPECT_TRUE(image.pixel.empty());
}

}  // namespace echo_readout_test
}  // namespace sarsim::picture
