#include "core/os/process.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/test_folder.hpp"

namespace sarsim::core {
namespace process_test {

TEST(Process, IsKnownByItsNumberAndItsBeginning) {
  const std::uint64_t start = process_start(process_id());
  EXPECT_TRUE(is_running(process_id(), start));
  EXPECT_TRUE(is_running(process_id(), 0));
  if (start != 0) {
    EXPECT_FALSE(is_running(process_id(), start + 1));
  }
  EXPECT_FALSE(is_running(std::numeric_limits<int>::max(), 0));
  EXPECT_FALSE(host_name().empty());
}

TEST(Process, SaysWhyAFileMayNotBeWritten) {
  const test::TestFolder folder;
  EXPECT_FALSE(write_failure(folder.path()));
  EXPECT_EQ(write_failure(folder.path() / "none"), std::errc::no_such_file_or_directory);
}

}  // namespace process_test
}  // namespace sarsim::core
