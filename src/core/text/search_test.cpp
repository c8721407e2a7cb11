#include "core/text/search.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {

namespace search_test {

using Positions = std::vector<std::size_t>;

TEST(Search, AnEmptySearchKeepsAllInOrder) {
  EXPECT_EQ(ranked_matches("", {"b", "a", ""}), (Positions{0, 1, 2}));
  EXPECT_EQ(ranked_matches("  ", {"b", "a"}), (Positions{0, 1}));
}

TEST(Search, TextsWithoutAllLettersInOrderAreLeftOut) {
  EXPECT_EQ(ranked_matches("ab", {"ba", "xaxb", "b", ""}), (Positions{1}));
  EXPECT_TRUE(ranked_matches("abc", {"ab"}).empty());
}

TEST(Search, CaseDoesNotMatter) { EXPECT_EQ(ranked_matches("NEW radar", {"New Radar", "new radar"}).size(), 2U); }

TEST(Search, WordBeginningsComeBeforeLettersWithinWords) {
  EXPECT_EQ(ranked_matches("nr", {"Centre", "Kinder", "New Radar"}), (Positions{2, 0, 1}));
}

TEST(Search, LettersInARowComeBeforeScatteredOnes) {
  EXPECT_EQ(ranked_matches("plat", {"Put lines at", "Add platform"}), (Positions{1, 0}));
}

TEST(Search, TheBeginningOfTheTextComesFirst) {
  EXPECT_EQ(ranked_matches("save", {"Do not save", "Save as"}), (Positions{1, 0}));
}

TEST(Search, TheWholeTextComesBeforeLongerOnes) {
  EXPECT_EQ(ranked_matches("save", {"Save as", "Save"}), (Positions{1, 0}));
}

TEST(Search, CapitalsWithinAWordBeginWords) { EXPECT_EQ(ranked_matches("sa", {"Visas", "SaveAs", "Isa"}).front(), 1U); }

TEST(Search, EqualsKeepTheirOrder) { EXPECT_EQ(ranked_matches("a", {"ab", "ac", "ad"}), (Positions{0, 1, 2})); }

}  // namespace search_test

}  // namespace sarsim::core
