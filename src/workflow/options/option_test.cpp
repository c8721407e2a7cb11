#include "workflow/options/option.hpp"

#include <gtest/gtest.h>

namespace sarsim::workflow::option_test {

namespace {

const Option text_option{"--out", OptionKind::text, "OUT", ""};
const Option number_option{"--height", OptionKind::number, "M", ""};
const Option whole_option{"--bursts", OptionKind::whole, "N", "", {}, 2, 64};
const Option seed_option{"--seed", OptionKind::whole, "N", "", {}, 0, UINT64_MAX};
const Option choice_option{"--grid", OptionKind::choice, "slant|ground", "", {"slant", "ground"}};

}  // namespace

TEST(Option, TakesWordsOfItsKindAlone) {
  for (const char* good : {"-1", "+2.5e3", ".5"}) EXPECT_EQ(mistake_in(number_option, good), "") << good;
  for (const char* bad : {"", "x", "1x", "nan", "inf"})
    EXPECT_EQ(mistake_in(number_option, bad), "'" + std::string(bad) + "' is not a number");
  for (const char* good : {"2", "64", "+3"}) EXPECT_EQ(mistake_in(whole_option, good), "") << good;
  for (const char* bad : {"1", "65", "-3", "2.0", ""})
    EXPECT_EQ(mistake_in(whole_option, bad), "'" + std::string(bad) + "' is not a whole number from 2 to 64");
  EXPECT_EQ(mistake_in(text_option, "./--force"), "");
  EXPECT_EQ(mistake_in(text_option, "--force"), "'--force' is not a name; write ./--force for such a file");
  EXPECT_EQ(mistake_in(text_option, ""), "the name is empty");
}

TEST(Option, TakesALineOfOptionsWhereItIsOne) {
  Option line{"--with", OptionKind::text, "OPTIONS", ""};
  EXPECT_NE(mistake_in(line, "--window hamming"), "");
  line.takes_options = true;
  EXPECT_EQ(mistake_in(line, "--window hamming"), "");
}

TEST(Option, ReadsWholeNumbersBeyondThoseWithASign) {
  EXPECT_EQ(mistake_in(seed_option, "18446744073709551615"), "");
  EXPECT_EQ(whole_number_in("18446744073709551615"), UINT64_MAX);
  EXPECT_EQ(mistake_in(seed_option, "18446744073709551616"),
            "'18446744073709551616' is not a whole number from 0 to 18446744073709551615");
  EXPECT_NE(mistake_in(seed_option, "-1"), "");
  EXPECT_EQ(whole_number_in("+3"), 3U);
}

TEST(Option, NamesTheNearestChoice) {
  EXPECT_EQ(mistake_in(choice_option, "GROUND"), "");
  EXPECT_EQ(choice_in(choice_option, "GROUND"), 1U);
  EXPECT_EQ(mistake_in(choice_option, "grund"), "'grund' is not one of slant, ground; did you mean 'ground'?");
  EXPECT_EQ(mistake_in(choice_option, "elsewhere"), "'elsewhere' is not one of slant, ground");
}

TEST(Option, TellsOfUnknownNamesFirstWithTheNearest) {
  const core::Problems problems =
      problems_with({number_option, choice_option}, {{"--grid", "x"}, {"--height", "y"}, {"--hight", "3"}});
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].message, "unknown option '--hight'");
  EXPECT_EQ(problems[0].hint, "did you mean '--height'?");
  EXPECT_EQ(problems[1].message, "--height: 'y' is not a number");
  EXPECT_EQ(problems[2].message, "--grid: 'x' is not one of slant, ground");
  EXPECT_EQ(problems[2].hint, "");
  const core::Problem nearly = problem_with(choice_option, mistake_in(choice_option, "grund"));
  EXPECT_EQ(nearly.message, "--grid: 'grund' is not one of slant, ground");
  EXPECT_EQ(nearly.hint, "did you mean 'ground'?");
}

}  // namespace sarsim::workflow::option_test
