#pragma once

#include <system_error>

#include "core/report/invalid_request.hpp"

namespace sarsim::core {

/// Thrown where a request is refused for now only, because another process holds what it needs. The user made no
/// mistake: the same request may succeed when that process has ended.
struct RetryableError : InvalidRequest {
  using InvalidRequest::InvalidRequest;
};

/// Whether the very same request may succeed later though nobody mends anything: it was refused for now.
[[nodiscard]] bool is_retryable(const InvalidRequest& refused);

/// The same of a failure of the system: something is busy, locked or overloaded, or a file server does not answer. What
/// somebody has to mend (a full disk, a missing permission) does not pass, nor does a lack of memory.
[[nodiscard]] bool is_retryable(const std::error_code& failure);

}  // namespace sarsim::core
