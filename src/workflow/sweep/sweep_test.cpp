#include "workflow/sweep/sweep.hpp"

#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>

#include "core/report/invalid_request.hpp"
#include "simulate/plan/flight_test_scene.hpp"
#include "support/test_folder.hpp"

namespace sarsim::workflow {
namespace sweep_test {

namespace fs = std::filesystem;

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

SweepRequest request_for(const test::TestFolder& folder, std::vector<std::string> settings) {
  SweepRequest request;
  request.scene = simulate::flight_scene();
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.file = "sim.bin";
  simulation.range_start_m = 2300.0;
  simulation.range_end_m = 2500.0;
  simulation.time_start_s = 0.0;
  simulation.time_end_s = 0.02;
  simulation.sample_rate_hz = 60e6;
  simulation.lsb_v = 2e-9;
  request.scene.simulations = {simulation};
  request.script = "flight.scr";
  request.values.settings = std::move(settings);
  request.folder = (folder / "out").string();
  request.threads = 2;
  return request;
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// What somebody who looks on was told.
struct Seen {
  std::vector<std::size_t> done;
  std::vector<std::string> lines;
  std::string problems;
  bool elsewhere = false;  // Something was told on another thread.

  [[nodiscard]] core::Observer observer() {
    const auto here = [this, caller = std::this_thread::get_id()] {
      elsewhere = elsewhere || std::this_thread::get_id() != caller;
    };
    core::Observer observer;
    observer.progress = [this, here](const std::string&, const core::Progress& progress) {
      here();
      done.push_back(progress.done);
    };
    observer.announce = [this, here](const std::string& line) {
      here();
      lines.push_back(line);
    };
    observer.remark = [this](const core::Problems& all) {
      for (const core::Problem& problem : all) problems += core::to_string(problem) + "\n";
    };
    return observer;
  }
};

TEST(SweepWorkflow, MakesEveryVariationAndTheirTables) {
  const test::TestFolder folder;
  const SweepRequest request = request_for(folder, {"seed=1..3", "Target1.rcs=1,4"});
  const SweepReport report = sweep(request, {});
  EXPECT_THAT(report.failures, SizeIs(0));
  EXPECT_THAT(report.plan.rows, SizeIs(6));
  EXPECT_EQ(report.table, fs::path(request.folder) / "sweep.csv");
  for (const SweepRow& row : report.plan.rows) {
    EXPECT_TRUE(row.done);
    EXPECT_EQ(static_cast<double>(fs::file_size(fs::path(request.folder) / row.file)), row.bytes);
  }
  const std::string table = content(report.table);
  EXPECT_EQ(std::ranges::count(table, '\n'), 7);
  EXPECT_THAT(table, HasSubstr("\n2,1,4,Simulation1,sim_seed=1_Target1.rcs=4.bin,done,"));
  EXPECT_THAT(content(fs::path(request.folder) / "sweep.json"), HasSubstr("\"status\": \"done\""));
}

TEST(SweepWorkflow, TellsItsProgressOnTheThreadThatCalls) {
  const test::TestFolder folder;
  Seen seen;
  const core::Observer observer = seen.observer();
  static_cast<void>(sweep(request_for(folder, {"seed=1..4"}), observer));
  EXPECT_THAT(seen.done, ElementsAre(0, 1, 2, 3, 4));
  ASSERT_THAT(seen.lines, SizeIs(1));
  EXPECT_THAT(seen.lines[0], HasSubstr("flight.scr: 4 variations, 4 to run, "));
  EXPECT_THAT(seen.lines[0], HasSubstr(", 2 at a time with 1 thread"));
  EXPECT_FALSE(seen.elsewhere);
}

TEST(SweepWorkflow, RefusesAllVariationsBeforeTheFirstIsMade) {
  const test::TestFolder folder;
  const SweepRequest request = request_for(folder, {"Radar1.pulse_width=1us,-1us"});
  try {
    static_cast<void>(sweep(request, {}));
    FAIL() << "nothing was refused";
  } catch (const core::InvalidRequest& refused) {
    ASSERT_FALSE(refused.problems.empty());
    EXPECT_THAT(core::to_string(refused.problems[0]), HasSubstr("with Radar1.pulse_width=-1us"));
  }
  EXPECT_FALSE(fs::exists(request.folder));
  EXPECT_TRUE(plan_sweep(request, {}).refused);
}

TEST(SweepWorkflow, LeavesOutWhatIsDoneWhereItResumes) {
  const test::TestFolder folder;
  SweepRequest request = request_for(folder, {"seed=1,2"});
  static_cast<void>(sweep(request, {}));
  EXPECT_THROW(static_cast<void>(sweep(request, {})), core::InvalidRequest);
  request.values.settings = {"seed=1..3"};
  request.resume = true;
  const SweepPlan plan = plan_sweep(request, {});
  EXPECT_THAT(plan.open, ElementsAre(2));
  Seen seen;
  const core::Observer observer = seen.observer();
  static_cast<void>(sweep(request, observer));
  EXPECT_THAT(seen.lines.at(0), HasSubstr("3 variations, 2 done before, 1 to run"));
}

TEST(SweepWorkflow, KeepsWhatWasDoneWhereItIsStopped) {
  const test::TestFolder folder;
  SweepRequest request = request_for(folder, {"seed=1..2000"});
  request.threads = 1;
  core::StopFlag stop;
  Seen seen;
  core::Observer observer = seen.observer();
  observer.stop = &stop;
  observer.progress = [&](const std::string&, const core::Progress& progress) {
    if (progress.done == 3) stop.request();
  };
  EXPECT_THROW(static_cast<void>(sweep(request, observer)), core::Interrupted);
  EXPECT_THAT(seen.lines.at(1), HasSubstr(" of 2000 variations done; continue with --resume"));
  EXPECT_FALSE(fs::exists(fs::path(request.folder) / "sweep.csv"));
  request.resume = true;
  EXPECT_LE(plan_sweep(request, {}).open.size(), 1997U);
}

// No lock but that of the HDF5 sinks themselves keeps the threads apart.
TEST(SweepWorkflow, MakesHdf5FilesOnSeveralThreads) {
  const test::TestFolder folder;
  SweepRequest request = request_for(folder, {"seed=1..12", "Simulation1.format=HDF5"});
  request.jobs = 1;
  static_cast<void>(sweep(request, {}));
  SweepRequest parallel = request;
  parallel.folder = (folder / "parallel").string();
  parallel.threads = parallel.jobs = 6;
  const SweepReport report = sweep(parallel, {});
  EXPECT_EQ(report.plan.jobs, 6U);
  for (const SweepRow& row : report.plan.rows) {
    const std::string one = content(fs::path(request.folder) / row.file);
    EXPECT_FALSE(one.empty());
    EXPECT_EQ(content(fs::path(parallel.folder) / row.file), one) << row.file;
  }
}

TEST(SweepWorkflow, DealsVariationsOutToParts) {
  const test::TestFolder folder;
  SweepRequest request = request_for(folder, {"seed=1..5"});
  request.part = {1, 3};
  const SweepReport report = sweep(request, {});
  EXPECT_THAT(report.plan.variations, ElementsAre(1, 4));
  EXPECT_EQ(report.table.filename(), "sweep-2-of-3.csv");
}

}  // namespace sweep_test
}  // namespace sarsim::workflow
