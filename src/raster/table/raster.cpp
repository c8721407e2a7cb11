#include "raster/table/raster.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

void check_window(const Raster& raster, const ImageWindow& window, std::size_t room) {
  const std::size_t rows = raster.rows();
  if (!fits(window.row0, window.rows, window.row_step, rows) ||
      !fits(window.col0, window.cols, window.col_step, raster.columns()))
    throw std::out_of_range(fmt::format("{} x {} samples from row {} and column {}, {} and {} apart, of {} x {}",
                                        window.rows, window.cols, window.row0, window.col0, window.row_step,
                                        window.col_step, rows, raster.columns()));
  if (checked_product(window.rows, window.cols) != room)
    throw std::invalid_argument(fmt::format("room for {} samples instead of {} x {}", room, window.rows, window.cols));
}

// One direction of a window at a wider spacing.
std::size_t coarse_count(std::size_t count, std::size_t factor) { return (count + factor - 1) / factor; }

ImageWindow coarser(const ImageWindow& window, std::size_t row_factor, std::size_t col_factor) {
  ImageWindow result = window;
  result.rows = coarse_count(window.rows, row_factor);
  result.cols = coarse_count(window.cols, col_factor);
  result.row_step *= row_factor;
  result.col_step *= col_factor;
  return result;
}

}  // namespace

void Raster::read_window(const ImageWindow& window, std::span<std::complex<float>> out,
                         const core::WorkControl& control) const {
  check_window(*this, window, out.size());
  if (out.empty()) return;
  read_samples(window, out, control);
  if (!rule_.is_plain()) rule_.apply(out);
}

void Raster::read_rgb(const ImageWindow& window, std::span<Rgb> out, const core::WorkControl& control) const {
  if (info_.value != ImageValue::rgb) throw std::logic_error("an image without colours was asked for them");
  check_window(*this, window, out.size());
  if (!out.empty()) read_colours(window, out, control);
}

void Raster::read_colours(const ImageWindow&, std::span<Rgb>, const core::WorkControl&) const {
  throw std::logic_error("an image without colours was asked for them");
}

void Raster::read_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const {
  const std::size_t known = rows();
  if (first > known || count > known - first)
    throw std::out_of_range(fmt::format("rows {} to {} of a file of {} rows", first, first + count, known));
  if (checked_product(count, columns()) != out.size())
    throw std::invalid_argument(
        fmt::format("room for {} samples instead of {} rows of {}", out.size(), count, columns()));
  if (out.empty()) return;
  read_whole_rows(first, count, out);
  if (!rule_.is_plain()) rule_.apply(out);
}

void Raster::read_whole_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const {
  constexpr std::size_t max_at_once = std::size_t{1} << 16;
  const std::size_t at_once = std::clamp<std::size_t>(max_at_once / columns(), 1, count);
  std::vector<std::complex<float>> samples(at_once * columns());
  for (std::size_t row = 0; row < count; row += at_once) {
    const std::size_t rows = std::min(at_once, count - row);
    const auto part = std::span(samples).first(rows * columns());
    read_samples({first + row, rows, 0, columns()}, part, {});
    std::ranges::copy(part, out.begin() + static_cast<std::ptrdiff_t>(row * columns()));
  }
}

ImageWindow Raster::read_draft(const ImageWindow& window, double seconds, std::span<std::complex<float>> out,
                               const core::WorkControl& control) const {
  CORE_EXPECT(seconds >= 0.0);
  check_window(*this, window, out.size());
  if (out.empty()) return window;
  seconds /= slowness_.load(std::memory_order_relaxed);
  std::size_t row_factor = 1;
  std::size_t col_factor = 1;
  while (read_cost_s(coarser(window, row_factor, col_factor)) > seconds) {
    const bool rows_left = row_factor < window.rows;
    const bool cols_left = col_factor < window.cols;
    if (!rows_left && !cols_left) break;
    const double fewer_rows = read_cost_s(coarser(window, 2 * row_factor, col_factor));
    const double fewer_cols = read_cost_s(coarser(window, row_factor, 2 * col_factor));
    // What saves more; of equals, what keeps the blocks square.
    const bool by_rows = fewer_rows < 0.9 * fewer_cols || (fewer_rows < 1.1 * fewer_cols && row_factor <= col_factor);
    (rows_left && (by_rows || !cols_left) ? row_factor : col_factor) *= 2;
  }
  const ImageWindow coarse = coarser(window, row_factor, col_factor);
  const bool exact = coarse == window;
  std::vector<std::complex<float>> samples(exact ? 0 : coarse.samples());
  const auto begin = std::chrono::steady_clock::now();
  read_window(coarse, exact ? out : std::span(samples), control);
  const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  // One slow call is no rule, and times far below a millisecond are none either.
  const double old = slowness_.load(std::memory_order_relaxed);
  if (taken > 1e-3) slowness_.store(std::clamp(std::sqrt(old * taken / read_cost_s(coarse)), 0.25, 1000.0));
  if (exact) return window;
  for (std::size_t i = 0; i < window.rows; ++i)
    for (std::size_t k = 0; k < window.cols; ++k)
      out[i * window.cols + k] = samples[i / row_factor * coarse.cols + k / col_factor];
  return coarse;
}

}  // namespace sarsim::raster
