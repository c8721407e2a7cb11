#include "core/os/output_folder.hpp"

#include <gmock/gmock.h>

#include <cerrno>
#include <system_error>

#include "support/test_folder.hpp"

namespace sarsim::core {
namespace output_folder_test {

namespace fs = std::filesystem;
using test::contents;
using test::put;
using test::TestFolder;

bool any(const fs::path&) { return true; }
bool none(const fs::path&) { return false; }

// Number of the error of making a folder with one file in it; 0 where it was made.
int error_of_making(const fs::path& path, bool replace, const FolderTest& ours, const char* text = "new") {
  try {
    OutputFolder folder(path, replace, ours);
    fs::create_directory(folder.working_path() / "inner");
    put(folder.working_path() / "inner" / "file", text);
    folder.commit();
  } catch (const std::system_error& error) {
    return error.code().value();
  }
  return 0;
}

TEST(OutputFolder, AppearsUnderItsNameWhenItIsComplete) {
  const TestFolder folder;
  {
    OutputFolder output(folder / "a/", false, none);
    put(output.working_path() / "file", "text");
    EXPECT_FALSE(fs::exists(folder / "a"));
    output.commit();
  }
  EXPECT_EQ(contents(folder / "a"), "file\ntext\n");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(OutputFolder, LeavesNothingWithoutCommit) {
  const TestFolder folder;
  {
    const OutputFolder output(folder / "a", false, none);
    fs::create_directories(output.working_path() / "one" / "two");
    put(output.working_path() / "one" / "two" / "file", "text");
    fs::create_symlink("/", output.working_path() / "link");
  }
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(OutputFolder, ReplacesOnlyWhatMayBeReplaced) {
  const TestFolder folder;
  fs::create_directory(folder / "a");
  put(folder / "a/theirs", "old");
  EXPECT_EQ(error_of_making(folder / "a", false, any), EEXIST);
  EXPECT_EQ(error_of_making(folder / "a", true, none), ENOTEMPTY);
  EXPECT_EQ(contents(folder / "a"), "theirs\nold\n");
  EXPECT_EQ(error_of_making(folder / "a", true, any), 0);
  EXPECT_EQ(contents(folder / "a"), "inner/file\nnew\n");
  put(folder / "file", "text");
  EXPECT_EQ(error_of_making(folder / "file", true, any), ENOTDIR);
  EXPECT_EQ(contents(folder / "file"), "text");
  EXPECT_EQ(folder.entries(), 2U);
}

TEST(OutputFolder, LooksAgainBeforeItReplaces) {
  const TestFolder folder;
  OutputFolder output(folder / "a", true, none);
  fs::create_directory(folder / "a");
  put(folder / "a/theirs", "old");
  EXPECT_THROW(output.commit(), std::system_error);
  EXPECT_EQ(contents(folder / "a"), "theirs\nold\n");
}

TEST(OutputFolder, KeepsALinkAndReplacesWhereItLeads) {
  const TestFolder folder;
  fs::create_directory(folder / "real");
  put(folder / "real/old", "old");
  fs::create_directory_symlink("real", folder / "link");
  EXPECT_EQ(error_of_making(folder / "link", true, any), 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(contents(folder / "real"), "inner/file\nnew\n");
}

TEST(OutputFolder, RemovesManyFilesAtOnce) {
  const TestFolder folder;
  fs::create_directories(folder / "a/b");
  for (int i = 0; i < 2000; ++i) put(folder / ("a/b/a name that takes its room " + std::to_string(i)), "");
  remove_folder(folder / "a");
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace output_folder_test
}  // namespace sarsim::core
