#pragma once

#include <string_view>

namespace sarsim {

/// No number of a scene may be larger than this (SI units, degrees): far beyond anything physical, and small enough
/// that squares and products of several such numbers stay finite.
inline constexpr double largest_value = 1e18;

/// The same for decibels, which are exponents. Losses may be of any size: they only make an echo vanish.
inline constexpr double largest_gain_db = 300.0;

/// Whether echoes can be computed with a number of this unit ("m", "dB"; SI otherwise); false for NaN.
[[nodiscard]] constexpr bool computable(double value, std::string_view unit) {
  return value >= -largest_value && value <= (unit == "dB" ? largest_gain_db : largest_value);
}

}  // namespace sarsim
