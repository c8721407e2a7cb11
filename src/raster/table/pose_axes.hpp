#pragma once

#include <array>
#include <string_view>

#include "raster/table/axis_labels.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// A dataset of three numbers for each row, part of where the radar's platform is.
struct PoseAxis {
  const char* name;       ///< In the root of the file.
  const char* units;      ///< As udunits writes them.
  const char* long_name;  ///< For people.
  const char* meaning;    ///< Its attribute `meaning`.
  std::array<double, 3> RowPose::*part;
};

/// All of them: a file has them together or not at all.
inline constexpr std::array<PoseAxis, 3> pose_axes{
    {{"platform_position_m", "m", "position of the radar's platform",
      "x, y, z of the radar's platform in world axes when the middle of the pulse leaves, m", &RowPose::position_m},
     {"platform_velocity_mps", "m s-1", "velocity of the radar's platform", "its velocity in world axes, m/s",
      &RowPose::velocity_mps},
     {"platform_rotation_rad", "rad", "rotation of the radar's platform",
      "its rotation about x, y and z, rad: world = Rz(-rz) Ry(-ry) Rx(-rx) platform", &RowPose::rotation_rad}}};

/// What an axis of that name is measured in, as `axis_words` and `pose_axes` have it; empty for another name.
[[nodiscard]] constexpr std::string_view units_of_axis(std::string_view name) {
  if (const AxisLabels* const words = words_of_axis(name)) return words->units;
  for (const PoseAxis& axis : pose_axes)
    if (name == axis.name) return axis.units;
  return {};
}

}  // namespace sarsim::raster
