#pragma once

#include <string>

namespace sarsim::raster {

/// Version of the HDF5 library that recordings are written with, such as "1.10.8"; loads the module for it. Where the
/// module, or a library that it needs, cannot be loaded: "absent", with the reason in parentheses.
[[nodiscard]] std::string hdf5_library_version();

}  // namespace sarsim::raster
