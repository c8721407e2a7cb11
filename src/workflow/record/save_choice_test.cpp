#include "workflow/record/save_choice.hpp"

#include <gtest/gtest.h>

#include "simulate/plan/flight_test_scene.hpp"

namespace sarsim::workflow {
namespace save_choice_test {

// An LSB that only the whole recording gives costs one pass more, not three.
TEST(SaveForecast, DoublesTheTimeWhereTheLsbIsMeasured) {
  SaveChoice choice;
  choice.file = "sim.bin";
  choice.lsb = LsbChoice::measured;
  choice.recording.radar = "Radar1";
  choice.recording.range_start_m = 2100.0;
  choice.recording.range_end_m = 2700.0;
  choice.recording.time_start_s = -0.01;
  choice.recording.time_end_s = 0.01;
  choice.recording.sample_rate_hz = 60e6;
  choice.recording.lsb_v = 1e-9;
  choice.recording.format = scene::FileFormat::binary;
  const SaveForecast measured = forecast(simulate::flight_scene(), choice, 1e-6, 2);
  choice.lsb = LsbChoice::given;
  const SaveForecast given = forecast(simulate::flight_scene(), choice, 1e-6, 2);
  ASSERT_TRUE(measured.estimate && given.estimate);
  EXPECT_NEAR(measured.estimate->seconds, 2.0 * given.estimate->seconds, 1e-9 * given.estimate->seconds);
}

}  // namespace save_choice_test
}  // namespace sarsim::workflow
