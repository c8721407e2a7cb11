#include "simulate/resolve/platform_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/maths/constants.hpp"

namespace sarsim::simulate {
namespace platform_motion_test {

using core::Vec3;

constexpr double deg = core::rad_per_deg;

// Each is 1 m ahead of the one before, and turned by 2 degrees.
scene::Scene chain(std::size_t links) {
  scene::Scene scene;
  scene.platforms.clear();
  for (std::size_t i = 0; i < links; ++i) {
    scene::Platform platform;
    platform.name = "Q" + std::to_string(i);
    if (i > 0) platform.parent = "Q" + std::to_string(i - 1);
    platform.position_m = {1.0, 0.0, 0.0};
    platform.rotation[2] = core::Angle::from_deg(2.0);
    scene.platforms.push_back(platform);
  }
  return scene;
}

// Yaw turns +x to -y. The first is not turned by its own yaw.
Vec3 place_of_last(std::size_t links, double yaw_of_first_rad) {
  Vec3 sum{1.0, 0.0, 0.0};
  for (std::size_t i = 1; i < links; ++i) {
    const double yaw = yaw_of_first_rad + 2.0 * deg * static_cast<double>(i - 1);
    sum = sum + Vec3{std::cos(yaw), -std::sin(yaw), 0.0};
  }
  return sum;
}

TEST(PlatformMotion, CarriesTheLongestChainThatMoves) {
  constexpr std::size_t links = 64;
  scene::Scene scene = chain(links);
  scene.platforms[0].rotation_rate[2] = core::Angle::from_deg(30.0);
  const auto tracks = tracks_of(scene, {});
  constexpr double time_s = 1.5, rate = 30.0 * deg;
  const Vec3 place = place_of_last(links, 2.0 * deg + rate * time_s);
  const Vec3 arm = place - Vec3{1.0, 0.0, 0.0};
  const radar::Pose pose = tracks.back().at(time_s, 0);
  EXPECT_LT(core::norm(pose.position_world_m - place), 1e-12);
  EXPECT_LT(core::norm(pose.velocity_world_mps - rate * Vec3{arm.y, -arm.x, 0.0}), 1e-12);
  radar::Track::ErrorSteps steps;
  const radar::PoseAcceleration acceleration = tracks.back().acceleration_at(time_s, 0, pose, steps);
  EXPECT_LT(core::norm(acceleration.acceleration_world_mps2 + rate * rate * arm), 1e-11);
}

// The last comes first: each needs the one behind it. Nested calls would need more stack than there is.
TEST(PlatformMotion, CarriesAnyChainThatRests) {
  constexpr std::size_t links = 30'000;
  scene::Scene scene = chain(links);
  std::ranges::reverse(scene.platforms);
  const auto tracks = tracks_of(scene, {});
  ASSERT_TRUE(tracks.front().fixed());
  EXPECT_LT(core::norm(tracks.front().at(0.0, 0).position_world_m - place_of_last(links, 2.0 * deg)), 1e-6);
}

}  // namespace platform_motion_test
}  // namespace sarsim::simulate
