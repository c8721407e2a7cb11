#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace sarsim::raster {

/// Writes a number with its most significant byte first.
template <class Number>
void put_big_endian(Number value, std::byte* to) {
  auto bytes = std::bit_cast<std::array<std::byte, sizeof(Number)>>(value);
  if constexpr (std::endian::native == std::endian::little) std::ranges::reverse(bytes);
  std::memcpy(to, bytes.data(), bytes.size());
}

/// Reads such a number.
template <class Number>
[[nodiscard]] Number get_big_endian(const std::byte* from) {
  std::array<std::byte, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), from, bytes.size());
  if constexpr (std::endian::native == std::endian::little) std::ranges::reverse(bytes);
  return std::bit_cast<Number>(bytes);
}

}  // namespace sarsim::raster
