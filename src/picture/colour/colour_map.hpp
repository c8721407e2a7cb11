#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "picture/colour/theme.hpp"

namespace sarsim::picture {

/// How numbers become colours. All but the classic ones are paths of constant speed through OKLab (B. Ottosson, "A
/// perceptual color space for image processing", 2020), so that equal differences of a number look equally large.
enum class ColourMap {
  ocean,             ///< Sequential: violet, blue, green, yellow.
  ember,             ///< Sequential: dark violet, red, light yellow.
  grey,              ///< Sequential: nearly black to white.
  balance,           ///< Diverging: red below, white at the centre, blue above.
  balance_dark,      ///< Diverging: the same with a dark centre.
  cycle,             ///< Cyclic: dark, orange, light, blue, dark.
  classic_grey,      ///< The four palettes of the original, 236 levels, with their sliders.
  classic_red_blue,  ///< Red below, black in the middle, blue above.
  classic_rainbow,
  classic_custom,
};

/// What a map is good for.
enum class ColourMapKind { sequential, diverging, cyclic };

/// A map as people are offered it.
struct ColourMapInfo {
  ColourMap map;
  ColourMapKind kind;
  bool classic;
  std::string_view name;   ///< For files: "balance_dark".
  std::string_view title;  ///< "Balance, dark"
};
[[nodiscard]] std::span<const ColourMapInfo> colour_maps();
[[nodiscard]] const ColourMapInfo& info_of(ColourMap map);

/// The sliders of the classic palettes, 0 to 255; what each means depends on the palette.
struct ClassicSliders {
  double brightness = 127.0;
  double contrast = 127.0;
  double saturation = 127.0;

  friend bool operator==(const ClassicSliders&, const ClassicSliders&) = default;
};

/// Colours from the lowest value to the highest. A cyclic map's last colour is the neighbour of its first.
/// Classic palettes of 236 levels i, with brightness B, contrast C, saturation S:
///
///     n = 1/(4.92e-5 B^2 + 0.2),   m = 0.01271 C^2 + 50
///     grey      y = m (i/236)^n - 127 + S, limited to 0 to 255
///     red-blue  the same of twice the distance from the middle: red below, blue above
///     rainbow   hue (0.3 + 0.00274 C) i/236 of a turn, lightness B/256, saturation S/256
///     custom    hue B/256 of a turn, lightness i/236, saturation S/256
///
/// @param inverted  from the last to the first
/// @param levels    of all maps but the classic ones, at least 2
[[nodiscard]] std::vector<raster::Rgb> colour_table(ColourMap map, const ClassicSliders& sliders = {},
                                                    bool inverted = false, std::size_t levels = 256);

/// A colour in OKLab: lightness 0 to 1, green-red, blue-yellow.
struct OkLab {
  double lightness = 0.0;
  double a = 0.0;
  double b = 0.0;
};
[[nodiscard]] OkLab oklab_of(raster::Rgb colour);
/// The nearest colour of 8 bits; outside what a screen can show each primary is cut off.
[[nodiscard]] raster::Rgb rgb_of(const OkLab& colour);
/// Whether a screen (sRGB) can show it.
[[nodiscard]] bool is_displayable(const OkLab& colour);
/// The colour of a map that is not classic at `position` from 0 to 1, before rounding to 8 bits; positions are
/// proportional to the length of the path.
[[nodiscard]] OkLab colour_at(ColourMap map, double position);

}  // namespace sarsim::picture
