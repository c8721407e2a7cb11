#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "core/text/json.hpp"
#include "scene/language/explanation.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/language/plain_table.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/schema/field_names.hpp"
#include "scene/schema/trade_words.hpp"

namespace sarsim::scene::language {
namespace trade_words_language_test {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

bool has_path(std::string_view name) {
  return std::ranges::any_of(plain_tables(), [&](const PlainTable& table) {
    return std::ranges::any_of(paths_of(table), [&](const PathFacts& facts) {
      return fmt::format("{}.{}", table.header, facts.path) == name;
    });
  });
}

TEST(TradeWordsOfTheLanguage, MeanFieldsThatThereAre) {
  for (const TradeWord& word : trade_words()) {
    if (word.field.empty()) continue;
    const bool is_table = std::ranges::any_of(plain_tables(), [&](const PlainTable& table) {
      return std::ranges::any_of(paths_of(table), [&](const PathFacts& facts) {
        return fmt::format("{}.{}", table.header, facts.path).starts_with(fmt::format("{}.", word.field));
      });
    });
    EXPECT_TRUE(has_path(word.field) || is_table) << word.names << " -> " << word.field;
    EXPECT_TRUE(word.kind.empty() || plain_table(word.kind) != nullptr) << word.kind;
  }
}

TEST(TradeWordsOfTheLanguage, ChooseAlternativesThatThereAre) {
  for (const TradeChoice& choice : trade_choices()) {
    bool found = false;
    for (const PlainTable& table : plain_tables())
      for (const PathFacts& facts : paths_of(table)) {
        if (facts.path != choice.choice) continue;
        const std::vector<Choice> all = alternatives(facts.spec());
        found = found || choice.word.empty() ||
                std::ranges::any_of(all, [&](const Choice& one) { return type_word(one) == choice.word; });
      }
    EXPECT_TRUE(found) << choice.choice << ": " << choice.word;
  }
  for (const TradeHeader& header : trade_headers())
    EXPECT_TRUE(header.header.empty() || header.header == "let" || plain_table(header.header) != nullptr)
        << header.header;
}

std::string scene_with(const std::string& kind, const std::string& line) {
  const auto in = [&](const std::string& one) { return kind == one ? line + "\n" : std::string(); };
  return "format = \"sarsim 2\"\n[[platform]]\nname = \"P\"\n" + in("platform") + "[[target]]\nposition = [0, 0, 0]\n" +
         in("target") + "[[radar]]\nname = \"R\"\nplatform = \"P\"\n" + in("radar") +
         "carrier = \"9.6 GHz\"\n[[recording]]\nradar = \"R\"\n" + in("recording");
}

std::string hint_of(const std::string& kind, const std::string& line) {
  const ScriptReading reading = read_format_2(scene_with(kind, line), "s.toml", {});
  for (const core::Problem& problem : reading.problems)
    if (problem.severity == core::Severity::error) return problem.hint;
  return "no error";
}

TEST(TradeWordsOfTheLanguage, AreAnsweredWhereTheyAreWritten) {
  struct Row {
    const char* kind;
    const char* line;
    const char* says;
  };
  const Row rows[]{
      {"radar", "wavelength = \"3 cm\"", "write carrier = \"9.993 GHz\""},
      {"radar", "pri = \"1 ms\"", "write repetition = \"1 kHz\""},
      {"radar", "prf = 1000", "write repetition = \"1000\""},
      {"radar", "gain = \"30 dB\"", "transmit_gain = \"30 dB\" and receive_gain = \"30 dB\""},
      {"radar", "noise_figure = \"4 dB\"", "noise_temperature = \"728.4 K\""},
      {"radar", "polarization = \"HH\"", "polarisation is not modelled"},
      {"target", "velocity = [10, 0, 0]", "objects move with their platform"},
      {"radar", "pulse = { type = \"lfm\", width = \"1 us\" }", "write \"chirp\""},
      {"radar", "beam = \"spotlight\"", "write \"spot\""},
      {"radar", "antenna = { type = \"gaussian\" }", "write \"points\""},
      {"radar", "bandwidth = \"50 MHz\"", "pulse = { type = \"chirp\", bandwidth = \"50 MHz\""},
      {"radar", "repetition = \"1.67 ms\"", "write \"598.8 Hz\", which is 1/(1.67 ms)"},
      {"radar", "antenna = { type = \"sinx\", azimuth_width = \"1 m\", elevation_width = \"5 deg\" }",
       "write \"1.585 deg\", which is 0.886 wavelength/(1 m)"},
      {"platform", "altitude = \"3 km\"", "position = [0, 0, \"3 km\"]"},
      {"platform", "yaw = 3", "rotation ="},
      {"recording", "fs = \"60 MHz\"", "write sample_rate = \"60 MHz\""},
      {"recording", "swath = \"1 km\"", "write range ="},
      {"recording", "cpi = \"0.5 s\"", "write time = [\"0 s\", \"0.5 s\"]"},
      {"recording", "format = \"h5\"", "write \"hdf5\""},
      {"recording", "window = \"hamming\"", "write window = \"hamming\" in [[radar]]"},
      {"target", "swerling = 1", "Swerling"},
      {"target", "sigma0 = \"-10 dB\"", "rcs"},
      {"radar", "frequncy = \"3 GHz\"", "write carrier = \"3 GHz\""},
      {"radar", "colour = 3", "your own fields must begin with x-"},
      {"radar", "antenna = { type = \"sinx\", length = \"1 m\" }", "write azimuth_width = \"1.585 deg\" in antenna"},
      {"radar", "rpm = 12", "rate = \"12 rpm\""},
      {"radar", "beam = { type = \"rotating\", rpm = 12 }", "write rate = \"12 rpm\" in beam"},
      {"radar", "beam = { type = \"fixed\", rpm = 12 }", "beam = { type = \"rotating\", elevation = \"0 deg\", rate ="},
      {"platform", "rpm = 300", "rotation_rate = [\"0 deg/s\", \"0 deg/s\", \"300 rpm\"]"},
      {"radar", "pulse = { type = \"chirp\", bandwidth = \"100 MHz\", pulse_width = \"2 us\" }",
       "write width = \"2 us\" in pulse"},
      {"radar", "pulse_width = \"2 us\"", "bandwidth = \"...\", width = \"2 us\""},
      {"radar", "repetition = [\"500 Hz\", \"600 Hz\"]", "repetition = { type = \"list\", intervals = ["},
      {"radar", "repetition = \"staggered\"", "intervals = [\"2 ms\""},
      {"target", "lat = 47.5", "latitude = \"47.5\""},
      {"target", "lon = \"9 deg\"", "longitude = \"9 deg\""},
      {"target", "x = 3000", "position = [\"3000\", \"0 m\", \"0 m\"]"},
      {"target", "location = [3000, 0, 5]", "position = [3000, 0, 5]"},
      {"platform", "path = { type = \"waypoints\", points = [[0, 0, 0]] }", "write waypoints = [{ position = ["},
      {"recording", "format = \"complex64\"", "write \"npy\""},
  };
  for (const Row& row : rows) EXPECT_THAT(hint_of(row.kind, row.line), HasSubstr(row.says)) << row.line;
}

TEST(TradeWordsOfTheLanguage, OfKindsNameTheRightHeader) {
  const auto said = [](const std::string& header) {
    const ScriptReading reading = read_format_2("format = \"sarsim 2\"\n" + header + "\n", "s.toml", {});
    return reading.problems.empty() ? std::string() : reading.problems.front().hint;
  };
  EXPECT_THAT(said("[[transmitter]]"), HasSubstr("write [[radar]]"));
  EXPECT_THAT(said("[[aircraft]]"), HasSubstr("write [[platform]]"));
  EXPECT_THAT(said("[[scatterer]]"), HasSubstr("write [[target]]"));
  EXPECT_THAT(said("[constants]"), HasSubstr("write [let]"));
  EXPECT_THAT(said("[[jammer]]"), HasSubstr("not modelled"));
  EXPECT_THAT(said("[[clutter]]"), HasSubstr("many [[target]]"));
}

TEST(TradeWordsOfTheLanguage, MarksThatAreMistypedAreNotThoseOfLaterPrograms) {
  const auto said = [](const std::string& mark) {
    const ScriptReading reading = read_format_2("format = " + mark + "\n", "s.toml", {});
    return reading.problems.empty() ? std::string() : reading.problems.front().hint;
  };
  for (const char* const mark : {"2", "\"2\"", "\"sarsim2\"", "\"Sarsim 2\"", "\"sarsim 1\""})
    EXPECT_EQ(said(mark), "write format = \"sarsim 2\"") << mark;
  EXPECT_THAT(said("\"sarsim 3\""), HasSubstr("newer Sarsim"));
}

TEST(TradeWordsOfTheLanguage, AreAnsweredBySettingThem) {
  Scene scene;
  scene.radars.emplace_back();
  scene.targets.emplace_back();
  const auto said = [&](const char* name, const char* value) { return find_named_field(scene, name, value).failure; };
  EXPECT_THAT(said("Radar1.pri", "1 ms"), HasSubstr("write Radar1.repetition.frequency=1 kHz"));
  EXPECT_THAT(said("Radar1.wavelength", "3 cm"), HasSubstr("write Radar1.carrier.frequency=9.993 GHz"));
  EXPECT_THAT(said("Radar1.polarization", "H"), HasSubstr("polarisation is not modelled"));
  EXPECT_THAT(said("wavelength", "3 cm"), HasSubstr("radar.carrier.frequency"));
  EXPECT_THAT(said("Target1.sigma", "3"), HasSubstr("write Target1.rcs=3"));
  EXPECT_THAT(said("Radar1.bandwith", "3 MHz"), HasSubstr("did you mean bandwidth?"));
}

TEST(TradeWordsOfTheLanguage, ChoicesThatAreSetAreNamedAsInFormat2) {
  Scene scene;
  scene.radars.emplace_back();
  const auto said = [&](const char* name, const char* value) {
    return set_named_field(scene, find_named_field(scene, name, value), value, {});
  };
  EXPECT_EQ(said("Radar1.repetition", "100Hz"), "'100Hz' is none of constant and list");
  EXPECT_THAT(said("Radar1.pulse", "100Hz"), HasSubstr("chirp"));
  EXPECT_EQ(said("Radar1.repetition", "constant"), "");
}

TEST(ExplanationSearch, PutsFieldsWhoseNameHasTheWordFirst) {
  const Explanation noise = explain("noise");
  ASSERT_FALSE(noise.lines.empty());
  EXPECT_EQ(noise.lines.front().name, "radar.noise_temperature");
  EXPECT_EQ(noise.failure, "");
}

TEST(ExplanationSearch, FindsHeadingsOfTheDocumentation) {
  for (const char* const words : {"migration", "range migration", "Range-Migration"}) {
    const Explanation found = explain(words);
    EXPECT_EQ(found.failure, "") << words;
    EXPECT_TRUE(std::ranges::any_of(found.pages, [](const GuideHeading& page) {
      return page.heading.find("Range migration") != std::string_view::npos;
    })) << words;
  }
  EXPECT_GT(guide_headings().size(), 300U);
  EXPECT_EQ(explain("range cell migration").failure, "") << "one word less";
}

TEST(ExplanationSearch, ExplainsTheFieldThatAWordOfTheTradeMeans) {
  const Explanation pri = explain("pri");
  EXPECT_EQ(pri.name, "radar.repetition.frequency");
  EXPECT_THAT(pri.asked, HasSubstr("1/PRI"));
  EXPECT_THAT(text_of(pri), HasSubstr("pri: write repetition"));
  EXPECT_EQ(explain("wavelength").name, "radar.carrier.frequency");
  const Explanation lfm = explain("lfm");
  EXPECT_EQ(lfm.name, "radar.pulse");
  EXPECT_THAT(lfm.asked, HasSubstr("\"chirp\""));
  EXPECT_THAT(explain("polarization").meaning, HasSubstr("not modelled"));
  EXPECT_NE(explain("xyzzy").failure, "");
  EXPECT_NE(explain("pulse.widht").failure, "") << "has a suggestion";
}

TEST(ExplanationSearch, AnswersAsJsonToo) {
  core::JsonWriter json;
  write_json(json, explain("migration"));
  EXPECT_THAT(json.text(), HasSubstr("\"pages\""));
  EXPECT_THAT(json.text(), HasSubstr("guide/recipes/from-pulse-to-image.md"));
}

}  // namespace trade_words_language_test
}  // namespace sarsim::scene::language
