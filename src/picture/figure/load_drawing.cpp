#include "picture/figure/load_drawing.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "core/os/load_module.hpp"

namespace sarsim::picture {

namespace {

const DrawingModule& loaded() {
  const core::LoadedModule module = core::load_module("sarsim_drawing.so", "sarsim_drawing_module");
  if (module.entry == nullptr)
    throw std::runtime_error(
        fmt::format("no picture can be drawn: the program's module for pictures cannot be loaded: {}", module.failure));
  return *static_cast<const DrawingModule*>(module.entry);
}

}  // namespace

const DrawingModule& drawing_module() {
  static const DrawingModule& module = loaded();
  return module;
}

}  // namespace sarsim::picture
