#pragma once

#include <algorithm>
#include <atomic>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <thread>
#include <vector>

#include "core/os/scratch_file.hpp"
#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "core/task/stop_points.hpp"
#include "signal/row/raw_samples.hpp"
#include "signal/row/row_kernels.hpp"

namespace sarsim::signal {

/// Counts units of work that several threads do and tells about them on the thread that made the counter.
class WorkCounter {
 public:
  /// @param total  in samples; told as rows of `columns` of them
  WorkCounter(core::ProgressReport report, std::size_t total, std::size_t columns);
  /// From any thread.
  void add(std::size_t done);

 private:
  core::ProgressReport report_;
  std::size_t total_;
  std::size_t columns_;
  std::atomic<std::size_t> done_{0};
  std::thread::id owner_;
};

/// Where large matrices may be worked on.
struct WorkSpace {
  std::size_t memory_bytes = 0;    ///< Beyond it they go to disk; 0: no limit.
  std::filesystem::path folder{};  ///< On disk; empty: the system's folder for temporary files.
};

/// A complex matrix that is gone through by rows and by columns in turn, in memory or, where it would need more than it
/// may, in a file without a name that is gone through piece by piece. What it holds at first is not defined.
class WorkMatrix {
 public:
  using Value = std::complex<float>;
  static constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max();

  /// @param memory_bytes  what it may hold in memory, of the matrix or of pieces, an eighth of it for copies of
  /// columns;
  ///                      0: no limit
  /// @param folder        where the file is made; empty: the system's folder for temporary files.
  ///                      std::system_error where it cannot be
  WorkMatrix(std::size_t rows, std::size_t columns, std::size_t memory_bytes, const std::filesystem::path& folder = {});
  ~WorkMatrix();
  WorkMatrix(WorkMatrix&&) noexcept;
  WorkMatrix& operator=(WorkMatrix&&) noexcept;

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] bool on_disk() const { return file_ != nullptr; }

  /// Calls body(row number, row) for the rows [first, last), on several threads. Rows begin at multiples of 16 bytes.
  /// A requested stop throws Interrupted, also while pieces come from the disk and go there; their rows are lost then.
  template <class Body>
  void each_row(std::size_t first, std::size_t last, const core::WorkControl& control, WorkCounter& counter,
                const Body& body);
  /// Calls body(column number, column) for the columns [first, last); columns are copies that are written back, of up
  /// to 16 at once on each thread.
  /// @param filled  rows from this on count as 0
  template <class Body>
  void each_column(std::size_t first, std::size_t last, const core::WorkControl& control, WorkCounter& counter,
                   const Body& body, std::size_t filled = all_rows);

  /// Columns that each of some threads copies at once: as many as fit their part of the memory, but one at least.
  [[nodiscard]] std::size_t columns_at_once(unsigned threads) const;

  /// Copies `out.size()` values of a row, from column `first` on. Not at the same time as `each_row`.
  void read_row(std::size_t row, std::size_t first, std::span<Value> out) const;

 private:
  // Some rows of the matrix and some columns of them: all of it where it is in memory.
  struct Piece {
    std::size_t first_row = 0, rows = 0;
    std::size_t first_column = 0, columns = 0;
    std::size_t stride = 0;
    Value* values = nullptr;
  };
  [[nodiscard]] std::vector<Piece> row_pieces(std::size_t first, std::size_t last);
  [[nodiscard]] std::vector<Piece> column_pieces(std::size_t first, std::size_t last);
  void load(Piece& piece, const core::StopFlag* stop);
  void store(const Piece& piece, const core::StopFlag* stop);

  std::size_t rows_;
  std::size_t columns_;
  std::size_t stride_;  // even, so that every row begins at a multiple of 16 bytes
  std::size_t memory_bytes_ = 0;
  std::size_t piece_values_ = 0;
  RawSamples store_;  // the matrix, or a piece of it
  std::unique_ptr<core::ScratchFile> file_;
};

// Implementation of the templates.

template <class Body>
void WorkMatrix::each_row(std::size_t first, std::size_t last, const core::WorkControl& control, WorkCounter& counter,
                          const Body& body) {
  for (Piece& piece : row_pieces(first, last)) {
    load(piece, control.stop);
    core::parallel_ranges(piece.rows, 4, control, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        core::end_if_asked(control.stop);  // Rows may be long.
        body(piece.first_row + r, std::span(piece.values + r * piece.stride, columns_));
      }
      counter.add((end - begin) * columns_);
    });
    store(piece, control.stop);
  }
}

template <class Body>
void WorkMatrix::each_column(std::size_t first, std::size_t last, const core::WorkControl& control,
                             WorkCounter& counter, const Body& body, std::size_t filled) {
  filled = std::min(filled, rows_);
  const std::size_t group = columns_at_once(control.threads);
  const std::size_t length = rows_ + rows_ % 2;
  for (Piece& piece : column_pieces(first, last)) {
    load(piece, control.stop);
    core::parallel_ranges(piece.columns, group, control, [&](std::size_t begin, std::size_t end) {
      const RawSamples copies((end - begin) * length);
      transpose(piece.values + begin, piece.stride, filled, end - begin, copies.data(), length);
      for (std::size_t c = 0; c < end - begin; ++c) {
        core::end_if_asked(control.stop);
        const std::span column(copies.data() + c * length, rows_);
        std::fill(column.begin() + static_cast<std::ptrdiff_t>(filled), column.end(), Value());
        body(piece.first_column + begin + c, column);
      }
      transpose(copies.data(), length, end - begin, rows_, piece.values + begin, piece.stride);
      counter.add((end - begin) * rows_);
    });
    store(piece, control.stop);
  }
}

}  // namespace sarsim::signal
