#include "scene/edit/recovery.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "scene/edit/text_file.hpp"

namespace sarsim::scene {

namespace recovery_test {

namespace fs = std::filesystem;

// The number of a process that has ended.
long dead_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  int status = 0;
  ::waitpid(child, &status, 0);
  return child;
}

class RecoveryFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("sarsim-recovery-test-" + std::to_string(::getpid())) / "deep";
    fs::remove_all(folder_.parent_path());
  }
  void TearDown() override { fs::remove_all(folder_.parent_path()); }

  // The only copy in the folder.
  [[nodiscard]] fs::path copy() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().extension() == ".recovery") files.push_back(entry.path());
    EXPECT_EQ(files.size(), 1U);
    return files.at(0);
  }

  fs::path folder_;
};

TEST_F(RecoveryFolder, GivesBackWhatADeadProgramLeft) {
  const Recovery recovery(folder_, dead_process());
  const std::string text = "$PLATFORM Earth\r\n! \xE9 and a\nline";
  recovery.keep("/scenes/with a\nline end.scr", text);
  const std::vector<Recovery::Copy> copies = Recovery::orphans(folder_);
  ASSERT_EQ(copies.size(), 1U);
  EXPECT_EQ(copies[0].text, text);
  EXPECT_EQ(copies[0].document, "/scenes/with a\nline end.scr");
  Recovery::discard(copies[0]);
  EXPECT_TRUE(Recovery::orphans(folder_).empty());
}

TEST_F(RecoveryFolder, KeepsTheLatestCopyOnly) {
  const Recovery recovery(folder_, dead_process());
  recovery.keep("", "first");
  recovery.keep("", "second");
  const std::vector<Recovery::Copy> copies = Recovery::orphans(folder_);
  ASSERT_EQ(copies.size(), 1U);
  EXPECT_EQ(copies[0].text, "second");
  EXPECT_TRUE(copies[0].document.empty());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(RecoveryFolder, LeavesTheCopiesOfRunningProgramsAlone) {
  const Recovery own(folder_, ::getpid());
  own.keep("a.scr", "mine");
  EXPECT_TRUE(Recovery::orphans(folder_).empty());
}

TEST_F(RecoveryFolder, TellsAProgramFromAnotherThatGotItsNumber) {
  const Recovery own(folder_, ::getpid());
  own.keep("a.scr", "mine");
  const fs::path file = copy();
  std::string bytes = read_text_file(file).value();
  const std::size_t start = bytes.find('\n') + 1;
  bytes.replace(start, bytes.find(' ', start) - start, "1");  // started in another time
  std::ofstream(file, std::ios::binary) << bytes;
  if (!fs::exists("/proc/self/stat")) GTEST_SKIP() << "the start of a process is not known here";
  EXPECT_EQ(Recovery::orphans(folder_).size(), 1U);
}

// In containers every start of a program may get the same number.
TEST_F(RecoveryFolder, AProgramThatGetsTheNumberOfADeadOneLeavesItsCopy) {
  if (!fs::exists("/proc/self/stat")) GTEST_SKIP() << "the start of a process is not known here";
  const Recovery own(folder_, ::getpid());
  own.keep("a.scr", "mine");
  const std::string bytes = read_text_file(copy()).value();
  const std::size_t start = bytes.find('\n') + 1;
  const fs::path earlier = folder_ / (std::to_string(::getpid()) + "-1.recovery");
  std::ofstream(earlier, std::ios::binary) << std::string(bytes).replace(start, bytes.find(' ', start) - start, "1");
  own.keep("b.scr", "mine, later");
  own.forget();
  const std::vector<Recovery::Copy> copies = Recovery::orphans(folder_);
  ASSERT_EQ(copies.size(), 1U);
  EXPECT_EQ(copies[0].file, earlier);
  EXPECT_EQ(copies[0].text, "mine");
}

TEST_F(RecoveryFolder, KeepsACopyForEachDocumentOfAProgram) {
  const Recovery first(folder_, dead_process());
  const Recovery second(folder_, dead_process(), 12);
  first.keep("a.scr", "one");
  second.keep("", "two");
  EXPECT_EQ(Recovery::orphans(folder_).size(), 2U);
  first.forget();
  const std::vector<Recovery::Copy> copies = Recovery::orphans(folder_);
  ASSERT_EQ(copies.size(), 1U);
  EXPECT_EQ(copies[0].text, "two");
}

TEST_F(RecoveryFolder, FindsTheCopiesOfEarlierVersions) {
  Recovery(folder_, dead_process()).keep("a.scr", "text");
  fs::rename(copy(), folder_ / (std::to_string(dead_process()) + ".recovery"));
  EXPECT_EQ(Recovery::orphans(folder_).size(), 1U);
}

TEST_F(RecoveryFolder, SweepsAwayWhatKilledWritersLeft) {
  fs::create_directories(folder_);
  const auto part = [this](long process, bool earlier = false) {
    const std::string number = std::to_string(process);
    fs::path file = folder_ / (earlier ? ".sarsim-" + number + "-0.part" : ".1-2.recovery.partial-" + number + "-0");
    std::ofstream(file) << "half a co";
    return file;
  };
  const auto age = [](const fs::path& file) {
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(1));
  };
  const fs::path of_dead = part(dead_process());
  const fs::path of_earlier = part(dead_process(), true);
  const fs::path young = part(dead_process());
  const fs::path of_living = part(::getpid());
  const fs::path foreign = folder_ / ".sarsim-notes.part";
  std::ofstream(foreign) << "x";
  for (const fs::path& file : {of_dead, of_earlier, of_living, foreign}) age(file);
  EXPECT_TRUE(Recovery::orphans(folder_).empty());
  EXPECT_FALSE(fs::exists(of_dead) || fs::exists(of_earlier));
  EXPECT_TRUE(fs::exists(young) && fs::exists(of_living) && fs::exists(foreign));
}

TEST_F(RecoveryFolder, ForgetsWhatWasSaved) {
  const Recovery recovery(folder_, dead_process());
  recovery.keep("a.scr", "text");
  recovery.forget();
  recovery.forget();
  EXPECT_TRUE(Recovery::orphans(folder_).empty());
}

TEST_F(RecoveryFolder, PassesOverDamagedCopiesAndOtherFiles) {
  const Recovery recovery(folder_, dead_process());
  recovery.keep("a.scr", "the text of a scene");
  const fs::path file = copy();
  const std::string whole = read_text_file(file).value();
  std::ofstream(folder_ / "notes.txt") << whole;
  std::ofstream(folder_ / "x.recovery") << whole;
  EXPECT_EQ(Recovery::orphans(folder_).size(), 1U);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    std::ofstream(file, std::ios::binary) << whole.substr(0, size);
    EXPECT_TRUE(Recovery::orphans(folder_).empty()) << size;
  }
  std::string damaged = whole;
  damaged[damaged.size() - 3] ^= 1;
  std::ofstream(file, std::ios::binary) << damaged;
  EXPECT_TRUE(Recovery::orphans(folder_).empty());
}

TEST_F(RecoveryFolder, ListsTheNewestFirst) {
  Recovery(folder_, dead_process()).keep("", "older");
  const fs::path older = copy();
  fs::last_write_time(older, fs::last_write_time(older) - std::chrono::hours(1));
  Recovery(folder_, dead_process()).keep("", "newer");
  const std::vector<Recovery::Copy> copies = Recovery::orphans(folder_);
  ASSERT_EQ(copies.size(), 2U);
  EXPECT_EQ(copies[0].text, "newer");
}

TEST_F(RecoveryFolder, KeepsTheOldCopyWhereTheNewOneCannotBeWritten) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const Recovery recovery(folder_, dead_process());
  recovery.keep("", "old");
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(recovery.keep("", "new"), std::runtime_error);
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_EQ(Recovery::orphans(folder_).at(0).text, "old");
}

TEST_F(RecoveryFolder, WithoutAFolderThereAreNoCopies) {
  EXPECT_TRUE(Recovery::orphans(folder_ / "none").empty());
  fs::create_directories(folder_);
  std::ofstream(folder_ / "file") << "x";
  EXPECT_THROW(Recovery(folder_ / "file", 1).keep("", ""), std::runtime_error);
}

}  // namespace recovery_test
}  // namespace sarsim::scene
