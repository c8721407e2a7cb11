#include "radar/waveform/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace sarsim::radar {
namespace schedule_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(Repetition, OfConstantFrequencyIsExact) {
  const Repetition r = Repetition::constant(300.0);
  EXPECT_EQ(r.send_time_s(0), 0.0);
  EXPECT_EQ(r.send_time_s(7), 7.0 / 300.0);
  EXPECT_EQ(r.send_time_s(-3), -3.0 / 300.0);
  EXPECT_EQ(r.send_time_s(3'000'000'000), 1e7);
  EXPECT_EQ(r.shortest_interval_s(), 1.0 / 300.0);
  EXPECT_EQ(r.mean_interval_s(), 1.0 / 300.0);
}

// The vector of three intervals 1, 2, 3 ms.
TEST(Repetition, OfIntervalsWrapsAroundInBothDirections) {
  const Repetition r = Repetition::intervals({1e-3, 2e-3, 3e-3});
  const double expected_ms[] = {-6.0, -5.0, -3.0, 0.0, 1.0, 3.0, 6.0, 7.0, 9.0, 12.0};
  for (int pulse = -3; pulse <= 6; ++pulse)
    EXPECT_NEAR(r.send_time_s(pulse), 1e-3 * expected_ms[pulse + 3], 12e-3 * 2.0 * epsilon) << pulse;
  EXPECT_EQ(r.shortest_interval_s(), 1e-3);
  EXPECT_NEAR(r.mean_interval_s(), 2e-3, 2e-3 * 2.0 * epsilon);
}

void expect_range(const PulseRange& range, std::int64_t first, std::int64_t last) {
  EXPECT_EQ(range.first, first);
  EXPECT_EQ(range.last, last);
  EXPECT_EQ(range.count(), last - first + 1);
}

TEST(Repetition, BothEndsOfAWindowBelongToIt) {
  const Repetition constant = Repetition::constant(1000.0);
  expect_range(constant.pulses_in(0.0, 0.01), 0, 10);
  expect_range(constant.pulses_in(-0.005, -0.001), -5, -1);
  expect_range(constant.pulses_in(0.0021, 0.0039), 3, 3);
  expect_range(constant.pulses_in(0.1 + 0.2, 0.3), 300, 300);           // 0.1 + 0.2 is a rounding above 0.3
  expect_range(constant.pulses_in(0.0, 0.29 * 100.0 / 1000.0), 0, 29);  // 28.999999999999996 intervals
  const Repetition list = Repetition::intervals({1e-3, 2e-3, 3e-3});
  expect_range(list.pulses_in(0.0, 6e-3), 0, 3);
  expect_range(list.pulses_in(-3e-3, 3e-3), -1, 2);
  expect_range(list.pulses_in(1e-3 + 1e-13, 3e-3 - 1e-13), 1, 2);  // within 1e-9 of the shortest interval
  expect_range(list.pulses_in(1e-3 + 1e-11, 3e-3 - 1e-11), 2, 1);
}

TEST(Repetition, AWindowBetweenPulsesIsEmpty) {
  EXPECT_EQ(Repetition::constant(1000.0).pulses_in(0.0101, 0.0109).count(), 0);
  EXPECT_EQ(Repetition::intervals({1e-3, 2e-3}).pulses_in(1.1e-3, 2.9e-3).count(), 0);
}

// The vector of a recording of 512 pulses at 400 Hz.
TEST(Repetition, CountsThePulsesOfARecordingAroundZero) {
  expect_range(Repetition::constant(400.0).pulses_in(-0.64, 0.6399), -256, 255);
}

TEST(Repetition, FindsTheSamePulsesAsASearchThroughAll) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> interval(0.5, 3.0);
  std::uniform_real_distribution<double> time(-40.0, 40.0);
  for (int round = 0; round < 300; ++round) {
    std::vector<double> pri(1 + static_cast<std::size_t>(round) % 7);
    for (double& p : pri) p = interval(random);
    const Repetition r = Repetition::intervals(pri);
    double start = time(random), end = time(random);
    if (round % 3 == 0) start = r.send_time_s(round % 11 - 5);
    if (round % 4 == 0) end = r.send_time_s(round % 13 - 4);
    if (end < start) std::swap(start, end);
    std::int64_t first = 200, last = -201;
    for (std::int64_t p = 200; p >= -200; --p)
      if (r.send_time_s(p) >= start - 1e-12) first = p;
    for (std::int64_t p = -200; p <= 200; ++p)
      if (r.send_time_s(p) <= end + 1e-12) last = p;
    const PulseRange range = r.pulses_in(start, end);
    ASSERT_EQ(range.first, first) << round;
    ASSERT_EQ(range.last, last) << round;
  }
}

TEST(Repetition, StaysSoundForHugeTimes) {
  const Repetition list = Repetition::intervals({1e-3, 2e-3});
  const PulseRange far = list.pulses_in(1e9, 1e9 + 1.0);
  EXPECT_NEAR(static_cast<double>(far.first), 1e12 * 2.0 / 3.0, 2.0);
  EXPECT_NEAR(static_cast<double>(far.count()), 667.0, 1.0);
  // Beyond the numbers that doubles hold exactly, ends are clamped rather than undefined.
  for (const Repetition& r : {list, Repetition::constant(1e3)}) {
    const PulseRange all = r.pulses_in(-1e300, 1e300);
    EXPECT_LT(all.first, -1'000'000'000'000'000);
    EXPECT_GT(all.last, 1'000'000'000'000'000);
  }
}

TEST(PulseRange, CountsNothingWhereItEndsBeforeItBegins) {
  EXPECT_EQ(PulseRange().count(), 0);
  EXPECT_EQ((PulseRange{5, 3}).count(), 0);
  EXPECT_EQ((PulseRange{5, 5}).count(), 1);
}

// The vector "STEPPED 1 0.1 3 2".
TEST(CarrierPlan, StepsThroughABurstAndWrapsAround) {
  const CarrierPlan plan = CarrierPlan::stepped(1e9, 0.1e9, 3, 2);
  const double expected_ghz[] = {1.2, 1.0, 1.0, 1.1, 1.1, 1.2, 1.2, 1.0};
  for (int pulse = -1; pulse <= 6; ++pulse)
    EXPECT_NEAR(plan.carrier_hz(pulse), 1e9 * expected_ghz[pulse + 1], 1e9 * 2.0 * epsilon) << pulse;
  EXPECT_EQ(plan.carrier_hz(-6), plan.carrier_hz(0));
  EXPECT_EQ(plan.steps(), 3);
  EXPECT_EQ(plan.pulses_per_step(), 2);
  EXPECT_EQ(plan.lowest_hz(), 1e9);
  EXPECT_EQ(plan.highest_hz(), 1.2e9);
}

TEST(CarrierPlan, KnowsItsLimitsWhenItStepsDown) {
  const CarrierPlan plan = CarrierPlan::stepped(1e9, -0.1e9, 3, 1);
  EXPECT_EQ(plan.lowest_hz(), 0.8e9);
  EXPECT_EQ(plan.highest_hz(), 1e9);
}

TEST(CarrierPlan, TakesAListInTurn) {
  const CarrierPlan plan = CarrierPlan::list({1e9, 2e9, 3e9});
  EXPECT_EQ(plan.carrier_hz(-1), 3e9);
  EXPECT_EQ(plan.carrier_hz(3), 1e9);
  EXPECT_EQ(plan.carrier_hz(4), 2e9);
  EXPECT_EQ(plan.lowest_hz(), 1e9);
  EXPECT_EQ(plan.highest_hz(), 3e9);
  EXPECT_EQ(CarrierPlan::single(5e9).carrier_hz(-17), 5e9);
  EXPECT_EQ(CarrierPlan::single(5e9).steps(), 1);
}

TEST(FloorDivide, RoundsDownAlsoBelowZero) {
  for (std::int64_t n = -20; n <= 20; ++n)
    for (const std::int64_t m : {1, 3, 7}) {
      EXPECT_EQ(floor_divide(n, m),
                static_cast<std::int64_t>(std::floor(static_cast<double>(n) / static_cast<double>(m))));
      EXPECT_EQ(floor_divide(n, m) * m + wrapped(n, m), n);
    }
}

}  // namespace schedule_test
}  // namespace sarsim::radar
