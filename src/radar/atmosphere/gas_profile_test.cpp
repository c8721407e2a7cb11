#include "radar/atmosphere/gas_profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/atmosphere/gas.hpp"

namespace sarsim::radar {
namespace gas_profile_test {

constexpr double radius_m = 6'371'000.0;
constexpr double flat = std::numeric_limits<double>::infinity();

double true_loss(double ghz, double height_m) { return gas_loss(1e9 * ghz, reference_air(height_m)).sum_db_per_m(); }

// Largest errors in the layers: over the layer's largest value, and as a sum of losses over the whole column.
struct LayerErrors {
  double worst = 0.0;
  double share_of_column = 0.0;
};

LayerErrors layer_errors(double ghz, double vapour) {
  const GasProfile profile(1e9 * ghz, vapour);
  LayerErrors errors;
  for (double base_m = 0.0; base_m < reference_top_m; base_m = next_reference_break_m(base_m)) {
    const double top_m = next_reference_break_m(base_m);
    double error = 0.0, largest = 0.0;
    for (int i = 0; i < 40; ++i) {
      const double height_m = base_m + (i + 0.5) / 40.0 * (top_m - base_m);
      const double truth = gas_loss(1e9 * ghz, reference_air(height_m, vapour)).sum_db_per_m();
      largest = std::max(largest, truth);
      error = std::max(error, std::abs(profile.value(height_m) - truth));
    }
    errors.worst = std::max(errors.worst, error / largest);
    errors.share_of_column += error * (top_m - base_m);
  }
  errors.share_of_column /= profile.column_db(reference_top_m) - profile.column_db(0.0);
  return errors;
}

TEST(GasProfile, FollowsTheSpecificAttenuation) {
  for (const double vapour : {0.0, 7.5e-3, 25e-3})
    for (const double ghz : {1.257, 5.405, 9.65, 16.0, 22.23508, 35.0, 60.3, 94.0, 118.75, 183.31}) {
      const LayerErrors errors = layer_errors(ghz, vapour);
      EXPECT_LT(errors.worst, 3e-2) << ghz << ' ' << vapour;
      EXPECT_LT(errors.share_of_column, 1e-5) << ghz << ' ' << vapour;
    }
}

TEST(GasProfile, IsPreciseInTheLowAirWhereTheLossIs) {
  for (const double ghz : {1.257, 5.405, 9.65, 16.0, 22.23508, 35.0, 94.0}) {
    const GasProfile profile(1e9 * ghz);
    for (double height_m = -400.0; height_m < 18e3; height_m += 117.0)
      EXPECT_NEAR(profile.value(height_m), true_loss(ghz, height_m), 5e-6 * true_loss(ghz, height_m)) << ghz;
  }
}

TEST(GasProfile, HasTheColumnOfItsValues) {
  const GasProfile profile(9.65e9);
  double sum_db = 0.0;
  for (int i = 0; i < 100'000; ++i) sum_db += profile.value(i + 0.5);
  EXPECT_NEAR(profile.column_db(100e3) - profile.column_db(0.0), sum_db, 1e-7 * sum_db);
  EXPECT_EQ(profile.column_db(200e3), profile.column_db(100e3));
  EXPECT_NEAR(profile.column_db(3000.0) - profile.column_db(1000.0), 2000.0 * profile.value(2000.0), 1e-3);
  EXPECT_EQ(profile.value(100.1e3), 0.0);
  EXPECT_EQ(profile.value(-9000.0), profile.value(-2000.0));
  EXPECT_NEAR(profile.column_db(-3000.0), -1000.0 * profile.value(-2000.0), 1e-15);
}

TEST(GasLossOfPath, IsTheIntegral) {
  const GasProfile profile(9.65e9);
  const Climb climb = climb_of({100.0, 4000.0, 60e3, radius_m});
  double sum_db = 0.0;
  constexpr int steps = 20'000;
  for (int i = 0; i < steps; ++i) sum_db += 60e3 / steps * true_loss(9.65, climb.height_at((i + 0.5) * 60e3 / steps));
  EXPECT_NEAR(gas_loss_db(profile, {100.0, 4000.0, 60e3, radius_m}), sum_db, 1e-7 * sum_db);
  EXPECT_NEAR(gas_loss_db(profile, {4000.0, 100.0, 60e3, radius_m}), sum_db, 1e-7 * sum_db);
}

TEST(GasLossOfPath, IsTheColumnOverTheFlatEarth) {
  const GasProfile profile(9.65e9);
  EXPECT_NEAR(gas_loss_db(profile, {0.0, 3000.0, 9000.0, flat}),
              3.0 * (profile.column_db(3000.0) - profile.column_db(0.0)), 1e-12);
  EXPECT_NEAR(gas_loss_db(profile, {500.0, 500.0, 9000.0, flat}), 9000.0 * profile.value(500.0), 1e-12);
  EXPECT_NEAR(gas_loss_db(profile, {500.0, 500.999999, 9000.0, flat}),
              gas_loss_db(profile, {500.0, 501.000001, 9000.0, flat}), 1e-9);
  EXPECT_NEAR(gas_loss_db(profile, {0.0, 3000.0, 9000.0, 1e14}), gas_loss_db(profile, {0.0, 3000.0, 9000.0, flat}),
              1e-9);
  EXPECT_EQ(gas_loss_db(profile, {200e3, 300e3, 150e3, flat}), 0.0);
}

// The straight line against the bent ray of P.676, both leaving at the same elevation: the bent one stays low for
// longer. Shells in their middles make 9e-6 of the loss to the zenith.
TEST(GasLossOfPath, IsNearlyThatOfTheBentRay) {
  const GasProfile profile(28e9);
  const auto ratio = [&](double elevation_deg) {
    const double elevation = elevation_deg * core::rad_per_deg;
    const auto path = path_at_elevation(0.0, elevation, 700e3, radius_m);
    return gas_loss_db(profile, *path) / slant_gas_loss_db(28e9, elevation);
  };
  EXPECT_NEAR(ratio(90.0), 1.0, 2e-5);
  EXPECT_NEAR(ratio(30.0), 0.99976, 2e-5);
  EXPECT_NEAR(ratio(10.0), 0.99747, 2e-4);
  EXPECT_NEAR(ratio(5.0), 0.9910, 1e-3);
  EXPECT_NEAR(ratio(1.0), 0.937, 3e-3);
}

}  // namespace gas_profile_test
}  // namespace sarsim::radar
