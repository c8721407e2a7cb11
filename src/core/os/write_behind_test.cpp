#include "core/os/write_behind.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "support/test_folder.hpp"

namespace sarsim::core {
namespace write_behind_test {

// Bytes are written as ever, in whatever pieces; the disk's errors alone are told.
TEST(WriteBehind, TakesAnyPieces) {
  const test::TestFolder folder;
  const int file = ::open((folder / "file").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_GE(file, 0);
  std::uint64_t end = 0;
  for (const std::size_t size : {std::size_t{1}, write_behind_bytes - 1, write_behind_bytes, std::size_t{77},
                                 20 * write_behind_bytes, std::size_t{5}}) {
    const std::vector<std::byte> bytes(size, std::byte{1});
    ASSERT_EQ(::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(end)), static_cast<ssize_t>(size));
    errno = ENOENT;
    EXPECT_EQ(write_behind(file, end, size), 0);
    EXPECT_EQ(errno, ENOENT);
    end += size;
  }
  ::close(file);
}

// Pipes and the like have nothing to bring to a disk.
TEST(WriteBehind, MindsNothingThatCannotBeAsked) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  EXPECT_EQ(write_behind(ends[1], 0, 3 * write_behind_bytes), 0);
  EXPECT_EQ(write_behind(ends[1], 20 * write_behind_bytes, write_behind_bytes), 0);
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace write_behind_test
}  // namespace sarsim::core
