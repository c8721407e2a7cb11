#include "scene/schema/unit_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::scene {

namespace {

constexpr Unit decimal(std::string_view name, int exponent, bool prefixed = true, bool shown = true) {
  return {name, Unit::Law::decimal, exponent, 1.0, shown, prefixed};
}
constexpr Unit scaled(std::string_view name, double factor, bool prefixed = false) {
  return {name, Unit::Law::factor, 0, factor, false, prefixed};
}
constexpr Unit decibel(std::string_view name, double offset) {
  return {name, Unit::Law::decibel, 0, offset, false, false};
}

// Units that are known beside the usual ones: names of [let] come before them.
constexpr Unit further(Unit unit, bool told = false) {
  unit.yields = true;
  unit.shown = false;
  unit.told = told;
  return unit;
}
constexpr Unit quotient(std::string_view name, double factor, double divisor) {
  Unit unit = scaled(name, factor);
  unit.divisor = divisor;
  return unit;
}
// Of thousands, so that a number is rounded as it is with the unit and its prefix apart.
constexpr Unit kilo_quotient(std::string_view name, double divisor) {
  Unit unit = quotient(name, 1.0, divisor);
  unit.exponent = 3;
  return unit;
}
constexpr Unit shifted(std::string_view name, double offset) {
  return {name, Unit::Law::offset, 0, offset, false, false};
}

constexpr double inch_m = 0.0254;
constexpr double mile_m = 1609.344;
constexpr double nautical_mile_m = 1852.0;
constexpr double dipole_gain_db = 2.15;  // above an isotropic antenna

constexpr Unit length_units[] = {decimal("m", 0, false),
                                 decimal("nm", -9),
                                 decimal("um", -6),
                                 decimal("mm", -3),
                                 decimal("cm", -2, true, false),
                                 decimal("km", 3),
                                 scaled("ft", 0.3048),
                                 scaled("nmi", nautical_mile_m),
                                 further(scaled("NM", nautical_mile_m)),
                                 further(scaled("mi", mile_m)),
                                 further(scaled("yd", 36 * inch_m)),
                                 further(scaled("in", inch_m))};
constexpr Unit time_units[] = {
    decimal("s", 0, false), decimal("ns", -9),   decimal("us", -6),           decimal("ms", -3),
    scaled("min", 60.0),    scaled("h", 3600.0), further(decimal("ps", -12)), further(scaled("day", 86400.0))};
constexpr Unit frequency_units[] = {decimal("Hz", 0, false), decimal("kHz", 3), decimal("MHz", 6), decimal("GHz", 9),
                                    further(decimal("THz", 12))};
constexpr Unit angle_units[] = {decimal("deg", 0, false),
                                scaled("rad", core::deg_per_rad),
                                scaled("mrad", core::deg_per_rad * 1e-3, true),
                                scaled("'", 1.0 / 60.0),
                                further(scaled("arcmin", 1.0 / 60.0)),
                                further(quotient("arcsec", 1.0, 3600.0)),
                                further(quotient("mil", 360.0, 6400.0)),
                                further(scaled("turn", 360.0)),
                                further(scaled("rev", 360.0))};
constexpr Unit angle_rate_units[] = {decimal("deg/s", 0, false),
                                     scaled("rad/s", core::deg_per_rad),
                                     scaled("rpm", 6.0),
                                     further(quotient("deg/min", 1.0, 60.0), true),
                                     further(scaled("turn/min", 6.0)),
                                     further(scaled("rev/min", 6.0)),
                                     further(scaled("turn/s", 360.0)),
                                     further(scaled("rev/s", 360.0)),
                                     further(scaled("mrad/s", core::deg_per_rad * 1e-3, true)),
                                     further(quotient("deg/h", 1.0, 3600.0))};
constexpr Unit area_units[] = {decimal("m2", 0, false), decimal("cm2", -4, true, false), decibel("dBsm", 0.0),
                               further(decibel("dBm2", 0.0))};
constexpr Unit power_units[] = {decimal("W", 0, false),     decimal("mW", -3),         decimal("kW", 3),
                                decimal("MW", 6),           decibel("dBW", 0.0),       decibel("dBm", -30.0),
                                further(decimal("uW", -6)), further(decimal("GW", 9)), further(decibel("dBkW", 30.0))};
constexpr Unit decibel_units[] = {decimal("dB", 0, false), further(decimal("dBi", 0, false), true),
                                  further(shifted("dBd", dipole_gain_db))};
constexpr Unit temperature_units[] = {decimal("K", 0, false), further(shifted("degC", 273.15), true)};
constexpr Unit voltage_units[] = {decimal("V", 0, false), decimal("nV", -9), decimal("uV", -6), decimal("mV", -3),
                                  further(decimal("kV", 3))};
constexpr Unit speed_units[] = {decimal("m/s", 0, false),
                                decimal("km/s", 3, true, false),
                                further(kilo_quotient("km/h", 3600.0), true),
                                further(quotient("kn", nautical_mile_m, 3600.0), true),
                                further(quotient("kt", nautical_mile_m, 3600.0)),
                                further(scaled("ft/s", 0.3048)),
                                further(quotient("mph", mile_m, 3600.0))};

constexpr double gravity_mps2 = 9.80665;
constexpr Unit acceleration_units[] = {decimal("m/s2", 0, false), scaled("g", gravity_mps2),
                                       scaled("mg", 1e-3 * gravity_mps2, true),
                                       scaled("ug", 1e-6 * gravity_mps2, true)};

// What people and their spreadsheets type for the characters that units and numbers are made of.
struct Spelling {
  std::string_view typed;
  std::string_view plain;
  std::string_view in_expression;
};

constexpr Spelling spellings[] = {
    {"\xC2\xB5", "u", "u"},      // micro sign
    {"\xCE\xBC", "u", "u"},      // Greek mu
    {"\xC2\xB2", "2", "^2"},     // superscript two
    {"\xC2\xB0", "deg", "deg"},  // degree sign
    {"\xC2\xA0", " ", " "},      // blank that does not break
    {"\xE2\x80\xAF", " ", " "},  // narrow one
    {"\xE2\x88\x92", "-", "-"},  // minus sign
    {"\xE2\x80\xB2", "'", "'"},  // prime
    {"\xC3\x97", "x", "*"},      // multiplication sign
    {"^2", "2", "^2"},
};

// Calls with each piece of the text: its length and the spelling that it is, null for a single character.
template <class Take>
void in_pieces(std::string_view text, const Take& take) {
  while (!text.empty()) {
    const auto found = std::ranges::find_if(spellings, [&](const Spelling& s) { return text.starts_with(s.typed); });
    const Spelling* spelling = found == std::end(spellings) ? nullptr : found;
    take(text, spelling);
    text.remove_prefix(spelling == nullptr ? 1 : spelling->typed.size());
  }
}

// How the trade, or a person in a hurry, spells units; what it means is told, not taken.
struct UnitSpelling {
  std::string_view typed;
  std::string_view name;
};
constexpr UnitSpelling unit_spellings[] = {
    {"knot", "kn"},
    {"knots", "kn"},
    {"kts", "kn"},
    {"kph", "km/h"},
    {"kmh", "km/h"},
    {"kmph", "km/h"},
    {"mps", "m/s"},
    {"fps", "ft/s"},
    {"meter", "m"},
    {"meters", "m"},
    {"metre", "m"},
    {"metres", "m"},
    {"kilometers", "km"},
    {"kilometres", "km"},
    {"micron", "um"},
    {"microns", "um"},
    {"feet", "ft"},
    {"foot", "ft"},
    {"inch", "in"},
    {"inches", "in"},
    {"yards", "yd"},
    {"mile", "mi"},
    {"miles", "mi"},
    {"naut", "nmi"},
    {"sec", "s"},
    {"secs", "s"},
    {"second", "s"},
    {"seconds", "s"},
    {"msec", "ms"},
    {"usec", "us"},
    {"nsec", "ns"},
    {"psec", "ps"},
    {"mins", "min"},
    {"minute", "min"},
    {"minutes", "min"},
    {"hr", "h"},
    {"hrs", "h"},
    {"hour", "h"},
    {"hours", "h"},
    {"days", "day"},
    {"hertz", "Hz"},
    {"pps", "Hz"},
    {"sps", "Hz"},
    {"ksps", "kHz"},
    {"Msps", "MHz"},
    {"Gsps", "GHz"},
    {"S/s", "Hz"},
    {"kS/s", "kHz"},
    {"MS/s", "MHz"},
    {"GS/s", "GHz"},
    {"Sa/s", "Hz"},
    {"kSa/s", "kHz"},
    {"MSa/s", "MHz"},
    {"GSa/s", "GHz"},
    {"megahertz", "MHz"},
    {"gigahertz", "GHz"},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"degs", "deg"},
    {"radian", "rad"},
    {"radians", "rad"},
    {"mils", "mil"},
    {"turns", "turn"},
    {"revs", "rev"},
    {"revolutions", "rev"},
    {"rps", "rev/s"},
    {"dps", "deg/s"},
    {"arcminutes", "arcmin"},
    {"arcseconds", "arcsec"},
    {"watt", "W"},
    {"watts", "W"},
    {"kilowatts", "kW"},
    {"milliwatts", "mW"},
    {"kelvin", "K"},
    {"kelvins", "K"},
    {"celsius", "degC"},
    {"centigrade", "degC"},
    {"c", "degC"},
    {"volt", "V"},
    {"volts", "V"},
    {"db", "dB"},
    {"decibel", "dB"},
    {"decibels", "dB"},
    {"dbic", "dBi"},
    {"dbc", "dB"},
    {"dbmw", "dBm"},
    {"sqm", "m2"},
    {"sm", "m2"},
    {"gee", "g"},
    {"gees", "g"},
};

// A unit of which only the prefix is in the other case is another unit: mHz is not MHz.
bool other_prefix(std::string_view typed, const Unit& unit) {
  return unit.prefixed && typed.front() != unit.name.front() && typed.substr(1) == unit.name.substr(1);
}

}  // namespace

std::span<const Unit> unit_table(Quantity quantity) {
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
    case Quantity::speed: return speed_units;
    case Quantity::acceleration: return acceleration_units;
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
    case Quantity::speed: return "speed";
    case Quantity::acceleration: return "acceleration";
  }
  return "number";
}

std::string with_article(std::string_view noun) { return fmt::format("{} {}", noun.front() == 'a' ? "an" : "a", noun); }

std::string units_listed(Quantity quantity) {
  std::vector<std::string> told;
  for (const Unit& unit : unit_table(quantity))
    // A quote alone, at the end perhaps, is not seen.
    if (unit.told) told.emplace_back(unit.name == "'" ? "minutes of arc (')" : unit.name);
  std::string text;
  for (std::size_t i = 0; i < told.size(); ++i) text += (i == 0 ? "" : i + 1 == told.size() ? " or " : ", ") + told[i];
  if (quantity == Quantity::ratio_db) text += ", or a bare factor such as x100";
  return text;
}

UnitSearch find_unit(std::string_view typed, Quantity quantity, std::string_view text) {
  const auto units = unit_table(quantity);
  UnitSearch search{nullptr, quantity, {}};
  std::string alike;
  for (const Unit& unit : units) {
    if (unit.name == typed) return {&unit, quantity, {}};
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
    search.failure =
        fmt::format("{} has a unit, {}; expected a {} alone", quoted(text), quoted(typed), noun_of(quantity));
  else
    search.failure =
        fmt::format("{} is not a valid {}; try {}", quoted(text), noun_of(quantity), units_listed(quantity));
  if (const std::string_view meant = unit_meant_by(typed); alike.empty() && !meant.empty())
    search.failure += fmt::format("; did you mean '{}'?", meant);
  return search;
}

UnitSearch find_unit(std::string_view typed, std::string_view text) {
  if (UnitSearch exact = unit_called(typed); exact.unit != nullptr) return exact;
  for (const Quantity quantity : every_quantity)
    for (const Unit& unit : unit_table(quantity))
      if (core::equal_ignoring_case(unit.name, typed)) return find_unit(typed, quantity, text);
  return {};
}

UnitSearch unit_called(std::string_view name) {
  for (const Quantity quantity : every_quantity)
    for (const Unit& unit : unit_table(quantity))
      if (unit.name == name) return {&unit, quantity, {}};
  return {};
}

std::string_view unit_meant_by(std::string_view typed) {
  const auto found = std::ranges::find_if(
      unit_spellings, [&](const UnitSpelling& spelling) { return core::equal_ignoring_case(spelling.typed, typed); });
  return found == std::end(unit_spellings) ? std::string_view() : found->name;
}

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

std::optional<double> in_base_unit(std::string_view number, const Unit& unit) {
  if (unit.law == Unit::Law::decimal) return core::parse_number(number, unit.exponent);
  const auto plain = core::parse_number(number, unit.exponent);
  if (!plain) return std::nullopt;
  const double value = unit.law == Unit::Law::factor   ? *plain * unit.factor / unit.divisor
                       : unit.law == Unit::Law::offset ? *plain + unit.factor
                                                       : std::pow(10.0, (*plain + unit.factor) / 10.0);
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::string plain_text(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  in_pieces(text, [&](std::string_view rest, const Spelling* spelling) {
    // A square belongs to a unit: "m^2". Behind a digit it would change the number: "10^2 m" is not 102 m.
    const bool square = spelling != nullptr && spelling->in_expression == "^2";
    const bool misplaced = square && !plain.empty() && core::is_digit(plain.back());
    plain += spelling == nullptr || misplaced ? rest.substr(0, 1) : spelling->plain;
  });
  return plain;
}

std::string plain_expression(std::string_view text, std::vector<std::size_t>& origins) {
  std::string plain;
  origins.clear();
  in_pieces(text, [&](std::string_view rest, const Spelling* spelling) {
    plain += spelling == nullptr ? rest.substr(0, 1) : spelling->in_expression;
    origins.resize(plain.size(), text.size() - rest.size());
  });
  origins.push_back(text.size());
  return plain;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 60;
  text = core::trimmed(text);
  if (text.size() <= longest) return fmt::format("'{}'", text);
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not within a character
  return fmt::format("'{}...'", text.substr(0, end));
}

bool begins_with_per_second(std::string_view text) {
  constexpr std::string_view unit = "1/s";
  if (!text.starts_with(unit)) return false;
  const char next = text.size() > unit.size() ? core::lower(text[unit.size()]) : ' ';
  return !(next >= 'a' && next <= 'z') && !core::is_digit(next) && next != '_';
}

std::string broken_number(std::string_view text, std::string_view whole, std::string_view rest) {
  const bool digit_follows = rest.size() > 1 && core::is_digit(rest[1]);
  if (rest.front() == ',') {
    const std::size_t end = whole.find_first_not_of("+-0123456789.,eE");
    const std::string_view number = core::trimmed(whole.substr(0, end));
    return digit_follows ? comma_failure(text, number) : fmt::format("{} has a comma after the number", quoted(text));
  }
  if (begins_with_per_second(rest)) {
    const std::string_view number = whole.substr(0, number_length(whole));
    return fmt::format("{} has 1/s for a unit; write {} Hz", quoted(text), core::clipped(number));
  }
  if (core::is_digit(rest.front())) {
    std::string corrected(whole);
    std::erase_if(corrected, core::is_blank);
    const std::size_t length = number_length(corrected);
    return fmt::format("{} has a blank within the number; write {}", quoted(text), corrected.substr(0, length));
  }
  if (rest.front() == '.' || rest.front() == '+' || rest.front() == '-')
    return fmt::format("{} is not a valid number: {} does not belong after one", quoted(text), quoted(rest));
  return {};
}

std::string comma_failure(std::string_view text, std::string_view number) {
  std::string corrected(number);
  std::ranges::replace(corrected, ',', '.');
  if (std::ranges::count(corrected, '.') > 1)
    return fmt::format("{} has commas; write the number without them, with a point before decimals", quoted(text));
  // "3,500" may be three and a half, or English thousands.
  constexpr std::size_t of_thousands = 4;  // the mark and three digits
  const std::size_t mark = corrected.find('.');
  if (mark != 0 && mark <= 3 && corrected.size() == mark + of_thousands)
    return fmt::format("{} has a comma; the decimal mark is the point, and thousands have no mark: {} or {}",
                       quoted(text), corrected, std::string(corrected).erase(mark, 1));
  return fmt::format("{} has a comma; the decimal mark is the point: {}", quoted(text), corrected);
}

}  // namespace sarsim::scene
