// What changes a recording's random numbers and what does not.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "support/scenes.hpp"

namespace sarsim {
namespace independence_test {

using namespace test;

// Noise, a jittering platform with two fluctuating targets.
scene::Scene random_scene(std::uint64_t seed = 1) {
  scene::Scene scene = radar_at_origin();
  scene.options.seed = seed;
  scene.radars[0].noise_temperature_k = 300.0;
  scene::Platform& shaking = add_platform(scene, "Shaking", {1000.0, 0.0, 0.0});
  shaking.position_stddev_m = {0.01, 0.01, 0.01};
  for (int i = 0; i < 2; ++i) {
    scene::Target& target = add_target(scene, {20.0 * i, 5.0, 0.0}, 1.0, "Shaking");
    target.traits.edit().position_stddev_m = {0.01, 0.02, 0.03};
    target.traits.edit().rcs_stddev_m2 = 0.2;
  }
  set_pulses(scene, 0, 19);
  return scene;
}

bool same_bytes(const simulate::Recording& a, const simulate::Recording& b) {
  return a.samples.size() == b.samples.size() &&
         std::memcmp(a.samples.data(), b.samples.data(), a.samples.size() * sizeof(a.samples[0])) == 0;
}

TEST(Seed, OfOneValueGivesOneRecordingByteForByte) {
  EXPECT_TRUE(same_bytes(recorded(random_scene(7)), recorded(random_scene(7))));
  EXPECT_FALSE(same_bytes(recorded(random_scene(7)), recorded(random_scene(8))));
}

TEST(Seed, GivesTheSameBytesForAnyNumberOfThreads) {
  scene::Scene scene = random_scene();
  set_pulses(scene, 0, 4000);  // several blocks of rows
  raster::RunControl control;
  control.threads = 1;
  const simulate::Recording one = simulate::record(simulate::make_plan(scene, 0), control);
  for (const unsigned threads : {2U, 5U}) {
    control.threads = threads;
    EXPECT_TRUE(same_bytes(one, simulate::record(simulate::make_plan(scene, 0), control))) << threads;
  }
}

TEST(AddedTarget, LeavesEveryOtherEchoAndTheNoiseAsTheyWere) {
  const simulate::Recording before = recorded(random_scene());
  scene::Scene larger = random_scene();
  add_target(larger, {1100.0, 30.0, 0.0}, 4.0);
  const simulate::Recording after = recorded(larger);
  scene::Scene alone = radar_at_origin();
  add_target(alone, {1100.0, 30.0, 0.0}, 4.0);
  set_pulses(alone, 0, 19);
  const simulate::Recording echo = recorded(alone);
  ASSERT_EQ(after.samples.size(), before.samples.size());
  for (std::size_t i = 0; i < after.samples.size(); ++i)
    EXPECT_LT(std::abs(after.samples[i] - before.samples[i] - echo.samples[i]), 1e-14 * after.report.maximum_v) << i;
}

TEST(AddedPlatform, LeavesTheJitterOfTheOthersAsItWas) {
  const simulate::Recording before = recorded(random_scene());
  scene::Scene larger = random_scene();
  scene::Platform extra;
  extra.name = "Extra";
  extra.position_stddev_m = {1.0, 1.0, 1.0};
  larger.platforms.insert(larger.platforms.begin(), extra);
  EXPECT_TRUE(same_bytes(before, recorded(larger)));
}

TEST(MovedWindow, SeesTheSameNoiseAtTheSameSamplesAndPulses) {
  const scene::Scene scene = random_scene();
  const simulate::Recording whole = recorded(scene);
  // Seven samples and three pulses later.
  scene::Scene part = scene;
  part.simulations[0].range_start_m = 7.0 * 0.5 * core::exact_light_speed_mps / part.simulations[0].sample_rate_hz;
  set_pulses(part, 3, 12);
  const simulate::Recording cut = recorded(part);
  ASSERT_EQ(cut.report.rows, 10u);
  ASSERT_EQ(cut.report.columns + 7, whole.report.columns);
  for (std::size_t row = 0; row < cut.report.rows; ++row)
    for (std::size_t i = 0; i < cut.report.columns; ++i) {
      const auto expected = whole.samples[(row + 3) * whole.report.columns + i + 7];
      EXPECT_LT(std::abs(cut.samples[row * cut.report.columns + i] - expected), 1e-14 * whole.report.maximum_v);
    }
}

TEST(ChangedWindow, OfTheMatchedFilterKeepsTheNoiseUnderTheSamples) {
  scene::Scene scene = random_scene();
  scene.simulations[0].processing = scene::Processing::matched_filter;
  const simulate::Recording whole = recorded(scene);
  scene.simulations[0].range_end_m -= 500.0;
  const simulate::Recording cut = recorded(scene);
  for (std::size_t i = 0; i < cut.report.columns; ++i)
    EXPECT_LT(std::abs(cut.samples[i] - whole.samples[i]), 1e-13 * whole.report.maximum_v) << i;
}

}  // namespace independence_test
}  // namespace sarsim
