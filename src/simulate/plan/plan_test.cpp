#include "simulate/plan/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "simulate/plan/flight_test_scene.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace plan_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double c = core::exact_light_speed_mps;

double samples_between(double start_m, double end_m, double rate_hz, double light_speed_mps = c) {
  scene::Simulation s;
  s.range_start_m = start_m;
  s.range_end_m = end_m;
  s.sample_rate_hz = rate_hz;
  return sample_count(s, light_speed_mps);
}

TEST(SampleCount, IsThatOfTheKnownRecordings) {
  EXPECT_EQ(samples_between(0, 2000, 4e6), 53.0);
  EXPECT_EQ(samples_between(0, 2000, 4e6, core::classic_light_speed_mps), 53.0);
  EXPECT_EQ(samples_between(5550, 5870, 120e6), 256.0);
  EXPECT_EQ(samples_between(1000, 1500, 150e6), 500.0);
  EXPECT_EQ(samples_between(0, c / 4e6, 1e6), 1.0);  // half a sample counts as one
  EXPECT_EQ(samples_between(0, 0.99 * c / 4e6, 1e6), 0.0);
}

TEST(Plan, PhysicalSamplesAreTheSamplingIntervalApart) {
  scene::Scene scene = one_target_scene();
  scene.simulations[0].range_start_m = 300.0;
  for (const scene::Processing processing : {scene::Processing::raw, scene::Processing::matched_filter}) {
    scene.simulations[0].processing = processing;
    const Plan plan = make_plan(scene, 0);
    EXPECT_EQ(plan.acquisition.reception.raw_grid.interval_s, 1.0 / 4e6);
    EXPECT_EQ(plan.acquisition.reception.raw_grid.first_s, 600.0 / c);
    ASSERT_EQ(plan.acquisition.reception.columns, 45u);
    ASSERT_EQ(plan.acquisition.reception.column_range_m.size(), 45u);
    for (std::size_t i = 0; i < 45; ++i)
      EXPECT_NEAR(plan.acquisition.reception.column_range_m[i], 300.0 + static_cast<double>(i) * c / 8e6,
                  2e3 * 4.0 * epsilon);
  }
  EXPECT_EQ(make_plan(scene, 0).acquisition.reception.raw_grid.count, 45u + 19u);  // 20 taps
}

// Less than a cycle of sweep leaves the band of a pulse of that length.
TEST(Plan, ChirpsOfNoBandwidthKeepTheBandOfAnUnmodulatedPulse) {
  scene::Scene scene = one_target_scene();
  scene.options.pulse = scene::PulseDefinition::band_limited;
  scene.simulations[0].oversampling = 2.0;
  const auto half_band_hz = [&] {
    return make_plan(scene, 0).acquisition.reception.pulse.band_limited.value().half_band_hz();
  };
  const double plain_hz = half_band_hz();
  EXPECT_EQ(plain_hz, 0.5 / scene.radars[0].pulse_width_s);
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  for (const double bandwidth_hz : {0.0, 1e-3, -1e3}) {
    scene.radars[0].bandwidth_hz = bandwidth_hz;
    EXPECT_EQ(half_band_hz(), plain_hz) << bandwidth_hz;
  }
}

TEST(Plan, ClassicRawSamplesDivideTheWindow) {
  scene::Scene scene = one_target_scene();
  scene.options.profile = scene::Profile::classic;
  const Plan plan = make_plan(scene, 0);
  EXPECT_NEAR(plan.acquisition.reception.raw_grid.interval_s, 4000.0 / core::classic_light_speed_mps / 53.0,
              1e-6 * 4.0 * epsilon);
  for (std::size_t i = 0; i < 53; ++i)
    EXPECT_NEAR(plan.acquisition.reception.column_range_m[i], static_cast<double>(i) * 2000.0 / 53.0,
                2e3 * 8.0 * epsilon);
}

// The compressed sample i of the 1998 program is the raw one trunc(i F): the axis tells where that one lies. A window
// of 53.63 samples holds 54: F is below 1, and the second sample repeats the first.
TEST(Plan, ClassicCompressedColumnsTellWhereTheirSamplesWereTaken) {
  scene::Scene scene = one_target_scene();
  scene.options.profile = scene::Profile::classic;
  scene.simulations[0].processing = scene::Processing::matched_filter;
  for (const double end_m : {2000.0, 2010.0}) {  // 53.37 and 53.63 samples
    scene.simulations[0].range_end_m = end_m;
    const Plan plan = make_plan(scene, 0);
    const double exact = 8e6 * end_m / core::classic_light_speed_mps;
    const double ratio = exact / std::floor(exact + 0.5);
    for (std::size_t i = 0; i < plan.acquisition.reception.columns; ++i)
      EXPECT_NEAR(plan.acquisition.reception.column_range_m[i],
                  std::floor(static_cast<double>(i) * ratio + 1e-9) * core::classic_light_speed_mps / 8e6,
                  2e3 * 8.0 * epsilon);
  }
}

TEST(Plan, CompressionBeginsHalfAPulseEarlierForCentre) {
  scene::Scene scene = one_target_scene();
  scene.simulations[0].range_start_m = 900.0;
  scene.simulations[0].processing = scene::Processing::matched_filter;
  const double begin_s = make_plan(scene, 0).acquisition.reception.raw_grid.first_s;
  const auto peak = [&] { return make_plan(scene, 0).acquisition.reception.column_range_m; };
  const auto begin_axis = peak();
  scene.simulations[0].pulse_position = scene::Simulation::PulsePosition::centre;
  EXPECT_NEAR(make_plan(scene, 0).acquisition.reception.raw_grid.first_s, begin_s - 2.5e-6, 1e-5 * epsilon);
  EXPECT_EQ(peak(), begin_axis);
}

// A target whose delay is a whole number of samples after the window's start: the compressed peak has its own column,
// amplitude and phase, wherever in the pulse the delay is measured.
TEST(Plan, CompressedPeakStandsAtTheTargetsRangeWithItsAmplitudeAndPhase) {
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre}) {
    scene::Scene scene = one_target_scene();
    const double range_m = 26.0 * c / 8e6;
    scene.targets[0].position_m = {range_m, 0, 0};
    scene.radars[0].pulse = scene::Radar::Pulse::chirp;
    scene.radars[0].bandwidth_hz = 3e6;
    scene.radars[0].window = scene::Radar::Window::hamming;
    scene.simulations[0].processing = scene::Processing::matched_filter;
    scene.simulations[0].pulse_position = position;
    const std::complex<double> peak = samples_of(scene)[26];
    const double amplitude = equation_amplitude(range_m, 1.0, c / 1e9);
    // 6500 cycles of phase, each of 80 FFT outputs rounded a few times.
    EXPECT_LT(std::abs(peak - std::polar(amplitude, -2.0 * core::pi * std::remainder(1e9 * 2.0 * range_m / c, 1.0))),
              amplitude * (6500.0 * 2.0 * core::pi * 4.0 + 1e3) * epsilon);
  }
}

scene::Scene stepped_scene() {
  scene::Scene scene = one_target_scene();
  scene.targets[0].position_m = {1100.0, 0, 0};
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_step_hz = 2e6;
  scene.radars[0].carrier_steps = 8;
  scene.radars[0].pulses_per_step = 3;
  scene.simulations[0].processing = scene::Processing::srp;
  scene.simulations[0].range_start_m = 1090.0;
  scene.simulations[0].range_end_m = 1200.0;
  return scene;
}

TEST(Plan, SyntheticProfilesHaveARowForEachCompleteBurst) {
  scene::Scene scene = stepped_scene();  // 24 pulses a burst, 1 kHz
  const auto rows = [&](int first, int last) {
    scene.simulations[0].time_start_s = first * 1e-3;
    scene.simulations[0].time_end_s = last * 1e-3;
    const Plan plan = make_plan(scene, 0);
    EXPECT_EQ(plan.acquisition.timing.dropped_pulses,
              last - first + 1 - 24 * static_cast<int>(plan.acquisition.timing.rows));
    return std::pair(plan.acquisition.timing.rows,
                     plan.acquisition.timing.rows > 0 ? plan.acquisition.timing.first_pulse_of_row(0) : 0);
  };
  EXPECT_EQ(rows(0, 23), (std::pair<std::size_t, std::int64_t>(1, 0)));
  EXPECT_EQ(rows(0, 22).first, 0u);
  EXPECT_EQ(rows(1, 24).first, 0u);
  EXPECT_EQ(rows(1, 71), (std::pair<std::size_t, std::int64_t>(2, 24)));
  EXPECT_EQ(rows(-24, -1), (std::pair<std::size_t, std::int64_t>(1, -24)));
  EXPECT_EQ(rows(-25, 24), (std::pair<std::size_t, std::int64_t>(2, -24)));
}

TEST(Plan, SyntheticProfileColumnsAreTheBinsOfTheGates) {
  const Plan plan = make_plan(stepped_scene(), 0);
  ASSERT_EQ(plan.acquisition.reception.columns, 3u * 8u);
  const double bin_m = c / (2.0 * 8 * 2e6);
  EXPECT_NEAR(plan.acquisition.reception.column_range_m[0], 1090.0, 1e-9);
  EXPECT_NEAR(plan.acquisition.reception.column_range_m[3], 1090.0 + 3.0 * bin_m, 1e-9);
  EXPECT_NEAR(plan.acquisition.reception.column_range_m[8 + 5], 1090.0 + c / 8e6 + 5.0 * bin_m, 1e-9);
}

// CENTRE: the gate hears targets on both sides of it. The target stands 2 bins beyond the first gate.
TEST(Plan, SyntheticProfilePeakHasTheTargetsPlaceAmplitudeAndPhase) {
  scene::Scene scene = stepped_scene();
  const double range_m = 1090.0 + 2.0 * c / (2.0 * 8 * 2e6);
  scene.targets[0].position_m = {range_m, 0, 0};
  scene.radars[0].transmit_gain = core::PowerRatio::from_db(0.0);
  scene.simulations[0].pulse_position = scene::Simulation::PulsePosition::centre;
  scene.simulations[0].time_end_s = 0.023;
  const auto row = samples_of(scene);
  const std::complex<double> unit = std::polar(1.0, -2.0 * core::pi * std::remainder(1e9 * 2.0 * range_m / c, 1.0));
  // The amplitude of each step is that of its own wavelength: 1e9/(1e9 + 2e6 n), the mean over eight steps.
  double mean = 0.0;
  for (int n = 0; n < 8; ++n) mean += equation_amplitude(range_m, 1.0, c / (1e9 + 2e6 * n)) / 8.0;
  EXPECT_LT(std::abs(row[2] - mean * unit), mean * 1e-9);
}

TEST(Plan, NoiseIsKtTimesTheSamplingRateInAllOrKtbInEachPart) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].noise_temperature_k = 290.0;
  EXPECT_NEAR(make_plan(scene, 0).acquisition.reception.noise_stddev_v, std::sqrt(1.380649e-23 * 290.0 * 4e6 / 2.0),
              1e-8 * 4.0 * epsilon);
  scene.options.profile = scene::Profile::classic;
  EXPECT_NEAR(make_plan(scene, 0).acquisition.reception.noise_stddev_v, std::sqrt(1.38e-23 * 290.0 / 5e-6),
              1e-8 * 4.0 * epsilon);
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = -3e6;
  EXPECT_NEAR(make_plan(scene, 0).acquisition.reception.noise_stddev_v, std::sqrt(1.38e-23 * 290.0 * 3e6),
              1e-8 * 4.0 * epsilon);
  scene.radars[0].noise_temperature_k = 0.0;
  EXPECT_EQ(make_plan(scene, 0).acquisition.reception.noise_stddev_v, 0.0);
}

// |noise|^2 is exponentially distributed: its deviation is its mean.
TEST(Plan, RecordedNoiseHasItsPowerInEverySample) {
  scene::Scene scene = one_target_scene();
  scene.targets.clear();
  scene.radars[0].noise_temperature_k = 290.0;
  scene.simulations[0].time_end_s = 1.0;
  double power = 0.0;
  const auto samples = samples_of(scene);
  for (const auto& s : samples) power += std::norm(s);
  const auto n = static_cast<double>(samples.size());
  const double expected = 1.380649e-23 * 290.0 * 4e6;
  EXPECT_NEAR(power / n, expected, 5.0 * expected / std::sqrt(n));
}

TEST(Plan, PhysicalStcMultipliesSignalAndNoiseByTheSamplesRangeSquared) {
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre}) {
    scene::Scene scene = one_target_scene();
    scene.simulations[0].pulse_position = position;
    scene.radars[0].noise_temperature_k = 1e4;
    const auto plain = samples_of(scene);
    scene.radars[0].stc = scene::Radar::Stc::range_law;
    const auto controlled = samples_of(scene);
    scene.radars[0].stc = scene::Radar::Stc::user;
    scene.radars[0].stc_gain.part[0] = lines({{0.0, 1.0}, {1000.0, 5.0}});  // held beyond
    const auto user = samples_of(scene);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const double range_m = static_cast<double>(i) * c / 8e6;
      EXPECT_LE(std::abs(controlled[i] - range_m * range_m * plain[i]), range_m * range_m * std::abs(plain[i]) * 1e-14);
      EXPECT_LE(std::abs(user[i] - (1.0 + 0.004 * std::min(1000.0, range_m)) * plain[i]),
                20.0 * std::abs(plain[i]) * 1e-14);
    }
  }
}

TEST(Plan, PhysicalStcComesBeforeCompression) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].stc = scene::Radar::Stc::range_law;
  scene.simulations[0].processing = scene::Processing::matched_filter;
  scene.simulations[0].range_start_m = 500.0;
  const Plan plan = make_plan(scene, 0);
  ASSERT_EQ(plan.acquisition.reception.stc_gain.size(), plan.acquisition.reception.raw_grid.count);
  EXPECT_NEAR(plan.acquisition.reception.stc_gain[0], 250e3, 250e3 * 8.0 * epsilon);
  EXPECT_NEAR(std::sqrt(plan.acquisition.reception.stc_gain.back()),
              500.0 + static_cast<double>(plan.acquisition.reception.raw_grid.count - 1) * c / 8e6, 1e-9);
  scene.options.profile = scene::Profile::classic;
  EXPECT_TRUE(make_plan(scene, 0).acquisition.reception.stc_gain.empty());
}

TEST(Plan, RefusesEmptyWindowsAndUnknownRadars) {
  scene::Scene scene = one_target_scene();
  scene.simulations[0].range_end_m = 1.0;
  EXPECT_THROW((void)make_plan(scene, 0), std::invalid_argument);
  scene = one_target_scene();
  scene.simulations[0].time_start_s = 0.0001;
  scene.simulations[0].time_end_s = 0.0009;
  EXPECT_THROW((void)make_plan(scene, 0), std::invalid_argument);
  scene = one_target_scene();
  scene.simulations[0].radar = "Sonar";
  EXPECT_THROW((void)make_plan(scene, 0), std::invalid_argument);
  scene = one_target_scene();
  scene.simulations[0].range_end_m = 1e18;
  EXPECT_THROW((void)make_plan(scene, 0), std::invalid_argument);
}

TEST(Product, DescribesTheAxesOfTheRecording) {
  scene::Scene scene = stepped_scene();
  scene.simulations[0].time_end_s = 0.047;
  const raster::Product srp = product_of(make_plan(scene, 0), "text");
  EXPECT_EQ(srp.rows, 2u);
  EXPECT_EQ(srp.row_time_s(1), 0.024);
  EXPECT_EQ(srp.row_carrier_hz(1), 1e9);
  scene.simulations[0].processing = scene::Processing::raw;
  scene.simulations[0].time_start_s = -0.001;
  const raster::Product raw = product_of(make_plan(scene, 0), "text");
  EXPECT_EQ(raw.rows, 49u);
  EXPECT_EQ(raw.row_time_s(0), -0.001);
  EXPECT_EQ(raw.row_carrier_hz(0), 1e9 + 7 * 2e6);
  EXPECT_EQ(raw.column_range_m(0), 1090.0);
  EXPECT_EQ(raw.script, "text");
}

// 120 m/s along x from 0, 10 m/s upwards from 1 km, and the yaw of a function and a rate.
TEST(Product, SaysWhereTheRadarIs) {
  scene::Scene scene = flight_scene();
  scene::Platform& plane = scene.platforms[1];
  plane.position_stddev_m = {0.0, 0.0, 0.0};
  plane.rotation_stddev = {};
  plane.rotation_rate[2] = core::Angle::from_deg(3.0);
  scene.simulations = {flight_recording(0.0, scene::FileFormat::hdf5)};
  const raster::Product product = product_of(make_plan(scene, 0), "text");
  for (const std::size_t row : {std::size_t{0}, product.rows - 1}) {
    const double time_s = product.row_time_s(row);
    const raster::RowPose pose = product.row_pose(row);
    EXPECT_NEAR(pose.position_m[0], 120.0 * time_s, 1e-9);
    EXPECT_NEAR(pose.position_m[1], -2000.0, 1e-9);
    EXPECT_NEAR(pose.position_m[2], 1000.0 + 10.0 * time_s, 1e-9);
    EXPECT_NEAR(pose.velocity_mps[0], 120.0, 1e-9);
    EXPECT_NEAR(pose.velocity_mps[2], 10.0, 1e-9);
    EXPECT_NEAR(pose.rotation_rad[2], 3.0 * core::rad_per_deg * time_s, 1e-12);
  }
}

TEST(Plan, OfManyTargetsIsGivenUpWhenAskedTo) {
  scene::Scene scene = one_target_scene();
  scene.targets.resize(10000, scene.targets[0]);
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)resolve(scene, {1, &stop}), core::Interrupted);
  const auto resolved = std::make_shared<const ResolvedScene>(resolve(scene));
  EXPECT_THROW((void)group_points(*resolved, resolve_radar(scene, *resolved, 0), &stop), core::Interrupted);
  EXPECT_THROW((void)make_plan(scene, 0, resolved, Engine::direct, &stop), core::Interrupted);
  EXPECT_NO_THROW((void)make_plan(scene, 0, resolved, Engine::direct));
}

}  // namespace plan_test
}  // namespace sarsim::simulate
