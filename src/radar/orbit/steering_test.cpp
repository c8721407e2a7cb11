#include "radar/orbit/steering.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "core/maths/constants.hpp"
#include "radar/orbit/kepler.hpp"
#include "radar/orbit/orbit_test_support.hpp"

namespace sarsim::radar {
namespace steering_test {

using core::Mat3;
using core::rad_per_deg;
using core::Vec3;

// The Earth-fixed frame as world frame.
constexpr TurningAxes earth{{0.0, 0.0, orbit_test::earth_rotation_rad_per_s}, {}};

OrbitMotion motion_of(const OrbitState& state) {
  return {state.position_m, state.velocity_mps, orbit_test::j2_acceleration(state.position_m, state.velocity_mps)};
}

Vec3 axis(const Mat3& m, int column) { return core::transposed(m).row[static_cast<std::size_t>(column)]; }

double largest_difference(const Mat3& a, const Mat3& b) {
  const Mat3 difference = a + (-1.0) * b;
  double largest = 0.0;
  for (const Vec3& row : difference.row) largest = std::max(largest, core::norm(row));
  return largest;
}

// A Kepler orbit seen from axes that turn with the Earth and coincide with the inertial ones at time 0.
OrbitMotion turning(double time_s) {
  EarthGravity point;
  point.j2 = 0.0;
  const OrbitMotion still = SecularOrbit({7.07e6, 0.02, 1.7, 0.4, 1.0, 2.0}, point).at(time_s);
  const double w = orbit_test::earth_rotation_rad_per_s;
  const double s = std::sin(w * time_s), c = std::cos(w * time_s);
  const Mat3 turn{{Vec3{c, s, 0.0}, Vec3{-s, c, 0.0}, Vec3{0.0, 0.0, 1.0}}};
  const Vec3 rotation{0.0, 0.0, w};
  OrbitMotion motion;
  motion.position_m = turn * still.position_m;
  motion.velocity_mps = turn * still.velocity_mps - core::cross(rotation, motion.position_m);
  motion.acceleration_mps2 = turn * still.acceleration_mps2 - 2.0 * core::cross(rotation, motion.velocity_mps) -
                             core::cross(rotation, core::cross(rotation, motion.position_m));
  return motion;
}

// Slant range along a direction to the ellipsoid WGS-84, and the angle of incidence there.
struct Ground {
  double range_m;
  double incidence_rad;
};

Ground ground_along(const Vec3& from, const Vec3& direction) {
  constexpr double a = 6378137.0, flattening = 1.0 / 298.257223563, b = a * (1.0 - flattening);
  const auto scaled = [](const Vec3& v) { return Vec3{v.x / a, v.y / a, v.z / b}; };
  const Vec3 p = scaled(from), d = scaled(direction);
  const double half = core::dot(p, d) / core::dot(d, d);
  const double range = -half - std::sqrt(half * half - (core::dot(p, p) - 1.0) / core::dot(d, d));
  const Vec3 normal = scaled(scaled(from + range * direction));
  return {range, std::acos(-core::dot(normal, direction) / core::norm(normal))};
}

const OrbitState& sentinel_1b() { return orbit_test::published_orbit_states[1].earth_fixed; }
constexpr double wavelength_m = 0.05546576;

// Direction of a beam at `look_deg` from the nadir to the right.
Vec3 beam(const OrbitAttitude& attitude, double look_deg) {
  return axis(rolled(attitude, {-look_deg * rad_per_deg, 0.0}).world_from_platform, 2);
}

double doppler_hz(const Vec3& velocity_mps, const Vec3& direction) {
  return 2.0 / wavelength_m * core::dot(velocity_mps, direction);
}

TEST(Steering, GivesRotations) {
  const OrbitMotion motion = turning(700.0);
  const OrbitMotion target{{6378137.0, 1000.0, -5000.0}, {10.0, 20.0, 30.0}, {}};
  for (const OrbitAttitude& attitude :
       {zero_doppler_attitude(motion, earth), zero_doppler_attitude(motion, earth, FlightDirection::inertial),
        nadir_attitude(motion, earth), nadir_attitude(motion, earth, FlightDirection::inertial),
        look_at_attitude(motion, target), rolled(nadir_attitude(motion, earth), {0.5, 0.0}),
        pitched(nadir_attitude(motion, earth), {0.5, 0.0}), yawed(nadir_attitude(motion, earth), {0.5, 0.0}),
        with_z_up(nadir_attitude(motion, earth))}) {
    const Mat3& m = attitude.world_from_platform;
    EXPECT_LT(largest_difference(m * core::transposed(m), Mat3{}), 1e-15);
    EXPECT_GT(core::dot(core::cross(axis(m, 0), axis(m, 1)), axis(m, 2)), 0.999);
  }
}

// Differences of fourth order over 4 s: their error is 1e-13/s for turns of 1e-3 rad/s, rounding is 1e-16/s.
TEST(Steering, RatesAreDerivatives) {
  const auto target_at = [](double t) { return OrbitMotion{{6.3e6, 1e5 + 20.0 * t, -5e3}, {0.0, 20.0, 0.0}, {}}; };
  const auto laws = {
      +[](double t, const OrbitMotion&) { return zero_doppler_attitude(turning(t), earth); },
      +[](double t, const OrbitMotion&) { return zero_doppler_attitude(turning(t), earth, FlightDirection::inertial); },
      +[](double t, const OrbitMotion&) { return nadir_attitude(turning(t), earth); },
      +[](double t, const OrbitMotion&) { return nadir_attitude(turning(t), earth, FlightDirection::inertial); },
      +[](double t, const OrbitMotion& target) { return look_at_attitude(turning(t), target); },
      +[](double t, const OrbitMotion&) {
        return rolled(nadir_attitude(turning(t), earth), {0.3 + 0.001 * t, 0.001});
      },
      +[](double t, const OrbitMotion&) {
        return pitched(nadir_attitude(turning(t), earth), {0.3 + 0.001 * t, 0.001});
      },
      +[](double t, const OrbitMotion&) {
        return yawed(nadir_attitude(turning(t), earth), {0.3 + 0.001 * t, 0.001});
      },
      +[](double t, const OrbitMotion&) { return with_z_up(nadir_attitude(turning(t), earth)); }};
  int number = 0;
  for (const auto& law : laws) {
    ++number;
    for (const double t : {0.0, 500.0, 2900.0}) {
      constexpr double h = 1.0;
      const auto matrix = [&](double s) { return law(t + s, target_at(t + s)).world_from_platform; };
      const auto pair = [&](double s) { return matrix(s) + (-1.0) * matrix(-s); };
      const Mat3 expected = (1.0 / (12.0 * h)) * (8.0 * pair(h) + (-1.0) * pair(2.0 * h));
      EXPECT_LT(largest_difference(law(t, target_at(t)).world_from_platform_rate, expected), 2e-11)
          << "law " << number << " at " << t;
    }
  }
}

TEST(ZeroDoppler, HasTheXAxisAlongTheVelocityAndZDown) {
  for (const auto& published : orbit_test::published_orbit_states) {
    const OrbitMotion motion = motion_of(published.earth_fixed);
    const Mat3 m = zero_doppler_attitude(motion, earth).world_from_platform;
    const double speed = core::norm(motion.velocity_mps);
    EXPECT_LT(core::norm(axis(m, 0) - (1.0 / speed) * motion.velocity_mps), 1e-15) << published.name;
    const double down = -core::dot(axis(m, 2), motion.position_m) / core::norm(motion.position_m);
    EXPECT_GT(down, 1.0 - 1e-5) << published.name;
    EXPECT_NEAR(core::dot(axis(m, 1), motion.position_m), 0.0, 1e-8) << published.name;
    EXPECT_GT(core::dot(axis(m, 1), core::cross(motion.velocity_mps, motion.position_m)), 0.0) << "right";
  }
}

TEST(ZeroDoppler, SeesNoDopplerAtAnyRange) {
  for (const auto& published : orbit_test::published_orbit_states)
    for (double look_deg = -60.0; look_deg <= 60.0; look_deg += 5.0) {
      const OrbitMotion motion = motion_of(published.earth_fixed);
      EXPECT_NEAR(doppler_hz(motion.velocity_mps, beam(zero_doppler_attitude(motion, earth), look_deg)), 0.0, 1e-10)
          << published.name << " " << look_deg;
    }
}

// Slant range, incidence, Doppler frequency without yaw steering, azimuth rate and effective speed of Sentinel-1B,
// computed independently (NumPy).
TEST(ZeroDoppler, HasTheGeometryOfSentinel1) {
  struct Row {
    double look_deg, range_km, incidence_deg, unsteered_hz, azimuth_rate_hz_per_s, effective_speed_mps;
  };
  constexpr Row rows[] = {{25.0, 784.8553, 27.959, -7452.36, -2386.887, 7207.891},
                          {30.0, 826.8470, 33.694, -8816.40, -2265.100, 7206.987},
                          {35.0, 882.2892, 39.529, -10113.35, -2121.735, 7205.242},
                          {40.0, 955.8742, 45.506, -11333.33, -1956.760, 7202.224}};
  const OrbitMotion motion = motion_of(sentinel_1b());
  for (const Row& row : rows) {
    const Vec3 direction = beam(zero_doppler_attitude(motion, earth), row.look_deg);
    const Ground ground = ground_along(motion.position_m, direction);
    EXPECT_NEAR(ground.range_m / 1000.0, row.range_km, 1e-4) << row.look_deg;
    EXPECT_NEAR(ground.incidence_rad / rad_per_deg, row.incidence_deg, 1e-3) << row.look_deg;
    const double range_acceleration = (core::dot(motion.velocity_mps, motion.velocity_mps) -
                                       ground.range_m * core::dot(motion.acceleration_mps2, direction)) /
                                      ground.range_m;
    EXPECT_NEAR(-2.0 / wavelength_m * range_acceleration, row.azimuth_rate_hz_per_s, 1e-3) << row.look_deg;
    EXPECT_NEAR(std::sqrt(ground.range_m * range_acceleration), row.effective_speed_mps, 1e-3) << row.look_deg;
    const OrbitAttitude unsteered = zero_doppler_attitude(motion, earth, FlightDirection::inertial);
    EXPECT_NEAR(doppler_hz(motion.velocity_mps, beam(unsteered, row.look_deg)), row.unsteered_hz, 0.01) << row.look_deg;
  }
}

// Doppler frequency of a degree of yaw and of pitch at a look angle of 30 deg.
TEST(ZeroDoppler, IsAsSensitiveAsKnown) {
  const OrbitMotion motion = motion_of(sentinel_1b());
  const OrbitAttitude steered = zero_doppler_attitude(motion, earth);
  const TurningAngle degree{rad_per_deg, 0.0};
  EXPECT_NEAR(std::abs(doppler_hz(motion.velocity_mps, beam(yawed(steered, degree), 30.0))), 2389.0, 1.0);
  EXPECT_NEAR(std::abs(doppler_hz(motion.velocity_mps, beam(pitched(steered, degree), 30.0))), 4138.0, 1.0);
}

TEST(Nadir, HasZDownAndXAhead) {
  const OrbitMotion motion = motion_of(sentinel_1b());
  for (const FlightDirection flight : {FlightDirection::earth_fixed, FlightDirection::inertial}) {
    const Mat3 m = nadir_attitude(motion, earth, flight).world_from_platform;
    EXPECT_LT(core::norm(axis(m, 2) + (1.0 / core::norm(motion.position_m)) * motion.position_m), 1e-15);
    const Vec3 v = flight == FlightDirection::inertial ? inertial_velocity_mps(motion, earth) : motion.velocity_mps;
    EXPECT_NEAR(core::dot(axis(m, 1), v), 0.0, 1e-11);
    EXPECT_GT(core::dot(axis(m, 0), v), 7000.0);
  }
}

TEST(InertialVelocity, IsThatOfThePublishedStates) {
  constexpr double speeds_mps[] = {7495.9160, 7503.4458, 7504.8239, 7460.2173, 7480.0284};
  int i = 0;
  for (const auto& published : orbit_test::published_orbit_states)
    EXPECT_NEAR(core::norm(inertial_velocity_mps(motion_of(published.earth_fixed), earth)), speeds_mps[i++], 1e-4)
        << published.name;
}

// The Earth's centre and axis may be anywhere in the world frame.
TEST(InertialVelocity, TakesTheEarthWhereItIs) {
  const OrbitMotion motion = motion_of(sentinel_1b());
  const Vec3 expected = inertial_velocity_mps(motion, earth);
  const Vec3 shift{1e6, -2e6, 3e6};
  const auto turned = [](const Vec3& v) { return Vec3{v.y, v.z, v.x}; };
  const OrbitMotion other{turned(motion.position_m) + shift, turned(motion.velocity_mps), {}};
  const TurningAxes moved{turned(earth.rotation_rad_per_s), shift};
  EXPECT_LT(core::norm(inertial_velocity_mps(other, moved) - turned(expected)), 1e-9);
}

// Angle about the nadir from the inertial to the Earth-fixed direction of flight.
double yaw_between_flights(const OrbitMotion& motion) {
  const Mat3 inertial = nadir_attitude(motion, earth, FlightDirection::inertial).world_from_platform;
  const Vec3 ahead = axis(nadir_attitude(motion, earth).world_from_platform, 0);
  return std::atan2(core::dot(ahead, axis(inertial, 1)), core::dot(ahead, axis(inertial, 0)));
}

TEST(YawSteering, IsTheYawToZeroDopplerOfThePublishedStates) {
  for (const auto& published : orbit_test::published_orbit_states) {
    const OrbitMotion motion = motion_of(published.earth_fixed);
    const double exact_deg = yaw_between_flights(motion) / rad_per_deg;
    EXPECT_NEAR(std::abs(exact_deg), published.yaw_to_zero_doppler_deg, 1e-4) << published.name;
    const auto k = osculating_elements({motion.position_m, inertial_velocity_mps(motion, earth)});
    ASSERT_TRUE(k.has_value());
    const double u = k->perigee_rad + true_anomaly_rad(k->mean_anomaly_rad, k->eccentricity);
    EarthGravity point;
    point.j2 = 0.0;
    const double n = j2_rates(*k, point).mean_anomaly_rad_per_s;
    const double formula_deg =
        yaw_steering_rad(k->inclination_rad, u, n / orbit_test::earth_rotation_rad_per_s) / rad_per_deg;
    // A tenth of the formula's own error: the published figures do not say how n and u were taken.
    EXPECT_NEAR(std::abs(formula_deg), published.yaw_formula_deg, 1e-3) << published.name;
    EXPECT_NEAR(formula_deg, exact_deg, 0.01) << published.name;  // the sign too
    EXPECT_EQ(exact_deg<0.0, motion.velocity_mps.z> 0.0) << published.name << ": to the left when ascending";
  }
}

// On a circular orbit the formula is exact.
TEST(YawSteering, IsExactOnCircles) {
  EarthGravity point;
  point.j2 = 0.0;
  for (const double inclination : {0.5, 1.2, 1.7, 2.4})
    for (double u = 0.0; u < 6.2; u += 0.4) {
      const KeplerElements k{7.1e6, 0.0, inclination, 0.3, 0.0, u};
      const OrbitState state = state_on_ellipse(k, point);
      const OrbitMotion motion{
          state.position_m, state.velocity_mps - core::cross(earth.rotation_rad_per_s, state.position_m), {}};
      const double ratio = j2_rates(k, point).mean_anomaly_rad_per_s / orbit_test::earth_rotation_rad_per_s;
      EXPECT_NEAR(yaw_between_flights(motion), yaw_steering_rad(inclination, u, ratio), 1e-13);
    }
}

TEST(LookAt, PointsZAtTheTarget) {
  const OrbitMotion motion = motion_of(sentinel_1b());
  const OrbitMotion target{{2.5e6, -5.7e6, -1.5e6}, {}, {}};
  const Mat3 m = look_at_attitude(motion, target).world_from_platform;
  const Vec3 sight = target.position_m - motion.position_m;
  EXPECT_LT(core::norm(axis(m, 2) - (1.0 / core::norm(sight)) * sight), 1e-15);
  EXPECT_NEAR(core::dot(axis(m, 1), motion.velocity_mps), 0.0, 1e-11);
  EXPECT_GT(core::dot(axis(m, 0), motion.velocity_mps), 0.0);
}

TEST(Attitude, TurnsAsItsWordsSay) {
  const OrbitAttitude level;  // x ahead, y right, z down are the world's axes
  constexpr TurningAngle small{0.1, 0.0};
  EXPECT_GT(axis(rolled(level, small).world_from_platform, 1).z, 0.0);   // the right side goes down
  EXPECT_LT(axis(rolled(level, small).world_from_platform, 2).y, 0.0);   // z moves to the left
  EXPECT_LT(axis(pitched(level, small).world_from_platform, 0).z, 0.0);  // the nose goes up
  EXPECT_GT(axis(pitched(level, small).world_from_platform, 2).x, 0.0);  // z turns towards x
  EXPECT_GT(axis(yawed(level, small).world_from_platform, 0).y, 0.0);    // the nose goes to the right
  const Mat3 up = with_z_up(level).world_from_platform;
  EXPECT_EQ(axis(up, 0), (Vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(axis(up, 1), (Vec3{0.0, -1.0, 0.0}));
  EXPECT_EQ(axis(up, 2), (Vec3{0.0, 0.0, -1.0}));
}

TEST(Attitude, IsARotationWhereDirectionsAreUndefined) {
  const OrbitMotion falling{{7.0e6, 0.0, 0.0}, {-100.0, 0.0, 0.0}, {}};
  const OrbitMotion resting{{7.0e6, 0.0, 0.0}, {}, {}};
  const OrbitMotion nowhere{};
  for (const OrbitMotion& motion : {falling, resting, nowhere})
    for (const OrbitAttitude& attitude :
         {zero_doppler_attitude(motion, earth), nadir_attitude(motion, earth), look_at_attitude(motion, motion)}) {
      const Mat3& m = attitude.world_from_platform;
      EXPECT_LT(largest_difference(m * core::transposed(m), Mat3{}), 1e-15);
    }
}

}  // namespace steering_test
}  // namespace sarsim::radar
