#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

namespace sarsim::core {

/// Number of this process.
[[nodiscard]] long process_id();

/// Name of this machine in its network.
[[nodiscard]] std::string host_name();

/// When a process began, in ticks since the system did (Linux, proc(5), field 22); 0 where that is not known. A number
/// is given to another process one day; number and beginning together are not.
[[nodiscard]] std::uint64_t process_start(long process);

/// Whether a process is running that began then.
/// @param start  as `process_start` gave it; 0: unknown, any start will do
[[nodiscard]] bool is_running(long process, std::uint64_t start);

/// Why this process may not write an existing file; no error where it may.
[[nodiscard]] std::error_code write_failure(const std::filesystem::path& path);

}  // namespace sarsim::core
