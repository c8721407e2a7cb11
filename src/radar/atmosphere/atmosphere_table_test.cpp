#include "radar/atmosphere/atmosphere_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/maths/random.hpp"

namespace sarsim::radar {
namespace atmosphere_table_test {

constexpr double radius_m = 6'371'000.0;
constexpr double flat = std::numeric_limits<double>::infinity();
constexpr double carrier_hz = 9.65e9;

Atmosphere air_only() {
  Atmosphere air;
  air.refraction = Refraction::exponential;
  return air;
}

Atmosphere everything() {
  Atmosphere all = air_only();
  all.gases = true;
  all.rain_rate_mm_per_h = 10.0;
  all.vertical_tec_per_m2 = 20.0 * tec_unit_per_m2;
  all.field_along_path_t = 40e-6;
  return all;
}

// Largest differences between a table and the path itself, over random paths that do not pass below the lowest height.
struct Errors {
  double delay_m = 0.0;
  double phase_m = 0.0;
  double loss_db = 0.0;
  double faraday_rad = 0.0;
  int paths = 0;
};

Errors errors_of(const AtmosphereTable& table, HeightSpan scatterers, HeightSpan radars, double max_m) {
  const core::RandomStream random(7, core::RandomKind::sweep_value, 1);
  Errors worst;
  for (int i = 0; i < 4000; ++i) {
    const auto [a, b] = random.uniforms(i, 0);
    const auto [e, unused] = random.uniforms(i, 1);
    const double hs = scatterers.low_m + a * (scatterers.high_m - scatterers.low_m);
    const double hr = radars.low_m + b * (radars.high_m - radars.low_m);
    const double distance_m = std::abs(hs - hr) + std::pow(max_m, e);
    const StraightPath path = table.path(hs, hr, distance_m);
    const Climb climb = climb_of(path);
    if (climb.height_at(climb.turn_m()) < std::min(0.0, scatterers.low_m)) continue;
    const PathEffect fast = table.at(hs, hr, distance_m), slow = table.model().effect(path);
    worst.delay_m = std::max(worst.delay_m, std::abs(fast.delay_m - slow.delay_m));
    worst.phase_m = std::max(worst.phase_m, std::abs(fast.phase_m - slow.phase_m));
    worst.loss_db = std::max(worst.loss_db, std::abs(fast.loss_db - slow.loss_db));
    worst.faraday_rad = std::max(worst.faraday_rad, std::abs(fast.faraday_rad - slow.faraday_rad));
    ++worst.paths;
  }
  return worst;
}

void expect_small(HeightSpan scatterers, HeightSpan radars, double max_m, double delay_m, double loss_db) {
  const AtmosphereTable table(everything(), carrier_hz, radius_m, scatterers, radars);
  const Errors worst = errors_of(table, scatterers, radars, max_m);
  EXPECT_GT(worst.paths, 1500);
  EXPECT_LT(worst.delay_m, delay_m);
  EXPECT_LT(worst.phase_m, delay_m);
  EXPECT_LT(worst.loss_db, loss_db);
  EXPECT_LT(worst.faraday_rad, 1e-15);
}

TEST(AtmosphereTable, IsThePathFromTheAir) { expect_small({0.0, 500.0}, {3000.0, 3100.0}, 200e3, 1e-9, 1e-5); }
TEST(AtmosphereTable, IsThePathFromSpace) { expect_small({0.0, 500.0}, {690e3, 710e3}, 2.4e6, 1e-9, 2e-5); }
TEST(AtmosphereTable, IsThePathBetweenAircraft) { expect_small({0.0, 12e3}, {0.0, 12e3}, 400e3, 1e-7, 4e-4); }
TEST(AtmosphereTable, IsThePathFromTheGroundUp) { expect_small({500.0, 9000.0}, {-30.0, 20.0}, 400e3, 1e-7, 4e-4); }
TEST(AtmosphereTable, IsThePathOfAHighWideSpan) { expect_small({0.0, 20e3}, {15e3, 36e6}, 1e6, 1e-7, 4e-4); }

// The error does not swing: what a Doppler shift or an interferogram sees. X band's 1e-4 of a wavelength is 3e-6 m.
TEST(AtmosphereTable, FollowsAMovingRadar) {
  const AtmosphereTable table(air_only(), carrier_hz, radius_m, {0.0, 500.0}, {3000.0, 3100.0});
  double last = 0.0, worst = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const double d = 4000.0 + 5.0 * i;
    const double error =
        table.at(120.0, 3050.0, d).phase_m - table.model().effect(table.path(120.0, 3050.0, d)).phase_m;
    if (i > 0) worst = std::max(worst, std::abs(error - last) / 5.0);
    last = error;
  }
  EXPECT_LT(worst, 1e-11);  // m for each m of distance
}

TEST(AtmosphereTable, ComputesWhatItDoesNotHold) {
  const AtmosphereTable table(everything(), carrier_hz, radius_m, {0.0, 500.0}, {3000.0, 3100.0});
  struct Case {
    double scatterer_m, radar_m, distance_m;
  };
  for (const auto& [hs, hr, d] :
       {Case{600.0, 3050.0, 9e3}, Case{100.0, 4000.0, 9e3}, Case{100.0, 3050.0, 700e3}, Case{100.0, 3050.0, 2800.0}}) {
    const PathEffect fast = table.at(hs, hr, d), slow = table.model().effect(table.path(hs, hr, d));
    EXPECT_EQ(fast.delay_m, slow.delay_m);
    EXPECT_EQ(fast.loss_db, slow.loss_db);
  }
  EXPECT_EQ(table.at(100.0, 3050.0, 0.0).delay_m, 0.0);
  const double nan = std::nan("");
  for (const PathEffect& effect : {table.at(100.0, nan, 9e3), table.at(nan, 3050.0, 9e3), table.at(100.0, 3050.0, nan)})
    EXPECT_TRUE(std::isnan(effect.delay_m) && std::isnan(effect.loss_db));
  // A radar above all air is in every table.
  EXPECT_NEAR(table.at(100.0, 700e3, 900e3).delay_m, table.model().effect(table.path(100.0, 700e3, 900e3)).delay_m,
              1e-9);
}

// Heights over an ellipsoid are not those over a sphere: a nadir path may be a little too short.
TEST(AtmosphereTable, TakesPathsThatAreALittleTooShort) {
  const AtmosphereTable table(air_only(), carrier_hz, radius_m, {0.0, 500.0}, {690e3, 710e3});
  for (const double d : {700e3, 699.9e3, 695e3})
    EXPECT_NEAR(table.at(0.0, 700e3, d).delay_m, table.model().effect(table.path(0.0, 700e3, d)).delay_m, 1e-9);
  EXPECT_NEAR(table.at(0.0, 700e3, 700e3).delay_m, 2.31525, 1e-9);
}

TEST(AtmosphereTable, KnowsEqualHeightsAndSinglePoints) {
  const AtmosphereTable table(air_only(), carrier_hz, radius_m, {1000.0, 1000.0}, {1000.0, 1000.0});
  for (const double d : {0.1, 10.0, 1e3, 50e3}) {
    const double truth_m = table.model().effect(table.path(1000.0, 1000.0, d)).delay_m;
    EXPECT_NEAR(table.at(1000.0, 1000.0, d).delay_m, truth_m, 1e-9) << d;
    EXPECT_NEAR(truth_m, 315e-6 * std::exp(-1000.0 / 7350.0) * d, 0.01 * truth_m);
  }
}

TEST(AtmosphereTable, WorksOverTheFlatEarth) {
  const AtmosphereTable table(everything(), carrier_hz, flat, {0.0, 500.0}, {3000.0, 3100.0});
  const PathEffect fast = table.at(100.0, 3050.0, 9e3),
                   slow = path_effect(everything(), carrier_hz, table.path(100.0, 3050.0, 9e3));
  EXPECT_EQ(fast.delay_m, slow.delay_m);
  EXPECT_EQ(fast.loss_db, slow.loss_db);
}

TEST(AtmosphereTable, TakesTheLinearModel) {
  Atmosphere linear = everything();
  linear.refraction = Refraction::linear;
  const AtmosphereTable table(linear, carrier_hz, radius_m, {0.0, 500.0}, {3000.0, 3100.0});
  EXPECT_EQ(table.at(100.0, 3050.0, 9e3).delay_m, table.model().effect(table.path(100.0, 3050.0, 9e3)).delay_m);
  EXPECT_GT(table.at(100.0, 3050.0, 9e3).delay_m, 0.0);
}

TEST(AtmosphereTable, OfNoAtmosphereIsNothing) {
  const AtmosphereTable table({}, carrier_hz, radius_m, {0.0, 500.0}, {3000.0, 3100.0});
  EXPECT_EQ(table.at(100.0, 3050.0, 9e3).delay_m, 0.0);
  EXPECT_EQ(table.at(100.0, 3050.0, 9e3).loss_db, 0.0);
}

TEST(AtmosphereTable, GrowsWithDistanceAndFallsWithHeight) {
  const AtmosphereTable table(everything(), carrier_hz, radius_m, {0.0, 500.0}, {3000.0, 3100.0});
  for (double d = 3500.0; d < 100e3; d += 500.0) {
    const PathEffect here = table.at(100.0, 3050.0, d), farther = table.at(100.0, 3050.0, d + 500.0);
    EXPECT_GT(farther.delay_m, here.delay_m);
    EXPECT_GT(farther.loss_db, here.loss_db);
    EXPECT_LT(table.at(300.0, 3050.0, d).delay_m, here.delay_m);
  }
}

}  // namespace atmosphere_table_test
}  // namespace sarsim::radar
