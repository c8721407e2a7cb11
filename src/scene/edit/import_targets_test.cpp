#include "scene/edit/import_targets.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include <fmt/format.h>

namespace sarsim::scene {

namespace import_targets_test {

std::string printed(const TargetImport& import) {
  std::string text;
  for (const core::Problem& problem : import.problems) text += core::to_string(problem) + "\n";
  return text;
}

void expect_targets(std::string_view text, const std::vector<Target>& expected) {
  const TargetImport import = import_targets(text, "Ship");
  EXPECT_EQ(printed(import), "") << text;
  EXPECT_EQ(import.targets, expected) << text;
}

Target target(double x, double y, double z, double rcs_m2 = 1.0) {
  Target made;
  made.platform = "Ship";
  made.position_m = {x, y, z};
  made.rcs_m2 = rcs_m2;
  return made;
}

TEST(ImportTargets, EveryFormOfTableGivesTheSameTargets) {
  const std::vector<Target> expected{target(1.0, 2.0, 3.0, 10.0), target(-4.5, 0.0, 1e3, 0.25)};
  expect_targets("1\t2\t3\t10\n-4.5\t0\t1e3\t0.25\n", expected);
  expect_targets("1,2,3,10\r\n-4.5,0,1e3,0.25\r\n", expected);
  expect_targets("1;2;3;10\n-4.5;0;1e3;0.25", expected);
  expect_targets("  1   2 3 10\n-4.5 0 1e3 0.25\n", expected);
  expect_targets("1, 2, 3, 10\r-4.5, 0, 1e3, 0.25", expected);
  expect_targets("\xEF\xBB\xBF\"1\",\"2\",\"3\",\"10\"\n-4.5,0,1e3,0.25,\n", expected);
}

TEST(ImportTargets, TheCrossSectionIsOneSquareMetreWhereNoneIsGiven) {
  expect_targets("1 2 3\n4,5,6,\n", {target(1, 2, 3), target(4, 5, 6)});
}

TEST(ImportTargets, EmptyLinesAndCommentsAreSkipped) {
  expect_targets("# survey\n\n! of 2024\n1 2 3\n   \n", {target(1, 2, 3)});
}

TEST(ImportTargets, NamesGiveTheOrderAndTheUnitsOfTheColumns) {
  expect_targets("z,x,y\n3,1,2\n", {target(1, 2, 3)});
  expect_targets("id\tRCS [dBsm]\tX [km]\tY (mm)\tZ\n7\t20\t1.5\t2\t3\n", {target(1500, 0.002, 3, 100.0)});
  expect_targets("x [m] y [m] z [km]\n1 2 3\n", {target(1, 2, 3000)});
}

TEST(ImportTargets, CellsMayHaveUnitsOfTheirOwn) {
  expect_targets("1 km, 20 cm, 3\n", {target(1000, 0.2, 3)});
  expect_targets("x [km],y [km],z [km]\n1,2 m,3\n", {target(1000, 2, 3000)});
}

TEST(ImportTargets, ABadLineIsAProblemWithItsNumberAndTheOthersAreTaken) {
  const TargetImport import = import_targets("1 2 3\n4 five 6\n7 8\n9 10 11\n", "Ship");
  EXPECT_EQ(import.targets, (std::vector<Target>{target(1, 2, 3), target(9, 10, 11)}));
  ASSERT_EQ(import.problems.size(), 2U);
  EXPECT_EQ(import.problems[0].place.line, 2U);
  EXPECT_EQ(import.problems[0].found, "five");
  EXPECT_NE(import.problems[0].message.find("y: 'five' is not a valid length"), std::string::npos)
      << import.problems[0].message;
  EXPECT_EQ(import.problems[1].place.line, 3U);
  EXPECT_EQ(import.problems[1].message, "z is missing");
  EXPECT_TRUE(core::has_errors(import.problems));
}

TEST(ImportTargets, ADecimalCommaIsExplained) {
  const TargetImport import = import_targets("1,5;2;3\n", "Ship");
  EXPECT_TRUE(import.targets.empty());
  EXPECT_NE(printed(import).find("the decimal mark is the point: 1.5"), std::string::npos) << printed(import);
}

TEST(ImportTargets, NamesThatLeaveOutACoordinateOrRepeatOneAreRefused) {
  EXPECT_NE(printed(import_targets("x,y,rcs\n1,2,3\n", "Ship")).find("do not include z"), std::string::npos);
  EXPECT_NE(printed(import_targets("x,y,z,x\n1,2,3,4\n", "Ship")).find("two columns are named x"), std::string::npos);
  const TargetImport import = import_targets("x [kg],y,z\n1,2,3\n", "Ship");
  EXPECT_TRUE(import.targets.empty());
  EXPECT_NE(printed(import).find("the unit of column x is not known; found 'kg'"), std::string::npos)
      << printed(import);
}

TEST(ImportTargets, ALineOfOtherWordsIsABadLine) {
  const TargetImport import = import_targets("hello world out\n1 2 3\n", "Ship");
  EXPECT_EQ(import.targets.size(), 1U);
  EXPECT_EQ(import.problems.size(), 1U);
}

TEST(ImportTargets, NumbersTooLargeToComputeWithAreRefused) {
  EXPECT_NE(printed(import_targets("1e19 0 0\n", "Ship")).find("too large"), std::string::npos);
  EXPECT_NE(printed(import_targets("nan 0 0\n", "Ship")).find("is not a valid length"), std::string::npos);
}

TEST(ImportTargets, MoreColumnsThanExpectedAreOneWarning) {
  const TargetImport import = import_targets("1 2 3 4 5\n1 2 3 4 5\n", "Ship");
  EXPECT_EQ(import.targets.size(), 2U);
  ASSERT_EQ(import.problems.size(), 1U);
  EXPECT_EQ(import.problems[0].severity, core::Severity::warning);
  EXPECT_EQ(import.problems[0].count, 2U);
}

TEST(ImportTargets, NothingGivesNothing) {
  expect_targets("", {});
  expect_targets("\n\n# only words\n", {});
  expect_targets("x,y,z\n", {});
}

TEST(ImportTargets, ATableThatIsWrittenIsReadBackExactly) {
  const std::vector<Target> targets{target(1.0 / 3.0, -1e-30, 1e17, 0.1), target(0, 0, 0, 0)};
  expect_targets(targets_text(targets), targets);
}

TEST(ImportTargets, ManyBadLinesGiveAFewProblemsThatSayHowManyThereAre) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "a b c 1\n";
  const TargetImport import = import_targets(text, "Ship");
  EXPECT_EQ(import.problems.size(), 100U);
  EXPECT_EQ(import.problems.back().hint, "4900 more lines could not be read.");
}

TEST(ImportTargets, TenThousandLinesTakeNoTimeToSpeakOf) {
  std::string text = "x [km]\ty\tz\trcs [dBsm]\n";
  for (int i = 0; i < 10000; ++i) text += fmt::format("{}.5\t{}\t12.25\t-3\n", i, 2 * i);
  const auto start = std::chrono::steady_clock::now();
  const TargetImport import = import_targets(text, "Ship");
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(import.targets.size(), 10000U);
  EXPECT_TRUE(import.problems.empty());
  EXPECT_LT(taken.count(), 1.0);  // some 30 ms; the bound is for a loaded machine
  RecordProperty("microseconds", static_cast<int>(taken.count() * 1e6));
}

}  // namespace import_targets_test

}  // namespace sarsim::scene
