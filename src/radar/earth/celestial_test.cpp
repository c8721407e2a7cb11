#include "radar/earth/celestial.hpp"

#include <erfa.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/earth/leap_seconds.hpp"

namespace sarsim::radar {
namespace celestial_test {

using core::Vec3;

constexpr double rad_per_arcsecond = core::rad_per_deg / 3600.0;

Instant utc(std::string_view text) { return parse_instant(text, TimeScale::utc).instant.value_or(Instant{}); }

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
  EXPECT_NEAR(found.z, expected.z, tolerance);
}

void expect_near(const core::Mat3& found, const core::Mat3& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) expect_near(found.row[i], expected.row[i], tolerance);
}

struct Dates {
  double day, tt, ut1;
};

Dates erfa_dates(const Instant& instant, double dut1_s) {
  const DayTime tt = day_time_of(instant, TimeScale::tt), ut1 = day_time_of(instant, TimeScale::ut1, dut1_s);
  const auto fraction = [&](const DayTime& time) {
    return static_cast<double>(time.day_mjd - tt.day_mjd) +
           (static_cast<double>(time.second) + time.fraction_s) / 86'400.0;
  };
  return {2'400'000.5 + static_cast<double>(tt.day_mjd), fraction(tt), fraction(ut1)};
}

TEST(EcefFromGcrf, HasTheRowOfTheSpecification) {
  const core::Mat3 found = ecef_from_gcrf(utc("2025-03-14T12:00:00Z")).rotation;
  expect_near(found.row[0], {0.9903526429502632, -0.1385488312343134, -0.002421562519185557}, 2e-14);
}

// ERFA's own angle of rotation has a rounding of 2e-14.
TEST(EcefFromGcrf, IsTheMatrixOfErfa) {
  for (const char* text : {"1972-01-01T00:00:00Z", "1999-12-31T12:00:00.5Z", "2016-12-31T23:59:60.5Z",
                           "2024-04-01T22:59:42.123Z", "2049-06-30T06:07:08Z"}) {
    const Instant instant = utc(text);
    const EarthOrientation orientation{0.31, 0.2 * rad_per_arcsecond, -0.4 * rad_per_arcsecond};
    const Dates dates = erfa_dates(instant, orientation.dut1_s);
    double m[3][3];  // NOLINT: as ERFA takes it
    eraC2t06a(dates.day, dates.tt, dates.day, dates.ut1, orientation.polar_x_rad, orientation.polar_y_rad, m);
    const core::Mat3 expected{
        {Vec3{m[0][0], m[0][1], m[0][2]}, Vec3{m[1][0], m[1][1], m[1][2]}, Vec3{m[2][0], m[2][1], m[2][2]}}};
    expect_near(ecef_from_gcrf(instant, orientation).rotation, expected, 3e-14);
    // It rounds up to 4e6 s there, twice: 4.7e-10 s each.
    EXPECT_NEAR(gmst82_rad(instant, 0.31), eraGmst82(dates.day, dates.ut1), 7e-14);
    EXPECT_NEAR(earth_rotation_angle_rad(instant, 0.31), eraEra00(dates.day, dates.ut1), 3e-14);
  }
}

// What a node of an orbit may be off against its neighbours: along an even path the second differences of positions
// change evenly, and what is left of fourth differences is rounding, 16 times that of one.
TEST(EcefFromGcrf, IsSmoothInTime) {
  const Instant start = utc("2024-04-01T22:59:42Z");
  const auto at = [&](int i) { return ecef_from_gcrf(later(start, 0.1 * i)).rotation * Vec3{7e6, 1e6, 2e6}; };
  for (int i = 0; i < 20; ++i) {
    const Vec3 rest = at(i) + -4.0 * at(i + 1) + 6.0 * at(i + 2) + -4.0 * at(i + 3) + at(i + 4);
    expect_near(rest, {}, 16.0 * 5e-9);
  }
}

// Of a straight path in GCRF, as for TEME. Without the change of precession and nutation it would be 5e-5 m/s off.
TEST(EcefFromGcrf, HasVelocitiesThatAreTheDerivativesOfPositions) {
  const Instant instant = utc("2024-04-01T22:59:42Z");
  const StateVector gcrf{{7e6, -1e6, 3e6}, {100.0, -7400.0, 1200.0}};
  const EarthOrientation orientation{0.1, 1e-6, 2e-6};
  const auto at = [&](double t) {
    const StateVector then{gcrf.position_m + t * gcrf.velocity_mps, gcrf.velocity_mps};
    return ecef_from_gcrf(later(instant, t), orientation).to(then).position_m;
  };
  const auto slope = [&](double t) { return (0.5 / t) * (at(t) - at(-t)); };
  const Vec3 derivative = (1.0 / 3.0) * (4.0 * slope(1.0) - slope(2.0));
  const StateVector found = ecef_from_gcrf(instant, orientation).to(gcrf);
  expect_near(found.velocity_mps, derivative, 2e-8);
  const StateVector back = ecef_from_gcrf(instant, orientation).back(found);
  expect_near(back.position_m, gcrf.position_m, 1e-8);
  expect_near(back.velocity_mps, gcrf.velocity_mps, 1e-11);
}

// Precession since 2000: what the rotation of the Earth alone would miss.
TEST(EcefFromGcrf, HasPrecession) {
  const Instant instant = utc("2025-06-01T00:00:00Z");
  const Vec3 place{7071e3, 0.0, 0.0};
  const Vec3 alone = turned_about_z(earth_rotation_angle_rad(instant)) * place;
  EXPECT_NEAR(core::norm(ecef_from_gcrf(instant).rotation * place - alone), 17.3e3, 200.0);
}

TEST(EcefFromEme2000, DiffersFromGcrfByTheBiasOfTheFrames) {
  const Instant instant = utc("2024-04-01T22:59:42Z");
  const TurningFrame gcrf = ecef_from_gcrf(instant), eme2000 = ecef_from_eme2000(instant);
  const core::Mat3 gcrf_from_eme2000 = core::transposed(gcrf.rotation) * eme2000.rotation;
  // Offsets of the pole and of the equinox (IERS Conventions 2010, 5.4.4): -16.617 and -6.819 mas, -14.6 mas.
  const Vec3 pole = gcrf_from_eme2000 * Vec3{0.0, 0.0, 1.0}, equinox = gcrf_from_eme2000 * Vec3{1.0, 0.0, 0.0};
  EXPECT_NEAR(pole.x / rad_per_arcsecond, -0.016617, 1e-6);
  EXPECT_NEAR(pole.y / rad_per_arcsecond, -0.006819, 1e-6);
  EXPECT_NEAR(equinox.y / rad_per_arcsecond, -0.0146, 1e-6);
  expect_near(core::transposed(gcrf.rate_per_s) * (gcrf.rotation * Vec3{1.0, 2.0, 3.0}),
              gcrf_from_eme2000 * (core::transposed(eme2000.rate_per_s) * (gcrf.rotation * Vec3{1.0, 2.0, 3.0})),
              1e-18);
}

// TEME and GCRF are two ways to the same Earth: the equation of the equinoxes is between them, and nothing else but
// 0.1" of the older models.
TEST(EcefFromGcrf, AgreesWithTemeThroughTheTrueEquinox) {
  const Instant instant = utc("2024-04-01T22:59:42Z");
  const Dates dates = erfa_dates(instant, 0.0);
  double npb[3][3];  // NOLINT: as ERFA takes it
  eraPnm80(dates.day, dates.tt, npb);
  const core::Mat3 true_from_j2000{{Vec3{npb[0][0], npb[0][1], npb[0][2]}, Vec3{npb[1][0], npb[1][1], npb[1][2]},
                                    Vec3{npb[2][0], npb[2][1], npb[2][2]}}};
  const core::Mat3 teme_from_j2000 = turned_about_z(eraEqeq94(dates.day, dates.tt)) * true_from_j2000;
  const core::Mat3 by_teme = ecef_from_teme(instant).rotation * teme_from_j2000;
  expect_near(by_teme, ecef_from_eme2000(instant).rotation, 0.1 * rad_per_arcsecond);
}

TEST(LeapSeconds, AreThoseOfErfa) {
  for (std::int64_t day = first_utc_day_mjd; day < 60'000; ++day) {
    const CivilTime date = date_of_mjd(day);
    double offset = 0.0;
    eraDat(date.year, date.month, date.day, 0.0, &offset);
    EXPECT_EQ(static_cast<double>(tai_minus_utc_s(day)), offset) << day;
  }
}

}  // namespace celestial_test
}  // namespace sarsim::radar
