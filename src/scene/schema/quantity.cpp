#include "scene/schema/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::scene {

namespace {

// One unit of a quantity: value = number * 10^exponent, number * factor, or 10^((number + offset)/10).
struct Unit {
  enum class Law { decimal, factor, decibel };

  std::string_view name;
  Law law = Law::decimal;
  int exponent = 0;
  double factor = 1.0;
  bool shown = true;      // may be chosen to show a value
  bool prefixed = false;  // its first letter is a prefix, whose case can change its meaning
};

constexpr Unit decimal(std::string_view name, int exponent, bool prefixed = true, bool shown = true) {
  return {name, Unit::Law::decimal, exponent, 1.0, shown, prefixed};
}
constexpr Unit scaled(std::string_view name, double factor, bool prefixed = false) {
  return {name, Unit::Law::factor, 0, factor, false, prefixed};
}
constexpr Unit decibel(std::string_view name, double offset) {
  return {name, Unit::Law::decibel, 0, offset, false, false};
}

constexpr Unit length_units[] = {
    decimal("m", 0, false),         decimal("nm", -9), decimal("um", -6),    decimal("mm", -3),
    decimal("cm", -2, true, false), decimal("km", 3),  scaled("ft", 0.3048), scaled("nmi", 1852.0)};
constexpr Unit time_units[] = {decimal("s", 0, false), decimal("ns", -9), decimal("us", -6), decimal("ms", -3),
                               scaled("min", 60.0)};
constexpr Unit frequency_units[] = {decimal("Hz", 0, false), decimal("kHz", 3), decimal("MHz", 6), decimal("GHz", 9)};
constexpr Unit angle_units[] = {decimal("deg", 0, false), scaled("rad", core::deg_per_rad),
                                scaled("mrad", core::deg_per_rad * 1e-3, true), scaled("'", 1.0 / 60.0)};
constexpr Unit angle_rate_units[] = {decimal("deg/s", 0, false), scaled("rad/s", core::deg_per_rad),
                                     scaled("rpm", 6.0)};
constexpr Unit area_units[] = {decimal("m2", 0, false), decimal("cm2", -4, true, false), decibel("dBsm", 0.0)};
constexpr Unit power_units[] = {decimal("W", 0, false), decimal("mW", -3),   decimal("kW", 3),
                                decimal("MW", 6),       decibel("dBW", 0.0), decibel("dBm", -30.0)};
constexpr Unit decibel_units[] = {decimal("dB", 0, false)};
constexpr Unit temperature_units[] = {decimal("K", 0, false)};
constexpr Unit voltage_units[] = {decimal("V", 0, false), decimal("nV", -9), decimal("uV", -6), decimal("mV", -3)};

std::span<const Unit> table_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::number:
    case Quantity::count: return {};
    case Quantity::length: return length_units;
    case Quantity::time: return time_units;
    case Quantity::frequency: return frequency_units;
    case Quantity::angle: return angle_units;
    case Quantity::angle_rate: return angle_rate_units;
    case Quantity::area: return area_units;
    case Quantity::power: return power_units;
    case Quantity::ratio_db: return decibel_units;
    case Quantity::temperature: return temperature_units;
    case Quantity::voltage: return voltage_units;
  }
  return {};
}

std::string_view noun_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::number: return "number";
    case Quantity::count: return "whole number";
    case Quantity::length: return "length";
    case Quantity::time: return "time";
    case Quantity::frequency: return "frequency";
    case Quantity::angle: return "angle";
    case Quantity::angle_rate: return "rate of turn";
    case Quantity::area: return "area";
    case Quantity::power: return "power";
    case Quantity::ratio_db: return "ratio in decibels";
    case Quantity::temperature: return "temperature";
    case Quantity::voltage: return "voltage";
  }
  return "number";
}

std::string units_listed(Quantity quantity) {
  const auto units = table_of(quantity);
  std::string text;
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (i > 0) text += i + 1 == units.size() ? " or " : ", ";
    text += units[i].name;
  }
  if (quantity == Quantity::ratio_db) text += ", or a bare factor such as x100";
  return text;
}

// What people and their spreadsheets type for the characters that units and numbers are made of.
constexpr std::pair<std::string_view, std::string_view> spellings[] = {
    {"\xC2\xB5", "u"},      // micro sign
    {"\xCE\xBC", "u"},      // Greek mu
    {"\xC2\xB2", "2"},      // superscript two
    {"\xC2\xB0", "deg"},    // degree sign
    {"\xC2\xA0", " "},      // blank that does not break
    {"\xE2\x80\xAF", " "},  // narrow one
    {"\xE2\x88\x92", "-"},  // minus sign
    {"\xE2\x80\xB2", "'"},  // prime
    {"\xC3\x97", "x"},      // multiplication sign
    {"^2", "2"},
};

std::string plain_text(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  while (!text.empty()) {
    const auto found = std::ranges::find_if(spellings, [&](const auto& pair) { return text.starts_with(pair.first); });
    if (found != std::end(spellings)) {
      plain += found->second;
      text.remove_prefix(found->first.size());
    } else {
      plain += text.front();
      text.remove_prefix(1);
    }
  }
  return plain;
}

// Texts can be of any length, messages cannot.
std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 60;
  text = core::trimmed(text);
  if (text.size() <= longest) return fmt::format("'{}'", text);
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not within a character
  return fmt::format("'{}...'", text.substr(0, end));
}

QuantityReading no_quantity(std::string failure) { return {std::nullopt, std::move(failure)}; }

// A unit of which only the prefix is in the other case is another unit: mHz is not MHz.
bool other_prefix(std::string_view typed, const Unit& unit) {
  return unit.prefixed && typed.front() != unit.name.front() && typed.substr(1) == unit.name.substr(1);
}

struct UnitSearch {
  const Unit* unit = nullptr;
  std::string failure;
};

UnitSearch find_unit(std::string_view typed, Quantity quantity, std::string_view text) {
  const auto units = table_of(quantity);
  UnitSearch search;
  std::string alike;
  for (const Unit& unit : units) {
    if (unit.name == typed) return {&unit, {}};
    if (!core::equal_ignoring_case(unit.name, typed)) continue;
    if (!alike.empty()) alike += " or ";
    alike += unit.name;
    search.unit = search.unit == nullptr && alike == unit.name && !other_prefix(typed, unit) ? &unit : nullptr;
  }
  if (search.unit != nullptr) return search;
  if (!alike.empty())
    search.failure = fmt::format("'{}' in {} is not clear; write {} with these capital and small letters", typed,
                                 quoted(text), alike);
  else if (units.empty())
    search.failure = fmt::format("{} has a unit, '{}'; expected a {} alone", quoted(text), typed, noun_of(quantity));
  else
    search.failure =
        fmt::format("{} is not a valid {}; try {}", quoted(text), noun_of(quantity), units_listed(quantity));
  return search;
}

std::string comma_failure(std::string_view text, std::string_view number) {
  std::string mended(number);
  std::ranges::replace(mended, ',', '.');
  if (std::ranges::count(mended, '.') > 1)
    return fmt::format("{} has commas; write the number without them, with a point before decimals", quoted(text));
  return fmt::format("{} has a comma; the decimal mark is the point: {}", quoted(text), mended);
}

// Why what stands behind a number is no unit, where it looks like a part of the number; empty where it does not.
std::string broken_number(std::string_view text, std::string_view whole, std::string_view rest) {
  const bool digit_follows = rest.size() > 1 && core::is_digit(rest[1]);
  if (rest.front() == ',') {
    const std::size_t end = whole.find_first_not_of("+-0123456789.,eE");
    const std::string_view number = core::trimmed(whole.substr(0, end));
    return digit_follows ? comma_failure(text, number) : fmt::format("{} has a comma after the number", quoted(text));
  }
  if (core::is_digit(rest.front())) {
    std::string mended(whole);
    std::erase_if(mended, core::is_blank);
    const std::size_t length = number_length(mended);
    return fmt::format("{} has a blank within the number; write {}", quoted(text), mended.substr(0, length));
  }
  if (rest.front() == '.' || rest.front() == '+' || rest.front() == '-')
    return fmt::format("{} is not a valid number: '{}' does not belong after one", quoted(text), rest);
  return {};
}

std::optional<double> converted(std::string_view number, const Unit& unit) {
  if (unit.law == Unit::Law::decimal) return core::parse_number(number, unit.exponent);
  const auto plain = core::parse_number(number);
  if (!plain) return std::nullopt;
  const double value =
      unit.law == Unit::Law::factor ? *plain * unit.factor : std::pow(10.0, (*plain + unit.factor) / 10.0);
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

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
  const auto units = table_of(quantity);
  return units.empty() ? fmt::format("{} is not a valid {}", quoted(text), noun_of(quantity))
                       : fmt::format("{} is not a valid {}; expected a number, with {} where it has a unit",
                                     quoted(text), noun_of(quantity), units_listed(quantity));
}

const Unit& unit_named(Quantity quantity, std::string_view name) {
  for (const Unit& unit : table_of(quantity))
    if (unit.name == name) return unit;
  static constexpr Unit pure{};
  if (name.empty()) return table_of(quantity).empty() ? pure : table_of(quantity).front();
  throw std::invalid_argument(fmt::format("'{}' is not a valid unit of a {}", name, noun_of(quantity)));
}

std::string text_in(double value, const Unit& unit) {
  std::string number;
  if (!std::isfinite(value))
    number = std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
  else if (unit.law == Unit::Law::decimal)
    number = core::format_number(value, -unit.exponent);
  else
    number = core::format_number(unit.law == Unit::Law::factor ? value / unit.factor
                                                               : 10.0 * std::log10(value) - unit.factor);
  return unit.name.empty() ? number : fmt::format("{} {}", number, unit.name);
}

}  // namespace

std::size_t number_length(std::string_view text) {
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  std::size_t digits = 0;
  while (i < text.size() && core::is_digit(text[i])) ++i, ++digits;
  if (i < text.size() && text[i] == '.') ++i;
  while (i < text.size() && core::is_digit(text[i])) ++i, ++digits;
  if (digits == 0) return 0;
  if (i == text.size() || std::string_view("eEdD").find(text[i]) == std::string_view::npos) return i;
  std::size_t end = i + 1;
  if (end < text.size() && (text[end] == '+' || text[end] == '-')) ++end;
  if (end == text.size() || !core::is_digit(text[end])) return i;
  while (end < text.size() && core::is_digit(text[end])) ++end;
  return end;
}

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
  const auto value = converted(number, *unit);
  if (!value) return no_quantity(fmt::format("{} is too large for a number", quoted(text)));
  if (quantity == Quantity::count && *value != std::floor(*value))
    return no_quantity(
        fmt::format("{} is not a valid whole number; try {}", quoted(text), core::format_number(std::round(*value))));
  return {*value, {}};
}

std::string quantity_text(double value, Quantity quantity) {
  const auto units = table_of(quantity);
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
  for (const Unit& unit : table_of(quantity)) names.push_back(unit.name);
  return names;
}

int exponent_of(std::string_view name, Quantity quantity) {
  const Unit& unit = unit_named(quantity, name);
  if (unit.law != Unit::Law::decimal)
    throw std::invalid_argument(fmt::format("'{}' is not a valid power of ten of a {}", name, noun_of(quantity)));
  return unit.exponent;
}

}  // namespace sarsim::scene
