#include "core/task/latest_only_worker.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <vector>

namespace sarsim::core {
namespace latest_request_test {

// Tells each step of a request's work until it is stopped, so that only a newer request, or a cancel, ends it.
struct Bench {
  std::mutex lock;
  std::vector<std::uint64_t> told;
  std::atomic<int> begun{0};
  LatestOnlyWorker<int> requests{[this](const int& steps, std::uint64_t number, const StopFlag& stop) {
    ++begun;
    for (int i = 0; (i < steps || steps < 0) && !stop.requested(); ++i)
      requests.tell(stop, [&] {
        const std::scoped_lock hold(lock);
        told.push_back(number);
      });
  }};

  std::vector<std::uint64_t> heard() {
    const std::scoped_lock hold(lock);
    return told;
  }
  void wait_until_begun(int count) const {
    while (begun < count) std::this_thread::yield();
  }
};

TEST(LatestOnlyWorker, IsComputedToItsEnd) {
  Bench bench;
  EXPECT_EQ(bench.requests.show(3), 1U);
  bench.requests.wait();
  EXPECT_EQ(bench.heard(), (std::vector<std::uint64_t>{1, 1, 1}));
}

TEST(LatestOnlyWorker, TellsNothingOfOneThatWasReplacedOnceShowHasReturned) {
  for (int round = 0; round < 200; ++round) {
    Bench bench;
    bench.requests.show(-1);
    bench.wait_until_begun(1);
    const std::uint64_t newer = bench.requests.show(2);
    const std::size_t before = bench.heard().size();
    bench.requests.wait();
    const std::vector<std::uint64_t> all = bench.heard();
    // Of the newer one some may have been told before it was looked.
    for (std::size_t i = before; i < all.size(); ++i) ASSERT_EQ(all[i], newer);
    ASSERT_EQ(std::ranges::count(all, newer), 2);
  }
}

TEST(LatestOnlyWorker, PassesOverWhatIsReplacedBeforeItBegins) {
  Bench bench;
  bench.requests.show(-1);
  bench.wait_until_begun(1);
  for (int i = 0; i < 50; ++i) bench.requests.show(-1);
  bench.requests.show(1);
  bench.requests.wait();
  EXPECT_EQ(bench.heard().back(), 52U);
}

TEST(LatestOnlyWorker, EndsAtOnceWhenCancelledOrDestroyed) {
  Bench bench;
  bench.requests.show(-1);
  bench.wait_until_begun(1);
  bench.requests.cancel();
  const std::size_t told = bench.heard().size();
  bench.requests.wait();
  EXPECT_EQ(bench.heard().size(), told);
  bench.requests.show(-1);
  bench.wait_until_begun(2);
}

}  // namespace latest_request_test
}  // namespace sarsim::core
