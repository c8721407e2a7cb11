#include "scene/language/path_facts.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/value_text.hpp"
#include "scene/schema/unit_table.hpp"
#include "scene/script/order.hpp"

namespace sarsim::scene::language {

namespace {

bool is_within(std::string_view path, std::string_view key) {
  return path.size() > key.size() && path.starts_with(key) && path[key.size()] == '.';
}

bool has_unit(Quantity quantity) { return quantity != Quantity::number && quantity != Quantity::count; }

void add_function(const PlainField& field, std::vector<PathFacts>& paths) {
  const FunctionBlock& block = *field.spec.block;
  for (std::size_t part = 0; part < block.count; ++part) {
    const std::string below =
        block.count == 1 ? std::string(field.spec.key) : fmt::format("{}.{}", field.spec.key, part_key(block, part));
    paths.push_back({fmt::format("{}.{}", below, points_key(block)), PathRole::points, {&field}, part});
    paths.push_back({below + ".interpolation", PathRole::interpolation, {&field}, part});
  }
  paths.push_back({fmt::format("{}.file", field.spec.key), PathRole::file, {&field}});
}

void add_value(const PlainField& field, std::vector<PathFacts>& paths) {
  const FieldSpec& spec = field.spec;
  const std::string key(spec.key.substr(0, spec.key.find('[')));
  const auto known = std::ranges::find(paths, key, &PathFacts::path);
  if (known != paths.end() && key != spec.key) return known->fields.push_back(&field);
  const bool is_choice = spec.type == FieldType::choice && has_words(spec);
  paths.push_back({key, is_choice ? PathRole::choice : PathRole::value, {&field}});
  if (!spec.other_key.key.empty()) paths.push_back({std::string(spec.other_key.key), PathRole::value, {&field}});
}

std::string elements_taken(ListKind kind) {
  std::vector<std::string> keys;
  for (const PlainField& field : element_table(kind).fields) {
    const std::string key(field.spec.key);
    if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  }
  return joined(keys, ", ");
}

// The alternatives of its choice with which a path means something.
std::vector<int> among(const PathFacts& facts) {
  const FieldSpec& spec = facts.spec();
  std::vector<int> values = spec.when.among;
  const OtherKey& other = spec.other_key;
  if (other.key.empty()) return values;
  if (facts.path == other.key) return {other.alternative};
  std::erase(values, other.alternative);
  return values;
}

std::vector<std::string> words_among(const FieldSpec& choice, const std::vector<int>& values) {
  std::vector<std::string> words;
  for (const Choice& alternative : alternatives(choice))
    if (std::ranges::find(values, alternative.value) != values.end()) words.push_back(type_word(alternative));
  return words;
}

}  // namespace

std::string joined(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? last : std::string_view(", ");
    text += words[i];
  }
  return text;
}

std::vector<PathFacts> paths_of(const PlainTable& table) {
  std::vector<PathFacts> paths;
  for (const PlainField& field : table.fields) {
    if (field.spec.key.empty()) continue;
    if (field.spec.block != nullptr)
      add_function(field, paths);
    else
      add_value(field, paths);
  }
  return paths;
}

std::vector<Dependence> dependences(const PlainTable& table, const PathFacts& facts) {
  std::vector<Dependence> found;
  std::vector<int> values = among(facts);
  for (const FieldSpec* spec = &facts.spec(); !values.empty(); values = spec->when.among) {
    const PlainField& choice = table.fields[spec->when.field];
    const bool is_default = choice.initial && is_among(*choice.initial, values);
    found.push_back({std::string(choice.spec.key), words_among(choice.spec, values), is_default});
    spec = &choice.spec;
  }
  return found;
}

std::string dependence_text(const PlainTable& table, const PathFacts& facts) {
  std::string text;
  for (const Dependence& on : dependences(table, facts))
    text += fmt::format("{}{}{} {}", text.empty() ? "" : ", with ", on.choice, table.is_entry ? "" : " of type",
                        joined(on.words));
  return text;
}

const std::vector<std::string>& paths_of(ObjectKind kind) {
  static const auto all = [] {
    std::array<std::vector<std::string>, kind_count> made;
    for (const ObjectKind of : all_object_kinds)
      for (const PathFacts& facts : paths_of(*plain_table(header_of(of)))) {
        std::vector<std::string>& paths = made[static_cast<std::size_t>(of)];
        paths.push_back(facts.path);
        if (facts.role == PathRole::choice) paths.push_back(facts.path + ".type");
      }
    return made;
  }();
  return all[static_cast<std::size_t>(kind)];
}

std::string owner_of(ObjectKind kind, std::string_view path) { return owner_of(*plain_table(header_of(kind)), path); }

std::string owner_of(const PlainTable& table, std::string_view path) {
  std::string text;
  for (const PathFacts& facts : paths_of(table)) {
    if (facts.path != path) continue;
    const std::string one = dependence_text(table, facts);
    if (one.empty()) return {};
    if (text.find(one) == std::string::npos) text += (text.empty() ? "" : ", or ") + one;
  }
  return text;
}

std::vector<Choice> alternatives(const FieldSpec& spec) {
  std::vector<Choice> found;
  for (const Choice& choice : spec.choices)
    if (std::ranges::find(found, choice.value, &Choice::value) == found.end()) found.push_back(choice);
  return found;
}

std::vector<PathFacts> paths_of_alternative(const PlainTable& table, const PathFacts& choice,
                                            const Choice& alternative) {
  std::vector<PathFacts> found;
  for (PathFacts& facts : paths_of(table)) {
    const std::vector<int> values = among(facts);
    const bool depends = !values.empty() && &table.fields[facts.spec().when.field] == &choice.field();
    const bool belongs = depends ? std::ranges::find(values, alternative.value) != values.end()
                                 : values.empty() && is_within(facts.path, choice.path);
    if (belongs) found.push_back(std::move(facts));
  }
  return found;
}

Quantity quantity_of(const PathFacts& facts) {
  switch (facts.role) {
    case PathRole::value: return facts.spec().quantity;
    case PathRole::points: return quantity_of(facts.spec().block->y[facts.part]);
    default: return Quantity::number;
  }
}

Range range_of(const PathFacts& facts) {
  if (facts.role == PathRole::points) return range_of_y(*facts.spec().block);
  const bool is_number = facts.spec().choices.empty() && facts.spec().flags.empty();
  return facts.role == PathRole::value && is_number ? facts.spec().range : any_value;
}

std::string range_words(const Range& range, Quantity quantity) {
  const bool below = range.low > -std::numeric_limits<double>::infinity();
  const bool above = range.high < std::numeric_limits<double>::infinity();
  const std::string low = quantity_text(range.low, quantity);
  const std::string high = quantity_text(range.high, quantity);
  const char* const excluded = range.low_excluded ? "above " : "";
  if (below && above) return fmt::format("{}{} {} {}", excluded, low, range.low_excluded ? "up to" : "to", high);
  if (above) return "up to " + high;
  if (!below) return {};
  return range.low_excluded ? "above " + low : low + " or more";
}

std::string range_text(const PathFacts& facts) {
  if (facts.role == PathRole::value && facts.spec().type == FieldType::seed) return "0 to 18446744073709551615";
  const Quantity quantity = quantity_of(facts);
  std::string text = range_words(range_of(facts), quantity);
  const auto& usable = facts.spec().usable;
  if (facts.role != PathRole::value || !usable || !facts.spec().choices.empty()) return text;
  const Range& allowed = facts.spec().range;
  const std::string needed = range_words(both(allowed, *usable), quantity);
  if (needed == text || needed.empty()) return text;
  return fmt::format("{}{}{} to be simulated", text, text.empty() ? "" : "; ", needed);
}

Range likely_range_of(const PathFacts& facts) {
  if (facts.role == PathRole::points) return likely_y(*facts.spec().block);
  return facts.role == PathRole::value ? facts.spec().likely : any_value;
}

std::string likely_text(const PathFacts& facts) {
  const std::string text = range_words(likely_range_of(facts), quantity_of(facts));
  return text == range_text(facts) ? std::string() : text;
}

std::string meaning_text(const PathFacts& facts) {
  const FieldSpec& spec = facts.spec();
  switch (facts.role) {
    case PathRole::points: {
      const FunctionAxis& y = spec.block->y[facts.part];
      if (spec.block->x_ignored) return std::string(spec.tip);
      return fmt::format("{} The points of {} against {}. Beyond them it {}.", spec.tip, y.name, spec.block->x.name,
                         function_ends(role_of(*spec.block, facts.part)).words);
    }
    case PathRole::interpolation:
      if (spec.block->x_ignored) return "Without effect: the values of a list are taken in turn.";
      return fmt::format("How {} runs between its points.", spec.block->y[facts.part].name);
    case PathRole::file: return fmt::format("{} The points are in this data file.", spec.tip);
    default: return std::string(spec.tip);
  }
}

namespace {

std::string value_noun(const FieldSpec& spec) {
  if (spec.quantity == Quantity::count) return "a whole number";
  return with_article(noun_of(spec.quantity));
}

std::string plural(Quantity quantity) {
  if (quantity == Quantity::frequency) return "frequencies";
  return quantity == Quantity::angle_rate ? "rates of turn" : fmt::format("{}s", noun_of(quantity));
}

[[maybe_unused]] std::string unit_in_brackets(Quantity quantity) {
  return has_unit(quantity) ? fmt::format(" [{}]", units_of(quantity).front()) : std::string();
}

std::string types_listed(const FieldSpec& spec) {
  std::vector<std::string> words;
  for (const Choice& choice : alternatives(spec))
    words.push_back(has_words(spec) ? value_text(spec, choice.value) : type_word(choice));
  return joined(words);
}

std::string points_taken(const PathFacts& facts) {
  const FunctionBlock& block = *facts.spec().block;
  const Quantity y = quantity_of(facts);
  if (block.x_ignored) return fmt::format("an array of {}: [value, value, ...]", plural(y));
  const FunctionAxis& y_axis = block.y[facts.part];
  const auto axis = [](const FunctionAxis& of) {
    return fmt::format("{}{}", of.name, of.unit.empty() ? std::string() : fmt::format(" [{}]", of.unit));
  };
  return fmt::format("an array of points [{}, {}], the first values ascending", axis(block.x), axis(y_axis));
}

std::string vector_taken(const PathFacts& facts) {
  const std::string three = fmt::format("three {}: [x, y, z]", plural(facts.spec().quantity));
  if (facts.path == "positions") return "an array of rows [x, y, z], or { file = \"FILE\" }";
  if (facts.fields.size() > 1) return "an array of three rows [x, y, z]";
  return facts.spec().on_earth ? three + ", or over an Earth { latitude, longitude, height }" : three;
}

// ", MONO, CHIRP or BARKER"
std::string keywords_listed(const FieldSpec& spec) {
  std::vector<std::string> words;
  for (const Choice& choice : spec.choices)
    if (!choice.word.empty()) words.emplace_back(choice.word);
  return ", " + joined(words);
}

std::string flags_listed(const FieldSpec& spec) {
  std::vector<std::string> ids;
  for (const Flag& flag : spec.flags) ids.push_back(fmt::format("\"{}\"", flag.id));
  return joined(ids, " and ");
}

}  // namespace

std::string takes_text(const PathFacts& facts) {
  const FieldSpec& spec = facts.spec();
  switch (facts.role) {
    case PathRole::choice: return "one of " + types_listed(spec);
    case PathRole::points: return points_taken(facts);
    case PathRole::interpolation: return "one of \"linear\", \"cubic\" or \"low-pass\"";
    case PathRole::file: return "the name of a file";
    case PathRole::value: break;
  }
  switch (spec.type) {
    case FieldType::vector: return vector_taken(facts);
    case FieldType::choice: return "one of " + types_listed(spec);
    case FieldType::check: return "true or false";
    case FieldType::flags: return "an array of some of " + flags_listed(spec);
    case FieldType::seed: return "a whole number";
    case FieldType::text: return "a text";
    case FieldType::name: return fmt::format("the name of a {}", spec.refers);
    case FieldType::list: return fmt::format("an array of tables: [{{ {} }}]", elements_taken(spec.list));
    default: break;
  }
  if (facts.fields.size() > 1) return fmt::format("two {}: [start, end]", plural(spec.quantity));
  return value_noun(spec);
}

std::string script_text(const PathFacts& facts) {
  const PlainField& field = facts.field();
  const FieldSpec& spec = field.spec;
  if (!field.in_script.empty()) return std::string(field.in_script);
  if (spec.since_2 || field.command.empty()) return "cannot say it";
  const std::string keywords = facts.role == PathRole::choice ? keywords_listed(spec) : std::string();
  if (field.command == "OPTIONS") return fmt::format("$OPTIONS {}{}", script::option_key(spec), keywords);
  std::string words = fmt::format("{}{}", spec.words, keywords);
  if (facts.fields.size() > 1 && facts.fields.back()->spec.words != spec.words)
    words += fmt::format(", {}", facts.fields.back()->spec.words);
  const std::string head = fmt::format("${}: {}", field.command, words);
  switch (facts.role) {
    case PathRole::points: {
      const std::string_view unit = spec.block->y[facts.part].unit;
      return fmt::format("{}, INLINE points{}", head, unit.empty() ? "" : fmt::format(" in {}", unit));
    }
    case PathRole::interpolation: return head + ", LINEAR, CUBIC or MFILTER";
    case PathRole::file: return head + ", FILE";
    default: break;
  }
  if (spec.type == FieldType::choice && !has_words(spec) && !spec.detail.empty())
    return fmt::format("{}; {}", head, spec.detail);
  const std::string_view unit = script_unit(spec);
  return unit.empty() || spec.type == FieldType::choice ? head : fmt::format("{} in {}", head, unit);
}

std::string label_text(const PathFacts& facts) {
  std::vector<std::string> labels;
  for (const PlainField* field : facts.fields)
    if (!field->labels.empty()) labels.push_back(fmt::format("{}: {}", field->spec.group, joined(field->labels, ", ")));
  return fmt::format("{}", fmt::join(labels, "; "));
}

std::vector<std::string> set_names(const PathFacts& facts) {
  std::vector<std::string> names;
  if (facts.role == PathRole::interpolation) return names;
  for (const PlainField* field : facts.fields)
    names.insert(names.end(), field->set_names.begin(), field->set_names.end());
  return names;
}

}  // namespace sarsim::scene::language
