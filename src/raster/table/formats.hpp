#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "scene/model/scene.hpp"

namespace sarsim {

/// The usual extension of a format, with its point: ".asc", ".bin", ".brk", ".h5", ".csv", ".npy".
[[nodiscard]] std::string_view extension_of(FileFormat format);

/// The keyword of a format in scripts: "ASCII", "BINARY", "BRACKET", "HDF5", "CSV", "NPY".
[[nodiscard]] std::string_view name_of(FileFormat format);

/// The format that a keyword means, ignoring case; nothing for another word.
[[nodiscard]] std::optional<FileFormat> format_from_name(std::string_view name);

/// The format that the extension of a path means, ignoring case (the usual ones, and .txt, .hdf5, .hdf, .he5); nothing
/// for another one.
[[nodiscard]] std::optional<FileFormat> format_from_path(const std::filesystem::path& path);

/// Whether a file of that format holds counts of the converter: HDF5 and NPY hold volts unless counts are asked for.
[[nodiscard]] constexpr bool holds_counts(FileFormat format, bool counts_asked = false) {
  return counts_asked || (format != FileFormat::hdf5 && format != FileFormat::npy);
}

}  // namespace sarsim
