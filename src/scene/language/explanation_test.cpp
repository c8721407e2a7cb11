#include "scene/language/explanation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene/language/keys.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/scene_writer.hpp"

namespace sarsim::scene::language {
namespace explanation_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// What reading a scene complains of. Its second object is the one that is looked at.
std::string complaints(const PlainTable& table, const std::string& lines) {
  const std::string text =
      fmt::format("format = \"sarsim 2\"\n{}{}\n{}\n", table.header == "radar" ? "" : "[[radar]]\nname = \"Radar1\"\n",
                  table.header_line(), lines);
  std::string listed;
  for (const core::Problem& problem : read_format_2(text, "example.toml", {}).problems)
    listed += core::to_string(problem) + "\n";
  return listed;
}

TEST(Explanation, EveryPathOfEveryKindIsExplained) {
  for (const ObjectKind kind : all_object_kinds)
    for (const std::string& path : paths_of(kind)) {
      const Explanation explanation = explain(fmt::format("{}.{}", header_of(kind), path));
      EXPECT_EQ(explanation.failure, "") << path;
      EXPECT_FALSE(explanation.meaning.empty()) << path;
      const bool says_something = !explanation.takes.empty() || !explanation.lines.empty();
      EXPECT_TRUE(says_something) << path;
    }
  for (const FieldOf<RunOptions>& field : table_of<RunOptions>().fields())
    EXPECT_EQ(explain(fmt::format("options.{}", field.spec.key)).failure, "") << field.spec.key;
}

TEST(Explanation, EveryExampleIsReadWithoutAComplaint) {
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) {
      if (facts.role == PathRole::file || facts.path == "geoid.file") continue;  // there is none
      const std::string example = example_text(table, facts);
      EXPECT_EQ(complaints(table, example), "") << table.header << '\n' << example;
      EXPECT_THAT(example, HasSubstr(facts.path.substr(0, facts.path.find('.'))));
    }
}

TEST(Explanation, EveryAlternativeIsReadWithoutAComplaint) {
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& choice : paths_of(table)) {
      if (choice.role != PathRole::choice) continue;
      for (const Choice& alternative : alternatives(choice.spec())) {
        const std::string example = example_text(table, choice, alternative);
        EXPECT_EQ(complaints(table, example), "") << example;
        EXPECT_THAT(example, HasSubstr(type_word(alternative)));
      }
    }
}

TEST(Explanation, EveryShorthandIsReadWithoutAComplaint) {
  std::vector<std::string> found;
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) {
      const std::string shorthand = shorthand_text(table, facts);
      if (shorthand.empty()) continue;
      EXPECT_EQ(complaints(table, shorthand), "") << shorthand;
      found.push_back(shorthand);
    }
  EXPECT_THAT(found, Contains("carrier = \"1 GHz\""));
  EXPECT_THAT(found, Contains("pulse = \"5 us\""));
}

// The writer says what is at its default too, in comment lines.
TEST(Explanation, DefaultsAreThoseThatTheWriterWrites) {
  Scene scene;
  scene.platforms.resize(1);
  scene.targets.resize(1);
  scene.surfaces.resize(1);
  scene.radars.resize(1);
  scene.simulations.resize(1);
  scene.geometries.resize(1);
  const std::string text = write_format_2(scene, Saying::everything);
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) {
      const std::string value = default_text(facts);
      const bool is_plain = facts.path.find('.') == std::string::npos && facts.role == PathRole::value;
      if (!is_plain || value.empty() || !facts.spec().when.among.empty()) continue;
      EXPECT_THAT(text, HasSubstr(fmt::format("{} = {}\n", facts.path, value))) << table.header;
    }
}

TEST(Explanation, SaysAllOfAField) {
  const Explanation width = explain("radar.pulse.width");
  EXPECT_EQ(width.name, "radar.pulse.width");
  EXPECT_EQ(width.takes, "a time");
  EXPECT_EQ(width.unit, "s");
  EXPECT_THAT(width.other_units, ElementsAre("ns", "us", "ms", "min", "h"));
  EXPECT_EQ(width.range, "0 s or more; above 0 s to be simulated");
  EXPECT_EQ(width.likely, "0.1 ns to 1 s");
  EXPECT_EQ(width.initial, "\"5 us\"");
  EXPECT_EQ(width.applies_to, "");
  EXPECT_EQ(width.example, "pulse = { type = \"mono\", width = \"5 us\" }");
  EXPECT_EQ(width.in_script, "$RADAR: pulse width in ns");
  EXPECT_EQ(width.label, "Pulse: Pulse width");
  EXPECT_THAT(width.set_names, ElementsAre("Radar1.pulse_width"));
}

TEST(Explanation, SaysWhenAFieldApplies) {
  EXPECT_EQ(explain("radar.pulse.bandwidth").applies_to, "pulse of type chirp");
  EXPECT_EQ(explain("radar.carrier.first").applies_to, "carrier of type stepped");
  EXPECT_EQ(explain("radar.carrier.frequency").applies_to, "carrier of type single");
  EXPECT_EQ(explain("radar.beam.elevation").applies_to, "beam of type fixed or rotating");
  EXPECT_EQ(explain("target.reflectivity.gain.points").applies_to,
            "reflectivity.gain of type points, with reflectivity of type directional");
}

TEST(Explanation, ChoicesTellTheirAlternatives) {
  const Explanation pulse = explain("radar.pulse");
  ASSERT_EQ(pulse.alternatives.size(), 4U);
  EXPECT_EQ(pulse.alternatives[1].word, "chirp");
  EXPECT_EQ(pulse.alternatives[1].in_script, "CHIRP");
  EXPECT_THAT(pulse.alternatives[1].fields, ElementsAre("pulse.bandwidth", "pulse.width"));
  EXPECT_EQ(explain("radar.pulse.type").name, "radar.pulse");
  EXPECT_EQ(explain("radar.receive_antenna").initial, "\"same\"");
  EXPECT_EQ(explain("platform.path").alternatives.back().word, "line");
}

TEST(Explanation, FindsAFieldByAnyOfItsNames) {
  EXPECT_EQ(explain("repetition.frequency").name, "radar.repetition.frequency");
  EXPECT_EQ(explain("bandwidth").name, "radar.pulse.bandwidth");
  EXPECT_EQ(explain("prf").name, "radar.repetition.frequency");
  EXPECT_EQ(explain("Radar1.prf").name, "radar.repetition.frequency");
  EXPECT_EQ(explain("prf_hz").name, "radar.repetition.frequency");
  EXPECT_EQ(explain("[[radar]]").name, "radar");
  EXPECT_THAT(explain("target.positions.file").set_names, ElementsAre("Cloud1.file"));
}

// Each list with the words of an object around it that make it mean something.
std::vector<std::pair<std::string, PathFacts>> lists() {
  std::vector<std::pair<std::string, PathFacts>> found;
  for (const PathFacts& facts : paths_of(*plain_table("platform")))
    if (facts.spec().type == FieldType::list) found.emplace_back("platform." + facts.path, facts);
  return found;
}

TEST(Explanation, EveryFieldOfAnEntryIsExplained) {
  ASSERT_EQ(lists().size(), 3U);
  for (const auto& [list, facts] : lists()) {
    const Explanation whole = explain(list);
    std::size_t count = 0;
    for (const PathFacts& field : paths_of(element_table(facts.spec().list))) {
      const Explanation explanation = explain(list + "." + field.path);
      EXPECT_EQ(explanation.failure, "") << list << field.path;
      EXPECT_EQ(explanation.name, list + "." + field.path);
      EXPECT_FALSE(explanation.takes.empty());
      EXPECT_EQ(whole.lines.at(count++).name, explanation.name);
      const std::string begin = facts.path == "oscillations" ? "" : "path.speed = 100\npath.";
      const std::string type = facts.path == "oscillations" ? "" : "path.type = \"" + facts.path.substr(5) + "\"\n";
      EXPECT_EQ(complaints(*plain_table("platform"), type + begin + explanation.example), "") << explanation.example;
      for (const AlternativeExplanation& one : explanation.alternatives) {
        const std::string key = facts.path.substr(facts.path.rfind('.') + 1);
        EXPECT_EQ(complaints(*plain_table("platform"), fmt::format("{}{}{} = [{}]", type, begin, key, one.example)),
                  "");
        for (const std::string& path : one.fields) EXPECT_EQ(explain("platform." + path).failure, "") << path;
      }
    }
  }
}

TEST(Explanation, FieldsOfEntriesAreFoundByTheNameOfTheList) {
  for (const char* const word :
       {"platform.path.legs.length", "path.legs.length", "legs.length", "platform.legs.length"})
    EXPECT_EQ(explain(word).name, "platform.path.legs.length") << word;
  EXPECT_EQ(explain("legs.length").applies_to, "leg straight");
  EXPECT_EQ(explain("legs.length").example, "legs = [{ leg = \"straight\", length = \"10 km\" }]");
  EXPECT_EQ(explain("legs.heading").initial, "");
  EXPECT_EQ(explain("legs.leg").alternatives[2].example,
            "{ leg = \"turn-to\", heading = \"270 deg\", bank = \"25 deg\" }");
  EXPECT_EQ(explain("waypoints.speed").unit, "m/s");
  EXPECT_EQ(explain("legs.lenght").hint, "did you mean 'legs.length'?");
  EXPECT_EQ(explain("platform.legs.raduis").hint, "did you mean 'platform.legs.radius'?");
}

TEST(Explanation, ListsWhatAWordCanMean) {
  const Explanation position = explain("position");
  ASSERT_EQ(position.lines.size(), 2U);
  EXPECT_EQ(position.lines[0].name, "platform.position");
  EXPECT_EQ(position.lines[1].name, "target.position");
  EXPECT_EQ(explain("format").lines.size(), 1U);
  EXPECT_GE(explain("radar").lines.size(), 40U);
  EXPECT_GE(explain("").lines.size(), 9U);
}

TEST(Explanation, UnknownWordsHaveASuggestion) {
  EXPECT_EQ(explain("radar.pulse.widht").hint, "did you mean 'radar.pulse.width'?");
  EXPECT_EQ(explain("bandwith").hint, "did you mean 'bandwidth'?");
  EXPECT_EQ(explain("recordnig").hint, "did you mean 'recording'?");
  EXPECT_THAT(explain("qqqqqqqqqqqq").hint, HasSubstr("lists what there is"));
}

TEST(Explanation, ExplainsWhatIsNoField) {
  for (const char* const word : {"let", "include", "format"}) {
    EXPECT_THAT(explain(word).failure, IsEmpty());
    EXPECT_THAT(explain(word).example, HasSubstr(word));
  }
}

TEST(Explanation, TextAndJsonSayTheSame) {
  const Explanation power = explain("radar.power");
  const std::string text = text_of(power);
  core::JsonWriter json;
  write_json(json, power);
  for (const char* const part : {"radar.power", "Transmitted peak power.", "0 W or more", "transmitted power in kW"}) {
    EXPECT_THAT(text, HasSubstr(part));
    EXPECT_THAT(json.text(), HasSubstr(part));
  }
  EXPECT_THAT(json.text(), HasSubstr("\"minimum\": 0"));
  EXPECT_THAT(json.text(), Not(HasSubstr("\"maximum\": null")));
}

}  // namespace explanation_test
}  // namespace sarsim::scene::language
