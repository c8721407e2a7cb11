#include "signal/search/ppi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/maths/constants.hpp"

namespace sarsim::signal {
namespace ppi_test {

constexpr double degree = core::pi / 180.0;

std::vector<double> edges(std::size_t cells, double first_m, double step_m) {
  std::vector<double> list;
  for (std::size_t i = 0; i <= cells; ++i) list.push_back(first_m + static_cast<double>(i) * step_m);
  return list;
}

struct Pixel {
  double x_m, y_m;
};

// The middle of the brightest pixel.
Pixel brightest(const PpiPicture& picture) {
  const auto& values = picture.values();
  const auto at = static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
  return {picture.grid().x_m(at % picture.grid().columns), picture.grid().y_m(at / picture.grid().columns)};
}

TEST(PpiGrid, ReachesToAllSidesOfItsMiddle) {
  const PpiGrid grid = ppi_grid(100.0, -50.0, 95.0, 10.0);
  EXPECT_EQ(grid.rows, 21u);
  EXPECT_EQ(grid.columns, 21u);
  EXPECT_EQ(grid.x_m(10), 100.0);
  EXPECT_EQ(grid.y_m(10), -50.0);
  EXPECT_EQ(grid.x_m(0), 0.0);
  EXPECT_EQ(grid.y_m(0), 50.0);
  EXPECT_THROW((void)ppi_grid(0, 0, 10, 0), std::invalid_argument);
}

TEST(PpiPicture, PutsACellWhereItsBearingAndRangeAre) {
  for (const double azimuth_deg : {0.0, 37.0, 90.0, 179.5, -120.0, 300.0}) {
    PpiPicture picture(ppi_grid(20.0, -30.0, 1000.0, 5.0));
    const auto ends = edges(60, 100.0, 15.0);
    std::vector<float> strengths(60, 0.1F);
    strengths[41] = 7.0F;
    const double azimuth = azimuth_deg * degree;
    picture.paint({20.0, -30.0, azimuth - degree, azimuth + degree, ends, strengths});
    const Pixel pixel = brightest(picture);
    const double range = std::hypot(pixel.x_m - 20.0, pixel.y_m + 30.0);
    EXPECT_NEAR(range, 722.5, 7.5 + 5.0) << azimuth_deg;
    const double bearing = std::remainder(std::atan2(pixel.x_m - 20.0, pixel.y_m + 30.0) - azimuth, 2.0 * core::pi);
    EXPECT_NEAR(bearing, 0.0, degree + 5.0 / range) << azimuth_deg;
  }
}

TEST(PpiPicture, LosesNoCellThatIsSmallerThanAPixel) {
  PpiPicture picture(ppi_grid(0.0, 0.0, 1000.0, 100.0));
  const auto ends = edges(500, 0.0, 2.0);
  std::vector<float> strengths(500, 0.1F);
  strengths[333] = 9.0F;
  picture.paint({0.0, 0.0, 0.7, 0.7001, ends, strengths});
  EXPECT_EQ(*std::ranges::max_element(picture.values()), 9.0F);
  const Pixel pixel = brightest(picture);
  EXPECT_NEAR(pixel.x_m, 667.0 * std::sin(0.70005), 50.0);
  EXPECT_NEAR(pixel.y_m, 667.0 * std::cos(0.70005), 50.0);
}

TEST(PpiPicture, OfAWholeTurnHasNeitherGapNorOverlap) {
  PpiPicture picture(ppi_grid(0.0, 0.0, 100.0, 1.0));
  const auto ends = edges(9, 10.0, 10.0);
  // Each sector has a strength of its own: a pixel's value must be that of the sector its middle is in, unless the
  // middle of a small cell of a later one is in it, too.
  constexpr int sectors = 73;
  for (int s = 0; s < sectors; ++s) {
    const std::vector<float> strengths(9, static_cast<float>(s + 1));
    picture.paint({0.0, 0.0, 2.0 * core::pi * s / sectors, 2.0 * core::pi * (s + 1) / sectors, ends, strengths});
  }
  std::size_t wrong = 0, inside = 0;
  for (std::size_t row = 0; row < picture.grid().rows; ++row)
    for (std::size_t column = 0; column < picture.grid().columns; ++column) {
      const double x = picture.grid().x_m(column), y = picture.grid().y_m(row);
      const double range = std::hypot(x, y);
      const float value = picture.values()[row * picture.grid().columns + column];
      if (range < 9.0 || range > 101.0) {
        EXPECT_EQ(value, 0.0F);
        continue;
      }
      if (range < 10.0 || range >= 100.0) continue;
      ++inside;
      double turns = std::atan2(x, y) / (2.0 * core::pi);
      if (turns < 0.0) turns += 1.0;
      if (static_cast<double>(value) != std::floor(turns * sectors + 1e-9) + 1.0) ++wrong;
      EXPECT_GT(value, 0.0F) << x << " " << y;
    }
  EXPECT_GT(inside, 30000u);
  EXPECT_LT(wrong, 9u * sectors);
}

TEST(PpiPicture, PaintsSectorsOfAnyWidth) {
  const auto ends = edges(1, 0.0, 50.0);
  const std::vector<float> strengths{1.0F};
  for (const double turn : {0.1, 0.5 * core::pi, 2.0, core::pi, 5.0, 2.0 * core::pi}) {
    PpiPicture picture(ppi_grid(0.0, 0.0, 60.0, 0.5));
    picture.paint({0.0, 0.0, -0.3, -0.3 + turn, ends, strengths});
    const auto painted = static_cast<double>(std::ranges::count(picture.values(), 1.0F)) * 0.25;
    EXPECT_NEAR(painted, 0.5 * turn * 2500.0, 0.01 * turn * 2500.0 + 4.0) << turn;
  }
}

// Wide sectors are painted pixel by pixel, narrow ones cell by cell: it makes no difference where cells are larger than
// pixels.
TEST(PpiPicture, PaintsWideSectorsAsTheirNarrowParts) {
  const auto ends = edges(9, 10.0, 10.0);
  const std::vector<float> strengths{1.0F, 4.0F, 0.0F, 2.0F, 9.0F, 3.0F, 5.0F, 8.0F, 7.0F};
  PpiPicture wide(ppi_grid(3.0, -2.0, 100.0, 1.0));
  PpiPicture narrow(wide.grid());
  const double end_rad = 2.0;
  constexpr int parts = 32;
  wide.paint({0.0, 0.0, 0.0, end_rad, ends, strengths});
  for (int i = 0; i < parts; ++i)
    narrow.paint({0.0, 0.0, end_rad * i / parts, end_rad * (i + 1) / parts, ends, strengths});
  EXPECT_EQ(wide.values(), narrow.values());
}

TEST(PpiPicture, KeepsTheLargestInAnyOrderOfLines) {
  const auto ends = edges(1, 0.0, 50.0);
  const std::vector<float> weak{1.0F}, strong{2.0F};
  PpiPicture one(ppi_grid(0.0, 0.0, 50.0, 1.0)), other(one.grid());
  one.paint({0.0, 0.0, 0.0, 1.0, ends, weak});
  one.paint({0.0, 0.0, 0.5, 1.5, ends, strong});
  other.paint({0.0, 0.0, 0.5, 1.5, ends, strong});
  other.paint({0.0, 0.0, 0.0, 1.0, ends, weak});
  EXPECT_EQ(one.values(), other.values());
  EXPECT_GT(std::ranges::count(one.values(), 1.0F), 100);
  EXPECT_GT(std::ranges::count(one.values(), 2.0F), 100);
}

TEST(PpiPicture, LeavesOutWhatIsBeyondItsEdges) {
  PpiPicture picture(ppi_grid(1e6, 0.0, 50.0, 1.0));
  const auto ends = edges(1, 0.0, 500.0);
  const std::vector<float> strengths{1.0F};
  picture.paint({0.0, 0.0, 0.0, 2.0 * core::pi, ends, strengths});
  EXPECT_EQ(*std::ranges::max_element(picture.values()), 0.0F);
}

TEST(PpiPicture, RefusesWhatMakesNoSense) {
  PpiPicture picture(ppi_grid(0.0, 0.0, 50.0, 1.0));
  const auto ends = edges(2, 0.0, 10.0);
  const std::vector<float> one{1.0F}, two{1.0F, 1.0F};
  EXPECT_THROW(picture.paint({0.0, 0.0, 0.0, 1.0, ends, one}), std::invalid_argument);
  EXPECT_THROW(picture.paint({0.0, 0.0, 1.0, 1.0, ends, two}), std::invalid_argument);
  EXPECT_THROW(picture.paint({0.0, 0.0, 0.0, 7.0, ends, two}), std::invalid_argument);
}

}  // namespace ppi_test
}  // namespace sarsim::signal
