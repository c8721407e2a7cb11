#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/task/stop.hpp"
#include "signal/sar/focusing.hpp"
#include "workflow/image/image_fields.hpp"
#include "workflow/image/in_memory_image.hpp"

namespace sarsim::workflow {

/// Whether a path names an ENVI image: every extension that names no other format does. New images have `.img` or none.
[[nodiscard]] bool is_envi(const std::filesystem::path& path);

/// Refuses the name of a picture (.png, .tif ...): an image is samples, and `sarsim plot` makes a picture of it. The
/// message begins with `option`.
void expect_no_picture(const std::filesystem::path& path, std::string_view option);

/// Refuses the name of a new image whose ending is that of a picture (`expect_no_picture`) or of no image: the format
/// is what the ending says, and a name without one is ENVI. The message begins with `option`.
void expect_image_ending(const std::filesystem::path& path, std::string_view option);

/// Whether a path names a SICD file: .nitf, .ntf or .sicd.
[[nodiscard]] bool is_sicd(const std::filesystem::path& path);

/// Refuses the name of a SICD file for what is no image of `focus`. The message begins with `option`.
void expect_no_sicd(const std::filesystem::path& path, std::string_view option);

/// The image of magnitudes that goes with a complex one: "name-magnitude.img" for "name.img".
[[nodiscard]] std::filesystem::path magnitude_path(const std::filesystem::path& path);

/// Files that an image of that name becomes: data, and the header of ENVI and NPY.
[[nodiscard]] std::vector<std::filesystem::path> files_of_image(const std::filesystem::path& path);

/// What an image is, as it stays in memory; its rows are those of `image`.
[[nodiscard]] InMemoryImage in_memory_image(const signal::FocusedRows& image, const ImageOrigin& origin);

/// Writes an image in the format that the path's extension says (docs/formats/focused-images.md): ENVI or NPY with a
/// header, HDF5 as complex samples, SICD where the origin has a collection, the others as counts of 16 bits whose
/// largest is the largest magnitude. Throws Interrupted, and like the sinks and SicdWriter.
/// @param magnitude  ENVI: magnitudes instead of complex numbers
void write_image(const signal::FocusedRows& image, const ImageOrigin& origin, const std::filesystem::path& path,
                 bool replace, bool magnitude, const core::StopFlag* stop);

}  // namespace sarsim::workflow
