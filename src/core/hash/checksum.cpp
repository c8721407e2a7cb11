#include "core/hash/checksum.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace sarsim::core {

namespace {

static_assert(std::endian::native == std::endian::little, "XXH64 reads little-endian words");

constexpr std::uint64_t prime1 = 0x9e3779b185ebca87U;
constexpr std::uint64_t prime2 = 0xc2b2ae3d27d4eb4fU;
constexpr std::uint64_t prime3 = 0x165667b19e3779f9U;
constexpr std::uint64_t prime4 = 0x85ebca77c2b2ae63U;
constexpr std::uint64_t prime5 = 0x27d4eb2f165667c5U;

std::uint64_t word64(const std::byte* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

std::uint64_t word32(const std::byte* bytes) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

std::uint64_t round(std::uint64_t lane, std::uint64_t input) { return std::rotl(lane + input * prime2, 31) * prime1; }

// The last bytes, fewer than a stripe.
std::uint64_t with_rest(std::uint64_t sum, std::span<const std::byte> rest) {
  for (; rest.size() >= 8; rest = rest.subspan(8))
    sum = std::rotl(sum ^ round(0, word64(rest.data())), 27) * prime1 + prime4;
  if (rest.size() >= 4) {
    sum = std::rotl(sum ^ word32(rest.data()) * prime1, 23) * prime2 + prime3;
    rest = rest.subspan(4);
  }
  for (const std::byte byte : rest) sum = std::rotl(sum ^ std::to_integer<std::uint64_t>(byte) * prime5, 11) * prime1;
  return sum;
}

}  // namespace

void Checksum::take_stripe(const std::byte* stripe) {
  for (std::size_t i = 0; i < lanes_.size(); ++i) lanes_[i] = round(lanes_[i], word64(stripe + 8 * i));
}

void Checksum::add(std::span<const std::byte> bytes) {
  size_ += bytes.size();
  if (rest_size_ > 0) {
    const std::size_t taken = std::min(bytes.size(), stripe_bytes - rest_size_);
    std::copy_n(bytes.begin(), taken, rest_.begin() + static_cast<std::ptrdiff_t>(rest_size_));
    rest_size_ += taken;
    bytes = bytes.subspan(taken);
    if (rest_size_ < stripe_bytes) return;
    take_stripe(rest_.data());
    rest_size_ = 0;
  }
  for (; bytes.size() >= stripe_bytes; bytes = bytes.subspan(stripe_bytes)) take_stripe(bytes.data());
  std::ranges::copy(bytes, rest_.begin());
  rest_size_ = bytes.size();
}

std::uint64_t Checksum::value() const {
  std::uint64_t sum = prime5;
  if (size_ >= stripe_bytes) {
    sum = std::rotl(lanes_[0], 1) + std::rotl(lanes_[1], 7) + std::rotl(lanes_[2], 12) + std::rotl(lanes_[3], 18);
    for (const std::uint64_t lane : lanes_) sum = (sum ^ round(0, lane)) * prime1 + prime4;
  }
  sum = with_rest(sum + size_, std::span(rest_).first(rest_size_));
  sum = (sum ^ (sum >> 33U)) * prime2;
  sum = (sum ^ (sum >> 29U)) * prime3;
  return sum ^ (sum >> 32U);
}

std::uint64_t checksum_of(std::string_view text) {
  Checksum sum;
  sum.add(text);
  return sum.value();
}

}  // namespace sarsim::core
