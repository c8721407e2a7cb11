#include "picture/image/overview.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace sarsim::picture {

namespace {

constexpr std::size_t samples_at_once = std::size_t{1} << 18;
constexpr std::size_t first_stride = 64;  // Between the rows of the first look.
constexpr std::uint8_t some = 1;
constexpr std::uint8_t all = 2;

std::size_t cells_of(std::size_t size, unsigned log2) { return size == 0 ? 0 : ((size - 1) >> log2) + 1; }

OverviewLevel level_of(std::size_t rows, std::size_t columns, unsigned row_log2, unsigned col_log2) {
  return {row_log2, col_log2, cells_of(rows, row_log2), cells_of(columns, col_log2)};
}

// Cells of at least 2 x 2 samples, the longer side thinned out until there are few enough.
OverviewLevel base_of(std::size_t rows, std::size_t columns, std::size_t max_cells) {
  OverviewLevel level = level_of(rows, columns, 1, 1);
  while (level.rows > 0 && level.rows > std::max<std::size_t>(max_cells, 1) / level.columns)
    level = level.rows >= level.columns ? level_of(rows, columns, level.row_log2 + 1, level.col_log2)
                                        : level_of(rows, columns, level.row_log2, level.col_log2 + 1);
  return level;
}

// What is gathered of the samples of a row of cells: the largest squared magnitude, or the sum of the magnitudes.
// Samples that are not numbers count as 0, infinite ones as the largest number.
class CellRow {
 public:
  CellRow(OverviewKind kind, std::size_t cells, std::size_t col_bin)
      : kind_(kind), col_bin_(col_bin), gathered_(cells), samples_(cells) {}

  // Consecutive samples of one row of the plane, the first of them `at` columns from the first cell's.
  void add(std::span<const std::complex<float>> samples, std::size_t at) {
    std::size_t cell = at / col_bin_;
    std::size_t left = col_bin_ - at % col_bin_;
    while (!samples.empty()) {
      const std::size_t count = std::min(left, samples.size());
      const auto part = samples.first(count);
      gathered_[cell] =
          kind_ == OverviewKind::peak ? std::max(gathered_[cell], peak_of(part)) : gathered_[cell] + sum_of(part);
      samples_[cell] += count;
      samples = samples.subspan(count);
      ++cell;
      left = col_bin_;
    }
  }
  void take(std::span<float> cells) const {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (samples_[i] == 0) continue;
      const double value =
          kind_ == OverviewKind::peak ? std::sqrt(gathered_[i]) : gathered_[i] / static_cast<double>(samples_[i]);
      cells[i] = static_cast<float>(std::min(value, largest));
    }
  }

 private:
  static constexpr double largest = std::numeric_limits<float>::max();

  static double power_of(const std::complex<float>& sample) {
    const auto i = static_cast<double>(sample.real());
    const auto q = static_cast<double>(sample.imag());
    return i * i + q * q;
  }
  static double peak_of(std::span<const std::complex<float>> samples) {
    double peak = 0.0;
    for (const auto& sample : samples) {
      const double power = power_of(sample);
      peak = power > peak ? power : peak;  // False for what is not a number.
    }
    return peak;
  }
  static double sum_of(std::span<const std::complex<float>> samples) {
    double sum = 0.0;
    for (const auto& sample : samples) {
      const double magnitude = std::sqrt(power_of(sample));
      if (!std::isnan(magnitude)) sum += std::min(magnitude, largest);
    }
    return sum;
  }

  OverviewKind kind_;
  std::size_t col_bin_;
  std::vector<double> gathered_;
  std::vector<std::size_t> samples_;
};

}  // namespace

void reduce_plane(const raster::Raster& plane, OverviewKind kind, std::size_t row0, std::size_t rows,
                  std::size_t row_bin, std::size_t col0, std::size_t cols, std::size_t col_bin, std::span<float> out,
                  const core::StopFlag* stop) {
  if (out.size() != rows * cols) throw std::invalid_argument("the cells and the room for them differ");
  std::ranges::fill(out, 0.0F);
  const std::size_t plane_rows = plane.rows();
  if (out.empty() || row0 >= plane_rows || col0 >= plane.columns()) return;
  const std::size_t left = plane.columns() - col0;
  const std::size_t extent = cols > left / col_bin ? left : cols * col_bin;
  const std::size_t width = std::min(extent, samples_at_once);
  const std::size_t height = std::max<std::size_t>(1, samples_at_once / width);
  std::vector<std::complex<float>> samples;
  for (std::size_t i = 0; i < rows && i <= (plane_rows - row0 - 1) / row_bin; ++i) {
    const std::size_t first = row0 + i * row_bin;
    const std::size_t last = first + std::min(row_bin, plane_rows - first);
    CellRow cells(kind, cols, col_bin);
    for (std::size_t row = first; row < last; row += height)
      for (std::size_t at = 0; at < extent; at += width) {
        if (stop != nullptr && stop->requested()) throw core::Interrupted();
        const raster::ImageWindow window{row, std::min(height, last - row), col0 + at, std::min(width, extent - at)};
        samples.resize(window.samples());
        plane.read_window(window, samples);
        for (std::size_t r = 0; r < window.rows; ++r)
          cells.add(std::span(samples).subspan(r * window.cols, window.cols), at);
      }
    cells.take(out.subspan(i * cols, cols));
  }
}

Overview::Overview(std::shared_ptr<const raster::Raster> plane, const OverviewOptions& options)
    : plane_(std::move(plane)),
      plane_rows_(plane_->rows()),
      options_(options),
      base_(base_of(plane_rows_, plane_->columns(), options.max_cells)) {
  levels_.push_back({base_, {}});
  if (plane_rows_ == 0 || plane_->columns() == 0) {
    base_ = levels_.front().shape = {base_.row_log2, base_.col_log2, 0, 0};
    state_ = OverviewState::complete;
    return;
  }
  levels_.front().cells.resize(base_.rows * base_.columns);
  known_.resize(base_.rows);
  thread_ = std::thread([this] { work(); });
}

Overview::~Overview() {
  stop_.request();
  if (thread_.joinable()) thread_.join();
}

void Overview::work() {
  std::string failure;
  bool done = false;
  try {
    if (!load()) {
      sample_rows();
      refine();
      store();
    }
    make_levels();
    done = true;
  } catch (const core::Interrupted&) {
    failure.clear();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  const std::scoped_lock hold(lock_);
  failure_ = failure;
  state_ = done ? OverviewState::complete : OverviewState::stopped;
  ended_.notify_all();
}

// One row of the plane for each row of cells, every 64th row of cells first, then those between.
void Overview::sample_rows() {
  // Where all samples are read within moments, a first look is not worth it.
  if (plane_rows_ <= (std::size_t{1} << 24U) / plane_->columns()) return;
  std::vector<float> row(base_.columns);
  for (std::size_t stride = first_stride; stride > 0; stride /= 2)
    for (std::size_t cell_row = 0; cell_row < base_.rows; cell_row += stride) {
      if (stride < first_stride && cell_row % (2 * stride) == 0) continue;
      reduce_row(cell_row, 1, row);
      publish(cell_row, row, some);
    }
}

void Overview::refine() {
  std::vector<float> row(base_.columns);
  for (std::size_t cell_row = 0; cell_row < base_.rows; ++cell_row) {
    reduce_row(cell_row, std::size_t{1} << base_.row_log2, row);
    publish(cell_row, row, all);
  }
}

void Overview::reduce_row(std::size_t cell_row, std::size_t count, std::vector<float>& row) const {
  reduce_plane(*plane_, options_.kind, cell_row << base_.row_log2, 1, count, 0, base_.columns,
               std::size_t{1} << base_.col_log2, row, &stop_);
}

void Overview::publish(std::size_t cell_row, const std::vector<float>& row, std::uint8_t known) {
  const std::scoped_lock hold(lock_);
  std::ranges::copy(row, levels_.front().cells.begin() + static_cast<std::ptrdiff_t>(cell_row * base_.columns));
  known_[cell_row] = known;
  if (known == all) ++exact_rows_;
}

// Coarser levels for quick reading, until one is smaller than a screen.
void Overview::make_levels() {
  constexpr std::size_t small_enough = std::size_t{1} << 18;
  std::vector<Level> levels;
  const Level* finer = &levels_.front();  // Only this thread changes the base, which is complete.
  while (finer->cells.size() > small_enough) {
    Level next{level(finer->shape.row_log2 + 1, finer->shape.col_log2 + 1), {}};
    next.cells.resize(next.shape.rows * next.shape.columns);
    for (std::size_t row = 0; row < next.shape.rows; ++row)
      add_cells(*finer, next.shape.row_log2, next.shape.col_log2, row, 0,
                std::span(next.cells).subspan(row * next.shape.columns, next.shape.columns));
    if (stop_.requested()) throw core::Interrupted();
    levels.push_back(std::move(next));
    finer = &levels.back();
  }
  const std::scoped_lock hold(lock_);
  for (Level& made : levels) levels_.push_back(std::move(made));
}

// What the cells depend on besides the file and how it is read.
std::string Overview::cache_words() const {
  return fmt::format("cells 1 {} {} {} {} {}", static_cast<int>(options_.kind), plane_rows_, plane_->columns(),
                     base_.row_log2, base_.col_log2);
}

bool Overview::load() {
  if (!options_.cache) return false;
  auto cells = options_.cache->load(cache_words(), base_.rows * base_.columns);
  if (!cells) return false;
  const std::scoped_lock hold(lock_);
  levels_.front().cells = std::move(*cells);
  std::ranges::fill(known_, all);
  exact_rows_ = base_.rows;
  from_cache_ = true;
  return true;
}

void Overview::store() const {
  // A file that was changed while it was read has another identity now.
  if (!options_.cache || (options_.still_the_same && !options_.still_the_same())) return;
  options_.cache->store(cache_words(), levels_.front().cells);
}

OverviewState Overview::state() const {
  const std::scoped_lock hold(lock_);
  return state_;
}

core::Progress Overview::progress() const {
  const std::scoped_lock hold(lock_);
  return {exact_rows_, base_.rows, plane_->columns() << base_.row_log2};
}

std::string Overview::failure() const {
  const std::scoped_lock hold(lock_);
  return failure_;
}

bool Overview::from_cache() const {
  const std::scoped_lock hold(lock_);
  return from_cache_;
}

void Overview::wait(const core::StopFlag* stop) const {
  std::unique_lock hold(lock_);
  while (state_ == OverviewState::building) {
    ended_.wait_for(hold, std::chrono::milliseconds(20));
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
  }
}

OverviewLevel Overview::level(unsigned row_log2, unsigned col_log2) const {
  return level_of(plane_rows_, plane_->columns(), row_log2, col_log2);
}

std::size_t Overview::shown_row(std::size_t cell_row) const {
  std::size_t row = cell_row;
  while (row > 0 && known_[row] == 0 && cell_row - row + 1 < first_stride) --row;
  return row;
}

// One row of cells from finer ones. Means are weighted with the samples of each cell, which are fewer at the edges.
void Overview::add_cells(const Level& source, unsigned row_log2, unsigned col_log2, std::size_t row, std::size_t col0,
                         std::span<float> out) const {
  const unsigned down = row_log2 - source.shape.row_log2;
  const unsigned across = col_log2 - source.shape.col_log2;
  const std::size_t first = row << down;
  const std::size_t last = std::min(source.shape.rows, (row + 1) << down);
  const auto extent = [](std::size_t cell, unsigned log2, std::size_t size) {
    return static_cast<double>(std::min(size - (cell << log2), std::size_t{1} << log2));
  };
  for (std::size_t k = 0; k < out.size(); ++k) {
    const std::size_t begin = (col0 + k) << across;
    const std::size_t end = std::min(source.shape.columns, (col0 + k + 1) << across);
    float peak = 0.0F;
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t r = first; r < last; ++r) {
      const std::size_t shown = &source == &levels_.front() ? shown_row(r) : r;
      const float* cells = source.cells.data() + shown * source.shape.columns;
      const double height = extent(r, source.shape.row_log2, plane_rows_);
      for (std::size_t c = begin; c < end; ++c) {
        peak = std::max(peak, cells[c]);
        if (options_.kind == OverviewKind::peak) continue;
        const double weight = height * extent(c, source.shape.col_log2, plane_->columns());
        sum += weight * static_cast<double>(cells[c]);
        weights += weight;
      }
    }
    out[k] = options_.kind == OverviewKind::peak ? peak : static_cast<float>(sum / weights);
  }
}

void Overview::read(unsigned row_log2, unsigned col_log2, std::size_t row0, std::size_t rows, std::size_t col0,
                    std::size_t cols, std::span<float> out) const {
  const OverviewLevel wanted = level(row_log2, col_log2);
  if (row_log2 < base_.row_log2 || col_log2 < base_.col_log2 || row_log2 > 62 || col_log2 > 62 || row0 > wanted.rows ||
      rows > wanted.rows - row0 || col0 > wanted.columns || cols > wanted.columns - col0)
    throw std::out_of_range(
        fmt::format("{} x {} cells of 2^{} x 2^{} samples from {}, {} on", rows, cols, row_log2, col_log2, row0, col0));
  if (out.size() != rows * cols) throw std::invalid_argument("the cells and the room for them differ");
  const std::scoped_lock hold(lock_);
  const Level* source = &levels_.front();
  for (const Level& other : levels_)
    if (other.shape.row_log2 <= row_log2 && other.shape.col_log2 <= col_log2) source = &other;
  for (std::size_t i = 0; i < rows; ++i)
    add_cells(*source, row_log2, col_log2, row0 + i, col0, out.subspan(i * cols, cols));
}

}  // namespace sarsim::picture
