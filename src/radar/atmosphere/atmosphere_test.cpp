#include "radar/atmosphere/atmosphere.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace atmosphere_test {

constexpr double radius_m = 6'371'000.0;
constexpr double carrier_hz = 9.65e9;

StraightPath to_space(double elevation_deg) {
  return *path_at_elevation(0.0, elevation_deg * core::rad_per_deg, 700e3, radius_m);
}

Atmosphere everything() {
  Atmosphere all;
  all.refraction = Refraction::exponential;
  all.gases = true;
  all.rain_rate_mm_per_h = 10.0;
  all.vertical_tec_per_m2 = 20.0 * tec_unit_per_m2;
  all.field_along_path_t = 40e-6;
  return all;
}

TEST(PathEffect, OfNoAtmosphereIsNothing) {
  const PathEffect none = path_effect({}, carrier_hz, to_space(30.0));
  EXPECT_EQ(none.delay_m, 0.0);
  EXPECT_EQ(none.phase_m, 0.0);
  EXPECT_EQ(none.loss_db, 0.0);
  EXPECT_EQ(none.faraday_rad, 0.0);
}

TEST(PathEffect, OfNoDistanceIsNothing) {
  const PathEffect none = path_effect(everything(), carrier_hz, {100.0, 100.0, 0.0, radius_m});
  EXPECT_EQ(none.delay_m, 0.0);
  EXPECT_EQ(none.loss_db, 0.0);
}

TEST(PathEffect, TakesEachPartByItself) {
  const StraightPath path = to_space(30.0);
  Atmosphere one;
  one.refraction = Refraction::exponential;
  EXPECT_EQ(path_effect(one, carrier_hz, path).delay_m, excess_path_m(ExponentialRefractivity{}, path));
  EXPECT_EQ(path_effect(one, carrier_hz, path).phase_m, excess_path_m(ExponentialRefractivity{}, path));
  EXPECT_EQ(path_effect(one, carrier_hz, path).loss_db, 0.0);
  one.refraction = Refraction::linear;
  const LinearRefractivity linear{315.0, gradient_of_k_per_m(4.0 / 3.0)};
  EXPECT_EQ(path_effect(one, carrier_hz, path).delay_m, excess_path_m(linear, path));
  one = {};
  one.gases = true;
  EXPECT_EQ(path_effect(one, carrier_hz, path).loss_db, gas_loss_db(GasProfile(carrier_hz), path));
  one = {};
  one.rain_rate_mm_per_h = 10.0;
  EXPECT_EQ(path_effect(one, carrier_hz, path).loss_db, rain_loss_db({10.0, 5000.0, 0.0}, rain_laws(carrier_hz), path));
  one = {};
  one.vertical_tec_per_m2 = 10.0 * tec_unit_per_m2;
  const double group_m = 0.04328 * shell_factor(path);
  EXPECT_NEAR(path_effect(one, carrier_hz, path).delay_m, group_m, 1e-5);
  EXPECT_EQ(path_effect(one, carrier_hz, path).phase_m, -path_effect(one, carrier_hz, path).delay_m);
  EXPECT_EQ(path_effect(one, carrier_hz, path).faraday_rad, 0.0);
}

TEST(PathEffect, AddsItsParts) {
  const StraightPath path = to_space(20.0);
  const PathEffect all = path_effect(everything(), carrier_hz, path);
  Atmosphere dry = everything(), air = everything(), vacuum = everything();
  dry.rain_rate_mm_per_h = 0.0;
  air.vertical_tec_per_m2 = 0.0;
  vacuum.refraction = Refraction::none;
  const double iono_m = path_effect(vacuum, carrier_hz, path).delay_m;
  EXPECT_NEAR(all.delay_m, path_effect(air, carrier_hz, path).delay_m + iono_m, 1e-14);
  EXPECT_NEAR(all.phase_m, path_effect(air, carrier_hz, path).delay_m - iono_m, 1e-14);
  EXPECT_GT(all.loss_db, path_effect(dry, carrier_hz, path).loss_db + 0.1);
  EXPECT_GT(all.faraday_rad, 0.0);
}

TEST(PathEffect, UsesTheNumbersOfTheAtmosphere) {
  const StraightPath path = to_space(20.0);
  const PathEffect all = path_effect(everything(), carrier_hz, path);
  Atmosphere other = everything();
  other.surface_refractivity = 360.0;
  EXPECT_GT(path_effect(other, carrier_hz, path).delay_m, all.delay_m);
  other = everything();
  other.scale_height_m = 8000.0;
  EXPECT_GT(path_effect(other, carrier_hz, path).delay_m, all.delay_m);
  other = everything();
  other.surface_vapour_kg_per_m3 = 0.02;
  EXPECT_GT(path_effect(other, carrier_hz, path).loss_db, all.loss_db);
  other = everything();
  other.rain_top_m = 2000.0;
  EXPECT_LT(path_effect(other, carrier_hz, path).loss_db, all.loss_db);
  other = everything();
  other.polarisation_tilt_rad = core::pi / 2.0;
  EXPECT_LT(path_effect(other, carrier_hz, path).loss_db, all.loss_db);
  other = everything();
  other.shell_height_m = 350e3;
  EXPECT_GT(path_effect(other, carrier_hz, path).faraday_rad, all.faraday_rad);
  other = everything();
  other.refraction = Refraction::linear;
  other.k_factor = 1.2;
  Atmosphere usual = other;
  usual.k_factor = 4.0 / 3.0;
  EXPECT_GT(path_effect(other, carrier_hz, path).delay_m, path_effect(usual, carrier_hz, path).delay_m);
}

// What the echoes of two scatterers tell: at 30 and 31 degrees the delays differ by 0.135 m.
TEST(PathEffect, IsDifferentialInsideAScene) {
  Atmosphere air;
  air.refraction = Refraction::exponential;
  const double near_m = path_effect(air, carrier_hz, to_space(31.0)).delay_m;
  const double far_m = path_effect(air, carrier_hz, to_space(30.0)).delay_m;
  EXPECT_NEAR(far_m - near_m, 2.31525 * (1.0 / std::sin(core::pi / 6.0) - 1.0 / std::sin(31.0 * core::rad_per_deg)),
              2e-3);
}

}  // namespace atmosphere_test
}  // namespace sarsim::radar
