#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "base/stop.hpp"

namespace sarsim {

/// Computes results 0 ... count - 1 on several threads and hands them over in that order on the calling thread.
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
  const auto stop_wanted = [&] { return stop != nullptr && stop->requested(); };
  std::mutex lock;
  std::condition_variable changed;
  std::map<std::size_t, Result> ready;
  std::exception_ptr failure;
  std::size_t next = 0;
  std::size_t consumed = 0;
  bool ended = false;
  threads = std::max(threads, 1U);
  const std::size_t ahead = 2 * static_cast<std::size_t>(threads) + 1;

  const auto work = [&] {
    try {
      auto worker = make_worker();
      for (;;) {
        std::size_t index = 0;
        {
          std::unique_lock hold(lock);
          changed.wait(hold, [&] { return ended || next >= count || next < consumed + ahead; });
          if (ended || next >= count) return;
          index = next++;
        }
        Result result = worker(index);
        const std::scoped_lock hold(lock);
        ready.emplace(index, std::move(result));
        changed.notify_all();
      }
    } catch (...) {
      const std::scoped_lock hold(lock);
      if (!failure) failure = std::current_exception();
      ended = true;
      changed.notify_all();
    }
  };

  std::vector<std::jthread> pool;
  const auto end_all = [&] {
    const std::scoped_lock hold(lock);
    ended = true;
    changed.notify_all();
  };
  try {
    for (unsigned i = 0; i < threads && i < count; ++i) pool.emplace_back(work);
    while (consumed < count) {
      Result result = [&] {
        std::unique_lock hold(lock);
        while (!failure && !ready.contains(consumed)) {
          // Woken now and then to look at the stop flag, which a signal handler may have set without waking anyone.
          changed.wait_for(hold, std::chrono::milliseconds(50));
          if (stop_wanted()) throw Interrupted();
        }
        if (failure) std::rethrow_exception(failure);
        auto node = ready.extract(consumed);
        return std::move(node.mapped());
      }();
      if (stop_wanted()) throw Interrupted();
      consume(consumed, std::move(result));
      const std::scoped_lock hold(lock);
      ++consumed;
      changed.notify_all();
    }
  } catch (...) {
    end_all();
    throw;
  }
  end_all();
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

}  // namespace sarsim
