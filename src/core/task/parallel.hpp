#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/os/large_pages.hpp"
#include "core/task/stop.hpp"

namespace sarsim::core {

/// What the threads of ordered_parallel share. They take numbers in order, and no number that is further than `ahead`
/// from what has been consumed.
template <class Result>
class OrderedQueue {
 public:
  OrderedQueue(std::size_t count, std::size_t ahead) : count_(count), ahead_(ahead) {}

  /// The next number to work on; waits until there is room for its result. Nothing where the work is over.
  [[nodiscard]] std::optional<std::size_t> take() {
    std::unique_lock hold(lock_);
    room_.wait(hold, [this] { return ended_ || next_ >= count_ || next_ < consumed_ + ahead_; });
    if (ended_ || next_ >= count_) return std::nullopt;
    return next_++;
  }

  /// The same without waiting: nothing, too, where there is no room now.
  [[nodiscard]] std::optional<std::size_t> try_take() {
    const std::scoped_lock hold(lock_);
    if (ended_ || next_ >= count_ || next_ >= consumed_ + ahead_) return std::nullopt;
    return next_++;
  }

  /// Hands in the result of a number that was taken.
  void put(std::size_t index, Result&& result) {
    bool wanted = false;
    {
      const std::scoped_lock hold(lock_);
      ready_.emplace(index, std::move(result));
      wanted = index == consumed_;
    }
    if (wanted) news_.notify_one();
  }

  /// The result that is to be consumed next, if it is there. Throws what a thread failed with.
  [[nodiscard]] std::optional<Result> in_order() {
    const std::scoped_lock hold(lock_);
    if (failure_) std::rethrow_exception(failure_);
    auto node = ready_.extract(consumed_);
    if (node.empty()) return std::nullopt;
    return std::move(node.mapped());
  }

  /// Waits a short while for it, or for a failure.
  void wait_for_news(std::chrono::milliseconds most) {
    std::unique_lock hold(lock_);
    news_.wait_for(hold, most, [this] { return failure_ || ready_.contains(consumed_); });
  }

  /// The result that `in_order` gave has been consumed: there is room for another.
  void count_consumed() {
    {
      const std::scoped_lock hold(lock_);
      ++consumed_;
    }
    room_.notify_all();
  }

  /// Nothing is taken any more.
  void end(std::exception_ptr failure = nullptr) {
    {
      const std::scoped_lock hold(lock_);
      if (!failure_) failure_ = std::move(failure);
      ended_ = true;
    }
    room_.notify_all();
    news_.notify_one();
  }

 private:
  const std::size_t count_;
  const std::size_t ahead_;
  std::mutex lock_;
  std::condition_variable room_;  // For those who wait to take.
  std::condition_variable news_;  // For the one who consumes.
  std::map<std::size_t, Result> ready_;
  std::exception_ptr failure_;
  std::size_t next_ = 0;
  std::size_t consumed_ = 0;
  bool ended_ = false;
};

/// Computes results 0 ... count - 1 on several threads, of which the calling one is one, and hands them over in that
/// order on the calling thread, which comes first for it: a thread of its own would wake for each result and take turns
/// with the others on their cores.
///
/// Each thread makes one worker of its own with `make_worker()` and calls it with an index to get a result; at most two
/// results per thread wait to be consumed, so that memory does not grow with `count`. An exception from a worker or
/// from `consume` stops everything and is thrown to the caller; a requested stop throws Interrupted.
///
/// @param threads      at least 1; 0 counts as 1
/// @param make_worker  () -> callable(std::size_t) -> Result; called once on each thread
/// @param consume      (std::size_t, Result&&)
template <class Result, class MakeWorker, class Consume>
void ordered_parallel(std::size_t count, unsigned threads, const MakeWorker& make_worker, const Consume& consume,
                      const StopFlag* stop) {
  // The stop flag may be set by a signal handler, which wakes nobody: it is looked at now and then.
  constexpr std::chrono::milliseconds longest_wait(50);
  if (count == 0) return;
  OrderedQueue<Result> queue(count, 2 * static_cast<std::size_t>(std::max(threads, 1U)) + 1);
  const auto help = [&] {
    try {
      auto worker = make_worker();
      while (const auto index = queue.take()) queue.put(*index, worker(*index));
    } catch (...) {
      queue.end(std::current_exception());
    }
  };
  std::vector<std::jthread> helpers;
  try {
    for (unsigned i = 1; i < threads && i < count; ++i) helpers.emplace_back(help);
    auto worker = make_worker();
    for (std::size_t consumed = 0; consumed < count;) {
      if (stop != nullptr && stop->requested()) throw Interrupted();
      if (auto result = queue.in_order()) {
        consume(consumed++, std::move(*result));
        queue.count_consumed();
      } else if (const auto index = queue.try_take()) {
        queue.put(*index, worker(*index));
      } else {
        queue.wait_for_news(longest_wait);
      }
    }
  } catch (...) {
    queue.end();
    throw;
  }
  queue.end();
}

/// How work is carried out; nothing here can change its result.
struct WorkControl {
  unsigned threads = 1;
  const StopFlag* stop = nullptr;  ///< Asked now and then; a requested stop throws Interrupted.
};

/// Calls `body(begin, end)` for the ranges [0, grain), [grain, 2 grain) ... of [0, count), on several threads of which
/// the calling one is one. The ranges are the same for any number of threads, so that sums over each of them, added in
/// their order, are too.
///
/// Where bodies throw, what the lowest of their ranges threw is thrown to the caller; a requested stop throws
/// Interrupted. Ranges that have not begun by then are left out.
///
/// @param grain  length of a range but the last, at least 1
template <class Body>
void parallel_ranges(std::size_t count, std::size_t grain, const WorkControl& control, const Body& body) {
  const std::size_t ranges = (count + grain - 1) / grain;
  std::atomic<std::size_t> next{0};
  std::mutex lock;
  std::exception_ptr failure;
  std::size_t failed_range = ranges;
  const auto fail = [&](std::size_t range) {
    next.store(ranges);
    const std::scoped_lock hold(lock);
    if (range >= failed_range) return;
    failed_range = range;
    failure = std::current_exception();
  };
  const auto work = [&] {
    for (std::size_t range = next++; range < ranges; range = next++) try {
        if (control.stop != nullptr && control.stop->requested()) throw Interrupted();
        body(range * grain, std::min(count, (range + 1) * grain));
      } catch (...) {
        fail(range);
      }
  };
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < control.threads && i < ranges; ++i) helpers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

/// `list.reserve(capacity)` for a list that is about to be filled: where it is large, memory that the system has yet to
/// provide costs more than writing to it, and several threads are given it sooner than one.
template <class T>
void reserve_touched(std::vector<T>& list, std::size_t capacity, const WorkControl& control) {
  constexpr std::size_t page_bytes = 4096;
  constexpr std::size_t range_bytes = std::size_t{1} << 20;
  const std::size_t known = list.capacity();
  list.reserve(capacity);
  if (control.threads < 2 || capacity <= known) return;
  prefer_large_pages(list.data(), capacity * sizeof(T));
  const std::size_t used = list.size() * sizeof(T);
  auto* const unused = reinterpret_cast<volatile unsigned char*>(list.data()) + used;
  parallel_ranges(capacity * sizeof(T) - used, range_bytes, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; i += page_bytes) unused[i] = 0;
  });
}

/// Threads to use: `wanted`, or one per core where `wanted` is 0.
[[nodiscard]] inline unsigned thread_count(unsigned wanted) {
  if (wanted > 0) return wanted;
  const unsigned cores = std::thread::hardware_concurrency();
  return cores > 0 ? cores : 1;
}

}  // namespace sarsim::core
