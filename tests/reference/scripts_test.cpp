// Every script that the original program's authors left: it reads, it can be simulated, it is simulated, it survives
// being written and read again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "scene/check/check.hpp"
#include "scene/language/exact_names.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/scene_writer.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"
#include "simulate/plan/row_maker.hpp"
#include "simulate/run/run.hpp"
#include "simulate/survey/survey.hpp"
#include "support/discarding_sink.hpp"
#include "support/folders.hpp"

namespace sarsim {
namespace scripts_test {

using test::reference_folder;

std::vector<std::filesystem::path> original_scripts() {
  std::vector<std::filesystem::path> scripts;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(reference_folder() / "original")) {
    const auto extension = entry.path().extension();
    if (extension == ".scr" || extension == ".SCR") scripts.push_back(entry.path());
  }
  std::ranges::sort(scripts);
  return scripts;
}

std::string errors_of(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems)
    if (problem.severity == core::Severity::error) text += core::to_string(problem) + '\n';
  return text;
}

class OriginalScripts : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::have_reference_folder()) GTEST_SKIP() << "no reference folder at " << reference_folder();
    scripts_ = original_scripts();
    ASSERT_EQ(scripts_.size(), 25u);
  }
  std::vector<std::filesystem::path> scripts_;
};

TEST_F(OriginalScripts, AreReadAndCheckedWithoutAnError) {
  for (const auto& path : scripts_) {
    const scene::ScriptReading reading = scene::read_script_file(path);
    EXPECT_EQ(errors_of(reading.problems), "") << path;
    EXPECT_EQ(errors_of(scene::check(reading.scene)), "") << path;
    EXPECT_EQ(errors_of(simulate::survey(reading.scene)), "") << path;
  }
}

TEST_F(OriginalScripts, GiveTheSameSceneAfterBeingWrittenAndReadAgain) {
  for (const auto& path : scripts_) {
    const scene::ScriptReading reading = scene::read_script_file(path);
    const scene::ScriptReading again = scene::read_script(scene::write_script(reading.scene), "written", {});
    EXPECT_EQ(errors_of(again.problems), "") << path;
    EXPECT_TRUE(again.scene == reading.scene) << path;
  }
}

// By way of format 2 the script is the same to the byte, but for names, which are written as they were defined.
TEST_F(OriginalScripts, ComeBackFromFormat2AsTheyWere) {
  for (const auto& path : scripts_) {
    const scene::Scene scene = scene::with_exact_names(scene::read_script_file(path).scene);
    const scene::ScriptReading again = scene::read_format_2(scene::write_format_2(scene), "written", {});
    EXPECT_EQ(errors_of(again.problems), "") << path;
    EXPECT_TRUE(again.scene == scene) << path;
    EXPECT_EQ(scene::write_script(again.scene), scene::write_script(scene)) << path;
  }
}

TEST_F(OriginalScripts, HoldASimulationExceptTheSixThatNeverDid) {
  const std::vector<std::string> without{"badfill", "gain", "kw", "kw2", "radarz", "singlept"};
  std::vector<std::string> found;
  for (const auto& path : scripts_)
    if (scene::read_script_file(path).scene.simulations.empty()) found.push_back(path.stem().string());
  std::ranges::sort(found);
  EXPECT_EQ(found, without);
}

// Runs in full whatever costs less than this; of anything larger, rows from one end to the other.
constexpr double affordable_s = 10.0;

void run_simulation(const scene::Scene& scene, std::size_t index) {
  const simulate::Plan plan = simulate::make_plan(scene, index);
  const double cost_s = simulate::estimated_cost(plan, 1).seconds_one_thread;
  std::printf("  %6zu x %6zu, about %.2f s: ", plan.acquisition.timing.rows, plan.acquisition.reception.columns,
              cost_s);
  if (cost_s <= affordable_s) {
    test::DiscardingSink sink;
    const raster::RunReport report = simulate::run(plan, plan.acquisition.simulation.lsb_v, sink, raster::RunControl{});
    EXPECT_TRUE(sink.finished());
    EXPECT_EQ(sink.rows(), plan.acquisition.timing.rows);
    EXPECT_TRUE(std::isfinite(report.maximum_v));
    std::printf("all rows, %.2f s, maximum %g mV\n", report.seconds, 1e3 * report.maximum_v);
    return;
  }
  constexpr std::size_t looked_at = 32;
  simulate::RowMaker maker(plan);
  std::vector<std::complex<double>> row(plan.acquisition.reception.columns);
  for (std::size_t i = 0; i < looked_at; ++i) {
    maker.make_row(i * (plan.acquisition.timing.rows - 1) / (looked_at - 1), row);
    for (const auto& sample : row) ASSERT_TRUE(std::isfinite(sample.real()) && std::isfinite(sample.imag()));
  }
  std::printf("%zu rows\n", looked_at);
}

TEST_F(OriginalScripts, AreSimulated) {
  for (const auto& path : scripts_) {
    const scene::Scene scene = scene::read_script_file(path).scene;
    for (std::size_t i = 0; i < scene.simulations.size(); ++i) {
      std::printf("%-12s %zu", path.stem().c_str(), i + 1);
      SCOPED_TRACE(path.string());
      run_simulation(scene, i);
    }
  }
}

}  // namespace scripts_test
}  // namespace sarsim
