#include "workflow/options/option_words.hpp"

#include <gmock/gmock.h>

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow::option_words_test {

namespace {

const std::vector<Option> options{{"--window", OptionKind::text, "WINDOW", ""},
                                  {"--pfa", OptionKind::number, "P", ""},
                                  {"--force", OptionKind::flag, "", ""},
                                  {"--set", OptionKind::texts, "FIELD=VALUE", ""}};

std::vector<std::string> refusals(const std::vector<std::string>& words) {
  std::vector<std::string> told;
  try {
    static_cast<void>(given_words(options, words));
  } catch (const core::InvalidRequest& refused) {
    for (const core::Problem& problem : refused.problems) told.push_back(problem.message + "|" + problem.hint);
  }
  return told;
}

}  // namespace

TEST(WordsOfLine, ArePartedBySpaceAndKeptTogetherByQuotes) {
  EXPECT_THAT(words_of_line(""), testing::IsEmpty());
  EXPECT_THAT(words_of_line("  --pfa 1e-4\t--out 'my \"own\" maps' \"it's\"--x '' "),
              testing::ElementsAre("--pfa", "1e-4", "--out", "my \"own\" maps", "it's--x", ""));
  EXPECT_THROW(static_cast<void>(words_of_line("--out 'maps")), core::InvalidRequest);
}

TEST(GivenWords, AreReadAsTheyAreTyped) {
  const GivenWords expected{{"--window", "hann"}, {"--pfa", "-1"}, {"--force", ""}};
  EXPECT_EQ(given_words(options, {"--window", "hann", "--force", "--pfa=-1"}), expected);
  EXPECT_TRUE(given_words(options, {}).empty());
}

TEST(GivenWords, OfSomeOptionsAreSeveralInTheirOrder) {
  const GivenWords expected{{"--set", "a.b=1"}, {"--set", "a.b=0"}};
  EXPECT_EQ(given_words(options, {"--set", "a.b=1", "--set=a.b=0"}), expected);
}

TEST(GivenWords, TellEverythingThatIsWrongAtOnce) {
  EXPECT_THAT(refusals({"--widnow", "--force", "--pfa", "often", "--force=yes"}),
              testing::ElementsAre("--force takes no word|", "unknown option '--widnow'|did you mean '--window'?",
                                   "--pfa: 'often' is not a number|"));
  EXPECT_THAT(refusals({"--widnow", "hann"}),
              testing::ElementsAre("unknown option '--widnow'|did you mean '--window'?"));
  EXPECT_THAT(refusals({"hann"}), testing::ElementsAre("'hann' belongs to no option|"));
  EXPECT_THAT(refusals({"--window"}), testing::ElementsAre("--window: WINDOW is missing after it|"));
  EXPECT_THAT(refusals({"--pfa", "1", "--pfa=2"}), testing::ElementsAre("--pfa is given twice|leave one of them out"));
}

}  // namespace sarsim::workflow::option_words_test
