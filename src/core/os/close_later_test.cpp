#include "core/os/close_later.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "support/test_folder.hpp"

namespace sarsim::core {
namespace close_later_test {

// A file of so many bytes, none of which takes room, and without a name.
int removed_file(const test::TestFolder& folder, off_t bytes) {
  const int file = ::open((folder / "file").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  EXPECT_GE(file, 0);
  EXPECT_EQ(::ftruncate(file, bytes), 0);
  EXPECT_EQ(::unlink((folder / "file").c_str()), 0);
  return file;
}

bool is_open(int descriptor) { return ::fcntl(descriptor, F_GETFD) >= 0; }

TEST(CloseLater, ClosesLargeFilesSoonAndSmallOnesAtOnce) {
  const test::TestFolder folder;
  const std::array small{removed_file(folder, 10)};
  close_later(small);
  EXPECT_FALSE(is_open(small[0]));
  const std::array large{removed_file(folder, off_t{1} << 32U), removed_file(folder, off_t{1} << 30U)};
  close_later(large);
  for (int i = 0; i < 1000 && closes_later(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(closes_later());
  for (const int file : large) EXPECT_FALSE(is_open(file));
}

// Somebody has the file under another name: nothing of it goes.
TEST(CloseLater, LeavesTheContentOfFilesThatHaveAName) {
  const test::TestFolder folder;
  const int file = removed_file(folder, 10);
  ::close(file);
  const std::array named{::open((folder / "named").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)};
  ASSERT_EQ(::ftruncate(named[0], off_t{1} << 30U), 0);
  close_later(named);
  EXPECT_FALSE(is_open(named[0]));
  struct stat status {};
  ASSERT_EQ(::stat((folder / "named").c_str(), &status), 0);
  EXPECT_EQ(status.st_size, off_t{1} << 30U);
}

}  // namespace close_later_test
}  // namespace sarsim::core
