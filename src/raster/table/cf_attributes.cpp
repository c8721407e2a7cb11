#include "raster/table/cf_attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "core/text/separated.hpp"
#include "raster/table/axis_labels.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

struct UnitWord {
  std::string_view word;
  double factor;
  std::string_view si;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

// As udunits writes them, and as people do.
constexpr std::array<UnitWord, 59> unit_words{{
    {"s", 1.0, "s"},
    {"sec", 1.0, "s"},
    {"second", 1.0, "s"},
    {"seconds", 1.0, "s"},
    {"ms", 1e-3, "s"},
    {"millisecond", 1e-3, "s"},
    {"milliseconds", 1e-3, "s"},
    {"us", 1e-6, "s"},
    {"\xC2\xB5s", 1e-6, "s"},
    {"\xCE\xBCs", 1e-6, "s"},
    {"microsecond", 1e-6, "s"},
    {"microseconds", 1e-6, "s"},
    {"ns", 1e-9, "s"},
    {"nanosecond", 1e-9, "s"},
    {"nanoseconds", 1e-9, "s"},
    {"min", 60.0, "s"},
    {"minutes", 60.0, "s"},
    {"h", 3600.0, "s"},
    {"hours", 3600.0, "s"},
    {"m", 1.0, "m"},
    {"metre", 1.0, "m"},
    {"metres", 1.0, "m"},
    {"meter", 1.0, "m"},
    {"meters", 1.0, "m"},
    {"km", 1e3, "m"},
    {"kilometre", 1e3, "m"},
    {"kilometres", 1e3, "m"},
    {"kilometer", 1e3, "m"},
    {"kilometers", 1e3, "m"},
    {"cm", 1e-2, "m"},
    {"mm", 1e-3, "m"},
    {"ft", 0.3048, "m"},
    {"feet", 0.3048, "m"},
    {"nmi", 1852.0, "m"},
    {"Hz", 1.0, "Hz"},
    {"hertz", 1.0, "Hz"},
    {"s-1", 1.0, "Hz"},
    {"1/s", 1.0, "Hz"},
    {"kHz", 1e3, "Hz"},
    {"MHz", 1e6, "Hz"},
    {"GHz", 1e9, "Hz"},
    {"THz", 1e12, "Hz"},
    {"m s-1", 1.0, "m s-1"},
    {"m/s", 1.0, "m s-1"},
    {"m.s-1", 1.0, "m s-1"},
    {"km s-1", 1e3, "m s-1"},
    {"km/s", 1e3, "m s-1"},
    {"rad", 1.0, "rad"},
    {"radian", 1.0, "rad"},
    {"radians", 1.0, "rad"},
    {"deg", core::rad_per_deg, "rad"},
    {"degree", core::rad_per_deg, "rad"},
    {"degrees", core::rad_per_deg, "rad"},
    {"V", 1.0, "V"},
    {"volt", 1.0, "V"},
    {"volts", 1.0, "V"},
    {"mV", 1e-3, "V"},
    {"uV", 1e-6, "V"},
    {"nV", 1e-9, "V"},
}};

core::Problem key_problem(const std::string& what, std::string_view key, std::string found, std::string expected,
                          std::string hint) {
  return file_problem({}, fmt::format("{}: its attribute {} cannot be followed", what, key), std::move(found),
                      std::move(expected), std::move(hint));
}

using Named = std::pair<std::string, std::string>;

const std::string* word_of(const ArrayAttributes& attributes, std::string_view name) {
  const auto found = std::ranges::find(attributes.known, name, &Named::first);
  return found == attributes.known.end() ? nullptr : &found->second;
}

// All attributes that say what the numbers of an array mean, and what they may be.
struct MeaningKey {
  std::string_view name;
  const char* expected;
};

constexpr std::array<MeaningKey, 10> meaning_keys{{{"units", "a text"},
                                                   {"unit", "a text"},
                                                   {"scale_factor", "a number"},
                                                   {"add_offset", "a number"},
                                                   {"_FillValue", "a number"},
                                                   {"missing_value", "up to 16 numbers"},
                                                   {"valid_range", "2 numbers"},
                                                   {"valid_min", "a number"},
                                                   {"valid_max", "a number"},
                                                   {"_Unsigned", "true or false, as a text"}}};

// Counts become volts, and numbers SI units, in single or double precision: of others nothing would be left.
constexpr double smallest_factor = 1e-37;
constexpr double largest_factor = 1e29;

// The numbers of an attribute, separated by commas; nothing where one is none.
std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view word : core::pieces_of(text, ',')) {
    const auto number = core::parse_number(word);
    if (number)
      numbers.push_back(*number);
    else if (core::equal_ignoring_case(word, "nan"))
      numbers.push_back(std::numeric_limits<double>::quiet_NaN());
    else if (word == "inf" || word == "-inf")
      numbers.push_back(word == "inf" ? infinity : -infinity);
    else
      return std::nullopt;
  }
  return numbers;
}

// Reads attributes of numbers and keeps the first problem.
class CfReader {
 public:
  CfReader(const ArrayAttributes& attributes, const std::string& what) : attributes_(attributes), what_(what) {
    if (!attributes.complete)
      problem_ = file_problem({}, fmt::format("{}: its attributes cannot be read to the last one", what), {},
                              "a sound list of at most 1000", "remove those that say nothing of the numbers");
    for (const auto& [name, found] : attributes.unreadable) {
      const auto key = std::ranges::find(meaning_keys, name, &MeaningKey::name);
      if (key != meaning_keys.end()) refuse(name, found, key->expected, "write it so, or remove it");
    }
  }

  [[nodiscard]] const std::optional<core::Problem>& problem() const { return problem_; }

  // As many numbers as are wanted, at least one; empty where the attribute is not there or no such.
  std::vector<double> numbers(std::string_view key, std::size_t least, std::size_t most) {
    const std::string* const text = word_of(attributes_, key);
    if (text == nullptr) return {};
    auto found = numbers_of(*text);
    if (found && found->size() >= least && found->size() <= most) return std::move(*found);
    refuse(key, *text, least == most && least == 1 ? "a number" : fmt::format("{} numbers", least), "correct it");
    return {};
  }
  double number(std::string_view key, double otherwise) {
    const std::vector<double> found = numbers(key, 1, 1);
    if (found.empty()) return otherwise;
    if (std::isfinite(found.front()) || found.front() == otherwise) return found.front();
    refuse(key, fmt::format("{}", found.front()), "a finite number", "correct it");
    return otherwise;
  }
  // A number that others are multiplied by.
  double factor(std::string_view key) {
    const double found = number(key, 1.0);
    if (std::abs(found) >= smallest_factor && std::abs(found) <= largest_factor) return found;
    refuse(key, core::format_number(found), found == 0.0 ? "a number other than 0" : "a size from 1e-37 to 1e29",
           "correct it");
    return 1.0;
  }
  // Which numbers stand for none.
  void take_valid(ValueRule& rule) {
    for (const char* const key : {"_FillValue", "missing_value"})
      for (const double value : numbers(key, 1, 16))
        if (!std::isnan(value)) rule.missing.push_back(value);
    const std::vector<double> range = numbers("valid_range", 2, 2);
    if (!range.empty()) {
      rule.least = range[0];
      rule.most = range[1];
    }
    rule.least = std::max(rule.least, number("valid_min", rule.least));
    rule.most = std::min(rule.most, number("valid_max", rule.most));
    if (!(rule.least <= rule.most))
      refuse("valid_range", fmt::format("{:g}, {:g}", rule.least, rule.most), "the least and the largest valid number",
             "correct it");
  }
  // netCDF's way to say that whole numbers have another sign than their type has.
  void expect_sign(bool has_sign) {
    const std::string* const said = word_of(attributes_, "_Unsigned");
    if (said == nullptr || core::equal_ignoring_case(core::trimmed(*said), has_sign ? "false" : "true")) return;
    refuse("_Unsigned", fmt::format("{:.60}", *said),
           has_sign ? "false, as the type of the numbers has a sign" : "true, as the type of the numbers has no sign",
           "store the numbers in the type that they are of, and remove the attribute");
  }
  void refuse(std::string_view key, std::string found, std::string expected, std::string hint) {
    if (!problem_) problem_ = key_problem(what_, key, std::move(found), std::move(expected), std::move(hint));
  }

 private:
  const ArrayAttributes& attributes_;
  const std::string& what_;
  std::optional<core::Problem> problem_;
};

bool is_count_word(std::string_view word) {
  return word == "count" || word == "counts" || word == "digital_number" || word == "DN";
}

// Without a unit: the number itself, as CF writes it.
bool is_one(std::string_view word) {
  return word.empty() || word == "1" || word == "dimensionless" || word == "none" || word == "arbitrary" ||
         word == "a.u.";
}

// The multiple of a volt; counts and numbers without unit are what they are.
double take_units(CfReader& reader, const std::string* units, bool integers, SampleMeaning& meaning) {
  if (units == nullptr) return 1.0;
  const std::string_view word = core::trimmed(*units);
  if (is_one(word)) return 1.0;
  if (is_count_word(word)) {
    if (!integers)
      reader.refuse("units", *units, "V, as the numbers are not whole", "multiply them by the LSB, or store integers");
    return 1.0;
  }
  if (const auto unit = unit_of_samples(word)) {
    meaning.counts = false;
    return unit->volts;
  }
  reader.refuse("units", core::quoted_word(*units), "V, mV, uV, nV or count",
                "convert the samples to volts: complex amplitudes, not powers or decibels");
  return 1.0;
}

}  // namespace

std::optional<std::pair<double, std::string_view>> si_unit_of(std::string_view word) {
  const auto found = std::ranges::find(unit_words, core::trimmed(word), &UnitWord::word);
  if (found == unit_words.end()) return std::nullopt;
  return std::pair{found->factor, found->si};
}

std::optional<SampleUnit> unit_of_samples(std::string_view word) {
  word = core::trimmed(word);
  if (is_count_word(word)) return SampleUnit{true, 1.0};
  const auto unit = si_unit_of(word);
  if (!unit || unit->second != "V") return std::nullopt;
  return SampleUnit{false, unit->first};
}

std::variant<SampleMeaning, core::Problem> meaning_of_samples(const ArrayAttributes& attributes,
                                                              const std::string& what, NumberKind kind) {
  CfReader reader(attributes, what);
  SampleMeaning meaning;
  meaning.counts = kind.whole;
  // Older files of ours say `unit` alone, newer ones both.
  const std::string* units = word_of(attributes, "units");
  const std::string* const unit_too = word_of(attributes, "unit");
  if (units != nullptr && unit_too != nullptr && *units != *unit_too)
    reader.refuse("units", core::quoted_word(*units),
                  fmt::format("{}, as its attribute unit says", core::quoted_word(*unit_too)), "correct one of them");
  if (units == nullptr) units = unit_too;
  const double unit = take_units(reader, units, kind.whole, meaning);
  const double scale = reader.factor("scale_factor");
  if (const double offset = reader.number("add_offset", 0.0); offset != 0.0)
    reader.refuse("add_offset", core::format_number(offset), "0",
                  "what an offset means for I and Q is not defined: add it to the samples and remove the attribute");
  meaning.rule.scale = scale * unit;
  const bool counts_said = units != nullptr && is_count_word(core::trimmed(*units));
  if (scale != 1.0 && counts_said)
    reader.refuse("scale_factor", core::format_number(scale), "1 for counts", "say the LSB by the attribute lsb_v");
  // One of 1 says as well that the numbers are those of the unit.
  if (word_of(attributes, "scale_factor") != nullptr && !counts_said) meaning.counts = false;
  reader.take_valid(meaning.rule);
  reader.expect_sign(kind.has_sign);
  if (reader.problem()) return *reader.problem();
  return meaning;
}

std::optional<core::Problem> problem_of_dimensions(const std::vector<std::string>& names, const std::string& what) {
  for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 2); ++i) {
    const AxisLabels* const axis = words_of_axis(names[i]);
    if (axis == nullptr || (axis->of == AxisOf::columns) == (i == 1)) continue;
    return file_problem({}, fmt::format("{}: its dimensions are in the wrong order", what),
                        fmt::format("dimension {} is {}", i, names[i]), "rows (pulses) first, then columns",
                        "store it transposed: array.T in NumPy, .' in MATLAB");
  }
  return std::nullopt;
}

std::variant<AxisMeaning, core::Problem> meaning_of_axis(const ArrayAttributes& attributes, const std::string& what,
                                                         std::string_view units, NumberKind kind) {
  CfReader reader(attributes, what);
  AxisMeaning meaning{reader.factor("scale_factor"), reader.number("add_offset", 0.0)};
  reader.take_valid(meaning.valid);
  reader.expect_sign(kind.has_sign);
  if (const std::string* const said = word_of(attributes, "units"); said != nullptr && !core::trimmed(*said).empty()) {
    const auto unit = si_unit_of(*said);
    if (!unit || unit->second != units)
      reader.refuse("units", core::quoted_word(*said), fmt::format("{} or a multiple of it", units),
                    "convert the numbers, or correct the attribute");
    else {
      meaning.factor *= unit->first;
      meaning.offset *= unit->first;
    }
  }
  if (reader.problem()) return *reader.problem();
  return meaning;
}

std::optional<core::Problem> problem_of_missing(const AxisMeaning& meaning, const std::string& what,
                                                std::span<const double> stored, std::size_t first) {
  const ValueRule& valid = meaning.valid;
  if (valid.is_plain()) return std::nullopt;
  const auto stands_for_none = [&valid](double number) {
    const auto is_it = [number](double value) {
      return number == value || number == static_cast<double>(as_float(value));
    };
    return number < valid.least || number > valid.most || std::ranges::any_of(valid.missing, is_it);
  };
  const auto bad = std::ranges::find_if(stored, stands_for_none);
  if (bad == stored.end()) return std::nullopt;
  return file_problem({}, fmt::format("{} has a number that stands for none", what),
                      fmt::format("{:g} at position {}", *bad, first + static_cast<std::size_t>(bad - stored.begin())),
                      "valid numbers, by its _FillValue, missing_value and valid range",
                      "store all places, or correct the attribute");
}

}  // namespace sarsim::raster
