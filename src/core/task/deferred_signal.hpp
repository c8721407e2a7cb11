#pragma once

#include <string>
#include <utility>

#include "core/task/stop.hpp"

namespace sarsim::core {

/// Thrown where work that was asked to stop has kept what it had done, so that somebody can go on.
struct DeferredSignal : Interrupted {
  explicit DeferredSignal(std::string where) : kept_in(std::move(where)) {}
  std::string kept_in;  ///< A folder.
};

}  // namespace sarsim::core
