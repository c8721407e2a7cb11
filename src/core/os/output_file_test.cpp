#include "core/os/output_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/time.h>

#include <string>
#include <system_error>
#include <thread>

#include "support/test_folder.hpp"

namespace sarsim::core {
namespace output_file_test {

using test::contents;
using test::put;
using test::SmallDisk;
using test::TestFolder;
using testing::HasSubstr;

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

// The error that an action ends with; a failed test where there is none.
template <class Action>
std::system_error error_of(Action action) {
  try {
    action();
  } catch (const std::system_error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return std::system_error(std::error_code());
}

TEST(OutputFile, AppearsUnderItsNameOnlyWithCommit) {
  const TestFolder folder;
  OutputFile file(folder / "a.bin", false);
  file.write(bytes_of("hello"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.bin"));
  EXPECT_TRUE(std::filesystem::exists(file.working_path()));
  EXPECT_THAT(file.working_path().filename().string(), testing::StartsWith(".a.bin.partial-"));
  file.commit();
  EXPECT_EQ(contents(folder / "a.bin"), "hello");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
  const TestFolder folder;
  { OutputFile(folder / "a.bin", false).write(bytes_of("hello")); }
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(OutputFile, WritesInTheMiddleAndReadsBack) {
  const TestFolder folder;
  OutputFile file(folder / "a.bin", false);
  file.write_at(4, bytes_of("xy"));
  file.write(bytes_of("ab"));
  std::array<std::byte, 8> back{};
  file.read_at(0, back);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(back.data()), 8), std::string("ab\0\0xy\0\0", 8));
  file.resize(5);
  file.commit();
  EXPECT_EQ(contents(folder / "a.bin"), std::string("ab\0\0x", 5));
}

TEST(OutputFile, RefusesAnExistingFileAtOnce) {
  const TestFolder folder;
  put(folder / "a.bin", "old");
  const auto error = error_of([&] { OutputFile(folder / "a.bin", false); });
  EXPECT_EQ(error.code().value(), EEXIST);
  EXPECT_THAT(error.what(), HasSubstr("a.bin"));
  EXPECT_EQ(contents(folder / "a.bin"), "old");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(OutputFile, RefusesAFileThatAppearsMeanwhile) {
  const TestFolder folder;
  OutputFile file(folder / "a.bin", false);
  file.write(bytes_of("new"));
  put(folder / "a.bin", "theirs");
  EXPECT_EQ(error_of([&] { file.commit(); }).code().value(), EEXIST);
  EXPECT_EQ(contents(folder / "a.bin"), "theirs");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(OutputFile, ReplacesAndKeepsPermissions) {
  const TestFolder folder;
  put(folder / "a.bin", "old");
  ::chmod((folder / "a.bin").c_str(), 0640);
  OutputFile file(folder / "a.bin", true);
  file.write(bytes_of("new"));
  EXPECT_EQ(contents(folder / "a.bin"), "old");
  file.commit();
  EXPECT_EQ(contents(folder / "a.bin"), "new");
  struct stat status {};
  ASSERT_EQ(::stat((folder / "a.bin").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST(OutputFile, RefusesFolders) {
  const TestFolder folder;
  EXPECT_EQ(error_of([&] { OutputFile(folder.path(), true); }).code().value(), EISDIR);
  EXPECT_EQ(error_of([&] { OutputFile(folder.path() / "", true); }).code().value(), EISDIR);
  EXPECT_EQ(error_of([&] { OutputFile(folder.path() / "new" / "", true); }).code().value(), EISDIR);
  EXPECT_EQ(error_of([&] { OutputFile("", true); }).code().value(), ENOENT);
}

TEST(OutputFile, NamesAMissingFolder) {
  const TestFolder folder;
  const auto error = error_of([&] { OutputFile(folder.path() / "none" / "a.bin", false); });
  EXPECT_EQ(error.code().value(), ENOENT);
  EXPECT_THAT(error.what(), HasSubstr((folder.path() / "none").string()));
}

TEST(OutputFile, NamesAFolderThatMayNotBeWritten) {
  const TestFolder folder;
  const SmallDisk disk(folder / "disk", "size=64k");
  if (!disk.mounted()) GTEST_SKIP() << "may not mount a file system here";
  ASSERT_EQ(::mount("none", (folder / "disk").c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr), 0);
  const auto error = error_of([&] { OutputFile(folder.path() / "disk" / "a.bin", false); });
  EXPECT_EQ(error.code().value(), EROFS);
  EXPECT_THAT(error.what(), HasSubstr("cannot create"));
}

TEST(OutputFile, ReplacesWhatALinkPointsTo) {
  const TestFolder folder;
  put(folder / "target.bin", "old");
  std::filesystem::create_symlink("target.bin", folder / "link.bin");
  OutputFile file(folder / "link.bin", true);
  file.write(bytes_of("new"));
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.bin"));
  EXPECT_EQ(contents(folder / "target.bin"), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "target.bin"));
}

TEST(OutputFile, CreatesWhatADanglingLinkPointsTo) {
  const TestFolder folder;
  std::filesystem::create_symlink("target.bin", folder / "link.bin");
  OutputFile file(folder / "link.bin", false);
  file.write(bytes_of("new"));
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.bin"));
  EXPECT_EQ(contents(folder / "target.bin"), "new");
}

TEST(OutputFile, RefusesALoopOfLinks) {
  const TestFolder folder;
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  EXPECT_EQ(error_of([&] { OutputFile(folder / "a", true); }).code().value(), ELOOP);
}

TEST(OutputFile, WritesDevicesDirectly) {
  OutputFile file("/dev/null", false);
  file.write(bytes_of("gone"));
  file.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(OutputFile, WritesAPipeInOrder) {
  const TestFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = contents(folder / "pipe"); });
  {
    OutputFile file(folder / "pipe", false);
    EXPECT_FALSE(file.seekable());
    file.write(bytes_of("through"));
    file.commit();
  }
  reader.join();
  EXPECT_EQ(got, "through");
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
}

TEST(OutputFile, ReportsAFullDeviceAndIsNotCompletedThen) {
  OutputFile file("/dev/full", false);
  const auto error = error_of([&] { file.write(bytes_of("more")); });
  EXPECT_EQ(error.code().value(), ENOSPC);
  EXPECT_THAT(error.what(), HasSubstr("cannot write /dev/full"));
  EXPECT_THROW(file.commit(), std::logic_error);
}

TEST(OutputFile, GoesOnAfterPartialWritesAndSignals) {
  const TestFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  struct sigaction action {};
  struct sigaction before {};
  action.sa_handler = [](int) {};  // Without SA_RESTART: calls end with EINTR or with a part of their work.
  ::sigaction(SIGALRM, &action, &before);
  const std::string sent(8'000'000, 'x');
  std::size_t got = 0;
  // The slow reader keeps the writer waiting; signals go to the writer alone.
  std::thread reader([&] {
    sigset_t alarm;
    sigemptyset(&alarm);
    sigaddset(&alarm, SIGALRM);
    pthread_sigmask(SIG_BLOCK, &alarm, nullptr);
    std::ifstream stream(folder / "pipe", std::ios::binary);
    std::vector<char> part(200'000);
    while (stream.read(part.data(), static_cast<std::streamsize>(part.size())) || stream.gcount() > 0) {
      got += static_cast<std::size_t>(stream.gcount());
      ::usleep(5000);
    }
  });
  {
    OutputFile file(folder / "pipe", false);
    const itimerval often{{0, 200}, {0, 200}};
    ::setitimer(ITIMER_REAL, &often, nullptr);
    file.write(bytes_of(sent));
    const itimerval never{};
    ::setitimer(ITIMER_REAL, &never, nullptr);
    file.commit();
  }
  reader.join();
  ::sigaction(SIGALRM, &before, nullptr);
  EXPECT_EQ(got, sent.size());
}

TEST(OutputFile, TakesNamesOfEveryLength) {
  const TestFolder folder;
  const std::string name(255, 'n');
  OutputFile file(folder / name, false);
  file.write(bytes_of("x"));
  file.commit();
  EXPECT_EQ(contents(folder / name), "x");
}

}  // namespace output_file_test
}  // namespace sarsim::core
