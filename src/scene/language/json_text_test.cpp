#include "scene/language/json_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "core/toml/values.hpp"
#include "scene/language/scene_reader.hpp"

namespace sarsim::scene::language {
namespace json_text_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string json_scene = R"({
  "format": "sarsim 2",
  "let": {"speed": "240 m/s"},
  "platform": [
    {"name": "P", "path": {"type": "line", "start": [0, 0, 100],
                           "velocity": ["speed", 0, 0]}}
  ],
  "target": [{"position": [1, 2, 3]}, {"positions": [[0, 0, 0],
     [0, 10, 0]], "rcs": "2 m2"}],
  "radar": [{"name": "R", "platform": "P", "carrier": {"type": "stepped",
    "first": "9 GHz", "step": 5e6, "count": 64}, "window": "hamming"}],
  "recording": [{"radar": "R", "file": "a\/b \ud83d\ude00.h5", "format": "hdf5", "range": [10, 20]}],
  "options": {"seed": 7},
  "x-mine": null
}
)";

const std::string toml_scene = R"(format = "sarsim 2"
[let]
speed = "240 m/s"
[[platform]]
name = "P"
path = { type = "line", start = [0, 0, 100], velocity = ["speed", 0, 0] }
[[target]]
position = [1, 2, 3]
[[target]]
positions = [[0, 0, 0], [0, 10, 0]]
rcs = "2 m2"
[[radar]]
name = "R"
platform = "P"
carrier = { type = "stepped", first = "9 GHz", step = 5e6, count = 64 }
window = "hamming"
[[recording]]
radar = "R"
file = "a/b 😀.h5"
format = "hdf5"
range = [10, 20]
[options]
seed = 7
)";

std::string complaints(const std::string& text) {
  std::string listed;
  for (const core::Problem& problem : read_scene_text(text, "scene.json", {}).problems)
    listed += core::to_string(problem) + "\n";
  return listed;
}

std::string without(std::string text, const std::string& piece) {
  text.erase(text.find(piece), piece.size());
  return text;
}

TEST(JsonText, IsTheSameSceneAsInToml) {
  const std::string text = without(json_scene, ",\n  \"x-mine\": null");
  const ScriptReading json = read_scene_text(text, "scene.json", {});
  const ScriptReading toml = read_scene_text(toml_scene, "scene.toml", {});
  ASSERT_THAT(toml.problems, IsEmpty());
  EXPECT_EQ(complaints(text), "");
  EXPECT_EQ(json.scene, toml.scene);
  EXPECT_EQ(json.scene.simulations.at(0).file, "a/b 😀.h5");
  EXPECT_EQ(json.scene.targets.size(), 3U);
}

TEST(JsonText, IsToldByItsFirstLetter) {
  EXPECT_TRUE(is_json("\xEF\xBB\xBF\n {}"));
  EXPECT_FALSE(is_json("format = \"sarsim 2\"\nx = {}"));
  EXPECT_FALSE(is_json(""));
}

TEST(JsonText, HasThePlacesOfTheFile) {
  const std::string told = complaints(R"({"format": "sarsim 2",
  "target": [{"postion": [1, 2, 3]},
             {"rcs": "3 km"}],
  "rader": [{}]})");
  EXPECT_THAT(told, HasSubstr("scene.json:2:15: error:"));
  EXPECT_THAT(told, HasSubstr("did you mean 'position'?"));
  EXPECT_THAT(told, HasSubstr("scene.json:3:23: error:"));
  EXPECT_THAT(told, HasSubstr("scene.json:4:"));
}

TEST(JsonText, SaysWhatIsNotJson) {
  const std::string head = R"({"format": "sarsim 2", "target": [)";
  EXPECT_THAT(complaints(head + "{\"rcs\": 1} # comment\n]}"), HasSubstr("JSON has no comments"));
  EXPECT_THAT(complaints(head + "{\"rcs\"= 1}]}"), HasSubstr("'=' in a JSON text"));
  EXPECT_THAT(complaints(head + "{\"rcs\": 1}]} x"), HasSubstr("unexpected text after the outermost object"));
  for (const char* const broken : {"{\"rcs\": 1}", "{\"rcs\": }]}", "{\"rcs\" 1}]}", "{\"rcs\": \"1 m2}]}",
                                   "{\"rcs\": nul}]}", "{\"rcs\": 1}, 5]}", "{\"rcs\": 1, \"rcs\": 2}]}"})
    EXPECT_THAT(complaints(head + broken), HasSubstr("error:")) << broken;
  EXPECT_THAT(complaints("{}"), HasSubstr("the format of the scene is not stated"));
  EXPECT_THAT(complaints(R"({"format": "sarsim 2", "x-a": 1, "x-a": 2})"), Not(HasSubstr("line 2")));
  EXPECT_THAT(complaints(json_scene), HasSubstr("null"));
}

TEST(JsonText, KeepsItsLengthWhateverItHolds) {
  for (const std::string& text : {json_scene, std::string("{\"a\": \"\\ud83d\\ude00\\/\\"), std::string("{\"a"),
                                  std::string("{\"\\u12"), std::string("{}}}]]]{{{[[[")})
    EXPECT_EQ(read_json(text).toml.size(), text.size()) << text;
}

}  // namespace json_text_test
}  // namespace sarsim::scene::language
