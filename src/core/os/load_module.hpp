#pragma once

#include <string>

namespace sarsim::core {

/// What a module of the program offers, or why it cannot be loaded.
struct LoadedModule {
  const void* entry = nullptr;  ///< Of the symbol; null: see `failure`.
  std::string failure;
};

/// Loads a module from the program's own folders and finds a symbol in it. It is never unloaded, since objects that it
/// makes have its code.
[[nodiscard]] LoadedModule load_module(const char* file, const char* symbol);

}  // namespace sarsim::core
