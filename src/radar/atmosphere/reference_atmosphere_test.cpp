#include "radar/atmosphere/reference_atmosphere.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sarsim::radar {
namespace reference_atmosphere_test {

double total_pa(const AirState& air) { return air.dry_pressure_pa + air.vapour_pressure_pa(); }

// By ITU-Rpy 0.4.0's P.835-6.
TEST(ReferenceAir, IsThatOfTheRecommendation) {
  struct Case {
    double height_km, temperature_k, pressure_hpa;
  };
  constexpr Case cases[] = {{0, 288.15, 1013.25},
                            {5, 255.67554322180348, 540.482809123109},
                            {11, 216.77351270445553, 226.99955507088836},
                            {15, 216.65, 121.1192943739718},
                            {25, 221.55206472628424, 25.492652174567194},
                            {40, 250.34964610242113, 2.871516854550676},
                            {50, 270.65, 0.7978217810352219},
                            {60, 247.02088477279676, 0.21959579859019995},
                            {75, 208.39913079860182, 0.02388280690863121},
                            {90, 186.8673, 0.0018359967260182521},
                            {95, 188.41827640311323, 0.0007596655323041114},
                            {100, 195.08134433524688, 0.0003201243640545924}};
  for (const auto& [height_km, temperature_k, pressure_hpa] : cases) {
    const AirState air = reference_air(1e3 * height_km);
    EXPECT_NEAR(air.temperature_k, temperature_k, 1e-10) << height_km;
    EXPECT_NEAR(total_pa(air), 100.0 * pressure_hpa, 1e-9 * pressure_hpa) << height_km;
  }
}

TEST(ReferenceAir, HasItsVapour) {
  EXPECT_EQ(reference_air(0.0).vapour_kg_per_m3, 7.5e-3);
  EXPECT_NEAR(reference_air(4000.0).vapour_kg_per_m3, 7.5e-3 * std::exp(-2.0), 1e-15);
  EXPECT_NEAR(reference_air(0.0, 0.02).vapour_pressure_pa(), 20.0 * 288.15 / 2.167, 1e-9);
  const AirState high = reference_air(60e3);
  EXPECT_NEAR(high.vapour_pressure_pa(), 2e-6 * total_pa(high), 1e-15 * total_pa(high));
}

// The printed pressures of the layers meet to 1.6e-5.
TEST(ReferenceAir, IsContinuous) {
  for (double height_m = next_reference_break_m(-2000.0); height_m < reference_top_m;
       height_m = next_reference_break_m(height_m)) {
    const AirState below = reference_air(height_m - 1e-3), above = reference_air(height_m + 1e-3);
    EXPECT_NEAR(below.temperature_k, above.temperature_k, height_m == 86e3 ? 0.1 : 2e-3) << height_m;
    EXPECT_NEAR(total_pa(below) / total_pa(above), 1.0, height_m == 86e3 ? 1e-3 : 2e-5) << height_m;
  }
}

TEST(ReferenceAir, FallsAndEnds) {
  double last_pa = 1e9;
  for (double height_m = -1000.0; height_m <= 100e3; height_m += 250.0) {
    const double pressure_pa = total_pa(reference_air(height_m));
    EXPECT_LT(pressure_pa, last_pa);
    last_pa = pressure_pa;
  }
  EXPECT_EQ(total_pa(reference_air(100.001e3)), 0.0);
}

TEST(RefractivityOf, IsOfDryAndMoistAir) {
  EXPECT_NEAR(refractivity_of({101'325.0, 288.15, 0.0}), 77.6 * 1013.25 / 288.15, 1e-10);
  const double e_hpa = 7.5 * 288.15 / 216.7;
  EXPECT_NEAR(refractivity_of({101'325.0, 288.15, 7.5e-3}),
              (77.6 * 1013.25 + 72.0 * e_hpa + 3.75e5 * e_hpa / 288.15) / 288.15, 1e-10);
  EXPECT_NEAR(refractivity_of(reference_air(0.0)), 315.0, 5.0);
}

TEST(NextReferenceBreak, ReachesTheTopInFewSteps) {
  int steps = 0;
  double height_m = -2000.0;
  while (height_m < reference_top_m) {
    const double next_m = next_reference_break_m(height_m);
    ASSERT_GT(next_m, height_m);
    height_m = next_m;
    ++steps;
  }
  EXPECT_EQ(height_m, reference_top_m);
  EXPECT_LT(steps, 45);
  EXPECT_TRUE(std::isinf(next_reference_break_m(reference_top_m)));
}

}  // namespace reference_atmosphere_test
}  // namespace sarsim::radar
