#include "scene/edit/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace sarsim::scene {
namespace text_file_test {

namespace fs = std::filesystem;

class TextFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("sarsim-text-file-test-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  static std::string failure_of(const fs::path& path) {
    try {
      write_text_file(path, "x");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

  fs::path folder_;
};

TEST_F(TextFile, ReplacesAFileAndKeepsItsPermissions) {
  const fs::path file = folder_ / "a.scr";
  write_text_file(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  write_text_file(file, "new");
  EXPECT_EQ(read_text_file(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(files(), 1);
}

TEST_F(TextFile, WritesThroughLinksToFilesThatNeedNotExist) {
  fs::create_symlink("b.scr", folder_ / "a.scr");
  write_text_file(folder_ / "a.scr", "text");
  EXPECT_TRUE(fs::is_symlink(folder_ / "a.scr"));
  EXPECT_EQ(read_text_file(folder_ / "b.scr"), "text");
  EXPECT_EQ(files(), 2);
}

TEST_F(TextFile, WritesDevicesDirectly) {
  EXPECT_EQ(failure_of("/dev/null"), "");
  EXPECT_EQ(failure_of("/dev/full"), "cannot write /dev/full: No space left on device");
}

TEST_F(TextFile, NamesTheFileAndTheCauseOfAFailure) {
  fs::create_symlink("loop", folder_ / "loop");
  const std::string folder = folder_.string();
  EXPECT_EQ(failure_of(folder_), "cannot write " + folder + ": Is a directory");
  EXPECT_EQ(failure_of(folder_ / "loop"), "cannot write " + folder + "/loop: Too many levels of symbolic links");
  EXPECT_EQ(failure_of(folder_ / "none" / "a"), "cannot write " + folder + "/none/a: No such file or directory");
  EXPECT_EQ(files(), 1);
}

TEST_F(TextFile, IsNotReadWhereItIsNoRegularFile) {
  EXPECT_EQ(read_text_file(folder_), std::nullopt);
  EXPECT_EQ(read_text_file(folder_ / "none"), std::nullopt);
}

}  // namespace text_file_test
}  // namespace sarsim::scene
