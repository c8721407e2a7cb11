#include "signal/measure/sample_statistics.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace sarsim::signal {
namespace sample_statistics_test {

using Samples = std::vector<std::complex<double>>;

TEST(SampleStatistics, FindsTheLargestMagnitudeAcrossBlocks) {
  SampleStatistics statistics;
  statistics.add(Samples{{1, 0}, {0, -2}, {0, 0}, {1, 1}}, 0, 2);
  statistics.add(Samples{{0, 0}, {3, 4}}, 2, 2);
  EXPECT_EQ(statistics.largest_magnitude, 5.0);
  EXPECT_EQ(statistics.largest_row, 2U);
  EXPECT_EQ(statistics.largest_column, 1U);
  EXPECT_EQ(statistics.lowest, -2.0);
  EXPECT_EQ(statistics.highest, 4.0);
  EXPECT_EQ(statistics.zeros, 2U);
  EXPECT_EQ(statistics.samples, 6U);
  EXPECT_DOUBLE_EQ(statistics.rms(), std::sqrt((1.0 + 4.0 + 2.0 + 25.0) / 6.0));
}

TEST(SampleStatistics, NanCountsNowhereElse) {
  SampleStatistics statistics;
  statistics.add(Samples{{std::nan(""), 7}, {3, 4}, {INFINITY, 0}}, 0, 3);
  EXPECT_EQ(statistics.not_finite, 2U);
  EXPECT_EQ(statistics.highest, 4.0);
  EXPECT_EQ(statistics.rms(), 5.0);
}

TEST(SampleStatistics, NothingIsZero) { EXPECT_EQ(SampleStatistics{}.rms(), 0.0); }

}  // namespace sample_statistics_test
}  // namespace sarsim::signal
