#include "scene/schema/option_words.hpp"

#include <gtest/gtest.h>

namespace sarsim::scene {
namespace option_words_test {

TEST(OptionWords, AreTheWordsOfTheScriptInSmallLetters) {
  RunOptions options;
  options.pulse = PulseDefinition::band_limited;
  options.cubic_ends = core::CubicEnds::not_a_knot;
  const std::vector<std::pair<std::string, std::string>> expected{{"profile", "physical"},
                                                                  {"pulse", "band_limited"},
                                                                  {"cubic_ends", "not_a_knot"},
                                                                  {"ambiguous_echoes", "strong"},
                                                                  {"eclipsing", "none"}};
  EXPECT_EQ(option_words(options), expected);
}

TEST(OptionWords, ComeBackAsTheOptionsTheyCameFrom) {
  RunOptions options;
  options.profile = Profile::classic;
  options.pulse = PulseDefinition::band_limited;
  options.cubic_ends = core::CubicEnds::not_a_knot;
  options.ambiguous_echoes = AmbiguousEchoes::none;
  options.eclipsing = Eclipsing::blanked;
  RunOptions back;
  for (const auto& [id, word] : option_words(options)) EXPECT_TRUE(take_option_word(back, id, word)) << id;
  EXPECT_EQ(back, options);
}

TEST(OptionWords, OfNoChoiceAreRefused) {
  RunOptions options;
  EXPECT_FALSE(take_option_word(options, "profile", "modern"));
  EXPECT_FALSE(take_option_word(options, "seed", "1"));
  EXPECT_FALSE(take_option_word(options, "colour", "none"));
  EXPECT_FALSE(take_option_word(options, "eclipsing", ""));
  EXPECT_EQ(options, RunOptions());
}

}  // namespace option_words_test
}  // namespace sarsim::scene
