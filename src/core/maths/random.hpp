#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace sarsim::core {

/// What a random number is for. Part of the key, so that no two uses ever share a stream.
enum class RandomKind : std::uint32_t {
  receiver_noise = 1,
  platform_position = 2,
  platform_rotation = 3,
  position_envelope = 4,
  rotation_envelope = 5,
  target_position = 6,
  target_rcs = 7,
  target_pointing = 8,
  sweep_value = 9,
  wave = 10,
};

/// A stream of random numbers without state: each number is a function of the stream's key and of
/// two counters, so that neither the order of evaluation nor the number of threads can change it.
///
/// Philox4x32-10 (Salmon, Moraes, Dror, Shaw: "Parallel random numbers: as easy as 1, 2, 3", SC 2011).
class RandomStream {
 public:
  /// @param seed    the user's seed
  /// @param kind    what the numbers are for
  /// @param object  the object's ordinal, or `name_key` of its name
  RandomStream(std::uint64_t seed, RandomKind kind, std::uint64_t object);

  /// Two independent normal variates, mean 0 and variance 1, for the counters (major, minor).
  /// Box-Muller on two 64-bit uniform numbers; never infinite (the largest magnitude is 9.4).
  [[nodiscard]] std::array<double, 2> normals(std::int64_t major, std::int64_t minor) const;

  /// Two independent numbers, uniform between 0 and 1 and never these, for the counters: those of `normals`.
  [[nodiscard]] std::array<double, 2> uniforms(std::int64_t major, std::int64_t minor) const;

  /// Philox's key, low word first. What `normals` makes of it, for kernels that draw many streams at once: the counter
  /// words are minor low, minor high, major low, major high; output words 0 and 1, the high and the low one, give the
  /// uniform number (n + 1/2)/2^53, n their upper 53 bits, of the radius, and words 2 and 3 that of the angle in turns.
  [[nodiscard]] std::uint64_t key() const { return std::uint64_t{key_high_} << 32 | key_low_; }

 private:
  std::uint32_t key_low_;
  std::uint32_t key_high_;
};

/// A key for an object that is known by name (FNV-1a over lower-case ASCII).
[[nodiscard]] std::uint64_t name_key(std::string_view name);

}  // namespace sarsim::core
