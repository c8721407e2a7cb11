#include "picture/echo/echo_picture.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "picture/echo/preview_test_scene.hpp"

namespace sarsim::picture {
namespace echo_picture_test {

// 11 pulses from 0 to 10 ms and 40 samples.
EchoWindow small_window() {
  EchoWindow window = flight_window();
  set_view(window, {2000.0, 2100.0, 0.0, 0.01});
  return window;
}

std::complex<double> numbered(std::size_t r, std::size_t k) {
  return {static_cast<double>(r) - 5.0, static_cast<double>(k)};
}

TEST(Paint, GivesEveryPixelTheColourOfItsNearestSample) {
  const EchoWindow window = small_window();
  const PlotSize size{97, 53};
  const auto matrix = filled_matrix(window, size, numbered);
  ASSERT_EQ(matrix->rows(), 11U);
  ASSERT_EQ(matrix->columns(), 40U);
  const EchoColours colours = colours_for(*matrix, window);
  EchoImage image;
  paint(*matrix, colours, RowPlacing::nearest, 2, image);
  ASSERT_EQ(image.pixel.size(), 97U * 53U);
  const EchoView view = view_of(window);
  for (std::size_t y = 0; y < 53; ++y)
    for (std::size_t x = 0; x < 97; ++x) {
      const double time = time_at(view, size, static_cast<double>(y));
      const double range = range_at(view, size, static_cast<double>(x));
      const auto r = static_cast<std::size_t>(std::clamp(std::lround(time / 1e-3), 0L, 10L));
      const auto k = static_cast<std::size_t>(
          std::clamp(std::lround((range - 2000.0) / (core::exact_light_speed_mps / 120e6)), 0L, 39L));
      if (std::abs(time / 1e-3 - std::floor(time / 1e-3) - 0.5) < 1e-6) continue;  // halfway between two
      const double value = value_of(DisplayQuantity::real, numbered(r, k));
      EXPECT_EQ(image.at(x, y), colours.level[colour_index(value, colours.limits, 256)]) << x << " " << y;
    }
}

TEST(Paint, PutsTheLatestPulseAtTheTop) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {40, 11}, numbered);
  EchoColours colours = colours_for(*matrix, window);
  colours.limits = {-5.0, 5.0};
  EchoImage image;
  paint(*matrix, colours, RowPlacing::nearest, 1, image);
  EXPECT_EQ(image.at(0, 0), colours.level.back());    // row 10: +5
  EXPECT_EQ(image.at(0, 10), colours.level.front());  // row 0: -5
}

TEST(Paint, LeavesRowsEmptyBetweenPulsesThatFillOneEach) {
  EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {40, 101}, numbered);
  const EchoColours colours = colours_for(*matrix, window);
  EchoImage image;
  paint(*matrix, colours, RowPlacing::own_row, 2, image);
  for (std::size_t y = 0; y < 101; ++y) EXPECT_EQ(image.at(3, y) != 0, y % 10 == 0) << y;
  paint(*matrix, colours, RowPlacing::nearest, 2, image);
  for (std::size_t y = 0; y < 101; ++y) EXPECT_NE(image.at(3, y), 0U);
}

TEST(Paint, RepeatsRowsUntilTheirNeighboursAreReady) {
  const EchoWindow window = small_window();
  const auto full = filled_matrix(window, {40, 11}, numbered);
  EchoMatrix matrix(std::make_shared<const simulate::Plan>(full->plan()), window, {40, 11});
  EchoImage image;
  paint(matrix, colours_for(matrix, window), RowPlacing::nearest, 1, image);
  for (const std::uint32_t pixel : image.pixel) EXPECT_EQ(pixel, 0U);
  std::ranges::copy(full->row(5), matrix.samples().begin() + 5 * 40);
  matrix.set_ready(5);
  EchoWindow imaginary = window;
  imaginary.quantity = DisplayQuantity::imaginary;
  paint(matrix, colours_for(matrix, imaginary), RowPlacing::nearest, 1, image);
  for (std::size_t y = 0; y < 11; ++y) EXPECT_EQ(image.at(39, y), image.at(39, 5));
  EXPECT_NE(image.at(39, 5), image.at(1, 5));
}

TEST(Paint, IsTheSameOnAnyNumberOfThreads) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {300, 200}, numbered);
  const EchoColours colours = colours_for(*matrix, window);
  EchoImage one;
  EchoImage many;
  paint(*matrix, colours, RowPlacing::nearest, 1, one);
  paint(*matrix, colours, RowPlacing::nearest, 5, many);
  EXPECT_EQ(one.pixel, many.pixel);
}

// Random samples over 300 dB, with zero, infinity and no number at all.
TEST(LevelOf, IsThatOfTheValueForEveryQuantity) {
  const EchoWindow window = small_window();
  const auto matrix = filled_matrix(window, {40, 11}, numbered);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const DisplayQuantity quantity : {DisplayQuantity::real, DisplayQuantity::imaginary, DisplayQuantity::magnitude,
                                         DisplayQuantity::phase, DisplayQuantity::decibels}) {
    EchoWindow how = window;
    how.quantity = quantity;
    for (const ColourMap map : {ColourMap::ocean, ColourMap::classic_grey}) {
      how.map = map;
      const EchoColours colours = colours_for(*matrix, how);
      for (int i = 0; i < 20000; ++i) {
        const std::complex<double> v =
            std::complex(normal(random), normal(random)) * std::pow(10.0, i % 10 == 0 ? 7.0 * normal(random) : 1.0);
        const double value = value_of(quantity, v, colours.reference_v);
        const std::size_t level = level_of(colours, v);
        const bool cyclic = quantity == DisplayQuantity::phase;
        // Rounding may decide where a value lies on the border of two levels.
        const double hair = 1e-9 * (colours.limits.high - colours.limits.low) + (cyclic ? 3e-6 : 0.0);
        EXPECT_TRUE(level == colour_index(value - hair, colours.limits, colours.level.size(), cyclic) ||
                    level == colour_index(value + hair, colours.limits, colours.level.size(), cyclic))
            << value << " " << level;
      }
      EXPECT_LT(level_of(colours, {std::nan(""), std::nan("")}), colours.level.size());
    }
  }
}

TEST(ColoursFor, DecibelsOfSilenceAreTheLowest) {
  EchoWindow how = small_window();
  how.quantity = DisplayQuantity::decibels;
  const auto matrix = filled_matrix(how, {40, 11}, numbered);
  const EchoColours colours = colours_for(*matrix, how);
  EXPECT_EQ(level_of(colours, 0.0), 0U);
  EXPECT_EQ(level_of(colours, std::complex(-5.0, 39.0)), 255U);
  EXPECT_EQ(colours.limits, (ColourLimits{-60.0, 0.0}));
  EXPECT_NEAR(colours.reference_v, std::hypot(5.0, 39.0), 1e-12);
}

TEST(DrawnAs, CurvesByItselfOnlyWherePulsesAreTwentyPixelsApart) {
  EchoWindow how = small_window();
  EXPECT_EQ(drawn_as(how, *filled_matrix(how, {40, 220}, numbered)), DrawAs::curves_per_pulse);
  EXPECT_EQ(drawn_as(how, *filled_matrix(how, {40, 219}, numbered)), DrawAs::pixels);
  how.draw_as = DrawAs::curves_per_range;
  EXPECT_EQ(drawn_as(how, *filled_matrix(how, {40, 219}, numbered)), DrawAs::curves_per_range);
}

TEST(ColourBar, RunsFromTheHighestValueDown) {
  const EchoWindow how = small_window();
  const EchoColours colours = colours_for(*filled_matrix(how, {40, 11}, numbered), how);
  const ColourBar bar = colour_bar(colours, 512, 40.0);
  EXPECT_EQ(bar.pixel.front(), colours.level.back());
  EXPECT_EQ(bar.pixel.back(), colours.level.front());
  EXPECT_EQ(bar.ticks.unit, "V");
  EXPECT_GE(bar.ticks.ticks.size(), 5U);
}

TEST(PlotAxes, MarkRangeDelayAndTimeWhereTheyLie) {
  const EchoView view{3000.0, 6000.0, -0.5, 0.5};
  const PlotSize size{600, 401};
  const PlotAxes axes = plot_axes(view, size, 3e8, 60.0);
  EXPECT_EQ(axes.range.title, "Slant range (km)");
  EXPECT_EQ(axes.delay.title, "Delay (µs)");
  EXPECT_EQ(axes.time.title, "Azimuth (ms)");
  ASSERT_GE(axes.range.marks.size(), 4U);
  EXPECT_NEAR(axes.range.marks[1].px, (std::stod(axes.range.marks[1].label) * 1e3 - 3000.0) / 5.0, 1e-6);
  // 1 us is 150 m.
  EXPECT_NEAR(axes.delay.marks[1].px, (std::stod(axes.delay.marks[1].label) * 150.0 - 3000.0) / 5.0, 1e-6);
  EXPECT_GT(axes.time.marks.front().px, axes.time.marks.back().px);  // upwards
}

TEST(HighestMagnitude, IsInMillivoltsOrUnknown) {
  SampleStatistics statistics;
  EXPECT_EQ(highest_magnitude_text(statistics), "Highest magnitude: unknown");
  statistics.count = 1;
  statistics.largest_v = 4.0985e-8;
  EXPECT_EQ(highest_magnitude_text(statistics), "Highest magnitude: 40.985 nV");
}

}  // namespace echo_picture_test
}  // namespace sarsim::picture
