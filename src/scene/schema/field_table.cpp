#include "scene/schema/field_table.hpp"

#include <algorithm>
#include <cctype>
#include <limits>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/model/limits.hpp"

namespace sarsim::scene::field_tables {

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
std::string range_words(const script::Range& range, Quantity quantity) {
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

}  // namespace

NumberReading read_number(const script::Field& grammar, Quantity quantity, std::string_view text) {
  QuantityReading reading = read_quantity(text, quantity);
  if (!reading.value) return {0.0, std::move(reading.failure)};
  const double value = *reading.value;
  const std::string found = core::clipped(core::trimmed(text));
  if (!grammar.range.holds(value))
    return {0.0, fmt::format("'{}' is outside what a script can say: {} is {}", found, grammar.words,
                             range_words(grammar.range, quantity))};
  if (!computable(value))
    return {0.0, fmt::format("'{}' is too large to compute with; expected a magnitude up to {}", found,
                             quantity_text(largest_value, quantity, ""))};
  if (quantity == Quantity::count && !fits_integer(value))
    return {0.0,
            fmt::format("'{}' is too large; expected a magnitude up to {}", found, std::numeric_limits<int>::max())};
  return {value, {}};
}

std::string name_failure(std::string_view words, std::string_view text) {
  if (text.empty()) return fmt::format("{} is empty; expected at least one character", words);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; };
  if (std::ranges::any_of(text, is_control))
    return fmt::format("{} has a line end or another control character, which a script cannot hold; leave it out",
                       words);
  return {};
}

ChoiceReading read_choice(const std::vector<std::string>& choices, std::string_view text) {
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
  std::string failure = fmt::format("'{}' is none of {}", core::clipped(typed), listed(choices, " and "));
  if (const std::string nearest = core::nearest_word(typed.substr(0, 60), choices); !nearest.empty())
    failure += fmt::format("; did you mean {}?", nearest);
  return {0, std::move(failure)};
}

CheckReading read_check(std::string_view text) {
  const std::string_view typed = core::trimmed(text);
  for (const std::string_view word : {"yes", "true", "on", "1", "y"})
    if (core::equal_ignoring_case(typed, word)) return {true, {}};
  for (const std::string_view word : {"no", "false", "off", "0", "n"})
    if (core::equal_ignoring_case(typed, word)) return {false, {}};
  return {false, fmt::format("'{}' is neither yes nor no", core::clipped(typed))};
}

std::string function_summary(const core::SampledFunction* parts, std::size_t count, const std::string& file) {
  if (!file.empty()) return file;
  static constexpr std::array<std::string_view, 3> methods{"linear", "cubic", "low pass"};
  std::vector<std::string> sizes;
  std::vector<std::string> kinds;
  for (std::size_t i = 0; i < count; ++i) {
    sizes.push_back(std::to_string(parts[i].knots.size()));
    kinds.emplace_back(methods[static_cast<std::size_t>(parts[i].method) % methods.size()]);
  }
  for (std::vector<std::string>* words : {&sizes, &kinds})
    if (std::ranges::all_of(*words, [&](const std::string& word) { return word == words->front(); })) words->resize(1);
  const bool single = sizes.size() == 1 && sizes.front() == "1";
  return fmt::format("{} {}, {}", listed(sizes, " and "), single ? "point" : "points", listed(kinds, " and "));
}

std::string limits_text(const script::Field& grammar, Quantity quantity) {
  const std::string words = range_words(grammar.range, quantity);
  return words.empty() ? std::string() : fmt::format(" Takes {}.", words);
}

void begin_constant(core::SampledFunction& function, double value) {
  if (function.knots.empty()) function.knots.push_back({0.0, value});
}

}  // namespace sarsim::scene::field_tables
