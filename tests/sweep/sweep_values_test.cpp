#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

#include "csv.hpp"
#include "program.hpp"

namespace sarsim::test {
namespace sweep_values_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// Where the values of a sweep come from besides lists on the command line.
class SweepValuesCommand : public CommandTest {
 protected:
  std::vector<std::map<std::string, std::string>> table(std::vector<std::string> words) {
    words.insert(words.begin(), {"sweep", "scene.scr"});
    words.insert(words.end(), {"--discard", "--force"});
    const Finished sweep = sarsim(words);
    EXPECT_EQ(sweep.status, 0) << sweep.err;
    return read_csv(text_of(folder_ / "sweep.csv"));
  }
  void expect_refusal(std::vector<std::string> words, const std::string& message) {
    words.insert(words.begin(), {"sweep", "scene.scr"});
    const Finished sweep = sarsim(words);
    EXPECT_EQ(sweep.status, 2);
    EXPECT_THAT(sweep.err, HasSubstr(message));
  }
};

TEST_F(SweepValuesCommand, PairedValuesMayBeRepeatedWhereVariationsDiffer) {
  write_scene({});
  EXPECT_EQ(table({"--zip", "--set", "Target1.rcs=1,1,2", "--set", "seed=1..3"}).size(), 3U);
  expect_refusal({"--zip", "--set", "Target1.rcs=1,1,2", "--set", "seed=1,1,1"},
                 "variations 1 and 2 have the same values: Target1.rcs=1 seed=1");
  expect_refusal({"--set", "Target1.rcs=1,1,2", "--set", "seed=1..3"}, "--set Target1.rcs=1: the value is given twice");
}

TEST_F(SweepValuesCommand, ATableHasAVariationInEachLine) {
  write_scene({});
  write_text(folder_ / "cases.csv",
             "# of a study\nTarget1.rcs,Radar1.bandwidth [MHz],Simulation1.processing\n"
             "1,20,RAW\n1,30,RAW\n4dBsm,2e7Hz,\"MATCHED_FILTER\"\n");
  const auto rows = table({"--values", "cases.csv"});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].at("Radar1.bandwidth [Hz]"), "30000000");
  EXPECT_EQ(rows[2].at("Radar1.bandwidth [Hz]"), "20000000");
  EXPECT_NEAR(std::stod(rows[2].at("Target1.rcs [m2]")), 2.5119, 1e-4);
  EXPECT_EQ(table({"--values", "cases.csv", "--set", "seed=1,2"}).size(), 6U);
  EXPECT_EQ(table({"--values", "cases.csv", "--set", "seed=1..3", "--zip"}).size(), 3U);
  expect_refusal({"--values", "cases.csv", "--set", "Target1.rcs=3"}, "set by Target1.rcs already");
  expect_refusal({"--values", "cases.csv", "--set", "seed=1..4", "--zip"}, "with --zip all lists are of one length");
}

TEST_F(SweepValuesCommand, WhatIsWrongWithATableHasItsLine) {
  write_scene({});
  const auto refused = [this](const std::string& text, const std::string& message) {
    write_text(folder_ / "cases.csv", text);
    expect_refusal({"--values", "cases.csv"}, message);
  };
  refused("Target1.rcs,seed\n1,2\n1\n",
          "cases.csv:3: error: a line has another number of values than there are columns");
  refused("Target1.rcs\n1\nmuch\n", "cases.csv:3: error: Target1.rcs: 'much' is not a valid");
  refused("Target1.rsc\n1\n", "cases.csv:1: error: a column is not named after a field");
  refused("Target1.rcs\n", "the table has no values");
  refused("", "the table has no values");
  refused("seed\n1\n2\n1\n", "cases.csv:4: error: seed=1: the value is given twice");
  std::filesystem::remove(folder_ / "cases.csv");
  expect_refusal({"--values", "cases.csv"}, "cases.csv");
  write_text(folder_ / "sweep.csv", "seed\n1\n2\n");  // Never replaced by the table of the sweep.
  expect_refusal({"--values", "sweep.csv", "--force"}, "sweep.csv");
  EXPECT_EQ(text_of(folder_ / "sweep.csv"), "seed\n1\n2\n");
}

TEST_F(SweepValuesCommand, WhatIsWrongWithAValueOfATableHasItsLine) {
  write_scene({});
  const auto refused = [this](const std::string& text, const std::string& message, std::vector<std::string> more = {}) {
    write_text(folder_ / "cases.csv", text);
    more.insert(more.begin(), {"sweep", "scene.scr", "--values", "cases.csv", "--dry-run"});
    const Finished sweep = sarsim(more);
    EXPECT_EQ(sweep.status, 2);
    EXPECT_THAT(sweep.err, HasSubstr(message));
    EXPECT_THAT(sweep.err, Not(HasSubstr("--set ")));
  };
  refused("# none\nSimulation1.bits\n1\n99\n", "cases.csv:4: error: Simulation1.bits=99: '99' is outside");
  refused("Simulation1.processing\nRAW\n\nFOO\n", "cases.csv:4: error: Simulation1.processing=FOO: 'FOO' is none of");
  refused("Simulation1.range_end [m]\n1400\n800\n", "cases.csv:3: error: the slant range window is empty");
  refused("seed\n1\n2\n1\n", "it is on line 2, too");
  refused("seed,Seed\n1,1\n", "cases.csv:1: error: Seed: this field is set by seed already");
  refused("seed,Target1.x\n1,1\n2,1\n1,1\n", "cases.csv:4: error: variations 1 and 3 have the same values", {"--zip"});
  refused("Radar1.bandwidth\n1\n", "cases.csv:2: warning: Radar1.bandwidth=1: a number without a unit", {"--strict"});
}

TEST_F(SweepValuesCommand, TheNamesOfColumnsAreWholeAndTheirUnitsFit) {
  write_scene({});
  const auto refused = [this](const std::string& heading, const std::string& message) {
    write_text(folder_ / "cases.csv", "# a study\n" + heading + "\n1,2\n");
    expect_refusal({"--values", "cases.csv", "--dry-run"}, "cases.csv:2: error: " + message);
  };
  refused("Target1.x [,seed",
          "the bracket of a unit is not closed; found 'Target1.x...', expected a name and its unit");
  refused("Target1.x [m,seed", "the bracket of a unit is not closed");
  refused("Target1.x [m],seed (", "the bracket of a unit is not closed");
  refused("Target1.x [m] km,seed", "something follows a unit's bracket");
  refused(" ,", "the first line of the table names no fields");
  refused("Target1.x,,seed", "a column has no name");
  refused("Target1.x,seed [m]", "seed has no unit; found 'seed [m]', expected seed alone");
  refused("Target1.x,options.seed [Hz]", "options.seed has no unit");
  refused("Target1.x [kg],seed", "Target1.x: the unit does not fit");
  write_text(folder_ / "cases.csv", "Target1.x [km],seed,\"Target1.rcs (dBsm)\"\n1,2,3\n");
  EXPECT_EQ(table({"--values", "cases.csv"}).size(), 1U);
}

TEST_F(SweepValuesCommand, TablesThatAreNoTextAreRefusedAtOnce) {
  write_scene({});
  const auto refused = [this](const std::string& message) {
    expect_refusal({"--values", "big", "--dry-run"}, message);
    const Finished check = sarsim({"check", "scene.scr", "--targets", "big"});
    EXPECT_EQ(check.status, 2);
    EXPECT_THAT(check.err, HasSubstr(message));
  };
  write_text(folder_ / "big", "");
  std::filesystem::resize_file(folder_ / "big", 200'000'000);  // Zeros, which take no room.
  refused("is not text; found 'a byte that is zero'");
  write_text(folder_ / "big", "seed\n" + std::string(1'000'001, '1') + "\n");
  refused("is too long; expected 1000000 bytes at most");
  write_text(folder_ / "big", "seed\n1" + std::string(999'990, ' ') + "\n");
  EXPECT_EQ(table({"--values", "big"}).size(), 1U);
}

// Columns of one name are told of a few times, however many there are.
TEST_F(SweepValuesCommand, ManyColumnsOfOneNameAreAFewMistakes) {
  write_scene({});
  std::string names = "Target1.x";
  std::string values = "1";
  for (int i = 1; i < 20000; ++i) {
    names += ",Target1.x";
    values += ",1";
  }
  write_text(folder_ / "cases.csv", names + "\n" + values + "\n");
  const Finished sweep = sarsim({"sweep", "scene.scr", "--values", "cases.csv", "--dry-run"});
  EXPECT_EQ(sweep.status, 2);
  EXPECT_THAT(sweep.err, HasSubstr("cases.csv:1: error: Target1.x: this field is set by Target1.x already"));
  EXPECT_LE(std::ranges::count(sweep.err, '\n'), 60);
}

TEST_F(SweepValuesCommand, CommandsArePrintedInsteadOfADryRunAlone) {
  write_scene({});
  expect_refusal({"--set", "seed=1", "--commands"}, "add --dry-run");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "sweep.csv"));
}

TEST_F(SweepValuesCommand, RandomValuesAreTheSameForOneSeed) {
  write_scene({});
  const auto rcs = [this](std::vector<std::string> words) {
    words.insert(words.end(), {"--set", "Target1.rcs=normal(1, 0.2)"});
    std::vector<std::string> values;
    for (const auto& row : table(words)) values.push_back(row.at("Target1.rcs [m2]"));
    return values;
  };
  const std::vector<std::string> five = rcs({"--draws", "5"});
  EXPECT_EQ(std::set<std::string>(five.begin(), five.end()).size(), 5U);
  EXPECT_EQ(rcs({"--zip", "--set", "seed=1..5"}), five);
  EXPECT_EQ(rcs({"--draws", "5", "--set", "Target1.x=uniform(0,1km)"}), five);  // One draw for each variation.
  EXPECT_EQ(rcs({"--draws", "5", "--set", "Simulation1.bits=4,8"}).size(), 10U);
  EXPECT_NE(rcs({"--draws", "5", "--seed", "2"}), five);
  rcs({"--draws", "5", "--part", "2/5", "--table", "p"});
  EXPECT_THAT(text_of(folder_ / "p-2-of-5.csv"), HasSubstr("\n2," + five[1] + ","));
  expect_refusal({"--set", "Target1.rcs=normal(1, 0.2)"}, "how often random values are drawn");
  expect_refusal({"--set", "seed=1,2", "--draws", "3"}, "no value is random");
  expect_refusal({"--set", "Target1.rcs=normal(1)", "--draws", "3"}, "expected normal(MEAN, STANDARD DEVIATION)");
}

TEST_F(SweepValuesCommand, FunctionsVaryByTheirDataFiles) {
  write_scene({});
  for (const auto& [name, range_m] : {std::pair{"near.dat", "950"}, std::pair{"far.dat", "1900"}})
    write_text(folder_ / name, std::string("2, 0 1, 20 1\n1, 0 ") + range_m + "\n1, 0 0\n");
  const auto rows = table({"--set", "Car.trajectory=near.dat,far.dat", "--set", "Simulation1.range_end=2500m", "--set",
                           "Radar1.noise_temperature=0", "--set", "Simulation1.lsb=1nV"});
  ASSERT_EQ(rows.size(), 2U);
  // Twice as far is 12 dB less.
  EXPECT_NEAR(std::stod(rows[0].at("maximum_v")) / std::stod(rows[1].at("maximum_v")), 4.0, 0.01);
  EXPECT_EQ(rows[1].at("Car.trajectory"), "far.dat");
  expect_refusal({"--set", "Car.trajectory=none.dat"}, "none.dat");
  write_text(folder_ / "bad.dat", "2, 0 1");
  expect_refusal({"--set", "Car.trajectory=near.dat,bad.dat"}, "bad.dat");
  EXPECT_THAT(sarsim({"sweep", "scene.scr", "--fields"}).out, HasSubstr("Car.trajectory"));
  ASSERT_EQ(sarsim({"run", "scene.scr", "--set", "Car.trajectory=near.dat", "--out", "r"}).status, 0);
  // What is run is never replaced.
  EXPECT_EQ(
      sarsim({"run", "scene.scr", "--set", "Car.trajectory=near.dat", "--set", "Simulation1.file=near.dat", "--force"})
          .status,
      2);
}

TEST_F(SweepValuesCommand, ResumingMakesAgainWhatComesFromAFileThatHasChanged) {
  write_scene({});
  const auto put = [this](const char* name, const char* range_m) {
    write_text(folder_ / name, std::string("2, 0 1, 20 1\n1, 0 ") + range_m + "\n1, 0 0\n");
  };
  put("a.dat", "950");
  put("b.dat", "1000");
  const std::vector<std::string> words{"sweep", "scene.scr", "--set", "Car.trajectory=a.dat,b.dat", "--out", "o"};
  ASSERT_EQ(sarsim(words).status, 0);
  put("b.dat", "1100.5");
  std::vector<std::string> again = words;
  again.insert(again.end(), {"--resume", "--force"});
  EXPECT_THAT(sarsim(again).err, HasSubstr("2 variations, 1 done before, 1 to run"));
}

TEST_F(SweepValuesCommand, CloudsVaryByTheirFiles) {
  SceneText scene;
  write_text(folder_ / "scene.scr", scene.text() + "$CLOUD Earth FILE one.csv 0 0 0 1 0 ISOTROPIC\n");
  write_text(folder_ / "one.csv", "x,y,z\n1000,0,0\n");
  write_text(folder_ / "many.csv", "x,y,z,rcs\n1000,0,0,100\n1001,0,0,100\n");
  const auto rows = table({"--set", "Cloud1.file=one.csv,many.csv", "--set", "Radar1.noise_temperature=0"});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_GT(std::stod(rows[1].at("maximum_v")), 5.0 * std::stod(rows[0].at("maximum_v")));
}

// The commands make the same files.
TEST_F(SweepValuesCommand, CommandsDoWhatTheSweepDoes) {
  SceneText scene;
  scene.geometry = "table.txt";
  write_scene(scene);
  const std::vector<std::string> words{"sweep",    "scene.scr", "--set",   "Target1.rcs=1,4", "--set", "seed=3",
                                       "--format", "npy",       "--pulse", "band-limited",    "--out", "it's out"};
  std::vector<std::string> dry = words;
  dry.insert(dry.end(), {"--dry-run", "--commands"});
  const Finished told = sarsim(dry);
  ASSERT_EQ(told.status, 0) << told.err;
  std::istringstream lines(told.out);
  int commands = 0;
  for (std::string line; std::getline(lines, line); ++commands) {
    ASSERT_TRUE(line.starts_with("sarsim run scene.scr ")) << line;
    const std::string shell =
        "cd " + folder_.string() + " && " + std::string(SARSIM_PROGRAM) + line.substr(6) + " --quiet";
    ASSERT_EQ(std::system(shell.c_str()), 0) << shell;
  }
  EXPECT_EQ(commands, 2);
  // With --resume each of them can be given again, and those that are done are not told.
  dry.push_back("--resume");
  const Finished again = sarsim(dry);
  EXPECT_THAT(again.out, HasSubstr(" --resume\n"));
  const std::vector<std::string> made = entries("it's out");
  EXPECT_THAT(made, ElementsAre("sim_Target1.rcs=1_seed=3.npy", "sim_Target1.rcs=4_seed=3.npy",
                                "table_Target1.rcs=1_seed=3.txt", "table_Target1.rcs=4_seed=3.txt"));
  std::filesystem::rename(folder_ / "it's out", folder_ / "alone");
  ASSERT_EQ(sarsim(words).status, 0);
  for (const std::string& name : made)
    EXPECT_EQ(text_of(folder_ / "it's out" / name), text_of(folder_ / "alone" / name)) << name;
}

}  // namespace sweep_values_test
}  // namespace sarsim::test
