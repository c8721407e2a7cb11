#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace sarsim::core {

/// Memory that programs can still have, in bytes; nothing where the system does not say.
[[nodiscard]] std::optional<std::size_t> free_memory_bytes();

/// Whether this process may map so many bytes more, as limits like `ulimit -v` have it: asked before a library is
/// called that ends the process where it gets no memory.
[[nodiscard]] bool can_map(std::uint64_t bytes) noexcept;

}  // namespace sarsim::core
