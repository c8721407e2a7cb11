#include "workflow/record/save_choice.hpp"

#include <gtest/gtest.h>

#include "simulate/plan/flight_test_scene.hpp"

namespace sarsim::workflow {
namespace save_choice_test {

SaveChoice measured_choice(scene::FileFormat format) {
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
  choice.recording.format = format;
  return choice;
}

// An LSB that only the whole recording gives costs one pass more, not three.
TEST(SaveForecast, DoublesTheTimeWhereTheLsbIsMeasured) {
  SaveChoice choice = measured_choice(scene::FileFormat::binary);
  const SaveForecast measured = forecast(simulate::flight_scene(), choice, 1e-6, 2);
  choice.lsb = LsbChoice::given;
  const SaveForecast given = forecast(simulate::flight_scene(), choice, 1e-6, 2);
  ASSERT_TRUE(measured.estimate && given.estimate);
  EXPECT_NEAR(measured.estimate->seconds, 2.0 * given.estimate->seconds, 1e-9 * given.estimate->seconds);
}

TEST(SaveForecast, HasTheSizeAndTheTimeOfTheSamplesThatAreChosen) {
  SaveChoice choice = measured_choice(scene::FileFormat::npy);
  choice.recording.bits = 40;  // in 8 bytes each
  const auto estimate_of = [&](SampleChoice samples) {
    choice.samples = samples;
    return forecast(simulate::flight_scene(), choice, 1e-6, 2).estimate.value();
  };
  const SaveEstimate volts = estimate_of(SampleChoice::volts);
  const SaveEstimate counts = estimate_of(SampleChoice::counts);
  const SaveEstimate doubles = estimate_of(SampleChoice::doubles);
  const double samples = volts.rows * volts.columns;
  EXPECT_DOUBLE_EQ(doubles.bytes - volts.bytes, 8.0 * samples);  // complex128 against complex64
  EXPECT_DOUBLE_EQ(counts.bytes - volts.bytes, 8.0 * samples);
  EXPECT_NEAR(counts.seconds, 2.0 * volts.seconds, 1e-9 * volts.seconds);  // their LSB is found first
}

TEST(SampleChoice, IsThatOfTheFormatWhereItHoldsCountsAlone) {
  SaveChoice choice = measured_choice(scene::FileFormat::binary);
  choice.samples = SampleChoice::doubles;
  EXPECT_EQ(chosen_samples(choice), SampleChoice::counts);
  EXPECT_TRUE(sink_options_of(choice, false).counts);
  EXPECT_FALSE(sink_options_of(choice, false).doubles);
  choice.recording.format = scene::FileFormat::hdf5;
  EXPECT_EQ(chosen_samples(choice), SampleChoice::doubles);
  EXPECT_TRUE(sink_options_of(choice, true).doubles);
  EXPECT_FALSE(sink_options_of(choice, true).counts);
  EXPECT_TRUE(sink_options_of(choice, true).replace);
}

}  // namespace save_choice_test
}  // namespace sarsim::workflow
