#pragma once

#include <complex>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/os/output_file.hpp"
#include "raster/format/envi.hpp"
#include "raster/sicd/sicd_writer.hpp"
#include "raster/table/raster_writer.hpp"
#include "raster/table/sink.hpp"
#include "workflow/image/in_memory_image.hpp"

namespace sarsim::workflow {

/// Whether a format holds counts, whose LSB is only known with the largest magnitude.
[[nodiscard]] bool needs_largest(const std::filesystem::path& path);

/// Writes an image row by row, in the format that its path's extension says (docs/formats/images.md): ENVI or NPY with
/// a header, HDF5 as complex samples, SICD, the others as counts of 16 bits. Files appear with `finish`; destroyed
/// before, nothing stays behind. Throws like the sinks.
class ImageWriter {
 public:
  /// @param largest  magnitude of the image, which full scale stands for; may be 0 unless `needs_largest`
  ImageWriter(const std::filesystem::path& path, ImageContent content, bool replace, double largest);
  /// Keeps the image in memory.
  explicit ImageWriter(ImageContent content);
  ~ImageWriter();

  /// Adds the next row, as long as the image is wide.
  void append(std::span<const std::complex<float>> row);
  /// Writes the header and gives the files their names; std::logic_error where rows are missing.
  void finish();
  /// The image that was kept, once it is finished.
  [[nodiscard]] InMemoryImage kept() &&;

 private:
  void write_npy_header(core::OutputFile& file) const;

  std::filesystem::path path_;
  ImageContent content_;
  bool replace_;
  raster::RunReport report_;
  std::optional<raster::EnviWriter> envi_;
  std::optional<raster::SicdWriter> sicd_;
  std::optional<raster::RasterWriter> samples_;
  std::vector<std::complex<float>> pixels_;  // of an image that is kept
};

}  // namespace sarsim::workflow
