#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radar/earth/earth_frame.hpp"
#include "radar/earth/transverse_mercator.hpp"
#include "raster/table/sink.hpp"
#include "signal/sar/sar_image.hpp"

namespace sarsim::workflow {

/// A ground grid on the map: positions are as good as `error_m`, because the map's grid bends against the plane's.
struct GridOnMap {
  radar::UtmPlace middle;      ///< Of the grid, exact.
  double line_east_m = 0.0;    ///< Step from line to line on the map, east and north.
  double line_north_m = 0.0;   ///< See `line_east_m`.
  double sample_east_m = 0.0;  ///< Step from sample to sample.
  double sample_north_m = 0.0;
  double error_m = 0.0;          ///< Largest distance on the map between these steps and the truth, over the grid.
  double lowest_height_m = 0.0;  ///< Of the plane over the ellipsoid, within the grid; it is lowest where they touch.
  double highest_height_m = 0.0;
};

/// The world's point of a pixel of a ground grid, counted from 0; m.
[[nodiscard]] core::Vec3 point_of_pixel(const signal::FocusedImage& grid, double line, double sample);

/// A ground grid on the map of the zone of its middle; errors and heights are those of nine points, its corners, the
/// middles of its edges and its own. Nothing beyond the ends of UTM.
[[nodiscard]] std::optional<GridOnMap> grid_on_map(const signal::FocusedImage& grid, const radar::EarthFrame& earth);

/// Fields of an ENVI header that lay a ground grid on the Earth (docs/formats/focused-images.md): `geo points` of the
/// middles of the four corner pixels, and within UTM what GridOnMap says. `map info`, which can turn a map but not
/// mirror it, only where that says the same to all readers: lines go clockwise from samples as seen from above, and
/// pixels are square or the grid is not turned, because GDAL takes the steps of turned ones for each other.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> map_fields(const signal::FocusedImage& grid,
                                                                          const radar::EarthFrame& earth);

/// What an HDF5 file of a ground grid says of its place on the Earth.
struct GridFacts {
  raster::Facts file;  ///< Bounds, as the Attribute Convention for Data Discovery (ACDD 1.3) names them.
  raster::Facts map;   ///< Its UTM map as CF and GDAL name it, see docs/formats/focused-images.md; empty beyond UTM.
};

/// The same as `map_fields`, for HDF5: the bounds of its corners and, within UTM, the map with the step from pixel to
/// pixel, which may turn and mirror.
[[nodiscard]] GridFacts grid_facts(const signal::FocusedImage& grid, const radar::EarthFrame& earth);

}  // namespace sarsim::workflow
