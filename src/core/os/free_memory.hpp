#pragma once

#include <cstddef>
#include <optional>

namespace sarsim::core {

/// Memory that programs can still have, in bytes; nothing where the system does not say.
[[nodiscard]] std::optional<std::size_t> free_memory_bytes();

}  // namespace sarsim::core
