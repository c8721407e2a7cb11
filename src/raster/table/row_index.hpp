#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/stop.hpp"

namespace sarsim::raster {

/// Where rows of a file begin that has to be looked through to know that: a mark every so many bytes, made on a thread
/// of its own, usable from any thread meanwhile.
template <class Mark>
class RowIndex {
 public:
  /// What the work is given to say what it finds.
  class Recorder {
   public:
    explicit Recorder(RowIndex& index) : index_(index) {}
    /// The row begins at `mark`, `offset` bytes into the file. Kept where far enough behind the last kept one.
    void row_begins(std::size_t row, std::uint64_t offset, const Mark& mark) {
      if (offset < next_offset_) return;
      next_offset_ = offset + index_.spacing_;
      const std::scoped_lock hold(index_.lock_);
      if (index_.marks_.empty() || index_.marks_.back().first < row) index_.marks_.emplace_back(row, mark);
    }
    /// So many rows can be read.
    void rows_known(std::size_t rows) { index_.rows_.store(rows, std::memory_order_release); }
    void part_done(double part) { index_.done_.store(part, std::memory_order_relaxed); }
    /// Something is wrong with the file; the work may go on.
    void problem(core::Problem problem) {
      const std::scoped_lock hold(index_.lock_);
      index_.problems_.push_back(std::move(problem));
    }
    [[nodiscard]] bool stop_wanted() const { return index_.stop_.requested(); }

   private:
    RowIndex& index_;
    std::uint64_t next_offset_ = 0;
  };

  explicit RowIndex(std::uint64_t spacing) : spacing_(spacing) {}
  RowIndex(const RowIndex&) = delete;
  RowIndex& operator=(const RowIndex&) = delete;
  ~RowIndex() {
    stop_.request();
    if (thread_.joinable()) thread_.join();
  }

  /// Begins work on a thread; waits for earlier work first. What it throws becomes a problem about `file`.
  void start(const std::string& file, std::function<void(Recorder&)> work) {
    if (thread_.joinable()) thread_.join();
    {
      const std::scoped_lock hold(lock_);
      running_ = true;
    }
    thread_ = std::thread([this, file, work = std::move(work)] {
      Recorder recorder(*this);
      try {
        work(recorder);
      } catch (const std::exception& error) {
        recorder.problem(core::error(error.what()).in(file));
      }
      const std::scoped_lock hold(lock_);
      running_ = false;
      ended_.notify_all();
    });
  }
  /// Whether the work has not ended yet.
  [[nodiscard]] bool running() const {
    const std::scoped_lock hold(lock_);
    return running_;
  }
  /// Returns when the work has ended; throws Interrupted where a stop is requested before.
  void wait(const core::StopFlag* stop) const {
    std::unique_lock hold(lock_);
    while (running_) {
      ended_.wait_for(hold, std::chrono::milliseconds(20));
      if (stop != nullptr && stop->requested()) throw core::Interrupted();
    }
  }

  [[nodiscard]] std::size_t rows() const { return rows_.load(std::memory_order_acquire); }
  /// 0 to 1.
  [[nodiscard]] double done() const { return running() ? std::min(0.999, done_.load(std::memory_order_relaxed)) : 1.0; }
  /// What was found to be wrong so far.
  [[nodiscard]] core::Problems problems() const {
    const std::scoped_lock hold(lock_);
    return problems_;
  }
  /// How many rows are marked by now.
  [[nodiscard]] std::size_t marks() const {
    const std::scoped_lock hold(lock_);
    return marks_.size();
  }
  /// The last marked row not behind `row` and its mark. The first row is always marked.
  [[nodiscard]] std::pair<std::size_t, Mark> before(std::size_t row) const {
    const std::scoped_lock hold(lock_);
    const auto after = std::ranges::upper_bound(marks_, row, {}, &std::pair<std::size_t, Mark>::first);
    return *(after - 1);
  }

 private:
  const std::uint64_t spacing_;
  mutable std::mutex lock_;
  mutable std::condition_variable ended_;
  std::vector<std::pair<std::size_t, Mark>> marks_;
  core::Problems problems_;
  bool running_ = false;
  std::atomic<std::size_t> rows_{0};
  std::atomic<double> done_{0.0};
  core::StopFlag stop_;
  std::thread thread_;
};

/// Bytes between marks for a file of a size: so few marks that they take some MB at most, so many that a row is found
/// within some hundred KB.
[[nodiscard]] inline std::uint64_t mark_spacing(std::uint64_t file_bytes) {
  constexpr std::uint64_t max_marks = std::uint64_t{1} << 18;
  constexpr std::uint64_t least = std::uint64_t{4} << 10;
  return std::max(least, file_bytes / max_marks);
}

}  // namespace sarsim::raster
