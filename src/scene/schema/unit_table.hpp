#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/quantity_kind.hpp"

/// The units of quantities and the words about them, stated once for all that reads values: forms, --set, tables and
/// expressions.
namespace sarsim::scene {

/// One unit of a quantity: value = number * 10^exponent, number * 10^exponent * factor/divisor,
/// 10^((number + factor)/10), or number + factor.
struct Unit {
  /// How a number with the unit becomes a value.
  enum class Law { decimal, factor, decibel, offset };

  std::string_view name;
  Law law = Law::decimal;
  int exponent = 0;
  double factor = 1.0;
  bool shown = true;      ///< May be chosen to show a value.
  bool prefixed = false;  ///< Its first letter is a prefix, whose case can change its meaning.
  double divisor = 1.0;
  bool yields = false;  ///< A name in [let] with the same letters takes precedence.
  bool told = true;     ///< Listed in messages.

  /// Whether it is a level (decibels, degC): zero is not zero in the base unit, negative numbers are usual, and
  /// multiples have no meaning.
  [[nodiscard]] constexpr bool is_level() const { return law == Law::decibel || law == Law::offset; }
};

/// The units of a quantity, the base unit first; empty for pure numbers.
[[nodiscard]] std::span<const Unit> unit_table(Quantity quantity);

/// "length", "rate of turn", "whole number".
[[nodiscard]] std::string_view noun_of(Quantity quantity);
/// "a length", "an angle".
[[nodiscard]] std::string with_article(std::string_view noun);
/// "m2, cm2 or dBsm"; empty for pure numbers.
[[nodiscard]] std::string units_listed(Quantity quantity);

/// A unit that was looked for, or why there is none, in words.
struct UnitSearch {
  const Unit* unit = nullptr;
  Quantity quantity = Quantity::number;
  std::string failure;  ///< "'mw' in '5 mw' is not clear; write mW or MW ..."
};

/// The unit of a quantity that is typed with these letters; capital and small ones are the same where one unit only can
/// be meant. `text` is quoted in the failure.
[[nodiscard]] UnitSearch find_unit(std::string_view typed, Quantity quantity, std::string_view text);
/// The same among the units of all quantities; neither a unit nor a failure where no unit has such letters.
[[nodiscard]] UnitSearch find_unit(std::string_view typed, std::string_view text);
/// The unit with exactly this name among those of all quantities; null where there is none.
[[nodiscard]] UnitSearch unit_called(std::string_view name);
/// The name of the unit for another common spelling, ignoring case: "kn" for "knots", "us" for "usec"; empty if there
/// is none.
[[nodiscard]] std::string_view unit_meant_by(std::string_view typed);

/// Length of the decimal number at the beginning of a text: sign, digits with a point, exponent; 0 where there is none.
[[nodiscard]] std::size_t number_length(std::string_view text);

/// A number (`number_length`) in a unit, in the base unit: correctly rounded once where the unit is a power of ten.
/// Nothing where it is too large.
[[nodiscard]] std::optional<double> in_base_unit(std::string_view number, const Unit& unit);

/// A text in the characters of which numbers and units are made: "3 \xC2\xB5s" gives "3 us".
[[nodiscard]] std::string plain_text(std::string_view text);
/// The same for expressions, in which a multiplication sign is "*" and a superscript two "^2".
/// @param origins  receives for each character of the result, and for its end, where it stands in `text`
[[nodiscard]] std::string plain_expression(std::string_view text, std::vector<std::size_t>& origins);

/// 'text' in quotes and without blanks at its ends, cut where it is long.
[[nodiscard]] std::string quoted(std::string_view text);

/// Whether a text begins with "1/s", which is how some write Hz.
[[nodiscard]] bool begins_with_per_second(std::string_view text);
/// Why what stands behind a number is no unit, where it looks like a part of the number; empty where it does not.
/// @param text   what is quoted
/// @param whole  begins with the number
/// @param rest   what follows it; not empty
[[nodiscard]] std::string broken_number(std::string_view text, std::string_view whole, std::string_view rest);
/// Says of a number with commas how to write it.
[[nodiscard]] std::string comma_failure(std::string_view text, std::string_view number);

}  // namespace sarsim::scene
