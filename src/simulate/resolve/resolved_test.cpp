#include "simulate/resolve/resolved.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "signal/sar/sar_window.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace resolved_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Link resolved_radar(const scene::Radar& radar, scene::Profile profile = scene::Profile::physical) {
  scene::Scene scene = one_target_scene();
  scene.options.profile = profile;
  scene.radars[0] = radar;
  return resolve_radar(scene, resolve(scene), 0);
}

TEST(Conventions, OfTheClassicProfileDifferFromThePhysicalOnesInEveryDecidedMatter) {
  const Conventions physical = conventions_of(scene::Profile::physical),
                    classic = conventions_of(scene::Profile::classic);
  EXPECT_EQ(physical.light_speed_mps, 299'792'458.0);
  EXPECT_EQ(classic.light_speed_mps, 299'792'500.0);
  EXPECT_EQ(physical.boltzmann_j_per_k, 1.380649e-23);
  EXPECT_EQ(classic.boltzmann_j_per_k, 1.38e-23);
  EXPECT_EQ(physical.pattern, radar::PatternRule::amplitude);
  EXPECT_EQ(classic.pattern, radar::PatternRule::power);
  EXPECT_EQ(physical.pointing, radar::PointingRule::boresight);
  EXPECT_EQ(classic.pointing, radar::PointingRule::added_angles);
  EXPECT_EQ(physical.low_pass, core::LowPassRule::first_knot);
  EXPECT_EQ(classic.low_pass, core::LowPassRule::origin);
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
  scene::Scene scene = one_target_scene();
  scene.platforms = {resting("Hill", {1, 2, 3}), resting("Plane", {4, 5, 6})};
  scene.targets = {target_on("plane", {}), target_on("Earth", {})};
  const ResolvedScene resolved = resolve(scene);
  EXPECT_EQ(resolved.platforms[resolved.scatterers[0].platform].name, "Plane");
  const ResolvedPlatform& world = resolved.platforms[resolved.scatterers[1].platform];
  EXPECT_EQ(world.name, "Earth");
  EXPECT_TRUE(world.track.fixed());
  EXPECT_EQ(world.track.at(7.0, 3).position_world_m, core::Vec3{});
  EXPECT_EQ(world.track.at(7.0, 3).world_from_platform, core::Mat3());
  scene.targets[0].platform = "Submarine";
  EXPECT_THROW((void)resolve(scene), std::invalid_argument);
}

TEST(Resolve, FindsPlatformsAsFindPlatformDoes) {
  scene::Scene scene;
  for (const char* name : {"Plane 1", "Plane 2", "PLANE 1", "Earthling", "Sub"})
    scene.platforms.push_back(resting(name, {}));
  for (const char* name : {"plane 1", "Plane 2", "Earthling", "Submarine", "S", "Plane", "nobody"}) {
    scene.targets = {target_on(name, {})};
    const std::size_t expected = scene::find_platform(scene, name);
    if (expected == scene::not_found)
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
  scene::Scene scene = one_target_scene();
  scene::Platform& p = scene.platforms[0];
  p.rotation_kind = scene::Platform::Rotation::user;
  p.rotation_deg.part[2] = lines({{0.0, 0.0}, {1.0, 90.0}});
  p.rotation_rate[0] = core::Angle::from_deg(180.0);
  const radar::Pose pose = resolve(scene).platforms[0].track.at(1.0, 0);
  EXPECT_NEAR(pose.rotation_rad[2], core::pi / 2, 2.0 * epsilon);
  EXPECT_NEAR(pose.rotation_rate_rad_per_s[2], core::pi / 2, 2.0 * epsilon);
  EXPECT_NEAR(pose.rotation_rad[0], core::pi, 2.0 * epsilon);
}

TEST(Resolve, TakesEnvelopesOnlyWhereTheyAreChosen) {
  scene::Scene scene = one_target_scene();
  scene::Platform& p = scene.platforms[0];
  p.position_stddev_m = {1, 1, 1};
  p.position_envelope.part[0] = lines({{0, 1}, {1, 1}});
  EXPECT_NE(resolve(scene).platforms[0].track.at(0.0, 0).position_world_m.y, 0.0);
  p.position_error = scene::Platform::MotionError::envelope;
  const radar::Pose pose = resolve(scene).platforms[0].track.at(0.0, 0);
  EXPECT_NE(pose.position_world_m.x, 0.0);
  EXPECT_EQ(pose.position_world_m.y, 0.0);
  p.rotation_error = scene::Platform::MotionError::envelope;
  p.rotation_stddev[1] = core::Angle::from_deg(5.0);
  p.rotation_envelope.part[0] = lines({{0, 2}, {1, 2}});
  radar::Motion radians;  // the same platform, described in rad/sqrt(s)
  radians.rotation_envelope[0] = core::Interpolator(lines({{0, 2 * core::pi / 180}, {1, 2 * core::pi / 180}}));
  const double expected = radar::Track(radians, scene.options.seed, p.name).at(0.3, 0).rotation_rad[0];
  ASSERT_NE(expected, 0.0);
  EXPECT_NEAR(resolve(scene).platforms[0].track.at(0.3, 0).rotation_rad[0], expected, 1e3 * epsilon);
  EXPECT_EQ(resolve(scene).platforms[0].track.at(0.3, 0).rotation_rad[1], 0.0);
}

TEST(Resolve, IgnoresTheAlignmentOfAPlatformThatRests) {
  scene::Scene scene = one_target_scene();
  scene.platforms[0].aligned = true;
  EXPECT_EQ(resolve(scene).platforms[0].track.at(0.0, 0).world_from_platform, core::Mat3());
}

TEST(Resolve, MarksJitteredTargetsByAnyOfTheirDeviations) {
  scene::Scene scene = one_target_scene();
  EXPECT_FALSE(resolve(scene).scatterers[0].jittered);
  scene.targets[0].traits.edit().rcs_stddev_m2 = 0.1;
  EXPECT_TRUE(resolve(scene).scatterers[0].jittered);
  scene.targets[0].traits.edit().rcs_stddev_m2 = 0.0;
  scene.targets[0].traits.edit().azimuth_stddev = core::Angle::from_deg(1.0);
  EXPECT_FALSE(resolve(scene).scatterers[0].jittered);  // isotropic: no normal to move
  scene.targets[0].traits.edit().reflectivity = scene::Target::Reflectivity::directional;
  EXPECT_TRUE(resolve(scene).scatterers[0].jittered);
}

TEST(Resolve, MakesOneCurveForTargetsThatShareTheirTraits) {
  scene::Scene scene = one_target_scene();
  scene::TargetTraits& traits = scene.targets[0].traits.edit();
  traits.reflectivity = scene::Target::Reflectivity::directional;
  traits.gain = scene::Target::Gain::user;
  traits.gain_db.part[0] = lines({{0.0, 0.0}, {90.0, -20.0}});
  scene.targets.resize(3, scene.targets[0]);
  EXPECT_EQ(resolve(scene).gain_curves.size(), 1U);
  scene.targets[1].traits.edit().gain_db.part[0] = lines({{0.0, 0.0}, {90.0, -30.0}});
  const ResolvedScene resolved = resolve(scene);
  EXPECT_EQ(resolved.gain_curves.size(), 3U);
  const auto at_90_db = [&](std::size_t i) {
    return resolved.gain_curves[resolved.scatterers[i].gain_curve].value(90.0);
  };
  EXPECT_EQ(at_90_db(0), -20.0);
  EXPECT_EQ(at_90_db(1), -30.0);
  EXPECT_EQ(at_90_db(2), -20.0);
}

TEST(ResolveRadar, RadiatesPowerTimesGainsOverLosses) {
  scene::Radar radar;
  radar.power_w = 200.0;
  radar.transmit_gain = core::PowerRatio::from_db(20.0);
  radar.receive_gain = core::PowerRatio::from_db(10.0);
  radar.losses = core::PowerRatio::from_db(3.0);
  EXPECT_NEAR(resolved_radar(radar).radiated_w, 200.0 * 1000.0 / std::pow(10.0, 0.3), 1e5 * 8.0 * epsilon);
}

TEST(ResolveRadar, TakesBeamwidthsOfItsOwnCutsAndTheReceiveAntennaOnlyWhereItDiffers) {
  scene::Radar radar;
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(1.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(30.0);
  radar.receive_antenna.pattern = scene::Antenna::Pattern::isotropic;
  Link r = resolved_radar(radar);
  EXPECT_NEAR(r.transmit.azimuth_beamwidth_rad, core::pi / 180.0, epsilon);
  EXPECT_NEAR(r.transmit.elevation_beamwidth_rad, core::pi / 6.0, epsilon);
  EXPECT_EQ(r.receive.kind, radar::AntennaPattern::Kind::sinx);
  radar.same_antenna = false;
  EXPECT_EQ(resolved_radar(radar).receive.kind, radar::AntennaPattern::Kind::isotropic);
  radar.receive_antenna.pattern = scene::Antenna::Pattern::user;
  radar.receive_antenna.gain_db.part = {lines({{0, -1}}), lines({{0, -2}})};
  r = resolved_radar(radar);
  EXPECT_EQ(r.receive.azimuth_gain_db.value(0), -1.0);
  EXPECT_EQ(r.receive.elevation_gain_db.value(0), -2.0);
}

TEST(ResolveRadar, MakesEveryKindOfPulse) {
  scene::Radar radar;
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = -3e6;
  radar.pulse_width_s = 7e-6;
  EXPECT_EQ(resolved_radar(radar).pulse.sweep_rate_hz_per_s(), -3e6 / 7e-6);
  radar.pulse = scene::Radar::Pulse::mono;
  EXPECT_EQ(resolved_radar(radar).pulse.sweep_rate_hz_per_s(), 0.0);
  radar.pulse = scene::Radar::Pulse::barker;
  radar.barker_code = 2;
  EXPECT_EQ(resolved_radar(radar).pulse.code, (std::vector<int>{1, 1, -1, 1}));
  radar.pulse = scene::Radar::Pulse::user;
  radar.pulse_iq.part = {lines({{0, 2}}), lines({{0, -3}})};
  EXPECT_EQ(resolved_radar(radar).pulse.value(1e-6), (std::complex(2.0, -3.0)));
  radar.envelope = scene::Radar::Envelope::linear;
  radar.rise_s = 2e-6;
  EXPECT_EQ(resolved_radar(radar).pulse.envelope_value(1e-6), 0.5);
  radar.envelope = scene::Radar::Envelope::user;
  radar.envelope_gain.part[0] = lines({{0, 0}, {1, 7}});
  EXPECT_NEAR(resolved_radar(radar).pulse.envelope_value(1e-6), 1.0, 4.0 * epsilon);
}

TEST(ResolveRadar, MakesEveryKindOfWindow) {
  scene::Radar radar;
  EXPECT_EQ(resolved_radar(radar).window(0.1), 1.0);
  radar.window = scene::Radar::Window::hanning;
  radar.hanning_pedestal = 0.2;
  EXPECT_NEAR(resolved_radar(radar).window(0.0), 0.2, epsilon);
  radar.window = scene::Radar::Window::bartlett;
  EXPECT_EQ(resolved_radar(radar).window(0.25), 0.5);
  radar.window = scene::Radar::Window::hamming;
  EXPECT_NEAR(resolved_radar(radar).window(0.0), 0.08, epsilon);
  radar.window = scene::Radar::Window::blackman;
  EXPECT_NEAR(resolved_radar(radar).window(0.25), 0.34, epsilon);
  radar.window = scene::Radar::Window::kaiser;
  radar.kaiser_beta = 4.0;
  EXPECT_NEAR(resolved_radar(radar).window(0.25), core::bessel_i0(4.0 * std::sqrt(0.75)) / core::bessel_i0(4.0),
              epsilon);
  radar.window = scene::Radar::Window::taylor;
  radar.taylor_sidelobes_db = 40.0;
  const auto taylor =
      signal::weight_of({.kind = signal::SarWindow::Kind::taylor, .sidelobes_db = 40.0, .equal_sidelobes = 5});
  EXPECT_NEAR(resolved_radar(radar).window(0.3), taylor(-0.2), epsilon);
  radar.window = scene::Radar::Window::user;
  radar.window_gain.part[0] = lines({{0, 1}, {1, 3}});
  EXPECT_EQ(resolved_radar(radar).window(0.5), 2.0);
}

TEST(ResolveRadar, MakesSchedulesFromTheOrdinatesOfTheirFunctions) {
  scene::Radar radar;
  radar.repetition = scene::Radar::Repetition::user;
  radar.pri_s.part[0] = lines({{0, 1e-3}, {9, 2e-3}});
  radar.carrier = scene::Radar::Carrier::user;
  radar.carrier_list_hz.part[0] = lines({{0, 1e9}, {5, 3e9}});
  const Link r = resolved_radar(radar);
  EXPECT_NEAR(r.repetition.send_time_s(3), 4e-3, 1e-3 * 8.0 * epsilon);
  EXPECT_EQ(r.carrier.carrier_hz(3), 3e9);
  radar.carrier = scene::Radar::Carrier::stepped;
  radar.carrier_hz = 2e9;
  radar.carrier_step_hz = 1e6;
  radar.carrier_steps = 4;
  radar.pulses_per_step = 2;
  EXPECT_EQ(resolved_radar(radar).carrier.carrier_hz(7), 2.003e9);
}

TEST(ResolveRadar, MakesEveryKindOfBeam) {
  scene::Radar radar;
  radar.beam_azimuth = core::Angle::from_deg(90.0);
  radar.beam_elevation = core::Angle::from_deg(45.0);
  radar.beam_rate = core::Angle::from_deg(180.0);
  radar.spot_world_m = {1, 2, 3};
  radar.beam_target_world_m.part = {lines({{0, 7}}), lines({{0, 8}}), lines({{0, 9}})};
  const radar::Beam beam = resolved_radar(radar).beam;
  EXPECT_NEAR(beam.azimuth_rad, core::pi / 2, epsilon);
  EXPECT_NEAR(beam.elevation_rad, core::pi / 4, epsilon);
  EXPECT_NEAR(beam.rate_rad_per_s, core::pi, epsilon);
  EXPECT_EQ(beam.spot_world_m, (core::Vec3{1, 2, 3}));
  EXPECT_EQ(beam.kind, radar::Beam::Kind::fixed);
  radar.beam = scene::Radar::Beam::user;
  EXPECT_EQ(resolved_radar(radar).beam.target_world_m[2].value(0), 9.0);
}

TEST(ResolveRadar, InterpolatesLowPassFunctionsByTheRuleOfTheProfile) {
  scene::Radar radar;
  radar.window = scene::Radar::Window::user;
  radar.window_gain.part[0] = {core::Interpolation::low_pass, {{0.0, 1.0}, {0.5, 1.0}, {1.0, 1.0}}};
  EXPECT_NEAR(resolved_radar(radar).window(0.25), 1.0, 10.0 * epsilon);
  EXPECT_GT(std::abs(resolved_radar(radar, scene::Profile::classic).window(0.25) - 1.0), 0.05);
}

}  // namespace resolved_test
}  // namespace sarsim::simulate
