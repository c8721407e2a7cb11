#include "simulate/resolve/compiled_simd.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "simulate/resolve/simd_level.hpp"

namespace sarsim::simulate {
namespace compiled_simd_test {

TEST(CompiledSimd, HoldsEveryLevelThatTheProcessorCanUseInTheSameOrder) {
  const std::vector<std::string> compiled = compiled_simd_levels();
  const std::vector<std::string> usable = simd_levels();
  ASSERT_FALSE(usable.empty());
  auto place = compiled.begin();
  for (const std::string& level : usable) {
    place = std::find(place, compiled.end(), level);
    EXPECT_NE(place, compiled.end()) << level;
  }
}

TEST(CompiledSimd, NamesEachLevelOnce) {
  const std::vector<std::string> compiled = compiled_simd_levels();
  const std::set<std::string> once(compiled.begin(), compiled.end());
  EXPECT_EQ(once.size(), compiled.size());
}

TEST(CompiledSimd, LibraryHasAVersionOfThreeNumbers) {
  EXPECT_THAT(simd_library_version(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
}

}  // namespace compiled_simd_test
}  // namespace sarsim::simulate
