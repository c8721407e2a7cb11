#pragma once

#include <atomic>
#include <stdexcept>

namespace sarsim::core {

/// A request to end long work early. May be set from any thread and from a signal handler.
class StopFlag {
 public:
  void request() noexcept { requested_.store(true, std::memory_order_relaxed); }
  /// Asked by the work, now and then. Work that is told so ends by itself.
  [[nodiscard]] bool requested() const noexcept {
    if (!requested_.load(std::memory_order_relaxed)) return false;
    noticed_.store(true, std::memory_order_relaxed);
    return true;
  }
  /// Whether some work has been told of the request.
  [[nodiscard]] bool noticed() const noexcept { return noticed_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> requested_{false};
  mutable std::atomic<bool> noticed_{false};
};

/// Thrown by long work that ended because it was asked to.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace sarsim::core
