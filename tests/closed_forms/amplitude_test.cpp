// The radar equation in recorded echoes.

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenes.hpp"

namespace sarsim {
namespace amplitude_test {

// Amplitude of the recorded echo of one target on the x axis.
double amplitude_v(scene::Scene scene, double range_m, double rcs_m2 = 1.0) {
  scene.targets.clear();
  test::add_target(scene, {range_m, 0.0, 0.0}, rcs_m2);
  test::set_window(scene, range_m - 100.0, range_m + 900.0, 2e6);
  return test::recorded(scene).report.maximum_v;
}

double decibels(double amplitude_ratio) { return 20.0 * std::log10(amplitude_ratio); }

TEST(RadarEquation, GivesTheAmplitude) {
  const scene::Scene scene = test::radar_at_origin();
  const double wavelength_m = core::exact_light_speed_mps / 1e9;
  for (const double range_m : {150.0, 1000.0, 30e3, 1e6})
    for (const double rcs_m2 : {1e-3, 1.0, 40.0}) {
      const double power_w =
          1000.0 * wavelength_m * wavelength_m * rcs_m2 / (std::pow(4.0 * core::pi, 3) * std::pow(range_m, 4));
      EXPECT_NEAR(amplitude_v(scene, range_m, rcs_m2) / std::sqrt(power_w), 1.0, 1e-12);
    }
}

TEST(RadarEquation, TakesTwelveDecibelsForTwiceTheRange) {
  const scene::Scene scene = test::radar_at_origin();
  EXPECT_NEAR(decibels(amplitude_v(scene, 2000.0) / amplitude_v(scene, 1000.0)), -12.0412, 1e-4);
}

TEST(RadarEquation, AddsGainsAndTakesLossesInDecibels) {
  scene::Scene scene = test::radar_at_origin();
  const double bare_v = amplitude_v(scene, 1000.0);
  scene.radars[0].transmit_gain = core::PowerRatio::from_db(20.0);
  scene.radars[0].receive_gain = core::PowerRatio::from_db(7.0);
  scene.radars[0].losses = core::PowerRatio::from_db(4.5);
  EXPECT_NEAR(decibels(amplitude_v(scene, 1000.0) / bare_v), 22.5, 1e-12);
}

TEST(RadarEquation, FollowsTheWavelengthOfEachPulse) {
  scene::Scene scene = test::radar_at_origin();
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_hz = 1e9;
  scene.radars[0].carrier_step_hz = 0.5e9;
  scene.radars[0].carrier_steps = 3;
  scene.radars[0].pulses_per_step = 1;
  test::add_target(scene, {1000.0, 0.0, 0.0});
  test::set_window(scene, 1100.0, 1150.0, 4e6);
  test::set_pulses(scene, 0, 2);
  const auto pulses = test::column(test::recorded(scene), 0);
  EXPECT_NEAR(std::abs(pulses[1]) / std::abs(pulses[0]), 1.0 / 1.5, 1e-12);
  EXPECT_NEAR(std::abs(pulses[2]) / std::abs(pulses[0]), 1.0 / 2.0, 1e-12);
}

TEST(RadarEquation, AddsEchoesOfSeveralTargetsAsVoltages) {
  // A quarter of a wavelength apart the two-way paths differ by half a wavelength: 1 m^2 and 1 m^2 cancel but for the
  // ratio of the ranges.
  scene::Scene scene = test::radar_at_origin();
  const double quarter_m = 0.25 * core::exact_light_speed_mps / 1e9;
  test::add_target(scene, {1000.0, 0.0, 0.0});
  test::add_target(scene, {1000.0 + quarter_m, 0.0, 0.0});
  test::set_window(scene, 1100.0, 1150.0, 4e6);
  const double together_v = std::abs(test::recorded(scene).samples[0]);
  const double alone_v = amplitude_v(scene, 1000.0);
  EXPECT_NEAR(together_v / alone_v, 1.0 - std::pow(1000.0 / (1000.0 + quarter_m), 2), 1e-9);
}

TEST(Reflectivity, OfACosineTargetIsHalfThePowerAtSixtyDegreesAndNothingFromBehind) {
  // Azimuth 270 deg looks along -x, back to the radar.
  const auto power = [](double turned_deg) {
    scene::Scene scene = test::radar_at_origin();
    scene::Target& target = test::add_target(scene, {1000.0, 0.0, 0.0});
    target.traits.edit().reflectivity = scene::Target::Reflectivity::directional;
    target.traits.edit().azimuth = core::Angle::from_deg(270.0 + turned_deg);
    test::set_window(scene, 900.0, 1900.0, 2e6);
    return std::pow(test::recorded(scene).report.maximum_v, 2);
  };
  EXPECT_NEAR(power(60.0) / power(0.0), 0.5, 1e-12);
  EXPECT_NEAR(power(30.0) / power(0.0), std::sqrt(0.75), 1e-12);
  EXPECT_EQ(power(120.0), 0.0);
}

TEST(Antenna, OfSinxIsDownByItsTwoWayCurveSquaredInThePhysicalProfile) {
  // 2.5 deg off a beam of 5 deg: x = 0.88 pi sin(2.5 deg)/5 deg, one-way amplitude sin(x)/x in azimuth.
  scene::Scene scene = test::radar_at_origin();
  scene::Radar& radar = scene.radars[0];
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(5.0);
  radar.beam_azimuth = core::Angle::from_deg(90.0);
  const double on_axis_v = amplitude_v(scene, 1000.0);
  radar.beam_azimuth = core::Angle::from_deg(92.5);
  const double x = 0.88 * core::pi * std::sin(2.5 * core::pi / 180.0) / (5.0 * core::pi / 180.0);
  EXPECT_NEAR(amplitude_v(scene, 1000.0) / on_axis_v, std::pow(std::sin(x) / x, 2), 1e-12);
  // Half the beamwidth off the axis is where one way loses half the power: two ways 6 dB.
  EXPECT_NEAR(decibels(amplitude_v(scene, 1000.0) / on_axis_v), -6.0, 0.1);
}

}  // namespace amplitude_test
}  // namespace sarsim
