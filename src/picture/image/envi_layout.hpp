#pragma once

#include <filesystem>
#include <optional>

#include "raster/format/custom_raw.hpp"
#include "raster/format/envi.hpp"

namespace sarsim {

/// The layout that an ENVI header gives: one band of float or complex float.
[[nodiscard]] RawLayout layout_of(const EnviHeader& header);

/// How a data file that has a sound ENVI header beside it is laid out; nothing for other files.
[[nodiscard]] std::optional<RawLayout> envi_layout(const std::filesystem::path& data);

}  // namespace sarsim
