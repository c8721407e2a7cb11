#include "scene/language/json_schema.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/path_facts.hpp"
#include "support/folders.hpp"

namespace sarsim::scene::language {
namespace json_schema_test {

// A value of JSON: members or elements, or the text of anything else, strings without their quotes.
struct Json {
  std::map<std::string, Json> members;
  std::vector<Json> elements;
  std::string text;

  [[nodiscard]] const Json* find(const std::string& name) const {
    const auto found = members.find(name);
    return found == members.end() ? nullptr : &found->second;
  }
};

// Reads JSON strictly; std::runtime_error where it is none.
class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_(text) {}

  Json whole() {
    Json json = value();
    skip();
    if (at_ != text_.size()) fail();
    return json;
  }

 private:
  [[noreturn]] void fail() const { throw std::runtime_error(fmt::format("no JSON at byte {}", at_)); }
  void skip() {
    while (at_ < text_.size() && core::is_blank(text_[at_])) ++at_;
  }
  char next() {
    skip();
    if (at_ == text_.size()) fail();
    return text_[at_];
  }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail();
  }

  Json value() {
    Json json;
    if (next() == '{') {
      ++at_;
      for (bool more = !take('}'); more; more = !take('}')) {
        if (!json.members.empty()) expect(',');
        std::string name = string();
        expect(':');
        if (!json.members.emplace(std::move(name), value()).second) fail();
      }
    } else if (next() == '[') {
      ++at_;
      for (bool more = !take(']'); more; more = !take(']')) {
        if (!json.elements.empty()) expect(',');
        json.elements.push_back(value());
      }
    } else {
      json.text = next() == '"' ? string() : word();
    }
    return json;
  }

  std::string string() {
    expect('"');
    std::string result;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (static_cast<unsigned char>(text_[at_]) < 0x20) fail();
      if (text_[at_] == '\\') ++at_;
      if (at_ < text_.size()) result += text_[at_];
    }
    if (at_ == text_.size()) fail();
    ++at_;
    return result;
  }

  std::string word() {
    const std::size_t end = std::min(text_.find_first_not_of("+-.0123456789aeflnrstuE", at_), text_.size());
    if (end == at_) fail();
    std::string result(text_.substr(at_, end - at_));
    at_ = end;
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

const Json& schema() {
  static const Json made = JsonReader(json_schema()).whole();
  return made;
}

const Json* kind_schema(std::string_view header) {
  const Json* const kind = schema().find("properties")->find(std::string(header));
  if (kind == nullptr) return nullptr;
  const Json* const items = kind->find("items");
  return items != nullptr ? items : kind;
}

// Every schema that a path has, whichever alternatives it belongs to.
void collect(const Json& from, std::string_view path, std::vector<const Json*>& found) {
  if (path.empty()) found.push_back(&from);
  const std::size_t dot = path.find('.');
  if (const Json* const properties = from.find("properties"); properties != nullptr && !path.empty())
    if (const Json* const inner = properties->find(std::string(path.substr(0, dot))))
      collect(*inner, dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1), found);
  if (const Json* const any = from.find("anyOf"); any != nullptr && !path.empty())
    for (const Json& alternative : any->elements) collect(alternative, path, found);
}

std::vector<const Json*> schemas_of(std::string_view header, std::string_view path) {
  std::vector<const Json*> found;
  if (const Json* const kind = kind_schema(header)) collect(*kind, path, found);
  return found;
}

TEST(JsonSchema, IsJsonOfDraft4) {
  EXPECT_EQ(schema().find("$schema")->text, "http://json-schema.org/draft-04/schema#");
  EXPECT_EQ(schema().find("required")->elements.front().text, "format");
}

TEST(JsonSchema, RefusesNoUnknownKeys) {
  EXPECT_EQ(json_schema().find("\"additionalProperties\": false"), std::string::npos);
}

TEST(JsonSchema, HasEveryPathOfEveryKind) {
  for (const ObjectKind kind : all_object_kinds)
    for (const std::string& path : paths_of(kind)) {
      if (path == "receive_antenna.type") continue;
      EXPECT_FALSE(schemas_of(header_of(kind), path).empty()) << header_of(kind) << '.' << path;
    }
}

TEST(JsonSchema, HasDescriptionAndDefaultOfEveryField) {
  for (const PlainTable& table : plain_tables())
    for (const PathFacts& facts : paths_of(table)) {
      const std::vector<const Json*> found = schemas_of(table.header, facts.path);
      EXPECT_FALSE(found.empty()) << facts.path;
      bool is_there = false;  // Several alternatives may have a key of that name.
      for (const Json* const one : found) {
        ASSERT_NE(one->find("description"), nullptr) << facts.path;
        if (!one->find("description")->text.starts_with(meaning_text(facts))) continue;
        is_there = true;
        EXPECT_EQ(one->find("default") != nullptr, !default_text(facts).empty()) << facts.path;
      }
      EXPECT_TRUE(is_there) << facts.path;
    }
}

TEST(JsonSchema, DefaultsAreThoseOfTheTable) {
  EXPECT_EQ(schemas_of("radar", "pulse.width").front()->find("default")->text, "5 us");
  EXPECT_EQ(schemas_of("radar", "window").front()->find("default")->text, "rectangular");
  EXPECT_EQ(schemas_of("recording", "bits").front()->find("default")->text, "8");
  EXPECT_EQ(schemas_of("geometry", "range").front()->find("default")->elements.back().text, "100 km");
  EXPECT_EQ(schemas_of("options", "seed").front()->find("default")->text, "1");
  EXPECT_EQ(schemas_of("radar", "receive_antenna").front()->find("default")->text, "same");
}

TEST(JsonSchema, ChoicesTakeAWordAShorthandAndATable) {
  const Json& carrier = *schemas_of("radar", "carrier").front();
  const std::vector<Json>& forms = carrier.find("anyOf")->elements;
  ASSERT_EQ(forms.size(), 3U);
  EXPECT_EQ(forms[0].find("enum")->elements.size(), 3U);
  EXPECT_EQ(forms[1].find("type")->elements.front().text, "number");
  EXPECT_EQ(forms[1].find("type")->elements.back().text, "string");
  EXPECT_EQ(forms[2].find("required")->elements.front().text, "type");
  EXPECT_EQ(forms[2].find("properties")->find("type")->find("enum")->elements.size(), 3U);
  EXPECT_EQ(forms[2].find("anyOf")->elements.size(), 3U);
}

// taplo shows each form by itself.
void expect_descriptions_in_every_form(const Json& json) {
  if (const Json* const forms = json.find("anyOf")) {
    for (const Json& form : forms->elements) EXPECT_NE(form.find("description"), nullptr);
  }
  for (const auto& [name, member] : json.members) expect_descriptions_in_every_form(member);
  for (const Json& element : json.elements) expect_descriptions_in_every_form(element);
}

TEST(JsonSchema, EveryFormIsDescribed) { expect_descriptions_in_every_form(schema()); }

TEST(JsonSchema, FormsHaveTheirOwnDefaults) {
  const std::vector<Json>& forms = schemas_of("radar", "carrier").front()->find("anyOf")->elements;
  EXPECT_EQ(forms[0].find("default")->text, "single");
  EXPECT_EQ(forms[1].find("default")->text, "1 GHz");
}

TEST(JsonSchema, EveryWordHasAMeaning) {
  const Json& words = schemas_of("radar", "window").front()->find("anyOf")->elements.front();
  const std::vector<Json>& meanings = words.find("x-taplo")->find("docs")->find("enumValues")->elements;
  ASSERT_EQ(meanings.size(), words.find("enum")->elements.size());
  EXPECT_EQ(meanings[3].text, "matched filter with a Hamming window");
}

TEST(JsonSchema, LimitsAreThoseOfTheTable) {
  const Json& bits = *schemas_of("recording", "bits").front();
  EXPECT_EQ(bits.find("type")->elements.front().text, "integer");
  EXPECT_EQ(bits.find("minimum")->text, "1");
  EXPECT_EQ(bits.find("maximum")->text, "64");
  const Json& rate = *schemas_of("recording", "sample_rate").front();
  EXPECT_EQ(rate.find("exclusiveMinimum")->text, "true");
}

TEST(JsonSchema, PositionsAreRowsOrAFile) {
  const Json& positions = *schemas_of("target", "positions").front();
  ASSERT_EQ(positions.find("anyOf")->elements.size(), 2U);
  EXPECT_EQ(positions.find("anyOf")->elements.front().find("type")->text, "array");
  EXPECT_EQ(schemas_of("target", "positions.file").front()->find("type")->text, "string");
}

// Filled by `sarsim explain --schema`.
TEST(JsonSchema, TheFileBesideTheDocumentationIsThatOfTheProgram) {
  std::ifstream file(test::source_folder() / "docs/formats/sarsim-2.schema.json");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(text == json_schema() || text == json_schema() + "\n") << "fill it with sarsim explain --schema";
}

}  // namespace json_schema_test
}  // namespace sarsim::scene::language
