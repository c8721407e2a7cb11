#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>

#include "core/os/raw_file.hpp"
#include "raster/table/row_places.hpp"

namespace sarsim::raster {

/// Rows that are written and read by their places: in one file, or in the pieces of a folder, of which one is open at a
/// time. Several processes may write different rows at once, of the same piece too. Fails like core::RawFile.
class PlacedRows {
 public:
  PlacedRows() = default;
  /// Opens the file, or the folder with the pieces of `places`; for writing both are made where they are missing.
  PlacedRows(std::filesystem::path path, const RowPlaces& places, core::RawFile::Mode mode);

  /// Writes at a place; a new piece has its full size at once, with zeros.
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Reads what stands at a place; false where the file or a piece ends before, or a piece is missing.
  [[nodiscard]] bool read_at(std::uint64_t offset, std::span<std::byte> bytes) const;
  /// Returns when everything written is on the disk.
  void sync();
  /// Whether the path still leads to what was opened.
  [[nodiscard]] bool still_there() const;
  /// The one file, where there are no pieces.
  [[nodiscard]] core::RawFile& file() { return file_; }

 private:
  [[nodiscard]] core::RawFile& piece(std::uint64_t number) const;

  std::filesystem::path path_;
  RowPlaces places_;
  core::RawFile::Mode mode_ = core::RawFile::Mode::read;
  std::uint64_t folder_ = 0;  // What tells the folder from another one of its name.
  mutable core::RawFile file_;
  mutable std::uint64_t open_ = UINT64_MAX;  // Number of the piece that is open.
  std::set<std::uint64_t> unsafe_;           // Pieces that may not be on the disk yet.
};

}  // namespace sarsim::raster
