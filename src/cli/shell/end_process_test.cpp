#include "cli/shell/end_process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include <gtest/gtest.h>

#include "support/test_folder.hpp"

namespace sarsim::cli {
namespace end_process_test {

TEST(EndProcess, EndsWithItsStatusAndLeavesNoDescriptorOpen) {
  const test::TestFolder folder;
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const int file = ::open((folder / "file").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    ::unlink((folder / "file").c_str());
    end_process(file >= 0 ? 42 : 1);
  }
  ::close(ends[1]);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 42);
  // Nobody keeps the pipe: whoever reads from it comes to its end.
  char byte = 0;
  EXPECT_EQ(::read(ends[0], &byte, 1), 0);
  ::close(ends[0]);
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace end_process_test
}  // namespace sarsim::cli
