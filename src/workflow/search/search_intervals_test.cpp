#include "workflow/search/search_intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "signal/search/canceller.hpp"
#include "signal/search/swerling0.hpp"
#include "workflow/search/search_test_scene.hpp"

namespace sarsim::workflow {
namespace search_intervals_test {

const double wavelength_m = core::exact_light_speed_mps / 10e9;

TEST(SearchIntervals, CountWholeIntervalsOnly) {
  SearchOptions options;
  options.pulses = 64;
  EXPECT_EQ(interval_count(options, 63), 0u);
  EXPECT_EQ(interval_count(options, 64), 1u);
  EXPECT_EQ(interval_count(options, 255), 3u);
  options.canceller = 2;
  EXPECT_EQ(interval_count(options, 257), 3u);
  EXPECT_EQ(interval_count(options, 258), 4u);
  options.step = 10;
  EXPECT_EQ(interval_count(options, 66 + 39), 4u);
}

TEST(SearchIntervals, ShowAMovingTargetsSpeedAndRangeWithinATenthOfACell) {
  for (const double speed_mps : {-21.3, -7.77, 0.0, 15.0, 28.9})
    for (const std::size_t canceller : {0u, 1u, 2u})
      for (const auto window : {signal::SarWindow::Kind::rectangular, signal::SarWindow::Kind::taylor}) {
        if (speed_mps == 0.0 && canceller > 0) continue;
        SearchOptions options;
        options.pulses = 64;
        options.canceller = canceller;
        options.window.kind = window;
        const auto intervals = intervals_of(pulse_rows_of(pulse_scene(speed_mps, 140)), options);
        ASSERT_EQ(intervals.size(), 2u);
        for (const SearchInterval& interval : intervals) {
          const SearchDetection& found = strongest(interval);
          const double cell_mps = 0.5 * wavelength_m * search_prf_hz / 64.0;
          EXPECT_NEAR(found.speed_mps, speed_mps, 0.1 * cell_mps) << canceller;
          EXPECT_NEAR(found.doppler_hz, -2.0 * speed_mps / wavelength_m, 0.1 * search_prf_hz / 64.0);
          EXPECT_NEAR(found.range_m, 5000.0 + speed_mps * found.time_s, 0.1 * 15.0) << speed_mps;
        }
        EXPECT_NEAR(intervals[1].time_s - intervals[0].time_s, 64.0 / search_prf_hz, 1e-12);
      }
}

TEST(SearchIntervals, FoldSpeedsBeyondTheUnambiguousOne) {
  SearchOptions options;
  options.pulses = 64;
  // lambda PRF/4 is 30 m/s: 40 m/s look like -20.
  const double folded_mps = 40.0 - 0.5 * wavelength_m * search_prf_hz;
  const auto intervals = intervals_of(pulse_rows_of(pulse_scene(40.0, 64)), options);
  EXPECT_NEAR(strongest(intervals.at(0)).speed_mps, folded_mps, 0.1);
}

TEST(SearchIntervals, PassTargetsWithTheGainOfTheCanceller) {
  // In the middle of a Doppler cell, where the map keeps an amplitude.
  const double doppler_hz = 16.0 * search_prf_hz / 64.0;
  const scene::Scene scene = pulse_scene(-0.5 * wavelength_m * doppler_hz, 66);
  SearchOptions options;
  options.pulses = 64;
  const double plain = strongest(intervals_of(pulse_rows_of(scene), options).at(0)).magnitude_v;
  for (const std::size_t order : {1u, 2u}) {
    options.canceller = order;
    const double passed = strongest(intervals_of(pulse_rows_of(scene), options).at(0)).magnitude_v;
    EXPECT_NEAR(passed / plain, std::pow(2.0 * std::sin(core::pi / 4.0), static_cast<double>(order)), 0.01);
  }
  // What rests leaves nothing but rounding.
  const auto resting = intervals_of(pulse_rows_of(pulse_scene(0.0, 66)), options).at(0);
  for (const auto& value : resting.map.values) EXPECT_LT(std::abs(value), 1e-5 * plain);
}

TEST(SearchIntervals, HaveTheFalseAlarmsTheyPromise) {
  const PulseRows rows = pulse_rows_of(noise_scene(320, 400));
  for (const std::size_t canceller : {0u, 2u})
    for (const auto kind : {signal::CfarOptions::Kind::cell_averaging, signal::CfarOptions::Kind::ordered_statistic}) {
      SearchOptions options;
      options.pulses = 16;
      options.canceller = canceller;
      options.all_cells = true;
      options.cfar.kind = kind;
      options.cfar.false_alarm = 2e-3;
      options.cfar.reference_columns = 10;
      const auto intervals = intervals_of(rows, options);
      double found = 0.0;
      for (const SearchInterval& interval : intervals) found += static_cast<double>(interval.detections.size());
      const double expected = 2e-3 * 16.0 * 400.0 * static_cast<double>(intervals.size());
      // Cells share reference cells; after a canceller rows are correlated over about two of 16.
      const double spread = canceller > 0 ? 3.0 : 2.0;
      EXPECT_NEAR(found, expected, 5.0 * std::sqrt(spread * expected)) << canceller;
    }
}

TEST(SearchIntervals, FindSteadyTargetsAsOftenAsTheClosedFormSays) {
  constexpr int targets = 16;
  constexpr int pulses = 1500;
  scene::Scene scene = noise_scene(pulses, 24 * targets);
  scene.options.ambiguous_echoes = scene::AmbiguousEchoes::none;
  const double step_m = 0.5 * core::exact_light_speed_mps / 1e6;
  const double first_m = scene.simulations[0].range_start_m;
  // A pulse covers one sample, the one half a sample behind its range. 24 cells apart, all equally strong.
  for (int t = 0; t < targets; ++t) {
    const double range_m = first_m + (11.5 + 24 * t) * step_m;
    scene.targets.push_back(simulate::target_on("Earth", {0.0, range_m, 0.0}, 1e3 * std::pow(range_m / 15e3, 4.0)));
  }
  const double echo_v = simulate::equation_amplitude(15e3, 1e3, wavelength_m);
  const double snr = 10.0;
  scene.radars[0].noise_temperature_k = echo_v * echo_v / (snr * core::boltzmann_j_per_k * 1e6);
  const PulseRows rows = pulse_rows_of(scene);
  for (const auto kind : {signal::CfarOptions::Kind::cell_averaging, signal::CfarOptions::Kind::ordered_statistic}) {
    SearchOptions options;
    options.all_cells = true;
    options.cfar.kind = kind;
    options.cfar.false_alarm = 1e-3;
    options.cfar.guard_columns = 2;
    options.cfar.reference_columns = 10;
    double hits = 0.0;
    each_interval(rows, options, {2, nullptr}, {}, [&](const SearchInterval& interval) {
      for (const SearchDetection& d : interval.detections) hits += d.column % 24 == 12 ? 1.0 : 0.0;
    });
    const double wanted =
        kind == signal::CfarOptions::Kind::cell_averaging
            ? signal::cell_averaging_steady_probability(16, signal::cell_averaging_factor(16, 1e-3), snr)
            : signal::ordered_statistic_steady_probability(16, 12, signal::ordered_statistic_factor(16, 12, 1e-3), snr);
    const double trials = targets * static_cast<double>(pulses);
    EXPECT_NEAR(hits / trials, wanted, 5.0 * std::sqrt(wanted * (1.0 - wanted) / trials));
  }
}

TEST(SearchIntervals, MeasureTheRatioToTheNoise) {
  scene::Scene scene = pulse_scene(10.0, 64 * 40);
  const double echo_v = simulate::equation_amplitude(5000.0, 1.0, wavelength_m);
  // 3 dB after the matched filter, so that sidelobes drown; the interval adds 18.
  scene.radars[0].noise_temperature_k = echo_v * echo_v * 10e-6 / (2.0 * core::boltzmann_j_per_k);
  const PulseRows rows = pulse_rows_of(scene);
  for (const auto kind : {signal::CfarOptions::Kind::cell_averaging, signal::CfarOptions::Kind::ordered_statistic}) {
    SearchOptions options;
    options.pulses = 64;
    options.cfar.kind = kind;
    options.cfar.false_alarm = 1e-3;
    options.cfar.guard_columns = 4;
    options.cfar.reference_columns = 20;
    double mean = 0.0;
    const auto intervals = intervals_of(rows, options);
    for (const SearchInterval& interval : intervals)
      mean += strongest(interval).magnitude_v * strongest(interval).magnitude_v / strongest(interval).snr /
              static_cast<double>(intervals.size());
    // 40 means of 32 cells, of which 2 of 3 are independent.
    EXPECT_NEAR(mean / (rows.noise_w / 64.0), 1.0, 5.0 * std::sqrt(2.0 / (40.0 * 20.0)));
  }
}

TEST(SearchIntervals, AreTheSameHoweverTheyAreGroupedAndForAnyNumberOfThreads) {
  scene::Scene scene = pulse_scene(10.0, 700);
  scene.radars[0].noise_temperature_k = 290.0;
  const PulseRows rows = pulse_rows_of(scene);
  std::vector<std::complex<float>> all(rows.pulses() * rows.samples());
  for (std::size_t p = 0; p < rows.pulses(); ++p)
    rows.read(p, std::span(all).subspan(p * rows.samples(), rows.samples()));
  for (const auto& [pulses, step] :
       {std::pair(1u, 0u), std::pair(16u, 0u), std::pair(16u, 5u), std::pair(20u, 50u), std::pair(300u, 150u)}) {
    SearchOptions options;
    options.pulses = pulses;
    options.step = step;
    options.canceller = 1;
    options.cfar.false_alarm = 1e-3;
    const auto one = intervals_of(rows, options, 1);
    const auto expected = signal::range_doppler_maps(signal::cancelled(all, rows.samples(), 1), rows.samples(),
                                                     search_prf_hz, coherent_interval(options), {1, nullptr});
    ASSERT_EQ(one.size(), expected.size()) << pulses;
    ASSERT_EQ(one.size(), interval_count(options, rows.pulses()));
    const auto three = intervals_of(rows, options, 3);
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].number, i);
      EXPECT_EQ(one[i].first_pulse, expected[i].first_pulse);
      EXPECT_TRUE(one[i].map.values == expected[i].values) << i;
      EXPECT_TRUE(three[i].map.values == expected[i].values) << i;
      ASSERT_EQ(one[i].detections.size(), three[i].detections.size());
      for (std::size_t d = 0; d < one[i].detections.size(); ++d) {
        EXPECT_EQ(one[i].detections[d].range_m, three[i].detections[d].range_m);
        EXPECT_EQ(one[i].detections[d].doppler_hz, three[i].detections[d].doppler_hz);
      }
    }
  }
}

TEST(SearchIntervals, KnowWhereARotatingBeamPoints) {
  scene::Scene scene = pulse_scene(0.0, 400);
  scene.radars[0].beam = scene::Radar::Beam::rotating;
  scene.radars[0].beam_rate = core::Angle::from_deg(720.0);
  SearchOptions options;
  options.detect = false;
  for (const std::size_t pulses : {1u, 2u, 7u}) {
    options.pulses = pulses;
    for (const SearchInterval& interval : intervals_of(pulse_rows_of(scene), options))
      EXPECT_NEAR(core::azimuth_rad(interval.beam_world), 4.0 * core::pi * interval.time_s, 1e-6);
  }
}

TEST(SearchIntervals, HoldNoMoreThanTheySay) {
  SearchOptions options;
  options.pulses = 64;
  // Four intervals, read and mapped.
  EXPECT_EQ(interval_bytes(options, 100000, 1000), 1000.0 * (8.0 * 256.0 + 12.0 * 256.0));
  options.pulses = 1024;
  options.canceller = 1;
  EXPECT_EQ(interval_bytes(options, 100000, 1000), 1000.0 * (16.0 * 1025.0 + 12.0 * 1024.0));
}

TEST(SearchIntervals, EndWhenAskedTo) {
  const PulseRows rows = pulse_rows_of(pulse_scene(0.0, 64));
  SearchOptions options;
  options.pulses = 8;
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW(each_interval(rows, options, {1, &stop}, {}, [](const SearchInterval&) {}), core::Interrupted);
  options.pulses = 0;
  EXPECT_THROW(each_interval(rows, options, {}, {}, [](const SearchInterval&) {}), std::invalid_argument);
}

}  // namespace search_intervals_test
}  // namespace sarsim::workflow
