#include <chrono>
#include <csignal>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace {

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
    const auto begin = std::chrono::steady_clock::now();
    program.send(signal);
    const Finished end = program.finish();
    EXPECT_EQ(end.status, status) << end.err;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
    EXPECT_THAT(entries("."), ElementsAre("scene.scr", "sim.bin"));
    EXPECT_EQ(text_of(folder_ / "sim.bin"), "earlier");
    EXPECT_THAT(end.out, HasSubstr("\"status\": \"interrupted\""));
    EXPECT_TRUE(is_json(end.out, folder_));
  }
};

TEST_F(Interruption, ControlCLeavesNothingUnfinished) { expect_clean_end(SIGINT, 130); }

TEST_F(Interruption, TerminationLeavesNothingUnfinished) { expect_clean_end(SIGTERM, 143); }

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
  EXPECT_EQ(program.finish(5.0).status, 143);
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

}  // namespace
}  // namespace sarsim::test
