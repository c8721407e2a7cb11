#include "workflow/verify/own_path.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::workflow::verify {
namespace own_path_test {

constexpr long double c = core::exact_light_speed_mps;

TEST(OwnPath, HasTheClosedFormOfUniformMotions) {
  const Place radar_mps{300.0L, 7600.0L, -20.0L};
  const Place target_mps{-2000.0L, 150.0L, 400.0L};
  const Place r{650e3L, 240e3L, -90e3L};
  // docs/theory/echo-model.md, light time.
  const long double along = dot_of(r, target_mps);
  const long double rest = c * c - dot_of(target_mps, target_mps);
  const long double out_s = (along + std::sqrt(along * along + dot_of(r, r) * rest)) / rest;
  const Place r1 = r + out_s * target_mps;
  const long double expected_s =
      2.0L * (c * c * out_s - dot_of(r1, radar_mps)) / (c * c - dot_of(radar_mps, radar_mps));
  const long double found_s = two_way_s(straight_motion({}, radar_mps), straight_motion(r, target_mps), 0.0L);
  EXPECT_NEAR(static_cast<double>(found_s / expected_s - 1.0L), 0.0, 1e-15);
}

TEST(OwnPath, OfARecedingTargetIsShiftedByItsDopplerFactor) {
  const double v = 3000.0;
  const double carrier_hz = 10e9;
  const Motion target = straight_motion({50e3L, 0.0L, 0.0L}, {v, 0.0L, 0.0L});
  const double delay_s = 1e5 / (core::exact_light_speed_mps - v);
  const auto middle = echo_received(at_rest({}), target, 0.0, delay_s, carrier_hz);
  const auto later = echo_received(at_rest({}), target, 0.0, delay_s + 1e-6, carrier_hz);
  const double shift_hz = -2.0 * v / (core::exact_light_speed_mps + v) * carrier_hz;
  EXPECT_NEAR(std::arg(later * std::conj(middle)), 2.0 * core::pi * shift_hz * 1e-6, 1e-6);
}

TEST(OwnPath, TurnsRightHandedly) {
  const Place turned_x = turned({1.0L, 0.0L, 0.0L}, {0.0L, 0.0L, 1.0L}, core::pi / 2.0);
  EXPECT_NEAR(static_cast<double>(turned_x.y), 1.0, 1e-15);
  EXPECT_NEAR(static_cast<double>(turned_x.x), 0.0, 1e-15);
}

}  // namespace own_path_test
}  // namespace sarsim::workflow::verify
