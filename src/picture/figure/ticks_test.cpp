#include "picture/figure/ticks.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sarsim::picture {
namespace ticks_test {

using testing::ElementsAre;

std::vector<std::string> labels(const Ticks& ticks) {
  std::vector<std::string> texts;
  for (const Tick& tick : ticks.ticks) texts.push_back(tick.label);
  return texts;
}

TEST(Ticks, ShareOnePrefix) {
  const Ticks ticks = axis_ticks(0.0, 10'000.0, 500.0, 100.0, "m");
  EXPECT_EQ(ticks.unit, "km");
  EXPECT_EQ(ticks.scale, 1000.0);
  EXPECT_THAT(labels(ticks), ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_DOUBLE_EQ(ticks.ticks[3].value, 6000.0);
}

TEST(Ticks, ShowTheDecimalsOfTheirStep) {
  EXPECT_THAT(labels(axis_ticks(0.0, 0.01, 400.0, 100.0, "s")), ElementsAre("0", "5", "10"));
  EXPECT_THAT(labels(axis_ticks(1.0, 2.0, 400.0, 100.0, "s")), ElementsAre("1.0", "1.5", "2.0"));
  EXPECT_THAT(labels(axis_ticks(-0.5, 0.5, 500.0, 100.0, "")), ElementsAre("−0.4", "−0.2", "0", "0.2", "0.4"));
}

TEST(Ticks, AreTwoAtLeastWhereShortLabelsHaveRoom) {
  EXPECT_THAT(labels(axis_ticks(-28.0, 28.0, 100.0, 80.0, "m")), ElementsAre("−20", "0", "20"));
  EXPECT_THAT(labels(axis_ticks(10'010.0, 10'510.0, 100.0, 80.0, "m")), ElementsAre("10.2", "10.4"));
  EXPECT_EQ(axis_ticks(1'000'010.0, 1'000'510.0, 100.0, 80.0, "Hz").ticks.size(), 1U);  // "1000.2" has none.
  EXPECT_EQ(axis_ticks(-28.0, 28.0, 30.0, 80.0, "m").ticks.size(), 1U);
}

TEST(Ticks, RunFromFirstToLast) {
  EXPECT_THAT(labels(axis_ticks(3.0, 0.0, 300.0, 100.0, "")), ElementsAre("3", "2", "1", "0"));
}

TEST(Ticks, DecibelsAndDegreesTakeNoPrefix) {
  EXPECT_EQ(axis_ticks(-200.0, 2000.0, 300.0, 50.0, "dB").unit, "dB");
  EXPECT_EQ(axis_ticks(0.0, 0.002, 300.0, 50.0, "deg").unit, "deg");
  EXPECT_EQ(axis_ticks(0.0, 5e6, 300.0, 50.0, "").scale, 1.0);
  EXPECT_EQ(axis_ticks(0.0, 5e6, 300.0, 50.0, "Hz").unit, "MHz");
  EXPECT_EQ(axis_ticks(0.0, 3e-6, 300.0, 50.0, "s").unit, "µs");
  EXPECT_EQ(axis_ticks(0.0, 3e-6, 300.0, 50.0, "m2").unit, "m²");
}

TEST(Ticks, AnEmptyOrInfiniteSpanHasNone) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(axis_ticks(1.0, 1.0, 300.0, 50.0, "m").ticks.empty());
  EXPECT_TRUE(axis_ticks(0.0, infinity, 300.0, 50.0, "m").ticks.empty());
  EXPECT_TRUE(axis_ticks(std::nan(""), 1.0, 300.0, 50.0, "m").ticks.empty());
  EXPECT_TRUE(axis_ticks(0.0, 1.0, 0.0, 50.0, "m").ticks.empty());
  EXPECT_TRUE(axis_ticks(1e9, 1e9 + 1e-7, 300.0, 50.0, "m").ticks.empty());
  EXPECT_TRUE(axis_ticks(-1.7e308, 1.7e308, 300.0, 50.0, "m").ticks.empty());
}

double number_of(const std::string& label) {
  constexpr std::string_view minus = "−";
  return label.starts_with(minus) ? -std::stod(label.substr(minus.size())) : std::stod(label);
}

std::size_t max_letters(const Ticks& ticks) {
  std::size_t most = 0;
  for (const Tick& tick : ticks.ticks) most = std::max(most, tick.label.size() - (tick.label.starts_with("−") ? 2 : 0));
  return most;
}

TEST(Ticks, KeepTheirDistanceAndStayInTheSpan) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-11.0, 12.0), side(-1.0, 1.0), length(30.0, 2000.0);
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10.0, exponent(random));
    const double a = size * side(random);
    const double b = size * side(random);
    const double length_px = length(random);
    const Ticks ticks = axis_ticks(a, b, length_px, 40.0, "m");
    const double span = std::abs(b - a);
    for (std::size_t k = 0; k < ticks.ticks.size(); ++k) {
      EXPECT_GE(ticks.ticks[k].value, std::min(a, b) - 1e-8 * size);
      EXPECT_LE(ticks.ticks[k].value, std::max(a, b) + 1e-8 * size);
      EXPECT_NEAR(number_of(ticks.ticks[k].label) * ticks.scale, ticks.ticks[k].value, 1e-9 * size);
      if (k == 0) continue;
      const double gap_px = std::abs(ticks.ticks[k].value - ticks.ticks[k - 1].value) / span * length_px;
      // Short labels stand nearer together where there would be one mark alone.
      const std::size_t letters = max_letters(ticks);
      const double min_px = letters <= 4 ? 16.0 : letters <= 6 ? 24.0 : 40.0;
      EXPECT_GE(gap_px, std::min(min_px, length_px) * (1.0 - 1e-6)) << a << " " << b;
      if (gap_px < 40.0 * (1.0 - 1e-6)) {
        EXPECT_LE(ticks.ticks.size(), 6U) << a << " " << b;
      }
      EXPECT_LE(gap_px, 2.5 * 40.0 * (1.0 + 1e-6) + length_px * 1e-6) << a << " " << b;
    }
  }
}

std::string labels_of(const Ticks& ticks) {
  std::string text;
  for (const Tick& tick : ticks.ticks) text += (text.empty() ? "" : " ") + tick.label;
  return text;
}

TEST(ClockTicks, StandAtRoundTimesOfDay) {
  const double clock_s = 22 * 3600 + 59 * 60 + 42.25;
  EXPECT_EQ(labels_of(clock_ticks(-10.0, 10.0, 400.0, 100.0, clock_s)), "22:59:35 22:59:40 22:59:45 22:59:50");
  EXPECT_EQ(labels_of(clock_ticks(0.0, 7200.0, 400.0, 100.0, clock_s)), "23:00:00 23:30:00 00:00:00 00:30:00");
  EXPECT_EQ(labels_of(clock_ticks(0.0, 1.0, 400.0, 100.0, clock_s)), "22:59:42.5 22:59:43.0");
  EXPECT_EQ(labels_of(clock_ticks(1.0, 0.0, 400.0, 100.0, clock_s)), "22:59:43.0 22:59:42.5");
  const Ticks ticks = clock_ticks(-10.0, 10.0, 400.0, 100.0, clock_s);
  EXPECT_NEAR(ticks.ticks[0].value, 35.0 - 42.25, 1e-9);
  EXPECT_EQ(ticks.unit, "");
}

TEST(ClockTicks, RollOverMidnightWithoutSixtySeconds) {
  EXPECT_EQ(labels_of(clock_ticks(-0.002, 0.002, 400.0, 100.0, 86400.0)),
            "23:59:59.998 23:59:59.999 00:00:00.000 00:00:00.001 00:00:00.002");
  EXPECT_TRUE(clock_ticks(0.0, 0.0, 400.0, 100.0, 0.0).ticks.empty());
  EXPECT_TRUE(clock_ticks(0.0, std::nan(""), 400.0, 100.0, 0.0).ticks.empty());
}

TEST(RoundBelow, IsTheLargestRoundNumberThatIsNotAbove) {
  EXPECT_DOUBLE_EQ(round_below(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_below(1.99), 1.0);
  EXPECT_DOUBLE_EQ(round_below(2.0), 2.0);
  EXPECT_DOUBLE_EQ(round_below(49'999.0), 20'000.0);
  EXPECT_DOUBLE_EQ(round_below(0.07), 0.05);
  EXPECT_DOUBLE_EQ(round_below(1000.0), 1000.0);
  EXPECT_DOUBLE_EQ(round_below(1e-3), 1e-3);
  EXPECT_EQ(round_below(0.0), 0.0);
  EXPECT_EQ(round_below(-5.0), 0.0);
  EXPECT_EQ(round_below(std::nan("")), 0.0);
}

}  // namespace ticks_test
}  // namespace sarsim::picture
