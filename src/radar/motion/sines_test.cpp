#include "radar/motion/sines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace sines_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::vector<Sine> mixed() {
  return {{SineAxis::x, 2.0, 0.5, 0.3},
          {SineAxis::x, 0.4, -1.7, 1.0},
          {SineAxis::z, 1.5, 0.1, 0.0},
          {SineAxis::roll, 0.2, 0.08, -2.0},
          {SineAxis::yaw, 0.1, 3.0, 0.0}};
}

std::vector<core::Jet> all_jets(double t) {
  const SineState s = sines_at(mixed(), t);
  return {s.position_m[0], s.position_m[1], s.position_m[2], s.rotation_rad[0], s.rotation_rad[1], s.rotation_rad[2]};
}

TEST(Sines, AreSummedOnTheirAxes) {
  constexpr double t = 1.234;
  const SineState s = sines_at(mixed(), t);
  const double w = 2.0 * core::pi * t;
  EXPECT_NEAR(s.position_m[0].value, 2.0 * std::sin(0.5 * w + 0.3) + 0.4 * std::sin(-1.7 * w + 1.0), 1e-14);
  EXPECT_EQ(s.position_m[1].value, 0.0);
  EXPECT_NEAR(s.position_m[2].value, 1.5 * std::sin(0.1 * w), 1e-14);
  EXPECT_NEAR(s.rotation_rad[0].value, 0.2 * std::sin(0.08 * w - 2.0), 1e-14);
  EXPECT_EQ(s.rotation_rad[1].value, 0.0);
  EXPECT_NEAR(s.rotation_rad[2].value, 0.1 * std::sin(3.0 * w), 1e-14);
}

// Third derivatives below 0.4 (2 pi 1.7)^3 + 2 pi^3 + ... = 1000: h^2/6 of it, and rounding.
TEST(Sines, DerivativesAreQuotients) {
  constexpr double h = 1e-4;
  for (const double t : {-20.0, 0.0, 3.3}) {
    const auto before = all_jets(t - h), now = all_jets(t), then = all_jets(t + h);
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_NEAR((then[i].value - before[i].value) / (2.0 * h), now[i].slope, h * h * 170.0 + 4.0 * epsilon / h);
      EXPECT_NEAR((then[i].slope - before[i].slope) / (2.0 * h), now[i].curvature, h * h * 2000.0 + 80.0 * epsilon / h);
    }
  }
}

TEST(Sines, KeepTheirPhaseForDays) {
  const std::vector<Sine> one{{SineAxis::y, 1.0, 0.25, 0.7}};
  EXPECT_EQ(sines_at(one, 4.0 * 1e5).position_m[1].value, sines_at(one, 0.0).position_m[1].value);
}

TEST(Sines, StayWithinTheBoundOfTheirAcceleration) {
  const double bound = acceleration_bound_mps2(mixed());
  for (double t = 0.0; t < 60.0; t += 0.01) {
    const SineState s = sines_at(mixed(), t);
    EXPECT_LE(std::hypot(s.position_m[0].curvature, s.position_m[1].curvature, s.position_m[2].curvature), bound);
  }
}

// The mean over many periods of all of them: 1000 s.
TEST(Sines, HaveTheVarianceOfTheirAmplitudes) {
  double sum = 0.0;
  constexpr int looks = 100'000;
  for (int i = 0; i < looks; ++i) sum += std::pow(sines_at(mixed(), 0.01 * i).position_m[0].value, 2);
  EXPECT_NEAR(variance(mixed(), SineAxis::x), 0.5 * (4.0 + 0.16), 1e-15);
  EXPECT_NEAR(sum / looks, variance(mixed(), SineAxis::x), 1e-3);
  EXPECT_EQ(variance(mixed(), SineAxis::pitch), 0.0);
}

}  // namespace sines_test
}  // namespace sarsim::radar
