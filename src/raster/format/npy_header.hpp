#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/os/input_file.hpp"
#include "core/report/problem.hpp"

namespace sarsim::raster {

/// A field of an array of structures.
struct NpyField {
  std::string name;
  std::string type;        ///< As NpyHeader::type.
  std::size_t bytes = 0;   ///< Of one number or text.
  std::size_t count = 1;   ///< Numbers or texts in the field.
  std::size_t offset = 0;  ///< Within the structure.
};

/// What the header of a NumPy array file says.
struct NpyHeader {
  std::string type;                   ///< Array-protocol type, for instance "<c8"; "V" of structures.
  bool fortran_order = false;         ///< First index fastest.
  std::vector<std::uint64_t> shape;   ///< Empty for a single number.
  std::size_t data_offset = 0;        ///< Bytes before the array.
  std::vector<NpyField> fields = {};  ///< Of structures, one behind the other; empty of numbers.

  /// Bytes of a structure.
  [[nodiscard]] std::size_t structure_bytes() const {
    return fields.empty() ? 0 : fields.back().offset + fields.back().bytes * fields.back().count;
  }
};

/// The header of a C-order array, version 1.0, padded with blanks so that the array begins at a multiple of 64 bytes.
/// Reference: NumPy, "numpy.lib.format", NPY format version 1.0.
[[nodiscard]] std::string npy_header_text(std::string_view type, std::span<const std::size_t> shape);

/// Bytes that `bytes` must hold before `parse_npy_header` can say everything: the prefix tells the header's length.
/// 0 where they are not the beginning of a NumPy array file. At least 12 bytes are needed to ask.
[[nodiscard]] std::uint64_t npy_header_size(std::span<const std::byte> bytes);

/// Reads a header of version 1.0, 2.0 or 3.0 from the beginning of a file.
[[nodiscard]] std::variant<NpyHeader, core::Problem> parse_npy_header(std::span<const std::byte> bytes);

/// Reads the header of a file; a problem, without a place, where it is none or longer than 1 MiB.
[[nodiscard]] std::variant<NpyHeader, core::Problem> read_npy_header(const core::InputFile& file);

/// A shape as NumPy prints it, nearly: "(620, 512)", "(512)", "()".
[[nodiscard]] std::string shape_text(const std::vector<std::uint64_t>& shape);

}  // namespace sarsim::raster
