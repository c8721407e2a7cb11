#pragma once

#include <cstddef>
#include <cstdint>

namespace sarsim::core {

/// Files are brought to the disk in blocks of so many bytes, and written in pieces no larger: in each call of the
/// system a stop may have to wait for one of them.
inline constexpr std::size_t write_behind_bytes = std::size_t{4} << 20U;

/// To be called after bytes were written at a place of a file: begins to bring to the disk the blocks that they
/// complete, and waits for one some way before them. Then little of a file that is written in order is left for
/// `fsync`, which nothing can interrupt.
/// @return 0, or the error of the disk, which `fsync` will not tell again
[[nodiscard]] int write_behind(int descriptor, std::uint64_t offset, std::size_t bytes) noexcept;

}  // namespace sarsim::core
