#include "core/os/load_module.hpp"

#include <dlfcn.h>

namespace sarsim::core {

LoadedModule load_module(const char* file, const char* symbol) {
  void* const library = ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
  const void* const entry = library != nullptr ? ::dlsym(library, symbol) : nullptr;
  return entry != nullptr ? LoadedModule{entry, {}} : LoadedModule{nullptr, ::dlerror()};
}

}  // namespace sarsim::core
