#include "raster/format/library_version.hpp"

#include <dlfcn.h>

#include <array>

#include <fmt/format.h>

#include "raster/format/hdf5_version.hpp"

namespace sarsim::raster {

std::string hdf5_library_version() {
  void* const library = ::dlopen("sarsim_hdf5.so", RTLD_NOW | RTLD_LOCAL);  // Stays, as hdf5_module() needs it.
  void* const symbol = library != nullptr ? ::dlsym(library, "sarsim_hdf5_version") : nullptr;
  if (symbol == nullptr) return fmt::format("absent ({})", ::dlerror());
  std::array<unsigned, 3> numbers{};
  reinterpret_cast<decltype(&sarsim_hdf5_version)>(symbol)(numbers.data());
  return fmt::format("{}.{}.{}", numbers[0], numbers[1], numbers[2]);
}

}  // namespace sarsim::raster
