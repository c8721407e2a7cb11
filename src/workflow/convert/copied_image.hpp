#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "raster/format/envi.hpp"
#include "raster/table/raster.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::workflow {

/// The ENVI header that describes a file of samples as it was opened; nothing where none does, as for recordings.
/// Throws core::InvalidRequest and std::system_error like EnviImage.
[[nodiscard]] std::optional<raster::EnviHeader> header_beside(const std::filesystem::path& path,
                                                              const raster::Raster& file);

/// The file that the header of a copy becomes: "copy.hdr" for "copy.npy", or "copy.npy.hdr" where the former is the
/// header of the image that is copied.
[[nodiscard]] std::filesystem::path header_file_of_copy(const std::filesystem::path& image,
                                                        const std::filesystem::path& copy);

/// The header of a copy: the image's, with its source and script as they are seen from the copy's folder
/// (docs/formats/focused-images.md).
/// @param array  the copy is a NumPy array of complex numbers; otherwise the pixels are the image's, from byte 0
[[nodiscard]] raster::EnviHeader header_of_copy(raster::EnviHeader header, const std::filesystem::path& image,
                                                const std::filesystem::path& copy, bool array);

/// Whether NumPy's complex numbers would make another image of one: magnitudes of a focused image have no phases.
[[nodiscard]] bool is_of_magnitudes(const raster::EnviHeader& header);

/// The pixels of an ENVI image without its header; rows are given in volts. Throws like OutputFile.
[[nodiscard]] std::unique_ptr<raster::Sink> make_pixel_sink(const std::filesystem::path& path,
                                                            const raster::EnviHeader& header, bool replace);

}  // namespace sarsim::workflow
