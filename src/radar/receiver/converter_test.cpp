#include "radar/receiver/converter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/report/expect.hpp"

namespace sarsim::radar {
namespace converter_test {

struct Conversion {
  std::vector<std::int64_t> counts;
  ConversionTally tally;
};

Conversion convert(int bits, double lsb_v, const std::vector<std::complex<double>>& volts) {
  Conversion result;
  result.counts.resize(2 * volts.size());
  Converter{bits, lsb_v}.convert(volts, result.counts, result.tally);
  return result;
}

std::int64_t count_of(int bits, double lsbs) { return convert(bits, 1.0, {{lsbs, 0.0}}).counts[0]; }

TEST(FullScaleCount, IsTheLargestPositiveCountButAtLeastOne) {
  EXPECT_EQ(full_scale_count(1), 1.0);
  EXPECT_EQ(full_scale_count(2), 1.0);
  EXPECT_EQ(full_scale_count(8), 127.0);
  EXPECT_EQ(full_scale_count(53), 4503599627370495.0);
}

TEST(Converter, RoundsHalvesUpwards) {
  EXPECT_EQ(count_of(8, 2.5), 3);
  EXPECT_EQ(count_of(8, -2.5), -2);
  EXPECT_EQ(count_of(8, 0.5), 1);
  EXPECT_EQ(count_of(8, -0.5), 0);
  EXPECT_EQ(count_of(8, 2.49), 2);
  EXPECT_EQ(count_of(8, -2.51), -3);
  EXPECT_EQ(count_of(8, std::nextafter(0.5, 0.0)), 0);  // half up is not "add a half and round down"
}

TEST(Converter, ClipsToMinusCAndCPlusOne) {
  EXPECT_EQ(count_of(8, 127.4), 127);
  EXPECT_EQ(count_of(8, 128.0), 128);
  EXPECT_EQ(count_of(8, 200.4), 128);
  EXPECT_EQ(count_of(8, -127.4), -127);
  EXPECT_EQ(count_of(8, -200.0), -127);
  EXPECT_EQ(count_of(1, 7.0), 2);
  EXPECT_EQ(count_of(1, -7.0), -1);
  EXPECT_EQ(count_of(2, 7.0), 2);
  EXPECT_EQ(count_of(2, -7.0), -1);
}

TEST(Converter, IsExactToFiftyThreeBitsAndSoundBeyond) {
  EXPECT_EQ(count_of(53, 0x1p52 - 1.0), 4503599627370495);
  EXPECT_EQ(count_of(53, 1e30), 4503599627370496);
  EXPECT_EQ(count_of(53, -1e30), -4503599627370495);
  EXPECT_EQ(count_of(60, 0x1p52 + 1.0), 4503599627370497);  // odd, and no double has a half beside it
  EXPECT_EQ(count_of(60, -0x1p52 - 3.0), -4503599627370499);
  EXPECT_EQ(count_of(64, 1e30), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(count_of(64, -1e30), -9223372036854774784);  // -(2^63 - 2^10), the next double
}

// Beyond 54 bits C itself is no double; what it is rounded to may not have a bit too many.
TEST(Converter, ClipsToWhatFitsForEveryNumberOfBits) {
  for (int bits = 2; bits < 64; ++bits) {
    const std::int64_t beyond = std::int64_t{1} << (bits - 1);
    EXPECT_EQ(count_of(bits, 1e30), beyond) << bits;
    EXPECT_GT(count_of(bits, -1e30), -beyond) << bits;
    EXPECT_LT(count_of(bits, -1e30), -beyond + (bits > 54 ? beyond >> 52 : 2)) << bits;
  }
  EXPECT_GT(count_of(64, -1e30), std::numeric_limits<std::int64_t>::min());
}

TEST(Converter, PutsIBeforeQAndDividesByTheLeastSignificantBit) {
  const Conversion c = convert(8, 0.25, {{1.0, -2.0}, {0.0, 5.0}});
  EXPECT_EQ(c.counts, (std::vector<std::int64_t>{4, -8, 0, 20}));
}

TEST(Converter, TalliesMaximumClippingAndSilence) {
  const Conversion c =
      convert(8, 1.0, {{0.4, -0.4}, {130.0, 0.0}, {0.0, -128.0}, {3.0, 4.0}, {-0.5, 0.49}, {128.4, 0.0}});
  EXPECT_EQ(c.tally.saturated, 2u);
  EXPECT_EQ(c.tally.zero, 2u);
  EXPECT_EQ(c.tally.maximum_v, 130.0);
}

TEST(Converter, MakesNothingOfWhatIsNoNumberAndClipsInfinity) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const int bits : {1, 8, 64}) {
    const Conversion c = convert(bits, 1.0, {{none, 1.0}, {-1.0, none}, {none, none}, {0.0, 0.0}});
    EXPECT_EQ(c.counts, (std::vector<std::int64_t>{0, 1, -1, 0, 0, 0, 0, 0})) << bits;
    EXPECT_EQ(c.tally.not_numbers, 3u);
    EXPECT_EQ(c.tally.saturated, 0u);
    EXPECT_EQ(c.tally.zero, 2u);
    EXPECT_EQ(c.tally.maximum_v, 0.0);
  }
  const Conversion c = convert(8, 1.0, {{infinite, -infinite}, {none, infinite}});
  EXPECT_EQ(c.counts, (std::vector<std::int64_t>{128, -127, 0, 128}));
  EXPECT_EQ(c.tally.saturated, 2u);
  EXPECT_EQ(c.tally.not_numbers, 1u);
  ConversionTally sum{1.0, 2, 3, 4};
  sum.add({1.0, 2, 3, 40});
  EXPECT_EQ(sum.not_numbers, 44u);
}

TEST(Converter, TalliesWithoutCountsAndAddsToTheTally) {
  ConversionTally tally{7.0, 1, 2};
  const std::vector<std::complex<double>> volts{{3.0, 4.0}, {0.0, 0.0}};
  Converter{8, 1.0}.convert(volts, {}, tally);
  EXPECT_EQ(tally.maximum_v, 7.0);
  EXPECT_EQ(tally.saturated, 1u);
  EXPECT_EQ(tally.zero, 3u);
  tally.add({9.0, 10, 20});
  EXPECT_EQ(tally.maximum_v, 9.0);
  EXPECT_EQ(tally.saturated, 11u);
  EXPECT_EQ(tally.zero, 23u);
}

// A sine over the full range of b bits: noise of an even rounding error, LSB^2/12 against C^2/2.
TEST(Converter, HasTheSignalToNoiseRatioOfItsBits) {
  constexpr int bits = 10;
  const double full = full_scale_count(bits);
  std::vector<std::complex<double>> volts;
  for (int i = 0; i < 20'000; ++i) volts.push_back(std::polar(full, 0.7390851 * i));
  const Conversion c = convert(bits, 1.0, volts);
  double noise = 0.0;
  for (std::size_t i = 0; i < volts.size(); ++i)
    noise += std::norm(volts[i] -
                       std::complex(static_cast<double>(c.counts[2 * i]), static_cast<double>(c.counts[2 * i + 1])));
  const double ratio_db = 10.0 * std::log10(full * full * static_cast<double>(volts.size()) / noise);
  // 40 000 squared errors, each with a relative deviation of sqrt(4/5): 5 sigma are 2.3 %, 0.1 dB; C is 1 % below 2^9.
  EXPECT_NEAR(ratio_db, 6.02 * bits + 1.76, 0.1 + 20.0 * std::log10(512.0 / full));
}

TEST(LargestMagnitude, IsThatOfTheComplexSamples) {
  const std::vector<std::complex<double>> volts{{3.0, -4.0}, {4.9, 0.0}, {0.0, -1.0}};
  EXPECT_EQ(largest_magnitude(volts), 5.0);
  EXPECT_EQ(largest_magnitude({}), 0.0);
}

TEST(Converter, ExpectsTwoCountsForEachSampleAndAnLsb) {
  if (!core::checks_expectations()) GTEST_SKIP() << "this build does not check expectations";
  const std::vector<std::complex<double>> volts(3);
  std::vector<std::int64_t> counts(5);
  ConversionTally tally;
  EXPECT_THROW((Converter{8, 1.0}.convert(volts, counts, tally)), core::BrokenExpectation);
  counts.resize(6);
  EXPECT_THROW((Converter{8, 0.0}.convert(volts, counts, tally)), core::BrokenExpectation);
  EXPECT_NO_THROW((Converter{8, 0.0}.convert(volts, {}, tally)));
}

}  // namespace converter_test
}  // namespace sarsim::radar
