#include "core/os/free_memory.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace sarsim::core {
namespace free_memory_test {

TEST(FreeMemory, IsKnownWhereTheSystemSays) {
  const auto bytes = free_memory_bytes();
  ASSERT_EQ(bytes.has_value(), std::filesystem::exists("/proc/meminfo"));
  if (bytes) {
    EXPECT_GT(*bytes, std::size_t{1} << 20);
  }
}

}  // namespace free_memory_test
}  // namespace sarsim::core
