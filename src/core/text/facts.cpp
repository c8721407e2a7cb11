#include "core/text/facts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "core/text/problem_json.hpp"

namespace sarsim::core {

namespace {

const Facts* group_of(const Fact& fact) { return std::get_if<Facts>(&fact.value.held()); }

bool holds_rows(const Fact& fact) { return std::holds_alternative<FactRows>(fact.value.held()); }

bool is_nothing(const FactValue& value) {
  const double* const number = std::get_if<double>(&value.held());
  if (number != nullptr) return !std::isfinite(*number);
  const Facts* const group = std::get_if<Facts>(&value.held());
  if (group == nullptr) return std::holds_alternative<std::monostate>(value.held());
  return std::ranges::all_of(*group, [](const Fact& fact) { return fact.key.empty() || is_nothing(fact.value); });
}

// Calls `take(fact)` for each fact and, in place of a group, for those of the group.
template <class Take>
void for_each(const Facts& facts, const Take& take) {
  for (const Fact& fact : facts)
    if (const Facts* const group = group_of(fact))
      for_each(*group, take);
    else
      take(fact);
}

void write_value(JsonWriter& json, const FactValue& value) {
  if (is_nothing(value)) {
    json.null();
    return;
  }
  std::visit(
      [&json](const auto& held) {
        using Value = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<Value, Facts>) {
          json.begin_object();
          write_json(json, held);
          json.end_object();
        } else if constexpr (std::is_same_v<Value, FactRows> || std::is_same_v<Value, std::vector<std::string>>) {
          json.begin_array();
          for (const auto& member : held) write_value(json, member);
          json.end_array();
        } else if constexpr (std::is_same_v<Value, Problems>) {
          write_json(json, held);
        } else if constexpr (!std::is_same_v<Value, std::monostate>) {
          json.value(held);
        }
      },
      value.held());
}

std::string without_sign_of_zero(std::string text) {
  if (text.starts_with('-') && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return text;
}

// A number in the unit of its column.
std::string number_text(double value, const Digits& digits) {
  switch (digits.notation) {
    case Digits::Notation::fixed: return without_sign_of_zero(fmt::format("{:.{}f}", value, digits.count));
    case Digits::Notation::scientific: return fmt::format("{:.{}e}", value, digits.count);
    case Digits::Notation::with_sign: return fmt::format("{:+.{}f}", value, digits.count);
    case Digits::Notation::prefixed:
    case Digits::Notation::significant: break;
  }
  return fmt::format("{:.{}g}", value == 0.0 ? 0.0 : value, digits.count);
}

std::string cell_of(const Fact& fact) {
  if (!fact.text.empty()) return fact.text;
  if (is_nothing(fact.value)) return {};
  const FactValue::Held& held = fact.value.held();
  if (const double* const number = std::get_if<double>(&held)) return number_text(*number, fact.digits);
  if (const std::int64_t* const count = std::get_if<std::int64_t>(&held)) return std::to_string(*count);
  if (const bool* const truth = std::get_if<bool>(&held)) return *truth ? "yes" : "no";
  const std::string* const word = std::get_if<std::string>(&held);
  return word != nullptr ? *word : std::string();
}

ShownFact shown_of(const Fact& fact) {
  const double* const number = std::get_if<double>(&fact.value.held());
  const bool prefixed = number != nullptr && fact.text.empty() && std::isfinite(*number) && !fact.unit.empty() &&
                        fact.digits.notation == Digits::Notation::prefixed;
  if (!prefixed) return {fact.label, cell_of(fact), fact.unit};
  const std::string text = with_prefix(*number == 0.0 ? 0.0 : *number, fact.unit, fact.digits.count);
  const std::size_t gap = text.find(' ');
  return {fact.label, text.substr(0, gap), text.substr(gap + 1)};
}

std::string csv_value(const FactValue& value, int digits) {
  if (is_nothing(value)) return {};
  const FactValue::Held& held = value.held();
  if (const double* const number = std::get_if<double>(&held))
    return digits > 0 ? fmt::format("{:.{}g}", *number, digits) : format_number(*number);
  if (const std::int64_t* const count = std::get_if<std::int64_t>(&held)) return std::to_string(*count);
  if (const bool* const truth = std::get_if<bool>(&held)) return *truth ? "1" : "0";
  const std::string* const word = std::get_if<std::string>(&held);
  return word != nullptr ? csv_cell(*word) : std::string();
}

// A line of what `cell(fact)` gives for each fact with a key.
template <class Cell>
std::string line_of(const Facts& facts, const Cell& cell) {
  std::string line;
  bool first = true;
  for_each(facts, [&](const Fact& fact) {
    if (fact.key.empty()) return;
    if (!first) line += ',';
    first = false;
    line += cell(fact);
  });
  return line + "\n";
}

}  // namespace

FactValue::FactValue(Facts group) : held_(std::move(group)) {}
FactValue::FactValue(FactRows rows) : held_(std::move(rows)) {}

std::vector<std::string> texts_of(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> texts;
  for (const std::filesystem::path& path : paths) texts.push_back(path.string());
  return texts;
}

void append(Facts& facts, Facts more) { std::ranges::move(more, std::back_inserter(facts)); }

void write_json(JsonWriter& json, const Facts& facts) {
  for (const Fact& fact : facts) {
    if (fact.key.empty()) continue;
    json.key(fact.key);
    write_value(json, fact.value);
  }
}

std::string json_of(const Facts& facts) {
  JsonWriter json;
  json.begin_object();
  write_json(json, facts);
  return json.end_object().text();
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string csv_names(const Facts& columns) {
  return line_of(columns, [](const Fact& fact) { return fact.key; });
}

std::string csv_line(const Facts& row, int digits) {
  return line_of(row, [digits](const Fact& fact) { return csv_value(fact.value, digits); });
}

std::vector<ShownFact> shown(const Facts& facts) {
  std::vector<ShownFact> list;
  for_each(facts, [&list](const Fact& fact) {
    if (!fact.label.empty() && !holds_rows(fact)) list.push_back(shown_of(fact));
  });
  return list;
}

std::string text_of(const Facts& facts) {
  std::string text;
  for (const ShownFact& fact : shown(facts))
    if (!fact.value.empty())
      text += fmt::format("  {:<24} {}{}{}\n", fact.label, fact.value, fact.unit.empty() ? "" : " ", fact.unit);
  return text;
}

std::vector<std::string> headings(const Facts& row) {
  std::vector<std::string> texts;
  for_each(row, [&texts](const Fact& fact) {
    if (!fact.label.empty())
      texts.push_back(fact.unit.empty() ? fact.label : fmt::format("{} ({})", fact.label, fact.unit));
  });
  return texts;
}

std::vector<std::string> cells(const Facts& row) {
  std::vector<std::string> texts;
  for_each(row, [&texts](const Fact& fact) {
    if (!fact.label.empty()) texts.push_back(cell_of(fact));
  });
  return texts;
}

std::string aligned_row(const Facts& row, std::span<const std::size_t> widths) {
  std::string line;
  std::size_t column = 0;
  bool ended = false;
  for_each(row, [&](const Fact& fact) {
    if (ended || fact.label.empty() || column == widths.size()) return;
    ended = !fact.text.empty() && is_nothing(fact.value);
    const std::size_t width = widths[column++];
    if (ended)
      line += "  " + fact.text;
    else
      line += fmt::format("{}{:>{}}", line.empty() ? "" : " ", cell_of(fact), width);
  });
  return line + "\n";
}

}  // namespace sarsim::core
