#pragma once

#include <QColor>
#include <QPalette>

#include "picture/colour/theme.hpp"

namespace sarsim::gui {

/// True where a palette shows light text on a dark ground.
[[nodiscard]] inline bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

/// The colour of picture/colour/theme.hpp that suits a palette.
[[nodiscard]] inline QColor colour_of(picture::Role role, const QPalette& palette) {
  const raster::Rgb rgb = picture::colour(role, is_dark(palette));
  return {rgb.red, rgb.green, rgb.blue};
}

}  // namespace sarsim::gui
