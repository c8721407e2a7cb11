#include "radar/target/reflectivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace reflectivity_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const core::Interpolator none;

TEST(Incidence, IsZeroFacingTheRadarAndHalfATurnFacingAway) {
  EXPECT_EQ(incidence_rad({0, -1, 0}, {0, 500, 0}), 0.0);
  EXPECT_EQ(incidence_rad({0, 1, 0}, {0, 500, 0}), core::pi);
  EXPECT_NEAR(incidence_rad({1, 0, 0}, {0, 500, 0}), 0.5 * core::pi, epsilon);
  EXPECT_NEAR(incidence_rad({0, 0, 1}, {300, 0, -300}), 0.25 * core::pi, 4.0 * epsilon);
}

TEST(Incidence, IsSafeForTheNullVectorAndForRoundedUnitVectors) {
  EXPECT_EQ(incidence_rad({0, 0, 1}, {}), 0.0);
  EXPECT_EQ(incidence_rad({0, -(1.0 + 1e-15), 0}, {0, 7, 0}), 0.0);
  EXPECT_EQ(incidence_rad({0, 1.0 + 1e-15, 0}, {0, 7, 0}), core::pi);
}

TEST(Incidence, IsPreciseWhereTheScattererFacesTheRadar) {
  for (const double angle : {1e-3, 1e-6, 1e-9}) {
    EXPECT_NEAR(incidence_rad({std::sin(angle), -std::cos(angle), 0}, {0, 7, 0}), angle, 4.0 * epsilon * angle);
    EXPECT_NEAR(incidence_rad({std::sin(angle), std::cos(angle), 0}, {0, 7, 0}), core::pi - angle, 4.0 * epsilon);
  }
}

TEST(Reflectivity, FollowsTheCosineInFrontAndIsNothingBehind) {
  EXPECT_EQ(reflectivity(ReflectivityLaw::cosine, none, 0.0), 1.0);
  EXPECT_NEAR(reflectivity(ReflectivityLaw::cosine, none, core::pi / 3.0), 0.5, 2.0 * epsilon);
  EXPECT_EQ(reflectivity(ReflectivityLaw::cosine, none, 0.6 * core::pi), 0.0);
  EXPECT_EQ(reflectivity(ReflectivityLaw::isotropic, none, 3.0), 1.0);
}

TEST(Reflectivity, ReadsTheUsersCurveInDegreesAndPowerDecibels) {
  const core::Interpolator curve(
      core::SampledFunction{core::Interpolation::linear, {{0.0, 0.0}, {90.0, -30.0}, {180.0, 10.0}}});
  EXPECT_NEAR(reflectivity(ReflectivityLaw::user, curve, core::pi / 6.0), 0.1, 0.1 * 20.0 * epsilon);
  EXPECT_NEAR(reflectivity(ReflectivityLaw::user, curve, core::pi), 10.0, 10.0 * 20.0 * epsilon);
}

}  // namespace reflectivity_test
}  // namespace sarsim::radar
