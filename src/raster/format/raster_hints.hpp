#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "raster/format/custom_raw.hpp"
#include "scene/model/scene.hpp"

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

}  // namespace sarsim::raster
