#include "radar/earth/turning_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace turning_frame_test {

using core::pi;
using core::Vec3;

constexpr double rad_per_arcsecond = core::rad_per_deg / 3600.0;

Instant utc(std::string_view text) { return parse_instant(text, TimeScale::utc).instant.value_or(Instant{}); }

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
  EXPECT_NEAR(found.z, expected.z, tolerance);
}

// Made by ERFA 2.0, whose own rounding is 2e-14.
TEST(EarthAngles, AreThoseOfErfa) {
  const Instant instant = utc("2025-03-14T12:00:00Z");
  EXPECT_NEAR(earth_rotation_angle_rad(instant), 6.144189343877386, 2e-14);
  EXPECT_NEAR(gmst82_rad(instant), 6.149824739311903, 2e-14);
}

TEST(EarthAngles, StayWithinATurnAndGrowAtTheirRates) {
  const Instant start = utc("2024-12-30T00:00:00Z");
  for (int hour = 0; hour < 72; ++hour) {
    const Instant now = later(start, 3600.0 * hour), then = later(now, 10.0);
    const auto grown = [](double from, double to) { return std::remainder(to - from, 2.0 * pi) / 10.0; };
    const double era = earth_rotation_angle_rad(now), gmst = gmst82_rad(now);
    EXPECT_GE(era, 0.0);
    EXPECT_LT(era, 2.0 * pi);
    EXPECT_GE(gmst, 0.0);
    EXPECT_LT(gmst, 2.0 * pi);
    // Two roundings of 9e-16 in 10 s.
    EXPECT_NEAR(grown(era, earth_rotation_angle_rad(then)), earth_rotation_angle_rate_rad_per_s, 2e-16);
    EXPECT_NEAR(grown(gmst, gmst82_rad(then)), gmst82_rate_rad_per_s(now), 2e-16);
  }
  EXPECT_NEAR(gmst82_rate_rad_per_s(start), 7.2921158553e-5, 1e-14);
}

TEST(EarthAngles, TakeDut1AsTurning) {
  const Instant instant = utc("2025-03-14T12:00:00Z");
  EXPECT_NEAR(earth_rotation_angle_rad(instant, 0.4), earth_rotation_angle_rad(later(instant, 0.4)), 1e-15);
  EXPECT_NEAR(gmst82_rad(instant, -0.4), gmst82_rad(later(instant, -0.4)), 1e-15);
  EXPECT_NEAR(gmst82_rad(instant, 0.4) - gmst82_rad(instant), 0.4 * 7.2921158553e-5, 1e-14);
}

TEST(TurningFrame, LeadsThereAndBack) {
  const TurningFrame frame = turning_about_z(0.7, 7.3e-5);
  const StateVector state{{7e6, -1e6, 3e5}, {100.0, -7400.0, 12.0}};
  const StateVector back = frame.back(frame.to(state));
  expect_near(back.position_m, state.position_m, 2e-9);
  expect_near(back.velocity_mps, state.velocity_mps, 3e-12);
}

TEST(TurningFrame, TakesAwayWhatTheEarthCarries) {
  const Vec3 w{0.0, 0.0, 7.3e-5};
  const TurningFrame frame = turning_about_z(0.7, w.z);
  const StateVector state{{7e6, -1e6, 3e5}, {100.0, -7400.0, 12.0}};
  const StateVector fixed = frame.to(state);
  expect_near(fixed.velocity_mps, frame.rotation * state.velocity_mps - core::cross(w, fixed.position_m), 3e-12);
  expect_near(frame.to({{7e6, 0.0, 0.0}, core::cross(w, {7e6, 0.0, 0.0})}).velocity_mps, {}, 3e-12);
  expect_near(turned_about_z(pi / 2.0) * Vec3{1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, 1e-16);
}

TEST(TurningFrame, OfTwoHasTheProductRule) {
  const TurningFrame both = turning_about_z(0.7, 7.3e-5) * turning_about_z(-0.2, 1e-5);
  const TurningFrame sum = turning_about_z(0.5, 8.3e-5);
  for (std::size_t i = 0; i < 3; ++i) {
    expect_near(both.rotation.row[i], sum.rotation.row[i], 3e-16);
    expect_near(both.rate_per_s.row[i], sum.rate_per_s.row[i], 3e-20);
  }
}

// Satellite 00005 of the Spacetrack verification set, 4320 min after its epoch.
TEST(EcefFromTeme, HasThePositionOfTheSpecification) {
  const Instant instant = later(utc("2000-06-27T18:50:19.733568Z"), 4320.0 * 60.0);
  const StateVector teme{{-9060473.73569, 4658709.52502, 813686.73153}, {-2232.832783, -4110.453490, -3157.345433}};
  expect_near(ecef_from_teme(instant).to(teme).position_m, {6692370.040, -7681662.711, 813686.732}, 5.1e-4);
}

// The example of Vallado, Crawford, Hujsak, Kelso: "Revisiting Spacetrack Report #3", AIAA 2006-6753, appendix C,
// before and after the motion of the pole. Its time is a Julian date in one double, 2e-5 s to either side: 0.012 m; its
// rate is that of the Earth with the length of that day, 7e-12 rad/s less.
TEST(EcefFromTeme, HasTheStateOfThePaper) {
  const Instant instant = utc("2004-04-06T07:51:28.386009Z");
  const StateVector teme{{5094180.16210, 6127644.65950, 6380344.53270}, {-4746.131487, 785.818041, 5531.931288}};
  const StateVector pef = ecef_from_teme(instant, {-0.439961, 0.0, 0.0}).to(teme);
  expect_near(pef.position_m, {-1033475.03130, 7901305.58560, 6380344.53270}, 0.012);
  expect_near(pef.velocity_mps, {-3225.632747, -2872.442511, 5531.931288}, 8e-5);
  const EarthOrientation orientation{-0.439961, -0.140682 * rad_per_arcsecond, 0.333309 * rad_per_arcsecond};
  const StateVector itrf = ecef_from_teme(instant, orientation).to(teme);
  expect_near(itrf.position_m, {-1033479.38300, 7901295.27540, 6380356.59580}, 0.012);
  expect_near(itrf.velocity_mps, {-3225.636520, -2872.451450, 5531.924446}, 8e-5);
  const StateVector back = ecef_from_teme(instant, orientation).back(itrf);
  expect_near(back.position_m, teme.position_m, 5e-9);
  expect_near(back.velocity_mps, teme.velocity_mps, 5e-12);
}

// Positions on a straight line in TEME: the velocity is their derivative, central over 2 s, less its third order,
// w^3 r/6 = 5e-7 m/s and w^2 v/2 = 2e-5 m/s, which a second difference takes out.
TEST(EcefFromTeme, HasVelocitiesThatAreTheDerivativesOfPositions) {
  const Instant instant = utc("2024-04-01T22:59:42Z");
  const StateVector teme{{7e6, -1e6, 3e5}, {100.0, -7400.0, 1200.0}};
  const auto at = [&](double t) {
    return ecef_from_teme(later(instant, t))
        .to({teme.position_m + t * teme.velocity_mps, teme.velocity_mps})
        .position_m;
  };
  const auto slope = [&](double t) { return (0.5 / t) * (at(t) - at(-t)); };
  const Vec3 derivative = (1.0 / 3.0) * (4.0 * slope(1.0) - slope(2.0));
  expect_near(ecef_from_teme(instant).to(teme).velocity_mps, derivative, 2e-8);
}

TEST(PolarMotion, MovesThePoleToItsCoordinates) {
  const double x = 0.2 * rad_per_arcsecond, y = 0.4 * rad_per_arcsecond;
  const core::Mat3 w = polar_motion({0.0, x, y});
  expect_near(w * Vec3{0.0, 0.0, 1.0}, {x, -y, 1.0}, 1e-11);
  EXPECT_EQ(polar_motion({}), core::Mat3());
  // 0.1" and 0.4" at 7071 km.
  EXPECT_NEAR(7071e3 * std::hypot(0.1, 0.4) * rad_per_arcsecond, 14.0, 0.5);
}

}  // namespace turning_frame_test
}  // namespace sarsim::radar
