#pragma once

#include <cstddef>
#include <cstdint>

namespace sarsim::raster {

/// Where the rows of a recording stand in its file, where that is known beforehand.
struct RowPlaces {
  std::uint64_t first_byte = 0;  ///< Of row 0.
  std::uint64_t row_bytes = 0;

  [[nodiscard]] std::uint64_t of(std::size_t row) const { return first_byte + row * row_bytes; }
};

}  // namespace sarsim::raster
