#include "radar/atmosphere/rain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace rain_test {

constexpr double radius_m = 6'371'000.0;
constexpr double flat = std::numeric_limits<double>::infinity();

// By ITU-Rpy 0.4.0's P.838-3 (each also in P.838-3's table 5 to four digits where that has the frequency).
TEST(RainLaw, IsThatOfTheRecommendation) {
  struct Case {
    double frequency_ghz, elevation_deg, tilt_deg, k, alpha;
  };
  constexpr Case cases[] = {{1.257, 0, 0, 3.2794875370711333e-05, 0.9934191970733929},
                            {1.257, 0, 90, 4.136876892269973e-05, 0.8750852159648512},
                            {1.257, 30, 45, 3.708182214670553e-05, 0.9274120426674531},
                            {5.405, 0, 0, 0.0003484223147605278, 1.6606677843932516},
                            {5.405, 0, 90, 0.00029186474861054104, 1.5840153871386942},
                            {5.405, 60, 20, 0.00032555923284372586, 1.6328884759678477},
                            {9.65, 0, 0, 0.010422169612847391, 1.2756406497952038},
                            {9.65, 0, 90, 0.009518643781858354, 1.2390666462712074},
                            {9.65, 60, 20, 0.010056924315108323, 1.2616471464708672},
                            {35, 0, 0, 0.3373869929620646, 0.9047129598171396},
                            {35, 0, 90, 0.3223760497327524, 0.8761420000004876},
                            {94, 30, 45, 1.3176819845472942, 0.6858083445086207}};
  for (const auto& [ghz, elevation_deg, tilt_deg, k, alpha] : cases) {
    const double sine = std::sin(elevation_deg * core::rad_per_deg);
    const RainLaw law = rain_law(rain_laws(1e9 * ghz), sine, tilt_deg * core::rad_per_deg);
    EXPECT_NEAR(law.k, k, 1e-12 * k) << ghz;
    EXPECT_NEAR(law.alpha, alpha, 1e-12) << ghz;
  }
}

// ITU-R SG3's validation example (CG-3M3J-13), 14.25 GHz.
TEST(RainLoss, HasTheValuesOfTheValidationExamples) {
  struct Case {
    double frequency_ghz, elevation_deg, rate, loss_db_per_km;
  };
  for (const auto& [ghz, elevation_deg, rate, loss] :
       {Case{14.25, 30.87067768, 30.875024, 1.879742}, Case{14.25, 40.97052773, 56.370009, 3.630988},
        Case{14.25, 47.91280491, 55.231625, 3.503189}, Case{29.0, 30.87067768, 30.875024, 5.814832}}) {
    const RainLaw law = rain_law(rain_laws(1e9 * ghz), std::sin(elevation_deg * core::rad_per_deg), 0.0);
    EXPECT_NEAR(1e3 * rain_loss_db_per_m(law, rate), loss, 6e-7);
  }
}

TEST(RainLaw, DependsOnPolarisationAtTheHorizonOnly) {
  const RainLaws laws = rain_laws(9.65e9);
  EXPECT_NEAR(rain_law(laws, 1.0, 0.0).k, rain_law(laws, 1.0, core::pi / 2.0).k, 1e-17);
  EXPECT_NEAR(rain_law(laws, 0.0, 0.0).k, laws.horizontal.k, 1e-17);
  EXPECT_NEAR(rain_law(laws, 0.0, core::pi / 2.0).alpha, laws.vertical.alpha, 1e-15);
  EXPECT_GT(laws.horizontal.k, laws.vertical.k);
}

TEST(RainLoss, IsOfThePartBelowTheTop) {
  const RainLaws laws = rain_laws(9.65e9);
  const UniformRain rain{20.0, 4000.0, 0.0};
  const auto up = path_at_elevation(0.0, core::pi / 6.0, 700e3, radius_m);
  const double sine = 0.5, r1 = radius_m, r2 = radius_m + 4000.0;
  const double inside_m = -r1 * sine + std::sqrt(r1 * r1 * (sine * sine - 1.0) + r2 * r2);
  const double each = rain_loss_db_per_m(rain_law(laws, sine, 0.0), 20.0);
  EXPECT_NEAR(rain_loss_db(rain, laws, *up), each * inside_m, 1e-8 * each * inside_m);
  EXPECT_NEAR(inside_m, 8000.0, 8.0);  // the curvature takes 3/4 of h^2/R off there
  EXPECT_EQ(rain_loss_db(rain, laws, {4000.0, 700e3, 800e3, radius_m}), 0.0);
  EXPECT_EQ(rain_loss_db(rain, laws, {1000.0, 1000.0, 0.0, flat}), 0.0);
  EXPECT_EQ(rain_loss_db({0.0, 4000.0, 0.0}, laws, *up), 0.0);
}

TEST(RainLoss, GrowsWithRateAndFrequency) {
  double last = 0.0;
  for (const double ghz : {1.257, 5.405, 9.65, 16.0, 35.0, 94.0}) {
    const double loss = rain_loss_db_per_m(rain_laws(1e9 * ghz).horizontal, 10.0);
    EXPECT_GT(loss, last);
    EXPECT_GT(rain_loss_db_per_m(rain_laws(1e9 * ghz).horizontal, 20.0), loss);
    last = loss;
  }
  EXPECT_EQ(rain_laws(0.5e9).horizontal.k, rain_laws(1e9).horizontal.k);
}

}  // namespace rain_test
}  // namespace sarsim::radar
