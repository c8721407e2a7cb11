#pragma once

#include <filesystem>

#include "raster/format/open_raster.hpp"

namespace sarsim::raster {

/// Opens an HDF5 file of samples: the layout of docs/formats/samples.md, or that of the program of 2015 (dataset
/// `/Data/PulseNo_x_SampleNo_I&Q` of interleaved counts, parameters as attributes below `/Details`).
///
/// Every size is held against the file's before anything is read; datasets in other files, over soft or external
/// links, of other types or with unknown filters are problems. Throws Interrupted where a stop is requested meanwhile.
[[nodiscard]] OpenedRaster open_hdf5(const std::filesystem::path& path, std::uint64_t file_bytes,
                                     const RasterHints& hints, const core::StopFlag* stop);

}  // namespace sarsim::raster
