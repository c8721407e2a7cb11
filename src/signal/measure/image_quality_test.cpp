#include "signal/measure/image_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace image_quality_test
}  // namespace sarsim::signal
