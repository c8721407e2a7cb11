#include <sys/wait.h>

#include <gmock/gmock.h>

#include "program.hpp"
#include "report_numbers.hpp"

namespace sarsim::test {
namespace failures_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// What the world does to a command: exit status 1, and nothing half done.
class Failures : public CommandTest {
 protected:
  [[nodiscard]] Finished sarsim_into(const std::vector<std::string>& arguments, const std::string& output) const {
    Start start;
    start.folder = folder_;
    start.standard_output = output;
    return Program(arguments, start).finish();
  }
};

TEST_F(Failures, FileThatCannotGrowIsRemoved) {
  SceneText scene;
  scene.pulses = 2000;
  write_scene(scene);
  Start start;
  start.folder = folder_;
  start.largest_file_bytes = 100000;  // Of 1.3 MB.
  const Finished run = Program({"run", "scene.scr"}, start).finish();
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("sim.bin"));
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

TEST_F(Failures, FullDiskIsToldForHdf5Too) {
  SceneText scene;
  scene.pulses = 2000;
  write_scene(scene);
  Start start;
  start.folder = folder_;
  start.largest_file_bytes = 100000;
  const Finished run = Program({"run", "scene.scr", "--format", "hdf5"}, start).finish();
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("sim.h5"));
  EXPECT_THAT(run.err, Not(HasSubstr("HDF5-DIAG")));
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

TEST_F(Failures, StandardOutputThatIsFullIsAFailure) {
  write_scene({});
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"format", "scene.scr"},
           {"info", "scene.scr"},
           {"check", "scene.scr"},
           {"completion", "bash"},
           {"--help"},
           {"geometry", "scene.scr", "--radar", "Radar1", "--start", "0", "--end", "1"}}) {
    const Finished run = sarsim_into(command, "/dev/full");
    EXPECT_EQ(run.status, 1) << command[0];
    EXPECT_THAT(run.err, HasSubstr("standard output")) << command[0];
  }
}

TEST_F(Failures, OutputFileOnAFullDeviceIsAFailure) {
  write_scene({});
  const Finished run = sarsim({"format", "scene.scr", "-o", "/dev/full", "--force"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("/dev/full"));
}

TEST_F(Failures, FolderThatCannotBeMadeIsNamed) {
  write_scene({});
  write_text(folder_ / "file", "");
  const Finished run = sarsim({"run", "scene.scr", "--out", "file/below"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("file/below"));
}

TEST_F(Failures, FileInPlaceOfTheFolderIsBadInput) {
  write_scene({});
  write_text(folder_ / "file", "kept");
  EXPECT_EQ(sarsim({"run", "scene.scr", "--out", "file", "--force"}).status, 2);
  EXPECT_EQ(text_of(folder_ / "file"), "kept");
}

TEST_F(Failures, FolderWithoutPermissionIsNamed) {
  if (geteuid() == 0) GTEST_SKIP() << "the superuser may write everywhere";
  write_scene({});
  std::filesystem::create_directory(folder_ / "locked");
  std::filesystem::permissions(folder_ / "locked", std::filesystem::perms::owner_read);
  const Finished run = sarsim({"run", "scene.scr", "--out", "locked"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("locked"));
}

TEST_F(Failures, RecordingsThatCannotFitAreRefusedBeforeTheyBegin) {
  SceneText scene;
  scene.pulses = 2'000'000'000;  // More than a terabyte.
  scene.lsb_mv = "1e-6";
  write_scene(scene);
  const Finished run = sarsim({"run", "scene.scr"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("not enough room"));
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

TEST_F(Failures, ReaderThatLeavesEndsTheCommandQuietly) {
  write_scene({});
  const std::string command = "cd '" + folder_.string() + "' && { '" + SARSIM_PROGRAM +
                              "' geometry scene.scr --radar Radar1 --start 0 --end 1000 2> err; echo $? > status; } | "
                              "head -n 1 > /dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(text_of(folder_ / "status"), "1\n");
  EXPECT_EQ(text_of(folder_ / "err"), "");
}

TEST_F(Failures, NamesOfFilesGiveNoOrdersToTheTerminal) {
  const Finished made = sarsim({"new", "tutorial", "-o", "a\033b\nc.scr"});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("a\\x1bb\\x0ac.scr: "));
  EXPECT_THAT(made.err, Not(HasSubstr("\033")));
}

TEST_F(Failures, CommandsThatAreNamedCanBeTyped) {
  EXPECT_THAT(sarsim({"new", "tutorial", "-o", "a b.scr"}).err, HasSubstr("sarsim check 'a b.scr' "));
  EXPECT_THAT(sarsim({"new", "tutorial", "--out=-c.scr"}).err, HasSubstr("sarsim run ./-c.scr "));
}

TEST_F(Failures, InfoSaysNothingInfinite) {
  SceneText scene;
  write_scene(scene);
  for (const char* setting : {"Radar1.noise_temperature=1e-300", "Radar1.bandwidth=1e18"}) {
    const Finished info = sarsim({"info", "scene.scr", "--set", setting});
    EXPECT_EQ(info.status, 0) << setting << info.err;
    EXPECT_THAT(info.out, Not(HasSubstr(" inf"))) << setting;
    EXPECT_THAT(info.out, Not(HasSubstr("nan"))) << setting;
  }
}

// What focusing would make of such waveforms is left out of it.
TEST_F(Failures, InfoOfWaveformsBeyondAllBoundsIsStillGiven) {
  for (const char* setting : {"Radar1.bandwidth=1e18", "Radar1.pulse_width=1e18"}) {
    const Finished info = sarsim({"info", examples + "sar_r.scr", "--set", setting});
    EXPECT_EQ(info.status, 0) << setting << info.err;
    EXPECT_THAT(info.out, HasSubstr("strongest echo")) << setting;
  }
  const Finished focus = sarsim({"focus", examples + "sar_r.scr", "--set", "Radar1.pulse_width=1e18", "-o", "o.npy"});
  EXPECT_EQ(focus.status, 2);
  EXPECT_THAT(focus.err, HasSubstr("the pulse is too long to be focused"));
}

TEST_F(Failures, MissingAndUnreadableScriptsAreBadInput) {
  for (const char* command : {"run", "check", "info", "format"}) {
    const Finished run = sarsim({command, "missing.scr"});
    EXPECT_EQ(run.status, 2) << command;
    EXPECT_THAT(run.err + run.out, HasSubstr("missing.scr")) << command;
  }
  EXPECT_EQ(sarsim({"run", "."}).status, 2);
}

}  // namespace failures_test
}  // namespace sarsim::test
