#include "radar/echo/reference_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace reference_kernel_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double c = core::exact_light_speed_mps;
using Row = std::vector<std::complex<double>>;

EchoPulse hard(Pulse::Kind kind, double width_s, double sweep_hz = 0.0) {
  EchoPulse pulse;
  pulse.pulse.kind = kind;
  pulse.pulse.width_s = width_s;
  pulse.pulse.sweep_hz = sweep_hz;
  if (kind == Pulse::Kind::code) pulse.pulse.code = barker_code(4);
  return pulse;
}

EchoBatch one(double delay_s, double amplitude, double speed_mps = 0.0) {
  EchoBatch batch;
  batch.add(delay_s, amplitude, 2.0 * speed_mps / c);
  return batch;
}

Row echoes(const SampleGrid& grid, const EchoPulse& pulse, double carrier_hz, const EchoBatch& batch) {
  Row row(grid.count);
  add_echoes(row, grid, pulse, carrier_hz, batch);
  return row;
}

double largest_difference(const Row& a, const Row& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// 20 million wavelengths and an eighth: two ways are 40 million cycles and a quarter, so the echo lags by 90 degrees.
// The delay is rounded to epsilon, of 4e7 cycles.
TEST(AddEchoes, KeepsTheCarrierPhaseOfATargetFarAway) {
  constexpr double carrier_hz = 1e10;
  const double distance_m = (20e6 + 0.125) * c / carrier_hz;
  ASSERT_GT(distance_m, 599e3);
  const double delay_s = 2.0 * distance_m / c;
  const Row row = echoes({delay_s, 1e-7, 5}, hard(Pulse::Kind::mono, 1e-6), carrier_hz, one(delay_s, 3.0));
  for (const auto& s : row)
    EXPECT_LT(std::abs(s - std::complex(0.0, -3.0)), 3.0 * 2.0 * core::pi * 4e7 * 3.0 * epsilon);
}

// The formula once more in long double, written with angles instead of turns.
std::complex<double> formula(const EchoPulse& p, double t_s, double f_hz, double delay_s, double a,
                             const PulseClock& clock) {
  const long double rate = p.pulse.kind == Pulse::Kind::chirp ? p.pulse.sweep_hz / p.pulse.width_s : 0.0;
  const long double u = static_cast<long double>(t_s) - delay_s + p.lead_s - 0.5L * p.pulse.width_s;
  const long double late = clock.doppler * u + 0.5L * clock.dilation_rate * u * u;
  const bool thesis = p.doppler_rule == DopplerRule::thesis;
  const long double sent = thesis ? u : u - late;
  const long double w = sent + 0.5L * p.pulse.width_s;
  if (w < 0 || w >= p.pulse.width_s) return 0.0;
  const long double in_pulse = thesis ? clock.doppler * (f_hz * u + 0.5L * rate * u * u) : f_hz * late;
  long double phase = -2.0L * std::numbers::pi_v<long double> * (f_hz * static_cast<long double>(delay_s) + in_pulse);
  phase += std::numbers::pi_v<long double> * rate * sent * sent;
  long double sign = 1.0;
  if (p.pulse.kind == Pulse::Kind::code)
    sign = p.pulse.code[static_cast<std::size_t>(w / p.pulse.width_s * static_cast<long double>(p.pulse.code.size()))];
  return {static_cast<double>(sign * a * std::cos(phase)), static_cast<double>(sign * a * std::sin(phase))};
}

void expect_documented_sum(DopplerRule rule, double max_bend) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> delay(20e-6, 60e-6), speed(-9e3, 9e3), amplitude(-1.0, 1.0);
  constexpr double f_hz = 5.3e9;
  const SampleGrid grid{30e-6, 1.0 / 37e6, 800};
  for (const Pulse::Kind kind : {Pulse::Kind::mono, Pulse::Kind::chirp, Pulse::Kind::code})
    for (const double sweep_hz : {30e6, -11e6})
      for (const double lead_s : {0.0, 2.5e-6}) {
        EchoPulse pulse = hard(kind, 5e-6, sweep_hz);
        pulse.lead_s = lead_s;
        pulse.doppler_rule = rule;
        EchoBatch batch;
        for (int k = 0; k < 20; ++k)
          batch.add(delay(random), amplitude(random),
                    PulseClock{2.0 * speed(random) / c, max_bend * amplitude(random)});
        batch.doppler[3] = 0.0;
        const Row row = echoes(grid, pulse, f_hz, batch);
        for (std::size_t i = 0; i < grid.count; ++i) {
          std::complex<double> sum = 0.0;
          for (std::size_t k = 0; k < batch.size(); ++k)
            sum += formula(pulse, grid.time_s(i), f_hz, batch.delay_s[k], batch.amplitude_sqrt_w[k], batch.clock(k));
          // f tau = 3e5 cycles, B Tp = 150, each rounded a few times, for up to 20 echoes of amplitude 1.
          ASSERT_LT(std::abs(row[i] - sum), 20.0 * 2.0 * core::pi * 3.2e5 * 4.0 * epsilon) << i;
        }
      }
}

TEST(AddEchoes, IsTheDocumentedSumForEveryKindOfPulse) {
  expect_documented_sum(DopplerRule::stretch, 0.0);
  expect_documented_sum(DopplerRule::stretch, 5.0);
  expect_documented_sum(DopplerRule::thesis, 0.0);
}

// A missile at 2 km/s, 1 GHz in 100 us: by the rule of the thesis the sweep is short of half its change, which turns
// the ends of the pulse by (pi/4) (2 v/c) B Tp = 1.05 rad.
TEST(AddEchoes, AStretchedChirpEndsARadianFromTheThesis) {
  EchoPulse pulse = hard(Pulse::Kind::chirp, 100e-6, 1e9);
  const SampleGrid grid{0.0, 0.5e-9, 200'000};
  const Row stretched = echoes(grid, pulse, 10e9, one(0.0, 1.0, 2000.0));
  pulse.doppler_rule = DopplerRule::thesis;
  const Row thesis = echoes(grid, pulse, 10e9, one(0.0, 1.0, 2000.0));
  const double expected = 0.25 * core::pi * (4000.0 / c) * 1e5;
  EXPECT_NEAR(expected, 1.05, 0.003);
  for (const std::size_t i : {std::size_t{1}, grid.count - 2})
    EXPECT_NEAR(std::arg(stretched[i] * std::conj(thesis[i])), -expected, 1e-3);
  EXPECT_NEAR(std::arg(stretched[grid.count / 2] * std::conj(thesis[grid.count / 2])), 0.0, 1e-9);
}

double phase_step(const Row& row, std::size_t i) { return std::arg(row[i + 1] * std::conj(row[i])); }

TEST(AddEchoes, ChirpPhaseHasTheSecondDifferenceOfItsSweepRate) {
  constexpr double rate_hz = 100e6;
  const EchoPulse pulse = hard(Pulse::Kind::chirp, 4e-6, 40e6);
  const Row row = echoes({0.0, 1.0 / rate_hz, 400}, pulse, 1e9, one(0.0, 1.0));
  const double expected = 2.0 * core::pi * (40e6 / 4e-6) / (rate_hz * rate_hz);
  for (std::size_t i = 0; i + 2 < row.size(); ++i)
    EXPECT_NEAR(std::remainder(phase_step(row, i + 1) - phase_step(row, i), 2.0 * core::pi), expected, 1e3 * epsilon);
}

// Sample 200 is the centre of the pulse: the steps on both sides of it are equal and opposite.
TEST(AddEchoes, ChirpOfARestingTargetHasNoFrequencyAtItsCentre) {
  const EchoPulse pulse = hard(Pulse::Kind::chirp, 4e-6, 40e6);
  const Row row = echoes({10e-6, 1e-8, 400}, pulse, 1e9, one(10e-6, 1.0));
  EXPECT_NEAR(phase_step(row, 199) + phase_step(row, 200), 0.0, 1e3 * epsilon);
  EXPECT_LT(phase_step(row, 100), 0.0);  // up chirp: below the carrier before the centre,
  EXPECT_GT(phase_step(row, 300), 0.0);  // above after it
}

// Per sample -2 pi (2 v f/c)/fs: a receding target (v > 0) lowers the frequency.
TEST(AddEchoes, DopplerTurnsThePhaseInsideThePulseForBothSignsOfSpeed) {
  constexpr double f_hz = 10e9, interval_s = 1e-8;
  const EchoPulse pulse = hard(Pulse::Kind::mono, 4e-6);
  for (const double v : {-7000.0, -3.0, 0.0, 250.0, 7000.0}) {
    const Row row = echoes({0.0, interval_s, 400}, pulse, f_hz, one(0.0, 1.0, v));
    for (std::size_t i = 1; i + 2 < row.size(); i += 37)  // the echo may be shorter than the pulse by half a sample
      EXPECT_NEAR(phase_step(row, i), -2.0 * core::pi * 2.0 * v * f_hz / c * interval_s, 100.0 * epsilon) << v;
    EXPECT_LT(std::abs(row[200] - 1.0), 10.0 * epsilon);  // the phase of the delay alone at the centre of the pulse
  }
}

// The sweep rate of what was sent slower is less by (1 - D)^2; thesis: by 1 - D.
TEST(AddEchoes, DopplerScalesTheSweepToo) {
  constexpr double interval_s = 1e-8, v = 300e3;
  EchoPulse pulse = hard(Pulse::Kind::chirp, 4e-6, 40e6);
  for (const DopplerRule rule : {DopplerRule::stretch, DopplerRule::thesis}) {
    pulse.doppler_rule = rule;
    const Row row = echoes({0.0, interval_s, 400}, pulse, 1e9, one(0.0, 1.0, v));
    const double left = 1.0 - 2.0 * v / c;
    const double expected =
        2.0 * core::pi * 1e13 * (rule == DopplerRule::stretch ? left * left : left) * interval_s * interval_s;
    for (std::size_t i = 0; i + 2 < row.size(); i += 13)
      EXPECT_NEAR(std::remainder(phase_step(row, i + 1) - phase_step(row, i), 2.0 * core::pi), expected, 1e3 * epsilon);
  }
}

TEST(AddEchoes, OverhangingEchoesChangeTheSamplesInsideOnly) {
  const EchoPulse pulse = hard(Pulse::Kind::chirp, 4e-6, 40e6);
  const SampleGrid wide{10e-6, 1e-8, 2000};
  EchoBatch batch = one(16.2345e-6, 1.0, 40.0);
  batch.add(22.8e-6, 0.5, -80.0 / c);
  const Row whole = echoes(wide, pulse, 3e9, batch);
  const SampleGrid cut{wide.time_s(800), wide.interval_s,
                       600};  // cuts the tail of the first and the head of the second
  const Row part = echoes(cut, pulse, 3e9, batch);
  for (std::size_t i = 0; i < part.size(); ++i)
    // Times of 3e-5 s differ by rounding; phases of up to 63 rad change by 2 pi K u per second.
    EXPECT_LT(std::abs(part[i] - whole[800 + i]), 2.0 * core::pi * 20e6 * 3e-5 * 4.0 * epsilon);
  EXPECT_NE(part.front(), 0.0);
  EXPECT_NE(part.back(), 0.0);
}

TEST(AddEchoes, LeavesARowAloneThatNoEchoTouches) {
  const EchoPulse pulse = hard(Pulse::Kind::mono, 1e-6);
  const SampleGrid grid{10e-6, 1e-8, 100};
  for (const double delay_s : {0.0, 8.99e-6, 11.0e-6, 12e-6, 1e3, -1e3})
    for (const auto& s : echoes(grid, pulse, 3e9, one(delay_s, 1.0))) EXPECT_EQ(s, 0.0);
}

TEST(AddEchoes, AddsToWhatIsThere) {
  const EchoPulse pulse = hard(Pulse::Kind::mono, 1e-6);
  Row row(3, {5.0, 7.0});
  add_echoes(row, {0.0, 1e-7, 3}, pulse, 1e9, one(0.0, 2.0));
  for (const auto& s : row) EXPECT_EQ(s, (std::complex(7.0, 7.0)));
}

TEST(AddEchoes, IsTheSumOfTheSingleEchoes) {
  const EchoPulse pulse = hard(Pulse::Kind::code, 7e-6);
  const SampleGrid grid{0.0, 1e-7, 300};
  const EchoBatch a = one(3.21e-6, 1.0, 10.0), b = one(5.4321e-6, -0.3, 0.0);
  EchoBatch both = a;
  both.add(b.delay_s[0], b.amplitude_sqrt_w[0], b.doppler[0]);
  Row sum = echoes(grid, pulse, 1e9, a);
  const Row second = echoes(grid, pulse, 1e9, b);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += second[i];
  EXPECT_EQ(largest_difference(echoes(grid, pulse, 1e9, both), sum), 0.0);
}

TEST(AddEchoes, CentrePositionPutsTheEchoHalfAPulseEarlier) {
  EchoPulse begin = hard(Pulse::Kind::chirp, 4e-6, 20e6);
  EchoPulse centre = begin;
  centre.lead_s = 2e-6;
  const Row late = echoes({10e-6, 1e-8, 600}, begin, 3e9, one(11e-6, 1.0, 30.0));
  const Row early = echoes({8e-6, 1e-8, 600}, centre, 3e9, one(11e-6, 1.0, 30.0));
  EXPECT_LT(largest_difference(late, early), 2.0 * core::pi * 10e6 * 1.6e-5 * 4.0 * epsilon);
  EXPECT_EQ(late[99], 0.0);
  EXPECT_NE(late[100], 0.0);
}

// The pulse is four intervals long: on for four samples if a sample is within 1e-9 of an interval of its leading edge,
// also four if not.
TEST(TouchedSamples, AnEdgeWithinOneBillionthOfAnIntervalCountsAsOnTheSample) {
  constexpr double interval_s = 1e-8;
  const EchoPulse pulse = hard(Pulse::Kind::mono, 4e-8);
  const SampleGrid grid{0.0, interval_s, 100};
  for (const double off : {-0.9e-9, -1e-12, 0.0, 1e-12, 0.9e-9}) {
    const SampleSpan on = touched_samples(pulse, grid, (20.0 + off) * interval_s, {});
    EXPECT_EQ(on.begin, 20u) << off;
    EXPECT_EQ(on.end, 24u) << off;
  }
  EXPECT_EQ(touched_samples(pulse, grid, (20.0 + 3e-9) * interval_s, {}).begin, 21u);
  EXPECT_EQ(touched_samples(pulse, grid, (20.0 + 3e-9) * interval_s, {}).end, 25u);
  EXPECT_EQ(touched_samples(pulse, grid, (20.0 - 3e-9) * interval_s, {}).begin, 20u);
  EXPECT_EQ(touched_samples(pulse, grid, (20.0 - 3e-9) * interval_s, {}).end, 24u);
}

TEST(TouchedSamples, AreThoseOfADirectSearch) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> delay(-5.0, 60.0);
  EchoPulse pulse = hard(Pulse::Kind::mono, 7.3);
  pulse.lead_s = 2.0;
  const SampleGrid grid{10.0, 0.7, 40};
  for (int round = 0; round < 500; ++round) {
    const double tau = delay(random);
    // Stretched by up to a fifth.
    const PulseClock clock{0.02 * (round % 11 - 5), 0.004 * (round % 7 - 3)};
    const SampleSpan on = touched_samples(pulse, grid, tau, clock);
    for (std::size_t i = 0; i < grid.count; ++i) {
      const double w = clock.sent(grid.time_s(i) - tau + 2.0 - 3.65) + 3.65;
      ASSERT_EQ(i >= on.begin && i < on.end, w >= 0.0 && w < 7.3);
    }
  }
}

TEST(AddEchoes, ChipsChangeOnTheSampleThatStandsOnTheirBorder) {
  const EchoPulse pulse = hard(Pulse::Kind::code, 7e-6);  // +++--+-, 10 samples a chip
  const double signs[] = {1, 1, 1, -1, -1, 1, -1, 0};
  for (int k = 0; k < 50; ++k) {  // rounding puts the borders on either side of their samples
    const double delay_s = 3.3e-6 + k * 0.7e-6;
    const Row row = echoes({delay_s, 1e-7, 80}, pulse, 0.0, one(delay_s, 1.0));
    for (std::size_t i = 0; i < 80; ++i) EXPECT_EQ(row[i], signs[i / 10]) << i;
  }
}

EchoPulse limited(double sample_rate_hz, double half_band_hz, double kept_s = 0.0) {
  EchoPulse pulse = hard(Pulse::Kind::chirp, 2e-6, 20e6);
  pulse.band_limited.emplace(pulse.pulse, half_band_hz, sample_rate_hz, kept_s);
  return pulse;
}

TEST(AddEchoes, BandLimitedEchoIsTheDelayedPulseTimesThePhaseOfTheDelay) {
  const EchoPulse pulse = limited(40e6, 20e6);
  const SampleGrid grid{10e-6, 1.0 / 40e6, 300};
  constexpr double delay_s = 12.3456e-6, f_hz = 1e9;
  const Row row = echoes(grid, pulse, f_hz, one(delay_s, 2.0));
  for (std::size_t i = 0; i < grid.count; ++i) {
    const std::complex<double> expected = 2.0 * std::polar(1.0, -2.0 * core::pi * std::remainder(f_hz * delay_s, 1.0)) *
                                          pulse.band_limited->value(grid.time_s(i) - delay_s);
    EXPECT_LT(std::abs(row[i] - expected), 2.0 * (2.0 * core::pi * 1.3e4 + 1e5) * epsilon);  // see "many values"
  }
  EXPECT_GT(std::abs(row[93]), 0.1);  // before the hard edge, at 93.8, its skirt
}

TEST(AddEchoes, ADelayByAWholeSampleShiftsABandLimitedEcho) {
  const EchoPulse pulse = limited(40e6, 20e6);
  const SampleGrid grid{10e-6, 1.0 / 40e6, 400};
  const Row row = echoes(grid, pulse, 0.0, one(14.321e-6, 1.0));
  const Row shifted = echoes(grid, pulse, 0.0, one(14.321e-6 + 3.0 / 40e6, 1.0));
  for (std::size_t i = 0; i + 3 < grid.count; ++i) EXPECT_LT(std::abs(shifted[i + 3] - row[i]), 1e5 * epsilon);
}

// Kept to 3 us about its centre, -0.5 us to 2.5 us: 120 samples, whichever way the times are rounded.
TEST(AddEchoes, ABandLimitedPulseThatIsCutOnSamplesHasTheSameTolerance) {
  const EchoPulse pulse = limited(40e6, 10e6, 3e-6);
  for (int k = 0; k < 200; ++k) {
    const SampleGrid grid{10e-6, 1.0 / 40e6, 1000};
    const Row row = echoes(grid, pulse, 0.0, one(11e-6 + k / 40e6, 1.0));
    const SampleSpan on = touched_samples(pulse, grid, 11e-6 + k / 40e6, {});
    EXPECT_EQ(on.begin, static_cast<std::size_t>(20 + k));
    EXPECT_EQ(on.end, on.begin + 120);
    EXPECT_NE(row[on.begin], 0.0) << k;
    EXPECT_NE(row[on.end - 1], 0.0) << k;
    EXPECT_EQ(row[on.end], 0.0) << k;
  }
}

}  // namespace reference_kernel_test
}  // namespace sarsim::radar
