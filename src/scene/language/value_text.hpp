#pragma once

#include <string>
#include <string_view>

#include "core/maths/vector.hpp"
#include "scene/schema/field_spec.hpp"

/// Single values as format 2 writes them; reading gives the same value, bit for bit.
namespace sarsim::scene::language {

/// A string of TOML; bytes that are not UTF-8 are taken for Latin-1, the coding of old scripts.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// A number in the base unit of its field, without the unit, as lists have them.
/// @param number  finite
[[nodiscard]] std::string number_text(double number);

/// Three of them: "[1, 2.5, 0]".
[[nodiscard]] std::string vector_text(const core::Vec3& vector);

/// A number with the unit that suits its size, in quotes; bare where the quantity has no unit.
[[nodiscard]] std::string quantity_value(double number, Quantity quantity);

/// The value of a field: "\"5 us\"", "[0, 0, 0]"; of a choice its word. Empty for functions.
[[nodiscard]] std::string value_text(const FieldSpec& spec, const FieldValue& value);

}  // namespace sarsim::scene::language
