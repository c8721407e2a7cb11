#include "core/maths/random.hpp"

#include <cmath>

#include <Random123/philox.h>

#include "core/hash/fnv1a.hpp"
#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"

namespace sarsim::core {

namespace {

// SplitMix64 finaliser (Steele, Lea, Flood 2014): a bijection that spreads every input bit.
std::uint64_t spread(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

std::uint32_t low_word(std::uint64_t x) { return static_cast<std::uint32_t>(x & 0xffffffffU); }
std::uint32_t high_word(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

// Uniform in (0, 1): the middle of one of 2^53 equal cells.
double unit_interval(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = (static_cast<std::uint64_t>(high) << 32 | low) >> 11;
  return (static_cast<double>(bits) + 0.5) * 0x1p-53;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, RandomKind kind, std::uint64_t object) {
  const std::uint64_t key = spread(spread(spread(seed) ^ static_cast<std::uint64_t>(kind)) ^ object);
  key_low_ = low_word(key);
  key_high_ = high_word(key);
}

std::array<double, 2> RandomStream::uniforms(std::int64_t major, std::int64_t minor) const {
  const auto a = static_cast<std::uint64_t>(major);
  const auto b = static_cast<std::uint64_t>(minor);
  const r123::Philox4x32::ctr_type counter = {{low_word(b), high_word(b), low_word(a), high_word(a)}};
  const r123::Philox4x32::key_type key = {{key_low_, key_high_}};
  const auto bits = r123::Philox4x32()(counter, key);
  return {unit_interval(bits[0], bits[1]), unit_interval(bits[2], bits[3])};
}

std::array<double, 2> RandomStream::normals(std::int64_t major, std::int64_t minor) const {
  const auto [first, second] = uniforms(major, minor);
  const double radius = std::sqrt(-2.0 * std::log(first));
  const double angle = 2.0 * pi * second;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::uint64_t name_key(std::string_view name) { return fnv1a(lower_case(name)); }

}  // namespace sarsim::core
