#include "raster/format/load_hdf5.hpp"

#include <dlfcn.h>

#include <stdexcept>

#include <fmt/format.h>

namespace sarsim::raster {

namespace {

// Found by the run path of the program; never unloaded, because sinks and readers carry its code with them.
const Hdf5Module& loaded(const std::filesystem::path& wanted_for) {
  void* const library = ::dlopen("sarsim_hdf5.so", RTLD_NOW | RTLD_LOCAL);
  const void* const module = library != nullptr ? ::dlsym(library, "sarsim_hdf5_module") : nullptr;
  if (module == nullptr)
    throw std::runtime_error(fmt::format("cannot read or write {}: the program's module for HDF5 cannot be loaded: {}",
                                         wanted_for.string(), ::dlerror()));
  const Hdf5Module& found = *static_cast<const Hdf5Module*>(module);
  found.use_temporary_names(core::temporary_names());
  return found;
}

}  // namespace

const Hdf5Module& hdf5_module(const std::filesystem::path& wanted_for) {
  static const Hdf5Module& module = loaded(wanted_for);
  return module;
}

}  // namespace sarsim::raster
