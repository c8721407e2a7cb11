#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace sarsim::raster {

/// Where the rows of a recording stand in its file, where that is known beforehand. Of a folder they stand in files of
/// equal sizes, its pieces: places are those that they would have if the pieces stood one after the other.
struct RowPlaces {
  std::uint64_t first_byte = 0;  ///< Of row 0.
  std::uint64_t row_bytes = 0;
  std::uint64_t piece_bytes = 0;  ///< Of a piece, whole rows; 0 where all rows stand in one file.
  std::string piece_begin = {};   ///< Name of a piece in the folder, before its number from 0: "samples/".
  std::string piece_end = {};     ///< The same behind its number: ".0".

  [[nodiscard]] std::uint64_t of(std::size_t row) const { return first_byte + row * row_bytes; }
  /// Rows of a piece; 1 where there are none.
  [[nodiscard]] std::size_t piece_rows() const {
    return piece_bytes == 0 ? 1 : static_cast<std::size_t>(piece_bytes / row_bytes);
  }
  /// The file of a piece, or the one file.
  [[nodiscard]] std::filesystem::path file_of(const std::filesystem::path& path, std::uint64_t piece) const {
    return piece_bytes == 0 ? path : path / (piece_begin + std::to_string(piece) + piece_end);
  }
};

}  // namespace sarsim::raster
