#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/formats.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::raster {

/// What the caller knows of a file that does not describe itself. Zero and empty: not known.
struct SampleFileHints {
  std::optional<scene::FileFormat> format;  ///< Otherwise found from the content, then from the extension.
  std::size_t columns = 0;  ///< Samples of a row: needed for BINARY; for ASCII and BRACKET it replaces row ends.
  std::size_t rows = 0;     ///< Checked against the file where given.
  int bits = 0;             ///< Of the A/D converter: needed for BINARY, and for CSV with an offset.
  double lsb_v = 0.0;
};

/// What a file of samples is.
struct SampleFileInfo {
  const Format* format = nullptr;  ///< Its row in the table; never null once a file is open.
  std::size_t rows = 0;
  std::size_t columns = 0;
  bool counts = true;                                           ///< The numbers are A/D counts; otherwise volts.
  int bits = 0;                                                 ///< 0 where unknown.
  std::optional<double> lsb_v;                                  ///< Volts of a count, where known.
  std::optional<double> sample_rate_hz;                         ///< Where the file says it.
  std::vector<std::pair<std::string, std::string>> attributes;  ///< Everything else a file says of itself: name, value.
};

/// The axes of a recording, where a file carries them.
struct SampleAxes {
  std::vector<double> row_time_s;      ///< Send time of each row's (first) pulse.
  std::vector<double> row_carrier_hz;  ///< Its carrier.
  std::vector<double> column_range_m;  ///< One-way slant range of each column.
};

/// One open file of samples. Functions may be called from many threads at once.
class SampleReader {
 public:
  explicit SampleReader(SampleFileInfo info) : info_(std::move(info)) {}
  SampleReader(const SampleReader&) = delete;
  SampleReader& operator=(const SampleReader&) = delete;
  virtual ~SampleReader() = default;

  [[nodiscard]] const SampleFileInfo& info() const { return info_; }
  /// Says by which format the file was opened.
  void set_format(const Format& format) { info_.format = &format; }
  /// See SampleFile::read_rows; the arguments are already checked.
  virtual void read_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const = 0;
  /// See SampleFile::axes.
  [[nodiscard]] virtual std::optional<SampleAxes> axes() const { return std::nullopt; }

 private:
  SampleFileInfo info_;
};

/// A reader, or nothing and at least one error. Warnings and notes may come with either.
struct OpenedReader {
  std::unique_ptr<SampleReader> reader;
  core::Problems problems;
};

/// rows * columns * bytes, or nothing where that does not fit into 64 bits signed.
[[nodiscard]] inline std::optional<std::uint64_t> checked_product(std::uint64_t a, std::uint64_t b,
                                                                  std::uint64_t c = 1) {
  std::uint64_t result = 0;
  if (__builtin_mul_overflow(a, b, &result) || __builtin_mul_overflow(result, c, &result)) return std::nullopt;
  if (result > static_cast<std::uint64_t>(INT64_MAX)) return std::nullopt;
  return result;
}

/// An error about a whole file.
[[nodiscard]] inline core::Problem file_problem(const std::string& file, std::string message, std::string found = {},
                                                std::string expected = {}, std::string hint = {}) {
  core::Problem problem;
  problem.message = std::move(message);
  problem.found = std::move(found);
  problem.expected = std::move(expected);
  problem.hint = std::move(hint);
  problem.place.file = file;
  return problem;
}

/// The same at another severity.
[[nodiscard]] inline core::Problem with_severity(core::Problem problem, core::Severity severity) {
  problem.severity = severity;
  return problem;
}

}  // namespace sarsim::raster
