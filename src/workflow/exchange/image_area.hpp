#pragma once

#include "workflow/exchange/collection.hpp"

namespace sarsim::workflow {

/// The part of the ground that an image of a collection is meant to show: a plane through the reference point with axes
/// to east and north (over a flat world: those of the world), and in it the rectangle of all targets, with a margin;
/// of a scene without targets, that of the recorded times of arrival.
/// @param reference_m  of the middle pulse, world
/// @param middle       vector of that pulse, with its band and times of arrival
[[nodiscard]] raster::SceneCoordinates image_area_of(const Collection& collection, const core::Vec3& reference_m,
                                                     const raster::PhaseVector& middle);

}  // namespace sarsim::workflow
