#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/os/input_file.hpp"

namespace sarsim::raster {

/// Decodes the bytes of a run-length encoded Sun raster from any remembered place on.
///
/// 80 00 stands for the byte 80, 80 n v for n + 1 times the byte v, everything else for itself; runs may go on from one
/// row to the next (SunOS, rasterfile(5)).
class SunRunDecoder {
 public:
  /// Where decoding stands: a place in the file and what is left of a run.
  struct State {
    std::uint64_t offset = 0;
    std::uint32_t left = 0;
    std::byte value{};
  };

  SunRunDecoder(const core::InputFile& file, State state) : file_(file), state_(state) {}

  /// Decodes bytes and returns how many there were; fewer than asked for only at the end of the file.
  std::size_t take(std::span<std::byte> out);
  /// The same without keeping them.
  std::uint64_t skip(std::uint64_t count);
  [[nodiscard]] const State& state() const { return state_; }

 private:
  bool next_run();
  bool next_byte(std::byte& byte);

  const core::InputFile& file_;
  State state_;
  std::vector<std::byte> buffer_;
  std::uint64_t buffer_offset_ = 0;
};

}  // namespace sarsim::raster
