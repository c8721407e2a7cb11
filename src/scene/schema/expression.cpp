#include "scene/schema/expression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/unit_evaluation.hpp"
#include "scene/schema/unit_functions.hpp"
#include "scene/schema/unit_source.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene {

namespace {

// Where a name stands on the path of `LetNames::resolve_from`, where it does not.
constexpr std::size_t unseen = std::numeric_limits<std::size_t>::max();
constexpr std::size_t done = unseen - 1;
constexpr std::size_t longest_chain = 8;

ExpressionFault other_dimension(std::string_view text, const Evaluated& found, Quantity quantity) {
  const Dimension wanted = dimension_of(quantity);
  const std::string units = units_listed(quantity);
  ExpressionFault fault{found.begin, found.end, {}, {}, found.hint};
  fault.message = fmt::format("{} is {}; the field takes {}{}", quoted(text), dimension_text(found.measured->dimension),
                              with_article(noun_of(quantity)), units.empty() ? " without a unit" : ", in " + units);
  Dimension straight = found.measured->dimension;
  const int turns = std::exchange(straight.powers[Dimension::degree], wanted.powers[Dimension::degree]) -
                    wanted.powers[Dimension::degree];
  if (fault.hint.empty() && straight == wanted && std::abs(turns) == 1)
    fault.hint = fmt::format("an angle is a unit of its own; {} by 1 rad", turns > 0 ? "divide" : "multiply");
  return fault;
}

ExpressionFault no_whole_number(std::string_view text, const Evaluated& found) {
  return {found.begin, found.end, quoted(text) + " is not a whole number", "a whole number",
          fmt::format("try {}", core::format_number(std::round(found.measured->value)))};
}

// Why a name cannot be one of [let].
std::optional<ExpressionFault> name_fault(std::string_view name) {
  const auto fault = [&](std::string message, std::string expected, std::string hint) {
    return ExpressionFault{0, name.size(), std::move(message), std::move(expected), std::move(hint)};
  };
  const auto taken = [&](std::string_view by) {
    return fault(fmt::format("'{}' is the name of a {}", name, by), "another name", fmt::format("write {}_1", name));
  };
  if (const Unit* const unit = unit_called(name).unit; unit != nullptr && !unit->yields) return taken("unit");
  if (constant_named(name) != nullptr) return taken("constant");
  if (function_named(name) != nullptr) return taken("function");
  if (!name.empty() && word_at(name, 0).size() == name.size()) return std::nullopt;
  std::string corrected(name);
  for (char& c : corrected)
    if (!begins_word(c) && !core::is_digit(c)) c = '_';
  if (corrected.empty() || !begins_word(corrected.front())) corrected.insert(0, "_");
  return fault(fmt::format("{} is not a valid name", quoted(name)),
               "letters A to Z, digits and underscores, no digit in front", fmt::format("write {}", quoted(corrected)));
}

// The value of a number with one unit in plain characters, which nearly all texts are; nothing for all others.
std::optional<double> plain_literal(std::string_view text, Quantity quantity, bool& bare) {
  const std::size_t length = number_length(text);
  if (length == 0) return std::nullopt;
  const std::string_view unit = core::trimmed(text.substr(length));
  bare = unit.empty();
  if (bare) return core::parse_number(text.substr(0, length));
  for (const Unit& candidate : unit_table(quantity))
    if (candidate.name == unit) return in_base_unit(text.substr(0, length), candidate);
  return std::nullopt;
}

// Whether a text is a ratio written as "x100", and no name.
bool is_factor(std::string_view text, const LetNames& names) {
  if (names.contains(text)) return false;
  const std::string plain = plain_text(text);
  if (plain.empty() || core::lower(plain.front()) != 'x') return false;
  const std::string_view number = core::trimmed(std::string_view(plain).substr(1));
  return !number.empty() && number_length(number) == number.size();
}

QuantityResult read_factor(std::string_view text) {
  QuantityReading reading = read_quantity(text, Quantity::ratio_db);
  if (reading.value) return {.value = reading.value, .fault = {}, .literal = true};
  return {.value = {}, .fault = ExpressionFault{0, text.size(), std::move(reading.failure)}};
}

}  // namespace

QuantityResult evaluate(std::string_view text, Quantity quantity, const LetNames& names) {
  bool bare = false;
  const bool has_units = !unit_table(quantity).empty();
  const auto suits = [&](double value) { return quantity != Quantity::count || value == std::floor(value); };
  const std::string_view typed = core::trimmed(text);
  if (const auto value = plain_literal(typed, quantity, bare); value && suits(*value))
    return {.value = value, .fault = {}, .literal = true, .bare = bare && has_units};
  if (quantity == Quantity::ratio_db && is_factor(typed, names)) return read_factor(text);

  Evaluated found = evaluated(text, names);
  if (!found.measured) return {.value = {}, .fault = std::move(found.fault)};
  const bool pure = found.measured->dimension.pure();
  if (!pure && found.measured->dimension != dimension_of(quantity))
    return {.value = {}, .fault = other_dimension(text, found, quantity), .other = found.measured};
  if (!suits(found.measured->value)) return {.value = {}, .fault = no_whole_number(text, found)};
  return {.value = found.measured->value, .fault = {}, .literal = found.literal, .bare = pure && has_units};
}

std::string exact_quantity_text(double value, Quantity quantity) {
  std::string text = quantity_text(value, quantity);
  return value == 0.0 && std::signbit(value) ? "-" + text : text;
}

void LetNames::define(std::string name, double value) { define(std::move(name), Measured{value, {}}); }

void LetNames::define(std::string name, const Measured& value) {
  Entry entry{std::move(name), {}, false, value, {}, false};
  if (!std::isfinite(value.value)) {
    entry.value = std::nullopt;
    entry.fault =
        ExpressionFault{0, 0, core::format_number(value.value) + " is not a number to compute with", "a finite number"};
  }
  add(std::move(entry));
}

void LetNames::define(std::string name, std::string expression) {
  add({std::move(name), std::move(expression), true, {}, {}, false});
}

void LetNames::add(Entry entry) {
  if (auto fault = name_fault(entry.name)) {
    entry = {std::move(entry.name), {}, false, {}, std::move(fault), true};
    entries_.push_back(std::move(entry));
    return;
  }
  const auto [place, added] = places_.try_emplace(entry.name, entries_.size());
  if (added)
    entries_.push_back(std::move(entry));
  else
    entries_[place->second] = std::move(entry);
}

const Measured* LetNames::find(std::string_view name) const {
  const auto found = places_.find(name);
  if (found == places_.end() || !entries_[found->second].value) return nullptr;
  return &*entries_[found->second].value;
}

std::vector<std::string_view> LetNames::all() const {
  std::vector<std::string_view> names;
  names.reserve(places_.size());
  for (const auto& [name, place] : places_) names.emplace_back(name);
  return names;
}

std::vector<NameFault> LetNames::resolve() {
  for (Entry& entry : entries_)
    if (entry.computed) entry.value = std::nullopt, entry.fault = std::nullopt;
  std::vector<std::size_t> positions(entries_.size(), unseen);
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (entries_[i].computed && positions[i] == unseen) resolve_from(i, positions);
  std::vector<NameFault> faults;
  for (const Entry& entry : entries_)
    if (entry.fault) faults.push_back({entry.name, entry.of_name, *entry.fault});
  return faults;
}

// Depth first, without recursion, because a chain of names may be of any length: a name is computed when all that its
// expression uses has been. One that leads back to itself meets a name without a value, and so gets none.
void LetNames::resolve_from(std::size_t first, std::vector<std::size_t>& positions) {
  struct Step {
    std::size_t entry;
    std::vector<ExpressionWord> words;
    std::size_t next = 0;
  };
  std::vector<Step> path;
  const auto enter = [&](std::size_t entry) {
    positions[entry] = path.size();
    path.push_back({entry, words_of(entries_[entry].expression)});
  };
  const auto report_cycle = [&](std::size_t start) {
    Entry& entry = entries_[path[start].entry];
    const ExpressionWord& word = path[start].words[path[start].next - 1];
    std::string chain;
    for (std::size_t i = start; i < std::min(path.size(), start + longest_chain); ++i)
      chain += core::clipped(entries_[path[i].entry].name) + " -> ";
    if (path.size() - start > longest_chain) chain += "... -> ";
    entry.fault = ExpressionFault{word.begin,
                                  word.end,
                                  quoted(entry.name) + " depends on itself: " + chain + core::clipped(entry.name),
                                  {},
                                  "give one of these names a value without the others"};
  };
  enter(first);
  while (!path.empty()) {
    Step& step = path.back();
    if (step.next == step.words.size()) {
      compute(entries_[step.entry]);
      positions[step.entry] = done;
      path.pop_back();
      continue;
    }
    const auto used = places_.find(step.words[step.next++].name);
    if (used == places_.end() || !entries_[used->second].computed) continue;
    const std::size_t position = positions[used->second];
    if (position == unseen)
      enter(used->second);
    else if (position != done && !entries_[used->second].fault)
      report_cycle(position);
  }
}

void LetNames::compute(Entry& entry) const {
  Evaluated found = evaluated(entry.expression, *this);
  entry.value = found.measured;
  if (!found.measured && !found.fault.follows && !entry.fault) entry.fault = std::move(found.fault);
}

}  // namespace sarsim::scene
