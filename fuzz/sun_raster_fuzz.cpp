// Sun rasters: any header and pixels behind the magic number. Whatever opens can be read: all rows or the first million
// pixels, the last row, every third pixel as a colour or level, and the same from the rows that are remembered.

#include <algorithm>
#include <cstring>

#include "raster/format/open_raster.hpp"
#include "raster_probe.hpp"

namespace {

constexpr std::size_t max_pixels = std::size_t{1} << 20;

void read_through(const sarsim::raster::Raster& source) {
  const std::size_t columns = std::min(source.columns(), max_pixels);
  const std::size_t rows = std::min(source.rows(), max_pixels / columns);
  std::vector<std::complex<float>> samples(rows * columns);
  source.read_window({0, rows, 0, columns}, samples);
  if (source.rows() == 0) return;
  std::vector<std::complex<float>> last(columns);
  source.read_window({source.rows() - 1, 1, source.columns() - columns, columns}, last);
  if (rows == source.rows() && columns == source.columns() &&
      !std::equal(last.begin(), last.end(), samples.end() - static_cast<std::ptrdiff_t>(columns)))
    throw std::logic_error("a row that is read twice differs");
  if (source.info().value != sarsim::raster::ImageValue::rgb) return;
  std::vector<sarsim::raster::Rgb> colours((columns + 2) / 3);
  source.read_rgb({source.rows() - 1, 1, 0, colours.size(), 1, 3}, colours);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint8_t magic[4] = {0x59, 0xa6, 0x6a, 0x95};
  if (size < sizeof magic) return 0;
  std::vector<std::uint8_t> bytes(data, data + size);
  std::memcpy(bytes.data(), magic, sizeof magic);
  const sarsim::raster::MemoryFile file(bytes.data(), bytes.size());
  const sarsim::raster::OpenedRaster opened =
      sarsim::raster::open_raster(sarsim::raster::Integrity::partial, file.path());
  if ((opened.raster != nullptr) == sarsim::core::has_errors(opened.problems))
    throw std::logic_error("a source without errors or errors without a source are promised");
  if (!opened.raster) return 0;
  opened.raster->wait_until_indexed(nullptr);
  // A picture of a known size cannot become shorter here: nothing may be thrown.
  read_through(*opened.raster);
  return 0;
}
