#include "radar/motion/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/maths/constants.hpp"
#include "radar/motion/motion_test_support.hpp"

namespace sarsim::radar {
namespace rotation_test {

using motion_test::difference;

constexpr double quarter_turn = core::pi / 2.0;

TEST(RotationAngles, GiveTheMatrixBack) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-7.0, 7.0);
  for (int i = 0; i < 300; ++i) {
    const core::Mat3 m = world_from_platform({angle(random), angle(random), angle(random)});
    EXPECT_LT(difference(world_from_platform(rotation_angles_rad(m)), m), 2e-15);
  }
}

TEST(RotationAngles, AreTheOnesWithinTheirRange) {
  for (const std::array<double, 3>& a : {std::array{0.1, 0.2, 0.3}, std::array{-3.0, -1.5, 3.0}}) {
    const auto got = rotation_angles_rad(world_from_platform(a));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(got[i], a[i], 1e-14);
  }
}

TEST(RotationAngles, GiveTheMatrixBackAtAndBesideGimbalLock) {
  for (const double off : {0.0, 1e-17, 1e-15, 1e-12, 1e-8, 1e-4})
    for (const double side : {-1.0, 1.0}) {
      const core::Mat3 m = world_from_platform({0.7, side * (quarter_turn - off), -2.0});
      EXPECT_LT(difference(world_from_platform(rotation_angles_rad(m)), m), 2e-15) << off;
    }
  const core::Mat3 lock{{core::Vec3{0, 0, -1}, core::Vec3{0, 1, 0}, core::Vec3{1, 0, 0}}};
  EXPECT_EQ(rotation_angles_rad(lock)[0], 0.0);
  EXPECT_LT(difference(world_from_platform(rotation_angles_rad(lock)), lock), 1e-15);
}

TEST(RotationRates, AreThoseThatMadeTheMatrix) {
  const std::array<double, 3> angles{0.4, -1.1, 2.5}, rates{0.7, -0.3, 1.9};
  const TurningMatrix m = turning_matrix(angles, rates);
  EXPECT_EQ(m.matrix, world_from_platform(angles));
  EXPECT_EQ(m.rate, world_from_platform_rate(angles, rates));
  const auto got = rotation_rates_rad_per_s(m, rotation_angles_rad(m.matrix));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(got[i], rates[i], 1e-14);
}

// At the lock a roll looks like a yaw: the yaw has it.
TEST(RotationRates, CountTheRollAsNothingAtGimbalLock) {
  const TurningMatrix m = turning_matrix({0.0, quarter_turn, 0.5}, {0.2, 0.0, 0.3});
  const auto got = rotation_rates_rad_per_s(m, rotation_angles_rad(m.matrix));
  EXPECT_EQ(got[0], 0.0);
  EXPECT_NEAR(got[2], 0.5, 1e-15);
}

TEST(TurningMatrix, ProductHasTheDerivativeOfTheProduct) {
  const std::array<double, 3> a{0.3, 0.2, -0.8}, ra{0.5, 1.0, -0.4}, b{1.3, -0.2, 0.1}, rb{-0.6, 0.3, 0.9};
  const auto at = [](const std::array<double, 3>& x, const std::array<double, 3>& r, double t) {
    return world_from_platform({x[0] + r[0] * t, x[1] + r[1] * t, x[2] + r[2] * t});
  };
  constexpr double h = 1e-5;
  const core::Mat3 quotient = (0.5 / h) * (at(a, ra, h) * at(b, rb, h) + -1.0 * (at(a, ra, -h) * at(b, rb, -h)));
  const TurningMatrix product = turning_matrix(a, ra) * turning_matrix(b, rb);
  EXPECT_LT(difference(product.rate, quotient), 1e-9);  // h^2/6 times the cube of 3 rad/s, and rounding
  EXPECT_LT(difference(product.matrix, at(a, ra, 0.0) * at(b, rb, 0.0)), 1e-15);
}

}  // namespace rotation_test
}  // namespace sarsim::radar
