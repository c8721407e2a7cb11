#pragma once

#include <complex>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "core/report/problem.hpp"
#include "raster/format/sample_reader.hpp"

namespace sarsim::raster {

struct OpenedSampleFile;

/// A file of samples in any of the formats of docs/formats/samples.md, or an image with an ENVI header, opened for
/// reading. Works on files of any size with bounded memory. Its functions may be called from many threads at once.
class SampleFile {
 public:
  /// Opens a file. The format is the hint's, otherwise that of an ENVI header beside a file of another extension than
  /// the formats', otherwise the content's, otherwise the extension's. No file and at least one error where it cannot
  /// be read as samples; warnings and notes may come with either. Throws std::system_error where the disk fails.
  [[nodiscard]] static OpenedSampleFile open(const std::filesystem::path& path, const SampleFileHints& hints = {});

  [[nodiscard]] const SampleFileInfo& info() const { return reader_->info(); }

  /// Reads the rows [first, first + count), one after the other, count * columns samples: counts as they are, with
  /// their sign and without an offset (exact up to 2^53), or volts. std::out_of_range for rows that are not there,
  /// std::invalid_argument where `out` has another size, std::runtime_error where the file has been changed meanwhile
  /// or the disk fails.
  void read_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const;

  /// Times, carriers and slant ranges, where the file carries all of them (HDF5).
  [[nodiscard]] std::optional<SampleAxes> axes() const { return reader_->axes(); }

 private:
  explicit SampleFile(std::unique_ptr<SampleReader> reader) : reader_(std::move(reader)) {}

  std::unique_ptr<SampleReader> reader_;
};

/// A file, or at least one error.
struct OpenedSampleFile {
  std::optional<SampleFile> file;
  core::Problems problems;
};

}  // namespace sarsim::raster
