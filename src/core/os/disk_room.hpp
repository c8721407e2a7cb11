#pragma once

#include <filesystem>
#include <string>

namespace sarsim::core {

/// Throws std::runtime_error where the disk of a folder, which need not be there yet, has less room than wanted. A disk
/// that does not tell has room enough.
/// @param advice  what else could be done than to make room, for the message
void expect_room(const std::filesystem::path& folder, double bytes, const std::string& advice);

}  // namespace sarsim::core
