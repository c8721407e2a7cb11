#pragma once

#include "core/os/input_file.hpp"
#include "raster/format/image_source.hpp"
#include "raster/format/sample_reader.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

/// How files of a format are opened. Their files are not empty.
struct FormatReader {
  /// As samples, whole and sound or not at all; null for what is no file of samples.
  OpenedReader (*samples)(core::InputFile file, const Format& format, const SampleFileHints& hints) = nullptr;
  /// To be looked at: what is there of a file that may be cut off or still growing.
  OpenedImage (*image)(core::InputFile file, const Format& format, const ImageHints& hints) = nullptr;
};

extern const FormatReader text_reader;
extern const FormatReader binary_reader;
extern const FormatReader npy_reader;
extern const FormatReader hdf5_file_reader;
extern const FormatReader envi_file_reader;
extern const FormatReader sun_reader;
extern const FormatReader custom_reader;

/// The format of a file: that of the hints, otherwise that of its first bytes, otherwise that of its extension where
/// this means no text, otherwise the text that it looks like, otherwise BINARY where its shape is known, otherwise that
/// of its extension. Null where nothing tells.
/// @param pictures  look for pictures, too
[[nodiscard]] const Format* detect_format(const core::InputFile& file, const SampleFileHints& hints, bool pictures);

}  // namespace sarsim::raster
