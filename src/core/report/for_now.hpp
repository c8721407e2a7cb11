#pragma once

#include <system_error>

#include "core/report/refused.hpp"

namespace sarsim::core {

/// Thrown where a request is refused for now only, because another process holds what it needs. The user made no
/// mistake: the same request may succeed when that process has ended.
struct RefusedForNow : Refused {
  using Refused::Refused;
};

/// Whether the very same request may succeed later though nobody mends anything: it was refused for now.
[[nodiscard]] bool may_pass(const Refused& refused);

/// The same of a failure of the system: something is busy, locked or overloaded, or a file server does not answer. What
/// somebody has to mend (a full disk, a missing permission) does not pass, nor does a lack of memory.
[[nodiscard]] bool may_pass(const std::error_code& failure);

}  // namespace sarsim::core
