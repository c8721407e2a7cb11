#include <cmath>

#include <gmock/gmock.h>

#include "csv.hpp"
#include "program.hpp"

namespace sarsim::test {
namespace monte_carlo_test {

using testing::HasSubstr;

class MonteCarlo : public CommandTest {};

// Receiver noise alone: a thousand recordings of one pulse of 4 samples, in decision 13's physical profile. The squared
// magnitude of a sample is exponential with mean kTfs; the largest of n = 4 independent ones has the mean (1 + 1/2 +
// 1/3 + 1/4) kTfs and the variance (1 + 1/4 + 1/9 + 1/16) (kTfs)^2.
TEST_F(MonteCarlo, AThousandSeedsHaveTheStatisticsOfReceiverNoise) {
  SceneText scene;
  scene.pulses = 1;
  scene.noise_k = "300";
  scene.lsb_mv = "1e-9";
  std::string text = scene.text();
  const std::string window = "Radar1 900 1400 0 0 8 0.1";
  ASSERT_NE(text.find(window), std::string::npos);
  text.replace(text.find(window), window.size(), "Radar1 2000 2006 0 0 8 0.1");
  write_text(folder_ / "scene.scr", text);
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "seed=1..1000", "--discard"});
  ASSERT_EQ(sweep.status, 0) << sweep.err;
  const auto rows = read_csv(text_of(folder_ / "sweep.csv"));
  ASSERT_EQ(rows.size(), 1000U);
  constexpr double density_w = 1.380649e-23 * 300.0 * 0.1e9;
  double sum = 0.0;
  for (const auto& row : rows) {
    ASSERT_EQ(row.at("columns"), "4");
    const double maximum_v = std::stod(row.at("maximum_v"));
    sum += maximum_v * maximum_v / density_w;
  }
  const double mean = 1.0 + 1.0 / 2 + 1.0 / 3 + 1.0 / 4;
  const double variance = 1.0 + 1.0 / 4 + 1.0 / 9 + 1.0 / 16;
  EXPECT_NEAR(sum / 1000.0, mean, 5.0 * std::sqrt(variance / 1000.0));
}

TEST_F(MonteCarlo, SeedsGiveDifferentRecordingsAndTheSameSeedTheSame) {
  SceneText scene;
  scene.pulses = 2;
  write_scene(scene);
  ASSERT_EQ(sarsim({"sweep", "scene.scr", "--set", "seed=1..1000", "--out", "a"}).status, 0);
  ASSERT_EQ(sarsim({"sweep", "scene.scr", "--set", "seed=999,1000", "--out", "b"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "a/sim_seed=1000.bin"), text_of(folder_ / "b/sim_seed=1000.bin"));
  EXPECT_NE(text_of(folder_ / "a/sim_seed=1000.bin"), text_of(folder_ / "a/sim_seed=999.bin"));
}

}  // namespace monte_carlo_test
}  // namespace sarsim::test
