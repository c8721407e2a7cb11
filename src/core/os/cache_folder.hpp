#pragma once

#include <filesystem>

namespace sarsim::core {

/// The user's folder for what can be made again: $XDG_CACHE_HOME/sarsim, otherwise $HOME/.cache/sarsim (XDG Base
/// Directory Specification); empty where neither is an absolute path.
[[nodiscard]] std::filesystem::path user_cache_folder();

}  // namespace sarsim::core
