#pragma once

namespace sarsim::scene {

/// No number of a scene may be larger than this (SI units, degrees): far beyond anything physical, and small enough
/// that squares and products of several such numbers stay finite.
inline constexpr double largest_value = 1e18;

/// The largest gain of a transmitter or receiver. Losses may be of any size: they only make an echo vanish.
inline constexpr double largest_gain_db = 300.0;

/// The largest surface, which is filled with a point per square metre, one thinner than a metre with a point per metre
/// of its length: as many points, half a gigabyte of them.
inline constexpr double largest_surface_m2 = 2e7;

/// The most samples of a row, and of a pulse that is kept as samples: a row is made in memory, by every thread.
inline constexpr double longest_row = 1e7;

/// Whether echoes can be computed with a number; false for NaN.
[[nodiscard]] constexpr bool computable(double value) { return value >= -largest_value && value <= largest_value; }

}  // namespace sarsim::scene
