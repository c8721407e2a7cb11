#include "signal/search/range_doppler_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "signal/search/canceller.hpp"
#include "signal/search/cfar.hpp"

namespace sarsim::signal {
namespace range_doppler_map_test {

using Volts = std::vector<std::complex<float>>;

const core::WorkControl one{1, nullptr};
constexpr double prf_hz = 2000.0;

// One tone in one gate of five.
Volts tone(std::size_t pulses, double doppler_hz, std::complex<double> amplitude) {
  Volts volts(pulses * 5);
  for (std::size_t p = 0; p < pulses; ++p)
    volts[p * 5 + 3] =
        std::complex<float>(amplitude * std::polar(1.0, 2.0 * core::pi * doppler_hz * static_cast<double>(p) / prf_hz));
  return volts;
}

TEST(RangeDopplerMaps, ShowAToneWithItsAmplitudeAtItsFrequency) {
  for (const std::size_t size : {64u, 65u, 100u})
    for (const bool windowed : {false, true}) {
      CoherentInterval interval{64, 0, size, {}};
      if (windowed) interval.window = core::hamming_window;
      const long bin = -11;
      const double doppler_hz = static_cast<double>(bin) * prf_hz / static_cast<double>(size);
      const auto maps = range_doppler_maps(tone(64, doppler_hz, {0.0, 3.0}), 5, prf_hz, interval, one);
      ASSERT_EQ(maps.size(), 1u);
      const RangeDopplerMap& map = maps[0];
      const auto row = static_cast<std::size_t>(bin + static_cast<long>(size / 2));
      EXPECT_NEAR(map.doppler_hz(row), doppler_hz, 1e-9);
      EXPECT_NEAR(map.speed_mps(row, 0.06), -0.03 * doppler_hz, 1e-9);
      EXPECT_LT(std::abs(map.values[row * 5 + 3] - std::complex<float>(0.0F, 3.0F)), 1e-5F);
      const auto power = power_of(map);
      EXPECT_EQ(std::ranges::max_element(power) - power.begin(), static_cast<long>(row * 5 + 3));
      EXPECT_NEAR(power[row * 5 + 3], 9.0F, 1e-4F);
      EXPECT_EQ(map.values[row * 5 + 2], 0.0F);
    }
}

TEST(RangeDopplerMaps, HaveTheSidelobesOfTheirWindow) {
  const auto highest_sidelobe_db = [](const WindowFunction& window, double first_null) {
    const CoherentInterval interval{128, 0, 4096, window};
    const auto map = range_doppler_maps(tone(128, 0.0, 1.0), 5, prf_hz, interval, one).at(0);
    double highest = 0.0;
    for (std::size_t k = 0; k < 4096; ++k)
      if (std::abs(static_cast<double>(k) - 2048.0) / 32.0 > first_null)
        highest = std::max(highest, static_cast<double>(std::abs(map.values[k * 5 + 3])));
    return 20.0 * std::log10(highest);
  };
  EXPECT_NEAR(highest_sidelobe_db({}, 1.0), -13.26, 0.02);
  EXPECT_NEAR(highest_sidelobe_db(core::hamming_window, 2.1), -42.7, 0.5);
}

TEST(RangeDopplerMaps, OfOverlappingIntervalsBeginWhereTheyShould) {
  const Volts volts = tone(100, 250.0, 1.0);
  const auto maps = range_doppler_maps(volts, 5, prf_hz, {32, 20, 0, {}}, one);
  ASSERT_EQ(maps.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(maps[i].first_pulse, 20 * i);
    // 250 Hz is bin 4 of 62.5 Hz; the phase is that of the interval's first pulse.
    const std::complex<double> want = std::polar(1.0, 2.0 * core::pi * 250.0 * 20.0 * static_cast<double>(i) / prf_hz);
    EXPECT_LT(std::abs(std::complex<double>(maps[i].values[20 * 5 + 3]) - want), 1e-5);
  }
  EXPECT_EQ(range_doppler_maps(volts, 5, prf_hz, {50, 0, 0, {}}, one).size(), 2u);
  EXPECT_TRUE(range_doppler_maps(volts, 5, prf_hz, {101, 0, 0, {}}, one).empty());
}

TEST(RangeDopplerMaps, AreTheSameForAnyNumberOfThreads) {
  std::mt19937_64 random(4);
  std::normal_distribution<float> normal;
  Volts volts(32 * 300);
  for (auto& v : volts) v = {normal(random), normal(random)};
  const auto expected = range_doppler_maps(volts, 300, prf_hz, {32, 0, 0, {}}, one).at(0);
  for (const unsigned threads : {2u, 3u, 8u}) {
    const auto got = range_doppler_maps(volts, 300, prf_hz, {32, 0, 0, {}}, {threads, nullptr}).at(0);
    EXPECT_EQ(got.values, expected.values);
  }
}

// Clutter 60 dB above the noise and a moving target 20 dB above it: cancelled, transformed, detected.
TEST(RangeDopplerMaps, ShowAMovingTargetInClutterAfterCancelling) {
  std::mt19937_64 random(21);
  std::normal_distribution<double> normal(0.0, std::sqrt(0.5));
  constexpr std::size_t pulses = 66, samples = 120;
  Volts volts(pulses * samples);
  std::vector<std::complex<double>> clutter(samples);
  for (auto& c : clutter) c = 1000.0 * std::complex(normal(random), normal(random));
  const double doppler_hz = 20.0 * prf_hz / 64.0;
  for (std::size_t p = 0; p < pulses; ++p)
    for (std::size_t n = 0; n < samples; ++n) {
      std::complex<double> v = clutter[n] + std::complex(normal(random), normal(random));
      if (n == 47) v += std::polar(10.0, 2.0 * core::pi * doppler_hz * static_cast<double>(p) / prf_hz);
      volts[p * samples + n] = std::complex<float>(v);
    }
  const auto map = range_doppler_maps(cancelled(volts, samples, 2), samples, prf_hz, {64, 0, 0, {}}, one).at(0);
  const auto found = detect_cfar(power_of(map), samples, {}, one);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].row, 32u + 20u);
  EXPECT_EQ(found[0].column, 47u);
  EXPECT_NEAR(found[0].power, 100.0 * canceller_gain(2, doppler_hz, prf_hz), 0.2 * found[0].power);
}

TEST(RangeDopplerMaps, RefuseWhatMakesNoSense) {
  const Volts volts(40);
  EXPECT_THROW((void)range_doppler_maps(volts, 0, prf_hz, {4, 0, 0, {}}, one), std::invalid_argument);
  EXPECT_THROW((void)range_doppler_maps(volts, 7, prf_hz, {4, 0, 0, {}}, one), std::invalid_argument);
  EXPECT_THROW((void)range_doppler_maps(volts, 5, 0.0, {4, 0, 0, {}}, one), std::invalid_argument);
  EXPECT_THROW((void)range_doppler_maps(volts, 5, prf_hz, {0, 0, 0, {}}, one), std::invalid_argument);
  EXPECT_THROW((void)range_doppler_maps(volts, 5, prf_hz, {4, 0, 3, {}}, one), std::invalid_argument);
  EXPECT_THROW((void)range_doppler_maps(volts, 5, prf_hz, {4, 0, 0, [](double x) { return x - 0.5; }}, one),
               std::invalid_argument);
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)range_doppler_maps(volts, 5, prf_hz, {4, 0, 0, {}}, {1, &stop}), core::Interrupted);
}

}  // namespace range_doppler_map_test
}  // namespace sarsim::signal
