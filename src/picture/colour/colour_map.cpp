#include "picture/colour/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/maths/constants.hpp"

namespace sarsim::picture {

namespace {

constexpr std::array<ColourMapInfo, 10> maps{{
    {ColourMap::ocean, ColourMapKind::sequential, false, "ocean", "Ocean"},
    {ColourMap::ember, ColourMapKind::sequential, false, "ember", "Ember"},
    {ColourMap::grey, ColourMapKind::sequential, false, "grey", "Grey"},
    {ColourMap::balance, ColourMapKind::diverging, false, "balance", "Balance"},
    {ColourMap::balance_dark, ColourMapKind::diverging, false, "balance_dark", "Balance, dark"},
    {ColourMap::cycle, ColourMapKind::cyclic, false, "cycle", "Cycle"},
    {ColourMap::classic_grey, ColourMapKind::sequential, true, "classic_grey", "Classic: grey scale"},
    {ColourMap::classic_red_blue, ColourMapKind::diverging, true, "classic_red_blue", "Classic: red-blue"},
    {ColourMap::classic_rainbow, ColourMapKind::sequential, true, "classic_rainbow", "Classic: rainbow"},
    {ColourMap::classic_custom, ColourMapKind::sequential, true, "classic_custom", "Classic: one hue"},
}};

constexpr int classic_levels = 236;

struct LinearRgb {
  double red, green, blue;
};

double linear_of(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double encoded_of(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

LinearRgb linear_of(const OkLab& c) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b);
  const double m = cube(c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b);
  const double s = cube(c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

std::uint8_t byte_of(double zero_to_255) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(zero_to_255 + 0.5), 0.0, 255.0));
}

OkLab polar(double lightness, double chroma, double hue_deg) {
  const double hue = hue_deg * core::pi / 180.0;
  return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

double smooth(double x) { return std::sin(0.5 * core::pi * std::clamp(x, 0.0, 1.0)); }

// The path of a map before its speed is made constant, 0 <= t <= 1. The numbers keep it inside what a screen shows.
OkLab path(ColourMap map, double t) {
  switch (map) {
    case ColourMap::ocean: {
      const double end = std::max(0.0, t - 0.6) / 0.4;
      return polar(0.22 + 0.73 * t, 0.09 + 0.06 * end * end, 305.0 - 200.0 * t);
    }
    case ColourMap::ember: return polar(0.12 + 0.84 * t, 0.046 + 0.13 * std::sin(core::pi * t), 290.0 + 165.0 * t);
    case ColourMap::balance: {
      const double s = std::abs(2.0 * t - 1.0);
      return polar(0.96 - 0.54 * s, 0.13 * smooth(1.8 * s), t < 0.5 ? 30.0 : 255.0);
    }
    case ColourMap::balance_dark: {
      const double s = std::abs(2.0 * t - 1.0);
      return polar(0.14 + 0.64 * s, 0.105 * smooth(2.4 * s), t < 0.5 ? 30.0 : 255.0);
    }
    case ColourMap::cycle:
      return polar(0.6 - 0.3 * std::cos(2.0 * core::pi * t), 0.115 * std::sin(2.0 * core::pi * t), 60.0);
    default: return {0.13 + 0.87 * t, 0.0, 0.0};  // below, 8 bits have too few greys
  }
}

double distance(const OkLab& p, const OkLab& q) { return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b); }

// Finds the parameter of a path from the share of its length.
class Pace {
 public:
  explicit Pace(ColourMap map) {
    OkLab before = path(map, 0.0);
    for (std::size_t i = 1; i < length_.size(); ++i) {
      const OkLab here = path(map, parameter(i));
      length_[i] = length_[i - 1] + distance(before, here);
      before = here;
    }
  }

  [[nodiscard]] double parameter_at(double share) const {
    const double wanted = share * length_.back();
    const auto above = std::clamp<std::ptrdiff_t>(std::ranges::lower_bound(length_, wanted) - length_.begin(), 1,
                                                  static_cast<std::ptrdiff_t>(length_.size()) - 1);
    const auto i = static_cast<std::size_t>(above);
    const double part = (wanted - length_[i - 1]) / (length_[i] - length_[i - 1]);
    return parameter(i - 1) + std::clamp(part, 0.0, 1.0) * (parameter(i) - parameter(i - 1));
  }

 private:
  static constexpr std::size_t steps = 2048;
  static double parameter(std::size_t i) { return static_cast<double>(i) / steps; }
  std::array<double, steps + 1> length_{};
};

raster::Rgb from_hue(double hue_turns, double saturation, double lightness) {
  const double s = std::clamp(saturation, 0.0, 1.0);
  const double l = std::clamp(lightness, 0.0, 1.0);
  const double reach = s * std::min(l, 1.0 - l);
  const auto part = [&](double offset) {
    const double sector = std::fmod(offset + 12.0 * (hue_turns - std::floor(hue_turns)), 12.0);
    return byte_of(255.0 * (l - reach * std::max(-1.0, std::min({sector - 3.0, 9.0 - sector, 1.0}))));
  };
  return {part(0.0), part(8.0), part(4.0)};
}

std::uint8_t classic_grey(double distance_of_236, const ClassicSliders& s) {
  const double n = 1.0 / (4.92e-5 * s.brightness * s.brightness + 0.2);
  const double m = 0.01271 * s.contrast * s.contrast + 50.0;
  return byte_of(m * std::pow(distance_of_236 / classic_levels, n) - 127.0 + s.saturation);
}

raster::Rgb classic_colour(ColourMap map, int level, const ClassicSliders& s) {
  const double share = static_cast<double>(level) / classic_levels;
  if (map == ColourMap::classic_rainbow)
    return from_hue((0.3 + 0.00274 * s.contrast) * share, s.saturation / 256.0, s.brightness / 256.0);
  if (map == ColourMap::classic_custom) return from_hue(s.brightness / 256.0, s.saturation / 256.0, share);
  if (map == ColourMap::classic_red_blue) {
    const int from_middle = level - classic_levels / 2;
    const std::uint8_t y = classic_grey(2.0 * std::abs(from_middle), s);
    return from_middle < 0 ? raster::Rgb{y, 0, 0} : raster::Rgb{0, 0, y};
  }
  const std::uint8_t y = classic_grey(level, s);
  return {y, y, y};
}

}  // namespace

std::span<const ColourMapInfo> colour_maps() { return maps; }

const ColourMapInfo& info_of(ColourMap map) { return *std::ranges::find(maps, map, &ColourMapInfo::map); }

std::vector<raster::Rgb> colour_table(ColourMap map, const ClassicSliders& sliders, bool inverted, std::size_t levels) {
  std::vector<raster::Rgb> table;
  if (info_of(map).classic) {
    for (int i = 0; i < classic_levels; ++i) table.push_back(classic_colour(map, i, sliders));
  } else {
    if (levels < 2) throw std::invalid_argument("a table of colours has at least 2 levels");
    const Pace pace(map);
    const auto last = static_cast<double>(map == ColourMap::cycle ? levels : levels - 1);
    for (std::size_t i = 0; i < levels; ++i)
      table.push_back(rgb_of(path(map, pace.parameter_at(static_cast<double>(i) / last))));
  }
  if (inverted) std::ranges::reverse(table);
  return table;
}

OkLab colour_at(ColourMap map, double position) {
  return path(map, Pace(map).parameter_at(std::clamp(position, 0.0, 1.0)));
}

OkLab oklab_of(raster::Rgb colour) {
  const double r = linear_of(colour.red / 255.0);
  const double g = linear_of(colour.green / 255.0);
  const double b = linear_of(colour.blue / 255.0);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

raster::Rgb rgb_of(const OkLab& colour) {
  const LinearRgb c = linear_of(colour);
  const auto byte = [](double linear) { return byte_of(255.0 * encoded_of(std::max(0.0, linear))); };
  return {byte(c.red), byte(c.green), byte(c.blue)};
}

bool is_displayable(const OkLab& colour) {
  constexpr double rounding = 1e-6;
  const LinearRgb c = linear_of(colour);
  const auto [least, most] = std::minmax({c.red, c.green, c.blue});
  return least >= -rounding && most <= 1.0 + rounding;
}

}  // namespace sarsim::picture
