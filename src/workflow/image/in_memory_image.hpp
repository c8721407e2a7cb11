#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "core/task/sample_rows.hpp"
#include "core/task/stop.hpp"
#include "raster/format/envi.hpp"
#include "raster/table/sink.hpp"
#include "workflow/image/image_fields.hpp"
#include "workflow/image/sicd_image.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::workflow {

/// What stands in the file of an image besides its pixels, for any format.
struct ImageContent {
  raster::EnviHeader header;  ///< Shape, description and fields: the header of ENVI and, of complex pixels, of NPY.
  raster::Product product;    ///< Axes for HDF5; shape, bits and LSB are filled in.
  std::optional<SicdImage> sicd{};  ///< Of the image of a SICD file.
};

/// An image that was made and not written.
struct InMemoryImage {
  ImageContent content;
  core::SampleRows<float> rows;               ///< May be on disk; kept as long as this.
  std::optional<ImageOrigin> origin{};        ///< Of focused images: how it came to be,
  std::optional<RecordingArguments> input{};  ///< and what it was made from, as it was opened.
  bool largest_if_needed = false;             ///< Its largest magnitude is looked for only where a format has counts.
  /// How it is written, where that is not the usual way.
  std::function<void(const std::filesystem::path& path, bool replace, const core::StopFlag* stop)> write{};
};

/// Writes it as it would have been written when it was made. Throws Interrupted, and like the sinks.
void write_image(const InMemoryImage& image, const std::filesystem::path& path, bool replace,
                 const core::StopFlag* stop);

}  // namespace sarsim::workflow
