#pragma once

#include <cstdint>
#include <string_view>

namespace sarsim::core {

/// FNV-1a of no bytes, 64 bits: what the hash of a text begins with.
inline constexpr std::uint64_t fnv1a_of_nothing = 0xcbf29ce484222325U;

/// FNV-1a of the bytes, 64 bits, continued from `hash`, so that the hash of two texts in turn is that of both together.
/// For values that must never change: keys of random streams, names of files, what is stored. For anything else
/// `Checksum` is faster and better.
///
/// Source: G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake, "The FNV non-cryptographic hash algorithm".
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = fnv1a_of_nothing) {
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return hash;
}

}  // namespace sarsim::core
