#include "simulate/plan/engine.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "simulate/run/run.hpp"

namespace sarsim::simulate {
namespace engine_test {

// A chirp of 20 us at 30 MHz, 3 km of window, 10 pulses, and `count` targets in a row.
scene::Scene scene_with(int count, scene::Radar::Pulse pulse = scene::Radar::Pulse::chirp) {
  scene::Scene scene = one_target_scene();
  scene.targets.clear();
  for (int i = 0; i < count; ++i) scene.targets.push_back(target_on("Earth", {1000.0 + 2000.0 * i / count, 0.0, 0.0}));
  scene.radars[0].pulse = pulse;
  scene.radars[0].bandwidth_hz = 25e6;
  scene.radars[0].pulse_width_s = 20e-6;
  scene.simulations[0].range_start_m = 500.0;
  scene.simulations[0].range_end_m = 6500.0;
  scene.simulations[0].time_end_s = 0.009;
  scene.simulations[0].sample_rate_hz = 30e6;
  return scene;
}

EngineChoice choice(const scene::Scene& scene, Engine wanted = Engine::automatic) {
  return make_plan(scene, 0, nullptr, wanted).engine;
}

TEST(ChooseEngine, TakesWhatIsAskedForWhateverItCosts) {
  for (const Engine engine : {Engine::reference, Engine::direct, Engine::spectral}) {
    EXPECT_EQ(choice(scene_with(1), engine).engine, engine);
    EXPECT_EQ(choice(scene_with(5000), engine).engine, engine);
    EXPECT_EQ(choice(scene_with(1), engine).reason, "asked for");
  }
}

class AutomaticEngine : public testing::Test {
 protected:
  void SetUp() override {
    if (simd_level() == "scalar") GTEST_SKIP() << "no SIMD here: always the reference";
  }
};

TEST_F(AutomaticEngine, IsDirectForFewEchoes) {
  const EngineChoice few = choice(scene_with(3));
  EXPECT_EQ(few.engine, Engine::direct);
  EXPECT_NE(few.reason.find("3 echoes a pulse of 600 samples"), std::string::npos) << few.reason;
}

TEST_F(AutomaticEngine, IsSpectralForManyEchoesOfALongPulse) {
  const EngineChoice many = choice(scene_with(20000));
  EXPECT_EQ(many.engine, Engine::spectral);
  EXPECT_NE(many.reason.find("20000 echoes"), std::string::npos) << many.reason;
  EXPECT_NE(many.reason.find("than 7 transforms of 1801 points"), std::string::npos) << many.reason;
}

TEST_F(AutomaticEngine, IsDirectForManyEchoesOfAPulseTooShortForABody) {
  scene::Scene scene = scene_with(20000, scene::Radar::Pulse::mono);
  scene.radars[0].pulse_width_s = 10.0 / 30e6;
  EXPECT_EQ(choice(scene).engine, Engine::direct) << choice(scene).reason;
}

TEST_F(AutomaticEngine, IsDirectForABarkerCodeWithAnEdgeForEveryFewSamples) {
  scene::Scene scene = scene_with(20000, scene::Radar::Pulse::barker);
  scene.radars[0].pulse_width_s = 13.0 * 10.0 / 30e6;
  EXPECT_EQ(choice(scene).engine, Engine::direct) << choice(scene).reason;
}

TEST_F(AutomaticEngine, IsSpectralForABandLimitedPulseWithFewerEchoes) {
  scene::Scene scene = scene_with(160);
  scene.options.pulse = scene::PulseDefinition::band_limited;
  EXPECT_EQ(choice(scene).engine, Engine::spectral) << choice(scene).reason;
  scene.options.pulse = scene::PulseDefinition::ideal;
  EXPECT_EQ(choice(scene).engine, Engine::direct) << choice(scene).reason;
}

TEST_F(AutomaticEngine, IsDirectWhereTargetsMoveTooDifferently) {
  scene::Scene scene = scene_with(20000);
  scene.platforms.push_back(moving("Missile", {2000.0, 0.0, 0.0}, {-60e3, 0.0, 0.0}));
  scene.radars[0].carrier_hz = 35e9;
  scene.radars[0].pulse_width_s = 150e-6;
  scene.simulations[0].range_end_m = 30e3;
  EXPECT_EQ(choice(scene).engine, Engine::spectral) << choice(scene).reason;
  for (std::size_t i = 0; i < scene.targets.size(); i += 2) scene.targets[i] = target_on("Missile", {500.0, 0.0, 0.0});
  EXPECT_EQ(choice(scene).engine, Engine::direct) << choice(scene).reason;
}

TEST(EngineName, NamesGoThereAndBack) {
  for (const Engine engine : {Engine::automatic, Engine::reference, Engine::direct, Engine::spectral})
    EXPECT_EQ(engine_from_name(name_of(engine)), engine);
  EXPECT_EQ(name_of(Engine::automatic), "auto");
  EXPECT_EQ(engine_from_name("fastest"), std::nullopt);
  EXPECT_EQ(engine_from_name(""), std::nullopt);
  EXPECT_EQ(engine_from_name("Direct"), std::nullopt);
}

TEST(SimdLevel, IsTheBestOfTheListAndUnknownOnesAreRefused) {
  const std::vector<std::string> levels = simd_levels();
  ASSERT_FALSE(levels.empty());
  EXPECT_EQ(levels.front(), simd_level());
  EXPECT_FALSE(use_simd_level("mmx"));
  EXPECT_FALSE(use_simd_level(""));
  EXPECT_EQ(simd_level(), levels.front());
}

// Sums of vectors of another width are rounded elsewhere.
TEST(SimdLevel, ChosenIsTheOneThatComputesHoweverOftenItIsLookedAt) {
  const std::string best = simd_level();
  const std::string worst = simd_levels().back();
  if (best == worst) GTEST_SKIP() << "only " << best << " here";
  const auto samples = [] { return record(make_plan(scene_with(400), 0, nullptr, Engine::spectral)).samples; };
  const auto fast = samples();
  ASSERT_TRUE(use_simd_level(worst));
  EXPECT_EQ(simd_level(), worst);
  EXPECT_EQ(simd_level(), worst);
  const auto slow = samples();
  EXPECT_FALSE(use_simd_level(best));
  hwy::SetSupportedTargetsForTest(0);
  EXPECT_NE(fast, slow);
  EXPECT_EQ(fast, samples());
}

TEST(SimdLevel, OfAScopeIsSetBackAtItsEnd) {
  const std::vector<std::string> levels = simd_levels();
  for (const std::string& level : levels) {
    {
      const SimdLevelScope scope(level);
      EXPECT_EQ(simd_level(), level);
    }
    EXPECT_EQ(simd_level(), levels.front());
  }
  const SimdLevelScope none("mmx");
  EXPECT_EQ(simd_level(), levels.front());
}

}  // namespace engine_test
}  // namespace sarsim::simulate
