#include "scene/schema/quantity.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene {

namespace {

QuantityReading no_quantity(std::string failure) { return {std::nullopt, std::move(failure)}; }

QuantityReading read_factor(std::string_view typed, std::string_view text) {
  const std::string_view number = core::trimmed(typed.substr(1));
  const auto factor = number_length(number) == number.size() ? core::parse_number(number) : std::nullopt;
  if (!factor || *factor <= 0.0)
    return no_quantity(
        fmt::format("{} is not a valid ratio; a factor is written as x100, with a number above zero", quoted(text)));
  return {10.0 * std::log10(*factor), {}};
}

std::string no_number(std::string_view text, std::string_view typed, Quantity quantity) {
  if (typed.empty()) return fmt::format("nothing is typed; expected a {}", noun_of(quantity));
  if (typed.front() == ',' && typed.size() > 1 && core::is_digit(typed[1]))
    return comma_failure(text, "0" + std::string(typed));
  const auto units = unit_table(quantity);
  return units.empty() ? fmt::format("{} is not a valid {}", quoted(text), noun_of(quantity))
                       : fmt::format("{} is not a valid {}; expected a number, with {} where it has a unit",
                                     quoted(text), noun_of(quantity), units_listed(quantity));
}

const Unit& unit_named(Quantity quantity, std::string_view name) {
  for (const Unit& unit : unit_table(quantity))
    if (unit.name == name) return unit;
  static constexpr Unit pure{};
  if (name.empty()) return unit_table(quantity).empty() ? pure : unit_table(quantity).front();
  throw std::invalid_argument(fmt::format("'{}' is not a valid unit of a {}", name, noun_of(quantity)));
}

std::string text_in(double value, const Unit& unit) {
  std::string number;
  if (!std::isfinite(value))
    number = std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
  else if (unit.law == Unit::Law::decimal)
    number = core::format_number(value, -unit.exponent);
  else
    number = core::format_number(unit.law == Unit::Law::factor   ? value / unit.factor * unit.divisor
                                 : unit.law == Unit::Law::offset ? value - unit.factor
                                                                 : 10.0 * std::log10(value) - unit.factor,
                                 -unit.exponent);
  return unit.name.empty() ? number : fmt::format("{} {}", number, unit.name);
}

}  // namespace

QuantityReading read_quantity(std::string_view text, Quantity quantity, std::string_view bare_unit) {
  const std::string plain = plain_text(text);
  const std::string_view typed = core::trimmed(plain);
  if (quantity == Quantity::ratio_db && !typed.empty() && (typed.front() == 'x' || typed.front() == 'X'))
    return read_factor(typed, text);
  const std::size_t length = number_length(typed);
  if (length == 0) return no_quantity(no_number(text, typed, quantity));
  const std::string_view number = typed.substr(0, length);
  const std::string_view rest = core::trimmed(typed.substr(length));

  const Unit* unit = nullptr;
  if (rest.empty()) {
    unit = &unit_named(quantity, bare_unit);
  } else {
    if (std::string why = broken_number(text, typed, rest); !why.empty()) return no_quantity(std::move(why));
    UnitSearch search = find_unit(rest, quantity, text);
    if (search.unit == nullptr) return no_quantity(std::move(search.failure));
    unit = search.unit;
  }
  const auto value = in_base_unit(number, *unit);
  if (!value) return no_quantity(fmt::format("{} is too large for a number", quoted(text)));
  if (quantity == Quantity::count && *value != std::floor(*value))
    return no_quantity(
        fmt::format("{} is not a valid whole number; try {}", quoted(text), core::format_number(std::round(*value))));
  return {*value, {}};
}

std::string quantity_text(double value, Quantity quantity) {
  const auto units = unit_table(quantity);
  if (units.empty()) return text_in(value, unit_named(quantity, ""));
  const Unit* chosen = &units.front();
  if (value == 0.0 || !std::isfinite(value)) return text_in(value, *chosen);
  const Unit* smallest = chosen;
  const Unit* fitting = nullptr;
  for (const Unit& unit : units) {
    if (!unit.shown) continue;
    if (unit.exponent < smallest->exponent) smallest = &unit;
    // The nearest double to the power of ten: the comparison is then that of the shortest decimals.
    const bool fits = std::abs(value) >= *core::parse_number("1", unit.exponent);
    if (fits && (fitting == nullptr || unit.exponent > fitting->exponent)) fitting = &unit;
  }
  return text_in(value, fitting == nullptr ? *smallest : *fitting);
}

std::string quantity_text(double value, Quantity quantity, std::string_view unit) {
  return text_in(value, unit_named(quantity, unit));
}

std::vector<std::string_view> units_of(Quantity quantity) {
  std::vector<std::string_view> names;
  for (const Unit& unit : unit_table(quantity))
    if (unit.told) names.push_back(unit.name);
  return names;
}

int exponent_of(std::string_view name, Quantity quantity) {
  const Unit& unit = unit_named(quantity, name);
  if (unit.law != Unit::Law::decimal)
    throw std::invalid_argument(fmt::format("'{}' is not a valid power of ten of a {}", name, noun_of(quantity)));
  return unit.exponent;
}

}  // namespace sarsim::scene
