#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace interrupt_test {

using testing::ElementsAre;
using testing::HasSubstr;

class Interruption : public CommandTest {
 protected:
  // Half a gigabyte of noise: seconds of work.
  void write_long_scene() const {
    SceneText scene;
    scene.pulses = 800000;
    scene.lsb_mv = "1e-6";
    scene.files = {"sim.bin"};
    write_scene(scene);
  }

  [[nodiscard]] Start here() const {
    Start start;
    start.folder = folder_;
    return start;
  }

  void expect_clean_end(int signal, int status) const {
    write_long_scene();
    write_text(folder_ / "sim.bin", "earlier");
    Program program({"run", "scene.scr", "--force", "--json"}, here());
    ASSERT_TRUE(program.wait_for("sim.bin: 10 %", 60.0)) << program.err();
    EXPECT_EQ(entries(".").size(), 3U);  // The script, the earlier file and the unfinished one.
    const double before_s = program.processor_s();
    program.send(signal);
    const Finished end = program.finish();
    EXPECT_EQ(end.status, status) << end.err;
    EXPECT_LT(end.processor_s - before_s, 2.0);
    EXPECT_THAT(entries("."), ElementsAre("scene.scr", "sim.bin"));
    EXPECT_EQ(text_of(folder_ / "sim.bin"), "earlier");
    EXPECT_THAT(end.out, HasSubstr("\"status\": \"interrupted\""));
    EXPECT_TRUE(is_json(end.out, folder_));
  }
};

TEST_F(Interruption, ControlCLeavesNothingUnfinished) { expect_clean_end(SIGINT, 130); }

TEST_F(Interruption, TerminationLeavesNothingUnfinished) { expect_clean_end(SIGTERM, 143); }

TEST_F(Interruption, HangUpLeavesNothingUnfinished) { expect_clean_end(SIGHUP, 129); }

// A terminal that closes and its shell both say so.
TEST_F(Interruption, HangUpThatIsRepeatedStillCleansUp) {
  write_long_scene();
  Program program({"run", "scene.scr"}, here());
  ASSERT_TRUE(program.wait_for("sim.bin: 10 %", 60.0)) << program.err();
  for (int i = 0; i < 3; ++i) program.send(SIGHUP);
  EXPECT_EQ(program.finish().status, 129);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

TEST_F(Interruption, HangUpThatWasIgnoredStaysSo) {
  SceneText scene;
  scene.pulses = 400000;
  scene.lsb_mv = "1e-6";
  write_scene(scene);
  Start start = here();
  start.ignores_hangup = true;
  Program program({"run", "scene.scr"}, start);
  ASSERT_TRUE(program.wait_for("sim.bin: 10 %", 60.0)) << program.err();
  program.send(SIGHUP);
  EXPECT_EQ(program.finish().status, 0);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr", "sim.bin"));
}

TEST_F(Interruption, HangUpEndsSweepsAndMapsCleanly) {
  write_long_scene();
  Program sweep({"sweep", "scene.scr", "--set", "seed=1..4", "--out", "s", "--jobs", "1"}, here());
  ASSERT_TRUE(sweep.wait_for("4 to run", 60.0)) << sweep.err();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  sweep.send(SIGHUP);
  EXPECT_EQ(sweep.finish().status, 129);
  for (const std::string& name : entries("s")) EXPECT_THAT(name, testing::Not(HasSubstr(".partial")));
  Program doppler({"doppler", "scene.scr", "--out", "d/map.img"}, here());
  ASSERT_TRUE(doppler.wait_for("map.img: 10 %", 60.0)) << doppler.err();
  doppler.send(SIGHUP);
  EXPECT_EQ(doppler.finish().status, 129);
  EXPECT_TRUE(entries("d").empty());
}

TEST_F(Interruption, SuddenDeathLeavesTheEarlierFileAlone) {
  write_long_scene();
  write_text(folder_ / "sim.bin", "earlier");
  Program program({"run", "scene.scr", "--force"}, here());
  ASSERT_TRUE(program.wait_for("sim.bin: 10 %", 60.0)) << program.err();
  program.send(SIGKILL);
  EXPECT_EQ(program.finish().status, -SIGKILL);
  EXPECT_EQ(text_of(folder_ / "sim.bin"), "earlier");
}

TEST_F(Interruption, ProductsFinishedBeforeStay) {
  SceneText quick;
  quick.files = {"quick.bin"};
  SceneText slow;
  slow.pulses = 800000;
  slow.lsb_mv = "1e-6";
  slow.files = {"slow.bin"};
  const std::string text = slow.text();
  write_text(folder_ / "scene.scr", quick.text() + text.substr(text.find("$SIMULATION")));
  Program program({"run", "scene.scr"}, here());
  ASSERT_TRUE(program.wait_for("slow.bin: 10 %", 60.0)) << program.err();
  program.send(SIGINT);
  EXPECT_EQ(program.finish().status, 130);
  EXPECT_THAT(entries("."), ElementsAre("quick.bin", "scene.scr"));
}

TEST_F(Interruption, ReachesTheEstimateOfTheLsb) {
  SceneText scene;
  scene.pulses = 800000;
  write_scene(scene);
  Program program({"run", "scene.scr"}, here());
  ASSERT_TRUE(program.wait_for("(finding the largest magnitude): 10 %", 60.0)) << program.err();
  program.send(SIGTERM);
  EXPECT_EQ(program.finish().status, 143);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

// Nobody looks at the request while a file is opened or read.
TEST_F(Interruption, EndsWhatWaitsForAPipe) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe.scr").c_str(), 0600), 0);
  for (const auto& [signal, status] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143)}) {
    Program program({"check", "pipe.scr"}, here());
    ASSERT_TRUE(program.wait_until_it_catches(signal, 60.0)) << program.err();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    program.send(signal);
    const Finished end = program.finish();
    EXPECT_EQ(end.status, status);
    EXPECT_THAT(end.err, HasSubstr("interrupted"));
  }
}

TEST_F(Interruption, TwiceInAMomentLeavesNothingUnfinished) {
  write_long_scene();
  Program program({"run", "scene.scr"}, here());
  ASSERT_TRUE(program.wait_for("sim.bin: 10 %", 60.0)) << program.err();
  program.send(SIGINT);
  program.send(SIGTERM);
  EXPECT_NE(program.finish().status, 0);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

}  // namespace interrupt_test
}  // namespace sarsim::test
