#pragma once

#include <atomic>
#include <stdexcept>

namespace sarsim::core {

/// A request to end long work early. May be set from any thread and from a signal handler.
class StopFlag {
 public:
  void request() noexcept { requested_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool requested() const noexcept { return requested_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> requested_{false};
};

/// Thrown by long work that ended because it was asked to.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace sarsim::core
