#include "radar/earth/turning_frame.hpp"

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

namespace {

// Days of UT1 since J2000 (MJD 51544.5) and what is over of the present day. In extended precision: the rounding of a
// double of days would turn the Earth by 1e-14 rad, 1e-7 m in orbit, otherwise at every moment.
struct Ut1 {
  long double since_2000_days = 0.0L;
  long double of_day = 0.0L;
};

Ut1 ut1_of(const Instant& instant, double dut1_s) {
  const DayTime clock = day_time_of(instant, TimeScale::ut1, dut1_s);
  const long double of_day = (static_cast<long double>(clock.second) + clock.fraction_s) / 86'400.0L;
  return {static_cast<long double>(clock.day_mjd - 51'544) - 0.5L + of_day, of_day};
}

double angle_of_turns(long double turns) {
  constexpr long double full = 2.0L * 3.141592653589793238462643383279502884L;
  const auto angle = static_cast<double>(full * (turns - std::floor(turns)));
  return angle < 2.0 * core::pi ? angle : 0.0;
}

constexpr long double days_per_century = 36'525.0L;

}  // namespace

StateVector TurningFrame::to(const StateVector& state) const {
  return {rotation * state.position_m, rotation * state.velocity_mps + rate_per_s * state.position_m};
}

StateVector TurningFrame::back(const StateVector& state) const {
  const core::Mat3 inverse = core::transposed(rotation);
  const core::Vec3 position_m = inverse * state.position_m;
  return {position_m, inverse * (state.velocity_mps - rate_per_s * position_m)};
}

TurningFrame operator*(const TurningFrame& a, const TurningFrame& b) {
  return {a.rotation * b.rotation, a.rate_per_s * b.rotation + a.rotation * b.rate_per_s};
}

double earth_rotation_angle_rad(const Instant& instant, double dut1_s) {
  const Ut1 ut1 = ut1_of(instant, dut1_s);
  // The day begins half a turn before the noon that Tu counts from.
  return angle_of_turns(0.7790572732640L - 0.5L + ut1.of_day + 0.00273781191135448L * ut1.since_2000_days);
}

double gmst82_rad(const Instant& instant, double dut1_s) {
  const Ut1 ut1 = ut1_of(instant, dut1_s);
  const long double t = ut1.since_2000_days / days_per_century;
  const long double seconds = 24'110.54841L + (8'640'184.812866L + (0.093104L - 6.2e-6L * t) * t) * t;
  return angle_of_turns(ut1.of_day + seconds / 86'400.0L);
}

double gmst82_rate_rad_per_s(const Instant& instant, double dut1_s) {
  const auto t = static_cast<double>(ut1_of(instant, dut1_s).since_2000_days / days_per_century);
  const double per_century_s = 8'640'184.812866 + (2.0 * 0.093104 - 3.0 * 6.2e-6 * t) * t;
  return 2.0 * core::pi / 86'400.0 * (1.0 + per_century_s / (36'525.0 * 86'400.0));
}

core::Mat3 turned_about_z(double angle_rad) {
  const double s = std::sin(angle_rad), c = std::cos(angle_rad);
  return {{core::Vec3{c, s, 0.0}, core::Vec3{-s, c, 0.0}, core::Vec3{0.0, 0.0, 1.0}}};
}

TurningFrame turning_about_z(double angle_rad, double rate_rad_per_s) {
  const double s = rate_rad_per_s * std::sin(angle_rad), c = rate_rad_per_s * std::cos(angle_rad);
  return {turned_about_z(angle_rad), {{core::Vec3{-s, c, 0.0}, core::Vec3{-c, -s, 0.0}, core::Vec3{}}}};
}

core::Mat3 polar_motion(const EarthOrientation& orientation) {
  const double sx = std::sin(orientation.polar_x_rad), cx = std::cos(orientation.polar_x_rad);
  const double sy = std::sin(orientation.polar_y_rad), cy = std::cos(orientation.polar_y_rad);
  const core::Mat3 about_y{{core::Vec3{cx, 0.0, sx}, core::Vec3{0.0, 1.0, 0.0}, core::Vec3{-sx, 0.0, cx}}};  // R2(-x)
  const core::Mat3 about_x{{core::Vec3{1.0, 0.0, 0.0}, core::Vec3{0.0, cy, -sy}, core::Vec3{0.0, sy, cy}}};  // R1(-y)
  return about_x * about_y;
}

TurningFrame ecef_from_teme(const Instant& instant, const EarthOrientation& orientation) {
  const TurningFrame pole{polar_motion(orientation)};
  return pole *
         turning_about_z(gmst82_rad(instant, orientation.dut1_s), gmst82_rate_rad_per_s(instant, orientation.dut1_s));
}

}  // namespace sarsim::radar
