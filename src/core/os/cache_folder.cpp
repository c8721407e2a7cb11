#include "core/os/cache_folder.hpp"

#include <cstdlib>

namespace sarsim::core {

namespace {

namespace fs = std::filesystem;

fs::path absolute_variable(const char* name) {
  const char* value = std::getenv(name);
  const fs::path path = value == nullptr ? "" : value;
  return path.is_absolute() ? path : fs::path();
}

}  // namespace

fs::path user_cache_folder() {
  if (const fs::path folder = absolute_variable("XDG_CACHE_HOME"); !folder.empty()) return folder / "sarsim";
  if (const fs::path home = absolute_variable("HOME"); !home.empty()) return home / ".cache" / "sarsim";
  return {};
}

}  // namespace sarsim::core
