#include <gmock/gmock.h>
#include <sys/stat.h>

#include "program.hpp"

namespace sarsim::test {
namespace outputs_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// What outputs may not replace, and what a refusal advises.
class Outputs : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_scene({});
  }

  // A script whose target has its pattern in gain.dat.
  void write_scene_with_data(const std::string& product, const std::string& data = "gain.dat") const {
    std::string text = SceneText{}.text();
    const std::string plain = "1 0 ISOTROPIC\n$RADAR";
    text.replace(text.find(plain), plain.size(), "1 0 DIRECTIONAL 0 0 0 0 OTHER_GAIN LINEAR FILE " + data + "\n$RADAR");
    text.replace(text.find("sim.bin"), 7, product);
    write_text(folder_ / "scene.scr", text);
    write_text(folder_ / data, "2\n0 0\n90 -20\n");
  }

  void expect_kept(const char* file, const std::vector<std::string>& words) const {
    const std::string before = text_of(folder_ / file);
    const std::vector<std::string> entries_before = entries(".");
    const Finished refused = sarsim(words);
    EXPECT_EQ(refused.status, 2) << words[0] << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("the output would replace the file that it is made from")) << words[0];
    EXPECT_EQ(text_of(folder_ / file), before) << words[0];
    EXPECT_EQ(entries("."), entries_before) << words[0];
  }

  void expect_advice(const std::vector<std::string>& words, const std::string& advice) const {
    const Finished refused = sarsim(words);
    EXPECT_EQ(refused.status, 2) << words[0] << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(advice)) << words[0];
  }
};

TEST_F(Outputs, ForceNeverReplacesTheScript) {
  const std::vector<std::string> table{"--radar", "Radar1", "--start", "0", "--end", "0"};
  std::vector<std::string> geometry{"geometry", "scene.scr", "-o", "scene.scr", "--force"};
  geometry.insert(geometry.end(), table.begin(), table.end());
  expect_kept("scene.scr", geometry);
  expect_kept("scene.scr", {"format", "scene.scr", "-o", "scene.scr", "--force"});
  expect_kept("scene.scr", {"plot", "scene.scr", "--kind", "pulse", "--csv", "scene.scr", "--force"});
}

TEST_F(Outputs, ForceNeverReplacesTheScriptOfAFile) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "--quiet"}).status, 0);
  for (const char* command : {"doppler", "search"})
    expect_kept("scene.scr",
                {command, "sim.bin", "--script", "scene.scr", "--detections", "scene.scr", "--force", "--quiet"});
  expect_kept("scene.scr", {"convert", "sim.bin", "scene.scr", "--to", "csv", "--script", "scene.scr", "--force"});
  expect_kept("scene.scr",
              {"plot", "sim.bin", "--script", "scene.scr", "--kind", "pulse", "--csv", "scene.scr", "--force"});
}

TEST_F(Outputs, ForceNeverReplacesADataFileOfTheScript) {
  write_scene_with_data("gain.dat");
  expect_kept("gain.dat", {"run", "scene.scr", "--force"});
  write_scene_with_data("sim.bin");
  const std::vector<std::string> table{"--radar", "Radar1", "--start", "0", "--end", "0"};
  std::vector<std::string> geometry{"geometry", "scene.scr", "-o", "gain.dat", "--force"};
  geometry.insert(geometry.end(), table.begin(), table.end());
  expect_kept("gain.dat", geometry);
  expect_kept("gain.dat", {"format", "scene.scr", "-o", "gain.dat", "--force"});
  expect_kept("gain.dat", {"plot", "scene.scr", "--kind", "pulse", "--csv", "gain.dat", "--force"});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--quiet"}).status, 0);
  expect_kept("gain.dat", {"convert", "sim.bin", "gain.dat", "--to", "csv", "--script", "scene.scr", "--force"});
  expect_kept("gain.dat",
              {"doppler", "sim.bin", "--script", "scene.scr", "--detections", "gain.dat", "--force", "--quiet"});
  write_scene_with_data("sim.bin", "gain.img");
  expect_kept("gain.img", {"doppler", "scene.scr", "--out", "gain.img", "--force", "--quiet"});
}

TEST_F(Outputs, ForceNeverReplacesADataFileOfTheScriptInARecording) {
  write_scene_with_data("sim.bin");
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "hdf5", "--quiet"}).status, 0);
  expect_kept("gain.dat", {"doppler", "sim.h5", "--detections", "gain.dat", "--force", "--quiet"});
}

TEST_F(Outputs, ForceNeverReplacesATableOfTargets) {
  write_text(folder_ / "t.hdr", "0,0,0,1\n");
  write_text(folder_ / "t.csv", "0,0,0,1\n");
  const std::string scene = SARSIM_SOURCE_DIR "/examples/sar_r.scr";
  expect_kept("t.hdr", {"focus", scene, "--targets", "t.hdr", "--out", "t.img", "--force"});
  expect_kept("t.hdr", {"focus", scene, "--targets", "Earth=t.hdr", "--out", "t.img", "--force"});
  expect_kept("t.csv", {"plot", "scene.scr", "--targets", "t.csv", "--kind", "pulse", "--csv", "t.csv", "--force"});
}

// A link between two names would let the later output replace the earlier one.
TEST_F(Outputs, ThatAreOneFileThroughALinkAreRefused) {
  const auto expect_refused = [&](const char* link, const char* to, const std::vector<std::string>& words) {
    fs::create_symlink(to, folder_ / link);
    const Finished refused = sarsim(words);
    EXPECT_EQ(refused.status, 2) << words[0];
    EXPECT_THAT(refused.err, HasSubstr("two outputs are one file through a link")) << words[0];
    EXPECT_FALSE(fs::exists(folder_ / to)) << words[0];
    fs::remove(folder_ / link);
  };
  const std::string examples = SARSIM_SOURCE_DIR "/examples/";
  expect_refused("t.hdr", "t.img", {"focus", examples + "sar_r.scr", "--out", "t.img", "--force"});
  expect_refused("t.hdr", "t.img", {"doppler", examples + "mti.scr", "--out", "t.img", "--force"});
  expect_refused("d.csv", "t.hdr",
                 {"search", examples + "search_radar.scr", "--out", "t.img", "--detections", "d.csv", "--force"});
  expect_refused("x.csv", "a.png",
                 {"plot", "scene.scr", "--kind", "pulse", "-o", "a.png", "--csv", "x.csv", "--force"});
}

TEST_F(Outputs, CutsStayInTheirFolderAndReplaceNoImage) {
  ASSERT_EQ(sarsim({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--out", "im.img", "--quiet"}).status, 0);
  const std::string image = text_of(folder_ / "im.img");
  fs::create_directory(folder_ / "d");
  fs::create_directory(folder_ / "h");
  fs::create_symlink("../im.img", folder_ / "d/target-2.png");
  EXPECT_EQ(sarsim({"measure", "im.img", "--cuts", "d", "--force"}).status, 2);
  EXPECT_EQ(text_of(folder_ / "im.img"), image);
  fs::remove(folder_ / "d/target-2.png");
  fs::create_symlink("../h/x", folder_ / "d/target-1.png");
  EXPECT_EQ(sarsim({"measure", "im.img", "--cuts", "d"}).status, 2);
  EXPECT_TRUE(fs::is_empty(folder_ / "h"));
}

// The ending in the scene is not that of the output.
TEST_F(Outputs, ThatTakeAnotherFormatTakeItsEnding) {
  write_scene_with_data("sim.h5");
  const auto warned = [&](const std::vector<std::string>& words) {
    const Finished done = sarsim(words);
    return (done.out + done.err).find("the file name has the extension of another format") != std::string::npos;
  };
  EXPECT_TRUE(warned({"check", "scene.scr"})) << "BINARY";
  EXPECT_FALSE(warned({"run", "scene.scr", "-o", "y.npy"}));
  EXPECT_TRUE(fs::exists(folder_ / "y.npy"));
  EXPECT_FALSE(warned({"run", "scene.scr", "--format", "npy"}));
  EXPECT_TRUE(fs::exists(folder_ / "sim.npy"));
}

TEST_F(Outputs, OtherFilesAreStillReplaced) {
  write_text(folder_ / "other.csv", "old");
  EXPECT_EQ(sarsim({"plot", "scene.scr", "--kind", "pulse", "--csv", "other.csv", "--force"}).status, 0);
  EXPECT_THAT(text_of(folder_ / "other.csv"), HasSubstr("slant range"));
}

TEST_F(Outputs, AdviceNamesTheOptionThatTheCommandHas) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "--quiet"}).status, 0);
  fs::create_directory(folder_ / "dir");
  expect_advice({"run", "scene.scr"}, "choose another folder with --out");
  expect_advice({"convert", "sim.bin", "sim.bin", "--script", "scene.scr"}, "name another file as OUT");
  expect_advice({"format", "scene.scr", "-o", "dir"}, "name another file with -o");
  expect_advice({"geometry", "scene.scr", "--radar", "Radar1", "--start", "0", "--end", "0", "-o", "dir"},
                "name another file with -o");
  expect_advice({"plot", "scene.scr", "--csv", "sim.bin"}, "or name another file with -o or --csv");
  expect_advice({"doppler", "scene.scr", "--out", "sim.bin"}, "or name another file with --out or --detections");
}

TEST_F(Outputs, KeptPathsNeverLeadOutOfTheFolder) {
  for (const char* name : {"../sim.bin", "sub/../../sim.bin", "/tmp/sarsim-never.bin", "c:\\sim.bin", "..\\sim.bin"}) {
    SceneText scene;
    scene.files = {name};
    write_scene(scene);
    const Finished refused = sarsim({"run", "scene.scr", "--out", "o/p", "--keep-paths"});
    EXPECT_EQ(refused.status, 2) << name;
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("the output's name leads out of the folder of the run"), HasSubstr("scene.scr:8:")))
        << name;
  }
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
  SceneText scene;
  scene.files = {"a/../b/sim.bin"};
  write_scene(scene);
  EXPECT_EQ(sarsim({"run", "scene.scr", "--out", "o", "--keep-paths", "--quiet"}).status, 0);
  EXPECT_THAT(entries("o/b"), ElementsAre("sim.bin"));
}

// What a run that can be resumed makes beside its recordings is looked at before it begins, too.
class SideFiles : public Outputs {
 protected:
  void expect_refused(const std::vector<std::string>& words, const std::string& message) const {
    const std::vector<std::string> before = entries(".");
    const Finished refused = sarsim(words);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(message));
    EXPECT_EQ(entries("."), before);
  }
};

TEST_F(SideFiles, ReceiptsReplaceNothingButReceipts) {
  const std::string message = "the file name of the recording's receipt is taken by something else";
  const std::string script = text_of(folder_ / "scene.scr");
  fs::rename(folder_ / "scene.scr", folder_ / "sim.bin.journal");
  for (const char* option : {"--resume", "--part=1/2"}) {
    expect_refused({"run", "sim.bin.journal", option, "--force"}, message);
    EXPECT_EQ(text_of(folder_ / "sim.bin.journal"), script);
  }
  fs::rename(folder_ / "sim.bin.journal", folder_ / "scene.scr");
  ASSERT_EQ(sarsim({"run", "scene.scr", "--part=1/2", "--part-file", "--quiet"}).status, 0);
  ASSERT_EQ(sarsim({"run", "scene.scr", "--part=2/2", "--part-file", "--quiet"}).status, 0);
  write_text(folder_ / "sim.bin.journal", "mine");
  expect_refused({"merge", "sim.bin.parts"}, message);
  EXPECT_EQ(text_of(folder_ / "sim.bin.journal"), "mine");
  fs::remove(folder_ / "sim.bin.journal");
  ASSERT_EQ(sarsim({"merge", "sim.bin.parts", "--quiet"}).status, 0);
  EXPECT_EQ(sarsim({"run", "scene.scr", "--resume", "--force", "--quiet"}).status, 0);
}

TEST_F(SideFiles, FoldersOfPartsHoldPartsAlone) {
  fs::create_directory(folder_ / "mine");
  for (const char* name : {"my.rows", "joined", "product"}) write_text(folder_ / "mine" / name, name);
  fs::create_directory_symlink("mine", folder_ / "sim.bin.parts");
  expect_refused({"run", "scene.scr", "--part=1/1"}, "the name of something that is not a folder");
  fs::remove(folder_ / "sim.bin.parts");
  fs::rename(folder_ / "mine", folder_ / "sim.bin.parts");
  for (const char* option : {"--part=1/1", "--resume"})
    expect_refused({"run", "scene.scr", option}, "holds files that are not parts");
  EXPECT_THAT(entries("sim.bin.parts"), ElementsAre("joined", "my.rows", "product"));
}

TEST_F(SideFiles, InAFolderOfPartsAreNeverReachedByLinks) {
  write_text(folder_ / "victim", "mine");
  fs::create_directory(folder_ / "sim.bin.parts");
  write_text(folder_ / "sim.bin.parts/lock", "");
  for (const char* name : {"samples", "part-1-of-1.rows"})
    fs::create_symlink("../victim", folder_ / "sim.bin.parts" / name);
  const Finished refused = sarsim({"run", "scene.scr", "--part=1/1", "--quiet"});
  EXPECT_NE(refused.status, 0);
  EXPECT_THAT(refused.err, HasSubstr("symbolic link"));
  EXPECT_EQ(text_of(folder_ / "victim"), "mine");
}

TEST_F(SideFiles, ThatWouldBeAnotherOutputAreRefused) {
  SceneText two;
  two.files = {"sim.bin.journal", "sim.bin"};
  write_scene(two);
  expect_refused({"run", "scene.scr", "--resume"}, "are one file");
  two.files = {"sim.bin", "other.bin"};
  write_scene(two);
  write_text(folder_ / "sim.bin", "old");
  fs::create_symlink("sim.bin", folder_ / "other.bin");
  expect_refused({"run", "scene.scr", "--force"}, "are one file");
  EXPECT_EQ(text_of(folder_ / "sim.bin"), "old");
}

TEST_F(SideFiles, AndOutputsDoNotLeaveTheirFolderByLinks) {
  fs::create_directory(folder_ / "out");
  fs::create_directory(folder_ / "home");
  fs::create_symlink("../home/x", folder_ / "out/sim.bin");
  const std::string message = "a symbolic link leads this output out of the folder 'out'";
  expect_refused({"run", "scene.scr", "--out", "out"}, message);
  fs::remove(folder_ / "out/sim.bin");
  fs::create_symlink("../home/x", folder_ / "out/sim_seed=1.bin");
  expect_refused({"sweep", "scene.scr", "--set", "seed=1..2", "--out", "out"}, message);
  EXPECT_THAT(entries("home"), ElementsAre());
  // In the folder that one works in, links are one's own.
  fs::create_symlink("home/x", folder_ / "sim.bin");
  EXPECT_EQ(sarsim({"run", "scene.scr", "--quiet"}).status, 0);
  EXPECT_THAT(entries("home"), ElementsAre("x"));
}

TEST_F(SideFiles, OfOtherImagesAreKept) {
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy", "--quiet"}).status, 0);
  const auto doppler = [](const char* output) {
    return std::vector<std::string>{"doppler", "sim.npy", "--script", "scene.scr", "--cfar",
                                    "none",    "--quiet", "--force",  "--out",     output};
  };
  const Finished first = sarsim(doppler("a.img"));
  ASSERT_EQ(first.status, 0) << first.err;
  expect_refused(doppler("a.npy"), "the header of the image 'a.img' would be replaced");
  EXPECT_EQ(sarsim(doppler("a.img")).status, 0);
}

TEST_F(SideFiles, JournalsThatArePipesEndACommandAtOnce) {
  fs::create_directory(folder_ / "sim.bin.parts");
  write_text(folder_ / "sim.bin.parts/lock", "");
  ASSERT_EQ(::mkfifo((folder_ / "sim.bin.parts/x.journal").c_str(), 0600), 0);
  const Finished refused = sarsim({"merge", "sim.bin.parts"});
  EXPECT_NE(refused.status, 0);
  EXPECT_THAT(refused.err, HasSubstr("not a regular file"));
}

TEST_F(SideFiles, TablesOfASweepAreNotItsRecordings) {
  expect_refused({"sweep", "scene.scr", "--set", "seed=1..2", "--format", "csv", "--table", "sim_seed=1", "--force"},
                 "is the name of a variation's file and of a table of the sweep");
}

TEST_F(Outputs, PicturesGoIntoFoldersThatAreThere) {
  const Finished refused = sarsim({"plot", "scene.scr", "--csv", "nowhere/x.csv"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("there is no folder 'nowhere'"), HasSubstr("make it")));
}

TEST_F(Outputs, PicturesThatAreTooLargeAreRefusedBeforehand) {
  const Finished refused = sarsim({"plot", "scene.scr", "-o", "x.png", "--size", "20000", "20000", "--scale", "16"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--size and --scale: a picture of 320000 x 320000 dots is too large"));
  EXPECT_THAT(refused.err, HasSubstr("at most 32767 dots to a side"));
}

TEST_F(Outputs, PlotSaysWhatItsOptionsTake) {
  const auto refused = [&](const std::vector<std::string>& option, const std::string& sentence) {
    std::vector<std::string> words{"plot", "scene.scr", "--csv", "x.csv"};
    words.insert(words.end(), option.begin(), option.end());
    const Finished end = sarsim(words);
    EXPECT_EQ(end.status, 2) << sentence;
    EXPECT_THAT(end.err, HasSubstr(sentence));
  };
  refused({"--span", "0"}, "--span: '0' is not a number above 0");
  refused({"--rate", "0"}, "--rate: '0' is not a number above 0");
  refused({"--percentile", "101"}, "--percentile: '101' is not a number above 0, at most 100");
  refused({"--percentile", "0"}, "--percentile: '0' is not");
  refused({"--limits", "1", "1"}, "--limits: the two values are the same");
  refused({"--scale", "0.1"}, "--scale: '0.1' is not a number from 0.25 to 16");
  refused({"--size", "20", "20"}, "--size: '20' is not a whole number from 64 to 20000");
  refused({"--title", "--force"}, "--title: '--force' is not a title");
  EXPECT_EQ(sarsim({"plot", "scene.scr", "--csv", "x.csv", "--title", ""}).status, 0);
}

TEST_F(Outputs, CutsNeedAFolderAndMeasureAnImage) {
  EXPECT_THAT(sarsim({"measure", "nofile"}).err, HasSubstr("there is no file 'nofile'"));
  ASSERT_EQ(sarsim({"focus", SARSIM_SOURCE_DIR "/examples/sar_r.scr", "--quiet"}).status, 0);
  const Finished refused = sarsim({"measure", "sar_r.img", "--cuts", "scene.scr"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--cuts: 'scene.scr' is not a folder"));
  EXPECT_EQ(refused.out, "");
}

}  // namespace outputs_test
}  // namespace sarsim::test
