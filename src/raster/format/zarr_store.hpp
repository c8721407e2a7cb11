#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/text/json.hpp"
#include "raster/format/encoder.hpp"
#include "raster/table/row_places.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// What `.zarray` says of an array of Zarr version 2 that is not compressed, last index fastest, and that has no value
/// for numbers that are nowhere: xarray would take that value for "no number".
void write_zarr_array(core::JsonWriter& json, const std::string& type, std::span<const std::uint64_t> shape,
                      std::span<const std::uint64_t> chunks);

/// Rows of a chunk of an array of so many rows: chunks are alike and as few as those of at most 8 MiB, but have a row
/// at least.
[[nodiscard]] std::size_t zarr_chunk_rows(std::size_t rows, std::uint64_t row_bytes);

/// Where the rows of a product stand in its store: the array `samples` in chunks of whole rows.
[[nodiscard]] RowPlaces zarr_places(const Product& product, const Encoding& encoding);

/// Completes a store whose chunks hold all samples: the axes, what it says of itself and of each array and, last, all
/// of that together.
void complete_zarr(const std::filesystem::path& folder, const Product& product, const Encoding& encoding,
                   const RunReport& report);

/// Whether a folder is a store that this program wrote, and nothing else is in it: another one is never replaced.
[[nodiscard]] bool is_own_zarr_store(const std::filesystem::path& folder);

/// Whether the files of a folder make it a store, or an array, of Zarr of any version.
[[nodiscard]] bool looks_like_zarr(const std::filesystem::path& folder);

}  // namespace sarsim::raster
