#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "core/os/input_file.hpp"
#include "raster/format/open_raster.hpp"
#include "raster/table/stored_grid.hpp"

namespace sarsim::raster {

/// As many rows as the file holds.
inline constexpr std::uint64_t any_rows = std::numeric_limits<std::int64_t>::max();

/// The decoder of colours of three bytes, which stand for their luminance.
[[nodiscard]] StoredGrid::Decoder rgb_decoder();

/// What is known of a file before anything of it is read.
[[nodiscard]] RasterInfo info_of(const core::InputFile& file, std::size_t columns, const RasterHints& hints);

/// Rows of samples of a fixed size, one after the other from some place of a file on. Colours have the `rgb_decoder`.
/// @param max_rows  rows that the file claims; more are never there
[[nodiscard]] std::shared_ptr<Raster> make_grid_raster(RasterInfo info, core::InputFile file, const StoredGrid& grid,
                                                       std::uint64_t max_rows);

/// The same where the columns follow one after the other: they are the rows of `grid`.
[[nodiscard]] std::shared_ptr<Raster> make_transposed_raster(RasterInfo info, core::InputFile file,
                                                             const StoredGrid& grid);

}  // namespace sarsim::raster
