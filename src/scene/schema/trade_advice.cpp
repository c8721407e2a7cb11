#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/schema/trade_words.hpp"
#include "scene/schema/unit_table.hpp"

/// Looking up the words of the trade, and turning their values into those of fields.
namespace sarsim::scene {

namespace {

constexpr double reference_k = 290.0;       // T0 of noise figures
constexpr double half_power_width = 0.886;  // of an even aperture, in wavelengths

// Small letters without what people put between words.
std::string folded(std::string_view text) {
  std::string made;
  for (const char c : text)
    if (c != '_' && c != '-' && c != ' ' && c != '.') made += core::lower(c);
  return made;
}

template <class Visit>
bool any_name(std::string_view names, const Visit& visit) {
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(' '), names.size());
    if (end > 0 && visit(names.substr(0, end))) return true;
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return false;
}

bool holds(std::string_view names, std::string_view folded_word) {
  return any_name(names, [&](std::string_view name) { return folded(name) == folded_word; });
}

// A unit at the end of a name: "fc_ghz".
struct NameUnit {
  std::string_view ending;
  std::string_view unit;
};
constexpr std::array<NameUnit, 25> name_units{
    {{"_ghz", "GHz"}, {"_mhz", "MHz"}, {"_khz", "kHz"},   {"_hz", "Hz"}, {"_dbm", "dBm"},
     {"_dbw", "dBW"}, {"_dbi", "dBi"}, {"_dbsm", "dBsm"}, {"_db", "dB"}, {"_kw", "kW"},
     {"_w", "W"},     {"_km", "km"},   {"_cm", "cm"},     {"_mm", "mm"}, {"_mps", "m/s"},
     {"_m", "m"},     {"_us", "us"},   {"_ns", "ns"},     {"_ms", "ms"}, {"_sec", "s"},
     {"_s", "s"},     {"_deg", "deg"}, {"_rad", "rad"},   {"_k", "K"},   {"rpm", "rpm"}}};

const NameUnit* unit_of_name(std::string_view name) {
  const std::string small = core::lower_case(name);
  const auto found = std::ranges::find_if(name_units, [&](const NameUnit& one) { return small.ends_with(one.ending); });
  return found == name_units.end() ? nullptr : &*found;
}

const TradeWord* word_called(std::string_view folded_name, std::string_view kind) {
  const TradeWord* general = nullptr;
  for (const TradeWord& word : trade_words()) {
    if (!holds(word.names, folded_name)) continue;
    if (!kind.empty() && word.kind == kind) return &word;
    if (general == nullptr && (kind.empty() || word.kind.empty())) general = &word;
  }
  return general;
}

// What a law takes and gives.
struct LawKinds {
  TradeLaw law;
  Quantity from;
  Quantity to;
};
constexpr std::array<LawKinds, 9> law_kinds{{{TradeLaw::reciprocal, Quantity::time, Quantity::frequency},
                                             {TradeLaw::wavelength, Quantity::length, Quantity::frequency},
                                             {TradeLaw::cell, Quantity::length, Quantity::frequency},
                                             {TradeLaw::noise_figure, Quantity::ratio_db, Quantity::temperature},
                                             {TradeLaw::turn_period, Quantity::time, Quantity::angle_rate},
                                             {TradeLaw::off_nadir, Quantity::angle, Quantity::angle},
                                             {TradeLaw::negative, Quantity::angle, Quantity::angle},
                                             {TradeLaw::aperture, Quantity::length, Quantity::angle},
                                             {TradeLaw::none, Quantity::number, Quantity::number}}};

double converted(TradeLaw law, double x, std::optional<double> carrier_hz) {
  constexpr double c = core::exact_light_speed_mps;
  switch (law) {
    case TradeLaw::reciprocal: return 1.0 / x;
    case TradeLaw::wavelength: return c / x;
    case TradeLaw::cell: return c / (2.0 * x);
    case TradeLaw::slant_range: return c * x / 2.0;
    case TradeLaw::turns: return 360.0 * x;
    case TradeLaw::noise_figure: return reference_k * std::pow(10.0, x / 10.0);
    case TradeLaw::turn_period: return 360.0 / x;
    case TradeLaw::off_nadir: return x - 90.0;
    case TradeLaw::negative: return -std::abs(x);
    case TradeLaw::aperture: return half_power_width * c / carrier_hz.value_or(0.0) / x * core::deg_per_rad;
    case TradeLaw::same:
    case TradeLaw::same_with_unit:
    case TradeLaw::none: break;
  }
  return NAN;
}

// What is usually meant where a field gets a value of another quantity.
struct FieldConversion {
  std::string_view path;  // the end of the field's
  Quantity given;
  TradeLaw law;
  std::string_view formula;  // of x
};
constexpr FieldConversion field_conversions[] = {
    {"repetition.frequency", Quantity::time, TradeLaw::reciprocal, "1/({})"},
    {"carrier.frequency", Quantity::length, TradeLaw::wavelength, "c/({})"},
    {"carrier.frequency", Quantity::time, TradeLaw::reciprocal, "1/({})"},
    {"carrier.step", Quantity::length, TradeLaw::cell, "c/(2 * {})"},
    {"pulse.bandwidth", Quantity::length, TradeLaw::cell, "c/(2 * {})"},
    {"pulse.bandwidth", Quantity::time, TradeLaw::reciprocal, "1/({})"},
    {"pulse.width", Quantity::frequency, TradeLaw::reciprocal, "1/({})"},
    {"sample_rate", Quantity::time, TradeLaw::reciprocal, "1/({})"},
    {"sample_rate", Quantity::length, TradeLaw::cell, "c/(2 * {})"},
    {"range[0]", Quantity::time, TradeLaw::slant_range, "c * {}/2"},
    {"range[1]", Quantity::time, TradeLaw::slant_range, "c * {}/2"},
    {"time[0]", Quantity::frequency, TradeLaw::reciprocal, "1/({})"},
    {"azimuth_width", Quantity::length, TradeLaw::aperture, "0.886 wavelength/({})"},
    {"elevation_width", Quantity::length, TradeLaw::aperture, "0.886 wavelength/({})"},
    {"noise_temperature", Quantity::ratio_db, TradeLaw::noise_figure, "290 K * 10^(NF/10) of a noise figure of {}"},
    {"beam.rate", Quantity::time, TradeLaw::turn_period, "360 deg/({})"},
    {"beam.rate", Quantity::frequency, TradeLaw::turns, "360 deg * {}"},
    {"rotation_rate", Quantity::frequency, TradeLaw::turns, "360 deg * {}"},
    {"rotation_rate", Quantity::time, TradeLaw::turn_period, "360 deg/({})"},
};

// Levels without what they are relative to.
std::string level_hint(const FieldSpec& spec, double level_db) {
  const std::string number = core::format_number(level_db);
  if (spec.quantity == Quantity::area) return fmt::format("write \"{} dBsm\"", number);
  if (spec.quantity == Quantity::power) return fmt::format("write \"{0} dBW\" or \"{0} dBm\"", number);
  return {};
}

// For people: four digits are enough.
std::string rounded_text(double value, Quantity quantity) {
  const auto digits = core::parse_number(fmt::format("{:.4g}", value));
  return quantity_text(digits.value_or(value), quantity);
}

// What stands in angle brackets in a line.
std::string_view sample_in(std::string_view line) {
  const std::size_t open = line.find('<');
  const std::size_t close = line.find('>', open);
  return close == std::string_view::npos ? std::string_view() : line.substr(open + 1, close - open - 1);
}

std::optional<Measured> measured(std::string_view text) {
  const QuantityResult result = evaluate(text, Quantity::number, {});
  return result.value ? Measured{*result.value, {}} : result.other;
}

// The value as a field takes it that takes the sample; empty where it does not.
std::string taken_as(std::string_view sample, const std::string& value) {
  const auto wanted = measured(sample);
  if (!wanted || value.starts_with('[')) return value;
  const auto found = measured(value);
  if (!found) return {};
  if (found->dimension.pure() || found->dimension == wanted->dimension) return value;
  const bool level_of_area =
      found->dimension == dimension_of(Quantity::ratio_db) && wanted->dimension == dimension_of(Quantity::area);
  return level_of_area ? fmt::format("{} dBsm", core::format_number(found->value)) : std::string();
}

// Whether the line and the value agree in that the field holds a list.
bool stands_alone(std::string_view line, std::string_view value) {
  const bool list = line.find("[\"<") != std::string_view::npos || line.find("<[") != std::string_view::npos;
  return !value.empty() && list == value.starts_with('[');
}

// The value as the field takes it; empty where that cannot be told.
std::string value_of(const TradeWord& word, const TradeUse& use) {
  const std::string_view typed = core::trimmed(use.value);
  if (typed.empty() || word.law == TradeLaw::none) return {};
  const NameUnit* const of_name = unit_of_name(use.name);
  const bool bare = number_length(typed) == typed.size();
  const std::string given =
      bare && of_name != nullptr ? fmt::format("{} {}", typed, of_name->unit) : std::string(typed);
  if (word.law == TradeLaw::same_with_unit && number_length(given) == given.size()) return {};
  if (keeps_value(word.law)) return taken_as(sample_in(word.line), given);
  const auto kinds = std::ranges::find(law_kinds, word.law, &LawKinds::law);
  const QuantityResult result = evaluate(given, kinds->from, {});
  if (!result.value) return {};
  const double value = converted(word.law, *result.value, use.carrier_hz);
  return std::isfinite(value) ? rounded_text(value, kinds->to) : std::string();
}

// The line with the value in place of what stands in angle brackets.
std::string filled(std::string_view line, const std::string& value) {
  std::string made;
  while (!line.empty()) {
    const std::size_t open = line.find('<');
    const std::size_t close = line.find('>', open);
    if (close == std::string_view::npos) break;
    made += line.substr(0, open);
    const std::string_view sample = line.substr(open + 1, close - open - 1);
    const bool fits = !value.empty() && value.starts_with('[') == sample.starts_with('[');
    made += fits ? std::string_view(value) : sample;
    line.remove_prefix(close + 1);
  }
  return made + std::string(line);
}

std::string_view kind_of(const TradeWord& word) { return word.field.substr(0, word.field.find('.')); }
std::string_view path_of(const TradeWord& word) {
  const std::size_t dot = word.field.find('.');
  return dot == std::string_view::npos ? std::string_view() : word.field.substr(dot + 1);
}

bool is_single_table(std::string_view kind) { return kind == "options" || kind == "world" || kind == "atmosphere"; }

}  // namespace

bool is_spelling(std::string_view names, std::string_view typed) {
  const std::string wanted = folded(typed);
  return !wanted.empty() && any_name(names, [&](std::string_view name) { return folded(name).starts_with(wanted); });
}

const TradeWord* trade_word(std::string_view name, std::string_view kind) {
  constexpr std::size_t longest = 64;
  if (name.size() > longest) return nullptr;
  if (const TradeWord* const word = word_called(folded(name), kind)) return word;
  const NameUnit* const unit = unit_of_name(name);
  if (unit == nullptr) return nullptr;
  return word_called(folded(name.substr(0, name.size() - unit->ending.size())), kind);
}

const TradeWord* nearest_trade_word(std::string_view name, std::string_view kind) {
  constexpr std::size_t enough = 5;  // letters: shorter words are near to too many
  if (name.size() < enough) return nullptr;
  std::vector<std::string> names;
  for (const TradeWord& word : trade_words())
    if (word.kind.empty() || word.kind == kind)
      any_name(word.names, [&](std::string_view one) {
        if (one.size() >= enough) names.push_back(folded(one));
        return false;
      });
  const std::string typed = folded(name);
  const std::string nearest = core::nearest_word(typed, names);
  const bool is_near = !nearest.empty() && core::edit_distance(typed, nearest) <= 1 + typed.size() / 8;
  return is_near ? word_called(nearest, kind) : nullptr;
}

const TradeChoice* trade_choice(std::string_view word, std::string_view choice) {
  const std::string wanted = folded(word);
  const auto all = trade_choices();
  const auto found = std::ranges::find_if(
      all, [&](const TradeChoice& one) { return one.choice == choice && holds(one.names, wanted); });
  return found == all.end() ? nullptr : &*found;
}

const TradeHeader* trade_header(std::string_view header) {
  const std::string wanted = folded(header);
  const auto all = trade_headers();
  const auto found = std::ranges::find_if(all, [&](const TradeHeader& one) { return holds(one.names, wanted); });
  return found == all.end() ? nullptr : &*found;
}

std::string_view table_of_word(const TradeWord& word) {
  const std::string_view table = path_of(word).substr(0, path_of(word).find('.'));
  return word.line.starts_with(fmt::format("{} = {{", table)) ? table : std::string_view();
}

std::string trade_advice(const TradeWord& word, const TradeUse& use) {
  if (word.line.empty()) return std::string(word.note);
  const std::string value = value_of(word, use);
  const std::string_view kind = kind_of(word);
  const std::string_view table = table_of_word(word), path = path_of(word);
  const bool alone = use.has_table && stands_alone(word.line, value) && !table.empty() && path != table;
  const std::string_view quote = value.starts_with('[') ? "" : "\"";
  std::string text = alone ? fmt::format("write {0} = {1}{2}{1} in {3}", path.substr(table.size() + 1), quote,
                                         core::clipped(value), table)
                           : "write " + filled(word.line, core::clipped(value));
  if (!kind.empty() && kind != use.kind)
    text += is_single_table(kind) ? fmt::format(" in [{}]", kind) : fmt::format(" in [[{}]]", kind);
  if (!word.note.empty()) text += fmt::format(" ({})", word.note);
  return text;
}

std::string trade_setting(const TradeWord& word, const TradeUse& use, std::string_view owner) {
  if (word.field.empty()) return std::string(word.note);
  std::string value = value_of(word, use);
  std::string text;
  if (owner.empty() || kind_of(word) != use.kind)
    text = fmt::format("it is called {}", word.field);
  else
    text = fmt::format("write {}.{}{}", owner, path_of(word), value.empty() ? "" : "=" + core::clipped(value));
  if (!word.note.empty()) text += fmt::format(" ({})", word.note);
  return text;
}

std::string conversion_hint(const FieldSpec& spec, std::string_view text, const Measured& found,
                            std::optional<double> carrier_hz) {
  const std::string given = core::clipped(core::trimmed(text));
  if (found.dimension == dimension_of(Quantity::ratio_db))
    if (std::string hint = level_hint(spec, found.value); !hint.empty()) return hint;
  for (const FieldConversion& known : field_conversions) {
    if (!spec.key.ends_with(known.path) || found.dimension != dimension_of(known.given)) continue;
    const std::string formula = fmt::format(fmt::runtime(known.formula), given);
    const double value = converted(known.law, found.value, carrier_hz);
    return std::isfinite(value) ? fmt::format("write \"{}\", which is {}", rounded_text(value, spec.quantity), formula)
                                : fmt::format("it is {}", formula);
  }
  return {};
}

std::string trade_advice(const TradeChoice& choice) {
  if (choice.word.empty()) return std::string(choice.note);
  return choice.note.empty() ? fmt::format("write \"{}\"", choice.word)
                             : fmt::format("write \"{}\" ({})", choice.word, choice.note);
}

}  // namespace sarsim::scene
