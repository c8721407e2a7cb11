#pragma once

#include <cstddef>
#include <functional>

namespace sarsim::core {

/// How far long work has come.
struct Progress {
  std::size_t done = 0;  ///< Units done, of `total`.
  std::size_t total = 0;
  std::size_t columns = 0;  ///< Size of a unit, for rates; 0 where it has none.
};

/// Told about progress now and then, on the thread that started the work.
using ProgressReport = std::function<void(const Progress&)>;

}  // namespace sarsim::core
