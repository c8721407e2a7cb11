#include "simulate/resolve/resolved.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

ResolvedRadar resolved_radar(const Radar& radar, Profile profile = Profile::physical) {
  Scene scene = one_target_scene();
  scene.options.profile = profile;
  scene.radars[0] = radar;
  return resolve_radar(scene, resolve(scene), 0);
}

TEST(Conventions, OfTheClassicProfileDifferFromThePhysicalOnesInEveryDecidedMatter) {
  const Conventions physical = conventions_of(Profile::physical), classic = conventions_of(Profile::classic);
  EXPECT_EQ(physical.light_speed_mps, 299'792'458.0);
  EXPECT_EQ(classic.light_speed_mps, 299'792'500.0);
  EXPECT_EQ(physical.boltzmann_j_per_k, 1.380649e-23);
  EXPECT_EQ(classic.boltzmann_j_per_k, 1.38e-23);
  EXPECT_EQ(physical.pattern, PatternRule::amplitude);
  EXPECT_EQ(classic.pattern, PatternRule::power);
  EXPECT_EQ(physical.pointing, PointingRule::boresight);
  EXPECT_EQ(classic.pointing, PointingRule::added_angles);
  EXPECT_EQ(physical.low_pass, LowPassRule::first_knot);
  EXPECT_EQ(classic.low_pass, LowPassRule::origin);
  EXPECT_EQ(physical.spacing, Conventions::SampleSpacing::sampling_rate);
  EXPECT_EQ(classic.spacing, Conventions::SampleSpacing::window_fraction);
  EXPECT_EQ(physical.compression, Conventions::Compression::keeps_peak);
  EXPECT_EQ(classic.compression, Conventions::Compression::pulse_energy);
  EXPECT_EQ(physical.noise, Conventions::Noise::per_sample);
  EXPECT_EQ(classic.noise, Conventions::Noise::per_bandwidth);
  EXPECT_EQ(physical.stc, Conventions::Stc::receiver_gain);
  EXPECT_EQ(classic.stc, Conventions::Stc::no_spreading);
}

TEST(Resolve, FindsPlatformsByNameAndTheWorldWithoutADefinition) {
  Scene scene = one_target_scene();
  scene.platforms = {resting("Hill", {1, 2, 3}), resting("Plane", {4, 5, 6})};
  scene.targets = {target_on("plane", {}), target_on("Earth", {})};
  const ResolvedScene resolved = resolve(scene);
  EXPECT_EQ(resolved.platforms[resolved.scatterers[0].platform].name, "Plane");
  const ResolvedPlatform& world = resolved.platforms[resolved.scatterers[1].platform];
  EXPECT_EQ(world.name, "Earth");
  EXPECT_TRUE(world.track.fixed());
  EXPECT_EQ(world.track.at(7.0, 3).position_world_m, Vec3{});
  EXPECT_EQ(world.track.at(7.0, 3).world_from_platform, Mat3());
  scene.targets[0].platform = "Submarine";
  EXPECT_THROW((void)resolve(scene), std::invalid_argument);
}

TEST(Resolve, FindsPlatformsAsFindPlatformDoes) {
  Scene scene;
  for (const char* name : {"Plane 1", "Plane 2", "PLANE 1", "Earthling", "Sub"})
    scene.platforms.push_back(resting(name, {}));
  for (const char* name : {"plane 1", "Plane 2", "Earthling", "Submarine", "S", "Plane", "nobody"}) {
    scene.targets = {target_on(name, {})};
    const std::size_t expected = find_platform(scene, name);
    if (expected == not_found)
      EXPECT_THROW(static_cast<void>(resolve(scene)), std::invalid_argument) << name;
    else
      EXPECT_EQ(resolve(scene).scatterers[0].platform, expected) << name;
  }
  // The world, which no platform "Earthling" stands for.
  scene.targets = {target_on("EARTH", {}), target_on("Sub", {}), target_on("Earth", {})};
  EXPECT_EQ(resolve(scene).scatterers[0].platform, scene.platforms.size());
  EXPECT_EQ(resolve(scene).scatterers[1].platform, 4u);
  EXPECT_EQ(resolve(scene).scatterers[2].platform, scene.platforms.size());
}

TEST(Resolve, TurnsDegreesIntoRadiansEverywhere) {
  Scene scene = one_target_scene();
  Platform& p = scene.platforms[0];
  p.rotation_kind = Platform::Rotation::user;
  p.rotation_deg.part[2] = lines({{0.0, 0.0}, {1.0, 90.0}});
  p.rotation_rate[0] = Angle::from_deg(180.0);
  const Pose pose = resolve(scene).platforms[0].track.at(1.0, 0);
  EXPECT_NEAR(pose.rotation_rad[2], pi / 2, 2.0 * epsilon);
  EXPECT_NEAR(pose.rotation_rate_rad_per_s[2], pi / 2, 2.0 * epsilon);
  EXPECT_NEAR(pose.rotation_rad[0], pi, 2.0 * epsilon);
}

TEST(Resolve, TakesEnvelopesOnlyWhereTheyAreChosen) {
  Scene scene = one_target_scene();
  Platform& p = scene.platforms[0];
  p.position_stddev_m = {1, 1, 1};
  p.position_envelope.part[0] = lines({{0, 1}, {1, 1}});
  EXPECT_NE(resolve(scene).platforms[0].track.at(0.0, 0).position_world_m.y, 0.0);
  p.position_error = Platform::MotionError::envelope;
  const Pose pose = resolve(scene).platforms[0].track.at(0.0, 0);
  EXPECT_NE(pose.position_world_m.x, 0.0);
  EXPECT_EQ(pose.position_world_m.y, 0.0);
  p.rotation_error = Platform::MotionError::envelope;
  p.rotation_stddev[1] = Angle::from_deg(5.0);
  p.rotation_envelope.part[0] = lines({{0, 2}, {1, 2}});
  Motion radians;  // the same platform, described in rad/sqrt(s)
  radians.rotation_envelope[0] = Interpolator(lines({{0, 2 * pi / 180}, {1, 2 * pi / 180}}));
  const double expected = Track(radians, scene.options.seed, p.name).at(0.3, 0).rotation_rad[0];
  ASSERT_NE(expected, 0.0);
  EXPECT_NEAR(resolve(scene).platforms[0].track.at(0.3, 0).rotation_rad[0], expected, 1e3 * epsilon);
  EXPECT_EQ(resolve(scene).platforms[0].track.at(0.3, 0).rotation_rad[1], 0.0);
}

TEST(Resolve, IgnoresTheAlignmentOfAPlatformThatRests) {
  Scene scene = one_target_scene();
  scene.platforms[0].aligned = true;
  EXPECT_EQ(resolve(scene).platforms[0].track.at(0.0, 0).world_from_platform, Mat3());
}

TEST(Resolve, MarksJitteredTargetsByAnyOfTheirDeviations) {
  Scene scene = one_target_scene();
  EXPECT_FALSE(resolve(scene).scatterers[0].jittered);
  scene.targets[0].rcs_stddev_m2 = 0.1;
  EXPECT_TRUE(resolve(scene).scatterers[0].jittered);
  scene.targets[0].rcs_stddev_m2 = 0.0;
  scene.targets[0].azimuth_stddev = Angle::from_deg(1.0);
  EXPECT_FALSE(resolve(scene).scatterers[0].jittered);  // isotropic: no normal to move
  scene.targets[0].reflectivity = Target::Reflectivity::directional;
  EXPECT_TRUE(resolve(scene).scatterers[0].jittered);
}

TEST(ResolveRadar, RadiatesPowerTimesGainsOverLosses) {
  Radar radar;
  radar.power_w = 200.0;
  radar.transmit_gain = PowerRatio::from_db(20.0);
  radar.receive_gain = PowerRatio::from_db(10.0);
  radar.losses = PowerRatio::from_db(3.0);
  EXPECT_NEAR(resolved_radar(radar).radiated_w, 200.0 * 1000.0 / std::pow(10.0, 0.3), 1e5 * 8.0 * epsilon);
}

TEST(ResolveRadar, TakesBeamwidthsOfItsOwnCutsAndTheReceiveAntennaOnlyWhereItDiffers) {
  Radar radar;
  radar.transmit_antenna.pattern = Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = Angle::from_deg(1.0);
  radar.transmit_antenna.elevation_beamwidth = Angle::from_deg(30.0);
  radar.receive_antenna.pattern = Antenna::Pattern::isotropic;
  ResolvedRadar r = resolved_radar(radar);
  EXPECT_NEAR(r.transmit.azimuth_beamwidth_rad, pi / 180.0, epsilon);
  EXPECT_NEAR(r.transmit.elevation_beamwidth_rad, pi / 6.0, epsilon);
  EXPECT_EQ(r.receive.kind, AntennaPattern::Kind::sinx);
  radar.same_antenna = false;
  EXPECT_EQ(resolved_radar(radar).receive.kind, AntennaPattern::Kind::isotropic);
  radar.receive_antenna.pattern = Antenna::Pattern::user;
  radar.receive_antenna.gain_db.part = {lines({{0, -1}}), lines({{0, -2}})};
  r = resolved_radar(radar);
  EXPECT_EQ(r.receive.azimuth_gain_db.value(0), -1.0);
  EXPECT_EQ(r.receive.elevation_gain_db.value(0), -2.0);
}

TEST(ResolveRadar, MakesEveryKindOfPulse) {
  Radar radar;
  radar.pulse = Radar::Pulse::chirp;
  radar.bandwidth_hz = -3e6;
  radar.pulse_width_s = 7e-6;
  EXPECT_EQ(resolved_radar(radar).pulse.sweep_rate_hz_per_s(), -3e6 / 7e-6);
  radar.pulse = Radar::Pulse::mono;
  EXPECT_EQ(resolved_radar(radar).pulse.sweep_rate_hz_per_s(), 0.0);
  radar.pulse = Radar::Pulse::barker;
  radar.barker_code = 2;
  EXPECT_EQ(resolved_radar(radar).pulse.code, (std::vector<int>{1, 1, -1, 1}));
  radar.pulse = Radar::Pulse::user;
  radar.pulse_iq.part = {lines({{0, 2}}), lines({{0, -3}})};
  EXPECT_EQ(resolved_radar(radar).pulse.value(1e-6), (std::complex(2.0, -3.0)));
  radar.envelope = Radar::Envelope::linear;
  radar.rise_s = 2e-6;
  EXPECT_EQ(resolved_radar(radar).pulse.envelope_value(1e-6), 0.5);
  radar.envelope = Radar::Envelope::user;
  radar.envelope_gain.part[0] = lines({{0, 0}, {1, 7}});
  EXPECT_NEAR(resolved_radar(radar).pulse.envelope_value(1e-6), 1.0, 4.0 * epsilon);
}

TEST(ResolveRadar, MakesEveryKindOfWindow) {
  Radar radar;
  EXPECT_EQ(resolved_radar(radar).window(0.1), 1.0);
  radar.window = Radar::Window::hanning;
  radar.hanning_pedestal = 0.2;
  EXPECT_NEAR(resolved_radar(radar).window(0.0), 0.2, epsilon);
  radar.window = Radar::Window::bartlett;
  EXPECT_EQ(resolved_radar(radar).window(0.25), 0.5);
  radar.window = Radar::Window::hamming;
  EXPECT_NEAR(resolved_radar(radar).window(0.0), 0.08, epsilon);
  radar.window = Radar::Window::user;
  radar.window_gain.part[0] = lines({{0, 1}, {1, 3}});
  EXPECT_EQ(resolved_radar(radar).window(0.5), 2.0);
}

TEST(ResolveRadar, MakesSchedulesFromTheOrdinatesOfTheirFunctions) {
  Radar radar;
  radar.repetition = Radar::Repetition::user;
  radar.pri_s.part[0] = lines({{0, 1e-3}, {9, 2e-3}});
  radar.carrier = Radar::Carrier::user;
  radar.carrier_list_hz.part[0] = lines({{0, 1e9}, {5, 3e9}});
  const ResolvedRadar r = resolved_radar(radar);
  EXPECT_NEAR(r.repetition.send_time_s(3), 4e-3, 1e-3 * 8.0 * epsilon);
  EXPECT_EQ(r.carrier.carrier_hz(3), 3e9);
  radar.carrier = Radar::Carrier::stepped;
  radar.carrier_hz = 2e9;
  radar.carrier_step_hz = 1e6;
  radar.carrier_steps = 4;
  radar.pulses_per_step = 2;
  EXPECT_EQ(resolved_radar(radar).carrier.carrier_hz(7), 2.003e9);
}

TEST(ResolveRadar, MakesEveryKindOfBeam) {
  Radar radar;
  radar.beam_azimuth = Angle::from_deg(90.0);
  radar.beam_elevation = Angle::from_deg(45.0);
  radar.beam_rate = Angle::from_deg(180.0);
  radar.spot_world_m = {1, 2, 3};
  radar.beam_target_world_m.part = {lines({{0, 7}}), lines({{0, 8}}), lines({{0, 9}})};
  const Beam beam = resolved_radar(radar).beam;
  EXPECT_NEAR(beam.azimuth_rad, pi / 2, epsilon);
  EXPECT_NEAR(beam.elevation_rad, pi / 4, epsilon);
  EXPECT_NEAR(beam.rate_rad_per_s, pi, epsilon);
  EXPECT_EQ(beam.spot_world_m, (Vec3{1, 2, 3}));
  EXPECT_EQ(beam.kind, Beam::Kind::fixed);
  radar.beam = Radar::Beam::user;
  EXPECT_EQ(resolved_radar(radar).beam.target_world_m[2].value(0), 9.0);
}

TEST(ResolveRadar, InterpolatesLowPassFunctionsByTheRuleOfTheProfile) {
  Radar radar;
  radar.window = Radar::Window::user;
  radar.window_gain.part[0] = {Interpolation::low_pass, {{0.0, 1.0}, {0.5, 1.0}, {1.0, 1.0}}};
  EXPECT_NEAR(resolved_radar(radar).window(0.25), 1.0, 10.0 * epsilon);
  EXPECT_GT(std::abs(resolved_radar(radar, Profile::classic).window(0.25) - 1.0), 0.05);
}

}  // namespace
}  // namespace sarsim
