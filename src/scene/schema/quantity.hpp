#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/quantity_kind.hpp"

namespace sarsim::scene {

/// A value read from what was typed, in the unit in which the quantity is held, or why it could not be read, in words.
struct QuantityReading {
  std::optional<double> value;
  std::string failure;  ///< "'5 kg' is not a valid length; try m, km or mm"
};

/// Reads "50 MHz", "3us", "10 km", "1e3", "1,5" is refused with a hint at the point. Case matters only where it must
/// (mW and MW); "µ" counts as "u". A number without a unit is in `bare_unit`, one of the quantity's units; empty: the
/// base unit. Values outside double's range and NaN are failures.
[[nodiscard]] QuantityReading read_quantity(std::string_view text, Quantity quantity, std::string_view bare_unit = "");

/// The value with the unit that suits its size: 5e7, frequency: "50 MHz". Reading it back gives exactly `value`.
[[nodiscard]] std::string quantity_text(double value, Quantity quantity);
/// Same with a given unit of the quantity; a unit that is not a power of ten of the base unit (ft, rad, dBm) gives the
/// nearest number, which need not read back exactly. std::invalid_argument for a unit that is none of the quantity's.
[[nodiscard]] std::string quantity_text(double value, Quantity quantity, std::string_view unit);

/// The units listed in messages, the base unit first; a few more may be typed (`unit_table`).
[[nodiscard]] std::vector<std::string_view> units_of(Quantity quantity);

/// Decimal exponent of a unit to the base unit: 9 for "GHz". std::invalid_argument for a unit that is none of the
/// quantity's or no power of ten of its base unit.
[[nodiscard]] int exponent_of(std::string_view unit, Quantity quantity);

}  // namespace sarsim::scene
