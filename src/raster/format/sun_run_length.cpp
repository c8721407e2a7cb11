#include "raster/format/sun_run_length.hpp"

#include <algorithm>

namespace sarsim::raster {

namespace {

constexpr std::byte escape{0x80};
constexpr std::size_t buffer_bytes = std::size_t{1} << 16;

}  // namespace

bool SunRunDecoder::next_byte(std::byte& byte) {
  if (buffer_.empty() || state_.offset < buffer_offset_ || state_.offset >= buffer_offset_ + buffer_.size()) {
    buffer_.resize(buffer_bytes);
    buffer_offset_ = state_.offset;
    buffer_.resize(file_.read_at(buffer_offset_, buffer_));
    if (buffer_.empty()) return false;
  }
  byte = buffer_[static_cast<std::size_t>(state_.offset - buffer_offset_)];
  ++state_.offset;
  return true;
}

bool SunRunDecoder::next_run() {
  std::byte first{};
  std::byte count{};
  if (!next_byte(first)) return false;
  state_.value = first;
  state_.left = 1;
  if (first != escape) return true;
  state_.left = 0;
  if (!next_byte(count)) return false;
  if (count != std::byte{0} && !next_byte(state_.value)) return false;
  state_.left = std::to_integer<std::uint32_t>(count) + 1;
  return true;
}

std::size_t SunRunDecoder::take(std::span<std::byte> out) {
  std::size_t done = 0;
  while (done < out.size()) {
    if (state_.left == 0 && !next_run()) break;
    const std::size_t part = std::min<std::size_t>(state_.left, out.size() - done);
    std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(done), part, state_.value);
    state_.left -= static_cast<std::uint32_t>(part);
    done += part;
  }
  return done;
}

std::uint64_t SunRunDecoder::skip(std::uint64_t count) {
  std::uint64_t done = 0;
  while (done < count) {
    if (state_.left == 0 && !next_run()) break;
    const std::uint64_t part = std::min<std::uint64_t>(state_.left, count - done);
    state_.left -= static_cast<std::uint32_t>(part);
    done += part;
  }
  return done;
}

}  // namespace sarsim::raster
