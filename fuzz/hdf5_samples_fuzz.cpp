// HDF5 files of samples.

#include "raster/format/sample_file_probe.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sarsim::raster::SampleFileHints hints;
  hints.format = sarsim::scene::FileFormat::hdf5;
  sarsim::raster::probe_sample_file(data, size, hints);
  return 0;
}
