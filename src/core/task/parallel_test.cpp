#include "core/task/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>

namespace sarsim::core {
namespace parallel_test {

using std::chrono::milliseconds;

// A worker that squares, the later the faster, so that results come out of order.
const auto squares = [] {
  return [](std::size_t index) {
    if (index % 7 == 0) std::this_thread::sleep_for(milliseconds(1));
    return index * index;
  };
};

TEST(OrderedParallel, HandsOverEveryResultInOrderForAnyNumberOfThreads) {
  for (const unsigned threads : {1u, 2u, 3u, 16u})
    for (const std::size_t count : {0u, 1u, 2u, 100u}) {
      std::size_t next = 0;
      ordered_parallel<std::size_t>(
          count, threads, squares,
          [&](std::size_t index, std::size_t&& result) {
            EXPECT_EQ(index, next++);
            EXPECT_EQ(result, index * index);
          },
          nullptr);
      EXPECT_EQ(next, count);
    }
}

TEST(OrderedParallel, ConsumesOnTheCallingThread) {
  const auto caller = std::this_thread::get_id();
  ordered_parallel<int>(
      20, 4, [] { return [](std::size_t) { return 1; }; },
      [&](std::size_t, int&&) { EXPECT_EQ(std::this_thread::get_id(), caller); }, nullptr);
}

TEST(OrderedParallel, MakesOneWorkerPerThreadAndNoMoreThanThereAreResults) {
  const auto workers_for = [](std::size_t count, unsigned threads) {
    std::atomic<int> made{0};
    ordered_parallel<int>(
        count, threads,
        [&] {
          ++made;
          return [](std::size_t) {
            std::this_thread::sleep_for(milliseconds(1));
            return 0;
          };
        },
        [](std::size_t, int&&) {}, nullptr);
    return made.load();
  };
  EXPECT_EQ(workers_for(100, 3), 3);
  EXPECT_EQ(workers_for(2, 8), 2);
}

// The first result is slow: the other threads must wait once they are two results each ahead.
TEST(OrderedParallel, HoldsBackWorkThatNobodyHasConsumed) {
  constexpr unsigned threads = 3;
  std::atomic<std::size_t> begun{0};
  std::size_t consumed = 0;
  std::size_t max_ahead = 0;
  ordered_parallel<int>(
      60, threads,
      [&] {
        return [&](std::size_t index) {
          ++begun;
          if (index == 0) std::this_thread::sleep_for(milliseconds(50));
          return 0;
        };
      },
      [&](std::size_t, int&&) {
        max_ahead = std::max(max_ahead, begun.load() - consumed);
        ++consumed;
      },
      nullptr);
  EXPECT_LE(max_ahead, 2 * threads + 1);
  EXPECT_GE(max_ahead, threads + 1);  // but they did work ahead
}

TEST(OrderedParallel, ThrowsWhatAWorkerThrows) {
  for (const unsigned threads : {1u, 4u}) {
    std::size_t consumed = 0;
    const auto work = [&] {
      ordered_parallel<int>(
          1000, threads,
          [] {
            return [](std::size_t index) {
              if (index == 20) throw std::runtime_error("row 20");
              return 0;
            };
          },
          [&](std::size_t, int&&) { ++consumed; }, nullptr);
    };
    try {
      work();
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "row 20");
    }
    EXPECT_LE(consumed, 20u);
  }
}

TEST(OrderedParallel, ThrowsWhatTheMakingOfAWorkerThrows) {
  const auto make = []() -> int (*)(std::size_t) { throw std::runtime_error("no memory"); };
  EXPECT_THROW(ordered_parallel<int>(
                   5, 2, make, [](std::size_t, int&&) {}, nullptr),
               std::runtime_error);
}

TEST(OrderedParallel, ThrowsWhatTheConsumerThrowsAndStopsTheWork) {
  std::atomic<std::size_t> begun{0};
  EXPECT_THROW(ordered_parallel<int>(
                   100'000, 2, [&] { return [&](std::size_t) { return static_cast<int>(++begun); }; },
                   [](std::size_t index, int&&) {
                     if (index == 5) throw std::logic_error("disk full");
                   },
                   nullptr),
               std::logic_error);
  EXPECT_LE(begun.load(), 5u + 2u * 2u + 1u);
}

TEST(OrderedParallel, EndsWhenAskedTo) {
  StopFlag stop;
  std::size_t consumed = 0;
  EXPECT_THROW(ordered_parallel<int>(
                   100'000, 2, [] { return [](std::size_t) { return 0; }; },
                   [&](std::size_t index, int&&) {
                     ++consumed;
                     if (index == 9) stop.request();
                   },
                   &stop),
               Interrupted);
  EXPECT_EQ(consumed, 10u);
}

// The flag may be set by a signal handler, which wakes nobody: the waiting thread looks at it now and then.
TEST(OrderedParallel, EndsWhenAskedToWhileItWaitsForASlowResult) {
  for (const unsigned threads : {1u, 2u}) {
    StopFlag stop;
    EXPECT_THROW(ordered_parallel<int>(
                     2, threads,
                     [&] {
                       return [&](std::size_t) {
                         stop.request();
                         std::this_thread::sleep_for(milliseconds(200));
                         return 0;
                       };
                     },
                     [](std::size_t, int&&) { FAIL(); }, &stop),
                 Interrupted);
  }
}

// The calling thread works too, but where a result can be handed over, that comes first.
TEST(OrderedParallel, WorksOnTheCallingThreadAloneWhereOneIsWanted) {
  const auto caller = std::this_thread::get_id();
  std::size_t begun = 0;
  ordered_parallel<int>(
      20, 1,
      [&] {
        return [&](std::size_t) {
          ++begun;
          EXPECT_EQ(std::this_thread::get_id(), caller);
          return 0;
        };
      },
      [&](std::size_t index, int&&) { EXPECT_EQ(begun, index + 1); }, nullptr);
  EXPECT_EQ(begun, 20u);
}

TEST(ParallelRanges, CoverEverythingOnceInTheSameRangesForAnyNumberOfThreads) {
  for (const unsigned threads : {0u, 1u, 2u, 3u, 16u})
    for (const std::size_t count : {0u, 1u, 9u, 10u, 11u, 1000u}) {
      std::vector<std::atomic<int>> visits(count);
      std::atomic<std::size_t> ranges{0};
      parallel_ranges(count, 10, {threads}, [&](std::size_t begin, std::size_t end) {
        EXPECT_EQ(begin % 10, 0u);
        EXPECT_EQ(end, std::min(begin + 10, count));
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
        ++ranges;
      });
      EXPECT_EQ(ranges.load(), (count + 9) / 10);
      EXPECT_TRUE(std::ranges::all_of(visits, [](const auto& v) { return v.load() == 1; }));
    }
}

TEST(ParallelRanges, TakeUpAllThreads) {
  // Each of three ranges waits for the others: fewer threads would never end.
  std::atomic<int> present{0};
  parallel_ranges(3, 1, {3}, [&](std::size_t, std::size_t) {
    ++present;
    while (present.load() < 3) std::this_thread::yield();
  });
  EXPECT_EQ(present.load(), 3);
}

TEST(ParallelRanges, ThrowWhatTheLowestOfTheirFailuresThrows) {
  for (const unsigned threads : {1u, 2u, 8u}) {
    std::atomic<std::size_t> begun{0};
    std::string message;
    try {
      parallel_ranges(100'000, 1, {threads}, [&](std::size_t begin, std::size_t) {
        ++begun;
        if (begin == 20) std::this_thread::sleep_for(milliseconds(20));  // later than the next ones
        if (begin >= 20) throw std::runtime_error(std::to_string(begin));
      });
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_EQ(message, "20");
    EXPECT_LE(begun.load(), 21u + threads);
  }
}

TEST(ParallelRanges, EndWhenAskedTo) {
  for (const unsigned threads : {1u, 2u}) {
    StopFlag stop;
    std::atomic<std::size_t> begun{0};
    EXPECT_THROW(parallel_ranges(100'000, 1, {threads, &stop},
                                 [&](std::size_t, std::size_t) {
                                   if (++begun == 5) stop.request();
                                 }),
                 Interrupted);
    EXPECT_LE(begun.load(), 5u + threads);
  }
}

TEST(ReserveTouched, KeepsWhatAListHolds) {
  for (const unsigned threads : {1u, 2u}) {
    std::vector<std::string> list{"a", std::string(100, 'b')};
    reserve_touched(list, 200'000, {threads});
    EXPECT_GE(list.capacity(), 200'000u);
    EXPECT_EQ(list, (std::vector<std::string>{"a", std::string(100, 'b')}));
    reserve_touched(list, 1, {threads});
    EXPECT_EQ(list.size(), 2u);
  }
}

TEST(ThreadCount, IsTheWantedOneOrAtLeastOne) {
  EXPECT_EQ(thread_count(5), 5u);
  EXPECT_GE(thread_count(0), 1u);
}

}  // namespace parallel_test
}  // namespace sarsim::core
