#include "scene/language/cursor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene/language/plain_table.hpp"

namespace sarsim::scene::language {
namespace cursor_test {

using testing::ElementsAre;
using testing::IsEmpty;

// What stands where a text has a bar.
Cursor at_bar(std::string text) {
  const std::size_t bar = text.find('|');
  text.erase(bar, 1);
  return cursor_at(text, bar);
}

std::string word_at_bar(std::string text) {
  const std::size_t bar = text.find('|');
  text.erase(bar, 1);
  return std::string(core::toml::piece(text, cursor_at(text, bar).word));
}

TEST(Cursor, KnowsThePathOfAKeyInAllNotations) {
  for (const char* const text : {"[[radar]]\npulse = { type = \"chirp\", wi|dth = 5 }", "[[radar]]\npulse.wi|dth = 5",
                                 "[[radar]]\n[radar.pulse]\nwi|dth = 5", "[[radar]]\npulse = { wi|"}) {
    const Cursor cursor = at_bar(text);
    EXPECT_EQ(cursor.site, Site::key) << text;
    EXPECT_EQ(cursor.kind, "radar") << text;
    EXPECT_EQ(cursor.table, "pulse") << text;
    EXPECT_TRUE(cursor.path.starts_with("pulse.wi")) << cursor.path;
    EXPECT_EQ(cursor.typed, "wi") << text;
  }
  EXPECT_EQ(word_at_bar("[[radar]]\npulse.wi|dth = 5"), "width");
  EXPECT_EQ(at_bar("[[radar]]\npul|se.width = 5").path, "pulse");
}

TEST(Cursor, TellsWhatAPlaceIsFor) {
  EXPECT_EQ(at_bar("|").site, Site::key);
  EXPECT_EQ(at_bar("[[radar]]\n|\n").site, Site::key);
  EXPECT_EQ(at_bar("[[radar]]\n# pu|lse").site, Site::comment);
  EXPECT_EQ(at_bar("[[radar]]\npulse = |").site, Site::value);
  EXPECT_EQ(at_bar("[[radar]]\npulse = |# later").site, Site::value);
  EXPECT_EQ(at_bar("[[radar]]\npower = 1|00").site, Site::value);
  EXPECT_EQ(at_bar("[[radar]]\npulse = \"|\"").site, Site::string);
  EXPECT_EQ(at_bar("[[radar]]\npulse = |\"chirp\"").site, Site::nothing);
  EXPECT_EQ(at_bar("[[radar]]\npulse = \"chirp\"| # x").site, Site::nothing);
  EXPECT_EQ(at_bar("[[radar]]\npulse = { type = \"chirp\" | }").site, Site::nothing);
  EXPECT_EQ(at_bar("[[radar]]\npulse = { type = \"chirp\", | }").site, Site::key);
  EXPECT_EQ(at_bar("[[ra|").site, Site::header);
  EXPECT_EQ(at_bar("[[radar]]\n[radar.be|am]").path, "radar.beam");
  EXPECT_EQ(at_bar("[[radar]]\n[ra|dar.beam]").path, "radar");
}

TEST(Cursor, CountsElementsOfArrays) {
  EXPECT_THAT(at_bar("[[recording]]\nrange = [\"1 km\", \"|\"]").rows, ElementsAre(1));
  EXPECT_THAT(at_bar("[[target]]\npositions = [\n  [1, 2, 3], # first\n  [4, |").rows, ElementsAre(1, 1));
  EXPECT_THAT(at_bar("[[target]]\npositions = [[1, 2, 3]]\nrcs = |").rows, IsEmpty());
}

TEST(Cursor, ReadsWhatElseIsSaidOfTheObject) {
  const Cursor cursor = at_bar(
      "[[radar]]\nname = \"R\"\npulse = { type = \"chirp\" }\n|\n[radar.beam]\ntype = \"fixed\"\n[[target]]\nrcs = "
      "1\n");
  std::vector<std::string> said;
  for (const KeyText& one : cursor.said) said.push_back(fmt::format("{}={}", one.path, one.word));
  EXPECT_THAT(said, ElementsAre("name=R", "pulse=", "pulse.type=chirp", "beam=", "beam.type=fixed"));
  EXPECT_TRUE(cursor.alone);
}

TEST(Cursor, WhatIsNotClosedEndsWhereTheNextThingBegins) {
  EXPECT_EQ(at_bar("[[target]]\npositions = [[1, 2,\nrcs = \"|\"").path, "rcs");
  EXPECT_EQ(at_bar("[[target]]\npositions = [[1, 2,\n[[radar]]\nna|me = 1").kind, "radar");
  EXPECT_EQ(at_bar("[[radar]]\npulse = { type = \"chirp\"\npo|wer = 1").path, "power");
  EXPECT_EQ(at_bar("[[radar]]\nname = \"Radar1\nbe|am = 1").path, "beam");
  EXPECT_EQ(at_bar("[[radar]]\nwindow = \"ha|").typed, "ha");
  EXPECT_FALSE(at_bar("[[radar]]\nwindow = \"ha|").complete);
  EXPECT_TRUE(at_bar("[[radar]]\nwindow = \"ha|\"").complete);
}

TEST(Cursor, LinesMayEndInBothWays) {
  EXPECT_EQ(word_at_bar("[[radar]]\r\nna|me = 3\r\n"), "name");
  EXPECT_EQ(word_at_bar("[[radar]]\r\nwindow = \"ha|m\r\n"), "ham");
  EXPECT_EQ(at_bar("\xEF\xBB\xBF[[radar]]\nna|me = 3").kind, "radar");
}

// Every place of every beginning of a text has an answer, and looks at nothing outside.
TEST(Cursor, AnyTextHasAnAnswer) {
  const std::string whole =
      "format = \"sarsim 2\"\n[let]\na = \"2 * b\"\n[[radar]]\npulse = { type = \"chirp\", width = '5 us' }\n"
      "x = [[1, \"a\"], # c\n [{ b.\"c d\" = 1 }]]\n[radar.beam]\ntype = \"\"\"a\nb\"\"\"\n[[target]]\n";
  for (std::size_t end = 0; end <= whole.size(); ++end)
    for (std::size_t at = 0; at <= end + 1; ++at) {
      const std::string text = whole.substr(0, end);
      const Cursor cursor = cursor_at(text, at);
      EXPECT_LE(cursor.word.begin, cursor.word.end);
      EXPECT_LE(cursor.word.end, text.size()) << text << at;
    }
  const std::string deep = "[[radar]]\nx = " + std::string(5000, '[');
  EXPECT_EQ(cursor_at(deep, deep.size()).path, "x");
}

TEST(Cursor, TellsHeadersOfObjectsFromRows) {
  for (const char* const line : {"[[radar]]", "  [let]  # names", "[ options ]", "[[x-own]]"})
    EXPECT_TRUE(begins_object(line)) << line;
  for (const char* const line : {"[radar.beam]", "[1, 2, 3],", "[\"a\"]", "[[radar]", "x = [a]", "[a, b]", ""})
    EXPECT_FALSE(begins_object(line)) << line;
}

TEST(Cursor, FindsTheEndOfWhatIsUnderlined) {
  const auto piece = [](std::string_view line, std::string_view from) {
    const std::size_t at = line.find(from);
    return std::string(line.substr(at, piece_end(line, at) - at));
  };
  EXPECT_EQ(piece("pulse.width = 3", "pulse"), "pulse.width");
  EXPECT_EQ(piece("width = \"800 n\" # ns", "\"800"), "\"800 n\"");
  EXPECT_EQ(piece("width = \"800 n\" # ns", "n\""), "n");
  EXPECT_EQ(piece("a = \"2 * foo + 3 km\"", "foo"), "foo");
  EXPECT_EQ(piece("a = \"2 * foo + 3 km\"", "3 km"), "3 km");
  EXPECT_EQ(piece("a = \"2 * foo + 3 km\"", "2 *"), "2 * foo + 3 km");
  EXPECT_EQ(piece("a = [1, 2] # c", "["), "[1, 2]");
  EXPECT_EQ(piece("a = [1, 34x] # c", "34x"), "34x");
  EXPECT_EQ(piece("[[radar]] # ]", "[["), "[[radar]]");
  EXPECT_EQ(piece("a = \"open", "\"open"), "\"open");
}

}  // namespace cursor_test
}  // namespace sarsim::scene::language
