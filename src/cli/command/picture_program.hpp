#pragma once

#include <filesystem>

#include "picture/figure/figure.hpp"

namespace sarsim::cli {

/// Size and look of a picture file.
struct PictureStyle {
  int width_px = 1000;
  int height_px = 700;
  double scale = 1.0;  ///< Dots for each pixel (PNG).
  bool dark = false;
};

/// Has the graphical program, which stands beside this one or in the PATH, draw a figure into a file; it needs no
/// display. The command line itself knows nothing of windows and fonts.
/// @throws std::runtime_error where the program is not installed or temporary files cannot be written, with what to do,
/// or with what the program says; std::system_error where the picture cannot be written
void draw_picture(const picture::Figure& figure, const std::filesystem::path& out, const PictureStyle& style);

}  // namespace sarsim::cli
