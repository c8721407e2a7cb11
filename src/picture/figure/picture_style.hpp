#pragma once

namespace sarsim::picture {

/// What pictures are written as.
enum class PictureKind { png, svg, pdf };

/// Size and look of a picture.
struct PictureStyle {
  int width_px = 1000;  ///< PDF: points.
  int height_px = 700;
  double scale = 1.0;  ///< Dots for each pixel (PNG).
  bool dark = false;   ///< Light words on a dark ground.
};

}  // namespace sarsim::picture
