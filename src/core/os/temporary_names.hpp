#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <string>

namespace sarsim::core {

/// What a program and its modules know together of files that mean nothing: lock-free, for signal handlers.
struct TemporaryNames {
  static constexpr std::size_t most = 256;
  std::array<std::atomic<std::string*>, most> slots{};
  std::atomic<int> closing{0};  ///< Threads of `close_later`.
};

}  // namespace sarsim::core
