#include "picture/image/envi_layout.hpp"

#include <system_error>

namespace sarsim::picture {

raster::RawLayout layout_of(const raster::EnviHeader& header) {
  raster::RawLayout layout;
  layout.header_bytes = header.header_offset;
  layout.width = header.samples;
  layout.height = header.lines;
  layout.number = raster::RawNumber::float32;
  layout.value = header.pixel == raster::EnviHeader::Pixel::complex_float ? raster::ImageValue::complex
                                                                          : raster::ImageValue::magnitude;
  return layout;
}

std::optional<raster::RawLayout> envi_layout(const std::filesystem::path& data) {
  // NumPy arrays say themselves what they are.
  if (data.extension() == ".npy") return std::nullopt;
  try {
    if (!raster::has_envi_header(data)) return std::nullopt;
    const auto [image, problems] = raster::EnviImage::open(data);
    if (image) return layout_of(image->header());
  } catch (const std::system_error&) {
    // Whoever opens the file says what the disk says.
  }
  return std::nullopt;
}

}  // namespace sarsim::picture
