#include <csignal>

#include "parts_support.hpp"

namespace sarsim::test {
namespace resume_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class Resume : public PartsTest {
 protected:
  // Enough work to be interrupted in the middle of it.
  void write_long_scene() const {
    SceneText scene;
    scene.pulses = 160000;
    scene.lsb_mv = "3e-5";
    write_scene(scene);
  }

  [[nodiscard]] Start here() const {
    Start start;
    start.folder = folder_;
    return start;
  }

  // Number behind a name in a JSON text.
  [[nodiscard]] static long member(const std::string& json, const std::string& name) {
    const std::size_t at = json.find("\"" + name + "\": ");
    return at == std::string::npos ? -1 : std::stol(json.substr(at + name.size() + 4));
  }

  void interrupt(int signal, int status) const {
    Program program({"run", "scene.scr", "--out", "out", "--resume", "--save-every", "0.05", "--threads", "1"}, here());
    ASSERT_TRUE(program.wait_for("sim.bin: 20 %", 60.0)) << program.err();
    program.send(signal);
    const Finished end = program.finish();
    EXPECT_EQ(end.status, status) << end.err;
    EXPECT_FALSE(fs::exists(folder_ / "out/sim.bin"));
  }

  void expect_to_go_on() const {
    const Finished again = run({"--out", "out", "--resume", "--json"});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_GT(member(again.out, "computed_rows"), 0);
    // A fifth was computed when it ended; what came after the last save is computed again, a few per cent under load.
    EXPECT_LT(member(again.out, "computed_rows"), 153000);
    ASSERT_EQ(run({"--out", "whole"}).status, 0);
    expect_same_bytes("whole/sim.bin", "out/sim.bin");
    EXPECT_THAT(entries("out"), ElementsAre("sim.bin", "sim.bin.journal"));
  }
};

TEST_F(Resume, GoesOnAfterControlC) {
  write_long_scene();
  interrupt(SIGINT, 130);
  expect_to_go_on();
}

TEST_F(Resume, GoesOnAfterSuddenDeath) {
  write_long_scene();
  interrupt(SIGKILL, -SIGKILL);
  expect_to_go_on();
}

TEST_F(Resume, GoesOnAfterADiskThatWasFull) {
  SceneText scene;
  scene.pulses = 2000;
  scene.format = "ASCII";
  scene.files = {"sim.bin"};
  scene.lsb_mv = "3e-5";
  write_scene(scene);
  Start start = here();
  start.largest_file_bytes = 1000000;
  const Finished full = Program({"run", "scene.scr", "--out", "out", "--resume", "--save-every", "0"}, start).finish();
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, HasSubstr("continue with --resume"));
  const Finished again = run({"--out", "out", "--resume", "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_LT(member(again.out, "computed_rows"), 2000);
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  expect_same_bytes("whole/sim.bin", "out/sim.bin");
}

TEST_F(Resume, OfAFinishedRunComputesNothing) {
  write_shaking_scene(20, "0");
  const Finished first = run({"--resume"});
  ASSERT_EQ(first.status, 0) << first.err;
  const Finished again = run({"--resume", "--json"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(member(again.out, "computed_rows"), 0);
  EXPECT_EQ(figures(again.err), figures(first.err));
}

TEST_F(Resume, FinishesWhatPartsHaveLeft) {
  write_shaking_scene(60, "3e-5");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  ASSERT_EQ(run({"--out", "out", "--part", "2/3"}).status, 0);
  const Finished rest = run({"--out", "out", "--resume", "--json"});
  ASSERT_EQ(rest.status, 0) << rest.err;
  EXPECT_EQ(member(rest.out, "computed_rows"), 40);
  expect_same_bytes("whole/sim.bin", "out/sim.bin");
}

TEST_F(Resume, ComputesAgainWhatTheDiskHasLost) {
  write_shaking_scene(60, "3e-5");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  ASSERT_EQ(run({"--out", "out", "--part", "1/2", "--save-every", "0"}).status, 0);
  std::string rows = text_of(folder_ / "out/sim.bin.parts/samples");
  rows[1000] = static_cast<char>(rows[1000] ^ 1);
  write_text(folder_ / "out/sim.bin.parts/samples", rows);
  const Finished again = run({"--out", "out", "--part", "1/2", "--resume", "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("do not match the journal"));
  EXPECT_GT(member(again.out, "rejected_rows"), 0);
  EXPECT_EQ(member(again.out, "rejected_rows"), member(again.out, "computed_rows"));
  ASSERT_EQ(run({"--out", "out", "--part", "2/2"}).status, 0);
  expect_same_bytes("whole/sim.bin", "out/sim.bin");
}

TEST_F(Resume, NoticesThatOthersRowsWereLost) {
  write_shaking_scene(60, "3e-5");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  ASSERT_EQ(run({"--out", "out", "--part", "1/2", "--save-every", "0"}).status, 0);
  fs::remove(folder_ / "out/sim.bin.parts/samples");
  const Finished last = run({"--out", "out", "--part", "2/2"});
  EXPECT_EQ(last.status, 2);
  EXPECT_THAT(last.err, HasSubstr("are not what part 1/2 wrote"));
  EXPECT_FALSE(fs::exists(folder_ / "out/sim.bin"));
  const Finished again = run({"--out", "out", "--part", "1/2", "--resume", "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(member(again.out, "rejected_rows"), 30);
  expect_same_bytes("whole/sim.bin", "out/sim.bin");
}

TEST_F(Resume, SaysSoWhereItsFolderWasDeleted) {
  write_long_scene();
  Program program({"run", "scene.scr", "--out", "out", "--resume", "--json", "--threads", "1"}, here());
  ASSERT_TRUE(program.wait_for("sim.bin: 20 %", 60.0)) << program.err();
  fs::remove_all(folder_ / "out/sim.bin.parts");
  const Finished end = program.finish();
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err, HasSubstr("were taken out of the folder"));
  EXPECT_THAT(end.out, HasSubstr("\"failed\""));
  EXPECT_THAT(entries("out"), testing::IsEmpty());
}

TEST_F(Resume, LeavesOutAnEntryThatWasBeingWritten) {
  write_shaking_scene(60, "3e-5");
  ASSERT_EQ(run({"--out", "whole"}).status, 0);
  ASSERT_EQ(run({"--out", "out", "--part", "1/2", "--save-every", "0"}).status, 0);
  const fs::path journal = folder_ / "out/sim.bin.parts/part-1-of-2.journal";
  const std::string text = text_of(journal);
  write_text(journal, text.substr(0, text.size() - 20));
  const Finished again = run({"--out", "out", "--part", "1/2", "--resume", "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_GT(member(again.out, "computed_rows"), 0);
  EXPECT_LT(member(again.out, "computed_rows"), 30);
  ASSERT_EQ(run({"--out", "out", "--part", "2/2"}).status, 0);
  expect_same_bytes("whole/sim.bin", "out/sim.bin");
}

}  // namespace resume_test
}  // namespace sarsim::test
