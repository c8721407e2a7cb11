#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/os/input_file.hpp"
#include "core/os/output_file.hpp"
#include "core/report/problem.hpp"

namespace sarsim::raster {

/// What a header of an ENVI image says: `lines` rows of `samples` pixels, least significant byte first, one band
/// (ENVI, "Header Files"; docs/formats/focused-images.md).
struct EnviHeader {
  enum class Pixel { real_float = 4, complex_float = 6 };  ///< Values of "data type".

  std::size_t samples = 0;
  std::size_t lines = 0;
  Pixel pixel = Pixel::complex_float;
  std::size_t header_offset = 0;  ///< Bytes of the data file before the first pixel.
  std::string description;
  std::vector<std::pair<std::string, std::string>> fields;  ///< Others: name in lower case, value.

  /// The value of a field of `fields`, or nothing.
  [[nodiscard]] std::optional<std::string> field(std::string_view name) const;
};

/// Bytes of a pixel.
[[nodiscard]] std::size_t pixel_bytes(EnviHeader::Pixel pixel);

/// The text of a header. Line feeds and braces in values become blanks and parentheses.
[[nodiscard]] std::string to_text(const EnviHeader& header);

/// A header, or at least one error.
struct EnviReading {
  std::optional<EnviHeader> header;
  core::Problems problems;
};

/// Reads the text of a header. Other pixels than those of EnviHeader, none of them, several bands and the other order
/// of bytes are errors.
/// @param file  name of the header, for the problems
[[nodiscard]] EnviReading read_envi_header(std::string_view text, const std::string& file);

/// The header that belongs to a data file: "image.hdr" for "image.img". Where there is an "image.img.hdr", too, and
/// the other one is missing or, by its sizes, that of another file: "image.img.hdr". Throws std::system_error where
/// the disk fails.
[[nodiscard]] std::filesystem::path envi_header_of(const std::filesystem::path& data);

/// The data files beside a header, of its own name before the ending, that it describes to the byte. None where it is
/// missing or not a header.
[[nodiscard]] std::vector<std::filesystem::path> images_of_header(const std::filesystem::path& header_file);

/// Whether a data file has a header beside it, and that is its own: what a NumPy array says of itself is what the
/// header says. A header that cannot be read counts for other files, which cannot be read without.
[[nodiscard]] bool has_envi_header(const std::filesystem::path& data);

/// Writes an image row by row. Data and header appear under their names with `finish`, the data first; destroyed
/// before, nothing stays behind. Throws like OutputFile.
class EnviWriter {
 public:
  /// @param data     the data file; the header takes its place with the extension ".hdr", which it must not have itself
  EnviWriter(const std::filesystem::path& data, EnviHeader header, bool replace);

  /// One row of header.samples pixels; of a real image, their magnitudes are written.
  void append(std::span<const std::complex<float>> row);
  /// Writes the header and gives both files their names; std::logic_error where rows are missing.
  void finish();

 private:
  EnviHeader header_;
  core::OutputFile data_;
  core::OutputFile text_;
  std::size_t rows_ = 0;
  std::vector<float> magnitudes_;
};

/// A flat image, opened for reading. May be called from many threads at once.
class EnviImage {
 public:
  /// Opens the data file of a header, checking its size; at most 1 MiB of a header is read. Throws std::system_error
  /// where the disk fails.
  [[nodiscard]] static std::pair<std::optional<EnviImage>, core::Problems> open(const std::filesystem::path& data);

  [[nodiscard]] const EnviHeader& header() const { return header_; }
  /// Pixels of a line, from a sample on. Real pixels have no imaginary part.
  void read(std::size_t line, std::size_t first, std::span<std::complex<float>> out) const;

 private:
  EnviImage(EnviHeader header, std::filesystem::path data, core::InputFile file);

  EnviHeader header_;
  std::filesystem::path data_;
  std::shared_ptr<const core::InputFile> file_;
};

}  // namespace sarsim::raster
