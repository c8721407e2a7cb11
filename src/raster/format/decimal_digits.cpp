#include "raster/format/decimal_digits.hpp"

#include <algorithm>

namespace sarsim::raster {

DecimalDigits::DecimalDigits() : groups_{}, padded_{} {
  for (std::uint32_t value = 0; value < 10'000; ++value) {
    auto& padded = padded_[value];
    std::uint32_t rest = value;
    for (std::size_t i = 4; i-- > 0; rest /= 10) padded[i] = static_cast<char>('0' + rest % 10);
    Group& group = groups_[value];
    group.length = value >= 1000 ? 4 : value >= 100 ? 3 : value >= 10 ? 2 : 1;
    std::copy(padded.end() - group.length, padded.end(), group.text.begin());
  }
}

const DecimalDigits& decimal_digits() {
  static const DecimalDigits digits;
  return digits;
}

}  // namespace sarsim::raster
