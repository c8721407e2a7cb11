#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace sarsim::core {

/// Checksum of bytes that come piece by piece: XXH64 with seed 0, 64 bits, several GB/s.
///
/// Source: Y. Collet, "XXH64 algorithm description", xxHash specification 0.1.1. It finds accidents, not forgeries: a
/// changed block escapes with probability 2^-64.
class Checksum {
 public:
  /// Takes in bytes; the sum of parts added in turn is that of all of them together.
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text))); }
  /// Of everything added so far.
  [[nodiscard]] std::uint64_t value() const;

 private:
  static constexpr std::size_t stripe_bytes = 32;

  void take_stripe(const std::byte* stripe);

  std::array<std::uint64_t, 4> lanes_{0x60ea27eeadc0b5d6U, 0xc2b2ae3d27d4eb4fU, 0, 0x61c8864e7a143579U};
  std::array<std::byte, stripe_bytes> rest_{};
  std::size_t rest_size_ = 0;
  std::uint64_t size_ = 0;
};

/// Checksum of a text at once.
[[nodiscard]] std::uint64_t checksum_of(std::string_view text);

}  // namespace sarsim::core
