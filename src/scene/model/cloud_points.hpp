#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/maths/vector.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/echo/view_geometry.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The points of a cloud, as kernels take them: 32 bytes each. Shared by all that look at the cloud.
struct CloudPoints {
  /// Positions in the platform's frame and roots of the cross-sections; nothing else is filled.
  radar::PointArrays arrays;
  bool own_rcs = false;   ///< The table has cross-sections; else all points have `rcs_m2`.
  double rcs_m2 = 1.0;    ///< Of the cloud when the table was read.
  core::Vec3 min_m;       ///< Corner of the box around all points ...
  core::Vec3 max_m;       ///< ... and the opposite one.
  std::string file;       ///< Name by which the cloud meant the table.
  std::uint64_t sum = 0;  ///< XXH64 of the file's bytes.
  std::optional<radar::Anchor>
      anchor;  ///< Of the world that latitudes of the table were laid in; nothing: no latitudes.
};

/// Number of the points of a cloud; 0 where they are not read.
[[nodiscard]] inline std::size_t point_count(const Cloud& cloud) {
  return !cloud.points ? 0 : cloud.points->arrays.size();
}

}  // namespace sarsim::scene
