#include "workflow/search/search_targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "signal/search/canceller.hpp"
#include "signal/search/swerling0.hpp"
#include "workflow/search/search_test_scene.hpp"

namespace sarsim::workflow {
namespace search_targets_test {

const double wavelength_m = core::exact_light_speed_mps / 10e9;

std::vector<TargetFinding> findings_of(const PulseRows& rows, const SearchOptions& options) {
  SearchTargets targets(rows, options);
  for (const SearchInterval& interval : intervals_of(rows, options)) (void)targets.take(interval);
  return targets.findings();
}

TEST(SearchTargets, KnowTheCellAndTheHeightOfATarget) {
  for (const double speed_mps : {0.0, -12.4, 16.7, 95.0})
    for (const std::size_t canceller : {0u, 1u, 2u})
      for (const std::size_t frequencies : {0u, 150u}) {
        if (speed_mps == 0.0 && canceller > 0) continue;
        SearchOptions options;
        options.pulses = 64;
        options.canceller = canceller;
        options.frequencies = frequencies;
        options.window.kind = signal::SarWindow::Kind::hamming;
        const PulseRows rows = pulse_rows_of(pulse_scene(speed_mps, 66));
        const TargetFinding finding = findings_of(rows, options).at(0);
        ASSERT_TRUE(finding.best) << speed_mps << " " << canceller;
        EXPECT_EQ(finding.best->row, finding.sight.row) << speed_mps;
        EXPECT_EQ(finding.best->column, finding.sight.column) << speed_mps;
        EXPECT_NEAR(finding.sight.doppler_hz, -2.0 * speed_mps / wavelength_m, 0.1);
        EXPECT_NEAR(finding.best->doppler_hz, finding.sight.seen_doppler_hz, 1.0);
        EXPECT_NEAR(finding.best->range_m, finding.sight.range_m, 0.5);
        // A range cell's edge takes up to 1 dB of a Hamming-weighted chirp at 1.25 samples a cell.
        EXPECT_LE(finding.best->magnitude_v, 1.001 * finding.sight.amplitude_v);
        EXPECT_GE(finding.best->magnitude_v, 0.88 * finding.sight.amplitude_v);
        EXPECT_TRUE(std::isinf(finding.sight.snr));
        EXPECT_FALSE(finding.probability);
        EXPECT_EQ(finding.found, 1u);
      }
}

TEST(SearchTargets, KnowTheNoiseOfEveryDopplerRow) {
  scene::Scene scene = noise_scene(2000, 100);
  // A target that is no more than a place to look at.
  scene.platforms.push_back(simulate::moving("Car", {0.0, 20e3, 0.0}, {0.0, -10.0, 0.0}));
  scene.targets.push_back(simulate::target_on("Car", {}, 1e-9));
  const PulseRows rows = pulse_rows_of(scene);
  for (const std::size_t canceller : {0u, 2u}) {
    SearchOptions options;
    options.pulses = 16;
    options.canceller = canceller;
    options.window.kind = signal::SarWindow::Kind::hamming;
    const TargetFinding finding = findings_of(rows, options).at(0);
    const double noise_w = finding.sight.amplitude_v * finding.sight.amplitude_v / finding.sight.snr;
    double power = 0.0;
    double count = 0.0;
    for (const SearchInterval& interval : intervals_of(rows, options))
      for (std::size_t n = 0; n < 100; ++n) {
        power += static_cast<double>(std::norm(interval.map.values[finding.sight.row * 100 + n]));
        count += 1.0;
      }
    EXPECT_NEAR(power / count / noise_w, 1.0, 5.0 / std::sqrt(count)) << canceller;
  }
}

// A beam of 2 degrees that turns by 0.03 degrees from pulse to pulse over a strong target that rests. It is met in
// pulse 203; its echo is one sample, the next one behind it.
scene::Scene swept_scene() {
  scene::Scene scene = noise_scene(400, 60);
  const double range_m = scene.simulations[0].range_start_m + 29.7 * 0.5 * core::exact_light_speed_mps / 1e6;
  const double bearing_rad = 6.1 * core::pi / 180.0;
  scene.targets.push_back(
      simulate::target_on("Earth", {range_m * std::sin(bearing_rad), range_m * std::cos(bearing_rad), 0.0}, 1e3));
  scene::Radar& radar = scene.radars[0];
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
  radar.beam = scene::Radar::Beam::rotating;
  radar.beam_rate = core::Angle::from_deg(120.0);
  radar.noise_temperature_k = 0.0;
  return scene;
}

// What the turning beam changes from pulse to pulse passes the cancellers, in the middle row or beside it: 0.2 % of the
// largest, which is 0.02 dB. Of intervals of 70 pulses every third is looked at.
TEST(SearchTargets, KnowWhatATurningBeamMakesOfATargetThatRests) {
  const PulseRows rows = pulse_rows_of(swept_scene());
  for (const std::size_t canceller : {0u, 1u, 2u})
    for (const std::size_t pulses : {7u, 33u, 70u}) {
      SearchOptions options;
      options.pulses = pulses;
      options.canceller = canceller;
      options.frequencies = pulses == 7 ? 16 : 0;
      double largest_v = 0.0;
      std::vector<std::pair<double, double>> expected_and_there;
      for (const SearchInterval& interval : intervals_of(rows, options)) {
        SearchTargets targets(rows, options);
        (void)targets.take(interval);
        const TargetVisibility sight = targets.findings().at(0).sight;
        const double there_v =
            static_cast<double>(std::abs(interval.map.values.at(sight.row * interval.map.samples + sight.column)));
        largest_v = std::max(largest_v, there_v);
        expected_and_there.emplace_back(sight.amplitude_v, there_v);
      }
      EXPECT_GT(largest_v, 0.0);
      for (const auto& [expected_v, there_v] : expected_and_there)
        EXPECT_NEAR(expected_v, there_v, 2e-3 * largest_v) << canceller << " " << pulses;
    }
}

// Where the canceller leaves as much of the rising as of the falling echo, the middle row is empty.
TEST(SearchTargets, ExpectWhatPassesACancellerInItsStrongestRow) {
  const PulseRows rows = pulse_rows_of(swept_scene());
  SearchOptions options;
  options.pulses = 33;
  options.canceller = 1;
  options.step = 1;
  options.detect = false;
  std::size_t beside = 0;
  for (const SearchInterval& interval : intervals_of(rows, options)) {
    if (interval.number < 160 || interval.number > 200) continue;
    SearchTargets targets(rows, options);
    (void)targets.take(interval);
    const TargetVisibility sight = targets.findings().at(0).sight;
    const auto height_v = [&](std::size_t row) {
      return static_cast<double>(std::abs(interval.map.values.at(row * interval.map.samples + sight.column)));
    };
    // Row 16 is that of resting targets.
    for (const std::size_t row : {15u, 16u, 17u}) EXPECT_LE(height_v(row), 1.02 * height_v(sight.row)) << row;
    if (sight.row != 16) ++beside;
  }
  EXPECT_GT(beside, 0u);
  EXPECT_LT(beside, 41u);
}

TEST(SearchTargets, AreFoundBehindACancellerWhereTheyAreExpected) {
  scene::Scene scene = swept_scene();
  // 63 dB in a pulse; a hundredth of the amplitude passes.
  scene.radars[0].noise_temperature_k = 290.0;
  const double echo_v = simulate::equation_amplitude(15e3 + 4452.0, 1.0, wavelength_m);
  scene.targets[0].rcs_m2 = 2e6 * 290.0 * core::boltzmann_j_per_k * 1e6 / (echo_v * echo_v);
  const PulseRows rows = pulse_rows_of(scene);
  SearchOptions options;
  options.pulses = 33;
  options.canceller = 1;
  const TargetFinding finding = findings_of(rows, options).at(0);
  ASSERT_TRUE(finding.best);
  ASSERT_TRUE(finding.probability);
  EXPECT_GT(finding.sight.snr, 1e3);
  EXPECT_GT(*finding.probability, 0.99);
  EXPECT_GE(finding.expected, 3u);
  EXPECT_GE(finding.found + 2, finding.expected);
  EXPECT_LE(finding.found, finding.expected + 3);
  // 33 dB of noise and more leave 10 %.
  EXPECT_NEAR(finding.best->magnitude_v / finding.sight.amplitude_v, 1.0, 0.1);
}

TEST(SearchTargets, PredictHowOftenTheyAreFound) {
  constexpr int pulses = 4000;
  scene::Scene scene = noise_scene(pulses, 60);
  const double step_m = 0.5 * core::exact_light_speed_mps / 1e6;
  const double range_m = scene.simulations[0].range_start_m + 29.5 * step_m;
  scene.targets.push_back(simulate::target_on("Earth", {0.0, range_m, 0.0}, 1e3));
  const double echo_v = simulate::equation_amplitude(range_m, 1e3, wavelength_m);
  scene.radars[0].noise_temperature_k = echo_v * echo_v / (9.0 * core::boltzmann_j_per_k * 1e6);
  SearchOptions options;
  options.cfar.false_alarm = 1e-4;
  options.all_cells = true;
  const TargetFinding finding = findings_of(pulse_rows_of(scene), options).at(0);
  EXPECT_NEAR(finding.sight.snr, 9.0, 1e-6);
  const double wanted = signal::cell_averaging_steady_probability(28, signal::cell_averaging_factor(28, 1e-4), 9.0);
  ASSERT_TRUE(finding.probability);
  EXPECT_NEAR(*finding.probability, wanted, 1e-9);
  EXPECT_EQ(finding.expected, wanted >= 0.5 ? std::size_t{pulses} : 0u);
  // Detections in the cells beside it count as its own, too: false alarms, at most two cells' worth.
  EXPECT_NEAR(static_cast<double>(finding.found) / pulses, wanted, 5.0 * std::sqrt(wanted * (1.0 - wanted) / pulses));
}

TEST(SearchTargets, GiveEachDetectionToTheNearest) {
  scene::Scene scene = pulse_scene(10.0, 64);
  scene.targets.push_back(simulate::target_on("Earth", {0.0, 5150.0, 0.0}, 2.0));
  SearchOptions options;
  options.pulses = 64;
  options.window.kind = signal::SarWindow::Kind::hamming;
  options.cfar.false_alarm = 1e-9;
  const PulseRows rows = pulse_rows_of(scene);
  SearchTargets targets(rows, options);
  const SearchInterval interval = intervals_of(rows, options).at(0);
  const auto of = targets.take(interval);
  ASSERT_EQ(of.size(), interval.detections.size());
  for (std::size_t d = 0; d < of.size(); ++d) {
    const SearchDetection& detection = interval.detections[d];
    const bool car = std::abs(detection.range_m - 5000.0) < 22.5 && std::abs(detection.speed_mps - 10.0) < 1.4;
    const bool house = std::abs(detection.range_m - 5150.0) < 22.5 && std::abs(detection.speed_mps) < 1.4;
    const auto wanted = car ? std::optional<std::size_t>(0) : house ? std::optional<std::size_t>(1) : std::nullopt;
    EXPECT_EQ(of[d], wanted) << detection.range_m << " " << detection.speed_mps;
  }
  const auto findings = targets.findings();
  EXPECT_EQ(findings.at(0).found, 1u);
  EXPECT_EQ(findings.at(1).found, 1u);
}

// An isotropic antenna that points to +y sees a target in +x as well, but says nothing of where it is.
TEST(SearchTargets, OfABeamThatDoesNotTurnAreInItsDirection) {
  SearchOptions options;
  options.cfar.false_alarm = 1e-9;
  for (const bool aside : {false, true}) {
    scene::Scene scene = pulse_scene(0.0, 4);
    scene.targets = {simulate::target_on("Earth", aside ? core::Vec3{5000.0, 0.0, 0.0} : core::Vec3{0.0, 5000.0, 0.0})};
    const PulseRows rows = pulse_rows_of(scene);
    SearchTargets targets(rows, options);
    for (const SearchInterval& interval : intervals_of(rows, options)) {
      EXPECT_FALSE(interval.detections.empty());
      for (const auto& of : targets.take(interval)) EXPECT_EQ(of.has_value() && aside, false);
    }
    EXPECT_EQ(targets.findings().at(0).found, aside ? 0u : 4u);
  }
  // Trains of pulses tell targets apart by their speeds as well.
  options.pulses = 4;
  scene::Scene scene = pulse_scene(0.0, 4);
  scene.targets = {simulate::target_on("Earth", {5000.0, 0.0, 0.0})};
  EXPECT_EQ(findings_of(pulse_rows_of(scene), options).at(0).found, 1u);
}

// Targets of one range and one speed differ in direction alone: each gets only what is detected while the beam is on
// it, half the sector of the interval and half the beam away at most.
TEST(SearchTargets, OfOneRangeRingGetTheDetectionsOfTheirOwnDirections) {
  std::mt19937 random(20261129);
  const double rad_per_deg = core::pi / 180.0;
  for (int draw = 0; draw < 4; ++draw) {
    scene::Scene scene = swept_scene();
    scene.simulations[0].time_end_s = (1400 - 0.5) / search_prf_hz;  // 42 degrees
    const double range_m = core::norm(scene.targets[0].position_m);
    scene.targets.clear();
    std::vector<double> bearings_deg;
    for (double bearing = 3.0; bearing < 39.0; bearing += std::uniform_real_distribution<double>(3.0, 8.0)(random)) {
      bearings_deg.push_back(bearing);
      const double b = bearing * rad_per_deg;
      scene.targets.push_back(simulate::target_on("Earth", {range_m * std::sin(b), range_m * std::cos(b), 0.0}, 1e3));
    }
    const PulseRows rows = pulse_rows_of(scene);
    SearchOptions options;
    options.pulses = std::uniform_int_distribution<std::size_t>(9, 40)(random);
    options.cfar.false_alarm = 1e-9;
    const double reach_deg = 0.5 * 0.03 * static_cast<double>(options.pulses - 1) + 1.0 + 1e-6;
    SearchTargets targets(rows, options);
    std::size_t taken = 0;
    for (const SearchInterval& interval : intervals_of(rows, options)) {
      EXPECT_NEAR(interval.half_sector_rad, 0.5 * 0.03 * rad_per_deg * static_cast<double>(options.pulses - 1), 1e-6);
      const auto of = targets.take(interval);
      for (std::size_t d = 0; d < of.size(); ++d) {
        if (!of[d]) continue;
        ++taken;
        EXPECT_LE(std::abs(interval.detections[d].azimuth_rad / rad_per_deg - bearings_deg[*of[d]]), reach_deg);
      }
    }
    EXPECT_GE(taken, bearings_deg.size());
    for (const TargetFinding& finding : targets.findings()) {
      EXPECT_GE(finding.found, 1u) << finding.target;
      // The beam is on it for so many intervals, and no longer.
      EXPECT_LE(static_cast<double>(finding.found),
                2.0 * reach_deg / (0.03 * static_cast<double>(options.pulses)) + 1.0);
    }
  }
}

// What is as strong as the target, in that direction and at that time, is the target; an antenna's side lobe that shows
// a stronger one of the same range and speed in its direction is not.
TEST(SearchTargets, AreNotFoundByTheSideLobesOfStrongerOnes) {
  std::mt19937 random(12);
  const double rad_per_deg = core::pi / 180.0;
  std::size_t by_side_lobe = 0;
  for (int draw = 0; draw < 6; ++draw) {
    scene::Scene scene = swept_scene();
    scene.radars[0].noise_temperature_k = 290.0;
    scene.simulations[0].time_end_s = (400 - 0.5) / search_prf_hz;  // 12 degrees
    const double range_m = core::norm(scene.targets[0].position_m);
    const auto at = [&](double bearing_deg, double rcs_m2) {
      const double b = bearing_deg * rad_per_deg;
      return simulate::target_on("Earth", {range_m * std::sin(b), range_m * std::cos(b), 0.0}, rcs_m2);
    };
    const double apart_deg = std::uniform_real_distribution<double>(2.6, 3.4)(random);
    const double weaker_db = std::uniform_real_distribution<double>(60.0, 80.0)(random);
    scene.targets = {at(4.0, 1e10), at(4.0 + apart_deg, 1e10 * std::pow(10.0, -0.1 * weaker_db))};
    const PulseRows rows = pulse_rows_of(scene);
    SearchOptions options;
    options.pulses = 9;
    SearchTargets targets(rows, options);
    for (const SearchInterval& interval : intervals_of(rows, options)) {
      const auto of = targets.take(interval);
      for (std::size_t d = 0; d < of.size(); ++d) {
        const bool beside = interval.detections[d].azimuth_rad > (4.0 + 0.5 * apart_deg) * rad_per_deg;
        if (beside && !of[d]) ++by_side_lobe;
      }
    }
    const std::vector<TargetFinding> findings = targets.findings();
    EXPECT_GE(findings[0].found, 5u);
    ASSERT_TRUE(findings[0].best);
    EXPECT_NEAR(findings[0].best->magnitude_v / findings[0].sight.amplitude_v, 1.0, 0.1);
    // The echo of the weaker one is below 2 % of the side lobe wherever the beam sees it.
    EXPECT_EQ(findings[1].found, 0u) << apart_deg << ' ' << weaker_db;
    // Alone it is found.
    scene.targets.erase(scene.targets.begin());
    scene.targets[0].rcs_m2 = 1e8;
    EXPECT_GE(findings_of(pulse_rows_of(scene), options).at(0).found, 1u);
  }
  EXPECT_GT(by_side_lobe, 6u);
}

// Echoes of one cell add up, in phase or not: both targets are found by what is detected there.
TEST(SearchTargets, OfOneCellAreFoundByTheSumOfTheirEchoes) {
  for (const double apart_m : {0.0, 1.0 / 4.0, 1.0 / 3.0}) {
    scene::Scene scene = pulse_scene(0.0, 64);
    scene.targets.push_back(simulate::target_on("Car", {0.0, apart_m * wavelength_m, 0.0}));
    SearchOptions options;
    options.pulses = 64;
    std::size_t found = 0;
    for (const TargetFinding& finding : findings_of(pulse_rows_of(scene), options)) found += finding.found;
    EXPECT_EQ(found, apart_m == 0.25 ? 0u : 1u) << apart_m;  // A quarter of the wavelength farther, they cancel.
  }
}

TEST(SearchTargets, DoNotExpectWhatLiesOutsideTheRecordedRanges) {
  scene::Scene scene = pulse_scene(0.0, 64);
  scene.targets[0].position_m.y = 3000.0;
  SearchOptions options;
  options.pulses = 64;
  const TargetFinding finding = findings_of(pulse_rows_of(scene), options).at(0);
  EXPECT_EQ(finding.sight.amplitude_v, 0.0);
  EXPECT_EQ(finding.found, 0u);
  EXPECT_FALSE(finding.best);
}

// Rows of what a run of the scene would record.
PulseRows recorded_rows(const scene::Scene& scene) {
  const auto acquisition = std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0));
  const auto recording = std::make_shared<const simulate::Recording>(
      simulate::record(simulate::plan_of(*acquisition, simulate::Engine::automatic)));
  return pulse_rows_of_recording(
      acquisition,
      core::rows_in_memory(std::shared_ptr<const std::vector<std::complex<double>>>(recording, &recording->samples),
                           acquisition->timing.rows, acquisition->reception.columns));
}

TEST(SearchTargets, KnowWhatTheEndOfARawRecordingLeavesOfAnEcho) {
  // A pulse of 1499 m, of which 749.5 m fit between target and the end of the window: by symmetry half of the weights.
  scene::Scene scene = pulse_scene(0.0, 64);
  scene.radars[0].noise_temperature_k = 290.0;
  SearchOptions options;
  options.pulses = 64;
  scene.simulations[0].range_end_m = 7000.0;
  const TargetVisibility whole = findings_of(recorded_rows(scene), options).at(0).sight;
  scene.simulations[0].range_end_m = 5749.5;
  const TargetVisibility half = findings_of(recorded_rows(scene), options).at(0).sight;
  EXPECT_NEAR(half.amplitude_v / whole.amplitude_v, 0.5, 0.02);
  EXPECT_NEAR(half.snr / whole.snr, 0.5, 0.03);
}

TEST(SearchTargets, GrowWithTheReceiversGainOverTimeAsNoiseDoes) {
  scene::Scene scene = pulse_scene(0.0, 64);
  scene.targets[0].rcs_m2 = 1e6;
  scene.radars[0].noise_temperature_k = 290.0;
  SearchOptions options;
  options.pulses = 64;
  const TargetFinding plain = findings_of(pulse_rows_of(scene), options).at(0);
  scene.radars[0].stc = scene::Radar::Stc::user;
  scene.radars[0].stc_gain.part = {simulate::lines({{0.0, 7.0}, {20000.0, 7.0}})};
  const TargetFinding loud = findings_of(pulse_rows_of(scene), options).at(0);
  EXPECT_NEAR(loud.sight.amplitude_v / plain.sight.amplitude_v, 7.0, 1e-9);
  EXPECT_NEAR(loud.sight.snr / plain.sight.snr, 1.0, 1e-9);
  ASSERT_TRUE(plain.best && loud.best);
  EXPECT_NEAR(loud.best->magnitude_v / plain.best->magnitude_v, 7.0, 1e-5);
}

TEST(SearchTargets, TakeTheShiftOfAChirpByItsDopplerFrequency) {
  // A long pulse of little bandwidth: 240 m/s shift its peak by 16 kHz/(1 MHz/100 us) = 1.6 us, 240 m.
  for (const double bandwidth_hz : {1e6, -1e6}) {
    scene::Scene scene = pulse_scene(-240.0, 64);
    scene.radars[0].bandwidth_hz = bandwidth_hz;
    scene.radars[0].pulse_width_s = 100e-6;
    scene.simulations[0].range_start_m = 3000.0;
    scene.simulations[0].range_end_m = 7000.0;
    scene.simulations[0].sample_rate_hz = 2e6;
    SearchOptions options;
    options.pulses = 32;
    options.cfar.guard_columns = 4;
    const TargetFinding finding = findings_of(pulse_rows_of(scene), options).at(0);
    const double shift_m = finding.sight.range_m - (5000.0 - 240.0 * finding.sight.time_s);
    EXPECT_NEAR(shift_m, bandwidth_hz > 0.0 ? -240.0 : 240.0, 2.0);
    ASSERT_TRUE(finding.best);
    EXPECT_NEAR(finding.best->range_m, finding.sight.range_m, 15.0);
  }
}

TEST(SteadyProbability, IsThatOfTheDetectorChosen) {
  signal::CfarOptions cfar;
  cfar.reference_columns = 10;
  const double ca = steady_probability(cfar, 8, 100, 20.0);
  EXPECT_EQ(ca, signal::cell_averaging_steady_probability(16, signal::cell_averaging_factor(16, 1e-6), 20.0));
  cfar.kind = signal::CfarOptions::Kind::ordered_statistic;
  EXPECT_EQ(steady_probability(cfar, 8, 100, 20.0),
            signal::ordered_statistic_steady_probability(16, 12, signal::ordered_statistic_factor(16, 12, 1e-6), 20.0));
  EXPECT_LT(steady_probability(cfar, 8, 100, 20.0), ca);
  cfar.independence = 0.5;
  EXPECT_EQ(steady_probability(cfar, 8, 100, 20.0),
            signal::ordered_statistic_steady_probability(8, 6, signal::ordered_statistic_factor(8, 6, 1e-6), 20.0));
  cfar.reference_columns = cfar.guard_columns;
  EXPECT_EQ(steady_probability(cfar, 8, 100, 20.0), 0.0);
}

TEST(SteadyProbability, CountsNoReferenceBeyondTheMap) {
  signal::CfarOptions cfar;
  cfar.reference_columns = 50;
  EXPECT_EQ(steady_probability(cfar, 8, 11, 20.0),
            signal::cell_averaging_steady_probability(6, signal::cell_averaging_factor(6, 1e-6), 20.0));
}

// Each pulse is multiplied with the sum of the differences that it is part of.
TEST(NoiseGains, AreTheSumOfTheSquaresOfWhatThePulsesAreMultipliedWith) {
  const std::vector<double> weights{0.3, 1.0, 0.8, -0.2, 0.5};
  for (const std::size_t canceller : {0u, 1u, 2u}) {
    const std::vector<double> differences = signal::canceller_weights(canceller);
    for (const std::size_t rows : {1u, 6u, 7u}) {
      const std::vector<double> gains = noise_gains(weights, canceller, rows);
      ASSERT_EQ(gains.size(), rows);
      for (std::size_t row = 0; row < rows; ++row) {
        const double cycles = (static_cast<double>(row) - static_cast<double>(rows / 2)) / static_cast<double>(rows);
        std::vector<std::complex<double>> filter(weights.size() + canceller);
        for (std::size_t p = 0; p < weights.size(); ++p)
          for (std::size_t k = 0; k < differences.size(); ++k)
            filter[p + k] +=
                weights[p] * differences[k] * std::polar(1.0, -2.0 * core::pi * cycles * static_cast<double>(p));
        double power = 0.0;
        for (const std::complex<double>& f : filter) power += std::norm(f);
        EXPECT_NEAR(gains[row], power, 1e-12) << canceller << " " << rows << " " << row;
      }
    }
  }
}

TEST(DetectorOf, KnowsWhatCorrelatedCellsAreWorth) {
  const PulseRows rows = pulse_rows_of(pulse_scene(0.0, 64));
  SearchOptions options;
  options.pulses = 64;
  // Hamming's weights, which are worth 1/1.36 of the band in noise, squared in power: about half of the samples.
  const double alone = detector_of(rows, options).independence;
  EXPECT_GT(alone, 0.35);
  EXPECT_LT(alone, 0.6);
  options.cfar.reference_rows = 2;
  EXPECT_NEAR(detector_of(rows, options).independence, alone, 1e-3);
  // Twice as many rows as pulses are worth half as much.
  options.frequencies = 128;
  EXPECT_NEAR(detector_of(rows, options).independence, 0.5 * alone, 2e-3);
  options.frequencies = 0;
  options.window.kind = signal::SarWindow::Kind::hann;
  // Neighbours of Hann's rows are correlated by 2/3, the next by 1/6.
  EXPECT_NEAR(detector_of(rows, options).independence, alone / (1.0 + 8.0 / 9.0 + 2.0 / 36.0), 3e-3);
}

}  // namespace search_targets_test
}  // namespace sarsim::workflow
