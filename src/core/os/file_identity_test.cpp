#include "core/os/file_identity.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/test_folder.hpp"

namespace sarsim::core {
namespace file_identity_test {

namespace fs = std::filesystem;

TEST(FileIdentity, IsThatOfTheFileWhateverItsName) {
  const test::TestFolder folder;
  const fs::path file = folder.path() / "a";
  std::ofstream(file) << "three";
  fs::create_hard_link(file, folder.path() / "b");
  fs::create_symlink("a", folder.path() / "c");
  std::ofstream(folder.path() / "d") << "three";
  EXPECT_EQ(identity_of_file(file), identity_of_file(folder.path() / "b"));
  EXPECT_EQ(identity_of_file(file), identity_of_file(folder.path() / "c"));
  EXPECT_NE(identity_of_file(file), identity_of_file(folder.path() / "d"));
  EXPECT_EQ(identity_of_file(folder.path()), std::nullopt);
  EXPECT_NE(identity_of(folder.path()), std::nullopt);
  EXPECT_EQ(identity_of(folder.path() / "none"), std::nullopt);
}

TEST(FileIdentity, StatusTellsLinksFromWhatTheyLeadTo) {
  const test::TestFolder folder;
  std::ofstream(folder.path() / "a") << "three";
  fs::create_symlink("a", folder.path() / "c");
  ASSERT_TRUE(file_status(folder.path() / "c"));
  EXPECT_TRUE(file_status(folder.path() / "c")->regular);
  EXPECT_EQ(file_status(folder.path() / "c")->bytes, 5U);
  EXPECT_FALSE(link_status(folder.path() / "c")->regular);
  EXPECT_TRUE(file_status(folder.path())->folder);
}

}  // namespace file_identity_test
}  // namespace sarsim::core
