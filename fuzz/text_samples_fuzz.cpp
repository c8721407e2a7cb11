// Text of samples; the first byte chooses the format and the hints.

#include <array>

#include "raster_probe.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using sarsim::scene::FileFormat;
  if (size == 0) return 0;
  constexpr std::array formats{sarsim::scene::FileFormat::ascii, sarsim::scene::FileFormat::csv,
                               sarsim::scene::FileFormat::bracket};
  const unsigned choice = data[0];
  sarsim::raster::RasterHints hints;
  if (choice % 4 < 3) hints.format = formats[choice % 4];
  hints.columns = choice / 4 % 4;
  hints.bits = choice / 16 % 2 == 1 ? 8 : 0;
  sarsim::raster::probe_raster(data + 1, size - 1, hints);
  return 0;
}
