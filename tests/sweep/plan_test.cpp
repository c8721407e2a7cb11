#include <chrono>
#include <cstdio>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>

#include "program.hpp"

namespace sarsim::test {
namespace plan_test {

using testing::HasSubstr;
using testing::Not;

class PlanCommand : public CommandTest {
 protected:
  // The first number behind a member's name; NaN where there is none.
  static double member(const std::string& json, const std::string& name) {
    const std::size_t place = json.find("\"" + name + "\": ");
    return place == std::string::npos ? std::numeric_limits<double>::quiet_NaN()
                                      : std::stod(json.substr(place + name.size() + 4));
  }
};

TEST_F(PlanCommand, SaysWhatARunTakes) {
  SceneText scene;
  scene.files = {"one.bin", "two.bin"};
  write_scene(scene);
  const Finished plan = sarsim({"info", "scene.scr", "--plan", "--workers", "3", "--threads", "1"});
  EXPECT_EQ(plan.status, 0) << plan.err;
  for (const char* text : {"simulation 1: one.bin, raw", "simulation 2: two.bin", "20 x 334", "13.4 kB", "memory",
                           "computed twice", "from a trial of", "1 worker ", "2 workers", "3 workers"})
    EXPECT_THAT(plan.out, HasSubstr(text));
}

TEST_F(PlanCommand, SaysTheSameAsJson) {
  write_scene({});
  const Finished plan = sarsim({"info", "scene.scr", "--plan", "--workers", "4", "--json"});
  EXPECT_EQ(plan.status, 0) << plan.err;
  EXPECT_TRUE(is_json(plan.out, folder_));
  EXPECT_EQ(member(plan.out, "samples"), 20.0 * 334.0);
  EXPECT_EQ(member(plan.out, "bytes"), 20.0 * 334.0 * 2.0);
  EXPECT_EQ(member(plan.out, "passes"), 2.0);
  EXPECT_GT(member(plan.out, "memory_bytes"), 1e6);
  EXPECT_GT(member(plan.out, "seconds_per_row"), 0.0);
  EXPECT_GE(member(plan.out, "trial_rows"), 1.0);
}

TEST_F(PlanCommand, TakesOtherValuesThanTheScripts) {
  write_scene({});
  const Finished plan = sarsim({"info", "scene.scr", "--plan", "--json", "--set", "Simulation1.sample_rate=200MHz",
                                "--set", "Simulation1.time_end=39ms"});
  EXPECT_EQ(plan.status, 0) << plan.err;
  EXPECT_EQ(member(plan.out, "rows"), 40.0);
  EXPECT_EQ(member(plan.out, "columns"), 667.0);
  EXPECT_THAT(sarsim({"info", "scene.scr", "--set", "seed=17"}).out, HasSubstr("seed 17"));
  const Finished wrong =
      sarsim({"info", "scene.scr", "--set", "seed", "--set", "Radar1.bandwith=1", "--set", "Simulation1.bits=0"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("there is no '='"));
  EXPECT_THAT(wrong.err, HasSubstr("did you mean bandwidth?"));
  EXPECT_THAT(wrong.err, HasSubstr("--set Simulation1.bits=0: "));
}

TEST_F(PlanCommand, RefusesWhatItCannotPlan) {
  write_scene({});
  ASSERT_EQ(sarsim({"run", "scene.scr", "--format", "npy"}).status, 0);
  const Finished data = sarsim({"info", "sim.npy", "--plan"});
  EXPECT_EQ(data.status, 2);
  EXPECT_THAT(data.err, HasSubstr("is not a script"));
  EXPECT_THAT(sarsim({"info", "scene.scr", "--workers", "2"}).err, HasSubstr("add --plan"));
  EXPECT_EQ(sarsim({"info", "scene.scr", "--plan", "--workers", "0"}).status, 2);
}

TEST_F(PlanCommand, SaysSoWhereAScriptHasNoRecording) {
  write_text(folder_ / "scene.scr", "$TARGET Earth 0 0 0 0 0 0 1 0 ISOTROPIC\n");
  const Finished plan = sarsim({"info", "scene.scr", "--plan"});
  EXPECT_EQ(plan.status, 0) << plan.err;
  EXPECT_THAT(plan.out, HasSubstr("the scene has no recording"));
  EXPECT_THAT(sarsim({"info", "scene.scr", "--plan", "--json"}).out, HasSubstr("\"seconds\""));
}

// The machine may do other things meanwhile, to the estimate or to the run; but not each of ten times.
TEST_F(PlanCommand, EstimatesTheTimeOfARunWithinAFactorOfTwo) {
  SceneText scene;
  scene.pulses = 20000;  // Half a second of noise and text.
  scene.format = "ASCII";
  write_scene(scene);
  const std::string examples = SARSIM_SOURCE_DIR "/examples/";
  for (const std::string& path : {std::string("scene.scr"), examples + "sar_r.scr", examples + "thesis_chapter3.scr",
                                  examples + "stepped_srp.scr"}) {
    std::ostringstream tried;
    bool near = false;
    for (int i = 0; i < 10 && !near; ++i) {
      const Finished plan = sarsim({"info", path, "--plan", "--json", "--threads", "1"});
      ASSERT_EQ(plan.status, 0) << plan.err;
      const auto begin = std::chrono::steady_clock::now();
      ASSERT_EQ(sarsim({"run", path, "--discard", "--quiet", "--threads", "1"}).status, 0);
      const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      // The total stands behind the recordings, each of which has seconds of its own.
      const double estimated_s = member(plan.out.substr(plan.out.rfind("\"memory_bytes\"")), "seconds");
      // A process takes some milliseconds to begin and end.
      constexpr double process_s = 0.02;
      near = estimated_s + process_s > 0.5 * took_s && estimated_s < 2.0 * took_s + process_s;
      tried << estimated_s << " s estimated, " << took_s << " s taken; ";
    }
    EXPECT_TRUE(near) << path << ": " << tried.str();
    std::printf("%s: %s\n", path.c_str(), tried.str().c_str());
  }
}

}  // namespace plan_test
}  // namespace sarsim::test
