#include "simulate/survey/survey.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/survey/survey_echoes.hpp"

namespace sarsim::simulate {
namespace survey_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double c = core::exact_light_speed_mps;

auto problem(core::Severity severity, const std::string& field, const std::string& words) {
  return AllOf(Field(&core::Problem::severity, severity), Field(&core::Problem::message, HasSubstr(words)),
               Field(&core::Problem::subject, Field(&core::Subject::field, field)));
}

// The scene of one target, 200 pulses, with an LSB that fits it: 2.13e-7 V over 127 counts.
scene::Scene sound_scene() {
  scene::Scene scene = one_target_scene();
  scene.simulations[0].time_end_s = 0.199;
  scene.simulations[0].lsb_v = 2e-9;
  return scene;
}

TEST(Survey, OfASoundSceneIsSilent) {
  EXPECT_THAT(survey(sound_scene()), IsEmpty());
  scene::Scene no_simulation = sound_scene();
  no_simulation.simulations.clear();
  EXPECT_THAT(survey(no_simulation), IsEmpty());
}

TEST(Survey, WarnsWhereAllEchoesMissTheWindowAndSaysWhereTheyAre) {
  scene::Scene scene = sound_scene();
  scene.simulations[0].range_start_m = 2000.0;  // the echo ends at 1000 m + 750 m
  scene.simulations[0].range_end_m = 3000.0;
  const core::Problems problems = survey(scene);
  ASSERT_THAT(problems, ElementsAre(problem(core::Severity::warning, "range_start_m", "no echo falls into")));
  EXPECT_THAT(problems[0].expected, HasSubstr("1000"));
  EXPECT_THAT(problems[0].expected, HasSubstr("1749.48"));
  EXPECT_THAT(problems[0].message, HasSubstr("estimate from 64 of 200 pulses"));
  scene.simulations[0].range_start_m = 1740.0;  // its last 9 m, a sample
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "range_start_m", "cuts the echoes")));
  scene.simulations[0].range_start_m = 2000.0;
  scene.simulations[0].range_end_m = 3300.0;
  scene.targets.push_back(target_on("Earth", {2500, 0, 0}, 40.0));
  EXPECT_THAT(survey(scene), IsEmpty());
}

// The world's z axis is up; 60 deg farther west nothing of the radar at 700 km is seen.
TEST(Survey, WarnsOfTargetsBehindTheEarth) {
  scene::Scene scene = sound_scene();
  scene.world.frame = scene::World::Frame::earth;
  scene.world.latitude = core::Angle::from_deg(40.0);
  scene.platforms.push_back(resting("High", {0.0, 0.0, 700e3}));
  scene.radars[0].platform = "High";
  scene.targets = {target_on("Earth", {0.0, 0.0, 0.0}, 1e9), target_on("Earth", {-5.5e6, 0.0, -3.2e6}, 1e9)};
  scene.simulations[0].range_start_m = 699.9e3;
  scene.simulations[0].range_end_m = 701e3;
  const auto is_horizon = Field(&core::Problem::message, HasSubstr("the Earth blocks"));
  core::Problems problems = survey(scene);
  ASSERT_THAT(problems, ::testing::Contains(is_horizon));
  EXPECT_EQ(
      std::ranges::find_if(problems, [](const core::Problem& p) { return p.message.starts_with("the Earth"); })->found,
      "1 of 2 targets behind the horizon, the first of them target 2; 0 in the window");
  scene.targets[1] = target_on("Earth", {-5.5e6, 0.0, 3.2e6}, 1e9);
  EXPECT_THAT(survey(scene), ::testing::Not(::testing::Contains(is_horizon)));
  scene.world.frame = scene::World::Frame::flat;
  scene.targets[1] = target_on("Earth", {-5.5e6, 0.0, -3.2e6}, 1e9);
  EXPECT_THAT(survey(scene), ::testing::Not(::testing::Contains(is_horizon)));
}

TEST(Survey, WarnsOfASceneWithoutTargets) {
  scene::Scene scene = sound_scene();
  scene.targets.clear();
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "", "zeros only")));
  scene.radars[0].noise_temperature_k = 300.0;
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "", "noise only")));
  scene.surfaces.push_back({});
  scene.radars[0].carrier_hz = 0.14e9;  // 2.1 m
  EXPECT_THAT(survey(scene), IsEmpty());
}

TEST(Survey, SaysThatThePointsOfASurfaceAreTooFewBelowAWavelengthOfTwoMetres) {
  scene::Scene scene = sound_scene();
  scene.surfaces.push_back({});
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::note, "radar", "too coarse for this wavelength")));
}

// 200 m/s both ways at 1 GHz: a band of 4 * 200/0.2998 = 2669 Hz.
TEST(Survey, WarnsOfAPrfBelowTheDopplerBand) {
  scene::Scene scene = sound_scene();
  scene.platforms.push_back(moving("Away", {1000, 0, 0}, {200, 0, 0}));
  scene.platforms.push_back(moving("Towards", {1000, 0, 0}, {-200, 0, 0}));
  scene.targets = {target_on("Away", {}), target_on("Towards", {})};
  scene.simulations[0].lsb_v = 0.0;
  const core::Problems problems = survey(scene);
  ASSERT_THAT(problems, ElementsAre(problem(core::Severity::warning, "radar", "PRF is below the Doppler band")));
  EXPECT_EQ(problems[0].id.name(), "prf.below-doppler-band");
  EXPECT_THAT(problems[0].expected, HasSubstr("2.669 kHz"));
  scene.radars[0].prf_hz = 2700.0;
  EXPECT_THAT(survey(scene), IsEmpty());
  scene.radars[0].prf_hz = 1000.0;
  scene.radars[0].beam = scene::Radar::Beam::rotating;  // of no use for images along a track
  scene.radars[0].beam_rate = core::Angle::from_deg(60.0);
  EXPECT_THAT(survey(scene), IsEmpty());
  scene.radars[0].beam = scene::Radar::Beam::fixed;
  scene.targets.pop_back();  // one speed has no band, however fast
  EXPECT_THAT(survey(scene), IsEmpty());
}

TEST(Survey, DopplerBandLeavesOutEchoesThatDoNotMatter) {
  scene::Scene scene = sound_scene();
  scene.platforms.push_back(moving("Away", {1000, 0, 0}, {500, 0, 0}));
  scene.simulations[0].lsb_v = 0.0;
  scene.targets.push_back(target_on("Away", {}, 1e-5));  // 50 dB below
  EXPECT_THAT(survey(scene), IsEmpty());
  scene.targets.back().rcs_m2 = 1e-3;  // 30 dB below
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "radar", "PRF")));
  scene.targets.back().position_m = {3000, 0, 0};  // out of the window
  EXPECT_THAT(survey(scene), IsEmpty());
}

TEST(Survey, WarnsOfAnLsbThatClipsOrWastesTheConverter) {
  scene::Scene scene = sound_scene();
  scene.simulations[0].lsb_v = 1.6e-9;  // full scale 2.03e-7 V, the echo has 2.13e-7
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "lsb_v", "too small")));
  scene.simulations[0].lsb_v = 5e-9;
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "lsb_v", "too large")));
  for (int i = 1; i < 10; ++i)  // ten echoes that add up, of one cell
    scene.targets.push_back(target_on("Earth", {1000.0, 0.1 * i, 0.0}));
  scene.simulations[0].lsb_v = 5e-8;
  const core::Problems large = survey(scene);
  ASSERT_THAT(large, ElementsAre(problem(core::Severity::warning, "lsb_v", "too large"),
                                 problem(core::Severity::note, "", "targets 1 and 2 are unresolved")));
  EXPECT_THAT(large[0].expected, HasSubstr("1.67"));  // 10 x 2.13e-7 V over 127 counts: 1.67e-8 V
  scene.targets.resize(1);
  scene.simulations[0].format = scene::FileFormat::npy;  // volts: no converter
  EXPECT_THAT(survey(scene), IsEmpty());
  scene.simulations[0].format = scene::FileFormat::binary;
  scene.simulations[0].lsb_v = 0.0;
  EXPECT_THAT(survey(scene), IsEmpty());
}

TEST(Survey, RefusesATargetAtTheRadarsPosition) {
  scene::Scene scene = sound_scene();
  scene.targets.push_back(target_on("Earth", {}));
  const core::Problems problems = survey(scene);
  ASSERT_THAT(problems, ElementsAre(problem(core::Severity::error, "position_m", "is at the position of radar")));
  EXPECT_EQ(problems[0].subject.kind, "target");
  EXPECT_EQ(problems[0].subject.index, 1u);
}

TEST(Survey, SaysOnceThatATargetIsImpossibleWhateverRecordsIt) {
  scene::Scene scene = sound_scene();
  scene.targets.push_back(target_on("Earth", {}));
  scene.simulations.push_back(scene.simulations[0]);
  EXPECT_EQ(survey(scene).size(), 1u);
}

TEST(Survey, RefusesATargetFasterThanLight) {
  scene::Scene scene = sound_scene();
  scene::Platform comet;
  comet.name = "Comet";
  comet.path = scene::Platform::Path::trajectory;
  comet.trajectory_m.part[0].knots = {{0.0, 1000.0}, {1.0, 3.1e8}};
  scene.platforms.push_back(comet);
  scene.targets.push_back(target_on("Comet", {}));
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::error, "position_m", "fast as light")));
}

TEST(Survey, WarnsOfEchoesThatComeAfterTheNextPulse) {
  scene::Scene scene = sound_scene();
  scene.radars[0].prf_hz = 200e3;  // 749 m
  const core::Problems problems = survey(scene);
  ASSERT_THAT(problems,
              ElementsAre(problem(core::Severity::warning, "radar",
                                  "arrive after the next pulse has left: rows also contain range-ambiguous echoes of"),
                          problem(core::Severity::note, "radar", "arrive while the radar transmits")));
  EXPECT_THAT(problems[0].expected, HasSubstr("749.48"));
  scene.radars[0].prf_hz = 149e3;  // 1006 m
  EXPECT_THAT(survey(scene),
              testing::Not(testing::Contains(problem(core::Severity::warning, "radar", "the next pulse"))));
}

TEST(Survey, SaysWhichOtherPulsesAreHeardAndWhatThePulseCovers) {
  scene::Scene scene = sound_scene();
  scene.targets.push_back(target_on("Earth", {1000.0 + 749.48, 0.0, 0.0}));  // a pulse interval beyond the first
  scene.radars[0].prf_hz = 200e3;
  scene.simulations[0].range_start_m = 800.0;
  scene.simulations[0].range_end_m = 1900.0;
  scene.radars[0].pulse_width_s = 1e-6;
  const core::Problems heard = survey(scene);
  ASSERT_THAT(heard, ElementsAre(problem(core::Severity::warning, "radar",
                                         "of 2 of 2 targets arrive after the next pulse has left: rows also contain "
                                         "range-ambiguous echoes of the pulse before and the pulse after their own")));
  EXPECT_THAT(heard[0].found, HasSubstr("; the strongest echo is among them, antenna patterns not applied"));
  scene.options.ambiguous_echoes = scene::AmbiguousEchoes::all;
  EXPECT_THAT(survey(scene),
              ElementsAre(problem(core::Severity::note, "radar", "rows also contain range-ambiguous echoes of")));
  scene.options.ambiguous_echoes = scene::AmbiguousEchoes::none;
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "radar", "are left out")));
  scene.options.ambiguous_echoes = scene::AmbiguousEchoes::all;
  scene.targets.pop_back();
  scene.targets[0].position_m.x = 800.0;  // 0.33 us after the next pulse
  EXPECT_THAT(survey(scene),
              testing::Contains(problem(
                  core::Severity::note, "radar",
                  "echoes of 1 of 1 targets arrive while the radar transmits; the receiver is assumed to stay on")));
  scene.options.eclipsing = scene::Eclipsing::blanked;
  EXPECT_THAT(survey(scene), testing::Contains(problem(core::Severity::note, "radar", "transmits and are blanked")));
}

TEST(Survey, ReportsBurstsThatAreMissingOrCut) {
  scene::Scene scene = sound_scene();
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_step_hz = 1e6;
  scene.radars[0].carrier_steps = 10;
  scene.radars[0].pulses_per_step = 2;
  scene.simulations[0].processing = scene::Processing::srp;
  EXPECT_THAT(survey(scene), IsEmpty());  // 200 pulses, 10 bursts
  scene.simulations[0].time_end_s = 0.205;
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::note, "time_end_s", "6 pulses of incomplete bursts")));
  scene.simulations[0].time_end_s = 0.018;
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::error, "time_end_s", "no complete burst")));
}

TEST(Survey, WarnsOfASurfaceThatShowsItsBackToTheRadar) {
  scene::Scene scene = sound_scene();
  scene.surfaces.assign(2, scene::Surface());
  scene.radars[0].carrier_hz = 0.14e9;
  scene.simulations[0].lsb_v = 0.0;
  EXPECT_THAT(survey(scene), IsEmpty());
  std::swap(scene.surfaces[1].corner_m[1], scene.surfaces[1].corner_m[2]);
  const core::Problems problems = survey(scene);
  ASSERT_THAT(problems, ElementsAre(problem(core::Severity::warning, "corner_m", "faces away")));
  EXPECT_EQ(problems[0].subject.kind, "surface");
  EXPECT_EQ(problems[0].subject.index, 1u);
  scene.platforms[0].position_m = {};
  scene.platforms.push_back(moving("Plane", {900, 0, 0}, {1000, 0, 0}));  // passes it: sees both sides
  scene.radars[0].platform = "Plane";
  scene.targets.clear();
  scene.surfaces.erase(scene.surfaces.begin());
  EXPECT_THAT(survey(scene), IsEmpty());
}

TEST(Survey, WarnsOfAWindowThatLeavesNothing) {
  scene::Scene scene = sound_scene();
  scene.radars[0].window = scene::Radar::Window::bartlett;
  EXPECT_THAT(survey(scene), IsEmpty());  // raw data have no use for it
  scene.simulations[0].processing = scene::Processing::matched_filter;
  EXPECT_THAT(survey(scene), IsEmpty());
  scene.simulations[0].sample_rate_hz = 1.0 / 5e-6;  // one sample a pulse, at its leading edge
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "radar", "is zero at every sample")));
  scene.simulations[0].processing = scene::Processing::srp;
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_step_hz = 1e6;
  scene.radars[0].carrier_steps = 2;
  scene.radars[0].pulses_per_step = 1;
  EXPECT_THAT(survey(scene), ElementsAre(problem(core::Severity::warning, "radar", "is zero at every sample")));
  scene.radars[0].carrier_steps = 4;
  EXPECT_THAT(survey(scene), IsEmpty());
}

TEST(Survey, WarnsOfAWindowThatCancels) {
  scene::Scene scene = sound_scene();
  scene.simulations[0].processing = scene::Processing::matched_filter;
  scene.radars[0].window = scene::Radar::Window::user;
  const auto from_to = [&](double first, double last) {
    scene.radars[0].window_gain.part[0] = {core::Interpolation::linear, {{0.0, first}, {1.0, last}}};
    return survey(scene);
  };
  const double rate_hz = scene.simulations[0].sample_rate_hz;
  const double samples = std::ceil(scene.radars[0].pulse_width_s * rate_hz - 1e-9);
  const double last = (samples - 1.0) / (scene.radars[0].pulse_width_s * rate_hz);  // where the last sample stands
  ASSERT_GT(samples, 2.0);
  EXPECT_THAT(from_to(1.0, 1.0 - 2.0 / last), ElementsAre(problem(core::Severity::warning, "radar", "cancels")));
  EXPECT_THAT(from_to(-1.0, -1.0), IsEmpty());
  EXPECT_THAT(from_to(1.0, -2.0), IsEmpty());
}

TEST(SurveyEchoes, MeasuresRangeDopplerAmplitudeAndSignalToNoise) {
  scene::Scene scene = sound_scene();
  scene.platforms.push_back(moving("Away", {1000, 0, 0}, {100, 0, 0}));
  scene.targets = {target_on("Away", {}), target_on("Earth", {5000, 0, 0})};
  scene.radars[0].noise_temperature_k = 100.0;
  scene.radars[0].pulse_width_s = 1e-6;
  const EchoSurvey survey = survey_echoes(acquisition_of(scene, 0));
  EXPECT_EQ(survey.pulses_sampled, 64u);
  EXPECT_FALSE(survey.all_pulses);
  ASSERT_EQ(survey.targets.size(), 2u);
  const TargetSurvey& away = survey.targets[0];
  EXPECT_NEAR(away.nearest_m, 1000.0 / (1.0 - 100.0 / c), 1e-9);  // of the first and the last pulse
  EXPECT_NEAR(away.farthest_m, 1019.9 / (1.0 - 100.0 / c), 1e-9);
  EXPECT_NEAR(away.lowest_doppler_hz, -2.0 * 100.0 * 1e9 / c, 1e-9);  // receding: below the carrier
  EXPECT_NEAR(away.largest_amplitude_v, equation_amplitude(1000.0 / (1.0 - 100.0 / c), 1.0, c / 1e9),
              1e-7 * 100.0 * epsilon);  // where the pulse meets it
  EXPECT_NEAR(away.snr, std::pow(away.largest_amplitude_v, 2.0) * 1e-6 / (1.380649e-23 * 100.0), 1e-12);
  EXPECT_NEAR(10.0 * std::log10(away.snr), 15.16, 0.005);  // thesis A.2: 15.2 dB
  EXPECT_TRUE(away.in_window);
  EXPECT_FALSE(survey.targets[1].in_window);
  EXPECT_EQ(survey.highest_doppler_hz, away.highest_doppler_hz);
  EXPECT_EQ(survey.largest_sum_v, away.largest_amplitude_v);
}

// Pulse 101 of 200 is none of the 64 that are looked at.
TEST(Survey, NamesThePulseAtWhichTheRadarMeetsATarget) {
  scene::Scene scene = sound_scene();
  scene.platforms.push_back(moving("Flight", {-1010, 0, 0}, {10000, 0, 0}));
  scene.radars[0].platform = "Flight";
  scene.targets = {target_on("Earth", {0, 0, 0}), target_on("Earth", {5, 300, 0})};
  const core::Problems problems = survey(scene);
  ASSERT_THAT(problems, ElementsAre(problem(core::Severity::error, "position_m", "is at the position of radar")));
  EXPECT_THAT(problems[0].message, HasSubstr("(pulse 101, 0.101 s)"));
  EXPECT_EQ(problems[0].subject.index, 0U);
  scene.targets = {target_on("Earth", {0, 1, 0})};
  for (const core::Problem& found : survey(scene)) EXPECT_NE(found.severity, core::Severity::error) << found.message;
}

// 30 000 targets are several ranges; on two platforms, some of them jittered, some, if wanted, on the radar.
scene::Scene wide_scene(bool with_impossible_targets) {
  scene::Scene scene = sound_scene();
  scene.platforms.push_back(moving("Away", {1000, 0, 0}, {100, 3, 0}));
  scene.radars[0].noise_temperature_k = 100.0;
  scene.surfaces.resize(3);
  scene.targets.clear();
  for (int i = 0; i < 30'000; ++i) {
    scene.targets.push_back(target_on(i % 3 == 0 ? "Away" : "Earth", {900.0 + 0.05 * i, 0.1 * i, 0.0}, 0.1 + i % 7));
    if (with_impossible_targets && i % 1000 == 5) scene.targets.back() = target_on("Earth", {});
    if (i % 11 == 0) scene.targets.back().traits.edit().rcs_stddev_m2 = 0.5;
  }
  return scene;
}

TEST(SurveyEchoes, AddUpToTheTotalsOfTheirTargets) {
  EXPECT_EQ(survey_echoes(acquisition_of(wide_scene(true), 0)).totals.impossible.size(), 30u);
  const EchoSurvey survey = survey_echoes(acquisition_of(wide_scene(false), 0));
  EXPECT_THAT(survey.totals.impossible, IsEmpty());
  EXPECT_TRUE(survey.totals.any_in_window);
  EXPECT_GT(survey.highest_doppler_hz, survey.lowest_doppler_hz + 100.0);
  double nearest = survey.targets[0].nearest_m;
  double strongest = 0.0;
  for (const TargetSurvey& t : survey.targets) {
    nearest = std::min(nearest, t.nearest_m);
    if (t.in_window) strongest = std::max(strongest, t.largest_amplitude_v);
  }
  EXPECT_EQ(survey.totals.nearest_m, nearest);
  EXPECT_EQ(survey.totals.strongest_v, strongest);
}

TEST(SurveyEchoes, AreTheSameForAnyNumberOfThreads) {
  for (const bool with_impossible_targets : {false, true}) {
    const Acquisition acquisition = acquisition_of(wide_scene(with_impossible_targets), 0);
    const EchoSurvey one = survey_echoes(acquisition);
    for (const unsigned threads : {2u, 3u, 8u}) {
      const EchoSurvey more = survey_echoes(acquisition, {threads});
      EXPECT_EQ(more.targets, one.targets);
      EXPECT_EQ(more.totals, one.totals);
      EXPECT_EQ(more.largest_sum_v, one.largest_sum_v);
      EXPECT_EQ(more.lowest_doppler_hz, one.lowest_doppler_hz);
      EXPECT_EQ(more.highest_doppler_hz, one.highest_doppler_hz);
      EXPECT_EQ(more.surface_faces_radar, one.surface_faces_radar);
    }
  }
}

TEST(SurveyEchoes, EndWhenAskedTo) {
  core::StopFlag stop;
  stop.request();
  const Acquisition acquisition = acquisition_of(sound_scene(), 0);
  EXPECT_THROW(static_cast<void>(survey_echoes(acquisition, {2, &stop})), core::Interrupted);
  EXPECT_THROW(static_cast<void>(survey(sound_scene(), nullptr, {1, &stop})), core::Interrupted);
}

// 6 s of a beam of 2 degrees that turns by 73 or -73 degrees a second, 1000 pulses a second: at one pulse it is within
// half a step, 0.037 degrees, of the target, where sin(x)/x has lost 0.04 %. An even choice of 64 pulses, 7 degrees
// from each other, would be right by chance.
TEST(SurveyEchoes, FindsTargetsInANarrowBeamThatTurns) {
  for (const double rate : {73.0, -73.0})
    for (const double azimuth_deg : {10.0, 33.3, 133.3, 251.0, 359.0}) {
      scene::Scene scene = sound_scene();
      const double azimuth = core::Angle::from_deg(azimuth_deg).rad();
      scene.targets = {target_on("Earth", {1000.0 * std::sin(azimuth), 1000.0 * std::cos(azimuth), 0.0})};
      scene.simulations[0].time_end_s = 6.0;
      scene::Radar& radar = scene.radars[0];
      radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
      radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
      radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(20.0);
      radar.beam = scene::Radar::Beam::rotating;
      radar.beam_rate = core::Angle::from_deg(rate);
      const EchoSurvey found = survey_echoes(acquisition_of(scene, 0));
      EXPECT_NEAR(found.targets[0].largest_amplitude_v / equation_amplitude(1000.0, 1.0, c / 1e9), 1.0, 1e-3)
          << rate << ' ' << azimuth_deg;
      EXPECT_LE(found.pulses_sampled, 64u + 5u);
    }
}

TEST(SurveyEchoes, PassesOverTargetsThatATurningBeamNeverMeets) {
  scene::Scene scene = sound_scene();
  scene.targets = {target_on("Earth", {0.0, -1000.0, 0.0})};
  scene.simulations[0].time_end_s = 1.0;  // 0 to 73 degrees
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  scene.radars[0].transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
  scene.radars[0].transmit_antenna.elevation_beamwidth = core::Angle::from_deg(20.0);
  scene.radars[0].beam = scene::Radar::Beam::rotating;
  scene.radars[0].beam_rate = core::Angle::from_deg(73.0);
  EXPECT_EQ(survey_echoes(acquisition_of(scene, 0)).pulses_sampled, 64u);
}

TEST(SurveyEchoes, LooksAtEveryPulseOfAShortRecording) {
  scene::Scene scene = sound_scene();
  scene.simulations[0].time_end_s = 0.063;
  EXPECT_TRUE(survey_echoes(acquisition_of(scene, 0)).all_pulses);
  scene.simulations[0].time_end_s = 0.064;
  EXPECT_FALSE(survey_echoes(acquisition_of(scene, 0)).all_pulses);
  scene.simulations[0].time_end_s = 0.0;
  EXPECT_EQ(survey_echoes(acquisition_of(scene, 0)).pulses_sampled, 1u);
}

}  // namespace survey_test
}  // namespace sarsim::simulate
