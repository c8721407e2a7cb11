#include "workflow/record/plan_forecast.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"
#include "scene/script/writer.hpp"
#include "simulate/plan/flight_test_scene.hpp"
#include "workflow/record/save_choice.hpp"

namespace sarsim::workflow {
namespace plan_forecast_test {

namespace fs = std::filesystem;

using simulate::flight_recording;

RecordingForecast of_rows(std::size_t rows, double seconds_per_row) {
  RecordingForecast recording;
  recording.rows = rows;
  recording.columns = 4;
  recording.bytes = 100.0;
  recording.memory_bytes = static_cast<double>(rows);
  recording.fixed_s = 1.0;
  recording.trial = {1, seconds_per_row, 1.0};
  return recording;
}

TEST(PlanForecast, AddsTheRecordingsUp) {
  PlanForecast forecast;
  forecast.reading_s = 3.0;
  forecast.recordings = {of_rows(10, 2.0), of_rows(5, 1.0)};
  EXPECT_EQ(forecast.samples(), 60.0);
  EXPECT_EQ(forecast.bytes(), 200.0);
  EXPECT_EQ(forecast.memory_bytes(), 10.0);
  EXPECT_EQ(forecast.seconds(1), 3.0 + (1.0 + 20.0) + (1.0 + 5.0));
  // The slowest of four has three and two rows.
  EXPECT_EQ(forecast.seconds(4), 3.0 + (1.0 + 6.0) + (1.0 + 2.0));
  EXPECT_EQ(forecast.times_as_fast(4), 30.0 / 13.0);
}

TEST(PlanForecast, TriesTheRecordingsOfAScript) {
  const fs::path script = fs::temp_directory_path() / "plan-forecast.scr";
  std::ofstream(script) << scene::write_script(
      with_simulation(simulate::flight_scene(), flight_recording(0.0, scene::FileFormat::binary)));
  const PlanForecast forecast = forecast_recordings({script.string(), {}, 1}, {});
  EXPECT_EQ(forecast.threads, 1U);
  ASSERT_EQ(forecast.recordings.size(), 1U);
  const RecordingForecast& recording = forecast.recordings.front();
  EXPECT_EQ(recording.columns, 240U);
  EXPECT_EQ(recording.bytes, 2.0 * recording.samples());
  EXPECT_TRUE(recording.twice);
  EXPECT_GT(recording.trial.rows, 0U);
  EXPECT_GT(recording.seconds(1), recording.seconds(2));
  EXPECT_GE(forecast.seconds(1), recording.seconds(1));
  core::StopFlag stop;
  stop.request();
  core::Observer stopped;
  stopped.stop = &stop;
  EXPECT_THROW(static_cast<void>(forecast_recordings({script.string(), {}, 1}, stopped)), core::Interrupted);
  fs::remove(script);
  EXPECT_THROW(static_cast<void>(forecast_recordings({script.string(), {}, 1}, {})), core::InvalidRequest);
}

}  // namespace plan_forecast_test
}  // namespace sarsim::workflow
