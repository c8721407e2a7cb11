#include "radar/path/light_time.hpp"

#include <random>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace light_time_test {

constexpr double c = core::exact_light_speed_mps;

// A place that changes as a quadratic of time, in extended precision.
struct Moving {
  core::Vec3 place, velocity, acceleration;

  [[nodiscard]] std::array<long double, 3> at(long double t) const {
    const auto part = [t](double p, double v, double a) { return p + t * (v + 0.5L * t * a); };
    return {part(place.x, velocity.x, acceleration.x), part(place.y, velocity.y, acceleration.y),
            part(place.z, velocity.z, acceleration.z)};
  }
};

long double between(const std::array<long double, 3>& a, const std::array<long double, 3>& b) {
  long double sum = 0.0L;
  for (std::size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

// The light-time equation by iteration: two-way delay of what leaves at t0.
long double delay_from(const Moving& radar, const Moving& point, long double t0) {
  long double t1 = t0;
  for (int i = 0; i < 30; ++i) t1 = t0 + between(point.at(t1), radar.at(t0)) / c;
  long double t2 = t1;
  for (int i = 0; i < 30; ++i) t2 = t1 + between(radar.at(t2), point.at(t1)) / c;
  return t2 - t0;
}

core::Vec3 random_vector(std::mt19937& random, double scale) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  return {scale * unit(random), scale * unit(random), scale * unit(random)};
}

core::Vec3 double_of(const std::array<long double, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

TEST(FlightOf, EvenMotionsIsTheSolutionOfTheLightTimeEquation) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const double speed = std::pow(10.0, trial % 8);
    const Moving radar{random_vector(random, 1e6), random_vector(random, speed), {}};
    const Moving point{random_vector(random, 1e6), random_vector(random, speed), {}};
    const double anchor_s = 1e-3;
    const core::Vec3 look = double_of(point.at(anchor_s)) - radar.place;
    const Flight flight = flight_of(look, {point.velocity, anchor_s, radar.velocity, radar.velocity}, c);
    const long double delay = delay_from(radar, point, 0.0L);
    // Rounding of the place and of the times.
    EXPECT_NEAR(flight.delay_s, static_cast<double>(delay), 1e-15 * flight.delay_s + 4e-10 / c) << speed;
    EXPECT_NEAR(flight.path.length_m(), c * flight.delay_s, 1e-15 * flight.path.length_m());
    EXPECT_NEAR(flight.path.out_m, core::norm(flight.line_of_sight_m), 8e-16 * flight.path.out_m);
    const long double h = 1e-6L;
    const long double slope = (delay_from(radar, point, h) - delay_from(radar, point, -h)) / (2.0L * h);
    EXPECT_NEAR(flight.doppler, static_cast<double>(slope / (1.0L + slope)), 3e-15 + 1e-13 * std::pow(speed / 1e5, 3));
  }
}

TEST(FlightOf, ResetsToTwiceTheDistanceOverCWhereNothingMoves) {
  const Flight flight = flight_of({3000.0, 4000.0, 0.0}, {}, c);
  EXPECT_EQ(flight.delay_s, 1e4 / c);
  EXPECT_EQ(flight.doppler, 0.0);
  EXPECT_EQ(flight.path.out_m, 5000.0);
  EXPECT_EQ(flight.path.back_m, 5000.0);
}

// Closed forms of radial motion: tau = 2 d/(c - v), D = 2 v/(c + v).
TEST(FlightToResting, IsTheFlightToAPointWithoutVelocity) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 500; ++trial) {
    const core::Vec3 look = random_vector(random, 1e6);
    const core::Vec3 way = random_vector(random, std::pow(10.0, trial % 8)), slope = 1.01 * way;
    const Flight general = flight_of(look, {{}, 1e-3, way, slope}, c);
    const Flight found = flight_to_resting(look, way, slope, c);
    EXPECT_NEAR(found.delay_s, general.delay_s, 4e-16 * general.delay_s);
    EXPECT_NEAR(found.path.back_m, general.path.back_m, 1e-15 * general.delay_s * c);
    EXPECT_EQ(found.path.out_m, core::norm(look));
    EXPECT_EQ(found.line_of_sight_m, look);
    EXPECT_NEAR(found.doppler, general.doppler, 4e-16 + 4e-16 * std::abs(general.doppler));
  }
}

TEST(FlightOf, AlongTheLineOfSightHasTheClosedForms) {
  for (const double v : {-7000.0, -30.0, 2.0, 15'000.0}) {
    const Flight flight = flight_of({0.0, 1e5, 0.0}, {{0.0, v, 0.0}, 0.0, {}}, c);
    EXPECT_NEAR(flight.delay_s, 2e5 / (c - v), 2e-16 * flight.delay_s);
    EXPECT_NEAR(flight.doppler, 2.0 * v / (c + v), 1e-19);
    EXPECT_NEAR(speed_of_doppler_factor(flight.doppler, c), v, 1e-12 * std::abs(v));
  }
}

// Findings of a satellite: 7.6 km/s abeam of a point 800 km away, the delay of the thesis is short by V^2 d/c^2 each
// way.
TEST(FlightOf, ASatelliteAbeamIsLaterThanTheThesisSaysByTwiceVSquaredDOverCCubed) {
  const double v = 7600.0, d = 8e5;
  const Flight exact = flight_of({0.0, d, 0.0}, {{}, 0.0, {v, 0.0, 0.0}, {v, 0.0, 0.0}}, c);
  const Flight thesis = thesis_flight_of({0.0, d, 0.0}, {-v, 0.0, 0.0}, c);
  EXPECT_NEAR(exact.delay_s - thesis.delay_s, 2.0 * v * v * d / (c * c * c), 1e-18);
  EXPECT_NEAR(0.5 * c * (exact.delay_s - thesis.delay_s), 0.514e-3, 1e-6);  // 0.208 rad at 9.65 GHz
}

TEST(BendOf, IsTheSecondDerivativeOfTheDelay) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const Moving radar{random_vector(random, 1e4), random_vector(random, 300.0), random_vector(random, 10.0)};
    const Moving point{random_vector(random, 1e4), random_vector(random, 300.0), random_vector(random, 100.0)};
    const long double h = 1e-2L;
    const long double second =
        (delay_from(radar, point, h) - 2.0L * delay_from(radar, point, 0.0L) + delay_from(radar, point, -h)) / (h * h);
    const FlightMotion motion{point.velocity,     0.0, radar.velocity, radar.velocity, point.acceleration,
                              radar.acceleration, 0.0};
    const double bend = bend_of(point.place - radar.place, motion, c);
    EXPECT_NEAR(bend, static_cast<double>(second), 1e-5 * std::abs(bend) + 1e-10);
  }
}

// A satellite and a plate a hundred kilometres wide that falls: what holds for the middle is bent to its ends.
TEST(Bend, CarriesAFlightToTimesBesideTheAnchor) {
  const Moving radar{{0.0, 0.0, 0.0}, {7600.0, 100.0, 0.0}, {0.0, -8.0, 3.0}};
  for (const double beside : {-5e4, 2e4}) {
    const Moving point{{3e4, 7e5 + beside, -2e5}, {200.0, -900.0, 30.0}, {5.0, 90.0, -40.0}};
    const double anchor_s = 2.4e-3, back_s = 4.8e-3;
    FlightMotion motion;
    motion.anchor_s = anchor_s;
    motion.back_s = back_s;
    motion.point_mps = point.velocity + anchor_s * point.acceleration;
    motion.radar_mps = radar.velocity + 0.5 * back_s * radar.acceleration;
    motion.radar_slope_mps = motion.radar_mps;
    motion.point_mps2 = point.acceleration;
    motion.radar_mps2 = radar.acceleration;
    Flight flight = flight_of(double_of(point.at(anchor_s)) - radar.place, motion, c);
    const auto off = [&] { return std::abs(flight.delay_s - static_cast<double>(delay_from(radar, point, 0.0L))); };
    const double before_s = off();
    bend(flight, motion, c);
    EXPECT_GT(before_s, 1e-14);
    EXPECT_LT(off(), 1e-3 * before_s);
    const long double h = 1e-4L;
    const long double slope = (delay_from(radar, point, h) - delay_from(radar, point, -h)) / (2.0L * h);
    EXPECT_NEAR(flight.doppler, static_cast<double>(slope / (1.0L + slope)), 1e-13);
  }
}

}  // namespace light_time_test
}  // namespace sarsim::radar
