#include "picture/scene/globe.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "picture/colour/theme.hpp"
#include "picture/figure/ticks.hpp"
#include "picture/scene/drawing_pen.hpp"

namespace sarsim::picture {

namespace {

constexpr int cell_deg = 2;
constexpr double depth_m = -2000.0;   // of the corners; the middle of a cell is 1.9 km deeper
constexpr double dimmest_part = 0.9;  // of the colour, opposite of the anchor
constexpr double curvature_px = 3.0;
constexpr double line_px = 100.0;  // between meridians, about
constexpr int lines_a_side = 12;   // at most, about what is looked at
constexpr int pieces = 8;          // of a line from one crossing to the next

radar::Geodetic place_deg(double latitude, double longitude, double height_m) {
  return {std::clamp(latitude, -90.0, 90.0) * core::rad_per_deg, longitude * core::rad_per_deg, height_m};
}

raster::Rgb dimmed(raster::Rgb colour, double part) {
  const auto channel = [&](std::uint8_t value) { return static_cast<std::uint8_t>(std::lround(part * value)); };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

// Degrees between lines that are about so far apart at the scale of the focus.
double step_deg(const Camera& camera, double pixel_scale) {
  const double wanted = line_px * pixel_scale / (camera.pixels_per_m * radar::wgs84_semi_major_m) * core::deg_per_rad;
  for (const double step : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0})
    if (step >= wanted) return step;
  return 30.0;
}

std::string degrees_text(double value_deg, const char* positive, const char* negative) {
  const double size = core::tidy(std::abs(value_deg), 8);
  return core::format_number(size) + "°" + (size == 0.0 || size == 180.0 ? "" : value_deg > 0.0 ? positive : negative);
}

// Meridians and parallels about a crossing of them, in steps.
struct Graticule {
  double step_deg = 1.0;
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  int south = 0;  // steps from the crossing
  int north = 0;
  int sides = 0;
};

Graticule graticule_about(const radar::EarthFrame& earth, const Camera& camera, double pixel_scale) {
  Graticule grid;
  grid.step_deg = step_deg(camera, pixel_scale);
  const radar::Geodetic at = earth.geodetic_of(camera.focus_world_m);
  const auto nearest = [&](double angle_rad) {
    return std::round(angle_rad * core::deg_per_rad / grid.step_deg) * grid.step_deg;
  };
  grid.latitude_deg = std::isfinite(at.latitude_rad) ? nearest(at.latitude_rad) : 0.0;
  grid.longitude_deg = std::isfinite(at.longitude_rad) ? nearest(at.longitude_rad) : 0.0;
  grid.south = std::min(lines_a_side, static_cast<int>((90.0 + grid.latitude_deg) / grid.step_deg));
  grid.north = std::min(lines_a_side, static_cast<int>((90.0 - grid.latitude_deg) / grid.step_deg));
  grid.sides = std::min(lines_a_side, static_cast<int>(180.0 / grid.step_deg));
  return grid;
}

void draw_line(Pen& pen, const radar::EarthFrame& earth, const radar::Geodetic& from, const radar::Geodetic& to,
               int parts) {
  core::Vec3 before = earth.world_of(from);
  for (int i = 1; i <= parts; ++i) {
    const double t = static_cast<double>(i) / parts;
    const core::Vec3 after = earth.world_of({from.latitude_rad + t * (to.latitude_rad - from.latitude_rad),
                                             from.longitude_rad + t * (to.longitude_rad - from.longitude_rad), 0.0});
    pen.world_line(before, after, Role::faint, 1.0);
    before = after;
  }
}

void put_degrees(Pen& pen, const radar::EarthFrame& earth, double latitude, double longitude, const std::string& words,
                 bool beside) {
  const auto at = pen.project(earth.world_of(place_deg(latitude, longitude, 0.0)));
  if (!at || pen.hides(*at)) return;
  pen.text(at->x + (beside ? pen.px(4.0) : 0.0), at->y - pen.px(4.0), words, Role::text, false, !beside,
           Drawing::Hold::spare);
}

}  // namespace

Mesh globe_mesh(const radar::EarthFrame& earth, bool dark) {
  constexpr int rows = 180 / cell_deg;
  constexpr int columns = 360 / cell_deg;
  const raster::Rgb colour = picture::colour(Role::globe, dark);
  Mesh mesh;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column < columns; ++column)
      mesh.points_world_m.push_back(
          earth.world_of(place_deg(row * cell_deg - 90.0, column * cell_deg - 180.0, depth_m)));
  const core::Vec3 centre = earth.world_from_ecef({});
  const auto add = [&](int a, int b, int c) {
    const auto point = [](int i) { return static_cast<std::uint32_t>(i); };
    mesh.triangles.push_back({point(a), point(b), point(c)});
    const core::Vec3 from_centre = mesh.points_world_m[point(a)] - centre;
    const double towards = from_centre.z / core::norm(from_centre);  // 1 at the anchor, -1 opposite
    mesh.colours.push_back(dimmed(colour, dimmest_part + (1.0 - dimmest_part) * 0.5 * (1.0 + towards)));
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int a = row * columns + column;
      const int b = row * columns + (column + 1) % columns;
      if (row > 0) add(a, b, b + columns);
      if (row + 1 < rows) add(a, b + columns, a + columns);
    }
  return mesh;
}

bool shows_curvature(const Camera& camera) {
  const double half_m = 0.5 * std::hypot(camera.width_px, camera.height_px) / camera.pixels_per_m;
  const double reach_m = half_m + std::hypot(camera.focus_world_m.x, camera.focus_world_m.y);
  return camera.pixels_per_m * reach_m * reach_m / (2.0 * radar::wgs84_semi_major_m) > curvature_px;
}

void draw_graticule(Pen& pen, const radar::EarthFrame& earth) {
  const Graticule grid = graticule_about(earth, pen.camera(), pen.options().pixel_scale);
  const double first = grid.latitude_deg - grid.south * grid.step_deg;
  const double last = grid.latitude_deg + grid.north * grid.step_deg;
  const double west = grid.longitude_deg - grid.sides * grid.step_deg;
  const double east = grid.longitude_deg + grid.sides * grid.step_deg;
  const bool words = pen.options().labels && !pen.options().coarse;
  for (int i = -grid.sides; i <= grid.sides; ++i) {
    const double longitude = grid.longitude_deg + i * grid.step_deg;
    if (i == grid.sides && 2.0 * grid.sides * grid.step_deg >= 360.0) break;
    draw_line(pen, earth, place_deg(first, longitude, 0.0), place_deg(last, longitude, 0.0),
              pieces * std::max(1, grid.south + grid.north));
    const double shown = std::remainder(longitude, 360.0);
    if (words && i != 0) put_degrees(pen, earth, grid.latitude_deg, longitude, degrees_text(shown, " E", " W"), false);
  }
  for (int i = -grid.south; i <= grid.north; ++i) {
    const double latitude = grid.latitude_deg + i * grid.step_deg;
    draw_line(pen, earth, place_deg(latitude, west, 0.0), place_deg(latitude, east, 0.0),
              pieces * std::max(1, 2 * grid.sides));
    if (words) put_degrees(pen, earth, latitude, grid.longitude_deg, degrees_text(latitude, " N", " S"), true);
  }
}

}  // namespace sarsim::picture
