#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "picture/colour/display_quantity.hpp"

namespace sarsim::picture {

/// The levels of a colour table for magnitudes in decibels, as colour_index(20 log10(magnitude/reference), ...) has
/// them but for roundings, without a logarithm for each.
class DecibelLevels {
 public:
  /// @param reference  magnitude of 0 dB, above 0; otherwise all levels are 0
  /// @param limits     in decibels, the lower one first
  /// @param levels     of the table, 1 to 65536
  DecibelLevels(float reference, const ColourLimits& limits, std::size_t levels);

  /// The level of a magnitude; 0 for NaN.
  [[nodiscard]] std::size_t operator()(float magnitude) const {
    if (!(magnitude > 0.0F)) return 0;
    std::size_t level = level_[std::bit_cast<std::uint32_t>(magnitude) >> dropped_bits];
    while (level + 1 < from_.size() && magnitude >= from_[level + 1]) ++level;
    return level;
  }

 private:
  // What is left of a positive number: its exponent and six bits after the point, a tenth of a decibel.
  static constexpr unsigned dropped_bits = 17;

  std::vector<float> from_;           // the lowest magnitude of each level
  std::vector<std::uint16_t> level_;  // of the lowest magnitude with these bits
};

}  // namespace sarsim::picture
