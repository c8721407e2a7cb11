#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "raster/table/image_places.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::workflow {

/// Where rows or columns are, under the name that files and bindings have for it.
struct NamedAxis {
  std::string name;  ///< "pulse_time_s"; ends in its unit.
  std::string unit;  ///< "s".
  bool of_columns = false;
  std::vector<double> values;
};

/// The axes of an image with a header: "azimuth_m", "slant_range_m", "doppler_frequency_hz". Rows and columns that have
/// numbers alone have none.
[[nodiscard]] std::vector<NamedAxis> named_axes(const raster::FocusedPlaces& places, std::size_t rows,
                                                std::size_t columns);

/// The axes of a recording, or an image as a file of samples has it: those that it has at all. Places, velocities and
/// rotations of the radar's platform are three axes each: "position_x_m".
[[nodiscard]] std::vector<NamedAxis> named_axes(const raster::RasterAxes& axes);

/// The same backwards; what is not there is not a number. Throws core::InvalidRequest for a name that no such axis has,
/// and for another number of values than rows or columns.
[[nodiscard]] raster::RasterAxes axes_of(const std::vector<NamedAxis>& named, std::size_t rows, std::size_t columns);

}  // namespace sarsim::workflow
