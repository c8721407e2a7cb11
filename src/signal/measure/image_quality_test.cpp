#include "signal/measure/image_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "core/maths/constants.hpp"
#include "core/maths/sinc.hpp"

namespace sarsim::signal {
namespace image_quality_test {

// A point whose spectrum fills the band that the samples have: null to null it is two samples wide.
FocusedImage point_at(double row, double column) {
  FocusedImage image;
  image.azimuth = {0.0, 0.5, 96};
  image.range = {100.0, 2.0, 96};
  image.carrier_hz = 5.3e9;
  image.light_speed_mps = core::exact_light_speed_mps;
  for (int r = 0; r < 96; ++r)
    for (int c = 0; c < 96; ++c)
      image.values.push_back(static_cast<float>(3.0 * core::sinc(r - row) * core::sinc(c - column)) *
                             std::polar(1.0F, 0.7F));
  return image;
}

TEST(MeasurePoint, FindsPeaksHalfWayBetweenCoarseSamples) {
  for (const double offset : {0.0, 0.2, 0.42, 0.49}) {
    const FocusedImage image = point_at(48.0 + offset, 48.0 - offset);
    const auto found = measure_point(image, reader_of(image), {24.0, 196.0}, 3.0);
    ASSERT_TRUE(found) << offset;
    // The tails beyond the piece that is transformed are missing, 1 % of the peak in each direction.
    EXPECT_NEAR(found->place.azimuth_m, 0.5 * (48.0 + offset), 0.5 * 0.01) << offset;
    EXPECT_NEAR(found->place.range_m, 100.0 + 2.0 * (48.0 - offset), 2.0 * 0.01) << offset;
    EXPECT_NEAR(found->amplitude, 3.0, 0.03 * 3.0) << offset;
    EXPECT_NEAR(found->phase_rad, 0.7, 0.001) << offset;
    EXPECT_NEAR(found->azimuth.width, 0.886 * 0.5, 0.015 * 0.443) << offset;
    EXPECT_NEAR(found->range.width, 0.886 * 2.0, 0.015 * 1.772) << offset;
  }
}

TEST(MeasurePoint, GivesTheCutsThatItMeasured) {
  const FocusedImage image = point_at(48.3, 47.6);
  PointCuts cuts;
  const auto found = measure_point(image, reader_of(image), {24.0, 195.0}, 3.0, &cuts);
  ASSERT_TRUE(found);
  for (const ResponseCut* cut : {&cuts.azimuth, &cuts.range}) {
    ASSERT_EQ(cut->values.size() % 2, 1U);
    EXPECT_NEAR(std::abs(cut->values[cut->values.size() / 2]), found->amplitude, 1e-6);
  }
  EXPECT_NEAR(cuts.azimuth.step_m, 0.5 / 32.0, 1e-12);
  EXPECT_NEAR(cuts.range.step_m, 2.0 / 32.0, 1e-12);
  // The first null, a sample beside the peak.
  EXPECT_LT(std::abs(cuts.range.values[cuts.range.values.size() / 2 + 32]), 0.02 * found->amplitude);
}

// A point seen under squint: its spectrum is a rectangle of `band` along the line of sight and `aperture` across it,
// which the axes of the image hold as a slanting one.
struct SquintedPoint {
  double squint_rad = 0.0;
  double band_per_m = 0.0;
  double aperture_per_m = 0.0;
  ImagePlace place{};
};

FocusedImage image_of(const SquintedPoint& point, double row_m, double column_m, std::size_t rows,
                      std::size_t columns) {
  constexpr double carrier_per_m = 64.0;
  const double sine = std::sin(point.squint_rad), cosine = std::cos(point.squint_rad);
  FocusedImage image;
  image.carrier_hz = 0.5 * carrier_per_m * core::exact_light_speed_mps;
  image.light_speed_mps = core::exact_light_speed_mps;
  image.azimuth = {1000.0, row_m, rows, carrier_per_m * sine};
  image.range = {3000.0, column_m, columns, carrier_per_m * (cosine - 1.0)};
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const double azimuth_m = image.azimuth.at(static_cast<double>(r)) - point.place.azimuth_m;
      const double range_m = image.range.at(static_cast<double>(c)) - point.place.range_m;
      const double along_m = sine * azimuth_m + cosine * range_m;
      const double across_m = cosine * azimuth_m - sine * range_m;
      const double turns =
          image.azimuth.spectrum_centre_per_m * azimuth_m + image.range.spectrum_centre_per_m * range_m;
      image.values.push_back(std::complex<float>(2.0 * core::sinc(point.band_per_m * along_m) *
                                                 core::sinc(point.aperture_per_m * across_m) *
                                                 std::polar(1.0, 2.0 * core::pi * (turns - std::round(turns)))));
    }
  return image;
}

// Rows a tenth of a cell apart, columns nearly a cell: the largest sample may lie ten rows from the peak, along the
// ridge. What the piece that is transformed leaves out of the side lobes is 1 % of the peak in either direction.
TEST(MeasurePoint, FindsPeaksOnTheRidgesOfSquint) {
  std::mt19937 random(20261129);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int draw = 0; draw < 40; ++draw) {
    SquintedPoint point;
    point.squint_rad = between(20.0, 55.0) * core::pi / 180.0;
    point.band_per_m = between(0.2, 1.0);
    point.aperture_per_m = between(0.3, 3.0);
    const double sine = std::sin(point.squint_rad), cosine = std::cos(point.squint_rad);
    // As close together as the slanting spectrum needs, rows up to six times closer.
    const double row_m = between(0.15, 0.9) / (sine * point.band_per_m + cosine * point.aperture_per_m);
    const double column_m = between(0.8, 0.95) / (cosine * point.band_per_m + sine * point.aperture_per_m);
    point.place = {1000.0 + row_m * (150.0 + between(-0.5, 0.5)), 3000.0 + column_m * (60.0 + between(-0.5, 0.5))};
    const FocusedImage image = image_of(point, row_m, column_m, 300, 120);
    const auto found = measure_point(image, reader_of(image), point.place, 2.0 / point.band_per_m);
    ASSERT_TRUE(found) << draw;
    const double azimuth_m = found->place.azimuth_m - point.place.azimuth_m;
    const double range_m = found->place.range_m - point.place.range_m;
    EXPECT_NEAR((sine * azimuth_m + cosine * range_m) * point.band_per_m, 0.0, 0.02) << draw;
    EXPECT_NEAR((cosine * azimuth_m - sine * range_m) * point.aperture_per_m, 0.0, 0.02) << draw;
    EXPECT_NEAR(20.0 * std::log10(found->amplitude / 2.0), 0.0, 0.1) << draw;
  }
}

// A stronger point just beyond the area that is searched does not hide the one in it.
TEST(MeasurePoint, IsNotDrawnOutOfTheAreaByAStrongerNeighbour) {
  FocusedImage image = point_at(48.0, 48.0);
  for (std::size_t r = 0; r < 96; ++r)
    for (std::size_t c = 0; c < 96; ++c)
      image.values[r * 96 + c] += 20.0F * static_cast<float>(core::sinc(static_cast<double>(r) - 55.0) *
                                                             core::sinc(static_cast<double>(c) - 48.0));
  const auto found = measure_point(image, reader_of(image), {24.0, 196.0}, 3.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->place.azimuth_m, 24.0, 0.25);
}

}  // namespace image_quality_test
}  // namespace sarsim::signal
