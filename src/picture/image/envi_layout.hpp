#pragma once

#include <filesystem>
#include <optional>

#include "raster/format/custom_raw.hpp"
#include "raster/format/envi.hpp"

namespace sarsim::picture {

/// The layout that an ENVI header gives: one band of float or complex float.
[[nodiscard]] raster::RawLayout layout_of(const raster::EnviHeader& header);

/// How a data file that has a sound ENVI header beside it is laid out; nothing for other files.
[[nodiscard]] std::optional<raster::RawLayout> envi_layout(const std::filesystem::path& data);

}  // namespace sarsim::picture
