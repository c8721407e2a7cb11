#pragma once

#include <cstdint>

namespace sarsim::raster {

/// A colour as red, green, blue from 0 to 255.
struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Rgb&, const Rgb&) = default;
};

}  // namespace sarsim::raster
