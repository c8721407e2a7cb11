#pragma once

#include <set>
#include <vector>

#include "picture/scene/drawing.hpp"

namespace sarsim::picture {

/// The camera moved and zoomed, its direction kept, so that all of a snapshot is in the picture with the marks that
/// keep their size on the screen: axes with their letters, names, discs.
[[nodiscard]] Camera showing_all(const Camera& camera, const Snapshot& snapshot, const DrawingOptions& options);

/// The camera moved and zoomed so that some objects fill the picture. A single point is shown with what is half as far
/// away as the nearest other point of the snapshot; where there is no other, or there are no objects, the scale is
/// kept.
/// @param objects  of the snapshot; others are passed over
[[nodiscard]] Camera showing(const Camera& camera, const Snapshot& snapshot, const std::set<scene::ObjectId>& objects,
                             double pixel_scale);

/// The points of `points_of` that belong to some of the objects.
[[nodiscard]] std::vector<core::Vec3> points_of(const Snapshot& snapshot, const std::set<scene::ObjectId>& objects);

/// True where points are all in the picture, and not all within a tenth of its width and height.
[[nodiscard]] bool shows_well(const Camera& camera, const std::vector<core::Vec3>& points_world_m);

}  // namespace sarsim::picture
