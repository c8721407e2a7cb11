#include "signal/sar/work_matrix.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

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

// A file that vanishes with the process.
struct WorkMatrix::File {
  // Between two looks for a stop: a piece may be all of the memory.
  static constexpr std::size_t max_bytes = std::size_t{4} << 20U;

  int descriptor = -1;
  std::filesystem::path folder;

  explicit File(std::filesystem::path where) : folder(std::move(where)) {
    if (folder.empty()) folder = std::filesystem::temp_directory_path();
    std::string name = (folder / "sarsim-XXXXXX").string();
    descriptor = ::mkstemp(name.data());
    if (descriptor < 0) fail("make a temporary file in");
    ::unlink(name.c_str());
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { ::close(descriptor); }

  [[noreturn]] void fail(const char* what) const {
    throw std::system_error(errno, std::generic_category(),
                            std::string("cannot ") + what + " '" + folder.string() + "'");
  }
  void reserve(std::size_t bytes) const {
    int error = EINTR;
    while (error == EINTR) error = ::posix_fallocate(descriptor, 0, static_cast<off_t>(bytes));
    if (error == 0) return;
    errno = error;
    fail("make room for a temporary file in");
  }
  void read(std::size_t offset, std::span<std::byte> bytes, const core::StopFlag* stop) const {
    while (!bytes.empty()) {
      end_if_wanted(stop);
      const std::size_t part = std::min(bytes.size(), max_bytes);
      const ssize_t done = ::pread(descriptor, bytes.data(), part, static_cast<off_t>(offset));
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail("read a temporary file in");
      offset += static_cast<std::size_t>(done);
      bytes = bytes.subspan(static_cast<std::size_t>(done));
    }
  }
  void write(std::size_t offset, std::span<const std::byte> bytes, const core::StopFlag* stop) const {
    while (!bytes.empty()) {
      end_if_wanted(stop);
      const std::size_t part = std::min(bytes.size(), max_bytes);
      const ssize_t done = ::pwrite(descriptor, bytes.data(), part, static_cast<off_t>(offset));
      if (done < 0 && errno == EINTR) continue;
      if (done == 0) errno = EIO;
      if (done <= 0) fail("write a temporary file in");
      offset += static_cast<std::size_t>(done);
      bytes = bytes.subspan(static_cast<std::size_t>(done));
    }
  }
};

namespace {

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
  file_ = std::make_unique<File>(folder);
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
    file_->read(piece.first_row * stride_ * sizeof(Value), bytes, stop);
    return;
  }
  for (std::size_t r = 0; r < piece.rows; ++r) {
    const auto bytes = std::as_writable_bytes(std::span(piece.values + r * piece.stride, piece.columns));
    file_->read(((piece.first_row + r) * stride_ + piece.first_column) * sizeof(Value), bytes, stop);
  }
}

void WorkMatrix::store(const Piece& piece, const core::StopFlag* stop) {
  if (!file_) return;
  if (piece.columns == columns_ && piece.stride == stride_) {
    const auto bytes = std::as_bytes(std::span(piece.values, piece.rows * stride_));
    file_->write(piece.first_row * stride_ * sizeof(Value), bytes, stop);
    return;
  }
  for (std::size_t r = 0; r < piece.rows; ++r) {
    const auto bytes = std::as_bytes(std::span(piece.values + r * piece.stride, piece.columns));
    file_->write(((piece.first_row + r) * stride_ + piece.first_column) * sizeof(Value), bytes, stop);
  }
}

void WorkMatrix::read_row(std::size_t row, std::size_t first, std::span<Value> out) const {
  CORE_EXPECT(row < rows_);
  CORE_EXPECT(first + out.size() <= columns_);
  if (file_) {
    file_->read((row * stride_ + first) * sizeof(Value), std::as_writable_bytes(out), nullptr);
    return;
  }
  std::copy_n(store_.data() + row * stride_ + first, out.size(), out.data());
}

}  // namespace sarsim::signal
