#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace sarsim::core {

/// SHA-512 (FIPS 180-4) of bytes that come in pieces, to verify checksums written by other programs.
class Sha512 {
 public:
  /// Adds the next bytes.
  void add(std::span<const std::byte> bytes);
  /// The digest of all bytes that were added, 128 hexadecimal digits in lower case. No member may be called after it.
  [[nodiscard]] std::string digest();

 private:
  static constexpr std::size_t block_bytes = 128;

  void take_block(const std::byte* block);

  std::array<std::uint64_t, 8> state_{0x6a09e667f3bcc908U, 0xbb67ae8584caa73bU, 0x3c6ef372fe94f82bU,
                                      0xa54ff53a5f1d36f1U, 0x510e527fade682d1U, 0x9b05688c2b3e6c1fU,
                                      0x1f83d9abfb41bd6bU, 0x5be0cd19137e2179U};
  std::array<std::byte, block_bytes> rest_{};
  std::size_t rest_bytes_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace sarsim::core
