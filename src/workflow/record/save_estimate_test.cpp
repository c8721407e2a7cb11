#include "workflow/record/save_estimate.hpp"

#include <gtest/gtest.h>

#include "raster/table/formats.hpp"
#include "simulate/plan/flight_test_scene.hpp"
#include "workflow/record/known_machine.hpp"

namespace sarsim::workflow {
namespace save_estimate_test {

simulate::Plan plan_of(double lsb_v, scene::FileFormat format = scene::FileFormat::hdf5) {
  scene::Scene scene = simulate::flight_scene();
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 2100.0;
  simulation.range_end_m = 2700.0;
  simulation.time_start_s = -0.1;
  simulation.time_end_s = 0.1;
  simulation.sample_rate_hz = 60e6;
  simulation.lsb_v = lsb_v;
  simulation.format = format;
  scene.simulations = {simulation};
  return simulate::make_plan(scene, 0, nullptr, simulate::Engine::direct);
}

// The example of thesis 4.5.2 has 6.39369e-5 mV over 127: 5.0344e-7 mV, before 3 % to spare.
TEST(EstimatedLsb, LeavesThreePercentAboveTheLargestMagnitude) {
  EXPECT_NEAR(estimated_lsb_v(6.39369e-8, 8), 1.03 * 5.0344e-10, 1e-14);
  EXPECT_NEAR(estimated_lsb_v(2.0, 1), 1.03, 1e-12);
  EXPECT_NEAR(estimated_lsb_v(2.0, 2), 2.06, 1e-12);
  EXPECT_NEAR(estimated_lsb_v(1.0, 16), 1.03 / 32767.0, 1e-12);
  EXPECT_EQ(estimated_lsb_v(0.0, 8), 0.0);
}

TEST(SaveEstimate, HasSizeTimeMemoryAndLsb) {
  const simulate::Plan plan = plan_of(0.0);
  const SaveEstimate e = save_estimate(plan, 96480.0, 1e-6, 2);
  EXPECT_EQ(e.rows, 201.0);
  EXPECT_EQ(e.columns, 240.0);
  EXPECT_EQ(e.bytes, 96480.0);
  EXPECT_GT(e.seconds, 0.0);
  EXPECT_GT(e.memory_bytes, 0.0);
  EXPECT_TRUE(e.lsb_estimated);
  EXPECT_NEAR(e.lsb_v, 1.03e-6 / 127.0, 1e-15);
  EXPECT_NE(text_of(e).find("201 x 240 samples"), std::string::npos);
  EXPECT_NE(text_of(e).find("(estimated)"), std::string::npos);
}

// Whoever writes counts without a given LSB computes everything twice.
TEST(SaveEstimate, CountsThePassThatFindsTheLargestMagnitude) {
  for (const scene::FileFormat format : {scene::FileFormat::binary, scene::FileFormat::hdf5, scene::FileFormat::npy})
    for (const double lsb_v : {0.0, 2e-9}) {
      const simulate::Plan plan = plan_of(lsb_v, format);
      const double passes = lsb_v == 0.0 && raster::holds_counts(format) ? 2.0 : 1.0;
      EXPECT_NEAR(save_estimate(plan, 1.0, 1e-6, 2).seconds,
                  passes * simulate::estimated_cost(plan, 2, known_machine()).seconds, 1e-12);
    }
  EXPECT_TRUE(raster::holds_counts(scene::FileFormat::binary));
}

TEST(SaveEstimate, SaysAboutHowLongInPlainWords) {
  SaveEstimate quick = save_estimate(plan_of(2e-9), 1.0, 1e-6, 1);
  quick.seconds = 0.0;
  EXPECT_EQ(text_of(quick).find("about below"), std::string::npos) << text_of(quick);
}

TEST(SaveEstimate, KeepsTheLsbThatIsSetAndAdmitsWhenNoneIsKnown) {
  const SaveEstimate set = save_estimate(plan_of(2e-9), 1.0, 1e-6, 1);
  EXPECT_EQ(set.lsb_v, 2e-9);
  EXPECT_FALSE(set.lsb_estimated);
  EXPECT_EQ(text_of(set).find("estimated"), std::string::npos);
  const SaveEstimate unknown = save_estimate(plan_of(0.0), 1.0, 0.0, 1);
  EXPECT_EQ(unknown.lsb_v, 0.0);
  EXPECT_NE(text_of(unknown).find("LSB unknown"), std::string::npos);
}

}  // namespace save_estimate_test
}  // namespace sarsim::workflow
