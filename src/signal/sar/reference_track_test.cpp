#include "signal/sar/reference_track.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::signal {
namespace reference_track_test {

std::vector<TrackPoint> turn_by(double angle_rad, std::size_t pulses) {
  std::vector<TrackPoint> track;
  for (std::size_t p = 0; p < pulses; ++p) {
    const double t = static_cast<double>(p) / static_cast<double>(pulses - 1) - 0.5;
    const double a = angle_rad * t;
    track.push_back({t, {500.0 * std::sin(a), 500.0 * std::cos(a), 40.0}, {}});
  }
  return track;
}

TEST(Straightness, IsTheChordOverTheWayOfATurn) {
  for (const double degrees : {1.0, 30.0, 50.0, 120.0, 270.0}) {
    const double half = 0.5 * degrees / core::deg_per_rad;
    // Eight chords in place of the arc.
    EXPECT_NEAR(straightness(turn_by(2.0 * half, 801)), std::sin(half) / (8.0 * std::sin(half / 8.0)), 1e-9) << degrees;
  }
  EXPECT_NEAR(straightness(turn_by(2.0 * core::pi, 801)), 0.0, 1e-9);
  EXPECT_LT(straightness(turn_by(55.0 / core::deg_per_rad, 801)), min_straightness);
  EXPECT_GT(straightness(turn_by(45.0 / core::deg_per_rad, 801)), min_straightness);
}

// A drone at 5 m/s that is blown to and fro by a metre, faster than it flies.
TEST(Straightness, OfALineThatSwaysIsThatOfALine) {
  std::vector<TrackPoint> track;
  for (int p = 0; p < 2000; ++p) {
    const double t = 0.01 * p;
    track.push_back({t, {5.0 * t, std::sin(2.0 * core::pi * t), 30.0}, {}});
  }
  EXPECT_GT(straightness(track), 0.99);
  EXPECT_EQ(straightness(std::vector<TrackPoint>(1)), 0.0);
  EXPECT_EQ(straightness(std::vector<TrackPoint>(5)), 0.0);
}

}  // namespace reference_track_test
}  // namespace sarsim::signal
