#include "workflow/focus/sar_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace sar_rows_test {

TEST(SarRows, OfASceneFocusToTheRadarEquationAtTheTargetsPlace) {
  const core::Vec3 point{3.0, 17.0, 0.0};
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {point}));
  const double closest = std::hypot(10003.0, 2000.0);
  const signal::PointResponse response = focused_point(rows, {17.0, closest});
  EXPECT_NEAR(response.place.azimuth_m, 17.0, 0.02 * 0.72);
  EXPECT_NEAR(response.place.range_m, closest, 0.02 * 1.5);
  const double wavelength = rows.waveform.light_speed_mps / 5.3e9;
  EXPECT_NEAR(response.amplitude / simulate::equation_amplitude(closest, 1.0, wavelength), 1.0, 0.01);
  EXPECT_NEAR(std::remainder(response.phase_rad + 4.0 * core::pi * closest / wavelength, 2.0 * core::pi), 0.0, 0.01);
}

TEST(SarRows, BeginWithTheScriptsWindowWhereverItPutsThePulse) {
  scene::Scene scene = sar_scene(600.0, {{3.0, 0.0, 0.0}}, 0.2);
  const signal::SarEchoes begin = signal::sar_echoes(sar_recording(scene).second);
  scene.simulations[0].pulse_position = scene::Simulation::PulsePosition::centre;
  const signal::SarEchoes centre = signal::sar_echoes(sar_recording(scene).second);
  EXPECT_NEAR(begin.first_delay_s, 2.0 * 10098.0 / begin.waveform.light_speed_mps, 1e-15);
  EXPECT_NEAR(centre.first_delay_s, begin.first_delay_s, 1e-15);
  ASSERT_EQ(begin.samples, centre.samples);
  for (std::size_t n = 0; n < begin.volts.size(); ++n)
    ASSERT_NEAR(std::abs(begin.volts[n] - centre.volts[n]), 0.0, 1e-13) << n;
}

// 12 m beyond the start of the window, of which half a pulse of 800 ns is 60 m.
TEST(SarRows, OfAPulseInTheMiddleShowTargetsAtTheWindowsStart) {
  const core::Vec3 point{-90.0, 5.0, 0.0};
  scene::Scene scene = sar_scene(600.0, {point});
  scene.simulations[0].pulse_position = scene::Simulation::PulsePosition::centre;
  const auto [acquisition, rows] = sar_recording(scene);
  const double closest = std::hypot(9910.0, 2000.0);
  const signal::PointResponse response = focused_point(rows, {5.0, closest});
  EXPECT_NEAR(response.place.azimuth_m, 5.0, 0.02 * 0.72);
  EXPECT_NEAR(response.place.range_m, closest, 0.02 * 1.5);
  const double wavelength = rows.waveform.light_speed_mps / 5.3e9;
  EXPECT_NEAR(response.amplitude / simulate::equation_amplitude(closest, 1.0, wavelength), 1.0, 0.01);
}

// The raw row of 200 samples and a pulse of 120 in it must reach past the last of them.
TEST(SarRows, OfAPulseInTheMiddleHoldTheWholeEchoesOfTheWindowsEnd) {
  scene::Scene scene = sar_scene(600.0, {}, 0.1);
  scene.simulations[0].pulse_position = scene::Simulation::PulsePosition::centre;
  const simulate::Acquisition window = simulate::acquisition_of(scene, 0);
  const auto [acquisition, rows] = sar_recording(scene);
  EXPECT_EQ(rows.columns, window.reception.columns);
  EXPECT_GE(acquisition->reception.columns, window.reception.columns + 119);
  EXPECT_NEAR(acquisition->reception.raw_grid.first_s, 2.0 * 10098.0 / rows.waveform.light_speed_mps - 400e-9, 1e-15);
}

// Reader of what a plan makes.
core::SampleRows<double> rows_made_by(const std::shared_ptr<const simulate::Acquisition>& acquisition) {
  const auto recording = std::make_shared<const simulate::Recording>(
      simulate::record(simulate::plan_of(*acquisition, simulate::Engine::automatic)));
  return core::rows_in_memory(std::shared_ptr<const std::vector<std::complex<double>>>(recording, &recording->samples),
                              acquisition->timing.rows, acquisition->reception.columns);
}

TEST(SarRows, OfARecordingAreThoseOfTheSceneButAtTheWindowsEnd) {
  const scene::Scene scene = sar_scene(600.0, {{3.0, 4.0, 0.0}}, 0.1);
  const auto acquisition = shared_acquisition(scene);
  const signal::SarEchoes recorded = signal::sar_echoes(sar_rows_of_recording(acquisition, rows_made_by(acquisition)));
  const signal::SarEchoes made = signal::sar_echoes(sar_recording(scene).second);
  ASSERT_EQ(recorded.samples, made.samples);
  EXPECT_EQ(recorded.first_delay_s, made.first_delay_s);
  // A pulse has 120 samples; the target's is wholly inside.
  for (std::size_t n = 0; n + 121 < made.samples; ++n)
    ASSERT_NEAR(std::abs(recorded.volts[n] - made.volts[n]), 0.0, 1e-13) << n;
}

TEST(SarRows, OfACompressedRecordingAreTheRecordingNoiseIncluded) {
  for (const auto position : {scene::Simulation::PulsePosition::begin, scene::Simulation::PulsePosition::centre}) {
    scene::Scene scene = sar_scene(600.0, {{3.0, 4.0, 0.0}}, 0.1);
    scene.radars[0].noise_temperature_k = 300.0;
    scene.simulations[0].processing = scene::Processing::matched_filter;
    scene.simulations[0].pulse_position = position;
    const auto acquisition = shared_acquisition(scene);
    const signal::SarEchoes taken = signal::sar_echoes(sar_rows_of_recording(acquisition, rows_made_by(acquisition)));
    const signal::SarEchoes made = signal::sar_echoes(sar_recording(scene).second);
    ASSERT_EQ(taken.samples, made.samples);
    EXPECT_NEAR(taken.first_delay_s, made.first_delay_s, 1e-15);
    for (std::size_t n = 0; n < made.volts.size(); ++n)
      ASSERT_NEAR(std::abs(taken.volts[n] - made.volts[n]), 0.0, 1e-6 * 1e-7) << n;
  }
}

TEST(SarEchoesOfRows, AreTheSameForAnyNumberOfThreads) {
  const auto [acquisition, rows] = sar_recording(sar_scene(600.0, {{3.0, 4.0, 0.0}}, 0.1));
  EXPECT_TRUE(signal::sar_echoes(rows, {.threads = 1}).volts == signal::sar_echoes(rows, {.threads = 3}).volts);
}

TEST(GeometricDopplerCentroid, IsThatOfTheTargetsOrTheBeam) {
  EXPECT_NEAR(geometric_doppler_centroid_hz(simulate::acquisition_of(sar_scene(600.0, {{0.0, 0.0, 0.0}}), 0)), 0.0,
              2.0);
  scene::Scene empty = sar_scene(600.0, {});
  empty.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  empty.radars[0].beam_azimuth = core::Angle::from_deg(80.0);
  const double expected = 2.0 * 200.0 * 5.3e9 / 299792458.0 * std::sin(10.0 * core::pi / 180.0);
  EXPECT_NEAR(geometric_doppler_centroid_hz(simulate::acquisition_of(empty, 0)), expected, 0.01);
  // An antenna without a beam points nowhere.
  empty.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::isotropic;
  EXPECT_EQ(geometric_doppler_centroid_hz(simulate::acquisition_of(empty, 0)), 0.0);
}

TEST(GeometricDopplerCentroid, IsThatOfASurfaceWhereThereIsNothingElse) {
  scene::Scene scene = sar_scene(600.0, {}, 0.02);
  // One of them shows the radar its back.
  scene.surfaces.push_back(
      {"Earth", {core::Vec3{0.0, 495.0, 0.0}, core::Vec3{0.0, 505.0, 0.0}, core::Vec3{10.0, 500.0, 0.0}}});
  scene.surfaces.push_back(
      {"Earth", {core::Vec3{0.0, 505.0, 0.0}, core::Vec3{0.0, 495.0, 0.0}, core::Vec3{10.0, 500.0, 0.0}}});
  const double ahead = 500.0 / std::hypot(10000.0, 2000.0, 500.0);
  EXPECT_NEAR(geometric_doppler_centroid_hz(simulate::acquisition_of(scene, 0)),
              2.0 * 200.0 * 5.3e9 / 299792458.0 * ahead, 1.0);
}

std::string first_problem(const scene::Scene& scene, bool recorded = false) {
  const core::Problems problems = problems_of_sar(simulate::acquisition_of(scene, 0), recorded);
  return problems.empty() ? std::string() : problems.front().message;
}

TEST(ProblemsOfSar, NameWhatNoMethodCanFocus) {
  EXPECT_EQ(first_problem(sar_scene(600.0, {{}})), "");
  scene::Scene resting_radar = sar_scene(600.0, {{}});
  resting_radar.radars[0].platform = "Earth";
  EXPECT_NE(first_problem(resting_radar).find("does not move"), std::string::npos);
  scene::Scene stepped = sar_scene(600.0, {{}});
  stepped.radars[0].carrier = scene::Radar::Carrier::stepped;
  stepped.radars[0].carrier_step_hz = 1e6;
  const auto [acquisition, rows] = sar_recording(stepped);  // Of back projection alone.
  EXPECT_EQ(rows.carriers_hz.size(), rows.rows);
  EXPECT_NE(core::to_string(signal::problems_of_focusing(rows, {}).at(0)).find("carrier changes"), std::string::npos);
  EXPECT_TRUE(signal::problems_of_focusing_in_time(rows, {}).empty());
  stepped.simulations[0].processing = scene::Processing::srp;
  EXPECT_NE(first_problem(stepped, true).find("synthetic range profiles"), std::string::npos);
  EXPECT_NE(first_problem(sar_scene(600.0, {{}}, 0.0012)).find("too few pulses"), std::string::npos);
}

TEST(ProblemsOfSar, RefuseOfRecordingsAloneWhatAScriptIsRecordedAnewWithout) {
  scene::Scene profiles = sar_scene(600.0, {{}});
  profiles.simulations[0].processing = scene::Processing::srp;
  EXPECT_EQ(first_problem(profiles, false), "");
  EXPECT_NE(first_problem(profiles, true).find("synthetic range profiles"), std::string::npos);
  // 200.1 samples fill the window: the classic profile of 200 columns is spread over them.
  scene::Scene classic = sar_scene(600.0, {{}});
  classic.simulations[0].processing = scene::Processing::matched_filter;
  classic.simulations[0].range_end_m = 10297.5;
  classic.options.profile = scene::Profile::classic;
  EXPECT_EQ(first_problem(classic, false), "");
  EXPECT_NE(first_problem(classic, true).find("the classic profile"), std::string::npos);
}

}  // namespace sar_rows_test
}  // namespace sarsim::workflow
