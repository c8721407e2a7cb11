#include "core/os/scratch_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <system_error>

#include "support/test_folder.hpp"

namespace sarsim::core {
namespace scratch_file_test {

namespace fs = std::filesystem;

TEST(ScratchFile, HoldsBytesAndHasNoName) {
  const test::TestFolder folder;
  const ScratchFile file(folder.path());
  EXPECT_TRUE(fs::is_empty(folder.path()));
  file.reserve(100);
  const std::array<std::byte, 3> bytes{std::byte{1}, std::byte{2}, std::byte{3}};
  EXPECT_EQ(file.write_some(50, bytes), 3U);
  std::array<std::byte, 3> back{};
  EXPECT_EQ(file.read_some(50, back), 3U);
  EXPECT_EQ(back, bytes);
  EXPECT_THROW(static_cast<void>(file.read_some(1000, back)), std::system_error);
  EXPECT_THROW(ScratchFile(folder.path() / "none"), std::system_error);
}

}  // namespace scratch_file_test
}  // namespace sarsim::core
