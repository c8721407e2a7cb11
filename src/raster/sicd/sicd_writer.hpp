#pragma once

#include <complex>
#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "core/os/output_file.hpp"
#include "raster/sicd/nitf.hpp"
#include "raster/sicd/sicd.hpp"

namespace sarsim::raster {

/// The container of an image.
[[nodiscard]] NitfContent nitf_content(const Sicd& image);

/// Writes a SICD file from an image whose rows are places along the track, one after the other: they become the columns
/// of the file, for a radar that looks to the left from the last one on. Holds some of them at a time, at most 64 MiB
/// or 64 rows. The file appears under its name with `finish`; destroyed before, nothing stays behind. The same bytes
/// for any number of rows that are held. Throws like OutputFile; core::InvalidRequest for pipes and for images that
/// NITF cannot hold.
class SicdWriter {
 public:
  /// @param backwards  the first row that is appended becomes the last column
  SicdWriter(const std::filesystem::path& path, const Sicd& image, bool backwards, bool replace);

  /// One row: `image.rows` samples.
  void append(std::span<const std::complex<float>> row);
  /// Gives the file its name; std::logic_error where rows are missing.
  void finish();

 private:
  void write_held();

  core::OutputFile file_;
  NitfLayout layout_;
  std::size_t rows_;     // of the file
  std::size_t columns_;  // of the file
  bool backwards_;
  std::size_t at_once_;
  std::size_t appended_ = 0;
  std::size_t held_ = 0;
  std::vector<std::complex<float>> turned_;  // rows_ stretches of at_once_
};

}  // namespace sarsim::raster
