#include <csignal>

#include <gmock/gmock.h>

#include "csv.hpp"
#include "program.hpp"

namespace sarsim::test {
namespace resume_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class SweepResume : public CommandTest {
 protected:
  [[nodiscard]] Finished sweep(std::vector<std::string> more) const {
    more.insert(more.begin(), {"sweep", "scene.scr"});
    return sarsim(more);
  }
  [[nodiscard]] fs::file_time_type time_of(const std::string& file) const {
    return fs::last_write_time(folder_ / file);
  }
};

TEST_F(SweepResume, LeavesOutWhatIsDoneAndSaysTheSame) {
  write_scene({});
  ASSERT_EQ(sweep({"--set", "seed=1..2"}).status, 0);
  const auto before = time_of("sim_seed=1.bin");
  const Finished more = sweep({"--set", "seed=1..4", "--resume"});
  EXPECT_EQ(more.status, 0) << more.err;
  EXPECT_THAT(more.err, HasSubstr("2 done before, 2 to run"));
  EXPECT_EQ(time_of("sim_seed=1.bin"), before);
  const std::string resumed = without_seconds(text_of(folder_ / "sweep.csv"));
  ASSERT_EQ(sweep({"--set", "seed=1..4", "--out", "fresh"}).status, 0);
  EXPECT_EQ(resumed, without_seconds(text_of(folder_ / "fresh/sweep.csv")));
}

TEST_F(SweepResume, KnowsFoldersAndSeveralFiles) {
  write_scene({});
  for (const char* format : {"zarr", "sigmf"}) {
    ASSERT_EQ(sweep({"--set", "seed=1..2", "--format", format, "--out", format}).status, 0);
    const Finished more = sweep({"--set", "seed=1..3", "--format", format, "--out", format, "--resume"});
    EXPECT_EQ(more.status, 0) << more.err;
    EXPECT_THAT(more.err, HasSubstr("2 done before, 1 to run")) << format;
  }
  fs::resize_file(folder_ / "zarr/sim_seed=1.zarr/samples/0.0", 100);
  const Finished changed = sweep({"--set", "seed=1..3", "--format", "zarr", "--out", "zarr", "--resume"});
  EXPECT_EQ(changed.status, 2);
  EXPECT_THAT(changed.err, HasSubstr("was changed since"));
}

TEST_F(SweepResume, MakesAgainWhatIsMissingOrOfAnotherSize) {
  write_scene({});
  ASSERT_EQ(sweep({"--set", "seed=1..3"}).status, 0);
  fs::remove(folder_ / "sim_seed=2.bin");
  const Finished missing = sweep({"--set", "seed=1..3", "--resume"});
  EXPECT_EQ(missing.status, 0) << missing.err;
  EXPECT_THAT(missing.err, HasSubstr("2 done before, 1 to run"));
  write_text(folder_ / "sim_seed=2.bin", "short");
  const Finished damaged = sweep({"--set", "seed=1..3", "--resume"});
  EXPECT_EQ(damaged.status, 2);
  EXPECT_THAT(damaged.err, HasSubstr("--force"));
  EXPECT_EQ(sweep({"--set", "seed=1..3", "--resume", "--force"}).status, 0);
  EXPECT_GT(fs::file_size(folder_ / "sim_seed=2.bin"), 5U);
}

TEST_F(SweepResume, TakesNoFileOnTheWordOfASweepThatDiscardedItsOwn) {
  SceneText scene;
  write_scene(scene);
  ASSERT_EQ(sweep({"--set", "seed=1..2"}).status, 0);
  scene.noise_k = "400";
  write_scene(scene);
  ASSERT_EQ(sweep({"--set", "seed=1..2", "--discard", "--force"}).status, 0);
  const Finished stale = sweep({"--set", "seed=1..2", "--resume"});
  EXPECT_EQ(stale.status, 2) << stale.err;
  EXPECT_THAT(stale.err, HasSubstr("exists already"));
  EXPECT_THAT(stale.err, HasSubstr("replace with --force"));
  EXPECT_THAT(stale.err, Not(HasSubstr("with --resume")));
  ASSERT_EQ(sweep({"--set", "seed=1..2", "--resume", "--force"}).status, 0);
  ASSERT_EQ(sweep({"--set", "seed=1..2", "--out", "fresh"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "sim_seed=1.bin"), text_of(folder_ / "fresh/sim_seed=1.bin"));
}

TEST_F(SweepResume, LeavesAloneWhatNoSweepWrote) {
  write_scene({});
  for (const char* name : {"sweep.csv", "sweep.json", "sweep.journal"}) {
    for (const char* foreign : {"KEEP\n", "variation,notes\n", "{\n  \"sarsim\": \"1\"\n}\n", "sarsim sweep\n"}) {
      write_text(folder_ / name, foreign);
      const Finished refused = sweep({"--set", "seed=1", "--resume"});
      EXPECT_EQ(refused.status, 2) << name << foreign;
      EXPECT_THAT(refused.err, HasSubstr("no sweep wrote it"));
      EXPECT_THAT(refused.err, HasSubstr(name));
      EXPECT_EQ(text_of(folder_ / name), foreign);
      EXPECT_FALSE(fs::exists(folder_ / "sim_seed=1.bin"));
    }
    write_text(folder_ / name, "");  // Nothing is lost with it.
    EXPECT_EQ(sweep({"--set", "seed=1", "--resume"}).status, 0) << name;
    EXPECT_EQ(sweep({"--set", "seed=1,2", "--set", "Target1.x=1m,2m", "--resume"}).status, 0) << name;
    for (const std::string& file : entries("."))
      if (file != "scene.scr") fs::remove_all(folder_ / file);
  }
}

TEST_F(SweepResume, ReplacesWhatNoSweepWroteWithForce) {
  write_scene({});
  for (const char* name : {"sweep.csv", "sweep.json", "sweep.journal"}) write_text(folder_ / name, "KEEP\n");
  EXPECT_EQ(sweep({"--set", "seed=1..2", "--resume", "--force"}).status, 0);
  EXPECT_THAT(text_of(folder_ / "sweep.journal"), testing::StartsWith("sarsim sweep "));
  EXPECT_THAT(sweep({"--set", "seed=1..3", "--resume"}).err, HasSubstr("2 done before, 1 to run"));
}

TEST_F(SweepResume, OfFiguresAloneLeavesTheFilesKnown) {
  write_scene({});
  ASSERT_EQ(sweep({"--set", "seed=1..2"}).status, 0);
  const Finished figures = sweep({"--set", "seed=1..3", "--discard", "--resume"});
  EXPECT_EQ(figures.status, 0) << figures.err;
  EXPECT_THAT(figures.err, HasSubstr("2 done before, 1 to run"));
  EXPECT_THAT(sweep({"--set", "seed=1..3", "--resume"}).err, HasSubstr("2 done before, 1 to run"));
}

TEST_F(SweepResume, NoticesAFileOfTheSameSizeThatWasChanged) {
  write_scene({});
  ASSERT_EQ(sweep({"--set", "seed=1..2"}).status, 0);
  std::string bytes = text_of(folder_ / "sim_seed=2.bin");
  bytes[100] = static_cast<char>(bytes[100] ^ 1);
  write_text(folder_ / "sim_seed=2.bin", bytes);
  EXPECT_EQ(sweep({"--set", "seed=1..2", "--resume"}).status, 2);
}

TEST_F(SweepResume, TakesNothingFromAnotherScene) {
  SceneText scene;
  write_scene(scene);
  ASSERT_EQ(sweep({"--set", "seed=1..2"}).status, 0);
  scene.noise_k = "301";
  write_scene(scene);
  const Finished changed = sweep({"--set", "seed=1..2", "--resume"});
  EXPECT_EQ(changed.status, 2);
  EXPECT_THAT(changed.err, HasSubstr("exists already"));
  const Finished engine = sweep({"--set", "seed=1..2", "--resume", "--engine", "reference"});
  EXPECT_EQ(engine.status, 2);
}

TEST_F(SweepResume, NoticesAChangeOfADataFile) {
  std::string text = SceneText{}.text();
  const std::string constant = "CHIRP 0.05 1000 RECT CONSTANT 1000";
  ASSERT_NE(text.find(constant), std::string::npos);
  text.replace(text.find(constant), constant.size(), "CHIRP 0.05 1000 RECT OTHER LINEAR FILE pri.txt");
  write_text(folder_ / "scene.scr", text);
  write_text(folder_ / "pri.txt", "1\n0 0.001\n");
  const Finished first = sweep({"--set", "seed=1..2"});
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_THAT(sweep({"--set", "seed=1..2", "--resume"}).err, HasSubstr("2 done before, 0 to run"));
  write_text(folder_ / "pri.txt", "1\n0 0.0011\n");
  EXPECT_EQ(sweep({"--set", "seed=1..2", "--resume"}).status, 2);
}

TEST_F(SweepResume, PartsMakeTheWholeTogether) {
  write_scene({});
  for (const char* part : {"1/3", "2/3", "3/3"}) {
    const Finished end = sweep({"--set", "seed=1..8", "--part", part, "--out", "parts"});
    EXPECT_EQ(end.status, 0) << end.err;
  }
  EXPECT_EQ(read_csv(text_of(folder_ / "parts/sweep-1-of-3.csv")).size(), 3U);
  EXPECT_EQ(read_csv(text_of(folder_ / "parts/sweep-3-of-3.csv")).size(), 2U);
  EXPECT_EQ(read_csv(text_of(folder_ / "parts/sweep-3-of-3.csv"))[1].at("seed"), "6");
  const Finished joined = sweep({"--set", "seed=1..8", "--resume", "--out", "parts"});
  EXPECT_EQ(joined.status, 0) << joined.err;
  EXPECT_THAT(joined.err, HasSubstr("8 done before, 0 to run"));
  ASSERT_EQ(sweep({"--set", "seed=1..8", "--out", "whole"}).status, 0);
  EXPECT_EQ(without_seconds(text_of(folder_ / "parts/sweep.csv")),
            without_seconds(text_of(folder_ / "whole/sweep.csv")));
}

TEST_F(SweepResume, RefusesPartsThatDoNotExist) {
  write_scene({});
  for (const char* part : {"0/3", "4/3", "1", "a/b", "1/0", "-1/3", "1/3/2", "/", "1/1e3"}) {
    const Finished end = sweep({"--set", "seed=1..8", "--part", part});
    EXPECT_EQ(end.status, 2) << part;
    EXPECT_THAT(end.err, HasSubstr("--part")) << part;
  }
  EXPECT_EQ(sweep({"--set", "seed=1..2", "--part", "3/3"}).status, 2);
}

TEST_F(SweepResume, ControlCLeavesFinishedVariationsForTheNextTime) {
  SceneText scene;
  scene.pulses = 1500;
  scene.lsb_mv = "1e-6";
  write_scene(scene);
  Start start;
  start.folder = folder_;
  const std::vector<std::string> words{"sweep", "scene.scr", "--set", "seed=1..400", "--out", "o"};
  Program program(words, start);
  ASSERT_TRUE(program.wait_for("sweep: 10 %", 60.0)) << program.err();
  program.send(SIGINT);
  const Finished end = program.finish();
  EXPECT_EQ(end.status, 130) << end.err;
  EXPECT_THAT(end.err, HasSubstr("continue with --resume"));
  std::size_t whole = 0;
  for (const std::string& name : entries("o")) {
    EXPECT_NE(name.front(), '.') << name;
    if (name.starts_with("sim_")) ++whole;
  }
  EXPECT_GE(whole, 40U);
  EXPECT_LT(whole, 400U);
  EXPECT_FALSE(fs::exists(folder_ / "o/sweep.csv"));
  const Finished rest = sarsim({"sweep", "scene.scr", "--set", "seed=1..400", "--out", "o", "--resume", "--dry-run"});
  EXPECT_EQ(rest.status, 0) << rest.err;
  EXPECT_THAT(rest.err, HasSubstr(std::to_string(whole) + " done before"));
}

// Whoever starts the same part twice, as engines do after a machine was lost, is told to try again.
TEST_F(SweepResume, IsLeftToTheProcessThatMakesIt) {
  SceneText scene;
  scene.pulses = 1500;
  scene.lsb_mv = "1e-6";
  write_scene(scene);
  Start start;
  start.folder = folder_;
  const std::vector<std::string> words{"--set", "seed=1..400", "--out", "o", "--jobs", "1", "--resume"};
  std::vector<std::string> part = words;
  part.insert(part.end(), {"--part", "1/2"});
  part.insert(part.begin(), {"sweep", "scene.scr"});
  Program busy(part, start);
  ASSERT_TRUE(busy.wait_for("sweep: 10 %", 60.0)) << busy.err();
  part.emplace_back("--json");
  const Finished twice = sarsim(part);
  EXPECT_EQ(twice.status, 75) << twice.err;
  EXPECT_THAT(twice.err, HasSubstr("part 1/2 of this sweep is being made by another process"));
  EXPECT_THAT(twice.out, HasSubstr("\"status\": \"try again\""));
  const Finished whole = sweep(words);
  EXPECT_EQ(whole.status, 75) << whole.err;
  part.back() = "--dry-run";
  EXPECT_EQ(sarsim(part).status, 0) << "looking is free";
  busy.send(SIGKILL);
  EXPECT_EQ(busy.finish().status, -SIGKILL);
  EXPECT_EQ(sweep({"--set", "seed=2,4", "--out", "o", "--resume"}).status, 0) << "the lock has gone with its process";
}

TEST_F(SweepResume, SuddenDeathLosesNoFinishedVariation) {
  SceneText scene;
  scene.pulses = 1500;
  scene.lsb_mv = "1e-6";
  write_scene(scene);
  Start start;
  start.folder = folder_;
  Program program({"sweep", "scene.scr", "--set", "seed=1..400", "--out", "o"}, start);
  ASSERT_TRUE(program.wait_for("sweep: 10 %", 60.0)) << program.err();
  program.send(SIGKILL);
  EXPECT_EQ(program.finish().status, -SIGKILL);
  const Finished rest = sarsim({"sweep", "scene.scr", "--set", "seed=1..400", "--out", "o", "--resume", "--dry-run"});
  EXPECT_THAT(rest.err, HasSubstr(" done before"));
  EXPECT_THAT(rest.err, Not(HasSubstr(" 0 done before")));
}

}  // namespace resume_test
}  // namespace sarsim::test
