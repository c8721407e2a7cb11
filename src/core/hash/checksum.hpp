#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

struct XXH64_state_s;  // of <xxhash.h>, which who includes this need not have

namespace sarsim::core {

/// Checksum of bytes that come piece by piece: XXH64 with seed 0, 64 bits, several GB/s.
///
/// Source: libxxhash (Y. Collet). It finds accidents, not forgeries: a changed block escapes with probability 2^-64.
/// Moved-from ones may only be assigned to or destroyed.
class Checksum {
 public:
  /// Of nothing so far.
  /// @throws std::bad_alloc
  Checksum();
  Checksum(const Checksum& other);
  Checksum(Checksum&& other) noexcept = default;
  Checksum& operator=(Checksum other) noexcept;
  ~Checksum() = default;

  /// Takes in bytes; the sum of parts added in turn is that of all of them together.
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text))); }
  /// Of everything added so far.
  [[nodiscard]] std::uint64_t value() const;

 private:
  struct Free {
    void operator()(XXH64_state_s* state) const noexcept;
  };

  std::unique_ptr<XXH64_state_s, Free> state_;
};

/// Checksum of bytes at once.
[[nodiscard]] std::uint64_t checksum_of(std::span<const std::byte> bytes);
[[nodiscard]] std::uint64_t checksum_of(std::string_view text);

}  // namespace sarsim::core
