#include "core/os/cache_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace sarsim::core {
namespace cache_folder_test {

namespace fs = std::filesystem;

TEST(UserCacheFolder, IsThatOfTheEnvironment) {
  const char* old = std::getenv("XDG_CACHE_HOME");
  const std::string kept = old == nullptr ? "" : old;
  ::setenv("XDG_CACHE_HOME", "/some/folder", 1);
  EXPECT_EQ(user_cache_folder(), fs::path("/some/folder/sarsim"));
  ::setenv("XDG_CACHE_HOME", "relative", 1);
  const fs::path fallback = user_cache_folder();
  EXPECT_TRUE(fallback.empty() || fallback.filename() == "sarsim");
  EXPECT_NE(fallback, fs::path("relative/sarsim"));
  old == nullptr ? ::unsetenv("XDG_CACHE_HOME") : ::setenv("XDG_CACHE_HOME", kept.c_str(), 1);
}

}  // namespace cache_folder_test
}  // namespace sarsim::core
