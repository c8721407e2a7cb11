#include "scene/schema/field_spec.hpp"

#include <algorithm>
#include <cctype>

namespace sarsim::scene {

int chosen(const FieldValue& value) {
  if (const auto* const number = std::get_if<double>(&value)) return static_cast<int>(*number);
  if (const auto* const yes = std::get_if<bool>(&value)) return *yes ? 1 : 0;
  return std::get<int>(value);
}

void choose(FieldValue& value, int alternative) {
  if (auto* const number = std::get_if<double>(&value))
    *number = alternative;
  else if (auto* const yes = std::get_if<bool>(&value))
    *yes = alternative != 0;
  else
    value = alternative;
}

bool is_among(const FieldValue& value, const std::vector<int>& among) {
  return std::ranges::find(among, chosen(value)) != among.end();
}

bool has_words(const FieldSpec& spec) {
  return std::ranges::any_of(spec.choices, [](const Choice& c) { return !c.word.empty() || !c.type.empty(); });
}

const Choice* chosen_word(const FieldSpec& spec, const FieldValue& value) {
  for (const Choice& choice : spec.choices)
    if (choice.value == chosen(value) && !choice.word.empty()) return &choice;
  return nullptr;
}

std::string type_word(const Choice& choice) {
  if (!choice.type.empty()) return std::string(choice.type);
  std::string word(choice.word.empty() ? choice.shown : choice.word);
  for (char& c : word) c = c == '_' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

const Choice* choice_of_type(const FieldSpec& spec, std::string_view word) {
  const std::string_view meant = spec.spelling == nullptr ? word : spec.spelling(word);
  const auto found =
      std::ranges::find_if(spec.choices, [&](const Choice& choice) { return type_word(choice) == meant; });
  return found == spec.choices.end() ? nullptr : &*found;
}

Range range_of_y(const FunctionBlock& block) { return block.x_ignored ? above_zero : any_value; }

Range likely_y(const FunctionBlock& block) { return {block.likely_low, block.likely_high}; }

Range likely_range(Quantity quantity) {
  switch (quantity) {
    case Quantity::length: return {-1e9, 1e9};
    case Quantity::time: return {-1e6, 1e6};
    case Quantity::frequency: return {-1e12, 1e12};
    case Quantity::angle: return {-360.0, 360.0};
    case Quantity::angle_rate: return {-1e6, 1e6};
    case Quantity::area: return {-1e9, 1e9};
    case Quantity::power: return {-1e10, 1e10};
    case Quantity::ratio_db: return {-300.0, 300.0};
    case Quantity::temperature: return {-1e6, 1e6};
    case Quantity::voltage: return {-1e6, 1e6};
    case Quantity::speed: return {-1e5, 1e5};
    case Quantity::acceleration: return {-1e5, 1e5};
    case Quantity::number:
    case Quantity::count: break;
  }
  return any_value;
}

Range both(const Range& a, const Range& b) {
  Range range{std::max(a.low, b.low), std::min(a.high, b.high)};
  range.low_excluded = (a.low_excluded && a.low == range.low) || (b.low_excluded && b.low == range.low);
  return range;
}

int script_shift(const FieldSpec& spec) {
  return spec.script_unit.empty() ? 0 : exponent_of(spec.script_unit, spec.quantity);
}

std::string_view script_unit(const FieldSpec& spec) {
  if (!spec.script_unit.empty()) return spec.script_unit;
  if (spec.quantity == Quantity::area) return "m^2";
  const auto units = units_of(spec.quantity);
  return units.empty() ? std::string_view{} : units.front();
}

}  // namespace sarsim::scene
