#include "picture/figure/load_drawing.hpp"

#include <dlfcn.h>

#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "core/os/free_memory.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::picture {

namespace {

// Drawing and its fonts end the process where they get no memory, and loading them says no more than that it failed.
void expect_memory() {
  constexpr std::uint64_t of_drawing = std::uint64_t{64} << 20U;
  if (core::can_map(of_drawing)) return;
  throw std::runtime_error(
      fmt::format("no picture can be drawn: drawing needs memory, and {} cannot be had; raise the "
                  "limit (ulimit -v)",
                  core::bytes_text(static_cast<double>(of_drawing))));
}

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
  expect_memory();
  static const DrawingModule& module = loaded();
  return module;
}

}  // namespace sarsim::picture
