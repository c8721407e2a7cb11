#include "picture/image/point_reading.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "raster/table/computed_raster.hpp"

namespace sarsim::picture {
namespace point_reading_test {

using Weight = std::function<double(double)>;

// The response of a band of width 1 with a weight over it, at a distance in resolution cells: the integral of
// w(u) exp(j 2 pi u d) over -1/2 to 1/2, by the midpoint rule; relative to that at 0.
double response(const Weight& weight, double distance) {
  constexpr int points = 600;
  double sum = 0.0;
  double all = 0.0;
  for (int i = 0; i < points; ++i) {
    const double x = (i + 0.5) / points;
    sum += weight(x) * std::cos(2.0 * core::pi * (x - 0.5) * distance);
    all += weight(x);
  }
  return sum / all;
}

struct Target {
  double row;
  double column;
  std::complex<double> value;
  double row_cell = 1.25;  // Samples of a resolution cell.
  double column_cell = 1.6;
  double row_turn = 0.0;  // Radians from sample to sample: where the spectrum's middle is.
  double column_turn = 0.0;
};

raster::ComputedRaster image_of(const Target& target, const Weight& weight, std::size_t rows = 300,
                                std::size_t columns = 260) {
  std::vector<double> down(rows);
  std::vector<double> across(columns);
  for (std::size_t i = 0; i < rows; ++i)
    down[i] = response(weight, (static_cast<double>(i) - target.row) / target.row_cell);
  for (std::size_t k = 0; k < columns; ++k)
    across[k] = response(weight, (static_cast<double>(k) - target.column) / target.column_cell);
  const auto read = [=](const raster::ImageWindow& window, std::span<std::complex<float>> out) {
    for (std::size_t i = 0; i < window.rows; ++i)
      for (std::size_t k = 0; k < window.cols; ++k) {
        const std::size_t row = window.row0 + i * window.row_step;
        const std::size_t column = window.col0 + k * window.col_step;
        const double turn = target.row_turn * (static_cast<double>(row) - target.row) +
                            target.column_turn * (static_cast<double>(column) - target.column);
        out[i * window.cols + k] =
            std::complex<float>(target.value * down[row] * across[column] * std::polar(1.0, turn));
      }
  };
  return {rows, columns, read};
}

PointReading reading_of(const raster::Raster& plane, std::size_t row, std::size_t column) {
  const auto result = read_point(plane, row, column);
  const auto* problem = std::get_if<core::Problem>(&result);
  EXPECT_EQ(problem, nullptr) << (problem == nullptr ? "" : core::to_string(*problem));
  return problem == nullptr ? std::get<PointReading>(result) : PointReading{};
}

// Widths in resolution cells and levels that theory gives: sin(x)/x, and windows over the band.
struct Theory {
  const char* name;
  Weight weight;
  double width;
  double null;
  double pslr_db;
  double islr_db;  // To 10 null widths.
};

class PointOfWindow : public testing::TestWithParam<Theory> {};

TEST_P(PointOfWindow, HasTheWidthAndSidelobesOfTheory) {
  const Theory& theory = GetParam();
  for (const double turn : {0.0, 1.3, -2.9}) {
    Target target{150.31, 128.77, {3.0, -4.0}};
    target.row_turn = turn;
    target.column_turn = -0.5 * turn;
    const PointReading reading = reading_of(image_of(target, theory.weight), 151, 127);
    EXPECT_NEAR(reading.row, target.row, 0.003);
    EXPECT_NEAR(reading.column, target.column, 0.003);
    EXPECT_NEAR(std::abs(reading.value), 5.0, 0.01);
    EXPECT_NEAR(std::arg(reading.value), std::atan2(-4.0, 3.0), 0.01);
    for (const auto& [cut, cell] :
         {std::pair{reading.along_column, target.row_cell}, {reading.along_row, target.column_cell}}) {
      EXPECT_NEAR(cut.width / cell, theory.width, 0.005);
      EXPECT_NEAR(cut.null / cell, theory.null, 0.06);
      EXPECT_NEAR(cut.pslr_db, theory.pslr_db, theory.pslr_db > -35.0 ? 0.1 : 0.5);
      EXPECT_NEAR(cut.islr_db, theory.islr_db, 0.15);
      EXPECT_NEAR(cut.reach, 10.0 * cut.null, 0.1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Windows, PointOfWindow,
    testing::Values(Theory{"none", [](double) { return 1.0; }, 0.886, 1.0, -13.26, -10.11},
                    Theory{"kaiser_2_5", [](double x) { return core::kaiser_window(2.0 * x - 1.0, 2.5); }, 1.042, 1.281,
                           -20.94, -18.80},
                    Theory{"hamming", core::hamming_window, 1.303, 2.0, -42.7, -35.3},
                    Theory{"hann", [](double x) { return core::hanning_window(x, 0.0); }, 1.441, 2.0, -31.5, -32.9}),
    [](const auto& tested) { return tested.param.name; });

double rectangular(double) { return 1.0; }

TEST(ReadPoint, FindsThePeakNextToTheClickAndNotASidelobe) {
  const Target target{100.0, 90.0, {1.0, 0.0}};
  const PointReading reading = reading_of(image_of(target, rectangular), 97, 93);
  EXPECT_NEAR(reading.row, 100.0, 0.003);
  EXPECT_NEAR(reading.column, 90.0, 0.003);
}

TEST(ReadPoint, SearchesAsFarAsItIsToldInEachDirection) {
  const raster::ComputedRaster image = image_of({100.0, 90.0, {1.0, 0.0}}, rectangular);
  const auto near = read_point(image, 102, 128, {3, 40});
  ASSERT_TRUE(std::holds_alternative<PointReading>(near));
  EXPECT_NEAR(std::get<PointReading>(near).column, 90.0, 0.003);
}

TEST(ReadPoint, GoesUpFromTheSlopeWhereItsSearchEnds) {
  const raster::ComputedRaster image =
      image_of({100.0, 90.0, {1.0, 0.0}, 9.0, 9.0}, [](double x) { return core::hanning_window(x, 0.0); });
  const auto reading = read_point(image, 96, 86, {1, 1});
  ASSERT_TRUE(std::holds_alternative<PointReading>(reading));
  EXPECT_NEAR(std::get<PointReading>(reading).row, 100.0, 0.01);
}

TEST(ReadPoint, SaysOfASidelobeThatAStrongerResponseIsBeside) {
  const Target target{100.0, 90.0, {1.0, 0.0}, 1.25, 4.0};
  const auto reading = read_point(image_of(target, rectangular), 100, 96, {0, 1});  // 1.5 cells beside
  ASSERT_TRUE(std::holds_alternative<PointReading>(reading));
  EXPECT_GT(std::get<PointReading>(reading).along_row.pslr_db, 10.0);
}

TEST(ReadPoint, AtTheCornerOfAnImageKeepsPlaceAndWidth) {
  const Target target{3.4, 256.2, {1.0, 0.0}};
  const PointReading reading =
      reading_of(image_of(target, [](double x) { return core::hanning_window(x, 0.0); }), 3, 256);
  EXPECT_NEAR(reading.row, 3.4, 0.03);
  EXPECT_NEAR(reading.column, 256.2, 0.03);
  EXPECT_NEAR(reading.along_row.width / target.column_cell, 1.441, 0.03);
}

TEST(ReadPoint, SaysWhyThereIsNone) {
  const auto message = [](const raster::Raster& plane, std::size_t row, std::size_t column) {
    const auto result = read_point(plane, row, column);
    return std::holds_alternative<core::Problem>(result) ? core::to_string(std::get<core::Problem>(result))
                                                         : std::string();
  };
  const auto constant = [](float value, std::size_t rows = 50, std::size_t columns = 40) {
    return raster::ComputedRaster(rows, columns,
                                  [value](const raster::ImageWindow&, std::span<std::complex<float>> out) {
                                    std::ranges::fill(out, std::complex<float>(value));
                                  });
  };
  EXPECT_THAT(message(constant(1.0F), 50, 0), testing::HasSubstr("outside the image"));
  EXPECT_THAT(message(constant(1.0F), 0, 40), testing::HasSubstr("outside the image"));
  EXPECT_THAT(message(constant(0.0F), 10, 10), testing::HasSubstr("zero"));
  EXPECT_THAT(message(constant(std::nanf("")), 10, 10), testing::HasSubstr("zero"));
  // A plateau that fills the whole cut.
  EXPECT_THAT(message(constant(1.0F, 500, 500), 250, 250), testing::HasSubstr("no main lobe"));
}

}  // namespace point_reading_test
}  // namespace sarsim::picture
