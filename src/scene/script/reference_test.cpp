// Every sample script of the original programs and of the reference cases: read without an error, written, read again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"
#include "support/folders.hpp"

namespace sarsim::scene {

namespace reference_test {

namespace fs = std::filesystem;

bool is_script(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".scr";
}

std::vector<fs::path> scripts_in(const fs::path& folder) {
  std::vector<fs::path> scripts;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_script(entry.path())) scripts.push_back(entry.path());
  std::ranges::sort(scripts);
  return scripts;
}

std::string printed(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

void expect_no_problem(const std::vector<fs::path>& scripts) {
  for (const fs::path& path : scripts) EXPECT_EQ(printed(read_script_file(path).problems), "") << path;
}

void expect_same_after_writing(const std::vector<fs::path>& scripts) {
  for (const fs::path& path : scripts) {
    const Scene scene = read_script_file(path).scene;
    const ScriptReading again = read_script(write_script(scene), "written.scr", {});
    EXPECT_EQ(printed(again.problems), "") << path;
    EXPECT_TRUE(again.scene == scene) << path;
  }
}

TEST(ReferenceScripts, AreReadWithoutAnyProblem) {
  const std::vector<fs::path> scripts = scripts_in(sarsim::test::direct_reference_folder());
  EXPECT_EQ(scripts.size(), 34U);
  expect_no_problem(scripts);
}

TEST(ReferenceScripts, GiveTheSameSceneAfterWriting) {
  expect_same_after_writing(scripts_in(sarsim::test::direct_reference_folder()));
}

class OriginalScripts : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(folder_))
      GTEST_SKIP() << "no scripts at " << folder_ << "; SARSIM_REFERENCE may name the folder above";
  }
  const fs::path folder_ = sarsim::test::reference_folder() / "original";
};

TEST_F(OriginalScripts, AreReadWithoutAnyProblem) {
  const std::vector<fs::path> scripts = scripts_in(folder_);
  EXPECT_EQ(scripts.size(), 25U);
  expect_no_problem(scripts);
}

TEST_F(OriginalScripts, GiveTheSameSceneAfterWriting) { expect_same_after_writing(scripts_in(folder_)); }

TEST_F(OriginalScripts, HoldAsManyObjectsAsTheyHaveCommands) {
  const Scene scene = read_script_file(folder_ / "windows/SAR_RC.SCR").scene;
  EXPECT_EQ(scene.targets.size(), 24U);
  EXPECT_EQ(read_script_file(folder_ / "windows/test.scr").scene.surfaces.size(), 1U);
}

TEST_F(OriginalScripts, GiveTheValuesThatTheyState) {
  const ScriptReading reading = read_script_file(folder_ / "linux/exam2.scr");
  const Radar& radar = reading.scene.radars.at(0);
  EXPECT_EQ(radar.bandwidth_hz, 0.1e9);
  EXPECT_EQ(radar.pulse_width_s, 2500e-9);
  EXPECT_EQ(radar.carrier_hz, 0.5e9);
  const Simulation& simulation = reading.scene.simulations.at(0);
  EXPECT_EQ(simulation.lsb_v, 2.43350484e-14);
  EXPECT_EQ(simulation.sample_rate_hz, 1e9);
  EXPECT_EQ(simulation.format, FileFormat::hdf5);
  EXPECT_EQ(simulation.width_factor, 100.0);
  EXPECT_EQ(reading.places.find({"simulation", 0, "lsb_v"}).line, 111U);
}

}  // namespace reference_test
}  // namespace sarsim::scene
