#include "core/report/retryable.hpp"

#include <algorithm>
#include <cerrno>

namespace sarsim::core {

bool is_retryable(const InvalidRequest& refused) { return dynamic_cast<const RetryableError*>(&refused) != nullptr; }

bool is_retryable(const std::error_code& failure) {
  // EAGAIN: no room for another thread or process. ESTALE: a file server has been started anew.
  constexpr int passing[] = {EAGAIN, EBUSY, ETXTBSY, ENFILE, ENOLCK, ESTALE, ETIMEDOUT, EHOSTDOWN, EHOSTUNREACH};
  const bool of_system = failure.category() == std::generic_category() || failure.category() == std::system_category();
  return of_system && std::ranges::find(passing, failure.value()) != std::end(passing);
}

}  // namespace sarsim::core
