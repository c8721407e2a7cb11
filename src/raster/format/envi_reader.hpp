#pragma once

#include <filesystem>

#include "raster/format/sample_reader.hpp"

namespace sarsim::raster {

/// Opens an image with its ENVI header beside it (docs/formats/focused-images.md) as samples in volts, lines for rows;
/// real pixels have no imaginary part. Its fields become attributes; that of the script is named "script file", as
/// "script" is the text of one. Throws std::system_error where the disk fails.
[[nodiscard]] OpenedReader open_envi(const std::filesystem::path& data);

}  // namespace sarsim::raster
