#include "workflow/record/record.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"
#include "simulate/plan/flight_test_scene.hpp"
#include "workflow/record/merge.hpp"
#include "workflow/record/prepared_recording.hpp"

namespace sarsim::workflow {
namespace record_test {

namespace fs = std::filesystem;

scene::Scene recorded_scene() {
  scene::Scene scene = simulate::flight_scene();
  scene.simulations = {simulate::flight_recording(1e-9, scene::FileFormat::binary)};
  return scene;
}

class Record : public testing::Test {
 protected:
  Record() {
    fs::remove_all(folder_);
    request_.scene = recorded_scene();
    request_.folder = folder_;
    request_.threads = 1;
  }
  ~Record() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string bytes_of(const fs::path& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_ = fs::temp_directory_path() /
                     (std::string("record-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  RecordRequest request_;
};

TEST_F(Record, TellsOfEachProductAndReportsIt) {
  std::vector<std::string> heard;
  core::Observer observer;
  observer.announce = [&](const std::string& line) { heard.push_back(line); };
  observer.progress = [&](const std::string& stage, const core::Progress&) {
    if (heard.back() != stage) heard.push_back(stage);
  };
  RecordEvents events;
  events.made = [&](const ProductReport& made) { heard.push_back("made " + made.path.filename().string()); };
  const RecordReport report = record(request_, observer, events);
  const std::string file = (folder_ / "sim.bin").string();
  ASSERT_EQ(heard.size(), 3U);
  EXPECT_THAT(heard[0], testing::StartsWith(file + ": Radar1, raw, "));
  EXPECT_EQ(heard[1], file);
  EXPECT_EQ(heard[2], "made sim.bin");
  ASSERT_EQ(report.products.size(), 1U);
  const RecordingReport& recording = report.products.front().recording.value();
  EXPECT_EQ(recording.file, file);
  EXPECT_EQ(recording.bytes, static_cast<double>(bytes_of("sim.bin").size()));
  EXPECT_GT(recording.run.maximum_v, 0.0);
}

TEST_F(Record, PreparedIsLookedAtAndThenMadeAlike) {
  scene::Scene scene = *request_.scene;
  scene.simulations.push_back(scene.simulations.front());
  scene.simulations.back().bits = 99;  // Another recording's mistake does not matter.
  const fs::path file = folder_ / "prepared.bin";
  fs::create_directories(folder_);
  const PreparedRecording prepared = prepare_recording(scene, 0, file, {});
  EXPECT_FALSE(fs::exists(file));
  EXPECT_GT(prepared.estimate.seconds, 0.0);
  const RecordingReport made = make_recording(prepared, {});
  EXPECT_EQ(made.run.rows, prepared.estimate.rows);
  EXPECT_EQ(made.run.columns, prepared.estimate.columns);
  EXPECT_EQ(made.bytes, prepared.estimate.bytes);
  EXPECT_EQ(made.engine, simulate::name_of(prepared.plan.engine.engine));
  (void)record(request_, {});
  EXPECT_EQ(bytes_of("prepared.bin"), bytes_of("sim.bin"));
  EXPECT_THROW((void)prepare_recording(scene, 1, folder_ / "wrong.bin", {}), core::InvalidRequest);
  EXPECT_THROW((void)make_recording(prepared, {}), std::runtime_error) << "the file is there and may not be replaced";
}

TEST_F(Record, PreparesNothingWhereAStopIsRequested) {
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)prepare_recording(*request_.scene, 0, folder_ / "prepared.bin", {}, &stop), core::Interrupted);
}

TEST_F(Record, PreparedHoldsWhatIsAskedForLikeARun) {
  scene::Scene scene = *request_.scene;
  scene.simulations[0].format = scene::FileFormat::npy;
  scene.simulations[0].file = "sim.npy";
  request_.scene = scene;
  fs::create_directories(folder_);
  std::string last;
  for (const bool counts : {true, false}) {
    const PreparedRecording prepared =
        prepare_recording(scene, 0, folder_ / "prepared.npy", {.replace = true, .counts = counts, .doubles = !counts});
    const RecordingReport made = make_recording(prepared, {});
    EXPECT_EQ(made.counts, counts);
    EXPECT_EQ(made.bytes, prepared.estimate.bytes);
    request_.force = true;
    request_.counts = counts;
    request_.doubles = !counts;
    (void)record(request_, {});
    EXPECT_EQ(bytes_of("prepared.npy"), bytes_of("sim.npy"));
    EXPECT_NE(bytes_of("sim.npy"), last);
    last = bytes_of("sim.npy");
  }
}

TEST_F(Record, DiscardingWritesNothing) {
  request_.discard = true;
  const RecordReport report = record(request_, {});
  EXPECT_TRUE(report.products.front().recording.value().file.empty());
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Record, RefusesToReplaceAFileUnlessForced) {
  static_cast<void>(record(request_, {}));
  EXPECT_THROW(static_cast<void>(record(request_, {})), core::InvalidRequest);
  request_.force = true;
  EXPECT_EQ(record(request_, {}).products.size(), 1U);
}

TEST_F(Record, TellsWhatIsWrongBeforeItRefuses) {
  request_.scene->simulations.front().radar = "Nobody";
  core::Problems found;
  RecordEvents events;
  events.found = [&](const core::Problems& problems) { found = problems; };
  EXPECT_THROW(static_cast<void>(record(request_, {}, events)), core::InvalidRequest);
  EXPECT_TRUE(core::has_errors(found));
}

TEST_F(Record, StoppedItLeavesNoFile) {
  core::StopFlag stop;
  stop.request();
  core::Observer observer;
  observer.stop = &stop;
  EXPECT_THROW(static_cast<void>(record(request_, observer)), core::Interrupted);
  EXPECT_FALSE(fs::exists(folder_ / "sim.bin"));
}

TEST_F(Record, MergedPartsAreTheFileOfASingleRun) {
  static_cast<void>(record(request_, {}));
  const std::string whole = bytes_of("sim.bin");
  fs::remove(folder_ / "sim.bin");
  request_.part.own_file = true;
  for (const std::int64_t number : {1, 2}) {
    request_.part.share = PartChoice::Share{number, 2};
    const RecordReport report = record(request_, {});
    EXPECT_FALSE(report.products.front().recording);
    EXPECT_TRUE(report.products.front().part.value().own_file);
  }
  const MergeReport merged = merge({{(folder_ / "sim.bin.parts").string()}, {}, 1}, {});
  EXPECT_EQ(merged.recording.file, (folder_ / "sim.bin").string());
  EXPECT_EQ(bytes_of("sim.bin"), whole);
}

}  // namespace record_test
}  // namespace sarsim::workflow
