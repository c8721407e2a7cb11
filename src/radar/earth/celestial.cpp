#include "radar/earth/celestial.hpp"

#include <cstddef>

#include <erfa.h>

namespace sarsim::radar {

namespace {

using ErfaMatrix = double[3][3];  // NOLINT: as ERFA takes it

core::Mat3 matrix_of(const ErfaMatrix& m) {
  core::Mat3 matrix;
  for (std::size_t i = 0; i < 3; ++i) matrix.row[i] = {m[i][0], m[i][1], m[i][2]};
  return matrix;
}

// Terrestrial time as ERFA takes it: two parts of a Julian date.
struct TerrestrialTime {
  double whole_day = 0.0;
  double of_day = 0.0;
};

TerrestrialTime terrestrial_time_of(const Instant& instant) {
  const DayTime clock = day_time_of(instant, TimeScale::tt);
  return {2'400'000.5 + static_cast<double>(clock.day_mjd),
          (static_cast<double>(clock.second) + clock.fraction_s) / 86'400.0};
}

core::Mat3 intermediate_from_gcrf(const TerrestrialTime& tt) {
  ErfaMatrix matrix;
  eraC2i06a(tt.whole_day, tt.of_day, matrix);
  return matrix_of(matrix);
}

// Precession and nutation. Their rate is a quotient over minutes: what is smooth about them has periods of days, and
// their rounding, 1e-16, becomes 1e-19 per second.
TurningFrame precession(const TerrestrialTime& tt) {
  constexpr double step_days = 300.0 / 86'400.0;
  TerrestrialTime before = tt, after = tt;
  before.of_day -= step_days;
  after.of_day += step_days;
  const core::Mat3 change = intermediate_from_gcrf(after) + -1.0 * intermediate_from_gcrf(before);
  return {intermediate_from_gcrf(tt), 1.0 / (2.0 * 86'400.0 * step_days) * change};
}

// Rotation by the locator of the terrestrial origin, 47 microseconds of arc a century, and the motion of the pole.
core::Mat3 ecef_from_pole(const TerrestrialTime& tt, const EarthOrientation& orientation) {
  return polar_motion(orientation) * turned_about_z(eraSp00(tt.whole_day, tt.of_day));
}

// From mean axes of J2000 to GCRF.
core::Mat3 gcrf_from_eme2000() {
  ErfaMatrix bias, precession_matrix, both;
  eraBp06(2451545.0, 0.0, bias, precession_matrix, both);
  return core::transposed(matrix_of(bias));
}

}  // namespace

TurningFrame ecef_from_gcrf(const Instant& instant, const EarthOrientation& orientation) {
  const TerrestrialTime tt = terrestrial_time_of(instant);
  const TurningFrame pole{ecef_from_pole(tt, orientation)};
  const double angle_rad = earth_rotation_angle_rad(instant, orientation.dut1_s);
  return pole * turning_about_z(angle_rad, earth_rotation_angle_rate_rad_per_s) * precession(tt);
}

TurningFrame ecef_from_eme2000(const Instant& instant, const EarthOrientation& orientation) {
  static const TurningFrame bias{gcrf_from_eme2000()};
  return ecef_from_gcrf(instant, orientation) * bias;
}

}  // namespace sarsim::radar
