// Scripts and data files on disk.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace reader_file_test {

namespace fs = std::filesystem;

constexpr const char* target_with_file = "$TARGET E 0 0 0 0 0 0 1 0 DIR 1 2 3 4 OTHER LIN FILE gain.dat\n";

class ScriptOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("sarsim_" + std::string(test->name()) + "_" + std::to_string(getpid()));
    fs::create_directories(folder_ / "elsewhere");
    start_ = fs::current_path();
    fs::current_path(folder_ / "elsewhere");
  }
  void TearDown() override {
    fs::current_path(start_);
    fs::remove_all(folder_);
  }

  static void write(const fs::path& path, std::string_view text) { std::ofstream(path, std::ios::binary) << text; }

  core::Problem only_problem_of(const fs::path& path) {
    const core::Problems problems = read_script_file(path).problems;
    EXPECT_EQ(problems.size(), 1U);
    return problems.empty() ? core::Problem{} : problems[0];
  }

  fs::path folder_;
  fs::path start_;
};

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

TEST_F(ScriptOnDisk, TakesDataFromItsOwnFolderFirst) {
  write(folder_ / "a.scr", target_with_file);
  write(folder_ / "gain.dat", "1 0 -1");
  write("gain.dat", "1 0 -2");
  const ScriptReading reading = read_script_file(folder_ / "a.scr");
  EXPECT_TRUE(reading.problems.empty());
  EXPECT_EQ(reading.scene.targets.at(0).traits->gain_db.part[0].knots.at(0).y, -1.0);
  EXPECT_EQ(reading.scene.targets.at(0).traits->gain_db.file, "gain.dat");
}

TEST_F(ScriptOnDisk, TakesDataFromTheCurrentFolderOtherwise) {
  write(folder_ / "a.scr", target_with_file);
  write("gain.dat", "1 0 -2");
  const ScriptReading reading = read_script_file(folder_ / "a.scr");
  EXPECT_TRUE(reading.problems.empty());
  EXPECT_EQ(reading.scene.targets.at(0).traits->gain_db.part[0].knots.at(0).y, -2.0);
}

TEST_F(ScriptOnDisk, TakesBackslashesBetweenFolders) {
  write(folder_ / "a.scr", "$TARGET E 0 0 0 0 0 0 1 0 DIR 1 2 3 4 OTHER LIN FILE sub\\gain.dat\n");
  fs::create_directories(folder_ / "sub");
  write(folder_ / "sub/gain.dat", "1 0 -3");
  EXPECT_TRUE(read_script_file(folder_ / "a.scr").problems.empty());
}

TEST_F(ScriptOnDisk, SaysInWhichFoldersAMissingDataFileWasLookedFor) {
  write(folder_ / "a.scr", target_with_file);
  const core::Problem problem = only_problem_of(folder_ / "a.scr");
  EXPECT_TRUE(holds(problem.message, (folder_ / "gain.dat").string() + " and gain.dat")) << problem.message;
  EXPECT_EQ(problem.place.line, 1U);
  EXPECT_EQ(problem.place.column, 54U);
}

TEST_F(ScriptOnDisk, TellsWhichFileADataFileIs) {
  EXPECT_TRUE(data_file_on_disk(folder_, "gain.dat").empty());
  write(folder_ / "gain.dat", "1 0 -3");
  EXPECT_EQ(data_file_on_disk(folder_, "gain.dat"), folder_ / "gain.dat");
  EXPECT_EQ(data_file_on_disk(folder_, "sub\\..\\gain.dat"), folder_ / "gain.dat");
}

TEST_F(ScriptOnDisk, ReportsAFolderInPlaceOfADataFile) {
  write(folder_ / "a.scr", target_with_file);
  fs::create_directories(folder_ / "gain.dat");
  EXPECT_TRUE(holds(only_problem_of(folder_ / "a.scr").message, "is a folder"));
}

TEST_F(ScriptOnDisk, ReportsAnEmptyDataFile) {
  write(folder_ / "a.scr", target_with_file);
  write(folder_ / "gain.dat", "");
  EXPECT_TRUE(holds(only_problem_of(folder_ / "a.scr").message, "holds no numbers"));
}

TEST_F(ScriptOnDisk, ReportsAScriptThatNamesItselfAsItsData) {
  write(folder_ / "gain.dat", target_with_file);
  EXPECT_TRUE(holds(only_problem_of(folder_ / "gain.dat").message, "this is a script"));
}

TEST_F(ScriptOnDisk, ReportsWhatIsNoScript) {
  EXPECT_TRUE(holds(only_problem_of(folder_ / "none.scr").message, "no such file"));
  EXPECT_EQ(only_problem_of(folder_ / "none.scr").place.file, (folder_ / "none.scr").string());
  EXPECT_TRUE(holds(only_problem_of(folder_).message, "is a folder"));
  EXPECT_TRUE(holds(only_problem_of("/dev/zero").message, "is not a file"));
  EXPECT_TRUE(holds(only_problem_of("").message, "cannot read the script"));
  write(folder_ / "b.scr", std::string_view("\x89PNG\r\n\x1A\n\0\0", 10));
  EXPECT_TRUE(holds(only_problem_of(folder_ / "b.scr").message, "it seems to be a PNG picture"));
  write(folder_ / "b.scr", std::string_view("$OPTIONS\n\1\2\n"));
  EXPECT_TRUE(holds(only_problem_of(folder_ / "b.scr").message, "not a text file"));
}

TEST_F(ScriptOnDisk, ReportsAFileThatMayNotBeRead) {
  write(folder_ / "a.scr", target_with_file);
  fs::permissions(folder_ / "a.scr", fs::perms::none);
  if (std::ifstream(folder_ / "a.scr")) GTEST_SKIP() << "this user may read every file";
  EXPECT_TRUE(holds(only_problem_of(folder_ / "a.scr").message, "Permission denied"));
}

TEST_F(ScriptOnDisk, RefusesAFileOfMoreThanTheLimitWithoutReadingIt) {
  write(folder_ / "a.scr", "");
  fs::resize_file(folder_ / "a.scr", largest_script_bytes + 1);  // sparse: takes no space on disk
  EXPECT_TRUE(holds(only_problem_of(folder_ / "a.scr").message, "is larger than"));
}

}  // namespace reader_file_test
}  // namespace sarsim::scene
