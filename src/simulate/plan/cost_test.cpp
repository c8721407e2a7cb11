#include <gtest/gtest.h>

#include "simulate/plan/plan.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

// Estimates are compared with each other: how long a machine takes is another matter on each, and on a busy one.

namespace sarsim::simulate {
namespace cost_test {

// Chirps of 300 samples, 20 pulses, `count` targets around 1 km.
scene::Scene scene_of(int count) {
  scene::Scene scene = one_target_scene();
  scene.targets.clear();
  for (int i = 0; i < count; ++i) scene.targets.push_back(target_on("Earth", {1000.0 + 0.01 * i, 0.0, 0.0}));
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 50e6;
  scene.radars[0].pulse_width_s = 5e-6;
  scene.simulations[0].sample_rate_hz = 60e6;
  scene.simulations[0].time_end_s = 0.0195;
  return scene;
}

// Of all pulses, without what comes before the first.
double seconds(const scene::Scene& scene, Engine engine) {
  const Cost cost = estimated_cost(make_plan(scene, 0, nullptr, engine), 1);
  return cost.seconds_one_thread - cost.start_seconds;
}

// docs/developer/performance.md: 18 ns against 0.13 to 0.5 ns for an echo and sample, 6 to 30 ns for an echo.
TEST(Cost, IsThatOfTheEngineThatWasChosen) {
  const scene::Scene scene = scene_of(20000);
  const double reference_s = seconds(scene, Engine::reference);
  const double direct_s = seconds(scene, Engine::direct);
  const double spectral_s = seconds(scene, Engine::spectral);
  EXPECT_GT(reference_s, 50.0 * direct_s);
  EXPECT_LT(reference_s, 300.0 * direct_s);
  EXPECT_GT(reference_s, 300.0 * spectral_s);
  EXPECT_LT(reference_s, 2000.0 * spectral_s);
  const double echoes = 20000.0 * 20.0;
  EXPECT_GT(spectral_s, 6e-9 * echoes);
  EXPECT_LT(spectral_s, 50e-9 * echoes);
}

TEST(Cost, OfTheAutomaticChoiceIsTheLeast) {
  for (const int targets : {1, 10, 100, 1000, 10000}) {
    const scene::Scene scene = scene_of(targets);
    const double min_s = std::min(seconds(scene, Engine::direct), seconds(scene, Engine::spectral));
    const double chosen_s = seconds(scene, Engine::automatic);
    if (make_plan(scene, 0, nullptr, Engine::automatic).engine.engine == Engine::reference) continue;  // no SIMD
    // Nobody asks for the least where all is cheap.
    EXPECT_LE(chosen_s, min_s + 20.0 * 20e-6) << targets;
  }
}

TEST(Cost, GrowsWithPulsesTargetsAndNoise) {
  const scene::Scene scene = scene_of(1000);
  scene::Scene longer = scene;
  longer.simulations[0].time_end_s = 0.1995;
  scene::Scene more = scene_of(10000);
  scene::Scene noisy = scene;
  noisy.radars[0].noise_temperature_k = 290.0;
  scene::Scene compressed = scene;
  compressed.simulations[0].processing = scene::Processing::matched_filter;
  for (const Engine engine : {Engine::direct, Engine::spectral}) {
    const double once_s = seconds(scene, engine);
    EXPECT_NEAR(seconds(longer, engine), 10.0 * once_s, 1e-6 * once_s);
    EXPECT_GT(seconds(more, engine), 2.0 * once_s);
    EXPECT_LT(seconds(more, engine), 10.5 * once_s);
    EXPECT_GT(seconds(noisy, engine), once_s);
    EXPECT_GT(seconds(compressed, engine), once_s);
  }
}

TEST(Cost, HasMemoryForTargetsCloudsAndThreads) {
  const auto bytes = [](const scene::Scene& scene, unsigned threads) {
    return estimated_cost(make_plan(scene, 0, nullptr, Engine::direct), threads).memory_bytes;
  };
  const double least = bytes(scene_of(1), 1);
  EXPECT_GT(least, 5e6);
  EXPECT_LT(least, 15e6);
  EXPECT_NEAR(bytes(scene_of(100'000), 1) - least, 100e3 * 340.0, 100e3 * 100.0);
  EXPECT_GT(bytes(scene_of(100'000), 16), bytes(scene_of(100'000), 1) + 20e6);
}

// Platforms are looked at before the pulses, whose memory comes after; a filter needs the library of transforms.
TEST(Cost, HasMemoryForPlatformsAndFilters) {
  const auto bytes = [](const scene::Scene& scene) {
    return estimated_cost(make_plan(scene, 0, nullptr, Engine::direct), 1).memory_bytes;
  };
  scene::Scene scene = scene_of(1000);
  const double least = bytes(scene);
  scene.platforms.resize(101, scene.platforms[0]);
  EXPECT_NEAR(bytes(scene) - least, 7e6, 1e6);
  scene = scene_of(1000);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  EXPECT_NEAR(bytes(scene) - least, 5e6, 1e6);
}

// A surface is looked at from the front, from behind, or from both sides in turn.
TEST(Cost, LeavesOutBacksOfSurfaces) {
  scene::Scene scene = scene_of(0);
  scene::Surface& surface = scene.surfaces.emplace_back();
  surface.platform = "Earth";
  surface.corner_m = {core::Vec3{1000.0, -50.0, 0.0}, core::Vec3{1000.0, 50.0, 0.0}, core::Vec3{1000.0, -50.0, 100.0}};
  const double one_s = seconds(scene, Engine::direct);
  std::swap(surface.corner_m[1], surface.corner_m[2]);
  const double other_s = seconds(scene, Engine::direct);
  EXPECT_GT(std::max(one_s, other_s), 20.0 * std::min(one_s, other_s));
}

}  // namespace cost_test
}  // namespace sarsim::simulate
