#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/os/input_file.hpp"
#include "core/task/parallel.hpp"
#include "raster/table/image_window.hpp"

namespace sarsim::raster {

/// A table of samples of a fixed size in a file, rows one after the other.
struct StoredGrid {
  /// Turns `count` samples that stand `stride` bytes apart into numbers.
  template <class Real>
  using Decode = void (*)(const StoredGrid& grid, const std::byte* first, std::size_t stride, std::size_t count,
                          std::complex<Real>* out);
  /// The same function for windows and for whole rows.
  struct Decoder {
    Decode<float> window = nullptr;
    Decode<double> rows = nullptr;
  };

  std::uint64_t offset = 0;  ///< Bytes before the first sample.
  std::size_t columns = 0;
  std::size_t sample_bytes = 0;
  Decoder decode;
  double centre = 0.0;             ///< Subtracted from every component.
  std::uint64_t count_offset = 0;  ///< The same where components are whole numbers of any number of bytes.

  [[nodiscard]] std::uint64_t row_bytes() const { return std::uint64_t{columns} * sample_bytes; }
};

/// Reads a window: whole stretches where samples lie close together, sample by sample where they are pages apart.
/// std::runtime_error where the file has become shorter, std::system_error where the disk fails.
void read_grid(const core::InputFile& file, const StoredGrid& grid, const ImageWindow& window,
               std::span<std::complex<float>> out, const core::WorkControl& control);

/// Reads whole rows from `first` on, as many as `out` holds, on the calling thread. Throws like `read_grid`.
void read_grid_rows(const core::InputFile& file, const StoredGrid& grid, std::size_t first,
                    std::span<std::complex<double>> out);

/// Estimated seconds of `read_grid` where the system holds the file in memory.
[[nodiscard]] double grid_cost_s(const StoredGrid& grid, const ImageWindow& window);

}  // namespace sarsim::raster
