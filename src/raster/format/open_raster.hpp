#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/task/stop.hpp"
#include "raster/format/custom_raw.hpp"
#include "raster/table/raster.hpp"
#include "scene/model/recording.hpp"

namespace sarsim::raster {

/// How much of a file has to be there.
enum class Integrity {
  whole,    ///< To work with: all of the file, and sound, or it is refused.
  partial,  ///< To look at: what is there of a file that may be cut off or still growing; pictures and any numbers,
            ///< too.
};

/// What the caller knows of a file that does not describe itself. Zero and empty: not known.
struct RasterHints {
  std::optional<scene::FileFormat> format =
      std::nullopt;         ///< Otherwise found from the content, then from the extension.
  std::size_t columns = 0;  ///< Samples of a row: needed for BINARY; for ASCII and BRACKET it replaces row ends.
  std::size_t rows = 0;     ///< Checked against the file where given.
  int bits = 0;             ///< Of the A/D converter: needed for BINARY, and for CSV with an offset.
  double lsb_v = 0.0;
  std::string dataset = {};                     ///< Of HDF5: path of the samples; empty: the usual one.
  std::optional<RawLayout> raw = std::nullopt;  ///< Given, the file is read so, whatever it holds.
};

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
