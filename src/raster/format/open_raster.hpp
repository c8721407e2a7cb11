#pragma once

#include <filesystem>

#include "core/task/stop.hpp"
#include "raster/format/raster_hints.hpp"
#include "raster/table/raster.hpp"
#include "scene/model/recording.hpp"

namespace sarsim::raster {

/// Opens a file in any of the formats of the table (`formats`). The format is that of the hints, otherwise the
/// content's, otherwise the extension's; of whole files, an ENVI header beside a file of another extension than the
/// formats' counts before the content. No raster and at least one error where the file cannot be read; warnings and
/// notes may come with either. Throws std::system_error where the disk fails, and Interrupted where a stop is requested
/// while a file is read through.
///
/// A text that has to be whole is read through at once. Otherwise this takes milliseconds for files of any size, except
/// HDF5, which is tried in a child process first: texts and run-length encoded pictures are looked through on a thread
/// of their own, so that their rows come to be known little by little (`Raster::rows`, `Raster::indexed`).
[[nodiscard]] OpenedRaster open_raster(Integrity integrity, const std::filesystem::path& path,
                                       const RasterHints& hints = {}, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::raster
