// Prints the tables of docs/formats/script.md from the tables of fields, each behind a line "=== heading", then every
// word, field and block of the script language, behind "=== language". For tools/field-tables and language_test.py.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/model/kinds.hpp"
#include "scene/script/order.hpp"

namespace sarsim::scene {
namespace {

std::string joined(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? last : std::string_view(", ");
    text += words[i];
  }
  return text;
}

std::vector<std::string> words_for(const FieldSpec& choice, const std::vector<int>& among) {
  std::vector<std::string> words;
  for (const int value : among) {
    const auto found = std::ranges::find(choice.choices, value, &Choice::value);
    if (found != choice.choices.end() && found->since_2()) continue;
    words.push_back(found != choice.choices.end() ? std::string(found->word)
                                                  : fmt::format("not {}", choice.choices.front().word));
  }
  return words;
}

// "`MONO`, `CHIRP` or `BARKER`", "pulse width", "position x, y, z", "block of 2 functions".
std::string what(const FieldSpec& spec) {
  if (spec.type == FieldType::function)
    return fmt::format("[block](#user-defined-functions) of {} function{}", spec.block->count,
                       spec.block->count == 1 ? "" : "s");
  if (has_words(spec)) {
    std::vector<std::string> words;
    for (const Choice& choice : spec.choices)
      if (!choice.since_2()) words.push_back(fmt::format("`{}`", choice.word));
    return joined(words, " or ");
  }
  const std::size_t number = spec.id.find('[');
  std::string text(spec.words);
  if (number != std::string_view::npos) text += fmt::format(" {}", static_cast<char>(spec.id[number + 1] + 1));
  return spec.type == FieldType::vector ? text + " x, y, z" : text;
}

std::string number_text(const FieldSpec& spec, double value) { return core::format_number(value, -script_shift(spec)); }

std::string unit_and_range(const FieldSpec& spec) {
  std::vector<std::string> parts;
  std::string unit(script_unit(spec));
  if (const std::size_t power = unit.find("^2"); power != std::string::npos) unit.replace(power, 2, "²");
  if (!unit.empty()) parts.push_back(unit);
  const Range& range = spec.range;
  if (spec.type == FieldType::seed)
    parts.emplace_back("0 … 18446744073709551615");
  else if (range.low > any_value.low && range.high < any_value.high)
    parts.push_back(fmt::format("{} … {}", number_text(spec, range.low), number_text(spec, range.high)));
  else if (range.low > any_value.low)
    parts.push_back(fmt::format("{} {}", range.low_excluded ? ">" : "≥", number_text(spec, range.low)));
  return joined(parts, ", ");
}

std::string default_text(const FieldSpec& spec, const FieldValue& value) {
  if (has_words(spec)) {
    const auto found = std::ranges::find(spec.choices, chosen(value), &Choice::value);
    return found == spec.choices.end() ? std::string() : std::string(found->word);
  }
  if (const auto* const number = std::get_if<double>(&value)) return number_text(spec, *number);
  if (const auto* const seed = std::get_if<std::uint64_t>(&value)) return std::to_string(*seed);
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  const auto* const vector = std::get_if<core::Vec3>(&value);
  if (vector == nullptr) return {};
  if (*vector == core::Vec3{}) return "0";
  return fmt::format("{}, {}, {}", number_text(spec, vector->x), number_text(spec, vector->y),
                     number_text(spec, vector->z));
}

std::string meaning(const FieldSpec& spec) {
  const bool coded = spec.type == FieldType::flags || (spec.type == FieldType::choice && !has_words(spec));
  return coded ? fmt::format("{} Numbers: {}.", spec.tip, spec.detail) : std::string(spec.tip);
}

template <class Object>
std::string condition(const FieldSpec& spec) {
  if (spec.when.among.empty()) return {};
  const FieldSpec& choice = table_of<Object>().fields()[spec.when.field].spec;
  return joined(words_for(choice, spec.when.among), " or ");
}

template <class Object>
void print_table(std::string_view command) {
  fmt::print("=== `${}`\n| Field | Unit, range | Default | Meaning |\n|---|---|---|---|\n", command);
  for (const FieldOf<Object>* const field : script::script_order<Object>()) {
    const std::string when = condition<Object>(field->spec);
    fmt::print("| {}{} | {} | {} | {} |\n", when.empty() ? "" : when + ": ", what(field->spec),
               unit_and_range(field->spec), default_text(field->spec, field->get(Object{})), meaning(field->spec));
  }
}

void print_options() {
  fmt::print("=== `$OPTIONS`\n| Key | Values | Default | Meaning |\n|---|---|---|---|\n");
  for (const FieldOf<RunOptions>* const field : script::script_order<RunOptions>())
    fmt::print("| `{}` | {} | {} | {} |\n", script::option_key(field->spec),
               has_words(field->spec) ? what(field->spec) : unit_and_range(field->spec),
               default_text(field->spec, field->get(RunOptions{})), field->spec.tip);
}

std::string with_unit(const std::string& name, std::string_view unit) {
  return unit.empty() ? name : fmt::format("{}, {}", name, unit);
}

void print_blocks() {
  fmt::print("=== User-defined functions\n| Where | Functions | x | y |\n|---|---|---|---|\n");
  for_each_kind([]<class Object>(const Kind<Object>& kind) {
    for (const FieldOf<Object>* const field : script::script_order<Object>()) {
      if (field->spec.type != FieldType::function) continue;
      const FunctionBlock& block = *field->spec.block;
      std::vector<std::string> names;
      for (std::size_t i = 0; i < block.count; ++i) names.emplace_back(block.y[i].name);
      fmt::print("| `${}` {}: {} | {} | {} | {} |\n", kind.command, condition<Object>(field->spec), block.words,
                 block.count, block.x_ignored ? "ignored" : with_unit(std::string(block.x.name), block.x.unit),
                 with_unit(joined(names, ", "), block.y[0].unit));
    }
  });
}

void print_language(const FieldSpec& spec) {
  for (const Choice& choice : spec.choices)
    if (!choice.word.empty()) fmt::print("word {}\n", choice.word);
  if (spec.type == FieldType::function)
    fmt::print("block {}\n", spec.block->words);
  else if (!has_words(spec))
    fmt::print("field {}\n", spec.words);
}

void print_all() {
  for_each_kind([]<class Object>(const Kind<Object>& kind) { print_table<Object>(kind.command); });
  print_options();
  print_blocks();
  fmt::print("=== language\nword {}\n", script::stc_switch);
  for (const auto& method : script::interpolations) fmt::print("word {}\n", method.word);
  for (const auto& source : script::data_sources) fmt::print("word {}\n", source.word);
  for_each_kind([](const auto& kind) {
    for (const auto& field : scene::table_of(kind).fields())
      if (!field.spec.since_2) print_language(field.spec);
  });
  for (const auto& field : table_of<RunOptions>().fields()) {
    fmt::print("word {}\n", script::option_key(field.spec));
    print_language(field.spec);
  }
}

}  // namespace
}  // namespace sarsim::scene

int main() { sarsim::scene::print_all(); }
