#include "workflow/input/input_list.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "support/test_folder.hpp"

namespace sarsim::workflow {
namespace input_list_test {

namespace fs = std::filesystem;

class InputLists : public testing::Test {
 protected:
  fs::path put(const std::string& name, const std::string& text = "text") {
    const fs::path path = folder_ / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path;
  }

  test::TestFolder folder_;
};

TEST_F(InputLists, KnowAFileByAllOfItsNames) {
  const fs::path file = put("a/in.csv");
  fs::create_hard_link(file, folder_ / "second.csv");
  fs::create_symlink(file, folder_ / "link.csv");
  fs::create_directory_symlink(folder_ / "a", folder_ / "b");
  const InputList list({file});
  for (const fs::path& name :
       {file, folder_ / "a/../a/./in.csv", folder_ / "second.csv", folder_ / "link.csv", folder_ / "b/in.csv"})
    EXPECT_TRUE(list.harm_of(name, true)) << name;
  put("other.csv");
  EXPECT_FALSE(list.harm_of(folder_ / "other.csv", true));
  EXPECT_FALSE(list.harm_of(folder_ / "a/new.csv", true));
}

TEST_F(InputLists, CountWhatIsInAFolder) {
  put("s.zarr/samples/0.0");
  put("elsewhere/chunk");
  fs::create_symlink(folder_ / "elsewhere/chunk", folder_ / "s.zarr/samples/0.1");
  fs::create_hard_link(folder_ / "s.zarr/samples/0.0", folder_ / "second");
  const InputList list({folder_ / "s.zarr"});
  EXPECT_TRUE(list.harm_of(folder_ / "s.zarr", true));
  EXPECT_TRUE(list.harm_of(folder_ / "s.zarr/samples/0.0", true));
  EXPECT_TRUE(list.harm_of(folder_ / "s.zarr/new", true));
  EXPECT_TRUE(list.harm_of(folder_ / "elsewhere/chunk", true));
  EXPECT_TRUE(list.harm_of(folder_ / "second", true));
  EXPECT_FALSE(list.harm_of(folder_ / "s.zarr.npy", true));
}

TEST_F(InputLists, FindAnInputInAFolderThatWouldBeReplaced) {
  put("out.zarr/scene.toml");
  EXPECT_TRUE(InputList({folder_ / "out.zarr/scene.toml"}).harm_of(folder_ / "out.zarr", true));
}

TEST_F(InputLists, SurviveLinksThatLeadAround) {
  put("s.zarr/a");
  fs::create_directory_symlink("..", folder_ / "s.zarr/up");
  fs::create_directory_symlink(".", folder_ / "s.zarr/self");
  put("other");
  // All that the links lead to is read with the store, its neighbours too.
  EXPECT_TRUE(InputList({folder_ / "s.zarr"}).harm_of(folder_ / "other", true));
}

TEST_F(InputLists, FollowAnImageToItsRecordingOnlyWhereSomethingIsReplaced) {
  put("rec.h5");
  put("image.img", std::string(8, '\0'));
  put("image.hdr",
      "ENVI\nsamples = 1\nlines = 1\nbands = 1\nheader offset = 0\ndata type = 6\ninterleave = bsq\nbyte order = 0\n"
      "source = { rec.h5 }\n");
  const InputList list = InputList::named({folder_ / "image.img"});
  EXPECT_TRUE(list.harm_of(folder_ / "image.hdr", false));
  EXPECT_FALSE(list.harm_of(folder_ / "rec.h5", false));
  EXPECT_TRUE(list.harm_of(folder_ / "rec.h5", true));
}

// The default output of focusing "rec.h5" is "rec.img", which may be made again.
TEST_F(InputLists, LeaveTheHeaderOfAnImageBesideARecordingAlone) {
  put("rec.h5");
  put("rec.img", std::string(8, '\0'));
  put("rec.hdr",
      "ENVI\nsamples = 1\nlines = 1\nbands = 1\nheader offset = 0\ndata type = 6\ninterleave = bsq\nbyte order = 0\n"
      "source = { rec.h5 }\n");
  for (const char* const name : {"rec.h5", "rec.toml", "rec.bin"}) {
    put(name, "format = \"sarsim 2\"\n");
    const InputList list = InputList::named({folder_ / name});
    EXPECT_FALSE(list.harm_of(folder_ / "rec.hdr", true)) << name;
    EXPECT_FALSE(list.harm_of(folder_ / "rec.img", true)) << name;
  }
}

TEST_F(InputLists, FollowASceneToWhatItIncludesAndNames) {
  put("points.csv", "x,y,z\n1,2,3\n");
  put("part.toml", "format = \"sarsim 2\"\n");
  const fs::path scene = put("s.toml",
                             "format = \"sarsim 2\"\ninclude = [\"part.toml\"]\n[[target]]\n"
                             "positions = { file = \"points.csv\" }\n");
  const InputList list = InputList::named({scene});
  EXPECT_TRUE(list.harm_of(folder_ / "part.toml", true));
  EXPECT_TRUE(list.harm_of(folder_ / "points.csv", true));
}

TEST_F(InputLists, LoseNothingOfWhatIsMissingOrNoFile) {
  const InputList list({folder_ / "missing", "/dev/null"});
  EXPECT_FALSE(list.harm_of("/dev/null", true));
  EXPECT_FALSE(list.harm_of(folder_ / "missing", true));
}

}  // namespace input_list_test
}  // namespace sarsim::workflow
