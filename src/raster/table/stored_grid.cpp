#include "raster/table/stored_grid.hpp"

#include <algorithm>
#include <vector>

#include "core/report/expect.hpp"

namespace sarsim::raster {

namespace {

// Reading what lies between two samples is cheaper than asking the system once more up to about this many bytes.
constexpr std::size_t stretch_bytes = std::size_t{4} << 10;
constexpr std::size_t chunk_bytes = std::size_t{256} << 10;
// Rows that a thread takes at a time, so that a stop is noticed and starting a thread is worth it.
constexpr std::size_t samples_at_once = std::size_t{1} << 16;

// Measured on a file in the system's memory; docs/formats/images.md.
constexpr double request_s = 0.6e-6;
constexpr double byte_s = 0.4e-9;
constexpr double sample_s = 2e-9;

bool far_apart(const StoredGrid& grid, const ImageWindow& window) {
  return window.col_step > stretch_bytes / grid.sample_bytes;
}

void read_row_far(const core::InputFile& file, const StoredGrid& grid, const ImageWindow& window,
                  std::uint64_t row_offset, std::vector<std::byte>& buffer, std::complex<float>* out) {
  buffer.resize(window.cols * grid.sample_bytes);
  for (std::size_t k = 0; k < window.cols; ++k)
    file.read_all_at(row_offset + std::uint64_t{window.column(k)} * grid.sample_bytes,
                     std::span(buffer).subspan(k * grid.sample_bytes, grid.sample_bytes));
  grid.decode.window(grid, buffer.data(), grid.sample_bytes, window.cols, out);
}

void read_row_near(const core::InputFile& file, const StoredGrid& grid, const ImageWindow& window,
                   std::uint64_t row_offset, std::vector<std::byte>& buffer, std::complex<float>* out) {
  const std::size_t stride = window.col_step * grid.sample_bytes;
  const std::size_t at_once = std::max<std::size_t>(1, chunk_bytes / stride);
  for (std::size_t k = 0; k < window.cols; k += at_once) {
    const std::size_t count = std::min(at_once, window.cols - k);
    buffer.resize((count - 1) * stride + grid.sample_bytes);
    file.read_all_at(row_offset + std::uint64_t{window.column(k)} * grid.sample_bytes, buffer);
    grid.decode.window(grid, buffer.data(), stride, count, out + k);
  }
}

}  // namespace

void read_grid(const core::InputFile& file, const StoredGrid& grid, const ImageWindow& window,
               std::span<std::complex<float>> out, const core::WorkControl& control) {
  CORE_EXPECT(grid.decode.window != nullptr);
  CORE_EXPECT(grid.sample_bytes > 0);
  CORE_EXPECT(out.size() == window.samples());
  CORE_EXPECT(window.row_step >= 1 && window.col_step >= 1);
  CORE_EXPECT(fits(window.col0, window.cols, window.col_step, grid.columns));
  if (window.samples() == 0) return;
  const bool far = far_apart(grid, window);
  const std::size_t grain = std::max<std::size_t>(1, samples_at_once / window.cols);
  core::parallel_ranges(window.rows, grain, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::byte> buffer;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint64_t row_offset = grid.offset + std::uint64_t{window.row(i)} * grid.row_bytes();
      (far ? read_row_far : read_row_near)(file, grid, window, row_offset, buffer, out.data() + i * window.cols);
    }
  });
}

void read_grid_rows(const core::InputFile& file, const StoredGrid& grid, std::size_t first,
                    std::span<std::complex<double>> out) {
  CORE_EXPECT(grid.decode.rows != nullptr);
  CORE_EXPECT(grid.sample_bytes > 0);
  const std::size_t at_once = std::min(out.size(), std::max<std::size_t>(1, chunk_bytes / grid.sample_bytes));
  std::uint64_t place = grid.offset + std::uint64_t{first} * grid.row_bytes();
  std::vector<std::byte> buffer(at_once * grid.sample_bytes);
  while (!out.empty()) {
    const std::size_t count = std::min(at_once, out.size());
    const auto bytes = std::span(buffer).first(count * grid.sample_bytes);
    file.read_all_at(place, bytes);
    grid.decode.rows(grid, bytes.data(), grid.sample_bytes, count, out.data());
    out = out.subspan(count);
    place += bytes.size();
  }
}

double grid_cost_s(const StoredGrid& grid, const ImageWindow& window) {
  CORE_EXPECT(window.row_step >= 1 && window.col_step >= 1);
  if (window.samples() == 0) return 0.0;
  const auto rows = static_cast<double>(window.rows);
  const auto cols = static_cast<double>(window.cols);
  if (far_apart(grid, window)) return rows * cols * (request_s + sample_s);
  const double stride = static_cast<double>(window.col_step) * static_cast<double>(grid.sample_bytes);
  const double requests = std::max(1.0, cols * stride / static_cast<double>(chunk_bytes));
  return rows * (requests * request_s + cols * (stride * byte_s + sample_s));
}

}  // namespace sarsim::raster
