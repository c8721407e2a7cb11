#include "workflow/image/map_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/maths/constants.hpp"

namespace sarsim::workflow {

namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;

// Pixels count from 0, and their middles are whole numbers.
struct Pixel {
  double line = 0.0;
  double sample = 0.0;
};

Pixel middle_of(const signal::FocusedImage& grid) {
  return {0.5 * (static_cast<double>(grid.azimuth.count) - 1.0), 0.5 * (static_cast<double>(grid.range.count) - 1.0)};
}

radar::Geodetic place_of(const signal::FocusedImage& grid, const radar::EarthFrame& earth, const Pixel& pixel) {
  return earth.geodetic_of(point_of_pixel(grid, pixel.line, pixel.sample));
}

// Corners, middles of edges and the middle.
std::array<Pixel, 9> looked_at(const signal::FocusedImage& grid) {
  const Pixel middle = middle_of(grid);
  std::array<Pixel, 9> pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = {middle.line * static_cast<double>(i / 3), middle.sample * static_cast<double>(i % 3)};
  return pixels;
}

// Steps on the map as differences over the whole grid; of a single line or sample, over one step.
void set_steps(const signal::FocusedImage& grid, const radar::EarthFrame& earth, GridOnMap& map) {
  const Pixel middle = middle_of(grid);
  const auto difference = [&](const Pixel& half, double steps, double& east_m, double& north_m) {
    const auto at = [&](double sign) {
      const Pixel pixel{middle.line + sign * half.line, middle.sample + sign * half.sample};
      return radar::utm_of(place_of(grid, earth, pixel), map.middle.zone, map.middle.north);
    };
    const radar::UtmPlace last = at(1.0);
    const radar::UtmPlace first = at(-1.0);
    east_m = (last.easting_m - first.easting_m) / steps;
    north_m = (last.northing_m - first.northing_m) / steps;
  };
  const double half_lines = std::max(middle.line, 0.5);
  const double half_samples = std::max(middle.sample, 0.5);
  difference({half_lines, 0.0}, 2.0 * half_lines, map.line_east_m, map.line_north_m);
  difference({0.0, half_samples}, 2.0 * half_samples, map.sample_east_m, map.sample_north_m);
}

void set_errors(const signal::FocusedImage& grid, const radar::EarthFrame& earth, GridOnMap& map) {
  const Pixel middle = middle_of(grid);
  map.lowest_height_m = std::numeric_limits<double>::infinity();
  map.highest_height_m = -std::numeric_limits<double>::infinity();
  for (const Pixel& pixel : looked_at(grid)) {
    const radar::Geodetic place = place_of(grid, earth, pixel);
    const radar::UtmPlace utm = radar::utm_of(place, map.middle.zone, map.middle.north);
    const double lines = pixel.line - middle.line;
    const double samples = pixel.sample - middle.sample;
    const double east_m = map.middle.easting_m + lines * map.line_east_m + samples * map.sample_east_m;
    const double north_m = map.middle.northing_m + lines * map.line_north_m + samples * map.sample_north_m;
    map.error_m = std::max(map.error_m, std::hypot(utm.easting_m - east_m, utm.northing_m - north_m));
    map.lowest_height_m = std::min(map.lowest_height_m, place.height_m);
    map.highest_height_m = std::max(map.highest_height_m, place.height_m);
  }
}

// ENVI counts pixels from 1 at the outer corner of the first.
std::string geo_points(const signal::FocusedImage& grid, const radar::EarthFrame& earth) {
  std::string text;
  const Pixel last{static_cast<double>(grid.azimuth.count) - 1.0, static_cast<double>(grid.range.count) - 1.0};
  for (const Pixel& pixel : {Pixel{0.0, 0.0}, Pixel{0.0, last.sample}, Pixel{last.line, 0.0}, last}) {
    const radar::Geodetic place = place_of(grid, earth, pixel);
    text +=
        fmt::format("{}{:.1f}, {:.1f}, {:.11f}, {:.11f}", text.empty() ? "" : ", ", pixel.sample + 1.5,
                    pixel.line + 1.5, core::deg_per_rad * place.latitude_rad, core::deg_per_rad * place.longitude_rad);
  }
  return text;
}

// Empty where it cannot be said.
std::string map_info(const signal::FocusedImage& grid, const GridOnMap& map) {
  const double line_m = std::hypot(map.line_east_m, map.line_north_m);
  const double sample_m = std::hypot(map.sample_east_m, map.sample_north_m);
  const double turn = map.line_east_m * map.sample_north_m - map.line_north_m * map.sample_east_m;
  const double rotation_deg = core::deg_per_rad * std::atan2(map.sample_north_m, map.sample_east_m);
  constexpr double square = 1e-6;
  const bool straight = std::abs(std::sin(core::rad_per_deg * rotation_deg)) < 1e-9;
  if (turn < 0.0 || (!straight && std::abs(line_m - sample_m) > square * sample_m)) return {};
  const Pixel middle = middle_of(grid);
  const double lines = -0.5 - middle.line;
  const double samples = -0.5 - middle.sample;
  return fmt::format("UTM, 1, 1, {:.4f}, {:.4f}, {:.9f}, {:.9f}, {}, {}, WGS-84, units=Meters, rotation={:.9f}",
                     map.middle.easting_m + lines * map.line_east_m + samples * map.sample_east_m,
                     map.middle.northing_m + lines * map.line_north_m + samples * map.sample_north_m, sample_m, line_m,
                     map.middle.zone, map.middle.north ? "North" : "South", rotation_deg);
}

// Corners in the order in which one walks around.
std::string bounds_text(const signal::FocusedImage& grid, const radar::EarthFrame& earth) {
  const Pixel last{static_cast<double>(grid.azimuth.count) - 1.0, static_cast<double>(grid.range.count) - 1.0};
  std::string text;
  for (const Pixel& pixel : {Pixel{0.0, 0.0}, Pixel{0.0, last.sample}, last, Pixel{last.line, 0.0}, Pixel{0.0, 0.0}}) {
    const radar::Geodetic place = place_of(grid, earth, pixel);
    text += fmt::format("{}{:.9f} {:.9f}", text.empty() ? "" : ", ", core::deg_per_rad * place.latitude_rad,
                        core::deg_per_rad * place.longitude_rad);
  }
  return "POLYGON ((" + text + "))";
}

double turned_deg(double longitude_deg) { return std::remainder(longitude_deg, 360.0); }

// Over the points that `looked_at` names. West of 180 deg and east of it the first longitude is the larger one.
raster::Facts bounds_of(const signal::FocusedImage& grid, const radar::EarthFrame& earth) {
  const double middle_deg = core::deg_per_rad * place_of(grid, earth, middle_of(grid)).longitude_rad;
  std::array<double, 3> least;
  std::array<double, 3> most;
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(-std::numeric_limits<double>::infinity());
  for (const Pixel& pixel : looked_at(grid)) {
    const radar::Geodetic place = place_of(grid, earth, pixel);
    const std::array<double, 3> numbers{core::deg_per_rad * place.latitude_rad,
                                        turned_deg(core::deg_per_rad * place.longitude_rad - middle_deg),
                                        place.height_m};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      least[i] = std::min(least[i], numbers[i]);
      most[i] = std::max(most[i], numbers[i]);
    }
  }
  return {{"geospatial_bounds", bounds_text(grid, earth)},
          {"geospatial_bounds_crs", "EPSG:4326"},
          {"geospatial_lat_min", least[0]},
          {"geospatial_lat_max", most[0]},
          {"geospatial_lon_min", turned_deg(middle_deg + least[1])},
          {"geospatial_lon_max", turned_deg(middle_deg + most[1])},
          {"geospatial_vertical_min", least[2]},
          {"geospatial_vertical_max", most[2]}};
}

// From the outer corner of the first pixel: easting, its steps from sample to sample and from line to line; northing.
std::string geo_transform(const signal::FocusedImage& grid, const GridOnMap& map) {
  const Pixel middle = middle_of(grid);
  const double lines = -0.5 - middle.line;
  const double samples = -0.5 - middle.sample;
  return fmt::format("{:.4f} {:.12g} {:.12g} {:.4f} {:.12g} {:.12g}",
                     map.middle.easting_m + lines * map.line_east_m + samples * map.sample_east_m, map.sample_east_m,
                     map.line_east_m, map.middle.northing_m + lines * map.line_north_m + samples * map.sample_north_m,
                     map.sample_north_m, map.line_north_m);
}

raster::Facts utm_facts(const signal::FocusedImage& grid, const GridOnMap& map) {
  constexpr int northern_zones = 32600;  // EPSG codes of WGS 84 / UTM; the southern ones are 100 more.
  const int code = northern_zones + (map.middle.north ? 0 : 100) + map.middle.zone;
  return {{"grid_mapping_name", "transverse_mercator"},
          {"longitude_of_central_meridian", 6.0 * map.middle.zone - 183.0},
          {"latitude_of_projection_origin", 0.0},
          {"scale_factor_at_central_meridian", 0.9996},
          {"false_easting", 500e3},
          {"false_northing", map.middle.north ? 0.0 : 10'000e3},
          {"semi_major_axis", radar::wgs84_semi_major_m},
          {"inverse_flattening", 1.0 / radar::wgs84_flattening},
          {"spatial_ref", fmt::format("EPSG:{}", code)},
          {"GeoTransform", geo_transform(grid, map)},
          {"largest_error_m", map.error_m}};
}

}  // namespace

core::Vec3 point_of_pixel(const signal::FocusedImage& grid, double line, double sample) {
  return grid.frame.origin_m + grid.azimuth.at(line) * grid.frame.along + grid.range.at(sample) * grid.frame.across;
}

std::optional<GridOnMap> grid_on_map(const signal::FocusedImage& grid, const radar::EarthFrame& earth) {
  const radar::Geodetic middle = place_of(grid, earth, middle_of(grid));
  const auto zone = radar::utm_zone(middle);
  if (!zone) return std::nullopt;
  GridOnMap map;
  map.middle = radar::utm_of(middle, *zone, middle.latitude_rad >= 0.0);
  set_steps(grid, earth, map);
  set_errors(grid, earth, map);
  return map;
}

Fields map_fields(const signal::FocusedImage& grid, const radar::EarthFrame& earth) {
  Fields fields;
  if (const auto map = grid_on_map(grid, earth)) {
    const std::string info = map_info(grid, *map);
    if (!info.empty()) fields.emplace_back("map info", info);
    fields.emplace_back("utm zone", fmt::format("{} {}", map->middle.zone, map->middle.north ? "North" : "South"));
    fields.emplace_back("utm middle m", fmt::format("{:.4f}, {:.4f}", map->middle.easting_m, map->middle.northing_m));
    fields.emplace_back("utm line step m", fmt::format("{}, {}", map->line_east_m, map->line_north_m));
    fields.emplace_back("utm sample step m", fmt::format("{}, {}", map->sample_east_m, map->sample_north_m));
    fields.emplace_back("utm error m", fmt::format("{:.3g}", map->error_m));
    fields.emplace_back("height m", fmt::format("{:.3f}, {:.3f}", map->lowest_height_m, map->highest_height_m));
  }
  fields.emplace_back("geo points", geo_points(grid, earth));
  return fields;
}

GridFacts grid_facts(const signal::FocusedImage& grid, const radar::EarthFrame& earth) {
  GridFacts facts{bounds_of(grid, earth), {}};
  if (const auto map = grid_on_map(grid, earth)) facts.map = utm_facts(grid, *map);
  return facts;
}

}  // namespace sarsim::workflow
