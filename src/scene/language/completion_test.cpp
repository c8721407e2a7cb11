#include "scene/language/completion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene/language/path_facts.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/schema/quantity.hpp"
#include "support/processor_time.hpp"

namespace sarsim::scene::language {
namespace completion_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

const KnownNames some_names{{"Plane", "Big \"ship\""}, {"Radar1", "Radar2"}, {{"speed", "\"200 m/s\""}}};

Completions at_bar(std::string text) {
  const std::size_t bar = text.find('|');
  text.erase(bar, 1);
  return completions_at(text, bar, some_names);
}

std::vector<std::string> words_at_bar(const std::string& text) {
  std::vector<std::string> words;
  for (const Completion& one : at_bar(text).offered) words.push_back(one.word);
  return words;
}

// The text after one of the offers was taken.
std::string taken(std::string text, std::string_view word) {
  const Completions all = at_bar(text);
  text.erase(text.find('|'), 1);
  for (const Completion& one : all.offered)
    if (one.word == word) return text.replace(all.replaced.begin, all.replaced.end - all.replaced.begin, one.inserted);
  return "not offered";
}

TEST(Completion, OffersEveryFieldWhereItMayStand) {
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) {
      const std::size_t dot = facts.path.rfind('.');
      const std::string below = dot == std::string::npos ? "" : facts.path.substr(0, dot);
      const std::string header = below.empty() ? "" : fmt::format("[{}.{}]\n", table.header, below);
      const std::string key = facts.path.substr(dot == std::string::npos ? 0 : dot + 1);
      EXPECT_THAT(words_at_bar(fmt::format("{}\n{}|", table.header_line(), header)), Contains(key)) << facts.path;
      const std::string begun = fmt::format("{}\n{}{}|", table.header_line(), header, key.substr(0, 2));
      EXPECT_THAT(words_at_bar(begun), Contains(key)) << facts.path;
    }
}

TEST(Completion, OffersEveryWordOfEveryChoiceAndReadsWhatItInserts) {
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) {
      if (facts.role != PathRole::choice || facts.path.find('.') != std::string::npos) continue;
      const std::string head = table.header == "radar" ? "" : "[[radar]]\nname = \"Radar1\"\n";
      const std::string text =
          fmt::format("format = \"sarsim 2\"\n{}{}\n{} = |\n", head, table.header_line(), facts.path);
      for (const Choice& choice : alternatives(facts.spec())) {
        const std::string made = taken(text, type_word(choice));
        for (const core::Problem& problem : read_format_2(made, "x.toml", {}).problems)
          EXPECT_NE(problem.severity, core::Severity::error) << made << core::to_string(problem);
        EXPECT_THAT(made, HasSubstr(fmt::format("\"{}\"", type_word(choice))));
      }
    }
}

TEST(Completion, LeavesOutWhatIsSaidOrBelongsToAnotherType) {
  EXPECT_THAT(words_at_bar("[[radar]]\nname = \"R\"\n|\npower = 1\n"), Not(Contains("name")));
  EXPECT_THAT(words_at_bar("[[radar]]\nname = \"R\"\n|\npower = 1\n"), Not(Contains("power")));
  EXPECT_THAT(words_at_bar("[[radar]]\npulse = { type = \"chirp\", | }"), ElementsAre("bandwidth", "width"));
  EXPECT_THAT(words_at_bar("[[radar]]\npulse = { | }"), IsSupersetOf({"type", "bandwidth", "length"}));
  EXPECT_THAT(words_at_bar("[[platform]]\npath = \"stationary\"\npo|"), Contains("position"));
  EXPECT_THAT(words_at_bar("[[platform]]\npo|\n[platform.path]\ntype = \"line\"\n"), Not(Contains("position")));
  EXPECT_THAT(words_at_bar("[[radar]]\ncarrier = \"9 GHz\"\ncarrier.|"), ElementsAre("type", "frequency"));
}

TEST(Completion, OffersTheFieldsOfAnEntryOfAList) {
  const std::string legs = "[[platform]]\n[platform.path]\ntype = \"legs\"\nlegs = [{ leg = \"turn\", radius = 1 }, ";
  EXPECT_THAT(words_at_bar(legs + "{ | }]"), IsSupersetOf({"leg", "radius", "length"}));
  EXPECT_THAT(words_at_bar(legs + "{ | }]"), Not(Contains("legs")));
  EXPECT_THAT(words_at_bar(legs + "{ leg = \"climb-to\", | }]"), ElementsAre("height", "rate", "rounding"));
  EXPECT_EQ(taken(legs + "{ leg = \"straight\", le| }]", "length"), legs + "{ leg = \"straight\", length =  }]");
  EXPECT_THAT(words_at_bar(legs + "{ leg = \"|\" }]"), IsSupersetOf({"straight", "turn-to"}));
  EXPECT_THAT(words_at_bar(legs + "{ leg = | }]"), IsSupersetOf({"straight", "turn-to"}));
  EXPECT_THAT(words_at_bar(legs + "{ length = \"2 |\" }]"), Contains("km"));
  EXPECT_THAT(words_at_bar("[[platform]]\npath.waypoints = [{ position = [0, \"2 |\" ] }]"), Contains("km"));
  EXPECT_THAT(words_at_bar("[[platform]]\noscillations = [\n  { axis = \"roll\", | },\n]"),
              ElementsAre("angle", "frequency", "phase"));
}

TEST(Completion, KeysGetAnEqualsSignOnce) {
  EXPECT_EQ(taken("[[radar]]\npo|", "power"), "[[radar]]\npower = ");
  EXPECT_EQ(taken("[[radar]]\npo| = 3", "power"), "[[radar]]\npower = 3");
  EXPECT_EQ(taken("[[radar]]\npulse.w|", "width"), "[[radar]]\npulse.width = ");
  EXPECT_THAT(words_at_bar("[[platform]]\nerror|"), ElementsAre("position_error", "rotation_error"));
  EXPECT_EQ(taken("in|", "include"), "include = ");
}

TEST(Completion, OffersHeaders) {
  EXPECT_THAT(words_at_bar("[|"), IsSupersetOf({"platform", "radar", "recording", "options", "let"}));
  EXPECT_EQ(taken("[[ra|", "radar"), "[[radar]]");
  EXPECT_EQ(taken("[ra|]", "radar"), "[[radar]]");
  EXPECT_EQ(taken("[[radar]]\n[radar.be|", "radar.beam"), "[[radar]]\n[radar.beam]");
  EXPECT_EQ(taken("[[radar]]\nrec|", "recording"), "[[radar]]\n[[recording]]");
  EXPECT_THAT(words_at_bar("[[radar]]\n[|"), Contains("radar.pulse"));
  EXPECT_THAT(words_at_bar("[[radar]]\npulse = \"mono\"\n[|"), Not(Contains("radar.pulse")));
  EXPECT_THAT(words_at_bar("[[target]]\n[|"), Not(Contains("radar.pulse")));
}

TEST(Completion, OffersWordsWithTheQuotesThatAreMissing) {
  EXPECT_EQ(taken("[[radar]]\nwindow = |", "hamming"), "[[radar]]\nwindow = \"hamming\"");
  EXPECT_EQ(taken("[[radar]]\nwindow = \"ha|", "hamming"), "[[radar]]\nwindow = \"hamming\"");
  EXPECT_EQ(taken("[[radar]]\nwindow = \"ha|nning\"", "hamming"), "[[radar]]\nwindow = \"hamming\"");
  EXPECT_EQ(taken("[[radar]]\npulse = { type = \"ch|, width = \"5 us\" }", "chirp"),
            "[[radar]]\npulse = { type = \"chirp\", width = \"5 us\" }");
  EXPECT_EQ(taken("format = \"|", "sarsim 2"), "format = \"sarsim 2\"");
  EXPECT_THAT(words_at_bar("[[platform]]\n[platform.path.x]\ninterpolation = \"|\""),
              ElementsAre("linear", "cubic", "low-pass"));
  EXPECT_THAT(words_at_bar("[[platform]]\npath.aligned = |"), ElementsAre("true", "false"));
}

TEST(Completion, OffersNamesOfTheScene) {
  EXPECT_THAT(words_at_bar("[[radar]]\nplatform = \"|\""), ElementsAre("Earth", "Plane", "Big \"ship\""));
  EXPECT_EQ(taken("[[radar]]\nplatform = \"B|\"", "Big \"ship\""), "[[radar]]\nplatform = \"Big \\\"ship\\\"\"");
  EXPECT_THAT(words_at_bar("[[recording]]\nradar = |"), ElementsAre("Radar1", "Radar2"));
  EXPECT_THAT(words_at_bar("[[radar]]\nname = \"|\""), IsEmpty());
}

TEST(Completion, OffersTheUnitsOfAField) {
  EXPECT_THAT(words_at_bar("[[radar]]\npulse.width = \"800 |\""), ElementsAre("s", "ns", "us", "ms", "min", "h"));
  EXPECT_EQ(taken("[[radar]]\npulse.width = \"800n|\"", "ns"), "[[radar]]\npulse.width = \"800ns\"");
  EXPECT_EQ(taken("[[radar]]\ncarrier = \"5.3 g|\"", "GHz"), "[[radar]]\ncarrier = \"5.3 GHz\"");
  EXPECT_THAT(words_at_bar("[[recording]]\nrange = [\"1 km\", \"2 k|\"]"), ElementsAre("km"));
  const std::string points = "[[platform]]\n[platform.path]\ntype = \"points\"\nx.points = [[";
  EXPECT_THAT(words_at_bar(points + "\"1 m|\""), ElementsAre("ms", "min"));
  EXPECT_THAT(words_at_bar(points + "0, \"1 m|\""), ElementsAre("m", "mm"));
  EXPECT_THAT(words_at_bar("[[platform]]\n[platform.path]\nvelocity = [\"3 m/|\""), ElementsAre("m/s"));
  EXPECT_THAT(words_at_bar("[[radar]]\nname = \"3 |\""), IsEmpty());
  EXPECT_THAT(words_at_bar("[let]\na = \"3 |\""), IsSupersetOf({"m", "GHz", "deg"}));
}

TEST(Completion, OffersNamesAndFunctionsWithinExpressions) {
  EXPECT_EQ(taken("[[radar]]\npulse.width = \"2 * sp|\"", "speed"), "[[radar]]\npulse.width = \"2 * speed\"");
  EXPECT_EQ(taken("[let]\na = \"sq|\"", "sqrt"), "[let]\na = \"sqrt(\"");
  EXPECT_THAT(words_at_bar("[let]\nspeed = \"sp|\""), IsEmpty());
  EXPECT_THAT(words_at_bar("[[radar]]\npower = \"|\""), IsSupersetOf({"speed", "sqrt", "pi", "c"}));
}

TEST(Completion, ComesUnaskedWhereAWordHasBegunOrHasToBeChosen) {
  for (const char* const text : {"[[radar]]\npo|", "[|", "[[radar]]\nwindow = |", "[[radar]]\nwindow = \"|\"",
                                 "[[radar]]\nplatform = |", "[[radar]]\npower = \"3 |\"", "[[radar]]\npulse.|"})
    EXPECT_TRUE(at_bar(text).unasked) << text;
  for (const char* const text : {"[[radar]]\n|", "[[radar]]\npower = \"3|\"", "[[radar]]\npower = \"|\"",
                                 "[[radar]]\npower = |", "[[radar]]\npower| = 3", "[[radar]]\nwindow = \"hamming|\"",
                                 "[[radar]]\n# po|", "[let]\npo|wer = 3", "[[x-own]]\npo|"})
    EXPECT_FALSE(at_bar(text).unasked) << text;
}

TEST(Completion, KnowsTheNamesOfLetInABrokenText) {
  Scene scene;
  scene.platforms.emplace_back().name = "Ship";
  const KnownNames names =
      known_names(scene, "x = [\n[let]\nspeed = \"200 m/s\" # fast\nn = 3\n= 4\n[[radar]]\npower = 1\n");
  EXPECT_THAT(names.platforms, ElementsAre("Ship"));
  ASSERT_EQ(names.let.size(), 2U);
  EXPECT_EQ(names.let[0].name, "speed");
  EXPECT_EQ(names.let[0].value, "\"200 m/s\"");
  EXPECT_EQ(names.let[1].value, "3");
}

TEST(Completion, AnyTextHasAnAnswer) {
  const std::string whole =
      "format = \"sarsim 2\"\n[let]\na = \"2 * b / 3 m/\"\n[[radar]]\npulse = { type = \"chirp\", width = '5 us' }\n"
      "carrier = \"9\n[radar.beam]\ntype = \"fixed\"\n[[target]]\npositions = [[1,\n";
  for (std::size_t end = 0; end <= whole.size(); ++end) {
    const std::string text = whole.substr(0, end);
    for (std::size_t at = 0; at <= end; ++at) {
      const Completions all = completions_at(text, at, some_names);
      EXPECT_LE(all.replaced.begin, at);
      EXPECT_LE(all.replaced.end, text.size());
      EXPECT_LE(all.replaced.begin, all.replaced.end);
    }
  }
}

// One that read all of the text would take a thousand times as long.
TEST(Completion, TakesNoLongerInALongText) {
  std::string text = "format = \"sarsim 2\"\n";
  for (int i = 0; i < 100'000; ++i) text += fmt::format("[[target]]\nposition = [{}, 0, 0]\nrcs = \"1 m2\"\n", i);
  const std::size_t at = text.find("rcs", text.size() / 2) + 1;
  const sarsim::test::ProcessorTime time;
  constexpr int times = 200;
  for (int i = 0; i < times; ++i) EXPECT_FALSE(completions_at(text, at, some_names).offered.empty());
  EXPECT_LT(1e3 * time.seconds() / times, 2.0);
}

}  // namespace completion_test
}  // namespace sarsim::scene::language
