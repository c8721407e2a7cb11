#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace sarsim::raster {

/// The counts that an A/D converter of 1 to 64 bits gives (docs/formats/samples.md): -C to C + 1 with
/// C = max(1, 2^(bits-1) - 1); for 64 bits the upper end is the largest 64-bit integer.
struct CountRange {
  int bits = 8;

  /// C, which is also what formats without a sign add to a count.
  [[nodiscard]] constexpr std::uint64_t offset() const {
    return bits <= 2 ? 1U : (std::uint64_t{1} << (bits - 1)) - 1U;
  }
  [[nodiscard]] constexpr std::int64_t lowest() const { return -static_cast<std::int64_t>(offset()); }
  [[nodiscard]] constexpr std::int64_t highest() const {
    return bits >= 64 ? std::numeric_limits<std::int64_t>::max() : static_cast<std::int64_t>(offset() + 1U);
  }
  /// Bytes of a component in BINARY: ceil(bits / 8).
  [[nodiscard]] constexpr std::size_t component_bytes() const { return (static_cast<std::size_t>(bits) + 7U) / 8U; }
  /// The largest number that is stored with the offset: 2C + 1.
  [[nodiscard]] constexpr std::uint64_t highest_stored() const { return 2 * offset() + 1; }
  /// The count plus C, in arithmetic modulo 2^64: at most 2C + 1 exactly for the counts of the range.
  [[nodiscard]] constexpr std::uint64_t with_offset(std::int64_t count) const {
    return static_cast<std::uint64_t>(count) + offset();
  }
  [[nodiscard]] constexpr bool contains(std::int64_t count) const { return count >= lowest() && count <= highest(); }
  /// The count that was stored with the offset; the inverse of `with_offset`.
  [[nodiscard]] constexpr std::int64_t without_offset(std::uint64_t stored) const {
    return std::bit_cast<std::int64_t>(stored - offset());
  }
};

}  // namespace sarsim::raster
