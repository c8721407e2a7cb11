#pragma once

#include <span>

namespace sarsim::core {

/// Closes the descriptors of files that nobody wants any more, whose names are gone already, and returns soon. To take
/// back gigabytes that such files hold costs the system up to a second, in one call that nothing can interrupt: a
/// thread of its own gives them back piece by piece, which the end of the process need not wait for.
void close_later(std::span<const int> descriptors) noexcept;

/// Whether such a thread is still at work.
[[nodiscard]] bool closes_later() noexcept;

}  // namespace sarsim::core
