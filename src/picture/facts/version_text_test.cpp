#include "picture/facts/version_text.hpp"

#include <gmock/gmock.h>

#include "core/build/version.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace sarsim::picture {
namespace version_text_test {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

constexpr core::Build development{"commit 0123456789ab, 5 after v1.2.3", "Debug", "GNU 12.2.0", "Linux x86_64"};

TEST(VersionText, FirstLineHoldsProgramAndNumberAlone) {
  EXPECT_THAT(version_text("sarsim-x", development, {}),
              StartsWith(std::string("sarsim-x ") + core::program_version + "\nSource: "));
}

TEST(VersionText, SaysWhatTheProgramWasBuiltFromAndHow) {
  const std::string text = version_text("sarsim", development, {});
  EXPECT_THAT(text, HasSubstr("\nSource: commit 0123456789ab, 5 after v1.2.3\n"));
  EXPECT_THAT(text, HasSubstr("\nBuild: Debug, GNU 12.2.0, Linux x86_64\n"));
}

TEST(VersionText, SourcesOfAReleaseAreCalledSo) {
  EXPECT_THAT(version_text("sarsim", core::Build{"", "Release", "GNU 12.2.0", "Linux x86_64"}, {}),
              HasSubstr("\nSource: the release\n"));
}

TEST(VersionText, SaysWhichInstructionSetIsUsed) {
  const std::string text = version_text("sarsim", development, {});
  EXPECT_THAT(text, HasSubstr("\nSIMD: " + simulate::simd_level() + " in use; compiled in: "));
}

TEST(VersionText, NamesLibrariesWithTheirVersions) {
  const std::string text = version_text("sarsim", development, {{"Other", "7.8"}});
  for (const char* library : {"FFTW", "HDF5", "Highway", "fmt"})
    EXPECT_THAT(text, ContainsRegex(std::string(library) + " [0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(text, HasSubstr(", Other 7.8\nLicence GPL-3.0-or-later"));
}

}  // namespace version_text_test
}  // namespace sarsim::picture
