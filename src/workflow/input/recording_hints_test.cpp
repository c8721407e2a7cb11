#include "workflow/input/recording_hints.hpp"

#include <gtest/gtest.h>

namespace sarsim::workflow {
namespace recording_hints_test {

scene::Scene recording_scene() {
  scene::Scene scene;
  scene.platforms.emplace_back();
  scene.radars.emplace_back();
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_end_m = 299.792458;
  simulation.time_end_s = 0.0095;
  simulation.sample_rate_hz = 50e6;
  simulation.bits = 10;
  simulation.lsb_v = 1e-6;
  simulation.file = "C:\\OUT\\Echo.BIN";
  simulation.format = scene::FileFormat::binary;
  scene.simulations.push_back(simulation);
  return scene;
}

TEST(HintsFromScene, AreOfTheWholeNameAndNeverOfOneAmongSeveralStems) {
  scene::Scene scene = recording_scene();
  scene.simulations.push_back(scene.simulations[0]);
  scene.simulations[1].file = "echo.asc";
  scene.simulations[1].bits = 12;
  ASSERT_TRUE(hints_from_scene(scene, "ECHO.asc"));
  EXPECT_EQ(hints_from_scene(scene, "ECHO.asc")->bits, 12);
  EXPECT_EQ(hints_from_scene(scene, "echo.bin")->bits, 10);
  EXPECT_FALSE(hints_from_scene(scene, "echo.npy"));
}

TEST(HintsFromScene, AreNotToBeHadOfWindowsThatNoMemoryHolds) {
  scene::Scene scene = recording_scene();
  scene.simulations[0].range_end_m = 1e12;
  EXPECT_FALSE(hints_from_scene(scene, "echo.bin"));
}

TEST(HintsFromScene, AreNotToBeHadOfARadarWithMistakes) {
  scene::Scene scene = recording_scene();
  scene.radars[0].prf_hz = 0.0;
  EXPECT_FALSE(hints_from_scene(scene, "echo.bin"));
}

TEST(HintsFromScene, AskNothingOfTargets) {
  scene::Scene scene = recording_scene();
  scene.targets.emplace_back().platform = "Nowhere";
  const auto hints = hints_from_scene(scene, "echo.bin");
  ASSERT_TRUE(hints);
  EXPECT_EQ(hints->columns, 100U);
}

TEST(HintsFromScene, AreTheShapeAndDepthOfTheSimulationThatWroteTheFile) {
  const auto hints = hints_from_scene(recording_scene(), "/data/echo.bin");
  ASSERT_TRUE(hints);
  EXPECT_EQ(hints->columns, 100U);
  EXPECT_EQ(hints->rows, 10U);
  EXPECT_EQ(hints->bits, 10);
  EXPECT_EQ(hints->lsb_v, 1e-6);
  EXPECT_EQ(hints->format, scene::FileFormat::binary);
  const auto other = hints_from_scene(recording_scene(), "echo.csv");
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->format);
  EXPECT_FALSE(hints_from_scene(recording_scene(), "other.bin"));
}

}  // namespace recording_hints_test
}  // namespace sarsim::workflow
