#include "radar/echo/doppler_terms.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace sarsim::radar {
namespace doppler_terms_test {

TEST(TermsFor, KeepTheRemainderOfChebyshevInterpolation) {
  EXPECT_EQ(terms_for(0.0, 1e-9), 1u);
  for (const double z : {1e-6, 0.1, 1.0, 5.0})
    for (const double error : {1e-3, 1e-7}) {
      const std::size_t terms = terms_for(z, error);
      ASSERT_LE(terms, max_doppler_terms);
      const auto remainder = [z](std::size_t r) {
        return 2.0 * std::pow(0.5 * z, static_cast<double>(r)) / std::tgamma(static_cast<double>(r) + 1.0);
      };
      EXPECT_LT(remainder(terms), error);
      if (terms > 1) {
        EXPECT_GE(remainder(terms - 1), error);
      }
    }
  EXPECT_GT(terms_for(1e3, 1e-7), max_doppler_terms);
}

TEST(SpanCovering, HoldsItsEndsOnFewRungs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double a = 1e-5 * unit(random), b = 1e-5 * unit(random);
    const DopplerSpan span = span_covering(std::min(a, b), std::max(a, b));
    EXPECT_LE(span.middle - span.half, std::min(a, b));
    EXPECT_GE(span.middle + span.half, std::max(a, b));
    EXPECT_EQ(std::exp2(std::round(std::log2(span.half))), span.half);
  }
}

TEST(SpanCovering, TakesTheNextRungOnlyWhereItMust) {
  EXPECT_EQ(span_covering(-0.5, 0.5), (DopplerSpan{0.0, 0.5}));
  // 0.875 of a rung fits it wherever it lies.
  for (double middle = -0.5; middle < 0.5; middle += 0.01)
    EXPECT_EQ(span_covering(middle - 0.87, middle + 0.87).half, 1.0) << middle;
}

// Bends of 1e6 rad per unit that change by a thousandth from pulse to pulse share spectra; none are made for a trifle.
TEST(BendsCovering, AreNoneForATrifleAndSharedByNeighbours) {
  constexpr double rad = 1e6, error = 1e-6;
  EXPECT_EQ(bends_covering(-2e-13, 2e-13, rad, error), DopplerSpan{});
  const DopplerSpan one = bends_covering(1.0000e-10, 1.0001e-10, rad, error);
  EXPECT_EQ(bends_covering(1.0002e-10, 1.0003e-10, rad, error), one);
  EXPECT_NEAR(one.middle, 1e-10, 0.5 * error / rad);
  EXPECT_EQ(one.half, 0.0);
  const DopplerSpan wide = bends_covering(-3e-10, 5e-10, rad, error);
  EXPECT_LE(wide.middle - wide.half, -3e-10);
  EXPECT_GE(wide.middle + wide.half, 5e-10);
}

TEST(SpanWithin, HoldsWhatItIsForOnTheCoarsestLadder) {
  for (double lowest = -3.0; lowest < 3.0; lowest += 0.03)
    for (const double width : {0.0, 0.2, 1.0, 1.7}) {
      const DopplerSpan span = span_within(lowest, lowest + width, 1.0).value();
      EXPECT_EQ(span.half, 1.0);
      EXPECT_LE(span.middle - 1.0, lowest);
      EXPECT_GE(span.middle + 1.0, lowest + width);
      EXPECT_EQ(std::remainder(span.middle, width <= 1.0 ? 1.0 : width <= 1.5 ? 0.5 : 0.125), 0.0);
    }
  EXPECT_FALSE(span_within(0.3, 2.29, 1.0).has_value());
  EXPECT_FALSE(span_within(0.0, 2.1, 1.0).has_value());
}

}  // namespace doppler_terms_test
}  // namespace sarsim::radar
