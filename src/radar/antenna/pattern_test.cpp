#include "radar/antenna/pattern.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace pattern_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

AntennaPattern sinx(double azimuth_deg, double elevation_deg) {
  AntennaPattern pattern;
  pattern.kind = AntennaPattern::Kind::sinx;
  pattern.azimuth_beamwidth_rad = azimuth_deg * core::rad_per_deg;
  pattern.elevation_beamwidth_rad = elevation_deg * core::rad_per_deg;
  return pattern;
}

double db(double amplitude) { return 20.0 * std::log10(std::abs(amplitude)); }

TEST(WrappedAngle, LiesInTheHalfOpenTurn) {
  EXPECT_EQ(wrapped_angle(0.5), 0.5);
  EXPECT_EQ(wrapped_angle(core::pi), core::pi);
  EXPECT_EQ(wrapped_angle(-core::pi), core::pi);
  EXPECT_EQ(wrapped_angle(-core::pi + 1e-12), core::pi);  // Rounding of the same direction.
  EXPECT_EQ(wrapped_angle(-core::pi + 1e-6), -core::pi + 1e-6);
  for (int turns = -3; turns <= 3; ++turns)
    EXPECT_NEAR(wrapped_angle(1.2 + 2.0 * core::pi * turns), 1.2, 2.0 * core::pi * 3.0 * epsilon);
  EXPECT_NEAR(wrapped_angle(core::pi + 0.25), -core::pi + 0.25, 4.0 * epsilon);
}

// 0.88 pi sin(B/2)/B tends to 0.44 pi: sin(0.44 pi)/(0.44 pi) = 0.71065, -2.967 dB; the sine makes a beam of 10 degrees
// wider by (5 deg)^2/6 = 0.13 %, 0.01 dB.
TEST(SinxGain, IsThreeDecibelsDownAtHalfTheBeamwidthAsAnAmplitude) {
  EXPECT_NEAR(db(sinx_gain(0.005, 0.01)), db(std::sin(0.44 * core::pi) / (0.44 * core::pi)), 1e-4);
  EXPECT_NEAR(sinx_gain(5.0 * core::rad_per_deg, 10.0 * core::rad_per_deg), 0.71128, 5e-6);
  for (const double beamwidth : {0.01, 0.05, 0.17}) EXPECT_NEAR(db(sinx_gain(0.5 * beamwidth, beamwidth)), -3.01, 0.06);
}

// The first side lobe of sin(x)/x has 0.21723 of the amplitude, at x = 1.4303 pi: -13.26 dB one way, -26.52 dB two
// ways.
TEST(SinxGain, OfANarrowBeamHasAFirstSideLobeOfMinusThirteenDecibels) {
  constexpr double beamwidth = 1.0 * core::rad_per_deg;
  double lobe = 0.0;
  for (double x = 1.01; x < 1.99; x += 1e-3) {
    const double offset = std::asin(x * beamwidth / 0.88);
    lobe = std::min(lobe, sinx_gain(offset, beamwidth));  // negative: the side lobe turns the phase
  }
  EXPECT_NEAR(lobe, -0.217234, 1e-6);
  const AntennaPattern antenna = sinx(1.0, 1.0);
  const double offset = std::asin(1.4303 * beamwidth / 0.88);
  const double amplitude = one_way_amplitude(antenna, offset, 0.0, PatternRule::amplitude);
  EXPECT_NEAR(db(amplitude), -13.26, 0.005);
  EXPECT_NEAR(db(amplitude * amplitude), -26.52, 0.01);
  const double classic = one_way_amplitude(antenna, offset, 0.0, PatternRule::power);
  EXPECT_NEAR(db(classic * classic), -13.26, 0.005);  // what the 1998 programs and the thesis show for two ways
}

TEST(SinxGain, IsOneOnTheAxisAndZeroBehind) {
  EXPECT_EQ(sinx_gain(0.0, 0.1), 1.0);
  EXPECT_NEAR(sinx_gain(1e-9, 0.1), 1.0, epsilon);
  EXPECT_EQ(sinx_gain(0.5 * core::pi, 0.1), 0.0);
  EXPECT_EQ(sinx_gain(-0.5 * core::pi, 0.1), 0.0);
  EXPECT_EQ(sinx_gain(core::pi, 3.0), 0.0);
  EXPECT_NE(sinx_gain(89.9 * core::rad_per_deg, 3.0), 0.0);
}

TEST(SinxGain, IsSymmetricAndWraps) {
  for (const double offset : {0.01, 0.3, 1.2, 2.0}) {
    EXPECT_EQ(sinx_gain(-offset, 0.2), sinx_gain(offset, 0.2));
    EXPECT_NEAR(sinx_gain(offset + 2.0 * core::pi, 0.2), sinx_gain(offset, 0.2), 100.0 * epsilon);
  }
}

TEST(OneWayAmplitude, IsTheProductOfTheCutsEachWithItsOwnBeamwidth) {
  const AntennaPattern antenna = sinx(2.0, 20.0);
  const double g_az = sinx_gain(0.05, 2.0 * core::rad_per_deg), g_el = sinx_gain(0.1, 20.0 * core::rad_per_deg);
  EXPECT_EQ(one_way_amplitude(antenna, 0.05, 0.1, PatternRule::amplitude), g_az * g_el);
  EXPECT_NEAR(one_way_amplitude(antenna, 0.05, 0.1, PatternRule::power), std::sqrt(std::abs(g_az * g_el)),
              2.0 * epsilon);
  EXPECT_LT(g_az * g_el, 0.0);  // so that the comparison above is about a side lobe
}

TEST(OneWayAmplitude, OfAnIsotropicAntennaIsOneEverywhere) {
  const AntennaPattern antenna;
  EXPECT_EQ(one_way_amplitude(antenna, 3.0, -1.0, PatternRule::amplitude), 1.0);
  EXPECT_EQ(one_way_amplitude(antenna, 3.0, -1.0, PatternRule::power), 1.0);
}

TEST(OneWayAmplitude, OfAUserAntennaAddsTheDecibelsOfTheCutsAtWrappedMagnitudes) {
  AntennaPattern antenna;
  antenna.kind = AntennaPattern::Kind::user;
  antenna.azimuth_gain_db =
      core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0, 10}, {180, -80}}});
  antenna.elevation_gain_db =
      core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0, 0}, {180, -180}}});
  for (const PatternRule rule : {PatternRule::amplitude, PatternRule::power}) {
    const auto decibels = [&](double az_deg, double el_deg) {
      return db(one_way_amplitude(antenna, az_deg * core::rad_per_deg, el_deg * core::rad_per_deg, rule));
    };
    EXPECT_NEAR(decibels(0.0, 0.0), 10.0, 1e-12);
    EXPECT_NEAR(decibels(20.0, 0.0), 0.0, 1e-12);
    EXPECT_NEAR(decibels(-20.0, 3.0), -3.0, 1e-12);
    EXPECT_NEAR(decibels(350.0, 0.0), 5.0, 1e-12);
    EXPECT_NEAR(decibels(0.0, -357.0), 7.0, 1e-12);
  }
}

// Two targets 10 degrees above and below the beam of a cosecant pattern: -12 and -60 dB there and back.
TEST(OneWayAmplitude, OfAUserAntennaTellsAboveFromBelow) {
  AntennaPattern antenna;
  antenna.kind = AntennaPattern::Kind::user;
  antenna.elevation_gain_db =
      core::AngleFunction({core::Interpolation::linear,
                           {{-90, -40}, {-10, -30}, {-2, -3}, {0, 0}, {2, -1}, {10, -6}, {40, -12}, {90, -40}}},
                          {}, core::AngleRule::elevation);
  const auto two_way_db = [&](double azimuth_rad, double elevation_rad) {
    const double one_way = one_way_amplitude(antenna, azimuth_rad, elevation_rad, PatternRule::amplitude);
    return db(one_way * one_way);
  };
  const double ten = 10.0 * core::rad_per_deg;
  EXPECT_NEAR(two_way_db(0.3, ten), -12.0, 1e-11);
  EXPECT_NEAR(two_way_db(-0.3, -ten), -60.0, 1e-11);
  std::swap(antenna.azimuth_gain_db, antenna.elevation_gain_db);
  EXPECT_NEAR(two_way_db(ten, 0.0), -12.0, 1e-11);
  EXPECT_NEAR(two_way_db(-ten + 2.0 * core::pi, 0.0), -60.0, 1e-10);
}

}  // namespace pattern_test
}  // namespace sarsim::radar
