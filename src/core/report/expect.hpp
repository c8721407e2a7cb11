#pragma once

#include <stdexcept>

namespace sarsim::core {

/// Throws std::invalid_argument with `what` where a precondition does not hold. `what` names the function and what it
/// expects: "back projection: a step is zero".
inline void expect(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

}  // namespace sarsim::core
