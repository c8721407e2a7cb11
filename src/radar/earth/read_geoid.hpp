#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "core/report/problem.hpp"
#include "radar/earth/geoid_grid.hpp"

namespace sarsim::radar {

/// The formats of grids of the geoid.
enum class GeoidFormat : std::uint8_t {
  unknown,
  pgm,    ///< GeographicLib's picture: "egm2008-5.pgm".
  gtx,    ///< Of NOAA's VDatum, also used by PROJ: "egm96_15.gtx".
  ascii,  ///< ESRI's text.
};

/// The format of some bytes. GTX has no mark: it is what has the length that its header says, within a few bytes of a
/// value.
[[nodiscard]] GeoidFormat geoid_format_of(std::string_view bytes);

/// Reads a grid of one of the three formats. Any bytes may be given; nothing is thrown but std::bad_alloc, and not more
/// than twice the memory of the bytes is taken, whatever counts they hold. Refuses what is broken: cut off, too long,
/// counts that the bytes do not hold, numbers that are not finite, and what `GeoidGrid::from` refuses.
/// @param name  of the file, for messages
[[nodiscard]] std::variant<GeoidGrid, core::Problem> read_geoid(std::string_view bytes, const std::string& name);

/// Reads GeographicLib's format: a portable gray map P5 with 65535 levels of 2 bytes, the higher first, whose comments
/// "# Offset" and "# Scale" turn levels to m. It covers the Earth: rows from 90 deg to the south, an odd number,
/// columns from 0 deg to the east, an even number (GeographicLib, "The format of the geoid files").
[[nodiscard]] std::variant<GeoidGrid, core::Problem> read_geoid_pgm(std::string_view bytes, const std::string& name);

/// Reads NOAA's format: the southern latitude, the western longitude, the steps of both as doubles, in degrees, the
/// numbers of rows and columns as 32-bit integers, then floats, rows from the south; all with the highest byte first.
/// -88.8888 is a node without a value (NOAA VDatum, "GTX format").
[[nodiscard]] std::variant<GeoidGrid, core::Problem> read_geoid_gtx(std::string_view bytes, const std::string& name);

/// Reads ESRI's ASCII grid in degrees: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize and,
/// where it likes, NODATA_value (otherwise -9999), then the values, rows from the north. Kept with the 24 bits of a
/// float: 4e-6 m.
[[nodiscard]] std::variant<GeoidGrid, core::Problem> read_geoid_ascii(std::string_view bytes, const std::string& name);

}  // namespace sarsim::radar
