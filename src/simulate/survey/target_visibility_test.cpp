#include "simulate/survey/target_visibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/survey/survey.hpp"
#include "simulate/survey/survey_echoes.hpp"

namespace sarsim::simulate {
namespace sight_test {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double c = core::exact_light_speed_mps;

// An aircraft on +x at 200 m/s and 2 km, 10 km from a point at the origin, looks down with a beam of 0.5 x 8 degrees;
// 2 s at a PRF of 4 kHz.
scene::Scene strip() {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Plane", {0.0, -9797.959, 2000.0}, {200.0, 0.0, 0.0}));
  scene.targets = {target_on("Earth", {})};
  scene::Radar& radar = scene.radars[0];
  radar.platform = "Plane";
  radar.carrier_hz = 10e9;
  radar.prf_hz = 4000.0;
  radar.pulse_width_s = 1e-6;
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(0.5);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(8.0);
  radar.beam_elevation = core::Angle::from_deg(-11.537);
  scene::Simulation& simulation = scene.simulations[0];
  simulation.sample_rate_hz = 100e6;
  simulation.range_start_m = 9900.0;
  simulation.range_end_m = 10300.0;
  simulation.time_start_s = -1.0;
  simulation.time_end_s = 0.99999;
  return scene;
}

std::string said(const scene::Scene& scene) {
  std::string text;
  for (const core::Problem& problem : survey(scene)) text += core::to_string(problem) + "\n";
  return text;
}

TEST(TargetVisibility, FindsAPassageMuchShorterThanTheLooksAreApart) {
  scene::Scene scene = strip();
  scene.simulations[0].time_start_s = -1000.0;  // looks 31 s apart, of a beam that passes in 0.4 s
  scene.simulations[0].time_end_s = 1117.3;
  scene.radars[0].noise_temperature_k = 300.0;
  const Acquisition acquisition = acquisition_of(scene, 0);
  const TargetVisibility sight = VisibilitySurvey(acquisition, {0}).look().at(0);
  EXPECT_NEAR(static_cast<double>(sight.pulse) / 4000.0, 0.0, 0.03);  // a tenth of the beam
  EXPECT_GT(sight.pattern, 0.95);
  EXPECT_NEAR(sight.range_m, 10000.0, 1.0);
  // The integral of sinc^4 is 2/3: x = 0.88 sin(angle)/beamwidth, angle = V t/R.
  const double pulses = 4000.0 * 2.0 / 3.0 * (0.5 * core::pi / 180.0 / 0.88) * 10000.0 / 200.0;
  EXPECT_NEAR(sight.processed_snr / sight.snr, pulses, 0.03 * pulses);
}

TEST(TargetVisibility, SnrIsThatOfTheRadarEquation) {
  scene::Scene scene = one_target_scene();
  scene.simulations[0].time_end_s = 0.0994;  // 100 pulses at 1 kHz
  scene.radars[0].noise_temperature_k = 290.0;
  const TargetVisibility sight = VisibilitySurvey(acquisition_of(scene, 0), {0}).look().at(0);
  const double amplitude = equation_amplitude(1000.0, 1.0, c / 1e9);
  const double snr = amplitude * amplitude * 5e-6 / (1.380649e-23 * 290.0);
  EXPECT_NEAR(sight.snr / snr, 1.0, 1e-6);
  EXPECT_NEAR(sight.processed_snr / snr, 100.0, 1e-4);
}

TEST(TargetVisibility, HasNoSnrWhereTheNoiseIsTooWeakForNumbers) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].noise_temperature_k = 1e-300;
  const Acquisition acquisition = acquisition_of(scene, 0);
  const TargetVisibility sight = VisibilitySurvey(acquisition, {0}).look().at(0);
  EXPECT_EQ(sight.snr, 0.0);
  EXPECT_EQ(sight.processed_snr, 0.0);
  EXPECT_EQ(survey_echoes(acquisition).targets.at(0).snr, 0.0);
  scene.radars[0].noise_temperature_k = 1e-170;
  EXPECT_TRUE(std::isfinite(VisibilitySurvey(acquisition_of(scene, 0), {0}).look().at(0).processed_snr));
}

TEST(TargetVisibility, OfATurningBeamIsOnePass) {
  scene::Scene scene = one_target_scene();
  scene::Radar& radar = scene.radars[0];
  radar.beam = scene::Radar::Beam::rotating;
  radar.beam_rate = core::Angle::from_deg(36.0);
  radar.noise_temperature_k = 300.0;
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(1.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(10.0);
  scene.simulations[0].time_end_s = 50.0;  // five turns
  const TargetVisibility sight = VisibilitySurvey(acquisition_of(scene, 0), {0}).look().at(0);
  EXPECT_GT(sight.pattern, 0.95);
  const double pulses = 1000.0 * 2.0 / 3.0 / 0.88 / 36.0;
  EXPECT_NEAR(sight.processed_snr / sight.snr, pulses, 0.1 * pulses);
}

TEST(VisibilityRules, AreSilentOfABeamOnItsTargets) { EXPECT_EQ(said(strip()), ""); }

TEST(VisibilityRules, NoticeABeamThatLooksUp) {
  scene::Scene scene = strip();
  scene.radars[0].beam_elevation = core::Angle::from_deg(11.537);
  const std::string text = said(scene);
  EXPECT_THAT(text, HasSubstr("the beam misses all targets"));
  EXPECT_THAT(text, HasSubstr("write -11.54"));
}

TEST(VisibilityRules, NoticeAnglesThatWereExchanged) {
  scene::Scene scene = strip();
  scene.radars[0].beam_azimuth = core::Angle::from_deg(-11.537);
  scene.radars[0].beam_elevation = core::Angle::from_deg(0.0);
  EXPECT_THAT(said(scene), HasSubstr("Azimuth and elevation seem to be swapped"));
}

TEST(VisibilityRules, NoticeABeamThatPointsTheOppositeWayAndThatNothingIsReceived) {
  scene::Scene scene = strip();
  scene.radars[0].beam_azimuth = core::Angle::from_deg(180.0);
  const core::Problems problems = survey(scene);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, core::Severity::warning);
  EXPECT_EQ(problems[0].subject.field, "beam_elevation");
  EXPECT_THAT(problems[0].message, HasSubstr("no echo is received: the beam points away"));
  EXPECT_THAT(problems[0].hint, HasSubstr("opposite way"));
  EXPECT_THAT(problems[0].expected, HasSubstr("azimuth 0 deg, elevation -11.54 deg"));
}

TEST(VisibilityRules, SayWhereTheTargetsAreOfABeamAlongTheTrack) {
  scene::Scene scene = strip();
  scene.radars[0].beam_azimuth = core::Angle::from_deg(90.0);
  EXPECT_THAT(said(scene), HasSubstr("Set the azimuth to 0 and the elevation to -11.5"));
}

TEST(VisibilityRules, WarnOfEchoesThatDrownInNoise) {
  scene::Scene scene = strip();
  scene.radars[0].power_w = 1.0;
  scene.radars[0].noise_temperature_k = 300.0;
  EXPECT_THAT(said(scene), HasSubstr("the echoes have too low an SNR"));
  scene.radars[0].power_w = 1e6;
  EXPECT_EQ(said(scene), "");
}

TEST(VisibilityRules, WarnOfEchoesThatTheWindowCuts) {
  scene::Scene scene = strip();
  scene.simulations[0].range_end_m = 10100.0;  // two thirds of 150 m
  core::Problems problems = survey(scene);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, core::Severity::note);  // the focus of the script loses nothing
  EXPECT_THAT(problems[0].found, HasSubstr("66 %"));
  EXPECT_THAT(problems[0].expected, HasSubstr("9900 to 10150 m"));
  scene.simulations[0].range_start_m = 9990.0;
  EXPECT_THAT(said(scene), HasSubstr("shorter than the pulse"));
  scene.simulations[0] = strip().simulations[0];
  scene.simulations[0].pulse_position = scene::Simulation::PulsePosition::centre;
  scene.simulations[0].range_start_m = 9986.0;  // 14 m before the target, an echo of which begins 75 m before
  problems = survey(scene);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].severity, core::Severity::warning);
  EXPECT_THAT(problems[0].expected, HasSubstr("9925 to"));
  scene.simulations[0].processing = scene::Processing::matched_filter;
  EXPECT_EQ(said(scene), "");
}

TEST(VisibilityRules, NoteTargetsThatTheBeamPassesAtOtherTimes) {
  scene::Scene scene = strip();
  scene.targets.push_back(
      target_on("Earth", {270.0, 0.0, 0.0}));  // 70 m beyond the end of 200 m, at 10 km: 0.4 degrees
  const core::Problems problems = survey(scene);
  ASSERT_EQ(problems.size(), 1U) << said(scene);
  EXPECT_EQ(problems[0].severity, core::Severity::note);
  EXPECT_THAT(problems[0].message, HasSubstr("passes 1 of 2 targets (2) before or after"));
  scene.simulations[0].time_end_s = 1.5;
  EXPECT_EQ(said(scene), "");
}

TEST(VisibilityRules, DoNotAdviseALowerPrfFromOrbit) {
  scene::Scene scene = strip();
  scene.platforms[1] = moving("Plane", {0.0, -600e3, 600e3}, {7500.0, 0.0, 0.0});
  scene.radars[0].beam_elevation = core::Angle::from_deg(-45.0);
  scene.simulations[0].range_start_m = 848e3;
  scene.simulations[0].range_end_m = 849e3;
  const std::string text = said(scene);
  EXPECT_THAT(text, HasSubstr("22 pulses are in flight at once"));
  EXPECT_EQ(text.find("lower the PRF"), std::string::npos);
}

}  // namespace sight_test
}  // namespace sarsim::simulate
