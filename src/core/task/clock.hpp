#pragma once

#include <chrono>

namespace sarsim::core {

/// Seconds on a clock that never goes back; only differences mean anything.
[[nodiscard]] inline double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace sarsim::core
