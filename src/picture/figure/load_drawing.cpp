#include "picture/figure/load_drawing.hpp"

#include <dlfcn.h>

#include <stdexcept>

#include <fmt/format.h>

namespace sarsim::picture {

namespace {

// Found by the run path of the program; never unloaded, because its libraries keep what they have set up.
const DrawingModule& loaded() {
  void* const library = ::dlopen("sarsim_drawing.so", RTLD_NOW | RTLD_LOCAL);
  const void* const module = library != nullptr ? ::dlsym(library, "sarsim_drawing_module") : nullptr;
  if (module == nullptr)
    throw std::runtime_error(
        fmt::format("no picture can be drawn: the program's module for pictures cannot be loaded: {}", ::dlerror()));
  return *static_cast<const DrawingModule*>(module);
}

}  // namespace

const DrawingModule& drawing_module() {
  static const DrawingModule& module = loaded();
  return module;
}

}  // namespace sarsim::picture
