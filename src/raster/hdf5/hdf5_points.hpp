#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/report/problem.hpp"
#include "raster/format/number_table.hpp"

namespace sarsim::raster {

/// Reads the dataset `/points` of an HDF5 file, two dimensions of numbers. A child process tries its beginning and its
/// end first, because a damaged file can crash the library.
/// @return what is wrong with the file, without a place; nothing where `taker` has had all rows
[[nodiscard]] std::optional<core::Problem> read_hdf5_points(const std::filesystem::path& path, std::uint64_t file_bytes,
                                                            const NumberTableTaker& taker);

}  // namespace sarsim::raster
