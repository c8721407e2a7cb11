#include "scene/language/hover.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene/language/path_facts.hpp"

namespace sarsim::scene::language {
namespace hover_test {

using testing::HasSubstr;

// The explanation of the byte behind a bar.
std::optional<Explanation> at_bar(std::string text) {
  const std::size_t bar = text.find('|');
  text.erase(bar, 1);
  return explanation_at(text, bar);
}

std::string name_at_bar(const std::string& text) {
  const auto explanation = at_bar(text);
  return explanation ? explanation->name : "nothing";
}

TEST(Hover, ExplainsEveryKey) {
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) {
      const std::size_t last = facts.path.rfind('.') + 1;  // npos + 1 is 0.
      const std::string key = facts.path.substr(0, last) + "|" + facts.path.substr(last);
      const auto explanation = at_bar(fmt::format("{}\n{} = 1", table.header_line(), key));
      ASSERT_TRUE(explanation) << key;
      EXPECT_EQ(explanation->name, fmt::format("{}.{}", table.header, facts.path));
      EXPECT_EQ(explanation->meaning, explain(explanation->name).meaning);
    }
}

TEST(Hover, ExplainsEveryWordOfEveryChoice) {
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) {
      if (facts.role != PathRole::choice) continue;
      for (const Choice& choice : alternatives(facts.spec()))
        for (const char* const key : {"", ".type"}) {
          const std::string text =
              fmt::format("{}\n{}{} = \"|{}\"", table.header_line(), facts.path, key, type_word(choice));
          const auto explanation = at_bar(text);
          ASSERT_TRUE(explanation) << text;
          EXPECT_THAT(explanation->name, HasSubstr(type_word(choice)));
          EXPECT_EQ(explanation->meaning, choice.meaning.empty() ? choice.shown : choice.meaning);
        }
    }
}

TEST(Hover, ExplainsHeadersAndTheWordsBeforeThem) {
  EXPECT_EQ(name_at_bar("[[ra|dar]]"), "radar");
  EXPECT_EQ(name_at_bar("[[radar]]\n[radar.be|am]"), "radar.beam");
  EXPECT_EQ(name_at_bar("[[radar]]\n[ra|dar.beam]"), "radar");
  EXPECT_EQ(name_at_bar("[l|et]"), "let");
  EXPECT_EQ(name_at_bar("for|mat = \"sarsim 2\""), "format");
}

TEST(Hover, SaysNothingOfOtherThings) {
  for (const char* const text :
       {"[[radar]]\npower| = 3", "[[radar]]\npower |= 3", "[[radar]]\npower = |3", "[[radar]]\nname = \"|R\"",
        "[[radar]]\nx-no|te = 3", "[[radar]]\npulse = \"|nothing\"", "[[radar]]\n# po|wer", "[let]\npo|wer = 3", "|",
        "[[re|dar]]"})
    EXPECT_EQ(name_at_bar(text), "nothing") << text;
}

TEST(Hover, ExplainsTheCommandsOf1998) {
  const auto radar = explanation_of_command("radar");
  ASSERT_TRUE(radar);
  EXPECT_EQ(radar->name, "$RADAR");
  EXPECT_EQ(radar->meaning, explain("radar").meaning + " In format 2: [[radar]].");
  EXPECT_EQ(radar->lines.front().name, "name of the radar");
  EXPECT_THAT(explanation_of_command("OPTIONS")->meaning, HasSubstr("[options]"));
  EXPECT_EQ(explanation_of_command("CLOUD")->name, "$CLOUD");
  EXPECT_FALSE(explanation_of_command("NOTHING"));
}

}  // namespace hover_test
}  // namespace sarsim::scene::language
