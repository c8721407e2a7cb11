#include "raster/format/load_hdf5.hpp"

#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "core/os/free_memory.hpp"
#include "core/os/load_module.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::raster {

namespace {

const Hdf5Module& loaded(const std::filesystem::path& wanted_for) {
  const core::LoadedModule module = core::load_module("sarsim_hdf5.so", "sarsim_hdf5_module");
  if (module.entry == nullptr)
    throw std::runtime_error(fmt::format("cannot read or write {}: the program's module for HDF5 cannot be loaded: {}",
                                         wanted_for.string(), module.failure));
  const Hdf5Module& found = *static_cast<const Hdf5Module*>(module.entry);
  found.use_temporary_names(core::temporary_names());
  return found;
}

// The library ends the process where it gets no memory.
void expect_memory(const std::filesystem::path& wanted_for) {
  constexpr std::uint64_t of_library = std::uint64_t{16} << 20U;
  if (core::can_map(of_library)) return;
  throw std::runtime_error(fmt::format("cannot read or write {}: HDF5 needs memory, and {} cannot be had",
                                       wanted_for.string(), core::bytes_text(static_cast<double>(of_library))));
}

}  // namespace

const Hdf5Module& hdf5_module(const std::filesystem::path& wanted_for) {
  expect_memory(wanted_for);  // Before loading, too, which would say no more than that it failed.
  static const Hdf5Module& module = loaded(wanted_for);
  return module;
}

}  // namespace sarsim::raster
