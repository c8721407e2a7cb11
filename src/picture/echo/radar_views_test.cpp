#include "picture/echo/radar_views.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "picture/echo/preview_test_scene.hpp"
#include "picture/echo/radar_figures.hpp"
#include "simulate/run/run.hpp"

namespace sarsim::picture {
namespace radar_views_test {

// One target at 3000 m that recedes at 3 m/s, 1 GHz, 1 kHz, 64 pulses; no noise, no jitter.
simulate::Plan receding_plan(double speed_mps = 3.0) {
  scene::Scene scene;
  scene.platforms.push_back({});
  scene::Platform car;
  car.name = "Car";
  car.path = scene::Platform::Path::trajectory;
  const auto line = [](double a, double b) {
    return core::SampledFunction{core::Interpolation::linear, {{0.0, a}, {1.0, b}}};
  };
  car.trajectory_m.part = {line(3000.0, 3000.0 + speed_mps), line(0.0, 0.0), line(0.0, 0.0)};
  scene.platforms.push_back(car);
  scene::Target target;
  target.platform = "Car";
  scene.targets.push_back(target);
  scene::Radar radar;
  radar.pulse = scene::Radar::Pulse::chirp;
  scene.radars.push_back(radar);
  scene::Simulation s;
  s.radar = "Radar1";
  s.range_start_m = 2900.0;
  s.range_end_m = 3900.0;
  s.time_end_s = 0.063;
  s.sample_rate_hz = 100e6;
  scene.simulations.push_back(s);
  return simulate::make_plan(scene, 0, nullptr, simulate::Engine::direct);
}

std::size_t strongest(const std::vector<std::complex<double>>& samples) {
  return static_cast<std::size_t>(
      std::ranges::max_element(samples, {}, [](std::complex<double> v) { return std::norm(v); }) - samples.begin());
}

TEST(EchoBlock, HoldsTheSamplesOfTheRecordingWithTheirAxes) {
  const simulate::Plan plan = receding_plan();
  const simulate::Recording recording = simulate::record(plan);
  const EchoBlock block = echo_block(plan, {10, 1000}, {2, nullptr});
  ASSERT_EQ(block.rows, 54U);
  for (std::size_t i = 0; i < block.samples.size(); ++i)
    ASSERT_EQ(block.samples[i], recording.samples[10 * plan.acquisition.reception.columns + i]);
  EXPECT_NEAR(block.time_s[0], 0.01, 1e-15);
  EXPECT_EQ(block.range_m, plan.acquisition.reception.column_range_m);
  EXPECT_EQ(block.carrier_hz[5], 1e9);
  EXPECT_NEAR(block.sample_rate_hz, 100e6, 1e-3);
  EXPECT_EQ(echo_block(plan, {100, 200}).rows, 0U);
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)echo_block(plan, {0, 10}, {1, &stop}), core::Interrupted);
}

TEST(RangeDoppler, PutsAMovingTargetAtItsDopplerFrequencyAndSpeedWithItsAmplitude) {
  // 2 v f/c = 20.01 Hz at 3 m/s: choose the speed whose frequency is exactly 5 bins of 64.
  const double doppler_hz = 5.0 * 1000.0 / 64.0;
  const double speed = doppler_hz * core::exact_light_speed_mps / 2e9;
  const simulate::Plan plan = receding_plan(speed);
  const EchoBlock block = echo_block(plan, {0, 64});
  for (const SpectrumWindow window : {SpectrumWindow::rectangular, SpectrumWindow::hann, SpectrumWindow::hamming}) {
    const RangeDoppler map = range_doppler(block, window);
    ASSERT_EQ(map.doppler_hz.size(), 64U);
    const std::size_t peak = strongest(map.samples) / map.range_m.size();
    EXPECT_NEAR(map.doppler_hz[peak], -doppler_hz, 1e-9);
    EXPECT_NEAR(map.speed_mps[peak], speed, 1e-6);
    const double amplitude = std::abs(block.at(0, 200));
    EXPECT_NEAR(std::abs(map.samples[strongest(map.samples)]), amplitude, 0.02 * amplitude);
    EXPECT_EQ(map.remark, "");
  }
}

TEST(RangeDoppler, OfAnApproachingTargetIsPositiveAndTakesMoreBinsWhereAsked) {
  const EchoBlock block = echo_block(receding_plan(-10.0), {0, 50});
  const RangeDoppler map = range_doppler(block, SpectrumWindow::hann, 500);
  EXPECT_EQ(map.doppler_hz.size(), 500U);
  EXPECT_NEAR(map.doppler_hz[strongest(map.samples) / map.range_m.size()], 66.7, 2.0);
  EXPECT_NEAR(map.doppler_hz.front(), -500.0, 1e-9);
}

TEST(RangeDoppler, RemarksOnWhatItSupposesInVain) {
  EchoBlock block = echo_block(receding_plan(), {0, 8});
  block.time_s[3] += 1e-5;
  EXPECT_EQ(range_doppler(block, SpectrumWindow::hann).remark, "the pulses are not evenly spaced");
  block.carrier_hz[1] = 1.1e9;
  EXPECT_EQ(range_doppler(block, SpectrumWindow::hann).remark, "the carrier changes from pulse to pulse");
  EXPECT_TRUE(range_doppler(echo_block(receding_plan(), {64, 65}), SpectrumWindow::hann).samples.empty());
}

TEST(RangeProfile, MeansPowerOrWhatKeepsItsPhase) {
  EchoBlock block;
  block.rows = 2;
  block.columns = 2;
  block.samples = {{3.0, 0.0}, {1.0, 1.0}, {-3.0, 0.0}, {1.0, 1.0}};
  block.range_m = {10.0, 20.0};
  const RangeProfile power = range_profile(block, ProfileMean::power);
  EXPECT_NEAR(power.magnitude_v[0], 3.0, 1e-12);
  EXPECT_NEAR(power.magnitude_v[1], std::sqrt(2.0), 1e-12);
  const RangeProfile coherent = range_profile(block, ProfileMean::coherent);
  EXPECT_NEAR(coherent.magnitude_v[0], 0.0, 1e-12);
  EXPECT_NEAR(coherent.magnitude_v[1], std::sqrt(2.0), 1e-12);
  EXPECT_EQ(coherent.range_m, block.range_m);
}

TEST(DopplerTime, FollowsAFrequencyThatRises) {
  // One cell of 1000 pulses at 1 kHz whose frequency goes from -200 to 200 Hz within a second.
  EchoBlock block;
  block.rows = 1000;
  block.columns = 1;
  block.range_m = {3000.0};
  block.sample_rate_hz = 1e6;
  block.light_speed_mps = core::exact_light_speed_mps;
  for (std::size_t r = 0; r < block.rows; ++r) {
    const double t = 1e-3 * static_cast<double>(r);
    block.time_s.push_back(t);
    block.carrier_hz.push_back(1e9);
    block.samples.push_back(std::polar(2.0, 2.0 * core::pi * (-200.0 * t + 200.0 * t * t)));
  }
  const DopplerTime history = doppler_time(block, 0, SpectrumWindow::hann, 64, 4);
  EXPECT_TRUE(history.remark.empty());
  ASSERT_EQ(history.doppler_hz.size(), 256U);
  EXPECT_NEAR(history.doppler_hz[128], 0.0, 1e-9);
  EXPECT_NEAR(history.doppler_hz.front(), -500.0, 1e-9);
  ASSERT_EQ(history.time_s.size(), (1000U - 64U) / 8U + 1U);
  EXPECT_NEAR(history.time_s[1] - history.time_s[0], 8e-3, 1e-12);
  for (std::size_t t = 0; t < history.time_s.size(); t += 10) {
    const double expected_hz = -200.0 + 400.0 * history.time_s[t];
    EXPECT_NEAR(history.mean_hz[t], expected_hz, 2.0) << t;
    // A sweep of 25.6 Hz under a Hann window, and what 64 ms tell apart.
    EXPECT_LT(history.width_hz[t], 20.0) << t;
    std::size_t strongest_row = 0;
    for (std::size_t d = 1; d < history.doppler_hz.size(); ++d)
      if (std::abs(history.samples[d * history.time_s.size() + t]) >
          std::abs(history.samples[strongest_row * history.time_s.size() + t]))
        strongest_row = d;
    EXPECT_NEAR(history.doppler_hz[strongest_row], expected_hz, 6.0) << t;
  }
}

TEST(DopplerTime, KeepsTheAmplitudeOfASteadyTargetAndTheWidthOfTwo) {
  EchoBlock block;
  block.rows = 512;
  block.columns = 2;
  block.range_m = {3000.0, 3001.0};
  block.light_speed_mps = core::exact_light_speed_mps;
  for (std::size_t r = 0; r < block.rows; ++r) {
    const double t = 1e-3 * static_cast<double>(r);
    block.time_s.push_back(t);
    block.carrier_hz.push_back(1e9);
    block.samples.push_back(std::polar(3.0, 2.0 * core::pi * 125.0 * t));
    block.samples.push_back(std::polar(1.0, 2.0 * core::pi * 125.0 * t) + std::polar(1.0, -2.0 * core::pi * 125.0 * t));
  }
  const DopplerTime one = doppler_time(block, 0, SpectrumWindow::rectangular, 64);
  EXPECT_NEAR(std::abs(one.samples[(32 + 8) * one.time_s.size() + 5]), 3.0, 1e-9);
  EXPECT_NEAR(one.mean_hz[5], 125.0, 1e-6);
  EXPECT_NEAR(one.width_hz[5], 0.0, 1e-3);
  const DopplerTime two = doppler_time(block, 1, SpectrumWindow::rectangular, 64);
  EXPECT_NEAR(two.mean_hz[5], 0.0, 1e-6);
  EXPECT_NEAR(two.width_hz[5], 125.0, 1e-6);
}

TEST(DopplerTime, OfFewPulsesIsOneSpectrum) {
  const EchoBlock block = echo_block(receding_plan(), {0, 10});
  const DopplerTime history = doppler_time(block, 0, SpectrumWindow::hann, 64);
  ASSERT_EQ(history.time_s.size(), 1U);
  EXPECT_NEAR(history.time_s[0], 0.5 * (block.time_s.front() + block.time_s.back()), 1e-12);
  EXPECT_TRUE(doppler_time(EchoBlock{}, 0, SpectrumWindow::hann, 64).time_s.empty());
}

TEST(PowerSpectrum, HasTheMeanPowerOfTheRowAndTheBandOfTheChirp) {
  const EchoBlock block = echo_block(receding_plan(), {0, 1});
  const PowerSpectrum spectrum = power_spectrum(block, 0, SpectrumWindow::rectangular);
  double mean = 0.0;
  for (std::size_t c = 0; c < block.columns; ++c)
    mean += std::norm(block.at(0, c)) / static_cast<double>(block.columns);
  const double spacing = spectrum.frequency_hz[1] - spectrum.frequency_hz[0];
  const double total =
      std::accumulate(spectrum.density_w_per_hz.begin(), spectrum.density_w_per_hz.end(), 0.0) * spacing;
  EXPECT_NEAR(total, mean, 1e-9 * mean);
  double inside = 0.0;
  for (std::size_t i = 0; i < spectrum.frequency_hz.size(); ++i)
    if (std::abs(spectrum.frequency_hz[i]) < 26e6) inside += spectrum.density_w_per_hz[i] * spacing;
  EXPECT_GT(inside, 0.98 * total);
  EXPECT_NEAR(spectrum.frequency_hz[block.columns / 2], 0.0, 1e-6);
}

TEST(PowerSpectrum, OfATonePeaksAtItsFrequency) {
  EchoBlock block;
  block.rows = 1;
  block.columns = 100;
  block.sample_rate_hz = 1000.0;
  for (int i = 0; i < 100; ++i) block.samples.push_back(std::polar(2.0, -2.0 * core::pi * 0.13 * i));
  const PowerSpectrum spectrum = power_spectrum(block, 0, SpectrumWindow::hann);
  const auto peak = std::ranges::max_element(spectrum.density_w_per_hz) - spectrum.density_w_per_hz.begin();
  EXPECT_NEAR(spectrum.frequency_hz[static_cast<std::size_t>(peak)], -130.0, 1e-9);
}

TEST(PhaseHistory, UnwrappedIsThePathOfTheTarget) {
  // 40 m/s: 40 mm a pulse, 0.27 of a turn at 30 cm wavelength.
  const EchoBlock block = echo_block(receding_plan(40.0), {0, 64});
  const PhaseHistory history = phase_history(block, 300);
  ASSERT_EQ(history.path_m.size(), 64U);
  for (std::size_t r = 0; r < 64; ++r) {
    EXPECT_LE(std::abs(history.phase_rad[r]), core::pi);
    EXPECT_NEAR(std::remainder(history.unwrapped_rad[r] - history.phase_rad[r], 2.0 * core::pi), 0.0, 1e-9);
    if (r == 0) continue;
    EXPECT_LT(std::abs(history.unwrapped_rad[r] - history.unwrapped_rad[r - 1]), core::pi);
  }
  // The chirp moves with the target: a fixed cell sees its phase change by 2 pi K tau' (t - tau) too, below 30 %.
  EXPECT_NEAR(history.path_m[63] - history.path_m[0], 63.0 * 0.04, 0.3 * 63.0 * 0.04);
}

// Two curves over the same places, as one table.
std::string table_over(const std::vector<double>& x) {
  Figure figure;
  FigurePanel& panel = figure.panels.emplace_back();
  panel.x = {"Time", "s", 0.0, 1.0, {}};
  panel.y = {"Level", "V", 0.0, 1.0, {}};
  for (const char* name : {"a", "b"}) panel.curves.push_back({name, Role::curve, false, x, {1.0, 2.0}});
  return curves_table(figure, ',');
}

TEST(CurvesTable, LeavesPlacesThatAreNotKnownEmpty) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(table_over({0.0, 1.0}), "Time [s],a [V],b [V]\n0,1,1\n1,2,2\n");
  EXPECT_EQ(table_over({nan, 1.0}), "Time [s],a [V],b [V]\n,1,1\n1,2,2\n");
  EXPECT_EQ(table_over({nan, -infinite}), "Time [s],a [V],b [V]\n,1,1\n,2,2\n");
}

}  // namespace radar_views_test
}  // namespace sarsim::picture
