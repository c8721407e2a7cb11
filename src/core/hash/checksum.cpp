#include "core/hash/checksum.hpp"

#include <new>

#include <xxhash.h>

namespace sarsim::core {

Checksum::Checksum() : state_(XXH64_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH64_reset(state_.get(), 0);
}

Checksum::Checksum(const Checksum& other) : Checksum() { XXH64_copyState(state_.get(), other.state_.get()); }

Checksum& Checksum::operator=(Checksum other) noexcept {
  state_.swap(other.state_);
  return *this;
}

void Checksum::Free::operator()(XXH64_state_s* state) const noexcept { XXH64_freeState(state); }

void Checksum::add(std::span<const std::byte> bytes) {
  if (!bytes.empty()) XXH64_update(state_.get(), bytes.data(), bytes.size());
}

std::uint64_t Checksum::value() const { return XXH64_digest(state_.get()); }

std::uint64_t checksum_of(std::span<const std::byte> bytes) { return XXH64(bytes.data(), bytes.size(), 0); }

std::uint64_t checksum_of(std::string_view text) { return checksum_of(std::as_bytes(std::span(text))); }

}  // namespace sarsim::core
