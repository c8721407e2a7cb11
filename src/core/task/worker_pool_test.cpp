#include "core/task/worker_pool.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace sarsim::core {
namespace worker_pool_test {

// Says when two threads hold it.
struct Item {
  std::atomic<bool> held{false};
};

TEST(WorkerPool, LendsAnItemToOneThreadAtATimeAndMakesNoMoreThanThreads) {
  constexpr std::size_t threads = 4;
  std::atomic<std::size_t> made{0};
  std::atomic<std::size_t> clashes{0};
  WorkerPool<Item> pool([&] {
    ++made;
    return std::make_unique<Item>();
  });
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < threads; ++i)
      workers.emplace_back([&] {
        for (int round = 0; round < 1000; ++round)
          pool.lend([&](Item& item) {
            if (item.held.exchange(true)) ++clashes;
            item.held = false;
          });
      });
  }
  EXPECT_EQ(clashes, 0U);
  EXPECT_GE(made, 1U);
  EXPECT_LE(made, threads);
}

TEST(WorkerPool, LendsWhatWasGivenBack) {
  int made = 0;
  WorkerPool<int> pool([&] { return std::make_unique<int>(++made); });
  for (int round = 0; round < 3; ++round) pool.lend([](int& item) { EXPECT_EQ(item, 1); });
  pool.lend([&](int& outer) {
    EXPECT_EQ(outer, 1);
    pool.lend([](int& inner) { EXPECT_EQ(inner, 2); });
  });
  EXPECT_EQ(made, 2);
}

TEST(WorkerPool, ThrowsAwayAnItemWhoseUseFailed) {
  int made = 0;
  WorkerPool<int> pool([&] { return std::make_unique<int>(++made); });
  EXPECT_THROW(pool.lend([](int&) { throw std::runtime_error("broken"); }), std::runtime_error);
  pool.lend([](int& item) { EXPECT_EQ(item, 2); });
}

}  // namespace worker_pool_test
}  // namespace sarsim::core
