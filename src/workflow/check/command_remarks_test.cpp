#include "workflow/check/command_remarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/maths/constants.hpp"
#include "workflow/focus/sar_test_scene.hpp"
#include "workflow/search/search_test_scene.hpp"
#include "workflow/stepped/stepped_test_scene.hpp"

namespace sarsim::workflow {
namespace command_remarks_test {

using ::testing::HasSubstr;
using ::testing::Not;

std::string said(const scene::Scene& scene) {
  const auto resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(scene));
  std::string text;
  for (const core::Problem& problem : diagnose_commands(scene, resolved, {2, nullptr}))
    text += core::to_string(problem) + "\n";
  return text;
}

// 10 GHz, 4 kHz: speeds are told apart up to 29.98 m/s.
scene::Scene noisy(double speed_mps) {
  scene::Scene scene = pulse_scene(speed_mps);
  scene.radars[0].noise_temperature_k = 290.0;
  return scene;
}

// The beam of 2 degrees turns once a second, over a target that rests or flies.
scene::Scene sweeping(double speed_mps) {
  scene::Scene scene = noisy(speed_mps);
  scene.simulations[0].time_end_s = (1023 - 0.5) / search_prf_hz;  // 93 intervals of 11 pulses
  scene::Radar& radar = scene.radars[0];
  radar.beam = scene::Radar::Beam::rotating;
  radar.beam_rate = core::Angle::from_deg(360.0);
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(20.0);
  return scene;
}

scene::Scene stepped(double speed_mps) {
  scene::Scene scene = stepped_scene();
  scene.platforms.push_back(simulate::moving("Plane", {0.0, 3000.0, 0.0}, {0.0, speed_mps, 0.0}));
  scene.targets.push_back(simulate::target_on("Plane", {}));
  scene.targets.push_back(simulate::target_on("Plane", {3.0, 3.0, 0.0}));
  return scene;
}

TEST(RemarksOfCommands, AreNoneForSoundScenes) {
  EXPECT_EQ(said(noisy(10.0)), "");
  EXPECT_EQ(said(sweeping(10.0)), "");
  EXPECT_EQ(said(sar_scene(600.0, {{}})), "");
  EXPECT_EQ(said(simulate::one_target_scene()), "");
}

TEST(RemarksOfCommands, NameDopplerWhereTargetsMoveBeforeANoisyRadarThatRests) {
  EXPECT_THAT(said(noisy(40.0)), HasSubstr("warning: sarsim doppler: 1 of 1 targets exceed the unambiguous speed"));
  EXPECT_EQ(said(pulse_scene(40.0)), "") << "nobody detects without noise";
  // 64 pulses of 4 kHz and a cell of 15 m.
  scene::Scene fast = noisy(29.0);
  fast.radars[0].bandwidth_hz = 500e6;
  fast.simulations[0].sample_rate_hz = 600e6;
  EXPECT_THAT(said(fast), HasSubstr("sarsim doppler: targets migrate through more than a cell of range"));
}

TEST(RemarksOfCommands, NameSearchWhereTheBeamTurns) {
  const std::string text = said(sweeping(40.0));
  EXPECT_THAT(text, HasSubstr("note: sarsim search: 1 of 1 targets exceed the unambiguous speed"));
  EXPECT_THAT(text, Not(HasSubstr("doppler")));
  scene::Scene silent = sweeping(40.0);
  silent.radars[0].noise_temperature_k = 0.0;
  EXPECT_EQ(said(silent), "");
}

TEST(RemarksOfCommands, NameProfilesAndIsarWhereTheCarrierSteps) {
  const std::string text = said(stepped(100.0));
  EXPECT_THAT(text, HasSubstr("warning: sarsim profiles: targets move during a burst"));
  EXPECT_THAT(text, HasSubstr("note: sarsim profiles: pulses of incomplete bursts at the ends are left out"));
  // Flown straight away, the target does not turn: isar refuses that, and is not asked.
  EXPECT_THAT(text, Not(HasSubstr("isar")));
}

TEST(RemarksOfCommands, SayOnceWhatTwoCommandsSay) {
  scene::Scene scene = stepped(0.0);
  scene.platforms.back().rotation_rate[2] = core::Angle::from_deg(20.0);
  const std::string text = said(scene);
  EXPECT_THAT(text, HasSubstr("note: sarsim profiles and isar: pulses of incomplete bursts at the ends are left out"));
  EXPECT_EQ(text.find("incomplete bursts"), text.rfind("incomplete bursts"));
}

TEST(RemarksOfCommands, NameIsarWhereTheTargetTurnsTooFar) {
  scene::Scene scene = stepped(0.0);
  scene.platforms.back().rotation_rate[2] = core::Angle::from_deg(900.0);
  EXPECT_THAT(said(scene), HasSubstr("warning: sarsim isar: the target rotates so far"));
}

TEST(RemarksOfCommands, NameFocusWhereTheRadarFliesPastTargetsThatRest) {
  const std::string ghosts = said(sar_scene(300.0, {{0.0, 150.0, 0.0}, {}, {0.0, -150.0, 0.0}}));
  EXPECT_THAT(ghosts, HasSubstr("sarsim focus: echoes of "));
  EXPECT_THAT(ghosts, HasSubstr("they cause smeared azimuth ambiguities"));
  scene::Scene movers = sar_scene(600.0, {{}});
  movers.platforms.push_back(simulate::moving("Car", {}, {5.0, 0.0, 0.0}));
  movers.targets.push_back(simulate::target_on("Car", {}));
  EXPECT_THAT(said(movers), HasSubstr("note: sarsim focus: 1 of 2 targets (2) move or turn with their platform"));
}

TEST(RemarksOfCommands, SayThatOnlyBackProjectionFocusesAFlightAroundTheScene) {
  scene::Scene scene = sar_scene(600.0, {{}});
  std::vector<core::Knot> x, y;
  for (double t = -1.1; t < 1.1; t += 0.005) {
    x.push_back({t, 200.0 * std::cos(core::pi * t)});
    y.push_back({t, 200.0 * std::sin(core::pi * t)});
  }
  scene.platforms[1].trajectory_m.part = {simulate::lines(x), simulate::lines(y), simulate::lines({{0.0, 100.0}})};
  scene.simulations[0].range_start_m = 150.0;
  scene.simulations[0].range_end_m = 400.0;
  EXPECT_THAT(said(scene), HasSubstr("sarsim focus: back-projection instead of omega-k: the antenna flies around"));
}

// Of 1200 pulses and 834 targets nothing is said.
TEST(RemarksOfCommands, DoNotLookAtMoreThanAMillionEchoesForFocus) {
  scene::Scene scene = sar_scene(600.0, {{}});
  scene.platforms.push_back(simulate::moving("Car", {}, {5.0, 0.0, 0.0}));
  for (int i = 0; i < 832; ++i) scene.targets.push_back(simulate::target_on("Car", {}));
  ASSERT_EQ(simulate::acquisition_of(scene, 0).timing.pulses.count(), 1200);
  EXPECT_THAT(said(scene), HasSubstr("sarsim focus: 832 of 833 targets"));
  scene.targets.push_back(scene.targets.back());
  EXPECT_EQ(said(scene), "");
}

// Intervals of 1/600 s and 1.3/600 s in turn: methods in the frequency domain need even ones.
TEST(RemarksOfCommands, SayThatOnlyBackProjectionFocusesUnevenPulses) {
  scene::Scene scene = sar_scene(600.0, {{}});
  ASSERT_EQ(said(scene), "");
  scene.radars[0].repetition = scene::Radar::Repetition::user;
  scene.radars[0].pri_s.part[0] = {core::Interpolation::linear, {{0.0, 1.0 / 600.0}, {1.0, 1.3 / 600.0}}};
  EXPECT_THAT(
      said(scene),
      HasSubstr("note: sarsim focus: back-projection instead of omega-k: the along-track pulse spacing changes"));
}

TEST(RemarksOfCommands, AskEachCommandOnceForARadar) {
  scene::Scene scene = noisy(40.0);
  scene.simulations.push_back(scene.simulations[0]);
  const std::string once = said(scene);
  EXPECT_EQ(once.find("exceed the unambiguous"), once.rfind("exceed the unambiguous"));
}

TEST(RemarksOfCommands, StandAtTheirSimulation) {
  scene::Scene scene = noisy(40.0);
  const auto resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(scene));
  const core::Problems problems = diagnose_commands(scene, resolved);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].subject, (core::Subject{"simulation", 0, ""}));
}

}  // namespace command_remarks_test
}  // namespace sarsim::workflow
