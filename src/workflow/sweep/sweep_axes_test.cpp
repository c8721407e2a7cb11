#include "workflow/sweep/sweep_axes.hpp"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow {
namespace sweep_axes_test {

using testing::HasSubstr;
using testing::Not;

scene::Scene small_scene() {
  scene::Scene scene;
  scene.radars.resize(1);
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.targets.resize(2);
  scene.simulations.resize(1);
  return scene;
}

std::string complaint(const std::vector<std::string>& settings, bool paired = false) {
  try {
    (void)Sweep(small_scene(), {settings, paired});
  } catch (const core::InvalidRequest& error) {
    std::string text;
    for (const core::Problem& problem : error.problems) text += core::to_string(problem) + "\n";
    return text;
  }
  return "none";
}

TEST(SweepAxes, CombineWithTheLastVaryingFastest) {
  const Sweep sweep(small_scene(), {{"Radar1.bandwidth=10MHz,20MHz", "seed=1..3"}, false});
  ASSERT_EQ(sweep.size(), 6U);
  EXPECT_EQ(sweep.label(0), "Radar1.bandwidth=10MHz seed=1");
  EXPECT_EQ(sweep.label(1), "Radar1.bandwidth=10MHz seed=2");
  EXPECT_EQ(sweep.label(3), "Radar1.bandwidth=20MHz seed=1");
  EXPECT_EQ(sweep.label(5), "Radar1.bandwidth=20MHz seed=3");
}

TEST(SweepAxes, PairWithZip) {
  const Sweep sweep(small_scene(), {{"Radar1.bandwidth=10,20,30MHz", "Radar1.pulse_width=3,2,1us"}, true});
  ASSERT_EQ(sweep.size(), 3U);
  EXPECT_EQ(sweep.label(2), "Radar1.bandwidth=30MHz Radar1.pulse_width=1us");
  EXPECT_THAT(complaint({"seed=1..3", "Target1.x=1,2"}, true),
              HasSubstr("this one has 2 values and that of seed has 3"));
}

TEST(SweepAxes, SetTheValuesOfAVariation) {
  const scene::Scene base = small_scene();
  const Sweep sweep(base, {{"Radar1.bandwidth=10MHz,20MHz", "Target*.x=1km,2km"}, false});
  core::Problems problems;
  const scene::Scene scene = sweep.scene(base, 3, problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(scene.radars[0].bandwidth_hz, 20e6);
  EXPECT_EQ(scene.targets[0].position_m.x, 2000.0);
  EXPECT_EQ(scene.targets[1].position_m.x, 2000.0);
}

TEST(SweepAxes, MakeNoSceneWhereAStopIsRequested) {
  const scene::Scene base = small_scene();
  const Sweep sweep(base, {{"Radar1.bandwidth=10MHz,20MHz"}, false});
  core::StopFlag stop;
  stop.request();
  core::Problems problems;
  EXPECT_THROW((void)sweep.scene(base, 1, problems, &stop), core::Interrupted);
}

TEST(SweepAxes, SetInTheOrderInWhichTheyAreGiven) {
  const scene::Scene base = small_scene();
  const Sweep sweep(base, {{"Radar1.pulse=Barker", "Radar1.barker_code=13"}, false});
  core::Problems problems;
  EXPECT_EQ(sweep.scene(base, 0, problems).radars[0].barker_code, 6);
  EXPECT_TRUE(problems.empty());
  const Sweep reversed(base, {{"Radar1.barker_code=13", "Radar1.pulse=Barker"}, false});
  (void)reversed.scene(base, 0, problems);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].message, HasSubstr("--set Radar1.barker_code=13: "));
}

TEST(SweepAxes, NameFilesByTheValuesOfTheVariationAlone) {
  const Sweep few(small_scene(), {{"Radar1.bandwidth=20MHz", "seed=7"}, false});
  const Sweep many(small_scene(), {{"Radar1.bandwidth=10MHz,20MHz", "seed=5..9"}, false});
  EXPECT_EQ(few.file_name("sim1", ".h5", 0), "sim1_Radar1.bandwidth=20MHz_seed=7.h5");
  EXPECT_EQ(many.file_name("sim1", ".h5", 7), few.file_name("sim1", ".h5", 0));
}

TEST(SweepAxes, NamesOfFilesAreSafeAndDiffer) {
  const Sweep sweep(small_scene(), {{"Simulation1.file=\"a/b\",a-b,\"a b\",ab,$(x)"}, false});
  std::set<std::string> names;
  for (std::size_t i = 0; i < sweep.size(); ++i) names.insert(sweep.file_name("o u/t", ".bin", i));
  EXPECT_EQ(names.size(), 5U);
  for (const std::string& name : names)
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._+=-"),
              std::string::npos)
        << name;
}

TEST(SweepAxes, LongNamesBecomeNumbersThatStayTheSame) {
  std::vector<std::string> settings;
  for (const char* field : {"pulse_width", "bandwidth", "prf", "power", "losses", "noise_temperature", "transmit_gain"})
    settings.push_back(std::string("Radar1.") + field + "=1.23456789012345,2.3456789012345");
  const Sweep sweep(small_scene(), {settings, false});
  std::set<std::string> names;
  for (std::size_t i = 0; i < sweep.size(); ++i) names.insert(sweep.file_name("sim1", ".bin", i));
  EXPECT_EQ(names.size(), sweep.size());
  for (const std::string& name : names) EXPECT_LE(name.size(), 200U);
  EXPECT_EQ(sweep.file_name("sim1", ".bin", 5), sweep.file_name("sim1", ".bin", 5));
}

TEST(SweepAxes, RefuseWhatIsNoSettingAllAtOnce) {
  const std::string text =
      complaint({"seed", "=3", "sead=1", "Radar1.bandwidth=fast", "seed=2,2", "Target1.x=1", "Target*.x=3"});
  EXPECT_THAT(text, HasSubstr("--set seed: there is no '='"));
  EXPECT_THAT(text, HasSubstr("no field is named"));
  EXPECT_THAT(text, HasSubstr("did you mean seed?"));
  EXPECT_THAT(text, HasSubstr("not a valid frequency"));
  EXPECT_THAT(text, HasSubstr("--set seed=2: the value is given twice"));
  EXPECT_THAT(text, HasSubstr("set by Target1.x already"));
  EXPECT_THAT(complaint({}), HasSubstr("nothing varies"));
}

// What is told, and what is kept of it, do not grow with the square of the settings.
TEST(SweepAxes, TellOfAFieldThatIsSetVeryOftenSomeTimes) {
  std::vector<std::string> settings;
  for (int i = 0; i < 20000; ++i) settings.push_back("Target1.x=" + std::to_string(i));
  const std::string often = complaint(settings);
  EXPECT_EQ(std::ranges::count(often, '\n'), 20);
  EXPECT_THAT(often, HasSubstr("--set Target1.x=20: this field is set by Target1.x already"));
  EXPECT_THAT(often, Not(HasSubstr("Target1.x=21:")));
  settings.assign(20000, "Target7.x=1");
  EXPECT_EQ(std::ranges::count(complaint(settings), '\n'), 20);
  EXPECT_EQ(std::ranges::count(complaint({"Target1.x=1", "Target2.x=1", "Target*.x=1", "target1.X=2"}), '\n'), 2);
  EXPECT_EQ(complaint({"Target1.x=1", "Target2.x=1", "Target*.y=1", "seed=1", "tolerance=0.1"}), "none");
}

TEST(SweepAxes, SayThatTheDrawsOfALawDoNotDiffer) {
  const auto drawn = [](const std::string& setting, std::size_t draws) {
    SweepValues values;
    values.settings = {setting};
    values.draws = draws;
    try {
      (void)Sweep(small_scene(), values);
    } catch (const core::InvalidRequest& error) {
      return core::to_string(error.problems.at(0));
    }
    return std::string("none");
  };
  for (const char* law : {"Target1.rcs=uniform(1,1.0000000001)", "Target1.rcs=normal(1, 0)"}) {
    EXPECT_THAT(drawn(law, 3), HasSubstr("the values of this law do not differ enough: draws 1 and 2 are both 1"));
    EXPECT_THAT(drawn(law, 3), HasSubstr("draws have nine digits"));
    EXPECT_EQ(drawn(law, 1), "none");
  }
  EXPECT_THAT(drawn("Simulation1.bits=uniform(1, 3)", 9), HasSubstr("draws are rounded to whole numbers"));
  EXPECT_EQ(drawn("Target1.rcs=uniform(1, 2)", 3), "none");
}

TEST(SweepAxes, RefuseMoreVariationsThanAnybodyMeans) {
  EXPECT_THAT(complaint({"seed=1..1000", "Target1.x=1..101"}), HasSubstr("would have 101000 variations"));
  EXPECT_THAT(complaint({"seed=1..100001"}), HasSubstr("more than 100000 values"));
  EXPECT_EQ(complaint({"seed=1..1000", "Target1.x=1..100"}), "none");
}

TEST(SweepAxes, KnowTheFirstOfThoseThatDifferByTheSeed) {
  const Sweep sweep(small_scene(), {{"seed=1..3", "Target1.x=1,2"}, false});
  EXPECT_EQ(sweep.first_alike(4), 0U);
  EXPECT_EQ(sweep.first_alike(5), 1U);
  const Sweep paired(small_scene(), {{"seed=1,2", "Target1.x=1,2"}, true});
  EXPECT_EQ(paired.first_alike(1), 1U);
}

TEST(SweepAxes, KnowWhichFieldsVary) {
  const Sweep sweep(small_scene(), {{"Target2.x=1,2", "seed=1,2"}, false});
  EXPECT_TRUE(sweep.varies({"target", 1, "position_m"}));
  EXPECT_TRUE(sweep.varies({"target", 1, "position_m.x"}));
  EXPECT_FALSE(sweep.varies({"target", 0, "position_m"}));
  EXPECT_FALSE(sweep.varies({"target", 1, ""}));
  EXPECT_TRUE(sweep.varies({"options", 0, "seed"}));
  EXPECT_FALSE(sweep.varies({"simulation", 0, "bits"}));
}

TEST(SweepAxes, TablesHoldBaseUnits) {
  const Sweep sweep(small_scene(), {{"Radar1.bandwidth=10MHz,2.5e7", "Simulation1.processing=Raw"}, false});
  EXPECT_EQ(sweep.axes()[0].unit(), "Hz");
  EXPECT_EQ(sweep.axes()[0].table_text(0), "10000000");
  EXPECT_EQ(sweep.axes()[0].table_text(1), "25000000");
  EXPECT_EQ(sweep.axes()[1].unit(), "");
  EXPECT_EQ(sweep.axes()[1].table_text(0), "Raw");
}

}  // namespace sweep_axes_test
}  // namespace sarsim::workflow
