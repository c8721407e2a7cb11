#include "simulate/survey/limit_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace limit_rules_test {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double c = core::exact_light_speed_mps;

core::Problems limits_of(const scene::Scene& scene) {
  const Acquisition acquisition = acquisition_of(scene, 0);
  core::Problems problems;
  check_limits(acquisition, survey_echoes(acquisition), 0, "", problems);
  return problems;
}

auto says(const std::string& words) { return Field(&core::Problem::message, HasSubstr(words)); }

// An aircraft 3 km high that flies along y at 100 m/s past targets 4 km to its right, L band, 64 pulses in a second.
scene::Scene side_scene() {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Plane", {0.0, 0.0, 3000.0}, {0.0, 100.0, 0.0}));
  scene.targets = {target_on("Earth", {4000.0, 0.0, 0.0})};
  scene::Radar& radar = scene.radars[0];
  radar.platform = "Plane";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 30e6;
  radar.pulse_width_s = 1e-6;
  radar.carrier_hz = 1.3e9;
  radar.prf_hz = 64.0;
  scene::Simulation& recorded = scene.simulations[0];
  recorded.range_start_m = 4000.0;
  recorded.range_end_m = 6000.0;
  recorded.time_start_s = -0.5;
  recorded.time_end_s = 0.5;
  recorded.sample_rate_hz = 40e6;
  return scene;
}

TEST(LimitRules, AreSilentOverASoundFlight) { EXPECT_THAT(limits_of(side_scene()), IsEmpty()); }

// Doppler d of a target at speed v: 2 v f/c beyond half of what the sampling rate exceeds the band by.
TEST(LimitRules, ReportDopplerBeyondTheSampledBand) {
  std::mt19937 random(54);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int draw = 0; draw < 40; ++draw) {
    scene::Scene scene = one_target_scene();
    const double speed_mps = -7000.0 * share(random), bandwidth_hz = 1e5 * std::pow(10.0, 2.0 * share(random));
    const double rate_hz = bandwidth_hz * (1.0 + share(random));
    scene.platforms.push_back(moving("Fast", {50e3, 0.0, 0.0}, {speed_mps, 0.0, 0.0}));
    scene.targets = {target_on("Fast", {})};
    scene.radars[0].pulse = scene::Radar::Pulse::chirp;
    scene.radars[0].bandwidth_hz = bandwidth_hz;
    scene.radars[0].pulse_width_s = 20.0 / bandwidth_hz;
    scene.radars[0].carrier_hz = 10e9;
    scene.simulations[0].range_start_m = 48e3;
    scene.simulations[0].range_end_m = 90e3;
    scene.simulations[0].sample_rate_hz = rate_hz;
    const double doppler_hz = -2.0 * speed_mps * 10e9 / c;
    const double aliased = (doppler_hz - 0.5 * (rate_hz - bandwidth_hz)) / bandwidth_hz;
    if (std::abs(aliased - 0.05) < 1e-3) continue;
    const auto reported = Contains(AllOf(says("out of the sampled band"),
                                         says(std::to_string(std::lround(100.0 * std::min(aliased, 1.0))) + " %")));
    if (aliased > 0.05)
      EXPECT_THAT(limits_of(scene), reported) << doppler_hz << ' ' << rate_hz << ' ' << bandwidth_hz;
    else
      EXPECT_THAT(limits_of(scene), Not(Contains(says("out of the sampled band"))));
  }
}

TEST(LimitRules, ReportARadarBelowTheGround) {
  scene::Scene scene = side_scene();
  scene.platforms.back() = moving("Plane", {0.0, 0.0, -3000.0}, {0.0, 100.0, 0.0});
  const core::Problems problems = limits_of(scene);
  ASSERT_THAT(problems, Contains(says("below the ground")));
  EXPECT_THAT(problems[0].found, HasSubstr("-3000 m"));
  scene.targets.push_back(target_on("Earth", {4000.0, 100.0, -3100.0}));  // A frame with its origin elsewhere.
  EXPECT_THAT(limits_of(scene), Not(Contains(says("below the ground"))));
  for (const double height_m : {-100.0, -500.0}) {
    scene::Scene earth = one_target_scene();
    earth.world.frame = scene::World::Frame::earth;
    earth.world.latitude = core::Angle::from_deg(-34.0);
    earth.platforms.push_back(resting("Low", {0.0, 0.0, height_m}));
    earth.radars[0].platform = "Low";
    if (height_m < -120.0)
      EXPECT_THAT(limits_of(earth), Contains(says("below the ellipsoid")));
    else
      EXPECT_THAT(limits_of(earth), Not(Contains(says("below the ellipsoid"))));
  }
}

// 50 TECU at 1.257 GHz and 77 MHz: 40.3e16 x 50/f^2 = 12.75 m one way, 2 x 12.75 B/f = 1.56 m over the band, times the
// slant factor; a cell of 1.95 m.
TEST(LimitRules, ReportDispersionWithinTheBand) {
  scene::Scene scene = one_target_scene();
  scene.world.frame = scene::World::Frame::earth;
  scene.atmosphere.tec_units = 50.0;
  scene.platforms.push_back(resting("High", {0.0, 0.0, 700e3}));
  scene.radars[0].platform = "High";
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 77e6;
  scene.radars[0].carrier_hz = 1.257e9;
  scene.targets = {target_on("Earth", {0.0, 0.0, 0.0}, 1e6)};
  scene.simulations[0].range_start_m = 699.9e3;
  scene.simulations[0].range_end_m = 702e3;
  scene.simulations[0].sample_rate_hz = 90e6;
  const core::Problems problems = limits_of(scene);
  ASSERT_THAT(problems, Contains(says("dispersion")));
  EXPECT_THAT(problems[0].found, HasSubstr("1.56 m"));
  scene.radars[0].bandwidth_hz = 40e6;  // 0.81 m of 3.75 m
  EXPECT_THAT(limits_of(scene), Not(Contains(says("dispersion"))));
}

TEST(LimitRules, ReportRaysThatBend) {
  for (const double elevation_deg : {3.0, 5.0, 20.0, 40.0}) {
    scene::Scene scene = one_target_scene();
    scene.world.frame = scene::World::Frame::earth;
    scene.atmosphere.refraction = scene::Atmosphere::Refraction::exponential;
    const double elevation_rad = elevation_deg * core::rad_per_deg;
    const double range_m = 10e3 / std::sin(elevation_rad);  // To about 10 km of height.
    scene.targets = {target_on("Earth", {range_m * std::cos(elevation_rad), 0.0, 10e3}, 1e6)};
    scene.radars[0].carrier_hz = 5e9;
    scene.simulations[0].range_start_m = range_m - 500.0;
    scene.simulations[0].range_end_m = range_m + 1500.0;
    const core::Problems problems = limits_of(scene);
    if (elevation_deg < 10.0)  // 90 and 27 mm of 60 mm; 0.5 mm at 20 deg.
      EXPECT_THAT(problems, Contains(says("rays bend"))) << elevation_deg;
    else
      EXPECT_THAT(problems, Not(Contains(says("rays bend")))) << elevation_deg;
  }
}

TEST(LimitRules, ReportLeftAndRightOfATrack) {
  scene::Scene scene = side_scene();
  scene.targets.push_back(target_on("Earth", {-4100.0, 30.0, 0.0}));
  const core::Problems problems = limits_of(scene);
  ASSERT_THAT(problems, Contains(says("left and right are ambiguous")));
  EXPECT_THAT(problems[0].found, HasSubstr("1 target on the left and 1 on the right"));
  scene.targets.back().rcs_m2 = 1e-4;  // 40 dB below.
  EXPECT_THAT(limits_of(scene), IsEmpty());
  scene.targets.back().rcs_m2 = 1.0;
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  scene.radars[0].beam_azimuth = core::Angle::from_deg(90.0);
  EXPECT_THAT(limits_of(scene), Not(Contains(says("left and right"))));
}

// A beam lights both sides alike where it points down or forward; beside the track the weaker side fades.
TEST(LimitRules, ReportLeftAndRightOfBeamsThatLightBoth) {
  std::mt19937 random(15);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int draw = 0; draw < 20; ++draw) {
    scene::Scene scene = side_scene();
    const double across_m = 300.0 + 500.0 * share(random), ahead_m = 3000.0 * share(random);
    scene.targets = {target_on("Earth", {across_m, ahead_m, 0.0}), target_on("Earth", {-across_m, ahead_m, 0.0})};
    scene.simulations[0].range_start_m = 2900.0;
    scene::Radar& radar = scene.radars[0];
    radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
    radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(50.0);
    radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(50.0);
    radar.beam_elevation = core::Angle::from_rad(-std::atan2(3000.0, ahead_m));
    EXPECT_THAT(limits_of(scene), Contains(says("left and right are ambiguous"))) << across_m << ' ' << ahead_m;
    // The weaker side: one way within 20 dB of the other, or below.
    for (const double ratio_db : {-19.5, -20.5}) {
      scene.targets[1].rcs_m2 = std::pow(10.0, 0.1 * ratio_db);
      if (ratio_db > -20.0)
        EXPECT_THAT(limits_of(scene), Contains(says("left and right are ambiguous")));
      else
        EXPECT_THAT(limits_of(scene), Not(Contains(says("left and right are ambiguous"))));
    }
  }
}

TEST(LimitRules, ReportARadarThatIsBelowTheGroundForAPartOfTheFlight) {
  for (const double climb_mps : {100.0, -100.0})
    for (const double lowest_m : {-0.9, -1.1}) {
      scene::Scene scene = side_scene();
      scene.simulations[0].range_start_m = 3000.0;
      scene.platforms.back() =
          moving("Plane", {0.0, 0.0, lowest_m + 0.5 * std::abs(climb_mps)}, {0.0, 100.0, climb_mps});
      const core::Problems problems = limits_of(scene);
      if (lowest_m < -1.0)
        EXPECT_THAT(problems, Contains(says("below the ground"))) << climb_mps;
      else
        EXPECT_THAT(problems, Not(Contains(says("below the ground")))) << climb_mps;
    }
}

TEST(LimitRules, ReportTargetsThatAreNotResolved) {
  scene::Scene scene = side_scene();
  scene.targets.push_back(target_on("Earth", {4000.0, 0.0, 0.0}));
  EXPECT_THAT(limits_of(scene), ::testing::ElementsAre(says("targets 1 and 2 are at the same position")));
  scene.targets.back().position_m = {4001.0, 0.0, 0.0};
  EXPECT_THAT(limits_of(scene), ::testing::ElementsAre(says("targets 1 and 2 are unresolved")));
  scene.targets.back().position_m = {4010.0, 0.0, 0.0};  // 8 m of range, cells of 5 m
  EXPECT_THAT(limits_of(scene), IsEmpty());
  scene.targets.back().position_m = {4000.0, 9.0, 0.0};  // lambda R/(2 v T) = 5.8 m
  EXPECT_THAT(limits_of(scene), IsEmpty());
}

TEST(LimitRules, ReportTargetsOfTwoPlatformsAtOnePosition) {
  scene::Scene scene = side_scene();
  scene.platforms.push_back(resting("Mast", {4000.0, 0.0, 0.0}));
  scene.targets.push_back(target_on("Mast", {}));
  EXPECT_THAT(limits_of(scene), ::testing::ElementsAre(says("targets 1 and 2 are at the same position")));
  scene.targets.back().position_m = {1e-9, 0.0, 0.0};
  EXPECT_THAT(limits_of(scene), ::testing::ElementsAre(says("targets 1 and 2 are unresolved")));
  // One that passes the other while the middle pulse is sent.
  scene.platforms.back() = moving("Mast", {4000.0, 0.0, 0.0}, {30.0, 0.0, 0.0});
  scene.targets.back().position_m = {};
  EXPECT_THAT(limits_of(scene), Not(Contains(says("same position"))));
}

// 64 steps of 2.5 MHz and a pulse of 1 MHz resolve c/(2 x 158.5 MHz) = 0.946 m, not the 150 m of one pulse.
TEST(LimitRules, ResolveTargetsByAllCarriersTogether) {
  scene::Scene scene = side_scene();
  scene::Radar& radar = scene.radars[0];
  radar.platform = "Earth";
  radar.bandwidth_hz = 1e6;
  radar.pulse_width_s = 1e-6;
  radar.carrier = scene::Radar::Carrier::stepped;
  radar.carrier_step_hz = 2.5e6;
  radar.carrier_steps = 64;
  const double cell_m = 0.5 * c / (63.0 * 2.5e6 + 1e6);
  scene.targets = {target_on("Earth", {5000.0, 0.0, 0.0}), target_on("Earth", {5000.0 + 1.01 * cell_m, 0.0, 0.0})};
  EXPECT_THAT(limits_of(scene), Not(Contains(says("unresolved"))));
  scene.targets[1].position_m.x = 5000.0 + 0.99 * cell_m;
  EXPECT_THAT(limits_of(scene), Contains(says("targets 1 and 2 are unresolved")));
}

// lambda PRF/2 = 7.4 m/s at 1.3 GHz and 64 Hz.
TEST(LimitRules, ReportBlindSpeeds) {
  const double blind_mps = 0.5 * c / 1.3e9 * 64.0;
  for (const double speeds : {0.0, 0.4, 1.0, 1.5, 2.0, 2.5, 3.0}) {
    scene::Scene scene = side_scene();
    scene.radars[0].platform = "Earth";
    scene.platforms.push_back(moving("Car", {5000.0, 0.0, 0.0}, {-speeds * blind_mps, 0.0, 0.0}));
    scene.targets = {target_on("Car", {})};
    const bool blind = speeds >= 1.0 && speeds == std::floor(speeds);
    if (blind)
      EXPECT_THAT(limits_of(scene), Contains(says("blind speed"))) << speeds;
    else
      EXPECT_THAT(limits_of(scene), Not(Contains(says("blind speed")))) << speeds;
  }
}

}  // namespace limit_rules_test
}  // namespace sarsim::simulate
