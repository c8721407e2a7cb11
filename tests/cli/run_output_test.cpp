#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace run_output_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

// `run --out NAME`: a name with the ending of a format, where no folder has it, is that of the only recording.
class RunOutput : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_scene({});
  }
};

TEST_F(RunOutput, IsAFileByTheEndingOfAFormat) {
  for (const std::string name : {"e.h5", "e.npy", "e.csv", "e.asc", "e.brk", "e.bin", "deep/down/e.npy"}) {
    const Finished run = sarsim({"run", "scene.scr", "-o", name, "--quiet"});
    EXPECT_EQ(run.status, 0) << name << run.err;
    EXPECT_TRUE(fs::is_regular_file(folder_ / name)) << name;
  }
  EXPECT_EQ(text_of(folder_ / "e.npy").substr(1, 5), "NUMPY");
  EXPECT_EQ(sarsim({"run", "scene.scr", "-o", "e.zarr", "--quiet"}).status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "e.zarr/.zattrs"));
  EXPECT_FALSE(fs::exists(folder_ / "sim.bin"));
}

TEST_F(RunOutput, HasTheBytesOfTheFileInAFolder) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy", "--out", "folder", "--quiet"}).status, 0);
  ASSERT_EQ(sarsim({"run", "scene.scr", "--out", "e.npy", "--quiet"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "folder/sim.npy"), text_of(folder_ / "e.npy"));
}

TEST_F(RunOutput, StaysAFolderInAllOtherCases) {
  fs::create_directory(folder_ / "there.h5");
  for (const std::string name : {"there.h5", "plain", "with.dots.in", "e.h5/"}) {
    ASSERT_EQ(sarsim({"run", "scene.scr", "-o", name, "--quiet"}).status, 0) << name;
    EXPECT_THAT(entries(name), ElementsAre("sim.bin")) << name;
  }
}

TEST_F(RunOutput, IsNotReplacedWithoutForce) {
  write_text(folder_ / "e.npy", "precious");
  const Finished run = sarsim({"run", "scene.scr", "-o", "e.npy"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("--force"));
  EXPECT_EQ(text_of(folder_ / "e.npy"), "precious");
  EXPECT_EQ(sarsim({"run", "scene.scr", "-o", "e.npy", "--force", "--quiet"}).status, 0);
  ASSERT_EQ(sarsim({"run", "scene.scr", "-o", "e.zarr", "--quiet"}).status, 0);
  EXPECT_EQ(sarsim({"run", "scene.scr", "-o", "e.zarr", "--quiet"}).status, 2);
  EXPECT_EQ(sarsim({"run", "scene.scr", "-o", "e.zarr", "--quiet", "--force"}).status, 0);
}

TEST_F(RunOutput, TakesOneRecording) {
  SceneText scene;
  scene.files = {"one.bin", "two.bin"};
  scene.geometry = "table.txt";
  write_scene(scene);
  const Finished both = sarsim({"run", "scene.scr", "-o", "e.h5"});
  EXPECT_EQ(both.status, 2);
  EXPECT_THAT(both.err, HasSubstr("there are 2 recordings"));
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
  EXPECT_EQ(sarsim({"run", "scene.scr", "2", "-o", "out/e.h5", "--quiet"}).status, 0);
  EXPECT_THAT(entries("out"), ElementsAre("e.h5"));
  EXPECT_THAT(sarsim({"run", "scene.scr", "table.txt", "-o", "e.h5"}).err, HasSubstr("name a folder"));
}

TEST_F(RunOutput, ContradictsAnotherFormat) {
  const Finished run = sarsim({"run", "scene.scr", "-o", "e.h5", "--format", "csv"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("'e.h5' has the ending of hdf5, and --format says csv"));
  EXPECT_EQ(sarsim({"run", "scene.scr", "-o", "e.h5", "--format", "hdf5", "--quiet"}).status, 0);
}

TEST_F(RunOutput, MayBeMadeInPartsAndResumed) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "-o", "whole.npy", "--quiet"}).status, 0);
  for (const char* part : {"1/2", "2/2"})
    ASSERT_EQ(sarsim({"run", "scene.scr", "-o", "e.npy", "--part", part, "--quiet"}).status, 0) << part;
  EXPECT_EQ(text_of(folder_ / "e.npy"), text_of(folder_ / "whole.npy"));
}

}  // namespace run_output_test
}  // namespace sarsim::test
