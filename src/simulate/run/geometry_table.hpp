#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "core/task/stop.hpp"
#include "scene/model/scene.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// Column bits of a geometry table (docs/formats/geometry-table.md).
enum GeometryColumn : int {
  geometry_time = 1,
  geometry_frequency = 2,
  geometry_position = 4,
  geometry_velocity = 8,
  geometry_rotation = 16,
  geometry_delay = 32,
  geometry_amplitude = 64,
  geometry_speed = 128,
};

/// Writes the table of a `$GEOMETRY` command: four header lines, then a line per pulse, in the columns and widths of
/// docs/formats/geometry-table.md. Every target has its columns in every line; where its range c tau/2 lies outside the
/// window they hold "nan". Radial speeds are signed (positive receding), the frequency of a line is that of its pulse.
/// @param write  takes the text piece by piece
/// @throws Interrupted when stopped
void write_geometry_text(const scene::Scene& scene, const scene::GeometryTable& table,
                         const std::function<void(std::string_view)>& write, const core::StopFlag* stop = nullptr);

/// The same pulses as comma-separated values with one header line with units: pulse, time_s, carrier_hz; for each
/// platform x_m, y_m, z_m, vx_mps ..., rx_deg ...; for each target distance_m, delay_s, radial_speed_mps, amplitude_v
/// (thesis 4.10). All targets, whatever the window; all columns, whatever the mask. Numbers are exact (shortest form).
/// Where the world has an epoch, `utc` of the send time stands behind time_s, to 1e-12 s. Over the Earth latitude_deg,
/// longitude_deg and height_m of each platform stand behind its z_m: over the ellipsoid of WGS 84. Through an
/// ionosphere phase_delay_s of each target stands behind its delay_s: the delay that the carrier's phase is that of,
/// where the other one is that of the pulse.
void write_geometry_csv(const scene::Scene& scene, const scene::GeometryTable& table,
                        const std::function<void(std::string_view)>& write, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::simulate
