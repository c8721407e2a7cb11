#include "picture/colour/display_quantity.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace sarsim::picture {
namespace display_quantity_test {

using Samples = std::vector<std::complex<double>>;

SampleStatistics statistics(const Samples& samples, double percentile = 100.0) {
  SampleStatistics s = statistics_of(samples);
  if (percentile < 100.0)
    s.percentile_v = magnitude_percentile(
        1, [&](std::size_t) { return std::span(samples); }, percentile);
  return s;
}

TEST(DisplayQuantity, ValuesAreThoseOfTheSample) {
  const std::complex<double> s(-3.0, 4.0);
  EXPECT_EQ(value_of(DisplayQuantity::real, s), -3.0);
  EXPECT_EQ(value_of(DisplayQuantity::imaginary, s), 4.0);
  EXPECT_EQ(value_of(DisplayQuantity::magnitude, s), 5.0);
  EXPECT_NEAR(value_of(DisplayQuantity::phase, s), 126.8698976, 1e-6);
  EXPECT_NEAR(value_of(DisplayQuantity::decibels, s, 0.5), 20.0, 1e-12);
  EXPECT_NEAR(value_of(DisplayQuantity::decibels, s, 10.0), -6.0206, 1e-4);
  EXPECT_EQ(value_of(DisplayQuantity::decibels, 0.0), lowest_db);
  EXPECT_TRUE(std::isnan(value_of(DisplayQuantity::decibels, std::nan(""))));
}

TEST(DisplayQuantity, HasAUnitATitleAndAKindOfMap) {
  EXPECT_EQ(unit_of(DisplayQuantity::real), "V");
  EXPECT_EQ(unit_of(DisplayQuantity::phase), "deg");
  EXPECT_EQ(unit_of(DisplayQuantity::decibels), "dB");
  EXPECT_EQ(title_of(DisplayQuantity::decibels), "dB power");
  EXPECT_EQ(axis_title_of(DisplayQuantity::decibels), "Power");
  EXPECT_EQ(axis_title_of(DisplayQuantity::magnitude), "Magnitude");
  EXPECT_EQ(kind_for(DisplayQuantity::imaginary), ColourMapKind::diverging);
  EXPECT_EQ(kind_for(DisplayQuantity::phase), ColourMapKind::cyclic);
  EXPECT_EQ(kind_for(DisplayQuantity::magnitude), ColourMapKind::sequential);
}

TEST(SampleStatistics, LookAtFiniteSamplesOnly) {
  const SampleStatistics s =
      statistics({{1.0, -2.0}, {-3.0, 4.0}, {std::numeric_limits<double>::infinity(), 0.0}, {std::nan(""), 0.0}});
  EXPECT_EQ(s.count, 2U);
  EXPECT_EQ(s.largest_v, 5.0);
  EXPECT_NEAR(s.smallest_v, std::sqrt(5.0), 1e-12);
  EXPECT_EQ(s.lowest_real_v, -3.0);
  EXPECT_EQ(s.highest_real_v, 1.0);
  EXPECT_EQ(s.lowest_imaginary_v, -2.0);
  EXPECT_EQ(s.highest_imaginary_v, 4.0);
  EXPECT_EQ(s.percentile_v, 5.0);
  EXPECT_EQ(statistics({}).count, 0U);
}

TEST(SampleStatistics, OfTwoSetsAreThoseOfAllTheirSamples) {
  const Samples a{{1.0, -2.0}, {-3.0, 4.0}};
  const Samples b{{7.0, 0.5}, {0.1, 0.2}};
  Samples all = a;
  all.insert(all.end(), b.begin(), b.end());
  const SampleStatistics s = together(statistics(a), statistics(b));
  const SampleStatistics expected = statistics(all);
  EXPECT_EQ(s.count, 4U);
  EXPECT_EQ(s.largest_v, expected.largest_v);
  EXPECT_EQ(s.smallest_v, expected.smallest_v);
  EXPECT_EQ(s.lowest_real_v, expected.lowest_real_v);
  EXPECT_EQ(s.highest_real_v, expected.highest_real_v);
  EXPECT_EQ(s.lowest_imaginary_v, expected.lowest_imaginary_v);
  EXPECT_EQ(s.highest_imaginary_v, expected.highest_imaginary_v);
  EXPECT_EQ(together({}, statistics(a)).smallest_v, statistics(a).smallest_v);
  EXPECT_EQ(together(statistics(a), {}).lowest_real_v, -3.0);
  EXPECT_EQ(magnitude_percentile(0, {}, 50.0), 0.0);
}

TEST(SampleStatistics, PercentileLeavesTheStrongestOut) {
  Samples samples;
  for (int i = 1; i <= 101; ++i) samples.emplace_back(i, 0.0);
  samples.back() = 1e6;
  EXPECT_EQ(statistics(samples, 99.0).percentile_v, 100.0);
  EXPECT_EQ(statistics(samples, 50.0).percentile_v, 51.0);
  EXPECT_EQ(statistics(samples, 50.0).largest_v, 1e6);
}

TEST(SampleStatistics, PercentileOfManySamplesIsTakenFromSomeOfThem) {
  Samples samples;
  for (int i = 0; i < 1'000'000; ++i) samples.emplace_back(i % 1000, 0.0);
  EXPECT_NEAR(statistics(samples, 90.0).percentile_v, 900.0, 10.0);
}

TEST(ColourLimits, OfSignedQuantitiesAreSymmetricAboutZero) {
  const SampleStatistics s = statistics({{-1.0, 0.5}, {4.0, 0.0}});
  EXPECT_EQ(colour_limits(DisplayQuantity::real, {}, {}, s), (ColourLimits{-4.0, 4.0}));
  EXPECT_EQ(colour_limits(DisplayQuantity::imaginary, {}, {}, s), (ColourLimits{-4.0, 4.0}));
  EXPECT_EQ(colour_limits(DisplayQuantity::magnitude, {}, {}, s), (ColourLimits{0.0, 4.0}));
}

TEST(ColourLimits, OfThePhaseAreAFullTurnWhateverTheRule) {
  const LimitRule manual{LimitRule::Kind::manual, 100.0, 1.0, 2.0};
  EXPECT_EQ(colour_limits(DisplayQuantity::phase, manual, {}, {}), (ColourLimits{-180.0, 180.0}));
}

TEST(ColourLimits, OfDecibelsReachFromTheReferenceDownByTheRange) {
  const SampleStatistics s = statistics({{0.1, 0.0}, {10.0, 0.0}});
  EXPECT_EQ(colour_limits(DisplayQuantity::decibels, {}, {Decibels::Reference::maximum, 1.0, 40.0}, s),
            (ColourLimits{-40.0, 0.0}));
  const ColourLimits absolute =
      colour_limits(DisplayQuantity::decibels, {}, {Decibels::Reference::volts, 0.1, 50.0}, s);
  EXPECT_NEAR(absolute.high, 40.0, 1e-12);
  EXPECT_NEAR(absolute.low, -10.0, 1e-12);
  EXPECT_EQ(reference_v({Decibels::Reference::maximum, 1.0, 40.0}, s), 10.0);
  EXPECT_EQ(reference_v({Decibels::Reference::volts, 0.1, 40.0}, s), 0.1);
  EXPECT_EQ(reference_v({}, {}), 1.0);
}

TEST(ColourLimits, OfTheOriginalAreTheExtremes) {
  const LimitRule rule{LimitRule::Kind::extremes, 100.0, 0.0, 1.0};
  const SampleStatistics s = statistics({{-1.0, 0.5}, {4.0, 0.0}});
  EXPECT_EQ(colour_limits(DisplayQuantity::real, rule, {}, s), (ColourLimits{-1.0, 4.0}));
  EXPECT_EQ(colour_limits(DisplayQuantity::imaginary, rule, {}, s), (ColourLimits{0.0, 0.5}));
  EXPECT_EQ(colour_limits(DisplayQuantity::decibels, rule, {}, statistics({{0.0, 0.0}, {2.0, 0.0}})),
            (ColourLimits{-200.0, 0.0}));
}

TEST(ColourLimits, ThatCoincideOrAreReversedAreMended) {
  const SampleStatistics silent = statistics({{0.0, 0.0}});
  const ColourLimits limits = colour_limits(DisplayQuantity::magnitude, {}, {}, silent);
  EXPECT_LT(limits.low, limits.high);
  const LimitRule reversed{LimitRule::Kind::manual, 100.0, 2.0, -1.0};
  EXPECT_EQ(colour_limits(DisplayQuantity::real, reversed, {}, silent), (ColourLimits{-1.0, 2.0}));
  const LimitRule equal{LimitRule::Kind::manual, 100.0, 2.0, 2.0};
  EXPECT_LT(colour_limits(DisplayQuantity::real, equal, {}, silent).low, 2.0);
}

TEST(ColourIndex, DividesTheLimitsIntoEqualSharesAndEndsAtThem) {
  const ColourLimits limits{-1.0, 1.0};
  EXPECT_EQ(colour_index(-1.0, limits, 256), 0U);
  EXPECT_EQ(colour_index(-7.0, limits, 256), 0U);
  EXPECT_EQ(colour_index(-1.0 + 2.5 / 128.0, limits, 256), 2U);
  EXPECT_EQ(colour_index(0.0, limits, 256), 128U);
  EXPECT_EQ(colour_index(1.0, limits, 256), 255U);
  EXPECT_EQ(colour_index(9.0, limits, 256), 255U);
  EXPECT_EQ(colour_index(std::numeric_limits<double>::infinity(), limits, 256), 255U);
  EXPECT_EQ(colour_index(std::nan(""), limits, 256), 0U);
}

TEST(ColourIndex, OfACyclicQuantityWrapsAround) {
  const ColourLimits turn{-180.0, 180.0};
  EXPECT_EQ(colour_index(180.0, turn, 256, true), 0U);
  EXPECT_EQ(colour_index(-180.0, turn, 256, true), 0U);
  EXPECT_EQ(colour_index(179.0, turn, 256, true), 255U);
  EXPECT_EQ(colour_index(181.0, turn, 256, true), colour_index(-179.0, turn, 256, true));
}

}  // namespace display_quantity_test
}  // namespace sarsim::picture
