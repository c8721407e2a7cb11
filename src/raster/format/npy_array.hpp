#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "raster/format/npy_header.hpp"
#include "raster/table/image_value.hpp"
#include "raster/table/stored_grid.hpp"

namespace sarsim::raster {

/// A type of numbers of NumPy's.
struct NpyType {
  std::string_view name;  ///< Without the byte order: "c8".
  std::size_t bytes;      ///< Of a component.
  bool pair;              ///< The type stands for a whole I/Q pair.
  bool counts;            ///< Whole numbers.
  bool sample;            ///< Files of samples may have it, least significant byte first.
  /// The decoder of its samples.
  StoredGrid::Decoder (*decoder)(bool complex, bool big_endian, bool q_first);
};

/// The type that a header names, of either byte order; null for one that is not read.
[[nodiscard]] const NpyType* npy_type_of(const NpyHeader& header);
/// The same where files of samples may have it as it is stored.
[[nodiscard]] const NpyType* npy_sample_type_of(const NpyHeader& header);
/// The names of all types that files of samples may have: "<c8, <c16, <f4".
[[nodiscard]] std::string npy_sample_types();

/// What an array is as rows and columns.
struct NpyPlane {
  std::uint64_t rows = 1;
  std::uint64_t columns = 1;
  std::uint64_t components = 1;  ///< Stored for each sample beyond the type's own.
  ImageValue value = ImageValue::real;
};

/// The rows and columns that a shape means: a last dimension of 2 makes pairs, one of 3 bytes colours, a single
/// dimension a single row. Nothing for other shapes, those without a sample, and components in Fortran order.
[[nodiscard]] std::optional<NpyPlane> npy_plane_of(const NpyHeader& header, const NpyType& type);

}  // namespace sarsim::raster
