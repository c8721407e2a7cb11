#pragma once

#include <cstdint>

#include "raster/table/rgb.hpp"

namespace sarsim::picture {

/// What colours of drawings are for. Light and dark give each its own.
enum class Role {
  background,
  text,
  faint,   ///< Grids, drop lines, trails.
  x_axis,  ///< Red, green and blue as in the thesis, told apart by letters as well.
  y_axis,
  z_axis,
  target,
  radar,
  beam,
  platform,
  surface,
  selected,
  hovered,
  error,
  warning,
  curve,  ///< Of plots.
  curve_2,
  curve_3,
  curve_4,
  curve_5,
  solid,  ///< Symbols of platforms, whose sides are darker.
  sky,    ///< Grounds: above a horizon,
  globe,  ///< and the Earth from afar.
  track,  ///< Lines with a tone of their own (`track_colour`).
  count
};

/// Text and marks have a contrast of at least 4.5 : 1 (faint: 1.5 : 1; surface: 1.2 : 1) against the background
/// (WCAG 2.1, 1.4.3), and of 3.5 : 1 against the other grounds, where words have a rim of the background.
[[nodiscard]] raster::Rgb colour(Role role, bool dark);

/// The fill of a surface of a shade, a grey that grows with it, with a contrast of at least 1.2 : 1 against the
/// background: neither white nor black surfaces are lost on a ground of their own colour.
[[nodiscard]] raster::Rgb surface_fill(std::uint8_t shade, bool dark);

/// The colour of a value from 0 to 1 along a track: violet, blue, green, with a contrast of at least 3 : 1 against the
/// background.
[[nodiscard]] raster::Rgb track_colour(double part, bool dark);

/// Contrast of two colours, 1 to 21, after WCAG 2.1.
[[nodiscard]] double contrast(raster::Rgb a, raster::Rgb b);

}  // namespace sarsim::picture
