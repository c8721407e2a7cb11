#include "picture/figure/load_drawing.hpp"

#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "core/os/free_memory.hpp"
#include "core/os/load_module.hpp"
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

const DrawingModule& loaded() {
  const core::LoadedModule module = core::load_module("sarsim_drawing.so", "sarsim_drawing_module");
  if (module.entry == nullptr)
    throw std::runtime_error(
        fmt::format("no picture can be drawn: the program's module for pictures cannot be loaded: {}", module.failure));
  return *static_cast<const DrawingModule*>(module.entry);
}

}  // namespace

const DrawingModule& drawing_module() {
  expect_memory();
  static const DrawingModule& module = loaded();
  return module;
}

}  // namespace sarsim::picture
