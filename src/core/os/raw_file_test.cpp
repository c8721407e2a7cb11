#include "core/os/raw_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <array>
#include <functional>
#include <span>
#include <system_error>
#include <utility>

#include "core/report/invalid_request.hpp"
#include "support/test_folder.hpp"

namespace sarsim::core {
namespace raw_file_test {

namespace fs = std::filesystem;

using test::contents;
using test::put;
using test::TestFolder;

constexpr std::array all_modes{RawFile::Mode::read, RawFile::Mode::write, RawFile::Mode::append};
const auto no_bytes = std::span<const std::byte>();

Problem refusal_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InvalidRequest& refused) {
    return refused.problems.at(0);
  }
  ADD_FAILURE() << "not refused";
  return {};
}

Problem refusal_of(const fs::path& path, RawFile::Mode mode) {
  return refusal_of([&] { const RawFile file(path, mode); });
}

TEST(RawFile, IsARegularFile) {
  const TestFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  fs::create_directory(folder / "folder");
  const std::array<std::pair<fs::path, const char*>, 3> others{
      {{folder / "pipe", "a pipe"}, {folder / "folder", "a folder"}, {"/dev/null", "a device"}}};
  for (const RawFile::Mode mode : all_modes) {
    for (const auto& [path, kind] : others) {
      const Problem problem = refusal_of(path, mode);
      EXPECT_EQ(problem.message, "this is not a regular file");
      EXPECT_EQ(problem.found, kind);
      EXPECT_EQ(problem.place.file, path.string());
      EXPECT_FALSE(problem.hint.empty());
    }
  }
}

TEST(RawFile, IsReachedByALinkForReadingAlone) {
  const TestFolder folder;
  put(folder / "victim", "mine");
  fs::create_symlink("victim", folder / "link");
  EXPECT_EQ(RawFile(folder / "link", RawFile::Mode::read).size(), 4U);
  for (const RawFile::Mode mode : {RawFile::Mode::write, RawFile::Mode::append})
    EXPECT_EQ(refusal_of(folder / "link", mode).found, "a symbolic link");
  EXPECT_EQ(refusal_of([&] { static_cast<void>(replace_file(folder / "link", no_bytes)); }).found, "a symbolic link");
  fs::create_symlink("nowhere", folder / "dangling");
  EXPECT_EQ(refusal_of([&] { static_cast<void>(replace_file(folder / "dangling", no_bytes)); }).found,
            "a symbolic link");
  EXPECT_FALSE(fs::exists(folder / "nowhere"));
  EXPECT_EQ(contents(folder / "victim"), "mine");
}

TEST(RawFile, ThatIsWrittenHasNoOtherName) {
  const TestFolder folder;
  put(folder / "victim", "mine");
  fs::create_hard_link(folder / "victim", folder / "name");
  EXPECT_EQ(RawFile(folder / "name", RawFile::Mode::read).size(), 4U);
  for (const RawFile::Mode mode : {RawFile::Mode::write, RawFile::Mode::append}) {
    const Problem problem = refusal_of(folder / "name", mode);
    EXPECT_EQ(problem.found, "2 hard links");
    EXPECT_EQ(problem.expected, "a file with one name");
  }
  // Another file takes the name; the one with two keeps its bytes.
  static_cast<void>(replace_file(folder / "name", no_bytes));
  EXPECT_EQ(contents(folder / "victim"), "mine");
  EXPECT_NO_THROW(RawFile(folder / "name", RawFile::Mode::write));
}

TEST(RawFile, NamesTheFileThatFails) {
  const TestFolder folder;
  try {
    const RawFile file(folder / "none", RawFile::Mode::read);
    FAIL() << "opened";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.what(), "cannot read " + (folder / "none").string() + ": No such file or directory");
  }
}

}  // namespace raw_file_test
}  // namespace sarsim::core
