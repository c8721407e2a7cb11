#pragma once

#include <cstddef>

#include "core/maths/constants.hpp"
#include "raster/sicd/sicd.hpp"

namespace sarsim::raster {

/// An image of slant ranges from a flight to the north past 34 S, 18 E, for tests of files: of its geometry only what
/// has to be there.
[[nodiscard]] inline Sicd sicd_test_value(std::size_t rows, std::size_t columns) {
  Sicd image;
  image.collector = "Radar1";
  image.name = "image";
  image.application = "sarsim";
  image.rows = rows;
  image.columns = columns;
  image.reference_row = rows / 2;
  image.reference_column = columns / 2;
  const radar::Geodetic middle{-34.0 * core::rad_per_deg, 18.0 * core::rad_per_deg, 100.0};
  image.reference_ecf_m = radar::ecef_of(middle);
  constexpr double half = 0.01 * core::rad_per_deg;
  for (std::size_t i = 0; i < 4; ++i)
    image.corners[i] = {middle.latitude_rad + (i == 1 || i == 2 ? half : -half),
                        middle.longitude_rad + (i < 2 ? -half : half), middle.height_m};
  image.time_s = {{1.0}};
  for (SicdDirection* direction : {&image.row, &image.column}) {
    direction->step_m = 0.5;
    direction->bandwidth_per_m = 1.5;
    direction->offset_per_m = {{0.25}};
  }
  image.row.centre_per_m = 64.0;
  image.start = "2024-04-01T22:59:42.5Z";
  image.duration_s = 2.0;
  image.pulses = 1000;
  image.position_ecf_m = {Polynomial{5e6, 1.0}, Polynomial{2e6, 2.0}, Polynomial{-3.5e6, 100.0}};
  image.lowest_hz = 9.55e9;
  image.highest_hz = 9.65e9;
  image.processing = "omega-k";
  image.approach = SicdClosestApproach{"OMEGA_K", {1.0, 0.01}, 3000.0, 9.6e9, {{1.0}}, {}};
  return image;
}

}  // namespace sarsim::raster
