// Files without a description: the first bytes choose a layout, the rest are the file. What opens can be read; and
// every layout that is guessed for the file opens.

#include <algorithm>
#include <cstring>

#include "raster/format/open_raster.hpp"
#include "raster_probe.hpp"

namespace {

constexpr std::size_t layout_bytes = 16;

sarsim::raster::RawLayout layout_from(const std::uint8_t* bytes) {
  sarsim::raster::RawLayout layout;
  layout.number = static_cast<sarsim::raster::RawNumber>(bytes[0] % 8);
  layout.value = static_cast<sarsim::raster::ImageValue>(bytes[1] % 5);
  layout.big_endian = (bytes[2] & 1U) != 0;
  layout.q_first = (bytes[2] & 2U) != 0;
  layout.header_bytes = bytes[3];
  // Most widths small, some anything.
  std::uint64_t width = 0;
  std::memcpy(&width, bytes + 4, sizeof width);
  layout.width = static_cast<std::size_t>((bytes[2] & 4U) != 0 ? width : width % 64);
  layout.height = static_cast<std::size_t>(bytes[12]);
  if ((bytes[2] & 8U) != 0) layout.header_bytes <<= 56U;
  float offset = 0.0F;
  std::memcpy(&offset, bytes + 12, sizeof offset);
  layout.offset = static_cast<double>(offset);
  return layout;
}

void read_as(const std::string& path, const sarsim::raster::RawLayout& layout, bool must_open) {
  sarsim::raster::RasterHints hints;
  hints.raw = layout;
  const sarsim::raster::OpenedRaster opened =
      sarsim::raster::open_raster(sarsim::raster::Integrity::partial, path, hints);
  if ((opened.raster != nullptr) == sarsim::core::has_errors(opened.problems))
    throw std::logic_error("a source without errors or errors without a source are promised");
  if (!opened.raster) {
    if (must_open) throw std::logic_error("a layout was guessed that the file cannot have");
    return;
  }
  const sarsim::raster::Raster& source = *opened.raster;
  if (source.rows() == 0) throw std::logic_error("an empty image was opened");
  std::vector<std::complex<float>> samples(source.rows() * source.columns());
  source.read_window({0, source.rows(), 0, source.columns()}, samples);
  std::vector<std::complex<float>> draft(samples.size());
  source.read_draft({0, source.rows(), 0, source.columns()}, 1e-7, draft);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size <= layout_bytes) return 0;
  const sarsim::raster::MemoryFile file(data + layout_bytes, size - layout_bytes);
  read_as(file.path(), layout_from(data), false);
  if ((data[2] & 16U) == 0) return 0;
  const auto guesses = sarsim::raster::guess_raw_layout(file.path());
  for (const sarsim::raster::RawGuess& guess : std::get<std::vector<sarsim::raster::RawGuess>>(guesses))
    read_as(file.path(), guess.layout, true);
  return 0;
}
