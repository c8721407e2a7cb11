#pragma once

#include "core/os/input_file.hpp"
#include "raster/format/image_source.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

/// The openers behind `ImageSource::open`, one for each way of reading. Their files are not empty.

/// A file of numbers that lie as the layout says; problems where it says nothing sensible of this file.
[[nodiscard]] OpenedImage open_raw_image(core::InputFile file, const RawLayout& layout);
/// Needs the samples of a row and the bits.
[[nodiscard]] OpenedImage open_binary_image(core::InputFile file, const SampleFileHints& hints);
/// Arrays of one or two dimensions of numbers of any size and byte order, C or Fortran order; a last dimension of 2
/// makes pairs of I and Q, one of 3 bytes colours.
[[nodiscard]] OpenedImage open_npy_image(core::InputFile file, const SampleFileHints& hints);
[[nodiscard]] OpenedImage open_sun_image(core::InputFile file);
[[nodiscard]] OpenedImage open_text_image(core::InputFile file, TextStyle style, const SampleFileHints& hints);
/// Through SampleFile: HDF5.
[[nodiscard]] OpenedImage open_sample_image(const std::filesystem::path& path, const SampleFileHints& hints);

}  // namespace sarsim::raster
