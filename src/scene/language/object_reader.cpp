#include "scene/language/object_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/toml/values.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/grammar.hpp"
#include "scene/schema/trade_words.hpp"

namespace sarsim::scene::language {

namespace toml = core::toml;

namespace {

// A key of the user's own, which is kept and means nothing.
bool is_private(std::string_view path) { return path.starts_with("x-") || path.find(".x-") != std::string_view::npos; }

std::string words_listed(const FieldSpec& spec) {
  std::string text;
  std::vector<std::string> words;
  std::vector<int> values;
  for (const Choice& choice : spec.choices) {
    if (std::ranges::find(values, choice.value) == values.end()) words.push_back(type_word(choice));
    values.push_back(choice.value);
  }
  for (const std::string_view other : spec.other_types) words.emplace_back(other);
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::string quantity_noun(const FieldSpec& spec) {
  if (spec.quantity == Quantity::count) return "a whole number";
  if (spec.quantity == Quantity::number) return "a number";
  return fmt::format("{}, as \"{}\"", dimension_text(dimension_of(spec.quantity)),
                     exact_quantity_text(1.0, spec.quantity));
}

bool is_number(toml::Kind kind) { return kind == toml::Kind::integer || kind == toml::Kind::floating; }

}  // namespace

std::string_view noun_of(toml::Kind kind) {
  switch (kind) {
    case toml::Kind::string: return "a string";
    case toml::Kind::integer:
    case toml::Kind::floating: return "a number";
    case toml::Kind::boolean: return "true or false";
    case toml::Kind::array: return "an array";
    case toml::Kind::table: return "a table";
    default: return "a date or time";
  }
}

ObjectReader::ObjectReader(Reading& reading, const Source& source, toml::Lines& lines, ObjectText& text,
                           std::string_view kind, std::size_t index)
    : reading_(reading), source_(source), lines_(lines), text_(text), kind_(kind), index_(index) {
  reading_.places.begin_object(kind_, index_, source_.file);
}

void ObjectReader::add(core::Severity severity, toml::Span at, std::string_view field, script::Complaint complaint) {
  const toml::Position position = lines_.at(at.begin);
  if (!entry_.empty() && !complaint.message.starts_with(entry_))
    complaint.message = fmt::format("{}: {}", entry_, complaint.message);
  reading_.log.add(core::ProblemBuilder(severity, std::move(complaint.message))
                       .found(std::move(complaint.found))
                       .expected(std::move(complaint.expected))
                       .hint(std::move(complaint.hint))
                       .in(source_.file, position.line, position.column)
                       .at(std::string(kind_), index_, std::string(list_field_.empty() ? field : list_field_)));
}

void ObjectReader::error(toml::Span at, std::string_view field, script::Complaint complaint) {
  add(core::Severity::error, at, field, std::move(complaint));
}

void ObjectReader::warning(toml::Span at, std::string_view field, script::Complaint complaint) {
  add(core::Severity::warning, at, field, std::move(complaint));
}

void ObjectReader::note_place(std::string_view field, toml::Span at) {
  if (!list_field_.empty()) return;
  const toml::Position position = lines_.at(at.begin);
  reading_.places.add_field(field, position.line, position.column);
}

Leaf* ObjectReader::find(std::string_view path) {
  Leaf* const leaf = text_.find(path);
  if (leaf != nullptr) leaf->used = true;
  return leaf;
}

bool ObjectReader::says_anything_of(std::string_view key) const {
  const std::string_view base = key.substr(0, key.find('['));
  return std::ranges::any_of(text_.leaves, [&](const Leaf& leaf) { return is_below(leaf.path, base); });
}

bool ObjectReader::check_number(const FieldSpec& spec, toml::Span at, double number, bool bare) {
  if (!computable(number)) {
    error(at, spec.problem_place(),
          {fmt::format("{} is too large to compute with", spec.words), script::shown(text_of(at)),
           fmt::format("a magnitude up to {:g}", largest_value)});
    return false;
  }
  if (!spec.range.holds(number)) {
    error(at, spec.problem_place(),
          {fmt::format("{} is out of range", spec.words), script::shown(text_of(at)),
           fmt::format("{}{}", quantity_noun(spec), script::range_text(spec.range))});
    return false;
  }
  const bool unusual = number != 0.0 && !spec.likely.holds(number);
  if (unusual)
    warning(at, spec.problem_place(),
            {fmt::format("{} of {} is unusual", spec.words, quantity_text(number, spec.quantity)), "",
             fmt::format("{} to {}", quantity_text(spec.likely.low, spec.quantity),
                         quantity_text(spec.likely.high, spec.quantity)),
             bare ? "is a unit missing?" : ""});
  return true;
}

bool ObjectReader::expression_in(const FieldSpec& spec, const toml::Value& value, double& number) {
  const std::string text = toml::decoded_string(source_.text, value);
  QuantityResult result = evaluate(text, spec.quantity, reading_.names);
  if (result.value) {
    if (!check_number(spec, value.span, *result.value, result.bare)) return false;
    number = *result.value;
    return true;
  }
  ExpressionFault& fault = *result.fault;
  if (fault.follows) return false;
  if (result.other)
    if (std::string hint = conversion_hint(spec, text, *result.other, carrier_hz()); !hint.empty())
      fault.hint = std::move(hint);
  // A string without escapes stands in the text as it is, behind its quote.
  toml::Span at = value.span;
  if (text_of(value.span).find(text) == 1) {
    at.begin += static_cast<std::uint32_t>(fault.begin) + 1;
    at.end = value.span.begin + static_cast<std::uint32_t>(fault.end) + 1;
  }
  error(at, spec.problem_place(),
        {fmt::format("{}: {}", spec.words, fault.message), "", std::move(fault.expected), std::move(fault.hint)});
  return false;
}

bool ObjectReader::number_in(const FieldSpec& spec, const toml::Value& value, double& number) {
  if (value.kind == toml::Kind::string) return expression_in(spec, value, number);
  if (!is_number(value.kind)) {
    error(value.span, spec.problem_place(),
          {fmt::format("{} is not a number", spec.words), std::string(noun_of(value.kind)), quantity_noun(spec)});
    return false;
  }
  const double read = toml::number(source_.text, value).value_or(0.0);
  if (!std::isfinite(read)) {
    error(value.span, spec.problem_place(),
          {fmt::format("{} is not finite", spec.words), script::shown(text_of(value.span)), quantity_noun(spec)});
    return false;
  }
  if (spec.quantity == Quantity::count && read != std::floor(read)) {
    error(value.span, spec.problem_place(),
          {fmt::format("{} is not a whole number", spec.words), script::shown(text_of(value.span)), "a whole number"});
    return false;
  }
  const bool has_unit = spec.quantity != Quantity::number && spec.quantity != Quantity::count;
  if (!check_number(spec, value.span, read, has_unit)) return false;
  number = read;
  return true;
}

bool ObjectReader::read_number(const FieldSpec& spec, const Leaf& leaf, double& number) {
  note_place(spec.problem_place(), leaf.value.span);
  return number_in(spec, leaf.value, number);
}

bool ObjectReader::read_vector(const FieldSpec& spec, const toml::Value& value, core::Vec3& vector) {
  if (value.kind == toml::Kind::table && spec.on_earth) return read_place(spec, value, vector);
  std::array<double, 3> numbers{vector.x, vector.y, vector.z};
  std::size_t count = 0;
  bool sound = value.kind == toml::Kind::array;
  toml::Elements elements(source_.text, value);
  while (const auto element = elements.next()) {
    if (count < numbers.size()) sound = number_in(spec, element->value, numbers[count]) && sound;
    ++count;
  }
  if (value.kind != toml::Kind::array || count != numbers.size())
    error(value.span, spec.problem_place(),
          {fmt::format("{} needs three numbers", spec.words),
           value.kind == toml::Kind::array ? fmt::format("{} of them", count) : std::string(noun_of(value.kind)),
           "[x, y, z]"});
  if (!sound || count != numbers.size()) return false;
  vector = {numbers[0], numbers[1], numbers[2]};
  return true;
}

// One of several values that share an array: "range[1]".
bool ObjectReader::read_listed(const FieldSpec& spec, std::string_view key, FieldValue& value) {
  const std::size_t bracket = key.find('[');
  const auto wanted = static_cast<std::size_t>(key[bracket + 1] - '0');
  Leaf* const leaf = find(key.substr(0, bracket));
  if (leaf == nullptr) return false;
  const std::size_t size = spec.type == FieldType::vector ? 3 : 2;
  toml::Elements elements(source_.text, leaf->value);
  std::optional<toml::Value> element;
  std::size_t count = 0;
  for (; const auto next = elements.next(); ++count)
    if (count == wanted) element = next->value;
  if (leaf->value.kind != toml::Kind::array || count != size) {
    if (wanted == 0)
      error(leaf->value.span, spec.problem_place(),
            {fmt::format("{} needs {} values", leaf->path, size),
             leaf->value.kind == toml::Kind::array ? fmt::format("{} of them", count)
                                                   : std::string(noun_of(leaf->value.kind)),
             spec.type == FieldType::vector ? "[[x, y, z], [x, y, z], [x, y, z]]" : "[start, end]"});
    return false;
  }
  note_place(spec.problem_place(), element->span);
  if (auto* const vector = std::get_if<core::Vec3>(&value)) return read_vector(spec, *element, *vector);
  return number_in(spec, *element, std::get<double>(value));
}

bool ObjectReader::read_text(const FieldSpec& spec, const Leaf& leaf, FieldValue& value) {
  if (leaf.value.kind != toml::Kind::string) {
    error(leaf.value.span, spec.problem_place(),
          {fmt::format("{} is not a string", spec.words), std::string(noun_of(leaf.value.kind)), "text in quotes"});
    return false;
  }
  std::string text = toml::decoded_string(source_.text, leaf.value);
  const bool control = std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (text.empty() || control) {
    error(leaf.value.span, spec.problem_place(),
          {std::string(spec.words) + (control ? " holds control characters" : " is empty"), "", "a name"});
    return false;
  }
  value = std::move(text);
  return true;
}

bool ObjectReader::read_seed(const FieldSpec& spec, const Leaf& leaf, FieldValue& value) {
  const std::string text = leaf.value.kind == toml::Kind::string ? toml::decoded_string(source_.text, leaf.value)
                                                                 : std::string(text_of(leaf.value.span));
  std::uint64_t seed = 0;
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos && text.size() <= 20;
  bool fits = digits;
  for (std::size_t i = 0; fits && i < text.size(); ++i) {
    const auto digit = static_cast<std::uint64_t>(text[i] - '0');
    fits = seed <= (~std::uint64_t{0} - digit) / 10;
    seed = 10 * seed + digit;
  }
  if (!fits) {
    error(leaf.value.span, spec.problem_place(),
          {fmt::format("{} is not a whole number", spec.words), script::shown(text), "0 to 18446744073709551615"});
    return false;
  }
  value = seed;
  return true;
}

bool ObjectReader::read_flags(const FieldSpec& spec, const Leaf& leaf, FieldValue& value) {
  if (leaf.value.kind != toml::Kind::array) {
    FieldSpec whole = spec;
    whole.quantity = Quantity::count;
    return number_in(whole, leaf.value, std::get<double>(value));
  }
  unsigned bits = 0;
  bool sound = true;
  toml::Elements elements(source_.text, leaf.value);
  while (const auto element = elements.next()) {
    const std::string word = toml::decoded_string(source_.text, element->value);
    const auto flag = std::ranges::find(spec.flags, word, &Flag::id);
    if (flag != spec.flags.end()) {
      bits |= flag->bit;
      continue;
    }
    std::vector<std::string_view> ids;
    std::string listed;
    for (const Flag& known : spec.flags) {
      ids.push_back(known.id);
      listed += (listed.empty() ? "" : ", ") + std::string(known.id);
    }
    const std::string near = core::nearest_word(word, ids);
    error(element->value.span, spec.problem_place(),
          {fmt::format("{} has an unknown entry", leaf.path), script::shown(text_of(element->value.span)), listed,
           near.empty() ? "" : fmt::format("did you mean \"{}\"?", near)});
    sound = false;
  }
  if (sound) value = static_cast<double>(bits);
  return sound;
}

// The alternative that a string or a number names.
bool ObjectReader::choose_word(const FieldSpec& spec, const Leaf& leaf, FieldValue& value) {
  const std::string word = leaf.value.kind == toml::Kind::string ? toml::decoded_string(source_.text, leaf.value)
                                                                 : std::string(text_of(leaf.value.span));
  if (const Choice* const choice = choice_of_type(spec, word)) {
    choose(value, choice->value);
    return true;
  }
  std::vector<std::string> words;
  for (const Choice& choice : spec.choices) words.push_back(type_word(choice));
  for (const std::string_view other : spec.other_types) words.emplace_back(other);
  const TradeChoice* const of_trade =
      trade_choice(leaf.value.kind == toml::Kind::array ? std::string_view("[]") : word, spec.key);
  const std::string near = of_trade != nullptr ? std::string() : core::nearest_word(word, words);
  error(leaf.value.span, spec.problem_place(),
        {fmt::format("unknown {}", spec.words), script::shown(text_of(leaf.value.span)), words_listed(spec),
         of_trade != nullptr ? trade_advice(*of_trade)
         : near.empty()      ? ""
                             : fmt::format("did you mean \"{}\"?", near)});
  return false;
}

// A word, a table with `type`, or the value that stands for the first alternative.
bool ObjectReader::read_choice(const FieldSpec& spec, std::string_view key, const FieldSpec* shorthand,
                               FieldValue& value) {
  const std::string type_path = std::string(key) + ".type";
  Leaf* const type = text_.find(type_path);
  if (type != nullptr && type->used) return false;  // read already, as a further type of format 2
  if (type != nullptr) type->used = true;
  Leaf* const leaf = find(key);
  const bool sound_type =
      type == nullptr || (note_place(spec.problem_place(), type->value.span), choose_word(spec, *type, value));
  if (!sound_type) text_.use_all_below(key);
  if (type != nullptr) return sound_type;
  if (leaf != nullptr) note_place(spec.problem_place(), leaf->value.span);
  if (leaf == nullptr || leaf->value.kind == toml::Kind::table) {
    error(leaf == nullptr ? text_.header : leaf->key, spec.problem_place(),
          {fmt::format("{} has no type", key), "", fmt::format("type = {}", words_listed(spec))});
    text_.use_all_below(key);
    return false;
  }
  const std::string word = toml::decoded_string(source_.text, leaf->value);
  const bool is_word = !has_words(spec) || choice_of_type(spec, word) != nullptr;
  const bool looks_like_word = !reading_.names.contains(word) && !word.empty() &&
                               std::ranges::all_of(word, [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
  const bool is_list = leaf->value.kind == toml::Kind::array && trade_choice("[]", spec.key) != nullptr;
  if (shorthand == nullptr || is_word || looks_like_word || is_list) return choose_word(spec, *leaf, value);
  // The object's own member is read by its field, which comes behind: it finds the value under its own path.
  choose(value, spec.choices.front().value);
  text_.leaves.push_back({shorthand->key, leaf->key, leaf->value});
  return true;
}

bool ObjectReader::read_value(const FieldSpec& spec, std::string_view key, const FieldSpec* shorthand,
                              FieldValue& value) {
  if (key.ends_with(']')) return read_listed(spec, key, value);
  const bool is_alternative = spec.type == FieldType::check && spec.choices.size() == 1;
  if (is_alternative) {  // "same" is a word of the choice that has the same key.
    Leaf* const leaf = text_.find(key);
    const bool chosen = leaf != nullptr && leaf->value.kind == toml::Kind::string &&
                        toml::decoded_string(source_.text, leaf->value) == type_word(spec.choices.front());
    if (chosen) leaf->used = true;
    choose(value, chosen ? spec.choices.front().value : 1 - spec.choices.front().value);
    return true;
  }
  if (spec.type == FieldType::choice && has_words(spec)) return read_choice(spec, key, shorthand, value);
  Leaf* const leaf = find(key);
  if (leaf == nullptr) return false;
  note_place(spec.problem_place(), leaf->value.span);
  switch (spec.type) {
    case FieldType::choice: return choose_word(spec, *leaf, value);
    case FieldType::vector: return read_vector(spec, leaf->value, std::get<core::Vec3>(value));
    case FieldType::seed: return read_seed(spec, *leaf, value);
    case FieldType::flags: return read_flags(spec, *leaf, value);
    case FieldType::text:
    case FieldType::name: return read_text(spec, *leaf, value);
    case FieldType::check:
      if (const auto yes = toml::boolean(source_.text, leaf->value)) {
        value = *yes;
        return true;
      }
      error(leaf->value.span, spec.problem_place(),
            {fmt::format("{} is not a yes or no", spec.words), script::shown(text_of(leaf->value.span)),
             "true or false"});
      return false;
    default: return number_in(spec, leaf->value, std::get<double>(value));
  }
}

// A plain value, or a list on one line, as it was typed; empty for others.
std::string ObjectReader::value_text(const toml::Value& value) const {
  if (value.kind == toml::Kind::string) return toml::decoded_string(source_.text, value);
  const std::string_view text = text_of(value.span);
  const bool is_list = value.kind == toml::Kind::array && text.find('\n') == std::string_view::npos;
  return is_number(value.kind) || is_list ? std::string(text) : std::string();
}

// What the trade means by a path: all of it ("antenna.length"), or its last word.
std::string ObjectReader::trade_remedy(const Leaf& leaf, std::string_view last) const {
  if (entries_ != nullptr) return {};
  const TradeWord* const whole = last == leaf.path ? nullptr : trade_word(leaf.path, text_.kind);
  const TradeWord* const word = whole != nullptr ? whole : trade_word(last, text_.kind);
  return word == nullptr ? std::string() : advice_on(*word, leaf, last);
}

std::string ObjectReader::advice_on(const TradeWord& word, const Leaf& leaf, std::string_view last) const {
  // What belongs to another type of the table has to be written with that type.
  const std::string_view table = table_of_word(word);
  const Leaf* const type = table.empty() ? nullptr : text_.find(fmt::format("{}.type", table));
  const bool has_table = type != nullptr && word.line.find(fmt::format("type = \"{}\"", value_text(type->value))) !=
                                                std::string_view::npos;
  return trade_advice(word, {last, text_.kind, value_text(leaf.value), carrier_hz(), has_table});
}

// Of the radar that is read, as far as its text says it.
std::optional<double> ObjectReader::carrier_hz() const {
  if (text_.kind != "radar") return std::nullopt;
  for (const char* const path : {"carrier", "carrier.frequency", "carrier.first"})
    if (const Leaf* const leaf = text_.find(path); leaf != nullptr)
      if (const auto hz = evaluate(value_text(leaf->value), Quantity::frequency, reading_.names).value) return hz;
  return std::nullopt;
}

// What to do about a path that nothing has.
std::string ObjectReader::remedy(const Leaf& leaf, const std::vector<std::string>& known) const {
  const std::string_view path = leaf.path;
  const std::string_view last = path.substr(path.rfind('.') + 1);
  if (last == "include" || last == "format") return fmt::format("{} comes before the first header", last);
  if (last != path && std::ranges::find(known, last) != known.end())
    return fmt::format("'{}' is a field of {}: move it above the header of the table it stands in", last, text_.kind);
  if (std::string meant = trade_remedy(leaf, last); !meant.empty()) return meant;
  if (const std::string near = core::nearest_word(path, known); !near.empty() && near != path)
    return fmt::format("did you mean '{}'?", near);
  const std::string below = fmt::format(".{}", last);
  if (const auto deeper = std::ranges::find_if(known, [&](const auto& one) { return one.ends_with(below); });
      deeper != known.end())
    return fmt::format("it is called '{}'", *deeper);
  std::string hint;
  for_each_kind([&](const auto& kind) {
    const auto& paths = paths_of(kind.kind);
    if (hint.empty() && std::ranges::find(paths, last) != paths.end())
      hint = fmt::format("'{}' is a field of {}", last, header_of(kind.kind));
  });
  if (!hint.empty()) return hint;
  if (const TradeWord* const word = entries_ == nullptr ? nearest_trade_word(last, text_.kind) : nullptr)
    return advice_on(*word, leaf, last);
  return "your own fields must begin with x-; or the file was written for a newer Sarsim";
}

void ObjectReader::report_unknown(const Leaf& leaf, const std::string& belongs, const std::vector<std::string>& known) {
  if (!belongs.empty())
    return error(leaf.key, "",
                 {fmt::format("'{}' does not apply here", script::shown(leaf.path)), "", "",
                  fmt::format("it belongs to {}", belongs)});
  const std::string_view name = leaf.is_header ? text_of(leaf.key) : leaf.path;
  error(leaf.key, "",
        {fmt::format("{} has no field '{}'", text_.kind.empty() ? "the scene" : text_.kind, script::shown(name)), "",
         "", remedy(leaf, known)});
}

void ObjectReader::finish(const std::vector<std::string>& known) {
  for (std::size_t i = 0; i < text_.leaves.size() && !reading_.log.full(); ++i) {
    const Leaf leaf = text_.leaves[i];
    if (leaf.used || is_private(leaf.path)) continue;
    const bool is_known_table = leaf.value.kind == toml::Kind::table &&
                                std::ranges::any_of(known, [&](const auto& path) { return is_below(path, leaf.path); });
    if (is_known_table) continue;
    const PlainTable* const table = is_single(text_.kind) ? plain_table(text_.kind) : entries_;
    report_unknown(leaf, table != nullptr ? owner_of(*table, leaf.path) : std::string(), known);
    if (leaf.value.kind == toml::Kind::table) text_.use_all_below(leaf.path);
  }
}

void ObjectReader::finish(ObjectKind kind) {
  // The names of all fields take 2 ms to list: only what is wrong needs them.
  const bool is_plain = std::ranges::all_of(text_.leaves, [this](const Leaf& leaf) {
    return leaf.used && !(leaf.is_header && text_of(leaf.key).starts_with("[["));
  });
  if (is_plain) return;
  const std::vector<std::string>& known = paths_of(kind);
  for (std::size_t i = 0; i < text_.leaves.size() && !reading_.log.full(); ++i) {
    const Leaf leaf = text_.leaves[i];
    const auto within = [&](const std::string& path) { return is_below(path, leaf.path); };
    if (leaf.is_header && text_of(leaf.key).starts_with("[[") && std::ranges::any_of(known, within))
      error(leaf.key, "",
            {"there is one such table", script::shown(text_of(leaf.key)), fmt::format("[{}.{}]", text_.kind, leaf.path),
             "write single brackets"});
    if (leaf.used || is_private(leaf.path) || leaf.value.kind == toml::Kind::table) continue;
    if (std::ranges::find(known, leaf.path) == known.end()) continue;
    if (const std::string owner = owner_of(kind, leaf.path); !owner.empty()) {
      report_unknown(leaf, owner, {});
      text_.leaves[i].used = true;
    }
  }
  const bool all_used = std::ranges::all_of(text_.leaves, &Leaf::used);
  if (!all_used) finish(known);
}

// --- The user-defined functions of objects.

namespace {

// An axis of a function as a field, to read its numbers by.
FieldSpec axis_spec(const FieldSpec& of, const FunctionAxis& axis, const Range& range) {
  FieldSpec spec;
  spec.id = of.problem_place();
  spec.words = axis.name;
  spec.quantity = quantity_of(axis);
  spec.range = range;
  return spec;
}

}  // namespace

void ObjectReader::read_function(const FieldSpec& spec, std::string_view key, const FunctionRef& function) {
  if (!says_anything_of(key)) return;
  const FunctionBlock& block = *spec.block;
  if (Leaf* const table = text_.find(key); table != nullptr && table->value.kind == toml::Kind::table)
    note_place(spec.problem_place(), table->key);
  Leaf* const file = find(std::string(key) + ".file");
  for (std::size_t part = 0; part < block.count; ++part) {
    std::string below(key);
    if (block.count > 1) below += "." + part_key(block, part);
    if (Leaf* const table = text_.find(below); table != nullptr && table->value.kind == toml::Kind::table)
      table->used = true;
    read_part(spec, below, part, function.parts[part]);
  }
  if (file != nullptr) read_function_file(spec, *file, function);
}

void ObjectReader::read_part(const FieldSpec& spec, const std::string& key, std::size_t part,
                             core::SampledFunction& function) {
  if (Leaf* const leaf = find(key + ".interpolation")) {
    const std::string word = toml::decoded_string(source_.text, leaf->value);
    const auto known = std::ranges::find_if(
        script::interpolations, [&](const auto& alternative) { return interpolation_word(alternative.value) == word; });
    if (known != script::interpolations.end())
      function.method = known->value;
    else
      error(leaf->value.span, spec.problem_place(),
            {fmt::format("unknown interpolation of {}", spec.block->y[part].name),
             script::shown(text_of(leaf->value.span)), "linear, cubic or low-pass"});
  }
  if (Leaf* const leaf = find(fmt::format("{}.{}", key, points_key(*spec.block))))
    read_points(spec, *leaf, part, function);
}

void ObjectReader::read_points(const FieldSpec& spec, const Leaf& leaf, std::size_t part,
                               core::SampledFunction& function) {
  const FunctionBlock& block = *spec.block;
  const FieldSpec x_spec = axis_spec(spec, block.x, any_value);
  FieldSpec y_spec = axis_spec(spec, block.y[part], range_of_y(block));
  y_spec.likely = likely_y(block);
  if (leaf.value.kind != toml::Kind::array) {
    const char* const form = block.x_ignored ? "[value, value, ...]" : "[[x, y], [x, y], ...]";
    return error(leaf.value.span, spec.problem_place(),
                 {fmt::format("{} is not an array", leaf.path), std::string(noun_of(leaf.value.kind)), form});
  }
  function.knots.clear();
  toml::Elements elements(source_.text, leaf.value);
  for (std::size_t number = 1; const auto element = elements.next(); ++number) {
    core::Knot knot{static_cast<double>(function.knots.size()), 0.0};
    if (block.x_ignored && element->value.kind != toml::Kind::array) {
      if (number_in(y_spec, element->value, knot.y)) function.knots.push_back(knot);
      continue;
    }
    toml::Elements pair(source_.text, element->value);
    const auto x = pair.next();
    const auto y = pair.next();
    if (element->value.kind != toml::Kind::array || !x || !y || pair.next()) {
      error(element->value.span, spec.problem_place(),
            {fmt::format("point {} of {} is not a pair", number, block.y[part].name),
             script::shown(text_of(element->value.span)), "[x, y]"});
      continue;
    }
    const bool sound = number_in(x_spec, x->value, knot.x);
    if (!number_in(y_spec, y->value, knot.y) || !sound) continue;
    if (!block.x_ignored && !function.knots.empty() && knot.x <= function.knots.back().x)
      error(x->value.span, spec.problem_place(),
            {fmt::format("point {} of {}: {} must ascend", number, block.y[part].name, block.x.name),
             script::shown(text_of(x->value.span)),
             fmt::format("above {}", quantity_text(function.knots.back().x, x_spec.quantity))});
    function.knots.push_back(knot);
  }
}

void ObjectReader::read_function_file(const FieldSpec& spec, const Leaf& leaf, const FunctionRef& function) {
  FieldValue name = std::string();
  if (!read_text(spec, leaf, name)) return;
  *function.file = std::get<std::string>(name);
  const DataFileText data =
      reading_.loader ? reading_.loader(*function.file) : DataFileText{{}, {}, "data files cannot be read here"};
  if (!data.failure.empty() || data.path.empty())
    return error(leaf.value.span, spec.problem_place(),
                 {fmt::format("cannot read the data file of {}", spec.words), *function.file, "", data.failure});
  DataFileReading read = read_data_file(data.text, data.path, *spec.block);
  for (core::Problem& problem : read.problems) {
    problem.subject = {std::string(kind_), index_, std::string(spec.problem_place())};
    reading_.log.add(std::move(problem));
  }
  for (std::size_t i = 0; i < spec.block->count; ++i) function.parts[i].knots = std::move(read.functions[i]);
}

// --- What stands in tables within an object: the elements of lists, and places on the Earth.

namespace {

template <class Element>
const std::vector<std::string>& keys_of() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> made;
    for (const FieldOf<Element>& field : table_of<Element>().fields()) made.emplace_back(field.spec.key);
    return made;
  }();
  return keys;
}

// Places of more entries of a list are not kept: they take the place of the list.
constexpr std::size_t placed_entries = 1000;

FieldSpec place_spec(std::string_view id, std::string_view words, Quantity quantity, const Range& range) {
  FieldSpec spec;
  spec.id = id;
  spec.words = words;
  spec.quantity = quantity;
  spec.range = range;
  return spec;
}

// The leaves of a table of an object, with or without a header of its own, as an object; they then count as used.
// Nothing for a table that is none of its leaves: an element of an array.
std::optional<ObjectText> taken_from(ObjectText& object, const toml::Value& table) {
  const auto own = std::ranges::find_if(object.leaves, [&](const Leaf& leaf) { return leaf.value.span == table.span; });
  if (own == object.leaves.end()) return std::nullopt;
  const std::string_view path = own->path;
  ObjectText taken;
  for (Leaf& leaf : object.leaves) {
    if (!is_below(leaf.path, path) || leaf.path.size() == path.size()) continue;
    taken.leaves.push_back(leaf);
    taken.leaves.back().path.remove_prefix(path.size() + 1);
    leaf.used = true;
  }
  return taken;
}

}  // namespace

template <class Element>
void ObjectReader::read_list(const FieldSpec& spec, const Leaf& leaf, std::vector<Element>& list) {
  note_place(spec.problem_place(), leaf.value.span);
  if (leaf.value.kind != toml::Kind::array) text_.use_all_below(leaf.path);
  if (leaf.value.kind != toml::Kind::array)
    return error(
        leaf.value.span, spec.problem_place(),
        {fmt::format("{} is not an array", leaf.path), std::string(noun_of(leaf.value.kind)), "[{ ... }, { ... }]"});
  toml::Elements elements(source_.text, leaf.value);
  const PlainTable& entries = element_table(spec.list);
  list.clear();
  for (std::size_t entry = 0; const auto element = elements.next(); ++entry) {
    if (reading_.log.full()) return;
    if (entry < placed_entries) note_place(fmt::format("{}[{}]", spec.problem_place(), entry), element->value.span);
    const std::string name = fmt::format("{} {}", entries.header, entry + 1);
    if (element->value.kind != toml::Kind::table) {
      error(
          element->value.span, spec.problem_place(),
          {fmt::format("{} is not a table", name), std::string(noun_of(element->value.kind)), "{ key = value, ... }"});
      continue;
    }
    ObjectTexts texts(source_.text, source_.document);
    ObjectText text = texts.inner(element->value);
    text.kind = name;
    ObjectReader inner(*this, text, spec.problem_place(), &entries);
    Element& read = list.emplace_back();
    inner.read(read);
    inner.report_lacks(read, element->value.span);
    inner.finish(keys_of<Element>());
  }
}

// What has no default and is not said. A word that nobody knows may be it, misspelt.
template <class Element>
void ObjectReader::report_lacks(const Element& element, toml::Span at) {
  if (!std::ranges::all_of(text_.leaves, &Leaf::used)) return;
  const FieldTable<Element>& table = table_of<Element>();
  for (const FieldOf<Element>& field : table.fields())
    if (field.spec.needed && table.applies(element, field) && text_.find(field.spec.key) == nullptr)
      error(at, field.spec.problem_place(),
            {fmt::format("{} lacks the {}", text_.kind, field.spec.words), "",
             fmt::format("{} = {}", field.spec.key, field.spec.example)});
}

template void ObjectReader::read_list(const FieldSpec&, const Leaf&, std::vector<Leg>&);
template void ObjectReader::read_list(const FieldSpec&, const Leaf&, std::vector<Waypoint>&);
template void ObjectReader::read_list(const FieldSpec&, const Leaf&, std::vector<Oscillation>&);

// A place on the Earth: { latitude, longitude, height }, or an altitude above the geoid in place of the height.
bool ObjectReader::read_place(const FieldSpec& spec, const toml::Value& value, core::Vec3& vector) {
  const FieldSpec latitude = place_spec(spec.problem_place(), "latitude", Quantity::angle, {-90.0, 90.0});
  const FieldSpec longitude = place_spec(spec.problem_place(), "longitude", Quantity::angle, {-360.0, 360.0});
  const FieldSpec height = place_spec(spec.problem_place(), "height", Quantity::length, {-1e4, 1e9});
  if (!reading_.earth) {
    static_cast<void>(taken_from(text_, value));  // one complaint is enough
    error(value.span, spec.problem_place(),
          {fmt::format("{}: the world is flat and has no latitudes", spec.words), "", "[x, y, z]",
           "write [world] with frame = \"earth\" and an anchor"});
    return false;
  }
  ObjectTexts texts(source_.text, source_.document);
  ObjectText text = taken_from(text_, value).value_or(texts.inner(value));
  text.kind = spec.words;
  ObjectReader inner(*this, text, spec.problem_place(), nullptr);
  std::array<double, 3> numbers{};
  bool sound = true;
  const auto read = [&](std::string_view key, const FieldSpec& of, double& number) {
    const Leaf* const leaf = inner.find(key);
    if (leaf != nullptr) sound = inner.number_in(of, leaf->value, number) && sound;
    return leaf != nullptr;
  };
  const bool has_latitude = read("latitude", latitude, numbers[0]);
  const bool has_longitude = read("longitude", longitude, numbers[1]);
  const bool has_height = read("height", height, numbers[2]);
  const bool has_altitude = read("altitude", height, numbers[2]);
  static const std::vector<std::string> known{"latitude", "longitude", "height", "altitude"};
  inner.finish(known);
  if (!has_latitude || !has_longitude || (has_height && has_altitude)) {
    error(value.span, spec.problem_place(),
          {fmt::format("{}: {}", spec.words,
                       has_height && has_altitude ? "a place has a height or an altitude, not both"
                                                  : "a place on the Earth needs latitude and longitude"),
           "", "{ latitude = \"-33.9 deg\", longitude = \"18.4 deg\", height = \"120 m\" }"});
    return false;
  }
  if (!sound) return false;
  const double latitude_rad = numbers[0] * core::rad_per_deg;
  const double longitude_rad = numbers[1] * core::rad_per_deg;
  const auto undulation_m =
      has_altitude ? reading_.earth->undulation_m(latitude_rad, longitude_rad) : std::optional<double>(0.0);
  if (!undulation_m) {
    error(value.span, spec.problem_place(),
          {fmt::format("{}: the grid of the geoid has no value there", spec.words), "", "",
           "give a height above the ellipsoid, or a grid that holds the place"});
    return false;
  }
  vector = reading_.earth->world_of({latitude_rad, longitude_rad, numbers[2] + *undulation_m});
  if (geodetic_at_ == toml::Span{}) geodetic_at_ = value.span;
  return true;
}

}  // namespace sarsim::scene::language
