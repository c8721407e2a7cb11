#include "signal/sar/work_matrix.hpp"

#include <algorithm>

#include "core/os/large_pages.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

WorkCounter::WorkCounter(core::ProgressReport report, std::size_t total, std::size_t columns)
    : report_(std::move(report)), total_(total), columns_(columns), owner_(std::this_thread::get_id()) {}

void WorkCounter::add(std::size_t done) {
  const std::size_t sum = done_.fetch_add(done) + done;
  if (report_ && std::this_thread::get_id() == owner_)
    report_({std::min(sum, total_) / columns_, total_ / columns_, columns_});
}

namespace {

void read_all(const core::ScratchFile& file, std::size_t offset, std::span<std::byte> bytes,
              const core::StopFlag* stop) {
  while (!bytes.empty()) {
    core::end_if_asked(stop);
    const std::size_t done = file.read_some(offset, bytes);
    offset += done;
    bytes = bytes.subspan(done);
  }
}

void write_all(const core::ScratchFile& file, std::size_t offset, std::span<const std::byte> bytes,
               const core::StopFlag* stop) {
  while (!bytes.empty()) {
    core::end_if_asked(stop);
    const std::size_t done = file.write_some(offset, bytes);
    offset += done;
    bytes = bytes.subspan(done);
  }
}

constexpr std::size_t copies_part = 8;  // of the memory, one over which columns are copied into

}  // namespace

WorkMatrix::WorkMatrix(std::size_t rows, std::size_t columns, std::size_t memory_bytes,
                       const std::filesystem::path& folder)
    : rows_(rows), columns_(columns), stride_(columns + columns % 2), memory_bytes_(memory_bytes) {
  // Columns whose values lie a power of two apart would all compete for a few places of the cache.
  if (stride_ % 512 == 0) stride_ += 8;
  const std::size_t all = rows_ * stride_;
  const std::size_t most = memory_bytes - memory_bytes / copies_part;
  if (memory_bytes == 0 || all * sizeof(Value) <= most) {
    store_ = RawSamples(all);
    core::prefer_large_pages(store_.data(), all * sizeof(Value));
    return;
  }
  file_ = std::make_unique<core::ScratchFile>(folder);
  file_->reserve(all * sizeof(Value));
  // A piece holds at least a row and a column.
  piece_values_ = std::max({most / sizeof(Value), stride_, 2 * rows_});
  store_ = RawSamples(std::min(piece_values_, all));
}

WorkMatrix::~WorkMatrix() = default;
WorkMatrix::WorkMatrix(WorkMatrix&&) noexcept = default;
WorkMatrix& WorkMatrix::operator=(WorkMatrix&&) noexcept = default;

std::size_t WorkMatrix::columns_at_once(unsigned threads) const {
  // Cache lines are fetched whole: a group of columns is as wide as two of them where there is room.
  constexpr std::size_t wide = 16;
  if (memory_bytes_ == 0) return wide;
  const std::size_t column_bytes = std::max(threads, 1U) * std::max<std::size_t>(rows_, 1) * sizeof(Value);
  return std::clamp<std::size_t>(memory_bytes_ / copies_part / column_bytes, 1, wide);
}

std::vector<WorkMatrix::Piece> WorkMatrix::row_pieces(std::size_t first, std::size_t last) {
  CORE_EXPECT(first <= last);
  CORE_EXPECT(last <= rows_);
  if (!file_) return {{first, last - first, 0, columns_, stride_, store_.data() + first * stride_}};
  std::vector<Piece> pieces;
  const std::size_t most = store_.size() / stride_;
  for (std::size_t row = first; row < last; row += most)
    pieces.push_back({row, std::min(most, last - row), 0, columns_, stride_, store_.data()});
  return pieces;
}

std::vector<WorkMatrix::Piece> WorkMatrix::column_pieces(std::size_t first, std::size_t last) {
  CORE_EXPECT(first <= last);
  CORE_EXPECT(last <= columns_);
  if (!file_) return {{0, rows_, first, last - first, stride_, store_.data() + first}};
  std::vector<Piece> pieces;
  const std::size_t most = std::max<std::size_t>(store_.size() / rows_, 1);
  for (std::size_t column = first; column < last; column += most) {
    const std::size_t width = std::min(most, last - column);
    pieces.push_back({0, rows_, column, width, width, store_.data()});
  }
  return pieces;
}

void WorkMatrix::load(Piece& piece, const core::StopFlag* stop) {
  if (!file_) return;
  if (piece.columns == columns_ && piece.stride == stride_) {
    const auto bytes = std::as_writable_bytes(std::span(piece.values, piece.rows * stride_));
    read_all(*file_, piece.first_row * stride_ * sizeof(Value), bytes, stop);
    return;
  }
  for (std::size_t r = 0; r < piece.rows; ++r) {
    const auto bytes = std::as_writable_bytes(std::span(piece.values + r * piece.stride, piece.columns));
    read_all(*file_, ((piece.first_row + r) * stride_ + piece.first_column) * sizeof(Value), bytes, stop);
  }
}

void WorkMatrix::store(const Piece& piece, const core::StopFlag* stop) {
  if (!file_) return;
  if (piece.columns == columns_ && piece.stride == stride_) {
    const auto bytes = std::as_bytes(std::span(piece.values, piece.rows * stride_));
    write_all(*file_, piece.first_row * stride_ * sizeof(Value), bytes, stop);
    return;
  }
  for (std::size_t r = 0; r < piece.rows; ++r) {
    const auto bytes = std::as_bytes(std::span(piece.values + r * piece.stride, piece.columns));
    write_all(*file_, ((piece.first_row + r) * stride_ + piece.first_column) * sizeof(Value), bytes, stop);
  }
}

void WorkMatrix::read_row(std::size_t row, std::size_t first, std::span<Value> out) const {
  CORE_EXPECT(row < rows_);
  CORE_EXPECT(first + out.size() <= columns_);
  if (file_) {
    read_all(*file_, (row * stride_ + first) * sizeof(Value), std::as_writable_bytes(out), nullptr);
    return;
  }
  std::copy_n(store_.data() + row * stride_ + first, out.size(), out.data());
}

}  // namespace sarsim::signal
