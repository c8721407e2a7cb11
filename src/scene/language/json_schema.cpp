#include "scene/language/json_schema.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/json.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/language/explanation.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/schema/expression.hpp"

namespace sarsim::scene::language {

namespace {

// Keys of the user's own, for editors that warn of unknown ones.
void write_own_keys(core::JsonWriter& json) {
  // tombi takes no schema that says nothing.
  json.key("patternProperties").begin_object().key("^x-").begin_object();
  json.member("description", "A key of your own, ignored by Sarsim.").end_object().end_object();
}

bool stands_below(const std::string& path, const std::string& prefix) { return path.starts_with(prefix + "."); }

std::string sentence(std::string_view head, const std::string& text) {
  return text.empty() ? std::string() : fmt::format(" {}: {}.", head, text);
}

// What an editor shows beside a key.
std::string description(const PlainTable& table, const PathFacts& facts) {
  const auto units = units_of(quantity_of(facts));
  std::string text = meaning_text(facts);
  text += sentence("Takes", takes_text(facts));
  if (!units.empty()) text += sentence("Unit", std::string(units.front()));
  text += sentence("Range", range_text(facts));
  text += sentence("Default", default_text(facts));
  text += sentence("Applies to", dependence_text(table, facts));
  return text;
}

std::string_view meaning_of(const Choice& choice) { return choice.meaning.empty() ? choice.shown : choice.meaning; }

// What else scenes may call an alternative: that of the language of 1998, where the field's spellings have it.
std::vector<std::string> other_spellings_of(const FieldSpec& spec, const Choice& choice) {
  const std::string old = core::lower_case(choice.word);
  const Choice* const meant = spec.spelling == nullptr ? nullptr : choice_of_type(spec, old);
  const bool is_one = meant != nullptr && old != type_word(choice) && type_word(*meant) == type_word(choice);
  return is_one ? std::vector{old} : std::vector<std::string>{};
}

std::vector<std::string> spellings_of(const FieldSpec& spec, const Choice& choice) {
  std::vector<std::string> words = other_spellings_of(spec, choice);
  words.insert(words.begin(), type_word(choice));
  return words;
}

// Writes the schema of a table. taplo shows each member of an `anyOf` by itself, so each has its own description and
// default.
class SchemaWriter {
 public:
  SchemaWriter(core::JsonWriter& json, const PlainTable& table) : json_(json), table_(table) {}

  void write_table() {
    std::vector<PathFacts> outer;
    const std::vector<PathFacts> all = paths_of(table_);
    for (const PathFacts& facts : all) {
      const bool within = std::ranges::any_of(all, [&](const PathFacts& choice) {
        return choice.role == PathRole::choice && stands_below(facts.path, choice.path);
      });
      if (!within) outer.push_back(facts);
    }
    json_.begin_object().member("type", "object").member("description", table_.meaning);
    write_own_keys(json_);
    json_.key("properties").begin_object();
    write_properties(outer, "");
    json_.end_object().end_object();
  }

 private:
  // The keys directly below a prefix.
  void write_properties(const std::vector<PathFacts>& paths, const std::string& prefix) {
    std::vector<std::string> done;
    for (const PathFacts& facts : paths) {
      if (!prefix.empty() && !stands_below(facts.path, prefix)) continue;
      const std::size_t begin = prefix.empty() ? 0 : prefix.size() + 1;
      std::string path = facts.path.substr(0, facts.path.find('.', begin));
      if (std::ranges::find(done, path) != done.end()) continue;
      json_.key(path.substr(begin));
      write_path(paths, path);
      done.push_back(std::move(path));
    }
  }

  void write_path(const std::vector<PathFacts>& paths, const std::string& path) {
    const auto own = std::ranges::find(paths, path, &PathFacts::path);
    const bool is_table =
        std::ranges::any_of(paths, [&](const PathFacts& other) { return stands_below(other.path, path); });
    if (own == paths.end()) return write_inner_table(paths, path);
    json_.begin_object();
    write_head(*own);
    if (own->role == PathRole::choice) {
      write_choice(*own);
    } else if (is_table) {
      json_.key("anyOf").begin_array().begin_object();
      write_head(*own);
      write_value(*own);
      json_.end_object();
      write_inner_table(paths, path);
      json_.end_array();
    } else {
      write_value(*own);
    }
    json_.end_object();
  }

  void write_head(const PathFacts& facts) {
    json_.member("description", description(table_, facts));
    write_default(facts);
  }

  // Described as its points, or whatever comes first in it, are.
  void write_inner_table(const std::vector<PathFacts>& paths, const std::string& path) {
    json_.begin_object().member("type", "object");
    auto first = std::ranges::find(paths, path + ".points", &PathFacts::path);
    if (first == paths.end())
      first = std::ranges::find_if(paths, [&](const PathFacts& facts) { return stands_below(facts.path, path); });
    if (first != paths.end()) json_.member("description", meaning_text(*first));
    write_own_keys(json_);
    json_.key("properties").begin_object();
    write_properties(paths, path);
    json_.end_object().end_object();
  }

  // A word, the value that stands for the first alternative, or a table with `type`.
  void write_choice(const PathFacts& choice) {
    json_.key("anyOf").begin_array();
    json_.begin_object();
    write_head(choice);
    write_enumeration(choice.spec());
    json_.end_object();
    const std::vector<PathFacts> all = paths_of(table_);
    const auto standing = std::ranges::find(all, choice.field().shorthand, &PathFacts::path);
    if (standing != all.end()) {
      json_.begin_object();
      write_head(*standing);
      write_value(*standing);
      json_.end_object();
    }
    write_choice_table(choice);
    json_.end_array();
  }

  // The alternatives that are more than a word.
  [[nodiscard]] std::vector<Choice> table_alternatives(const PathFacts& choice) const {
    std::vector<Choice> tables = alternatives(choice.spec());
    std::erase_if(tables, [&](const Choice& alternative) {
      return alternative.value >= first_added_value && paths_of_alternative(table_, choice, alternative).empty();
    });
    return tables;
  }

  // tombi offers the words of `type` only where they stand together, before the alternatives.
  void write_choice_table(const PathFacts& choice) {
    const std::vector<Choice> tables = table_alternatives(choice);
    if (tables.empty()) return;
    json_.begin_object().member("type", "object").member("description", description(table_, choice));
    json_.key("required").begin_array().value("type").end_array();
    json_.key("properties").begin_object().key("type").begin_object();
    json_.member("description", description(table_, choice));
    write_words(choice.spec(), tables);
    json_.end_object().end_object();
    json_.key("anyOf").begin_array();
    for (const Choice& alternative : tables) write_alternative(choice, alternative);
    json_.end_array().end_object();
  }

  void write_alternative(const PathFacts& choice, const Choice& alternative) {
    json_.begin_object().member("type", "object").member("description", meaning_of(alternative));
    json_.key("required").begin_array().value("type").end_array();
    write_own_keys(json_);
    json_.key("properties").begin_object();
    json_.key("type").begin_object().member("description", meaning_of(alternative));
    // With it, taplo writes the table out.
    json_.member("default", type_word(alternative));
    json_.key("enum").begin_array();
    for (const std::string& word : spellings_of(choice.spec(), alternative)) json_.value(word);
    json_.end_array().end_object();
    write_properties(paths_of_alternative(table_, choice, alternative), choice.path);
    json_.end_object().end_object();
  }

  void write_enumeration(const FieldSpec& spec) { write_words(spec, alternatives(spec)); }

  void write_words(const FieldSpec& spec, const std::vector<Choice>& choices) {
    json_.key("enum").begin_array();
    for (const Choice& choice : choices) write_word(spec, choice);
    for (const Choice& choice : choices)
      for (const std::string& word : other_spellings_of(spec, choice)) json_.value(word);
    json_.end_array();
    if (std::ranges::all_of(choices, &std::string_view::empty, &Choice::meaning)) return;
    // What taplo shows beside each word.
    json_.key("x-taplo").begin_object().key("docs").begin_object().key("enumValues").begin_array();
    for (const Choice& choice : choices) json_.value(meaning_of(choice));
    for (const Choice& choice : choices)
      for (std::size_t i = 0; i < other_spellings_of(spec, choice).size(); ++i) json_.value(meaning_of(choice));
    json_.end_array().end_object().end_object();
  }

  void write_word(const FieldSpec& spec, const Choice& choice) {
    const auto number = core::parse_integer(type_word(choice));
    if (number && !has_words(spec))
      json_.value(*number);
    else
      json_.value(type_word(choice));
  }

  void write_value(const PathFacts& facts) {
    const FieldSpec& spec = facts.spec();
    if (facts.role == PathRole::points) return write_points(facts);
    if (facts.role == PathRole::file) return write_type("string");
    if (facts.role == PathRole::interpolation) {
      json_.key("enum").begin_array().value("linear").value("cubic").value("low-pass").end_array();
      return;
    }
    switch (spec.type) {
      case FieldType::vector: return write_vectors(facts);
      case FieldType::choice: return write_enumeration(spec);
      case FieldType::check: return write_type("boolean");
      case FieldType::flags: return write_flags(facts);
      case FieldType::text:
      case FieldType::name: return write_type("string");
      case FieldType::seed: return write_number("integer", zero_or_more);
      case FieldType::list: return write_list(spec.list);
      default: break;
    }
    if (facts.fields.size() == 1)
      return write_number(spec.quantity == Quantity::count ? "integer" : "number", spec.range);
    write_array(facts.fields.size(), [&] { write_number("number", spec.range); });
  }

  void write_type(const char* type) { json_.member("type", type); }

  // A number within limits, or an expression. Limits do not concern texts.
  void write_number(const char* type, const Range& range) {
    json_.key("type").begin_array().value(type).value("string").end_array();
    if (std::isfinite(range.low)) json_.member("minimum", range.low);
    if (std::isfinite(range.low) && range.low_excluded) json_.member("exclusiveMinimum", true);
    if (std::isfinite(range.high)) json_.member("maximum", range.high);
  }

  // @param count  of elements; 0: any
  template <class WriteElement>
  void write_array(std::size_t count, const WriteElement& element) {
    json_.member("type", "array");
    if (count != 0) json_.member("minItems", count).member("maxItems", count);
    json_.key("items").begin_object();
    element();
    json_.end_object();
  }

  // [x, y, z], or a place on the Earth.
  void write_vector(const FieldSpec& spec) {
    const auto three = [&] { write_array(3, [&] { write_number("number", spec.range); }); };
    if (!spec.on_earth) return three();
    json_.key("anyOf").begin_array().begin_object();
    json_.member("description", "World coordinates.");
    three();
    json_.end_object().begin_object().member("type", "object");
    json_.member("description", "A place on the Earth: WGS 84, height above the ellipsoid or altitude above the sea.");
    json_.key("required").begin_array().value("latitude").value("longitude").end_array();
    json_.key("properties").begin_object();
    for (const char* const key : {"latitude", "longitude", "height", "altitude"}) {
      json_.key(key).begin_object();
      write_number("number", key == std::string_view("latitude") ? Range{-90.0, 90.0} : any_value);
      json_.end_object();
    }
    json_.end_object().end_object().end_array();
  }

  void write_vectors(const PathFacts& facts) {
    const auto vector = [&] { write_vector(facts.spec()); };
    if (facts.path == "positions") return write_array(0, vector);
    if (facts.fields.size() > 1) return write_array(facts.fields.size(), vector);
    vector();
  }

  void write_list(ListKind kind) {
    json_.member("type", "array").key("items");
    SchemaWriter(json_, element_table(kind)).write_table();
  }

  void write_points(const PathFacts& facts) {
    const Range range = range_of(facts);
    const auto number = [&] { write_number("number", any_value); };
    if (facts.spec().block->x_ignored)
      write_array(0, [&] { write_number("number", range); });
    else
      write_array(0, [&] { write_array(2, number); });
  }

  // Their names, or their sum.
  void write_flags(const PathFacts& facts) {
    const FieldSpec& spec = facts.spec();
    json_.key("anyOf").begin_array().begin_object();
    write_head(facts);
    write_array(0, [&] {
      json_.key("enum").begin_array();
      for (const Flag& flag : spec.flags) json_.value(flag.id);
      json_.end_array();
    });
    json_.end_object().begin_object();
    json_.member("description", description(table_, facts)).member("type", "integer");
    json_.member("minimum", spec.range.low).member("maximum", spec.range.high).end_object().end_array();
  }

  void write_default(const PathFacts& facts) {
    if (default_text(facts).empty()) return;
    json_.key("default");
    if (facts.role == PathRole::interpolation) {
      json_.value("linear");
      return;
    }
    if (facts.fields.size() == 1) return write_initial(facts.field());
    json_.begin_array();
    for (const PlainField* field : facts.fields) write_initial(*field);
    json_.end_array();
  }

  void write_initial(const PlainField& field) {
    const FieldSpec& spec = field.spec;
    const FieldValue& value = *field.initial;
    if (spec.type == FieldType::choice) return write_chosen(spec, chosen(value));
    if (spec.type == FieldType::flags) return write_set_flags(spec, static_cast<unsigned>(chosen(value)));
    if (const auto* const vector = std::get_if<core::Vec3>(&value))
      json_.begin_array().value(vector->x).value(vector->y).value(vector->z).end_array();
    else if (const auto* const number = std::get_if<double>(&value))
      write_quantity(*number, spec.quantity);
    else if (const auto* const text = std::get_if<std::string>(&value))
      json_.value(*text);
    else if (const auto* const yes = std::get_if<bool>(&value))
      json_.value(*yes);
    else
      json_.value(std::get<std::uint64_t>(value));
  }

  void write_chosen(const FieldSpec& spec, int value) {
    for (const Choice& choice : alternatives(spec))
      if (choice.value == value) return write_word(spec, choice);
    json_.null();
  }

  void write_set_flags(const FieldSpec& spec, unsigned bits) {
    json_.begin_array();
    for (const Flag& flag : spec.flags)
      if ((bits & flag.bit) != 0) json_.value(flag.id);
    json_.end_array();
  }

  void write_quantity(double number, Quantity quantity) {
    if (quantity == Quantity::number || quantity == Quantity::count)
      json_.value(number);
    else
      json_.value(exact_quantity_text(number, quantity));
  }

  core::JsonWriter& json_;
  const PlainTable& table_;
};

void write_general(core::JsonWriter& json) {
  json.key("format").begin_object().member("description", explain("format").meaning);
  json.key("enum").begin_array().value(format_2_mark).end_array().end_object();
  json.key("include").begin_object().member("description", explain("include").meaning).member("type", "array");
  json.key("items").begin_object().member("type", "string").end_object().end_object();
  json.key("let").begin_object().member("description", explain("let").meaning).member("type", "object");
  json.key("additionalProperties").begin_object().key("type").begin_array().value("number").value("string");
  json.end_array().end_object().end_object();
}

}  // namespace

std::string json_schema() {
  core::JsonWriter json;
  json.begin_object().member("$schema", "http://json-schema.org/draft-04/schema#");
  json.member("title", "Sarsim scene, format 2").member("description", "A radar scene: platforms, targets and radars.");
  json.member("type", "object").key("required").begin_array().value("format").end_array();
  write_own_keys(json);
  json.key("properties").begin_object();
  write_general(json);
  for (const PlainTable& table : plain_tables()) {
    json.key(table.header);
    if (table.is_list) json.begin_object().member("type", "array").member("description", table.meaning).key("items");
    SchemaWriter(json, table).write_table();
    if (table.is_list) json.end_object();
  }
  json.end_object().end_object();
  return json.text();
}

}  // namespace sarsim::scene::language
