// `sarsim motion`: what it prints and what it writes.
#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace motion_test {

using testing::HasSubstr;
using testing::Not;

class Motion : public CommandTest {
 protected:
  // A line over a plane, and a recording whose window no echo meets.
  void SetUp() override {
    CommandTest::SetUp();
    write_text(folder_ / "flat.toml", text_of_scene(""));
  }

  static std::string text_of_scene(const std::string& world) {
    return "format = \"sarsim 2\"\n" + world +
           "[[platform]]\nname = \"Plane\"\npath = { type = \"line\", start = [0, 0, 1000], velocity = [100, 0, 0] }\n"
           "[[target]]\nposition = [0, 500, 0]\n[[radar]]\nname = \"R\"\nplatform = \"Plane\"\n[[recording]]\n"
           "radar = \"R\"\nfile = \"a.h5\"\nformat = \"hdf5\"\nrange = [90000, 90500]\ntime = [0, 1]\nsample_rate = "
           "1e6\n";
  }
};

TEST_F(Motion, SaysNothingOfTheWindowsOfRecordings) {
  const Finished loud = sarsim({"motion", "flat.toml", "--platform", "Plane", "--out", "a.csv"});
  EXPECT_EQ(loud.status, 0) << loud.err;
  EXPECT_THAT(loud.out, HasSubstr("states from 0 s to 1 s"));
  EXPECT_EQ(loud.err, "");
  const Finished checked = sarsim({"check", "flat.toml"});
  EXPECT_THAT(checked.out + checked.err, HasSubstr("slant range window"));
}

TEST_F(Motion, IsQuietWhereItIsAskedTo) {
  const Finished quiet = sarsim({"motion", "flat.toml", "--platform", "Plane", "--out", "a.csv", "--quiet"});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  const Finished refused = sarsim({"motion", "flat.toml", "--platform", "Train", "--out", "b.csv", "--quiet"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("no platform 'Train'"));
}

// A date that is none of the file's own is said to be the epoch, or not said.
TEST_F(Motion, SaysNoDateOfCreationThatIsNotTrue) {
  const std::string earth =
      "[world]\nframe = \"earth\"\nepoch = \"2024-04-01T00:00:00Z\"\n"
      "anchor = { latitude = \"40 deg\", longitude = \"10 deg\" }\n";
  write_text(folder_ / "earth.toml", text_of_scene(earth));
  for (const char* const scene : {"flat.toml", "earth.toml"}) {
    EXPECT_EQ(sarsim({"motion", scene, "--platform", "Plane", "--out", "a.csv", "--force"}).status, 0);
    EXPECT_THAT(text_of(folder_ / "a.csv"), Not(HasSubstr("reated")));
  }
  EXPECT_EQ(sarsim({"motion", "earth.toml", "--platform", "Plane", "--out", "a.oem"}).status, 0);
  EXPECT_THAT(text_of(folder_ / "a.oem"), HasSubstr("COMMENT CREATION_DATE is the epoch of the scene"));
  EXPECT_THAT(text_of(folder_ / "a.oem"), HasSubstr("CREATION_DATE = 2024-04-01T00:00:00\n"));
}

}  // namespace motion_test
}  // namespace sarsim::test
