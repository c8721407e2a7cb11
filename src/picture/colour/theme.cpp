#include "picture/colour/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sarsim::picture {

namespace {

struct Tones {
  Role role = Role::background;
  raster::Rgb light;
  raster::Rgb dark;
};

// Axes, curves and the marks of objects stay apart for people who do not tell red from green: reds lean to orange,
// greens to blue, and neighbours differ in lightness as well.
constexpr std::array<Tones, static_cast<std::size_t>(Role::count)> tones{{
    {Role::background, {255, 255, 255}, {21, 25, 30}}, {Role::text, {27, 31, 36}, {230, 234, 240}},
    {Role::faint, {170, 178, 189}, {83, 92, 104}},     {Role::x_axis, {184, 32, 15}, {255, 106, 85}},
    {Role::y_axis, {0, 128, 96}, {88, 224, 164}},      {Role::z_axis, {0, 80, 200}, {102, 168, 255}},
    {Role::target, {168, 32, 13}, {255, 138, 112}},    {Role::radar, {87, 96, 106}, {182, 192, 204}},
    {Role::beam, {122, 82, 0}, {230, 195, 92}},        {Role::platform, {106, 112, 121}, {169, 179, 191}},
    {Role::surface, {141, 152, 165}, {95, 107, 120}},  {Role::selected, {0, 104, 214}, {79, 180, 255}},
    {Role::hovered, {160, 31, 168}, {240, 160, 255}},  {Role::error, {179, 0, 27}, {255, 138, 138}},
    {Role::warning, {133, 86, 0}, {240, 192, 96}},     {Role::curve, {0, 96, 180}, {106, 180, 255}},
    {Role::curve_2, {179, 71, 0}, {255, 166, 87}},     {Role::curve_3, {0, 122, 90}, {95, 215, 176}},
    {Role::curve_4, {120, 0, 110}, {228, 72, 180}},    {Role::curve_5, {30, 32, 36}, {240, 240, 60}},
    {Role::solid, {118, 126, 138}, {196, 205, 216}},   {Role::sky, {222, 235, 248}, {10, 15, 26}},
    {Role::globe, {236, 241, 245}, {33, 39, 47}},      {Role::track, {52, 98, 175}, {110, 170, 230}},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < tones.size(); ++i)
    if (tones[i].role != static_cast<Role>(i)) return false;
  return true;
}
static_assert(in_order());

double linear(std::uint8_t channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// Relative luminance of WCAG 2.1.
double luminance(raster::Rgb colour) {
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

}  // namespace

raster::Rgb colour(Role role, bool dark) {
  const Tones& tone = tones[std::min(static_cast<std::size_t>(role), tones.size() - 1)];
  return dark ? tone.dark : tone.light;
}

raster::Rgb surface_fill(std::uint8_t shade, bool dark) {
  // Above the dark ground, below the light one.
  const int grey = dark ? 45 + shade / 2 : shade * 220 / 255;
  const auto channel = static_cast<std::uint8_t>(grey);
  return {channel, channel, channel};
}

raster::Rgb track_colour(double part, bool dark) {
  using Path = std::array<raster::Rgb, 3>;
  const Path path = dark ? Path{{{190, 130, 255}, {70, 160, 255}, {90, 235, 150}}}
                         : Path{{{110, 30, 160}, {20, 105, 210}, {0, 135, 85}}};
  const double at = 2.0 * std::clamp(part, 0.0, 1.0);
  const std::size_t first = at < 1.0 ? 0 : 1;
  const double t = at - static_cast<double>(first);
  const auto mix = [&](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
  };
  const raster::Rgb& a = path[first];
  const raster::Rgb& b = path[first + 1];
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

double contrast(raster::Rgb a, raster::Rgb b) {
  const double first = luminance(a) + 0.05;
  const double second = luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

}  // namespace sarsim::picture
