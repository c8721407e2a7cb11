#pragma once

#include <QColor>
#include <QPalette>

#include "picture/colour/theme.hpp"

namespace sarsim {

/// True where a palette shows light text on a dark ground.
[[nodiscard]] inline bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

/// The colour of picture/colour/theme.hpp that suits a palette.
[[nodiscard]] inline QColor colour_of(Role role, const QPalette& palette) {
  const Rgb rgb = colour(role, is_dark(palette));
  return {rgb.red, rgb.green, rgb.blue};
}

}  // namespace sarsim
