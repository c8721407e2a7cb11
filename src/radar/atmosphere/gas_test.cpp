#include "radar/atmosphere/gas.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/atmosphere/gas_lines.hpp"

namespace sarsim::radar {
namespace gas_test {

constexpr AirState standard{101'325.0, 288.15, 7.5e-3};

TEST(GasLines, AreAscending) {
  for (std::size_t i = 1; i < oxygen_lines.size(); ++i)
    EXPECT_GT(oxygen_lines[i].frequency_ghz, oxygen_lines[i - 1].frequency_ghz);
  for (std::size_t i = 1; i < vapour_lines.size(); ++i)
    EXPECT_GT(vapour_lines[i].frequency_ghz, vapour_lines[i - 1].frequency_ghz);
}

// ITU-R SG3's validation examples CG-3M3J-13-ValEx-Rev8.3.0, sheet "P.676-13 SpAtt".
TEST(GasLoss, HasTheValuesOfTheValidationExamples) {
  struct Case {
    double frequency_ghz, oxygen, vapour;
  };
  for (const auto& [ghz, oxygen, vapour] :
       {Case{12, 0.00869826406877357, 0.00953538822024593}, Case{20, 0.0118835504778076, 0.0970473048151117},
        Case{60, 14.6234747964861, 0.154841841}, Case{90, 0.0388697110724235, 0.341973394},
        Case{130, 0.0415090835995228, 0.751844704}}) {
    const GasLoss loss = gas_loss(1e9 * ghz, standard);
    EXPECT_NEAR(1e3 * loss.oxygen_db_per_m, oxygen, 1e-13 * 1e2 * oxygen) << ghz;
    EXPECT_NEAR(1e3 * loss.vapour_db_per_m, vapour, 3e-9 * vapour) << ghz;
    EXPECT_DOUBLE_EQ(loss.sum_db_per_m(), loss.oxygen_db_per_m + loss.vapour_db_per_m);
  }
}

// By ITU-Rpy 0.4.0, where single terms rule: Debye's spectrum (1.257), wings of lines, interference (60 GHz), Zeeman
// splitting and Doppler width (thin air), the line for all above 1 THz (325, 500), nitrogen (500).
TEST(GasLoss, IsThatOfAnotherProgram) {
  struct Case {
    double frequency_ghz;
    AirState air;
    double oxygen, vapour;
  };
  constexpr Case cases[] = {{1.257, standard, 0.005960213558975685, 8.0489611090083e-05},
                            {5.405, standard, 0.007455362616628078, 0.0015440326705403538},
                            {9.65, standard, 0.008151529964132008, 0.005485846947984217},
                            {22.23508, {50'000, 255, 1.5e-3}, 0.00455842960494723, 0.06403985109181218},
                            {35, {70'000, 300, 12e-3}, 0.013694672417856116, 0.08104870783253164},
                            {118.75, {30'000, 230, 0.2e-3}, 2.185653459615532, 0.008503431751192714},
                            {183.31, {80'000, 270, 4e-3}, 0.010308811054376279, 20.220820185162975},
                            {60.306056, {50, 250, 1e-7}, 1.120092923439767, 1.4078475892970754e-09},
                            {22.23508, {5, 220, 1e-7}, 6.411957407353945e-10, 0.034647913918770014},
                            {325.2, standard, 0.03013770118472503, 37.96487937777235},
                            {500, {101'325, 288.15, 0}, 0.09027242845764595, 0.0}};
  for (const auto& [ghz, air, oxygen, vapour] : cases) {
    const GasLoss loss = gas_loss(1e9 * ghz, air);
    EXPECT_NEAR(1e3 * loss.oxygen_db_per_m, oxygen, 1e-10 * oxygen) << ghz;
    EXPECT_NEAR(1e3 * loss.vapour_db_per_m, vapour, 1e-10 * vapour) << ghz;
  }
}

TEST(GasLoss, OfNothingIsNothing) {
  EXPECT_EQ(gas_loss(10e9, reference_air(200e3)).sum_db_per_m(), 0.0);
  EXPECT_EQ(gas_loss(10e9, {101'325.0, 288.15, 0.0}).vapour_db_per_m, 0.0);
}

// Sheet "P.676-13 A_Gas_A1_2.2.1a", example 1.
TEST(SlantGasLoss, HasTheValueOfTheValidationExample) {
  EXPECT_NEAR(slant_gas_loss_db(28e9, 30.0 * core::rad_per_deg), 0.47081173472870474, 1e-9);
}

TEST(SlantGasLoss, FallsWithElevationAndHeight) {
  double last_db = 1e9;
  for (const double elevation_deg : {0.0, 0.5, 2.0, 5.0, 10.0, 30.0, 60.0, 90.0}) {
    const double loss_db = slant_gas_loss_db(28e9, elevation_deg * core::rad_per_deg);
    EXPECT_LT(loss_db, last_db);
    EXPECT_LT(slant_gas_loss_db(28e9, elevation_deg * core::rad_per_deg, 500.0), loss_db);
    last_db = loss_db;
  }
  EXPECT_GT(slant_gas_loss_db(28e9, 0.5, 0.0, 15e-3), slant_gas_loss_db(28e9, 0.5));
  EXPECT_EQ(slant_gas_loss_db(28e9, 0.5, 100e3), 0.0);
}

// At the zenith nothing bends: a ray from inside a shell loses what lies below it.
TEST(SlantGasLoss, BeginsInsideAShell) {
  const double zenith = core::pi / 2.0;
  const double below_db = slant_gas_loss_db(28e9, zenith) - slant_gas_loss_db(28e9, zenith, 1234.5);
  double sum_db = 0.0;
  for (int i = 0; i < 1000; ++i) sum_db += 1.2345 * gas_loss(28e9, reference_air((i + 0.5) * 1.2345)).sum_db_per_m();
  EXPECT_NEAR(below_db, sum_db, 1e-6);
}

}  // namespace gas_test
}  // namespace sarsim::radar
