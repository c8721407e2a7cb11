#include "workflow/input/output_names.hpp"
#include "scene/model/scene.hpp"

#include <fstream>

#include <gtest/gtest.h>

namespace sarsim::workflow {
namespace output_names_test {

namespace fs = std::filesystem;

scene::Scene scene_with(const std::vector<std::string>& files, const std::vector<std::string>& tables = {}) {
  scene::Scene scene;
  for (const std::string& file : files) scene.simulations.emplace_back().file = file;
  for (const std::string& file : tables) scene.geometries.emplace_back().file = file;
  return scene;
}

TEST(OutputNames, BaseNameFollowsEitherSlashAndDrive) {
  EXPECT_EQ(base_name("a.asc"), "a.asc");
  EXPECT_EQ(base_name("x/y/a.asc"), "a.asc");
  EXPECT_EQ(base_name("c:\\old\\a.asc"), "a.asc");
  EXPECT_EQ(base_name("D:a.asc"), "a.asc");
  EXPECT_EQ(base_name("x\\y/a.asc"), "a.asc");
  EXPECT_EQ(base_name("x/"), "");
}

TEST(OutputNames, GoIntoTheFolder) {
  OutputRules rules;
  rules.folder = "out";
  const OutputNames names = output_names(scene_with({"../up/a.asc"}, {"/etc/t.txt"}), rules);
  EXPECT_EQ(names.simulations.at(0), "out/a.asc");
  EXPECT_EQ(names.tables.at(0), "out/t.txt");
  EXPECT_TRUE(names.problems.empty());
}

TEST(OutputNames, KeepTheirFoldersOnlyWhenAsked) {
  OutputRules rules;
  rules.folder = "out";
  rules.keep_paths = true;
  const OutputNames names = output_names(scene_with({"c:sub\\a.asc", "sub/../b.asc"}), rules);
  EXPECT_EQ(names.simulations.at(0), "out/sub/a.asc");
  EXPECT_EQ(names.simulations.at(1), "out/b.asc");
  EXPECT_TRUE(names.problems.empty());
}

TEST(OutputNames, NeverLeadOutOfTheFolder) {
  OutputRules rules;
  rules.folder = "out";
  rules.keep_paths = true;
  for (const char* name : {"/tmp/b.asc", "\\b.asc", "c:\\b.asc", "../b.asc", "sub/../../b.asc", "..\\out\\b.asc"}) {
    const OutputNames names = output_names(scene_with({name}), rules);
    ASSERT_EQ(names.problems.size(), 1U) << name;
    EXPECT_EQ(names.problems[0].severity, core::Severity::error) << name;
    EXPECT_EQ(names.problems[0].found, name);
  }
}

TEST(OutputNames, RepeatedNamesAreNumbered) {
  const OutputNames names = output_names(scene_with({"a.asc", "x/a.asc", "a-2.asc", "A.asc"}, {"a.asc"}), {});
  EXPECT_EQ(names.simulations.at(0), "a.asc");
  EXPECT_EQ(names.simulations.at(1), "a-2.asc");
  EXPECT_EQ(names.simulations.at(2), "a-2-2.asc");
  EXPECT_EQ(names.simulations.at(3), "A.asc");
  EXPECT_EQ(names.tables.at(0), "a-3.asc");
  // The script's own repetitions are the business of `check`; here only the number that met another name.
  ASSERT_EQ(names.problems.size(), 1U);
  EXPECT_EQ(names.problems[0].severity, core::Severity::warning);
  EXPECT_EQ(names.problems[0].subject, (core::Subject{"simulation", 2, "file"}));
}

// A format of several files claims the names of all of them.
TEST(OutputNames, FilesThatBelongToAnotherProductAreNumberedWithAWarning) {
  scene::Scene scene = scene_with({"t.sigmf-meta", "u.sigmf-data", "u.sigmf-meta"}, {"t.sigmf-data", "v.txt"});
  for (scene::Simulation& simulation : scene.simulations) simulation.format = scene::FileFormat::sigmf;
  const OutputNames names = output_names(scene, {});
  EXPECT_EQ(names.simulations.at(0), "t.sigmf-meta");
  EXPECT_EQ(names.simulations.at(2), "u-2.sigmf-meta");
  EXPECT_EQ(names.tables.at(0), "t-2.sigmf-data");
  EXPECT_EQ(names.tables.at(1), "v.txt");
  ASSERT_EQ(names.problems.size(), 2U);
  EXPECT_EQ(names.problems[0].subject, (core::Subject{"simulation", 2, "file"}));
  EXPECT_EQ(names.problems[1].subject, (core::Subject{"geometry", 0, "file"}));
  EXPECT_EQ(names.problems[1].severity, core::Severity::warning);
}

// Numbers go on where the last one of the name stopped; each trying all of them took minutes.
TEST(OutputNames, ManyOfOneNameAreNumberedAtOnce) {
  const scene::Scene scene = scene_with(std::vector<std::string>(20000, "a.bin"));
  EXPECT_EQ(output_names(scene, {}).simulations.back().filename(), "a-20000.bin");
}

TEST(OutputNames, NamesThatAFormatMakesAlikeGiveAWarning) {
  OutputRules rules;
  rules.format = scene::FileFormat::hdf5;
  const OutputNames names = output_names(scene_with({"a.asc", "a.bin"}), rules);
  EXPECT_EQ(names.simulations.at(1), "a-2.h5");
  EXPECT_EQ(names.problems.size(), 1U);
}

TEST(OutputNames, FormatChangesTheExtensionOfRecordings) {
  OutputRules rules;
  rules.format = scene::FileFormat::hdf5;
  const OutputNames names = output_names(scene_with({"a.asc", "b", "c.d.bin"}, {"t.txt"}), rules);
  EXPECT_EQ(names.simulations.at(0), "a.h5");
  EXPECT_EQ(names.simulations.at(1), "b.h5");
  EXPECT_EQ(names.simulations.at(2), "c.d.h5");
  EXPECT_EQ(names.tables.at(0), "t.txt");
}

TEST(OutputNames, NamesWithoutAFileAreErrors) {
  for (const char* name : {"", "x/", "..", ".", "c:"}) {
    const OutputNames names = output_names(scene_with({name}), {});
    ASSERT_EQ(names.problems.size(), 1U) << name;
    EXPECT_EQ(names.problems[0].severity, core::Severity::error) << name;
  }
}

class OutputPlaces : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "there.asc") << "old";
    std::ofstream(folder_ / "scene.scr") << "script";
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST_F(OutputPlaces, ExistingFilesNeedForce) {
  EXPECT_EQ(problems_of_output(folder_ / "there.asc", folder_ / "scene.scr", false).size(), 1U);
  EXPECT_TRUE(problems_of_output(folder_ / "there.asc", folder_ / "scene.scr", true).empty());
  EXPECT_TRUE(problems_of_output(folder_ / "new.asc", folder_ / "scene.scr", false).empty());
}

TEST_F(OutputPlaces, FoldersAndTheScriptAreNeverReplaced) {
  EXPECT_EQ(problems_of_output(folder_, folder_ / "scene.scr", true).size(), 1U);
  EXPECT_EQ(problems_of_output(folder_ / "." / "scene.scr", folder_ / "scene.scr", true).size(), 1U);
}

TEST_F(OutputPlaces, EverySourceIsKept) {
  const OutputCare care{{folder_ / "scene.scr", folder_ / "there.asc", folder_ / "missing"}, true, "-o"};
  for (const char* name : {"scene.scr", "there.asc"}) {
    const core::Problems problems = problems_of_output(folder_ / name, care);
    ASSERT_EQ(problems.size(), 1U) << name;
    EXPECT_EQ(problems[0].message, "the output would replace the file that it is made from");
    EXPECT_EQ(problems[0].hint, "name another file with -o");
  }
  EXPECT_TRUE(problems_of_output(folder_ / "new.asc", care).empty());
}

TEST_F(OutputPlaces, HintsNameWhatTheCommandHas) {
  const auto hint = [&](const std::string& option) {
    return problems_of_output(folder_ / "there.asc", {{}, false, option}).at(0).hint;
  };
  EXPECT_EQ(hint(""), "replace it with --force, or choose another folder with --out");
  EXPECT_EQ(hint("--out"), "replace it with --force, or name another file with --out");
  EXPECT_EQ(hint("OUT"), "replace it with --force, or name another file as OUT");
}

}  // namespace output_names_test
}  // namespace sarsim::workflow
