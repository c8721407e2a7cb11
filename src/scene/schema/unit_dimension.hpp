#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "scene/schema/quantity.hpp"

namespace sarsim::scene {

/// What a value of an expression measures: whole powers of the units in which values are held. All zero: a pure number.
/// An angle is a dimension of its own, and so are decibels.
struct Dimension {
  /// The units, by their place in `powers`.
  enum Base : std::size_t { metre, second, degree, kelvin, watt, volt, decibel };

  std::array<int, 7> powers{};

  [[nodiscard]] bool pure() const { return *this == Dimension{}; }
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// That of a quantity; frequency is 1/s, `number` and `count` are pure numbers.
[[nodiscard]] Dimension dimension_of(Quantity quantity);

/// a b^power; nothing where a unit would have a power beyond -99 to 99, or decibels one that is neither 0 nor 1,
/// because decibels are added and never multiplied by each other.
[[nodiscard]] std::optional<Dimension> product(const Dimension& a, const Dimension& b, int power);

/// a^power for a whole power, or for 0.5 where every unit has an even one; nothing for others and as `product`.
[[nodiscard]] std::optional<Dimension> raised(const Dimension& a, double power);

/// In words: "a length", "a pure number", "a quantity in m/s^2".
[[nodiscard]] std::string dimension_text(const Dimension& dimension);

}  // namespace sarsim::scene
