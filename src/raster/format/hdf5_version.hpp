#pragma once

extern "C" {

/// Shown by the module `sarsim_hdf5.so`: the version of the HDF5 library that it runs with, as three numbers.
[[gnu::visibility("default")]] void sarsim_hdf5_version(unsigned* numbers);
}
