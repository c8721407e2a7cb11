// What the reader says about mistakes: where, what was found, what was expected, and nothing more than once.

#include <gtest/gtest.h>

#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace reader_problem_test {

constexpr std::string_view radar_start = "$RADAR R P ";
constexpr std::string_view radar_end = " ISO SAM FIX 0 0 RECT NO_STC";

core::Problems problems_of(std::string_view text) { return read_script(text, "t.scr", {}).problems; }

// The only problem of a text.
core::Problem only_problem(std::string_view text) {
  const core::Problems problems = problems_of(text);
  EXPECT_EQ(problems.size(), 1U) << text;
  for (std::size_t i = 1; i < problems.size(); ++i) ADD_FAILURE() << core::to_string(problems[i]);
  return problems.empty() ? core::Problem{} : problems[0];
}

core::Problem radar_problem(std::string_view middle) {
  return only_problem(std::string(radar_start) + std::string(middle) + std::string(radar_end));
}

core::Problem target_problem(std::string_view values) { return only_problem("$TARGET E " + std::string(values)); }

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

TEST(ReaderProblem, NamesPlaceTextFieldUnitAndRangeOfABadNumber) {
  const core::Problem problem =
      only_problem("\n$RADAR R P CHIRP 0.1\n  12abc RECT CON 1 SIN 1 1 0 0 ISO SAM FIX 0 0 RECT NO_STC");
  EXPECT_EQ(core::to_string(problem),
            "t.scr:3:3: error: pulse width is not a number; found '12abc', expected a number in ns, zero or more\n"
            "    the unit is fixed (ns): write 12");
  EXPECT_EQ(problem.subject, (core::Subject{"radar", 0, "pulse_width_s"}));
}

TEST(ReaderProblem, NeverTakesATextForZero) {
  for (const char* text : {"12abc", "nan", "inf", "-inf", "abc", "1e999", "-1e999", "0x10", "1.2.3", "--1", "1e", ".",
                           "+", "1_000", "5GHz"}) {
    const core::Problem problem = target_problem(std::string(text) + " 0 0 0 0 0 1 0 ISO");
    EXPECT_EQ(problem.severity, core::Severity::error) << text;
    EXPECT_EQ(problem.found, text);
    EXPECT_TRUE(holds(problem.message, "position x")) << problem.message;
    EXPECT_EQ(problem.place, (core::Place{"t.scr", 1, 11}));
  }
}

// Editors show a new line there, and the language has none.
TEST(ReaderProblem, WarnsWhereACommentHidesCommands) {
  for (const char* mark : {"\xE2\x80\xA8", "\xE2\x80\xA9", "\r"}) {
    const core::Problem problem =
        only_problem("$TARGET E 0 0 0 0 0 0 1 0 ISO\n! a comment" + std::string(mark) + "$TARGET E 1 0 0\n");
    EXPECT_EQ(problem.severity, core::Severity::warning);
    EXPECT_TRUE(holds(problem.message, "hides commands")) << problem.message;
    EXPECT_EQ(problem.place, (core::Place{"t.scr", 2, 12}));
  }
  for (const char* fine : {"! a comment \xE2\x80\xA8 goes on\n", "! a comment\r\n$TARGET E 0 0 0 0 0 0 1 0 ISO\r\n",
                           "! a comment\r$TARGET E 0 0 0 0 0 0 1 0 ISO\r", "! a\n\r$TARGET E 0 0 0 0 0 0 1 0 ISO\n"})
    for (const core::Problem& problem : problems_of(fine))
      EXPECT_FALSE(holds(problem.message, "hides commands")) << fine;
}

TEST(ReaderProblem, SaysThatANumberIsTooLarge) {
  EXPECT_TRUE(holds(target_problem("1e999 0 0 0 0 0 1 0 ISO").message, "too large"));
}

TEST(ReaderProblem, WarnsOfANumberTooSmallForADouble) {
  const core::Problem problem = target_problem("1e-400 0 0 0 0 0 1 0 ISO");
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_TRUE(holds(problem.message, "too small"));
}

TEST(ReaderProblem, HintsAtTheFixedUnit) {
  EXPECT_TRUE(holds(radar_problem("MONO 1 RECT CON 1 SINGLE 5GHz 1 0 0").hint, "write 5"));
}

TEST(ReaderProblem, RejectsWhatIsOutsideTheLimitsOfTheLanguage) {
  for (const char* middle :
       {"MONO -1 RECT CON 1 SIN 1 1 0 0", "MONO 1 LIN -1 0 CON 1 SIN 1 1 0 0", "MONO 1 LIN 0 -1 CON 1 SIN 1 1 0 0",
        "MONO 1 RECT CON 0.000009 SIN 1 1 0 0", "MONO 1 RECT CON 1 SIN -1 1 0 0", "MONO 1 RECT CON 1 SIN 1 -1 0 0",
        "MONO 1 RECT CON 1 SIN 1 1 -1 0", "MONO 1 RECT CON 1 SIN 1 1 0 -1", "MONO 1 RECT CON 1 SIN 1 1 -1 0 0 0",
        "MONO 1 RECT CON 1 SIN 1 1 0 -1 0 0", "BAR 7 1 RECT CON 1 SIN 1 1 0 0", "BAR -1 1 RECT CON 1 SIN 1 1 0 0",
        "MONO 1 RECT CON 1 STE -1 1 1 1 1 0 0", "MONO 1 RECT CON 1 STE 1 -1 1 1 1 0 0",
        "MONO 1 RECT CON 1 STE 1 1 0 1 1 0 0", "MONO 1 RECT CON 1 STE 1 1 1001 1 1 0 0",
        "MONO 1 RECT CON 1 STE 1 1 1 0 1 0 0", "MONO 1 RECT CON 1 STE 1 1 1 101 1 0 0"}) {
    const core::Problem problem = radar_problem(middle);
    EXPECT_EQ(problem.severity, core::Severity::error) << middle;
    EXPECT_TRUE(holds(problem.message, "out of range")) << problem.message;
    EXPECT_FALSE(problem.expected.empty());
  }
}

TEST(ReaderProblem, RejectsRecordingsOutsideTheLimitsOfTheLanguage) {
  for (const char* text : {"0 1 0 ASC RAW f BEG", "65 1 0 ASC RAW f BEG", "8 0 0 ASC RAW f BEG", "8 -1 0 ASC RAW f BEG",
                           "8 1 0 ASC RAW f BEG 0.9", "8 1 0 ASC RAW f BEG 101", "8 1 0 ASC RAW f BEG 1 -1",
                           "8 1 0 ASC RAW f BEG 1 101"}) {
    const core::Problem problem = only_problem("$SIM R 1 2 3 4 " + std::string(text));
    EXPECT_TRUE(holds(problem.message, "out of range")) << text << problem.message;
  }
  EXPECT_TRUE(holds(only_problem("$GEO R 1 2 3 4 SPA 256 f").message, "out of range"));
  EXPECT_TRUE(holds(only_problem("$GEO R 1 2 3 4 SPA -1 f").message, "out of range"));
  EXPECT_TRUE(holds(only_problem("$OPT TOL 0").message, "out of range"));
}

TEST(ReaderProblem, StatesLimitsInTheUnitsOfTheScript) {
  EXPECT_EQ(only_problem("$SIM R 1 2 3 4 8 0 0 ASC RAW f BEG").expected, "a number in GHz, above zero");
}

TEST(ReaderProblem, AcceptsTheEndsOfTheLimits) {
  EXPECT_TRUE(
      problems_of("$SIM R 1 2 3 4 1 1e-9 -1 ASC RAW f BEG 1 100\n$SIM R 1 2 3 4 64 1 0 ASC RAW f BEG 100 1").empty());
  EXPECT_TRUE(
      problems_of("$RADAR R P BAR 0 0 LIN 0 0 CON 1e-5 STE 0 0 1000 100 0 0 0 SIN 7000 -3 SAM ROT 99999 0 HAN 0 "
                  "NO_STC")
          .empty());
}

TEST(ReaderProblem, RejectsAFractionForAWholeNumber) {
  const core::Problem problem = only_problem("$SIM R 1 2 3 4 8.5 1 0 ASC RAW f BEG");
  EXPECT_TRUE(holds(problem.message, "not a whole number"));
  EXPECT_EQ(problem.expected, "a whole number, 1 to 64");
  EXPECT_TRUE(holds(only_problem("$SIM R 1 2 3 4 99999999999999999999 1 0 ASC RAW f BEG").message, "bits"));
  EXPECT_TRUE(holds(only_problem("$OPT SEED -1").message, "seed"));
  EXPECT_TRUE(holds(only_problem("$OPT SEED 18446744073709551616").message, "seed"));
}

TEST(ReaderProblem, SuggestsTheNearestKeyword) {
  const core::Problem problem = only_problem("$RADAR R P MONO 1 RCET CON 1 SIN 1 1 0 0 ISO SAM FIX 0 0 RECT NO_STC");
  EXPECT_EQ(problem.found, "RCET");
  EXPECT_EQ(problem.expected, "RECT, LINEAR or OTHER");
  EXPECT_EQ(problem.hint, "did you mean RECT?");
  EXPECT_EQ(problem.place, (core::Place{"t.scr", 1, 19}));
}

TEST(ReaderProblem, SuggestsTheNearestCommand) {
  const core::Problem problem = only_problem("$RADER a b c");
  EXPECT_TRUE(holds(problem.message, "unknown command"));
  EXPECT_EQ(problem.found, "$RADER");
  EXPECT_EQ(problem.hint, "did you mean $RADAR?");
  EXPECT_TRUE(only_problem("$QWERTZ 1 2").hint.empty());
}

TEST(ReaderProblem, ReportsAllBadNumbersOfAnObject) {
  const core::Problems problems = problems_of("$TARGET E x1 0 y1 0 0 0 z1 0 ISO");
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].found, "x1");
  EXPECT_EQ(problems[1].found, "y1");
  EXPECT_EQ(problems[2].subject.field, "rcs_m2");
}

TEST(ReaderProblem, ReportsMissingNumbersOnce) {
  const core::Problem problem = target_problem("0 0 0 0 0 ISOTROPIC");
  EXPECT_TRUE(holds(problem.message, "is missing"));
  EXPECT_EQ(problem.found, "ISOTROPIC");
  EXPECT_TRUE(holds(radar_problem("CHIRP 0.1 RECT CON 1 SIN 1 1 0 0").message, "pulse width is missing"));
  EXPECT_TRUE(holds(radar_problem("CHIRP 0.1 HAMMING CON 1 SIN 1 1 0 0").message, "pulse width is missing"));
}

TEST(ReaderProblem, ReportsAnEarlyEndOnce) {
  const core::Problem problem = only_problem("$TARGET E 0 0 0\n$TARGET E 0 0 0 0 0 0 1 0 ISO");
  EXPECT_TRUE(holds(problem.message, "$TARGET ends before the standard deviation of position x")) << problem.message;
  EXPECT_EQ(problem.place, (core::Place{"t.scr", 1, 15}));
  EXPECT_TRUE(holds(only_problem("$RADAR").message, "ends before the name of the radar"));
  EXPECT_TRUE(holds(only_problem("$RADAR R").message, "ends before the name of its platform"));
  EXPECT_TRUE(holds(only_problem("$TARGET E 0 0 0 0 0 0 1 0").expected, "ISOTROPIC or DIRECTIONAL"));
}

TEST(ReaderProblem, ReportsAWrongNumberOfValuesBehindThePowerAndGoesOn) {
  const core::Problem problem = radar_problem("MONO 1 RECT CON 1 SIN 1 1 0 0 0");
  EXPECT_TRUE(holds(problem.message, "3 values"));
  const core::Problems two = problems_of("$RADAR R P MONO 1 RECT CON 1 SIN 1 1 0 0 0 0 0 ISO SAM FIX x 0 RECT NO_STC");
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[1].subject.field, "beam_elevation");
}

TEST(ReaderProblem, KeepsAFaultyObjectUnderItsName) {
  const ScriptReading reading = read_script("$PLATFORM Plane FLYING 1 2 3\n$RADAR Big Plane FOO\n$TARGET", "t.scr", {});
  EXPECT_EQ(reading.problems.size(), 3U);
  ASSERT_EQ(reading.scene.platforms.size(), 1U);
  EXPECT_EQ(reading.scene.platforms[0].name, "Plane");
  ASSERT_EQ(reading.scene.radars.size(), 1U);
  EXPECT_EQ(reading.scene.radars[0].name, "Big");
  EXPECT_TRUE(reading.scene.targets.empty());
}

TEST(ReaderProblem, GoesOnWithTheNextCommandAfterAnUnknownKeyword) {
  const ScriptReading reading =
      read_script("$TARGET E 0 0 0 0 0 0 1 0 FOO 1 2 3 4 5\n$TARGET E 0 0 0 0 0 0 1 0 ISO", "", {});
  EXPECT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.scene.targets.size(), 2U);
}

TEST(ReaderProblem, WarnsOfValuesThatNobodyAskedFor) {
  const core::Problem problem = target_problem("0 0 0 0 0 0 1 0 ISO 7 8 9");
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_EQ(problem.found, "7");
  EXPECT_TRUE(holds(problem.hint, "decimal mark"));
}

TEST(ReaderProblem, WarnsOfTextBeforeTheFirstCommand) {
  const core::Problem problem = only_problem("hello world $TARGET E 0 0 0 0 0 0 1 0 ISO");
  EXPECT_EQ(problem.severity, core::Severity::warning);
  EXPECT_EQ(problem.place, (core::Place{"t.scr", 1, 1}));
}

TEST(ReaderProblem, WarnsOfADollarWithoutACommand) {
  EXPECT_EQ(only_problem("$TARGET E 0 0 0 0 0 0 1 0 ISO $\n").severity, core::Severity::warning);
}

TEST(ReaderProblem, WarnsOfACommentThatTouchesAValue) {
  const ScriptReading reading = read_script("$TARGET E 0 0 0 0 0 0 12!note\n0 ISO", "t.scr", {});
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.problems[0].severity, core::Severity::warning);
  EXPECT_EQ(reading.problems[0].place, (core::Place{"t.scr", 1, 23}));
  EXPECT_EQ(reading.scene.targets.at(0).rcs_m2, 12.0);
}

TEST(ReaderProblem, WarnsOfAnEmptyScript) {
  EXPECT_TRUE(holds(only_problem("").message, "this is no scene: it seems to be an empty file"));
  EXPECT_TRUE(holds(only_problem("! only a comment").message, "no command"));
}

TEST(ReaderProblem, HintsAtADollarWithoutABlankBefore) {
  const core::Problem problem = only_problem("$TARGET E 0 0 0 0 0 0 1 5$TARGET ISO");
  EXPECT_TRUE(holds(problem.hint, "blank"));
}

TEST(ReaderProblem, ReportsAnOpenQuote) {
  EXPECT_TRUE(holds(only_problem("$TARGET \"E\n0 0 0 0 0 0 1 0 ISO").message, "quote is not closed"));
}

TEST(ReaderProblem, ReportsEmptyNames) {
  EXPECT_TRUE(holds(only_problem("$TARGET \"\" 0 0 0 0 0 0 1 0 ISO").message, "is empty"));
  EXPECT_TRUE(holds(only_problem("$SIM R 1 2 3 4 8 1 0 ASC RAW \"\" BEG").message, "is empty"));
}

TEST(ReaderProblem, RefusesBytesThatAreNoTextWithOneError) {
  const core::Problem problem = only_problem(std::string_view("$RADAR\nx\0 y z", 13));
  EXPECT_EQ(core::to_string(problem), "t.scr:2:2: error: not a text file; expected a script as text");
}

TEST(ReaderProblem, ReportsAnUnknownOption) {
  const core::Problem problem = only_problem("$OPTIONS SEDE 7");
  EXPECT_TRUE(holds(problem.hint, "SEED")) << problem.hint;
  EXPECT_TRUE(holds(only_problem("$OPTIONS PROFILE FANCY").expected, "CLASSIC or PHYSICAL"));
  EXPECT_TRUE(holds(only_problem("$OPTIONS SEED").message, "ends before the seed"));
  EXPECT_EQ(only_problem("$OPTIONS SEED 1 SEED 2").severity, core::Severity::warning);
}

TEST(ReaderProblem, EndsAfterAThousandErrors) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "$TARGET E x 0 0 0 0 0 1 0 ISO\n";
  const core::Problems problems = problems_of(text);
  EXPECT_EQ(problems.size(), 1001U);
  EXPECT_TRUE(holds(problems.back().message, "stopped after 1000 errors"));
}

TEST(ReaderProblem, CountsWarningsBeyondAThousand) {
  std::string text;
  for (int i = 0; i < 1500; ++i) text += "$TARGET E 0 0 0 0 0 0 1 0 ISO 5\n";
  const core::Problems problems = problems_of(text);
  EXPECT_EQ(problems.size(), 1001U);
  EXPECT_TRUE(holds(problems.back().message, "500 more warnings"));
}

TEST(ReaderProblem, ShowsOnlyTheBeginningOfAVeryLongText) {
  const core::Problem problem = target_problem(std::string(10000, 'x') + " 0 0 0 0 0 1 0 ISO");
  EXPECT_LT(problem.found.size(), 100U);
}

TEST(ReaderProblem, RefusesFiniteNumbersThatAreTooLargeToComputeWith) {
  EXPECT_EQ(
      core::to_string(target_problem("0 -1e300 0 0 0 0 1 0 ISO")),
      "t.scr:1:13: error: position y is too large to compute with; found '-1e300', expected a magnitude up to 1e+18 "
      "m");
  EXPECT_TRUE(holds(radar_problem("CHIRP 1e10 100 RECT CON 1 SIN 1 1 0 0").expected, "up to 1e+09 GHz"));
  EXPECT_TRUE(problems_of("$TARGET E 0 1e18 0 0 0 0 1 0 ISO").empty());
}

TEST(ReaderProblem, PlacesANegativeDeviationAtItsOwnCoordinate) {
  const core::Problem problem = target_problem("0 0 0 0 -1 0 1 0 ISO");
  EXPECT_EQ(problem.place.column, 19U);
  EXPECT_TRUE(holds(problem.message, "standard deviation of position y"));
}

TEST(ReaderProblem, RecognizesUtf16) {
  EXPECT_TRUE(holds(only_problem(std::string_view("\xFF\xFE$\0T\0", 6)).hint, "UTF-16"));
  EXPECT_EQ(only_problem(std::string_view("\x7F"
                                          "ELF\0",
                                          5))
                .hint,
            "");
}

}  // namespace reader_problem_test
}  // namespace sarsim::scene
