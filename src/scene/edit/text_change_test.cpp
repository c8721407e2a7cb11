#include "scene/edit/text_change.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace sarsim::scene {
namespace text_change_test {

TEST(TextChange, IsAppliedAndReverted) {
  const TextChanges changes{{0, "one", "1"}, {4, "", "and "}, {4, "two", ""}};
  EXPECT_EQ(apply_changes("one two three", changes), "1 and  three");
  EXPECT_EQ(revert_changes("1 and  three", changes), "one two three");
}

TEST(TextChange, RefusesAnotherText) {
  const TextChanges changes{{4, "two", "2"}};
  EXPECT_THROW(static_cast<void>(apply_changes("one three", changes)), std::logic_error);
  EXPECT_THROW(static_cast<void>(apply_changes("one", changes)), std::logic_error);
  EXPECT_THROW(static_cast<void>(revert_changes("one two", changes)), std::logic_error);
}

TEST(TextDifference, IsWhatStandsBetweenTheCommonEnds) {
  EXPECT_EQ(text_difference("a target", "a large target"), (TextChanges{{2, "", "large "}}));
  EXPECT_EQ(text_difference("aaa", "aa"), (TextChanges{{2, "a", ""}}));
  EXPECT_EQ(text_difference("", "new"), (TextChanges{{0, "", "new"}}));
  EXPECT_TRUE(text_difference("same", "same").empty());
}

TEST(ComposedTextChanges, OfTypingAreOneChange) {
  TextChanges typed;
  std::string text = "ISOTROPIC";
  const std::string start = text;
  for (const char c : std::string_view(" ! round")) {
    const TextChanges next = text_difference(text, text + c);
    text += c;
    typed = composed(typed, next);
  }
  EXPECT_EQ(typed, (TextChanges{{9, "", " ! round"}}));
}

TEST(ComposedTextChanges, ThatUndoEachOtherAreNone) {
  EXPECT_TRUE(composed({{2, "ab", "x"}, {9, "", "y"}}, {{2, "x", "ab"}, {8, "y", ""}}).empty());
}

TEST(ComposedTextChanges, DoWhatBothDoInTurn) {
  std::mt19937_64 engine(17);
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(engine() % limit); };
  const auto random_changes = [&](const std::string& text) {
    TextChanges changes;
    for (std::size_t at = below(4); at < text.size(); at += 1 + below(6)) {
      const std::size_t size = std::min(below(4), text.size() - at);
      std::string after;
      for (std::size_t i = below(4); i > 0; --i) after += static_cast<char>('a' + below(3));
      changes.push_back({at, text.substr(at, size), after});
      at += size;
    }
    return changes;
  };
  for (int round = 0; round < 2000; ++round) {
    std::string start;
    for (std::size_t i = below(30); i > 0; --i) start += static_cast<char>('a' + below(3));
    TextChanges all;
    std::string text = start;
    for (int i = 0; i < 4; ++i) {
      const TextChanges next = random_changes(text);
      text = apply_changes(text, next);
      all = composed(all, next);
      ASSERT_EQ(apply_changes(start, all), text);
      ASSERT_EQ(revert_changes(text, all), start);
    }
  }
}

}  // namespace text_change_test
}  // namespace sarsim::scene
