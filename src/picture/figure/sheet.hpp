#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "raster/table/rgb.hpp"

namespace sarsim::picture {

/// A picture as marks in colours, drawn in the order of its lists. Places are pixels of the screen from the upper left
/// corner.
struct Sheet {
  /// A colour that fades from the upper edge to a row.
  struct Sky {
    raster::Rgb top;
    raster::Rgb horizon;
    double horizon_px = 0.0;
  };
  /// Dots of a screen, some for each pixel.
  struct Image {
    double left = 0.0;
    double top = 0.0;
    int width = 0;   ///< Dots.
    int height = 0;  ///< Dots.
    double dots_per_px = 1.0;
    std::vector<std::uint32_t> argb;  ///< 0xAARRGGBB, multiplied by its opacity.
  };
  /// A straight line.
  struct Line {
    double x0, y0, x1, y1;
    double width_px;
    bool dotted;
    raster::Rgb colour;
  };
  /// A filled circle.
  struct Disc {
    double x, y;
    double diameter_px;
    raster::Rgb colour;
    std::optional<raster::Rgb> rim;
  };
  /// Words.
  struct Text {
    double x, y;  ///< Left end of the base line, or its middle.
    std::string text;
    bool bold;
    bool centred;
    raster::Rgb colour;
  };
  raster::Rgb background;
  std::optional<Sky> sky;
  std::optional<Image> image;
  std::vector<Line> lines;
  std::vector<Disc> discs;
  std::vector<Text> texts;  ///< With a rim in the colour of the background.
};

}  // namespace sarsim::picture
