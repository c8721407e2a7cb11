#include "core/text/quoted_word.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {
namespace quoted_word_test {

TEST(QuotedWord, IsTheFirstWord) {
  EXPECT_EQ(quoted_word("word"), "word");
  EXPECT_EQ(quoted_word("  word \n"), "word");
  EXPECT_EQ(quoted_word("one two three"), "one...");
  EXPECT_EQ(quoted_word("one\nsecret: line"), "one...");
  EXPECT_EQ(quoted_word("one\fsecret"), "one...");
  EXPECT_EQ(quoted_word(""), "");
}

TEST(QuotedWord, IsCutBetweenCharacters) {
  EXPECT_EQ(quoted_word(std::string(1'000'000, '1')), std::string(60, '1') + "...");
  std::string umlauts;
  for (int i = 0; i < 50; ++i) umlauts += "\u00fc";
  EXPECT_EQ(quoted_word("a" + umlauts), "a" + umlauts.substr(0, 58) + "...");
}

}  // namespace quoted_word_test
}  // namespace sarsim::core
