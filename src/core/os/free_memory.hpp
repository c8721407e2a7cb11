#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace sarsim::core {

/// Memory that programs can still have, in bytes; nothing where the system does not say.
[[nodiscard]] std::optional<std::size_t> free_memory_bytes();

/// Memory of the machine, in bytes; nothing where the system does not say.
[[nodiscard]] std::optional<std::uint64_t> machine_memory_bytes();

/// Whether this process may map that many more bytes under limits like `ulimit -v`: to be asked before calling a
/// library that ends the process when it gets no memory.
[[nodiscard]] bool can_map(std::uint64_t bytes) noexcept;

}  // namespace sarsim::core
