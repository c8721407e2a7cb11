#pragma once

#include <complex>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "data/envi.hpp"
#include "data/output_file.hpp"
#include "simulate/sink.hpp"

namespace sarsim::cli {

/// What a picture of maps is, for any format.
struct MapImage {
  std::size_t rows = 0;
  std::size_t columns = 0;
  bool real = false;  ///< Magnitudes: an ENVI image has one number a pixel.
  std::string description;
  std::vector<std::pair<std::string, std::string>> fields;  ///< Of the header of ENVI and NPY.
  Product product;                                          ///< Axes for HDF5; shape, bits and LSB are filled in.
};

/// Whether a format holds counts, whose LSB is only known with the largest magnitude.
[[nodiscard]] bool needs_largest(const std::filesystem::path& path);

/// Writes an image row by row, in the format that its path's extension says (docs/formats/images.md): ENVI or NPY with
/// a header, HDF5 as complex samples, the others as counts of 16 bits. Files appear with `finish`; destroyed before,
/// nothing stays behind. Throws like the sinks.
class MapImageWriter {
 public:
  /// @param largest  magnitude of the image, where `needs_largest`
  MapImageWriter(const std::filesystem::path& path, MapImage image, bool replace, double largest);
  ~MapImageWriter();

  /// Adds the next row, as long as the image is wide.
  void append(std::span<const std::complex<float>> row);
  /// Writes the header and gives the files their names; std::logic_error where rows are missing.
  void finish();

 private:
  [[nodiscard]] EnviHeader header() const;
  void write_npy_header(OutputFile& file) const;

  std::filesystem::path path_;
  MapImage image_;
  bool replace_;
  RunReport report_;
  std::optional<EnviWriter> envi_;
  std::unique_ptr<Sink> sink_;
  std::vector<std::complex<double>> volts_;
  std::vector<std::int64_t> counts_;
  std::size_t rows_ = 0;
};

}  // namespace sarsim::cli
