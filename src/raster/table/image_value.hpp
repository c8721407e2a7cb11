#pragma once

#include "raster/table/rgb.hpp"

namespace sarsim::raster {

/// Brightness of a colour, 0 to 255: ITU-R BT.601, 0.299 red + 0.587 green + 0.114 blue.
[[nodiscard]] inline float luminance(Rgb colour) {
  return 0.299F * static_cast<float>(colour.red) + 0.587F * static_cast<float>(colour.green) +
         0.114F * static_cast<float>(colour.blue);
}

/// What the values of an image are.
enum class ImageValue {
  complex,    ///< I and Q.
  real,       ///< A number with a sign, or a grey level.
  magnitude,  ///< Never negative; 20 log10 gives dB.
  power,      ///< Never negative; 10 log10 gives dB.
  rgb,        ///< A colour.
};

}  // namespace sarsim::raster
