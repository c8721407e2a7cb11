#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "scene/model/scene.hpp"

namespace sarsim::raster {

/// The usual extension of a format, with its point: ".asc", ".bin", ".brk", ".h5", ".csv", ".npy".
[[nodiscard]] std::string_view extension_of(scene::FileFormat format);

/// The keyword of a format in scripts: "ASCII", "BINARY", "BRACKET", "HDF5", "CSV", "NPY".
[[nodiscard]] std::string_view name_of(scene::FileFormat format);

/// The format that a keyword means, ignoring case; nothing for another word.
[[nodiscard]] std::optional<scene::FileFormat> format_from_name(std::string_view name);

/// The format that the extension of a path means, ignoring case (the usual ones, and .txt, .hdf5, .hdf, .he5); nothing
/// for another one.
[[nodiscard]] std::optional<scene::FileFormat> format_from_path(const std::filesystem::path& path);

/// Whether a file of that format holds counts of the converter: HDF5 and NPY hold volts unless counts are asked for.
[[nodiscard]] constexpr bool holds_counts(scene::FileFormat format, bool counts_asked = false) {
  return counts_asked || (format != scene::FileFormat::hdf5 && format != scene::FileFormat::npy);
}

}  // namespace sarsim::raster
