// HDF5 files of samples.

#include "raster_probe.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sarsim::raster::RasterHints hints;
  hints.format = sarsim::scene::FileFormat::hdf5;
  sarsim::raster::probe_raster(data, size, hints);
  return 0;
}
