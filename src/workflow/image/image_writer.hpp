#pragma once

#include <complex>
#include <filesystem>
#include <optional>
#include <span>

#include "core/os/output_file.hpp"
#include "raster/format/envi.hpp"
#include "raster/table/raster_writer.hpp"
#include "simulate/plan/sink.hpp"

namespace sarsim::workflow {

/// What stands in the file of an image besides its pixels, for any format.
struct ImageContent {
  raster::EnviHeader header;  ///< Shape, description and fields: the header of ENVI and, of complex pixels, of NPY.
  simulate::Product product;  ///< Axes for HDF5; shape, bits and LSB are filled in.
};

/// Whether a format holds counts, whose LSB is only known with the largest magnitude.
[[nodiscard]] bool needs_largest(const std::filesystem::path& path);

/// Writes an image row by row, in the format that its path's extension says (docs/formats/images.md): ENVI or NPY with
/// a header, HDF5 as complex samples, the others as counts of 16 bits. Files appear with `finish`; destroyed before,
/// nothing stays behind. Throws like the sinks.
class ImageWriter {
 public:
  /// @param largest  magnitude of the image, which full scale stands for; may be 0 unless `needs_largest`
  ImageWriter(const std::filesystem::path& path, ImageContent content, bool replace, double largest);
  ~ImageWriter();

  /// Adds the next row, as long as the image is wide.
  void append(std::span<const std::complex<float>> row);
  /// Writes the header and gives the files their names; std::logic_error where rows are missing.
  void finish();

 private:
  void write_npy_header(core::OutputFile& file) const;

  std::filesystem::path path_;
  ImageContent content_;
  bool replace_;
  simulate::RunReport report_;
  std::optional<raster::EnviWriter> envi_;
  std::optional<raster::RasterWriter> samples_;
};

}  // namespace sarsim::workflow
