#pragma once

#include <optional>

#include "raster/format/envi.hpp"
#include "raster/table/raster.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::workflow {

/// The fields of a focused image's header, but for those of its map, as attributes of an HDF5 file: blanks in names
/// become underscores, and "script", which is the text of one there, "script_file".
[[nodiscard]] raster::Facts facts_of_header(const raster::EnviHeader& header);

/// The header that the attributes of a file make up; nothing where they are not those of a focused image.
[[nodiscard]] std::optional<raster::EnviHeader> header_of_facts(const raster::Raster& file);

}  // namespace sarsim::workflow
