#include "scene/edit/import_targets.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "scene/model/world_frame.hpp"
#include "support/processor_time.hpp"

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
  for (const Target& target : import.targets) EXPECT_EQ(&*target.platform, &*import.targets.front().platform);
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

TEST(ImportTargets, NamesWithAUnitAreNotContradicted) {
  expect_targets("x_m [m],y,z,rcs_dbsm [dBsm]\n1,2,3,10\n", {target(1, 2, 3, 10.0)});
  expect_targets("x,y,z,rcs_m2 [m^2]\n1,2,3,10\n", {target(1, 2, 3, 10.0)});
  for (const char* const text :
       {"x,y,z,rcs_dbsm [m2]\n1,2,3,10\n", "x,y,z,rcs_m2 [dBsm]\n1,2,3,10\n", "x_m [km],y,z,rcs\n1,2,3,10\n"}) {
    const TargetImport import = import_targets(text, "Ship");
    EXPECT_TRUE(import.targets.empty()) << text;
    EXPECT_NE(printed(import).find("contradict each other"), std::string::npos) << printed(import);
  }
}

TEST(ImportTargets, QuotesHoldANameAndItsUnitTogether) {
  expect_targets("\"x [km]\" \"y [m]\" \"z\"\n1 2 3\n", {target(1000, 2, 3)});
  expect_targets("\"x [km]\",\"y, north\",y,z\n1,9,2,3\n", {target(1000, 2, 3)});
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

// The anchor of the tests of latitudes.
World world_on_earth() {
  World world;
  world.frame = World::Frame::earth;
  world.latitude = core::Angle::from_deg(-16.2);
  world.longitude = core::Angle::from_deg(-76.2);
  world.height_m = 50.0;
  return world;
}

TEST(ImportTargets, LatitudesLieInTheWorldOfTheEarth) {
  const World world = world_on_earth();
  const auto earth = earth_of(world);
  for (const char* text : {"latitude,longitude,height,rcs\n-16.2,-76.2,50,4\n-16.25,-76,0,9\n",
                           "rcs;lon_deg;height_m;Lat_deg;name\n4;-76.2;50;-16.2;a\n9;-76;0;-16.25;b\n",
                           "latitude [deg]\tlongitude [deg]\theight [km]\trcs\n-16.2\t-76.2\t0.05\t4\n"
                           "-16.25 deg\t-76\t0\t9\n"}) {
    const TargetImport import = import_targets(text, "Earth", world);
    EXPECT_EQ(printed(import), "") << text;
    ASSERT_EQ(import.targets.size(), 2U) << text;
    EXPECT_EQ(import.targets[0].position_m, core::Vec3{}) << text;
    EXPECT_EQ(import.targets[0].rcs_m2, 4.0);
    EXPECT_EQ(import.targets[1].position_m,
              earth->world_of({core::rad_per_deg * -16.25, core::rad_per_deg * -76.0, 0.0}));
  }
}

TEST(ImportTargets, LatitudesNeedAnEarthAndItsPlatform) {
  const std::string table = "latitude,longitude,height\n-16.2,-76.2,0\n";
  EXPECT_NE(printed(import_targets(table, "Earth")).find("the world is flat and has no latitudes"), std::string::npos);
  EXPECT_NE(printed(import_targets(table, "Ship", world_on_earth()))
                .find("places on the Earth cannot be those of a platform; found 'Ship'"),
            std::string::npos)
      << printed(import_targets(table, "Ship", world_on_earth()));
  EXPECT_NE(
      printed(import_targets("latitude,longitude\n1,2\n", "Earth", world_on_earth())).find("do not include height"),
      std::string::npos);
  EXPECT_NE(printed(import_targets("latitude,longitude,height\n90.5,2,0\n", "Earth", world_on_earth()))
                .find("latitude is beyond a pole"),
            std::string::npos);
}

TEST(ImportTargets, TablesOfCoordinatesMayHaveOtherLatitudes) {
  const TargetImport import = import_targets("latitude,x,y,z\n50,1,2,3\n", "Ship");
  EXPECT_EQ(printed(import), "");
  EXPECT_EQ(import.targets, std::vector<Target>{target(1, 2, 3)});
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
  const sarsim::test::ProcessorTime time;
  const TargetImport import = import_targets(text, "Ship");
  const double taken_s = time.seconds();
  EXPECT_EQ(import.targets.size(), 10000U);
  EXPECT_TRUE(import.problems.empty());
  EXPECT_LT(taken_s, 1.0);  // some 30 ms
  RecordProperty("microseconds", static_cast<int>(taken_s * 1e6));
}

TEST(ImportTargets, TellsHowFarItIsAndStops) {
  std::string text = "x y z\n";
  for (int i = 0; i < 10000; ++i) text += "1 2 3\n";
  std::vector<core::Progress> told;
  const TargetImport import =
      import_targets(text, "Ship", {}, nullptr, [&](const core::Progress& p) { told.push_back(p); });
  EXPECT_EQ(import.targets.size(), 10000U);
  ASSERT_GT(told.size(), 5U);
  EXPECT_EQ(told.front().done, 0U);
  for (std::size_t i = 1; i < told.size(); ++i) EXPECT_GT(told[i].done, told[i - 1].done);
  EXPECT_LT(told.back().done, told.back().total);
  EXPECT_EQ(told.back().total, text.size());
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW(static_cast<void>(import_targets(text, "Ship", {}, &stop)), core::Interrupted);
}

}  // namespace import_targets_test

}  // namespace sarsim::scene
