#include "picture/image/envi_layout.hpp"

#include <system_error>

namespace sarsim {

RawLayout layout_of(const EnviHeader& header) {
  RawLayout layout;
  layout.header_bytes = header.header_offset;
  layout.width = header.samples;
  layout.height = header.lines;
  layout.number = RawNumber::float32;
  layout.value = header.pixel == EnviHeader::Pixel::complex_float ? ImageValue::complex : ImageValue::magnitude;
  return layout;
}

std::optional<RawLayout> envi_layout(const std::filesystem::path& data) {
  // NumPy arrays say themselves what they are.
  if (data.extension() == ".npy") return std::nullopt;
  try {
    if (!has_envi_header(data)) return std::nullopt;
    const auto [image, problems] = EnviImage::open(data);
    if (image) return layout_of(image->header());
  } catch (const std::system_error&) {
    // Whoever opens the file says what the disk says.
  }
  return std::nullopt;
}

}  // namespace sarsim
