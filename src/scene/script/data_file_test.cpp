#include "scene/script/data_file.hpp"

#include <gtest/gtest.h>

#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace data_file_test {

const FunctionBlock& trajectory = function_blocks::trajectory;
const FunctionBlock& carriers = function_blocks::carrier_list;

constexpr std::string_view three_functions = "! path\n2\n-1 -100, 1 100\n1\n0 10000\n1\n0 2000\n";

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

core::Problem only_problem(const core::Problems& problems) {
  EXPECT_EQ(problems.size(), 1U);
  for (std::size_t i = 1; i < problems.size(); ++i) ADD_FAILURE() << core::to_string(problems[i]);
  return problems.empty() ? core::Problem{} : problems[0];
}

core::Problem data_problem(std::string_view text, const FunctionBlock& block = trajectory) {
  return only_problem(read_data_file(text, "p.dat", block).problems);
}

// A script whose platform takes its path from the given block text, read with one data file "p.dat".
core::Problems script_problems(const std::string& block, const std::string& data) {
  const std::string script = "$PLATFORM P TRAJ\n" + block + " NOT CONST 0 0 0 0 0 0 STD 0 0 0 STD 0 0 0";
  return read_script(script, "t.scr",
                     [&](const std::string& name) {
                       if (name == "p.dat") return DataFileText{"dir/p.dat", data, {}};
                       return DataFileText{{}, {}, "data file not found; looked for " + name};
                     })
      .problems;
}

TEST(DataFile, HoldsCountAndPointsOfEachFunction) {
  const DataFileReading reading = read_data_file(three_functions, "p.dat", trajectory);
  EXPECT_TRUE(reading.problems.empty());
  ASSERT_EQ(reading.functions.size(), 3U);
  EXPECT_EQ(reading.functions[0], (std::vector<core::Knot>{{-1, -100}, {1, 100}}));
  EXPECT_EQ(reading.functions[2], (std::vector<core::Knot>{{0, 2000}}));
}

TEST(DataFile, IsScaledToTheUnitsOfTheScene) {
  const DataFileReading reading = read_data_file("2 0 5.3 0 0.141", "p.dat", carriers);
  EXPECT_TRUE(reading.problems.empty());
  EXPECT_EQ(reading.functions[0], (std::vector<core::Knot>{{0, 5.3e9}, {0, 0.141e9}}));
}

TEST(DataFile, IsReadBackBitForBitForEveryBlock) {
  for (const FunctionBlock* block : function_blocks::all) {
    std::vector<core::SampledFunction> functions(block->count);
    double x = -1.0 / 3.0;
    for (core::SampledFunction& function : functions)
      for (int i = 0; i < 50; ++i)
        function.knots.push_back({x += 1.0 / 7.0, std::ldexp(block->x_ignored ? std::abs(x) : x, 2 * i - 70)});
    const std::string text = write_data_file(functions, *block);
    const DataFileReading reading = read_data_file(text, "p.dat", *block);
    EXPECT_TRUE(reading.problems.empty()) << text;
    for (std::size_t i = 0; i < block->count; ++i) EXPECT_EQ(reading.functions[i], functions[i].knots);
    EXPECT_TRUE(holds(text, block->x.name)) << text;
    EXPECT_TRUE(holds(text, block->y[0].name)) << text;
  }
}

TEST(DataFile, ReportsABadNumberWithItsPlaceAxisAndUnit) {
  const core::Problem problem = data_problem("2\n-1 -100, 1 10x0\n1\n0 10000\n1\n0 2000\n");
  EXPECT_EQ(problem.place, (core::Place{"p.dat", 2, 12}));
  EXPECT_EQ(problem.found, "10x0");
  EXPECT_EQ(problem.expected, "a number in m");
  EXPECT_TRUE(holds(problem.message, "position x"));
}

TEST(DataFile, ReportsACountThatIsNone) {
  EXPECT_TRUE(holds(data_problem("2.5 1 2").message, "not a whole number"));
  EXPECT_TRUE(holds(data_problem("x 1 2").message, "not a number"));
  EXPECT_TRUE(holds(data_problem("0").message, "too small"));
  EXPECT_TRUE(holds(data_problem("-3 1 2").message, "too small"));
  EXPECT_TRUE(holds(data_problem("99999999999999999999").message, "number of points"));
}

TEST(DataFile, ReportsTooFewNumbersAndTooFewFunctions) {
  const core::Problem few = data_problem("3 0 1 1 2");
  EXPECT_TRUE(holds(few.message, "3 points were announced")) << few.message;
  EXPECT_TRUE(holds(few.message, "after 2"));
  EXPECT_TRUE(holds(data_problem("1 0 1").message, "number of points for position y"));
}

TEST(DataFile, ReportsEmptinessScriptsAndBytes) {
  EXPECT_TRUE(holds(data_problem("").message, "holds no numbers"));
  EXPECT_TRUE(holds(data_problem("! only words\n").message, "holds no numbers"));
  EXPECT_TRUE(holds(data_problem("! x\n$PLATFORM P").message, "is a script"));
  EXPECT_TRUE(holds(data_problem("! x\n$PLATFORM P\n0 0 0 0\n1 0 0 0\n").message, "is a script"));
  EXPECT_TRUE(holds(data_problem(std::string_view("1 0\0", 4)).message, "not a text file"));
}

TEST(DataFile, DemandsThatXAscends) {
  const core::Problem problem = data_problem("4 0 0 2 0 1 0 0.5 0\n1 0 0\n1 0 0");
  EXPECT_EQ(problem.place, (core::Place{"p.dat", 1, 11}));
  EXPECT_EQ(problem.expected, "more than 2, as of the point before");
  EXPECT_TRUE(holds(problem.message, "point 3 of "));
  EXPECT_TRUE(holds(data_problem("2 1 0 1 0 1 0 0 1 0 0").message, "must ascend"));
}

TEST(DataFile, IgnoresXInLists) { EXPECT_TRUE(read_data_file("3 0 1 0 2 -5 3", "p.dat", carriers).problems.empty()); }

TEST(DataFile, DemandsListsAboveZero) {
  for (const char* text : {"2 0 1 0 0", "2 0 1 0 -5"}) {
    const core::Problems problems = read_data_file(text, "p.dat", carriers).problems;
    ASSERT_EQ(problems.size(), 1U) << text;
    EXPECT_EQ(problems[0].place.column, 9U) << text;
  }
}

TEST(DataFile, SaysOnlyThatPointsAreMissingWhereTheCountIsWrong) {
  const core::Problems problems = read_data_file("9 0 0 1 1 1 0 1 1 1 0", "p.dat", trajectory).problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(holds(problems[0].message, "9 points were announced"));
}

TEST(DataFile, WarnsOfNumbersBehindTheLastFunction) {
  const core::Problem problem = data_problem("1 0 1 7", carriers);
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_EQ(problem.found, "7");
}

TEST(DataFile, IsNotBelievedAHugeCount) {
  const DataFileReading reading = read_data_file("9000000000000000000 0 1", "p.dat", carriers);
  EXPECT_TRUE(core::has_errors(reading.problems));
  EXPECT_LT(reading.functions[0].capacity(), 100U);
}

TEST(DataFile, GivesAFewProblemsOnly) {
  std::string text = "5000";
  for (int i = 0; i < 10000; ++i) text += " x";
  EXPECT_LE(read_data_file(text, "p.dat", carriers).problems.size(), 21U);
}

TEST(FunctionBlock, TakesItsPointsFromTheFileItNames) {
  EXPECT_TRUE(script_problems("LIN LIN LIN FILE p.dat", std::string(three_functions)).empty());
  const ScriptReading reading = read_script("$PLATFORM P TRAJ CUB LIN MFI FILE \"p.dat\" NOT 0 0 0 STD 0 0 0 STD 0 0 0",
                                            "t.scr", [](const std::string&) {
                                              return DataFileText{"p.dat", std::string(three_functions), {}};
                                            });
  EXPECT_TRUE(reading.problems.empty());
  const UserFunction<3>& path = reading.scene.platforms.at(0).trajectory_m;
  EXPECT_EQ(path.file, "p.dat");
  EXPECT_EQ(path.part[0].method, core::Interpolation::cubic);
  EXPECT_EQ(path.part[2].method, core::Interpolation::low_pass);
  EXPECT_EQ(path.part[0].knots.size(), 2U);
}

TEST(FunctionBlock, PlacesProblemsOfADataFileAtItsNameAndSaysWhereTheyAre) {
  const core::Problem problem = only_problem(script_problems("LIN LIN LIN FILE p.dat", "1 0 1\n1 0 q\n1 0 1"));
  EXPECT_EQ(problem.place, (core::Place{"t.scr", 2, 18}));
  EXPECT_TRUE(holds(problem.message, "dir/p.dat:2:5: position y")) << problem.message;
  EXPECT_EQ(problem.found, "q");
  EXPECT_EQ(problem.subject, (core::Subject{"platform", 0, "trajectory_m"}));
}

TEST(FunctionBlock, SaysWhereAMissingDataFileWasLookedFor) {
  const core::Problem problem = only_problem(script_problems("LIN LIN LIN FILE q.dat", ""));
  EXPECT_EQ(problem.place, (core::Place{"t.scr", 2, 18}));
  EXPECT_TRUE(holds(problem.message, "looked for q.dat"));
}

TEST(FunctionBlock, NeedsALoaderForFiles) {
  EXPECT_TRUE(
      holds(only_problem(read_script("$TARGET E 0 0 0 0 0 0 1 0 DIR 1 2 3 4 OTH LIN FILE x", "", {}).problems).message,
            "not available"));
}

TEST(FunctionBlock, ToleratesAFunctionWithoutPointsInTheScriptWithAWarning) {
  const core::Problem problem = only_problem(script_problems("LIN LIN LIN INLINE 0 1 0 1 1 0 1", ""));
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_TRUE(holds(problem.message, "no points"));
}

TEST(FunctionBlock, ReportsACountThatIsTooLargeOnce) {
  const core::Problem problem = only_problem(script_problems("LIN LIN LIN INLINE 1 0 1 1 0 1 2 0 1", ""));
  EXPECT_TRUE(holds(problem.message, "2 points were announced for position z")) << problem.message;
  EXPECT_EQ(problem.found, "NOT");
}

TEST(FunctionBlock, ReportsACountThatIsTooSmallOnce) {
  const core::Problem problem = only_problem(script_problems("LIN LIN LIN INLINE 1 0 1 1 0 1 1 0 1 5 6", ""));
  EXPECT_EQ(problem.found, "5");
  EXPECT_TRUE(holds(problem.expected, "NOT_ALIGNED"));
}

TEST(FunctionBlock, ReportsAnUnknownInterpolationOrSource) {
  EXPECT_EQ(only_problem(script_problems("LIN SPLINE LIN INLINE 1 0 1 1 0 1 1 0 1", "")).expected,
            "CUBIC, MFILTER or LINEAR");
  EXPECT_EQ(only_problem(script_problems("LIN LIN LIN ONLINE 1 0 1 1 0 1 1 0 1", "")).hint, "did you mean INLINE?");
}

TEST(FunctionBlock, GoesOnAfterABadPoint) {
  const core::Problems problems = script_problems("LIN LIN LIN INLINE 1 0 a 1 b 1 1 0 c", "");
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[1].found, "b");
}

TEST(FunctionBlock, ReadsMoreInlinePointsThanTheOldLimit) {
  std::string block = "LIN LIN LIN INLINE 20000";
  for (int i = 0; i < 20000; ++i) block += " " + std::to_string(i) + " 0\n";
  EXPECT_TRUE(script_problems(block + " 1 0 1 1 0 1", "").empty());
}

}  // namespace data_file_test
}  // namespace sarsim::scene
