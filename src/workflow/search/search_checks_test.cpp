#include "workflow/search/search_checks.hpp"

#include <gtest/gtest.h>

#include "workflow/search/search_test_scene.hpp"

namespace sarsim::workflow {
namespace search_checks_test {

simulate::Acquisition plan_of(scene::Scene scene) {
  scene.simulations[0] = compressed_simulation(scene.simulations[0]);
  return simulate::acquisition_of(scene, 0);
}

bool mentions(const core::Problems& problems, core::Severity severity, const std::string& text) {
  return std::ranges::any_of(problems, [&](const core::Problem& p) {
    return p.severity == severity && core::to_string(p).find(text) != std::string::npos;
  });
}

SearchOptions train_of(std::size_t pulses, std::size_t canceller = 0) {
  SearchOptions options;
  options.pulses = pulses;
  options.canceller = canceller;
  return options;
}

scene::Scene noisy_scene(double speed_mps) {
  scene::Scene scene = pulse_scene(speed_mps);
  scene.radars[0].noise_temperature_k = 290.0;
  return scene;
}

TEST(ProblemsOfSearch, AreNoneForASoundRadar) {
  EXPECT_TRUE(problems_of_search(plan_of(noisy_scene(10.0)), train_of(64, 2)).empty());
  EXPECT_TRUE(diagnose_search(plan_of(noisy_scene(10.0)), train_of(64, 2)).empty());
}

TEST(ProblemsOfSearch, AreTrainsOfUnlikePulses) {
  scene::Scene staggered = noisy_scene(0.0);
  staggered.radars[0].repetition = scene::Radar::Repetition::user;
  staggered.radars[0].pri_s.part[0] = simulate::lines({{0.0, 250e-6}, {1.0, 300e-6}});
  EXPECT_TRUE(
      mentions(problems_of_search(plan_of(staggered), train_of(64)), core::Severity::error, "not evenly spaced"));
  EXPECT_TRUE(
      mentions(problems_of_search(plan_of(staggered), train_of(1, 1)), core::Severity::error, "not evenly spaced"));
  EXPECT_TRUE(problems_of_search(plan_of(staggered), train_of(1)).empty());
  scene::Scene agile = noisy_scene(0.0);
  agile.radars[0].carrier = scene::Radar::Carrier::stepped;
  EXPECT_TRUE(mentions(problems_of_search(plan_of(agile), train_of(64)), core::Severity::error, "carrier changes"));
  EXPECT_TRUE(problems_of_search(plan_of(agile), train_of(1)).empty());
}

TEST(ProblemsOfSearch, AreSizesThatDoNotFit) {
  const simulate::Acquisition acquisition = plan_of(noisy_scene(0.0));
  SearchOptions options = train_of(1024, 1);
  EXPECT_TRUE(
      mentions(problems_of_search(acquisition, options), core::Severity::error, "more pulses than the recording"));
  EXPECT_TRUE(problems_of_search(acquisition, train_of(1023, 1)).empty());
  options = train_of(64);
  options.frequencies = 63;
  options.cfar.reference_columns = options.cfar.guard_columns;
  const core::Problems both = problems_of_search(acquisition, options);
  EXPECT_TRUE(mentions(both, core::Severity::error, "fewer Doppler frequencies"));
  EXPECT_TRUE(mentions(both, core::Severity::error, "no reference cells"));
  options.detect = false;
  options.frequencies = 64;
  EXPECT_TRUE(problems_of_search(acquisition, options).empty());
  options.pulses = 1;
  EXPECT_TRUE(
      mentions(problems_of_search(acquisition, options), core::Severity::error, "a single pulse has no Doppler"));
}

TEST(RemarksOnSearch, SayWhatFoldsAndWhatIsBlind) {
  // lambda PRF/4 is 30 m/s, the first blind speed 60 m/s.
  const core::Problems fast = diagnose_search(plan_of(noisy_scene(40.0)), train_of(64));
  EXPECT_TRUE(mentions(fast, core::Severity::warning, "1 of 1 targets exceed the unambiguous speed"));
  EXPECT_TRUE(mentions(fast, core::Severity::warning, "29.98 m/s"));
  EXPECT_FALSE(mentions(diagnose_search(plan_of(noisy_scene(29.0)), train_of(64)), core::Severity::warning, "faster"));
  EXPECT_FALSE(mentions(diagnose_search(plan_of(noisy_scene(40.0)), train_of(1)), core::Severity::warning, "faster"));
  EXPECT_TRUE(mentions(diagnose_search(plan_of(noisy_scene(-60.0)), train_of(64, 1)), core::Severity::warning,
                       "target 1 moves near a blind speed"));
  EXPECT_FALSE(mentions(diagnose_search(plan_of(noisy_scene(-60.0)), train_of(64)), core::Severity::warning, "blind"));
  EXPECT_FALSE(mentions(diagnose_search(plan_of(noisy_scene(0.0)), train_of(64, 1)), core::Severity::warning, "blind"));
}

TEST(RemarksOnSearch, SayWhenTargetsWalkThroughRangeCells) {
  EXPECT_TRUE(mentions(diagnose_search(plan_of(noisy_scene(-70.0)), train_of(1000)), core::Severity::warning,
                       "more than a cell of range"));
  EXPECT_FALSE(
      mentions(diagnose_search(plan_of(noisy_scene(-70.0)), train_of(500)), core::Severity::warning, "cell of range"));
}

// The check of the scene does, and of the echoes of other pulses.
TEST(RemarksOnSearch, LeaveAmbiguousRangesToTheCheckOfTheScene) {
  scene::Scene scene = noisy_scene(0.0);
  scene.simulations[0].range_end_m = 40e3;
  EXPECT_FALSE(mentions(diagnose_search(plan_of(scene), train_of(64)), core::Severity::warning, "unambiguous"));
}

TEST(RemarksOnSearch, SayWhenTheBeamTurnsTooFarInAnInterval) {
  scene::Scene scene = noisy_scene(0.0);
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  scene.radars[0].transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
  scene.radars[0].beam = scene::Radar::Beam::rotating;
  scene.radars[0].beam_rate = core::Angle::from_deg(360.0);
  const simulate::Acquisition acquisition = plan_of(scene);
  EXPECT_NEAR(beam_width_rad(acquisition), 2.0 * core::pi / 180.0, 1e-12);
  // 2 degrees take 22.2 pulses.
  EXPECT_EQ(dwell_pulses(acquisition), 11u);
  EXPECT_TRUE(
      mentions(diagnose_search(acquisition, train_of(23)), core::Severity::warning, "intervals of at most 22 pulses"));
  EXPECT_FALSE(mentions(diagnose_search(acquisition, train_of(22)), core::Severity::warning, "beam turns"));
  EXPECT_EQ(dwell_pulses(plan_of(noisy_scene(0.0))), 1u);
}

TEST(RemarksOnSearch, SayWhichPartOfATurnNoIntervalSees) {
  scene::Scene scene = noisy_scene(0.0);
  scene.radars[0].beam = scene::Radar::Beam::rotating;
  // 0.25 degrees a pulse: 1024 pulses are 256 degrees.
  scene.radars[0].beam_rate = core::Angle::from_deg(1000.0);
  const core::Problems remarks = diagnose_search(plan_of(scene), train_of(10));
  EXPECT_TRUE(
      mentions(remarks, core::Severity::note, "the last 4 of 1024 pulses do not fill an interval: 1 deg of the turn"));
  EXPECT_TRUE(mentions(remarks, core::Severity::note, "record 6 more"));
  EXPECT_FALSE(mentions(diagnose_search(plan_of(scene), train_of(8)), core::Severity::note, "do not fill an interval"));
  // Behind a canceller of order 2 102 intervals take 1022 pulses.
  EXPECT_TRUE(mentions(diagnose_search(plan_of(scene), train_of(10, 2)), core::Severity::note, "the last 2 of 1024"));
  // The turn ends in the 1021st pulse: 0.1 degrees of 360 are left, or of a longer one nothing.
  scene.radars[0].beam_rate = core::Angle::from_deg(4000.0 * 359.9 / 1020.0);
  EXPECT_TRUE(mentions(diagnose_search(plan_of(scene), train_of(10)), core::Severity::note, ": 0.1 deg of the turn"));
  scene.radars[0].beam_rate = core::Angle::from_deg(4000.0 * 360.1 / 1020.0);
  EXPECT_FALSE(
      mentions(diagnose_search(plan_of(scene), train_of(10)), core::Severity::note, "do not fill an interval"));
  scene.radars[0].beam = scene::Radar::Beam::fixed;
  EXPECT_FALSE(
      mentions(diagnose_search(plan_of(scene), train_of(10)), core::Severity::note, "do not fill an interval"));
}

TEST(RemarksOnSearch, SayWhenASearchingBeamDoesNotTurn) {
  scene::Scene scene = noisy_scene(0.0);
  EXPECT_FALSE(beam_turns(plan_of(scene)));
  EXPECT_TRUE(
      mentions(diagnose_search(plan_of(scene), train_of(1)), core::Severity::warning, "the beam does not rotate"));
  EXPECT_FALSE(mentions(diagnose_search(plan_of(scene), train_of(64)), core::Severity::warning, "does not rotate"));
  scene.radars[0].beam = scene::Radar::Beam::rotating;
  EXPECT_FALSE(beam_turns(plan_of(scene)));
  scene.radars[0].beam_rate = core::Angle::from_deg(360.0);
  EXPECT_TRUE(beam_turns(plan_of(scene)));
  EXPECT_FALSE(mentions(diagnose_search(plan_of(scene), train_of(1)), core::Severity::warning, "does not rotate"));
}

// What turns a beam does not matter.
TEST(RemarksOnSearch, KnowThatAPlatformTurnsABeam) {
  scene::Scene scene = noisy_scene(0.0);
  scene.platforms[0].rotation_rate[2] = core::Angle::from_deg(90.0);
  EXPECT_TRUE(beam_turns(plan_of(scene)));
}

TEST(ProblemsOfSearch, AreGuardsLargerThanTheMap) {
  const simulate::Acquisition acquisition = plan_of(noisy_scene(0.0));
  SearchOptions options = train_of(64);
  options.cfar.reference_columns = options.cfar.guard_columns = 1000;
  options.cfar.reference_rows = 2000;
  options.cfar.guard_rows = 1000;
  EXPECT_TRUE(mentions(problems_of_search(acquisition, options), core::Severity::error, "no reference cells are left"));
  options.cfar.guard_rows = 62;
  EXPECT_TRUE(problems_of_search(acquisition, options).empty());
}

TEST(RemarksOnSearch, SayWhatTheDetectorCannotTrust) {
  const simulate::Acquisition silent = plan_of(pulse_scene(0.0));
  EXPECT_TRUE(mentions(diagnose_search(silent, train_of(64)), core::Severity::warning, "no noise"));
  SearchOptions options = train_of(64, 1);
  options.cfar.reference_rows = 2;
  EXPECT_TRUE(mentions(diagnose_search(silent, options), core::Severity::warning, "differs from one Doppler row"));
  options.detect = false;
  EXPECT_FALSE(mentions(diagnose_search(silent, options), core::Severity::warning, "noise"));
  scene::Scene fine = noisy_scene(0.0);
  fine.simulations[0].sample_rate_hz = 50e6;
  EXPECT_TRUE(mentions(diagnose_search(plan_of(fine), train_of(64)), core::Severity::warning, "a target masks itself"));
}

TEST(RemarksOnSearch, SayWhichEchoesTheEndOfARawRecordingCuts) {
  // A pulse of 1499 m in a window of 1700 m: echoes from 4901 m on are cut.
  scene::Scene scene = noisy_scene(0.0);
  scene.simulations[0].range_end_m = 6400.0;
  EXPECT_TRUE(mentions(diagnose_search(simulate::acquisition_of(scene, 0), train_of(64)), core::Severity::warning,
                       "1 of 1 targets are within a pulse length of the end"));
  EXPECT_FALSE(mentions(diagnose_search(plan_of(scene), train_of(64)), core::Severity::warning, "of the end"));
  scene.simulations[0].range_end_m = 6600.0;
  EXPECT_FALSE(mentions(diagnose_search(simulate::acquisition_of(scene, 0), train_of(64)), core::Severity::warning,
                        "of the end"));
}

}  // namespace search_checks_test
}  // namespace sarsim::workflow
