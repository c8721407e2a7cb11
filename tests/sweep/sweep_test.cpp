#include <cmath>

#include <gmock/gmock.h>

#include "csv.hpp"
#include "program.hpp"

namespace sarsim::test {
namespace sweep_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class SweepCommand : public CommandTest {};

TEST_F(SweepCommand, MakesAFileForEachVariationAndATable) {
  write_scene({});
  const Finished sweep =
      sarsim({"sweep", "scene.scr", "--set", "Radar1.bandwidth=20MHz,50MHz", "--set", "seed=1..2", "--out", "o"});
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  EXPECT_EQ(sweep.out, "");
  EXPECT_THAT(entries("o"),
              ElementsAre("sim_Radar1.bandwidth=20MHz_seed=1.bin", "sim_Radar1.bandwidth=20MHz_seed=2.bin",
                          "sim_Radar1.bandwidth=50MHz_seed=1.bin", "sim_Radar1.bandwidth=50MHz_seed=2.bin", "sweep.csv",
                          "sweep.journal", "sweep.json"));
  const auto rows = read_csv(text_of(folder_ / "o/sweep.csv"));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[2].at("variation"), "3");
  EXPECT_EQ(rows[2].at("Radar1.bandwidth [Hz]"), "50000000");
  EXPECT_EQ(rows[2].at("seed"), "1");
  EXPECT_EQ(rows[2].at("file"), "sim_Radar1.bandwidth=50MHz_seed=1.bin");
  EXPECT_EQ(rows[2].at("status"), "done");
  EXPECT_EQ(rows[2].at("rows"), "20");
  EXPECT_EQ(rows[2].at("columns"), "334");
  EXPECT_EQ(rows[2].at("bytes"), std::to_string(20 * 334 * 2));
  EXPECT_TRUE(is_json(text_of(folder_ / "o/sweep.json"), folder_));
}

TEST_F(SweepCommand, MakesTheBytesThatARunOfTheChangedScriptMakes) {
  SceneText scene;
  write_scene(scene);
  ASSERT_EQ(sarsim({"sweep", "scene.scr", "--set", "seed=5,6", "--set", "Radar1.noise_temperature=300,600"}).status, 0);
  scene.noise_k = "600";
  write_text(folder_ / "changed.scr", scene.text());
  ASSERT_EQ(sarsim({"run", "changed.scr", "--seed", "6", "--out", "r"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "sim_seed=6_Radar1.noise_temperature=600.bin"), text_of(folder_ / "r/sim.bin"));
  EXPECT_NE(text_of(folder_ / "sim_seed=5_Radar1.noise_temperature=600.bin"), text_of(folder_ / "r/sim.bin"));
}

TEST_F(SweepCommand, RunWithOneValueMakesTheSameBytes) {
  write_scene({});
  ASSERT_EQ(sarsim({"sweep", "scene.scr", "--set", "seed=6", "--set", "Radar1.noise_temperature=600"}).status, 0);
  ASSERT_EQ(
      sarsim({"run", "scene.scr", "--set", "seed=6", "--set", "Radar1.noise_temperature=600", "--out", "r"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "sim_seed=6_Radar1.noise_temperature=600.bin"), text_of(folder_ / "r/sim.bin"));
  const Finished many = sarsim({"run", "scene.scr", "--set", "seed=1..3", "--out", "m"});
  EXPECT_EQ(many.status, 2);
  EXPECT_THAT(many.err, HasSubstr("seed=1..3"));
}

TEST_F(SweepCommand, SaysTheSameWhateverRunsBesideWhat) {
  write_scene({});
  const std::vector<std::string> set{"--set", "seed=1..7", "--set", "Target1.rcs=1,4", "--format", "npy"};
  const auto sweep = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> words{"sweep", "scene.scr", "--out", out};
    words.insert(words.end(), set.begin(), set.end());
    words.insert(words.end(), more.begin(), more.end());
    const Finished end = sarsim(words);
    EXPECT_EQ(end.status, 0) << end.err;
    return without_seconds(text_of(folder_ / out / "sweep.csv"));
  };
  const std::string alone = sweep("a", {"--jobs", "1", "--threads", "1"});
  EXPECT_EQ(sweep("b", {"--jobs", "5", "--threads", "4"}), alone);
  EXPECT_EQ(sweep("c", {"--jobs", "1", "--threads", "4"}), alone);
  const std::string name = "sim_seed=3_Target1.rcs=4.npy";
  EXPECT_EQ(text_of(folder_ / "a" / name), text_of(folder_ / "b" / name));
  EXPECT_EQ(text_of(folder_ / "a" / name), text_of(folder_ / "c" / name));
}

TEST_F(SweepCommand, FollowsThePhysics) {
  SceneText scene;
  scene.noise_k = "0";
  scene.lsb_mv = "1e-6";
  write_scene(scene);
  // Power goes with the fourth power of the distance and with the cross-section.
  ASSERT_EQ(sarsim({"sweep", "scene.scr", "--set", "Target1.rcs=1,4", "--discard", "--zip", "--set",
                    "Radar1.power=1kW,1kW", "--out", "zip"})
                .status,
            0);
  ASSERT_EQ(
      sarsim({"sweep", "scene.scr", "--set", "Target1.rcs=1,4", "--set", "Radar1.power=1kW,9kW", "--discard"}).status,
      0);
  const auto rows = read_csv(text_of(folder_ / "sweep.csv"));
  ASSERT_EQ(rows.size(), 4U);
  const auto maximum_v = [&](std::size_t i) { return std::stod(rows[i].at("maximum_v")); };
  EXPECT_NEAR(maximum_v(1) / maximum_v(0), 3.0, 1e-5);
  EXPECT_NEAR(maximum_v(2) / maximum_v(0), 2.0, 1e-5);
  EXPECT_NEAR(maximum_v(3) / maximum_v(0), 6.0, 1e-5);
}

TEST_F(SweepCommand, PairsWithZip) {
  write_scene({});
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "Simulation1.bits=4,8", "--set", "seed=3,4", "--zip"});
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  EXPECT_THAT(entries("."),
              ElementsAre("scene.scr", "sim_Simulation1.bits=4_seed=3.bin", "sim_Simulation1.bits=8_seed=4.bin",
                          "sweep.csv", "sweep.journal", "sweep.json"));
}

TEST_F(SweepCommand, PrintsWhatWouldRunAndMakesNothing) {
  write_scene({});
  const Finished dry = sarsim({"sweep", "scene.scr", "--set", "seed=1..3", "--out", "o", "--dry-run"});
  EXPECT_EQ(dry.status, 0) << dry.err;
  EXPECT_EQ(dry.out,
            "1  seed=1  sim_seed=1.bin  20 x 334 samples, 13.4 kB\n"
            "2  seed=2  sim_seed=2.bin  20 x 334 samples, 13.4 kB\n"
            "3  seed=3  sim_seed=3.bin  20 x 334 samples, 13.4 kB\n");
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

// Names of files lose blanks, and have a dash for what is no part of a word.
TEST_F(SweepCommand, GivesEveryProductAFileOfItsOwn) {
  SceneText scene;
  scene.files = {"sim1.bin", "sim@1.bin", "sim-1.bin"};
  write_scene(scene);
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "seed=1,2", "--out", "o"});
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  EXPECT_THAT(entries("o"),
              ElementsAre("sim-1-2_seed=1.bin", "sim-1-2_seed=2.bin", "sim-1_seed=1.bin", "sim-1_seed=2.bin",
                          "sim1_seed=1.bin", "sim1_seed=2.bin", "sweep.csv", "sweep.journal", "sweep.json"));
}

TEST_F(SweepCommand, ChangesTheExtensionWithTheFormat) {
  write_scene({});
  const Finished sweep =
      sarsim({"sweep", "scene.scr", "--set", "Simulation1.format=BINARY,NPY,HDF5", "--set", "seed=1..2"});
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  EXPECT_TRUE(fs::exists(folder_ / "sim_Simulation1.format=BINARY_seed=1.bin"));
  EXPECT_TRUE(fs::exists(folder_ / "sim_Simulation1.format=NPY_seed=2.npy"));
  ASSERT_TRUE(fs::exists(folder_ / "sim_Simulation1.format=HDF5_seed=2.h5"));
  EXPECT_THAT(sarsim({"info", "sim_Simulation1.format=HDF5_seed=2.h5"}).out, HasSubstr("seed"));
}

TEST_F(SweepCommand, MakesEveryProductOrTheChosenOnes) {
  SceneText scene;
  scene.files = {"one.bin", "two.bin", "sub/one.bin"};
  scene.geometry = "table.txt";
  write_scene(scene);
  ASSERT_EQ(sarsim({"sweep", "scene.scr", "--set", "Target1.rcs=1,2", "--out", "all"}).status, 0);
  EXPECT_EQ(entries("all").size(), 8U + 3U);
  EXPECT_EQ(read_csv(text_of(folder_ / "all/sweep.csv")).size(), 8U);
  ASSERT_EQ(sarsim({"sweep", "scene.scr", "2", "table.txt", "--set", "Target1.rcs=1,2", "--out", "some"}).status, 0);
  EXPECT_THAT(entries("some"),
              ElementsAre("sweep.csv", "sweep.journal", "sweep.json", "table_Target1.rcs=1.txt",
                          "table_Target1.rcs=2.txt", "two_Target1.rcs=1.bin", "two_Target1.rcs=2.bin"));
}

TEST_F(SweepCommand, PaysNoAttentionToProductsThatAreNotChosen) {
  SceneText scene;
  scene.files = {"one.bin", "two.bin"};
  scene.geometry = "table.txt";
  std::string text = scene.text();
  const std::string first = "$SIMULATION Radar1 900 1400";
  text.replace(text.find(first), first.size(), "$SIMULATION Radar1 900 800");
  write_text(folder_ / "scene.scr", text);
  const Finished dry = sarsim({"sweep", "scene.scr", "2", "table.txt", "--set", "seed=1..2", "--dry-run"});
  EXPECT_EQ(dry.status, 0) << dry.err;
  EXPECT_EQ(dry.out,
            "1  seed=1  two_seed=1.bin  20 x 334 samples, 13.4 kB\n"
            "1  seed=1  table_seed=1.txt  geometry table\n"
            "2  seed=2  two_seed=2.bin  20 x 334 samples, 13.4 kB\n"
            "2  seed=2  table_seed=2.txt  geometry table\n");
  EXPECT_THAT(dry.err, HasSubstr("26.7 kB"));
  const Finished made = sarsim({"sweep", "scene.scr", "2", "--set", "seed=1..2", "--out", "o"});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(sarsim({"sweep", "scene.scr", "1", "--set", "seed=1..2", "--out", "p"}).err, HasSubstr("scene.scr:8"));
  EXPECT_FALSE(fs::exists(folder_ / "p"));
}

TEST_F(SweepCommand, ThatIsOnlyPlannedIsToldAsJson) {
  write_scene({});
  const Finished dry = sarsim({"sweep", "scene.scr", "--set", "seed=1..2", "--dry-run", "--json"});
  EXPECT_EQ(dry.status, 0) << dry.err;
  ASSERT_TRUE(is_json(dry.out, folder_)) << dry.out;
  for (const char* text : {"\"planned\"", "sim_seed=2.bin", "\"columns\": 334", "\"not made\""})
    EXPECT_THAT(dry.out, HasSubstr(text));
}

TEST_F(SweepCommand, ReportsAllProblemsOfAllVariationsBeforeAnythingRuns) {
  write_scene({});
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "Simulation1.sample_rate=10MHz,100MHz,200MHz", "--set",
                                 "Simulation1.range_end=500m,1400m", "--out", "o"});
  EXPECT_EQ(sweep.status, 2);
  EXPECT_THAT(sweep.err, HasSubstr("error:"));
  EXPECT_THAT(sweep.err, HasSubstr("in 3 of 6 variations, first with Simulation1.sample_rate=10MHz "
                                   "Simulation1.range_end=500m"));
  EXPECT_FALSE(fs::exists(folder_ / "o"));
}

TEST_F(SweepCommand, SaysWhatIsCommonToAllVariationsOnceAndPlainly) {
  SceneText scene;
  scene.target_m = 5000.0;  // Outside the window.
  write_scene(scene);
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "seed=1..50", "--discard"});
  EXPECT_EQ(sweep.status, 0) << sweep.err;
  const std::size_t first = sweep.err.find("warning:");
  ASSERT_NE(first, std::string::npos) << sweep.err;
  EXPECT_EQ(sweep.err.find("warning:", first + 1), std::string::npos) << sweep.err;
  EXPECT_THAT(sweep.err, Not(HasSubstr("variations, first")));
  EXPECT_EQ(sarsim({"sweep", "scene.scr", "--set", "seed=1..50", "--discard", "--strict", "--force"}).status, 2);
}

TEST_F(SweepCommand, RefusesSettingsThatMakeNoSense) {
  write_scene({});
  const auto complaint = [&](const std::string& setting) {
    const Finished sweep = sarsim({"sweep", "scene.scr", "--set", setting});
    EXPECT_EQ(sweep.status, 2) << setting;
    return sweep.err;
  };
  EXPECT_THAT(complaint("Radar1.bandwith=1MHz"), HasSubstr("did you mean bandwidth?"));
  EXPECT_THAT(complaint("Radar1.bandwidth=10MHz:-1MHz:100MHz"), HasSubstr("never reaches its end"));
  EXPECT_THAT(complaint("seed=1..1000000000"), HasSubstr("more than 100000 values"));
  EXPECT_THAT(complaint("Radar1.bandwidth"), HasSubstr("there is no '='"));
  EXPECT_THAT(complaint("Radar1.barker_code=13"), HasSubstr("does not apply with the present choices"));
  EXPECT_THAT(complaint("Radar1.platform=Nowhere"), HasSubstr("Nowhere"));
  const Finished nothing = sarsim({"sweep", "scene.scr"});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_THAT(nothing.err, HasSubstr("nothing varies"));
  EXPECT_THAT(entries("."), ElementsAre("scene.scr"));
}

TEST_F(SweepCommand, BlamesTheSettingAndNotTheLineOfTheScript) {
  write_scene({});
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "Simulation1.range_end=500m"});
  EXPECT_EQ(sweep.status, 2);
  EXPECT_THAT(sweep.err, HasSubstr("error:"));
  EXPECT_THAT(sweep.err, Not(HasSubstr("scene.scr:")));
}

TEST_F(SweepCommand, SaysWhatABadScriptSays) {
  write_text(folder_ / "scene.scr", SceneText{}.text() + "$TARGET Earth 1 2 x\n");
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "seed=1..3"});
  EXPECT_EQ(sweep.status, 2);
  EXPECT_THAT(sweep.err, HasSubstr("scene.scr:"));
  write_text(folder_ / "scene.scr", "$TARGET Earth 0 0 0 0 0 0 1 0 ISOTROPIC\n");
  EXPECT_THAT(sarsim({"sweep", "scene.scr", "--set", "seed=1..3"}).err,
              HasSubstr("defines no recording or geometry table to vary"));
}

TEST_F(SweepCommand, RefusesExistingFilesOnceForAll) {
  write_scene({});
  write_text(folder_ / "sim_seed=2.bin", "precious");
  write_text(folder_ / "sim_seed=3.bin", "precious");
  const std::vector<std::string> words{"sweep", "scene.scr", "--set", "seed=1..3"};
  const Finished sweep = sarsim(words);
  EXPECT_EQ(sweep.status, 2);
  EXPECT_THAT(sweep.err, HasSubstr("exists already, and 1 other;"));
  EXPECT_THAT(sweep.err, HasSubstr("--force"));
  EXPECT_FALSE(fs::exists(folder_ / "sim_seed=1.bin"));
  EXPECT_EQ(text_of(folder_ / "sim_seed=2.bin"), "precious");
  EXPECT_EQ(sarsim({"sweep", "scene.scr", "--set", "seed=1..3", "--force"}).status, 0);
  EXPECT_EQ(fs::file_size(folder_ / "sim_seed=2.bin"), fs::file_size(folder_ / "sim_seed=1.bin"));
  EXPECT_EQ(sarsim(words).status, 2);  // The table stands in the way, too.
}

// The target jumps to the radar for one pulse of 901, which is none of the 64 that the check looks at.
// Two outputs that are one file would leave one of them.
TEST_F(SweepCommand, RefusesOutputsThatAreLinks) {
  write_scene({});
  fs::create_directory(folder_ / "o");
  const auto refused = [this](const std::string& message) {
    const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "seed=1,2", "--out", "o", "--force"});
    EXPECT_EQ(sweep.status, 2);
    EXPECT_THAT(sweep.err, HasSubstr(message));
    EXPECT_THAT(entries("o"), Not(Contains("sim_seed=2.bin")));
    for (const std::string& name : entries("o")) fs::remove(folder_ / "o" / name);
  };
  const std::string link = "a link has the name of a file that the sweep makes";
  fs::create_symlink("sweep.csv", folder_ / "o/sim_seed=1.bin");
  refused(link);
  fs::create_symlink("sweep.json", folder_ / "o/sweep.csv");
  refused(link);
  write_text(folder_ / "o/sim_seed=1.bin", "old");
  fs::create_hard_link(folder_ / "o/sim_seed=1.bin", folder_ / "o/sweep.csv");
  refused("this file and 'o/sim_seed=1.bin' are one file; found 'o/sweep.csv'");
}

TEST_F(SweepCommand, MakesTheOtherVariationsWhereOneMeetsAnImpossibleEcho) {
  std::string text = SceneText{}.text();
  const std::string path = "2 0, 0 1, 20 1 0, 1000 1 0, 0";
  ASSERT_NE(text.find(path), std::string::npos);
  text.replace(text.find(path), path.size(), "6 0 1000 0.7765 1000 0.7766 0 0.7774 0 0.7775 1000 2 1000, 1 0 0, 1 0 0");
  text.replace(text.find("900 1400 0 0.019"), 16, "900 1400 0 0.9");
  write_text(folder_ / "scene.scr", text);
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "Target1.x=0,1,2", "--json"});
  EXPECT_EQ(sweep.status, 2);
  EXPECT_THAT(sweep.err, HasSubstr("error: Target1.x=0: the target is at the position of radar"));
  EXPECT_THAT(sweep.err, HasSubstr("pulse 777"));
  EXPECT_THAT(sweep.out, HasSubstr("\"status\": \"failed\""));
  const auto rows = read_csv(text_of(folder_ / "sweep.csv"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].at("status"), "failed");
  EXPECT_EQ(rows[1].at("status"), "done");
  EXPECT_FALSE(fs::exists(folder_ / "sim_Target1.x=0.bin"));
  EXPECT_TRUE(fs::exists(folder_ / "sim_Target1.x=2.bin"));
  // Only what failed is tried again.
  const Finished again = sarsim({"sweep", "scene.scr", "--set", "Target1.x=0,1,2", "--resume"});
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.err, HasSubstr("2 done before, 1 to run"));
}

TEST_F(SweepCommand, ListsTheFieldsThatCanBeSet) {
  write_scene({});
  const Finished fields = sarsim({"sweep", "scene.scr", "--fields"});
  EXPECT_EQ(fields.status, 0) << fields.err;
  EXPECT_THAT(fields.out, HasSubstr("\nRadar1.bandwidth "));
  EXPECT_THAT(fields.out, HasSubstr("50 MHz"));
  EXPECT_THAT(fields.out, HasSubstr("Hz, kHz, MHz, GHz"));
  EXPECT_THAT(fields.out, HasSubstr("\nseed "));
  EXPECT_THAT(fields.out, Not(HasSubstr("barker_code")));  // The pulse is a chirp.
}

TEST_F(SweepCommand, PrintsTheTableAsJson) {
  write_scene({});
  const Finished sweep = sarsim({"sweep", "scene.scr", "--set", "seed=1..2", "--json", "--quiet"});
  EXPECT_EQ(sweep.status, 0);
  EXPECT_EQ(sweep.err, "");
  EXPECT_EQ(sweep.out, text_of(folder_ / "sweep.json"));
  EXPECT_TRUE(is_json(sweep.out, folder_));
  const Finished bad = sarsim({"sweep", "scene.scr", "--set", "Simulation1.range_end=500m", "--json", "--out", "o"});
  EXPECT_EQ(bad.status, 2);
  EXPECT_TRUE(is_json(bad.out, folder_)) << bad.out;
  EXPECT_THAT(bad.out, HasSubstr("\"status\": \"bad input\""));
}

}  // namespace sweep_test
}  // namespace sarsim::test
