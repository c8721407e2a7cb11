// The version of the library that the module brings, for hdf5_library_version().

#include "raster/format/hdf5_version.hpp"
#include "raster/hdf5/hdf5_library.hpp"

extern "C" {

void sarsim_hdf5_version(unsigned* numbers) { H5get_libversion(numbers, numbers + 1, numbers + 2); }
}
