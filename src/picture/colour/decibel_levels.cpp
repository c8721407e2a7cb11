#include "picture/colour/decibel_levels.hpp"

#include <cmath>
#include <stdexcept>

namespace sarsim::picture {

DecibelLevels::DecibelLevels(float reference, const ColourLimits& limits, std::size_t levels)
    : level_((std::size_t{1} << 31U) >> dropped_bits) {
  if (levels == 0 || levels > 65536) throw std::invalid_argument("a colour table has 1 to 65536 levels");
  if (!(reference > 0.0F)) levels = 1;
  const double step_db = (limits.high - limits.low) / static_cast<double>(levels);
  for (std::size_t i = 0; i < levels; ++i) {
    const double db = limits.low + static_cast<double>(i) * step_db;
    from_.push_back(static_cast<float>(static_cast<double>(reference) * std::pow(10.0, db / 20.0)));
  }
  std::size_t level = 0;
  for (std::size_t bits = 0; bits < level_.size(); ++bits) {
    const auto lowest = std::bit_cast<float>(static_cast<std::uint32_t>(bits << dropped_bits));
    while (level + 1 < levels && lowest >= from_[level + 1]) ++level;
    level_[bits] = static_cast<std::uint16_t>(level);
  }
}

}  // namespace sarsim::picture
