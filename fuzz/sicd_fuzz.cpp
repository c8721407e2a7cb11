// SICD files: the headers of NITF, their pixels, and, where the input begins like one, the XML text alone.

#include <cstring>
#include <string_view>

#include "raster/sicd/sicd.hpp"
#include "raster_probe.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0 && data[0] == '<') {
    (void)sarsim::raster::read_sicd_xml({reinterpret_cast<const char*>(data), size}, "file");
    return 0;
  }
  if (size < 4 || std::memcmp(data, "NITF", 4) != 0) return 0;
  sarsim::raster::probe_raster(data, size, {});
  return 0;
}
