#include "scene/schema/field_form.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/expression.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/schema/trade_words.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene::field_forms {

namespace {

bool begins_with(std::string_view text, std::string_view beginning) {
  return beginning.size() <= text.size() && core::equal_ignoring_case(text.substr(0, beginning.size()), beginning);
}

std::string listed(const std::vector<std::string>& words, std::string_view last_joint) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? last_joint : std::string_view(", ");
    text += words[i];
  }
  return text;
}

// "1 to 1000", "0 or more", "above 0", in the unit in which people see the field.
std::string range_words(const Range& range, Quantity quantity) {
  const bool below = range.low > -std::numeric_limits<double>::infinity();
  const bool above = range.high < std::numeric_limits<double>::infinity();
  if (below && above)
    return fmt::format("{} to {}", core::format_number(range.low), quantity_text(range.high, quantity));
  if (above) return fmt::format("up to {}", quantity_text(range.high, quantity));
  if (!below) return {};
  if (range.low == 0.0) return range.low_excluded ? "above 0" : "0 or more";
  return fmt::format("{} or more", quantity_text(range.low, quantity));
}

bool fits_integer(double value) {
  return value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
}

// A number for a field, checked against the limits of the script language.
struct NumberReading {
  double value = 0.0;
  std::string failure;
};

// Whether a text looks like one number, perhaps with a unit, rather than like an expression.
bool looks_plain(std::string_view text) {
  text = core::trimmed(text);
  const std::size_t length = number_length(text);
  return text.empty() || (length > 0 && text.find_first_of("+-*/^(", length) == std::string_view::npos);
}

std::string sentence_of(const ExpressionFault& fault, std::string_view text) {
  if (fault.follows) return fmt::format("'{}' uses a name of [let] that has no value", core::clipped(text));
  std::string sentence = fault.message;
  if (!fault.expected.empty()) sentence += fmt::format("; expected {}", fault.expected);
  if (!fault.hint.empty()) sentence += fmt::format("; {}", fault.hint);
  return sentence;
}

// What a file accepts, and where it does not, what a form does.
QuantityReading read_with_names(std::string_view text, Quantity quantity, const LetNames& names) {
  const QuantityResult result = evaluate(text, quantity, names);
  if (result.value) return {result.value, {}};
  QuantityReading plain = read_quantity(text, quantity);
  if (!plain.value && !looks_plain(text)) plain.failure = sentence_of(*result.fault, text);
  return plain;
}

NumberReading read_number(const FieldSpec& spec, std::string_view text, const LetNames* names) {
  QuantityReading reading =
      names == nullptr ? read_quantity(text, spec.quantity) : read_with_names(text, spec.quantity, *names);
  if (!reading.value) {
    if (const auto other = evaluate(text, spec.quantity, names == nullptr ? LetNames{} : *names).other)
      if (const std::string hint = conversion_hint(spec, text, *other, {}); !hint.empty())
        reading.failure += fmt::format("; {}", hint);
    return {0.0, std::move(reading.failure)};
  }
  const double value = *reading.value;
  const std::string found = core::clipped(core::trimmed(text));
  if (!spec.range.holds(value))
    return {0.0, fmt::format("'{}' is outside what a scene can say: {} is {}", found, spec.words,
                             range_words(spec.range, spec.quantity))};
  if (!computable(value))
    return {0.0, fmt::format("'{}' is too large to compute with; expected a magnitude up to {}", found,
                             quantity_text(largest_value, spec.quantity, ""))};
  if (spec.quantity == Quantity::count && !fits_integer(value))
    return {0.0,
            fmt::format("'{}' is too large; expected a magnitude up to {}", found, std::numeric_limits<int>::max())};
  return {value, {}};
}

// Why a name cannot stand in a script; empty where it can.
std::string name_failure(std::string_view words, std::string_view text) {
  if (text.empty()) return fmt::format("{} is empty; expected at least one character", words);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; };
  if (std::ranges::any_of(text, is_control))
    return fmt::format("{} has a line end or another control character, which a scene cannot hold; leave it out",
                       words);
  return {};
}

// Position of the choice that is meant, without regard to case, by its whole name or a beginning that only it has.
struct ChoiceReading {
  std::size_t index = 0;
  std::string failure;
};

ChoiceReading read_choice(const FieldSpec& spec, std::string_view text) {
  const std::vector<std::string> choices = shown_choices(spec);
  const std::string_view typed = core::trimmed(text);
  std::vector<std::string> alike;
  std::size_t found = 0;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (core::equal_ignoring_case(choices[i], typed)) return {i, {}};
    if (typed.empty() || !begins_with(choices[i], typed)) continue;
    alike.push_back(choices[i]);
    found = i;
  }
  if (alike.size() == 1) return {found, {}};
  if (typed.empty()) return {0, fmt::format("nothing is chosen; expected {}", listed(choices, " or "))};
  if (alike.size() > 1)
    return {0, fmt::format("'{}' can mean {}; write more of it", core::clipped(typed), listed(alike, " or "))};
  return {0, none_of(spec, typed, choices)};
}

// "yes" and "no" and what means the same.
struct CheckReading {
  bool value = false;
  std::string failure;
};

CheckReading read_check(std::string_view text) {
  const std::string_view typed = core::trimmed(text);
  for (const std::string_view word : {"yes", "true", "on", "1", "y"})
    if (core::equal_ignoring_case(typed, word)) return {true, {}};
  for (const std::string_view word : {"no", "false", "off", "0", "n"})
    if (core::equal_ignoring_case(typed, word)) return {false, {}};
  return {false, fmt::format("'{}' is neither yes nor no", core::clipped(typed))};
}

// "3 points, cubic", "3, 2 and 1 points, linear", or the name of the file.
std::string function_summary(const ConstFunctionRef& function) {
  if (!function.file->empty()) return *function.file;
  static constexpr std::array<std::string_view, 3> methods{"linear", "cubic", "low pass"};
  std::vector<std::string> sizes;
  std::vector<std::string> kinds;
  for (const core::SampledFunction& part : function.parts) {
    sizes.push_back(std::to_string(part.knots.size()));
    kinds.emplace_back(methods[static_cast<std::size_t>(part.method) % methods.size()]);
  }
  for (std::vector<std::string>* words : {&sizes, &kinds})
    if (std::ranges::all_of(*words, [&](const std::string& word) { return word == words->front(); })) words->resize(1);
  const bool single = sizes.size() == 1 && sizes.front() == "1";
  return fmt::format("{} {}, {}", listed(sizes, " and "), single ? "point" : "points", listed(kinds, " and "));
}

// "4 entries".
std::string list_summary(const ConstListRef& list) {
  const std::size_t count = visit_elements(list.kind, list.list, [](const auto& elements) { return elements.size(); });
  return fmt::format("{} {}", count, count == 1 ? "entry" : "entries");
}

std::string set_number(const FieldSpec& spec, double& value, std::string_view text, const LetNames* names) {
  NumberReading reading = read_number(spec, text, names);
  if (reading.failure.empty()) value = reading.value;
  return std::move(reading.failure);
}

std::string set_seed(std::uint64_t& value, std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first != std::string_view::npos) text = text.substr(first, text.find_last_not_of(" \t") - first + 1);
  const auto seed = core::parse_whole(text);
  if (!seed)
    return fmt::format("'{}' is not a valid seed; expected a whole number, 0 to 18446744073709551615",
                       text.substr(0, 60));
  value = *seed;
  return {};
}

std::string set_choice(const FieldSpec& spec, FieldValue& value, std::string_view text) {
  ChoiceReading reading = read_choice(spec, text);
  if (!reading.failure.empty()) return std::move(reading.failure);
  choose(value, static_cast<int>(reading.index));
  return {};
}

std::string set_flag(const Flag& flag, double& value, std::string_view text) {
  CheckReading reading = read_check(text);
  const auto flags = static_cast<unsigned>(static_cast<int>(value));
  if (reading.failure.empty()) value = static_cast<int>(reading.value ? flags | flag.bit : flags & ~flag.bit);
  return std::move(reading.failure);
}

std::string set_check(bool& value, std::string_view text) {
  CheckReading reading = read_check(text);
  if (reading.failure.empty()) value = reading.value;
  return std::move(reading.failure);
}

std::string set_text(const FieldSpec& spec, std::string& value, std::string_view text) {
  if (text == value) return {};
  std::string failure = spec.optional && text.empty() ? std::string() : name_failure(spec.words, text);
  if (failure.empty()) value = text;
  return failure;
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

// What follows the meaning in a tooltip: ", 0 to 7" in the field's unit; empty where anything goes.
std::string limits_text(const FieldSpec& spec) {
  const std::string words = range_words(spec.range, spec.quantity);
  return words.empty() ? std::string() : fmt::format(" Takes {}.", words);
}

FieldKind form_kind(const FieldSpec& spec) {
  switch (spec.type) {
    case FieldType::number:
    case FieldType::seed:
    case FieldType::vector: return FieldKind::quantity;
    case FieldType::choice: return FieldKind::choice;
    case FieldType::check:
    case FieldType::flags: return FieldKind::check;
    case FieldType::text: return FieldKind::text;
    case FieldType::name: return spec.refers == "radar" ? FieldKind::radar : FieldKind::platform;
    case FieldType::function: return FieldKind::function;
    case FieldType::list: return FieldKind::list;
  }
  return FieldKind::text;
}

}  // namespace

double& component(core::Vec3& vector, std::size_t part) {
  return part == 0 ? vector.x : part == 1 ? vector.y : vector.z;
}

std::string none_of(const FieldSpec& spec, std::string_view text, const std::vector<std::string>& choices) {
  const std::string_view typed = core::trimmed(text);
  std::string failure = fmt::format("'{}' is none of {}", core::clipped(typed), listed(choices, " and "));
  if (const TradeChoice* const of_trade = trade_choice(typed, spec.key))
    failure += fmt::format("; {}", trade_advice(*of_trade));
  else if (const std::string nearest = core::nearest_word(typed.substr(0, 60), choices); !nearest.empty())
    failure += fmt::format("; did you mean {}?", nearest);
  return failure;
}

std::vector<std::string> shown_choices(const FieldSpec& spec) {
  std::vector<std::string> shown;
  for (const Choice& choice : spec.choices) {
    const auto at = static_cast<std::size_t>(choice.value);
    if (shown.size() <= at) shown.resize(at + 1);
    if (shown[at].empty()) shown[at] = choice.shown;
  }
  return shown;
}

std::vector<Field> form_fields(const FieldSpec& spec) {
  Field field;
  field.id = spec.id;
  field.label = spec.label;
  field.group = spec.group;
  field.tooltip = spec.tip;
  field.kind = form_kind(spec);
  field.quantity = spec.quantity;
  field.rare = spec.rare;
  field.spec = &spec;
  if (spec.type == FieldType::choice) field.choices = shown_choices(spec);
  if (spec.type == FieldType::number || spec.type == FieldType::vector) field.tooltip += limits_text(spec);
  std::vector<Field> fields;
  if (spec.type == FieldType::vector)
    for (const char axis : {'x', 'y', 'z'}) {
      Field& part = fields.emplace_back(field);
      part.id += fmt::format(".{}", axis);
      part.label = fmt::format("{} {}", static_cast<char>(axis - 'a' + 'A'), field.label);
      part.part = static_cast<std::size_t>(axis - 'x');
    }
  for (const Flag& flag : spec.flags) {
    Field& part = fields.emplace_back(field);
    part.id += fmt::format(".{}", flag.id);
    part.label = flag.label;
    part.part = fields.size() - 1;
  }
  if (fields.empty()) fields.push_back(std::move(field));
  return fields;
}

std::string form_text(const FieldSpec& spec, const FieldValue& value, std::size_t part) {
  switch (spec.type) {
    case FieldType::number: return quantity_text(std::get<double>(value), spec.quantity);
    case FieldType::seed: return std::to_string(std::get<std::uint64_t>(value));
    case FieldType::vector: {
      core::Vec3 vector = std::get<core::Vec3>(value);
      return quantity_text(component(vector, part), spec.quantity);
    }
    case FieldType::choice: {
      const std::vector<std::string> choices = shown_choices(spec);
      const auto at = static_cast<std::size_t>(chosen(value));
      return at < choices.size() ? choices[at] : std::to_string(chosen(value));
    }
    case FieldType::check: return yes_or_no(std::get<bool>(value));
    case FieldType::flags: return yes_or_no((static_cast<unsigned>(chosen(value)) & spec.flags[part].bit) != 0);
    case FieldType::text:
    case FieldType::name: return std::get<std::string>(value);
    case FieldType::function: return function_summary(std::get<ConstFunctionRef>(value));
    case FieldType::list: return list_summary(std::get<ConstListRef>(value));
  }
  return {};
}

bool same_part(const FieldSpec& spec, const FieldValue& a, const FieldValue& b, std::size_t part) {
  if (spec.type != FieldType::vector) return a == b;
  core::Vec3 first = std::get<core::Vec3>(a);
  core::Vec3 second = std::get<core::Vec3>(b);
  return component(first, part) == component(second, part);
}

std::string set_value(const FieldSpec& spec, FieldValue& value, std::size_t part, std::string_view text,
                      const LetNames* names) {
  switch (spec.type) {
    case FieldType::number: return set_number(spec, std::get<double>(value), text, names);
    case FieldType::seed: return set_seed(std::get<std::uint64_t>(value), text);
    case FieldType::vector: return set_number(spec, component(std::get<core::Vec3>(value), part), text, names);
    case FieldType::choice: return set_choice(spec, value, text);
    case FieldType::check: return set_check(std::get<bool>(value), text);
    case FieldType::flags: return set_flag(spec.flags[part], std::get<double>(value), text);
    case FieldType::text:
    case FieldType::name: return set_text(spec, std::get<std::string>(value), text);
    case FieldType::list:
      if (text == list_summary(std::get<ConstListRef>(value))) return {};
      return "a list is edited in the text of the scene";
    case FieldType::function: break;
  }
  if (text == function_summary(std::get<ConstFunctionRef>(value))) return {};
  return "a function is edited in the function editor";
}

}  // namespace sarsim::scene::field_forms
