#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "raster/table/stored_array.hpp"

namespace sarsim::raster {

/// Where the samples and axes of an HDF5 file stand (docs/formats/samples.md), of our own layout of any version and of
/// that of 2015. A problem, without a place, where they do not stand in one piece.
/// @param file_bytes  size of a file that `open_hdf5` could open
/// @param dataset     path of the samples; empty: where the layouts have them
[[nodiscard]] StoredArrays hdf5_arrays(const std::filesystem::path& path, std::uint64_t file_bytes,
                                       const std::string& dataset);

}  // namespace sarsim::raster
