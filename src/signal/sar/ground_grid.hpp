#pragma once

#include "signal/sar/sar_image.hpp"

namespace sarsim::signal {

/// The axes and the frame of an image of level ground that holds what an image of slant range holds: rows along the
/// horizontal part of the flight, columns across it, from below the antenna's line; as close together as there, so that
/// nothing is undersampled where the ground is seen flat. Without values.
///
/// What a line that climbs by the angle g sees across itself lies h tan g ahead of it, h its height. The centres of the
/// spectra are those of the slant image times the change of its coordinates along the axes of the ground, in the middle
/// of the swath.
/// @param slant    axes and frame, of slant range
/// @param scene_m  world; a point that says on which side of the line, and how high, the ground is
/// @throw  std::invalid_argument where the line is vertical, the scene lies on it, or all of it is farther above the
///         ground than all ranges of the image
[[nodiscard]] FocusedImage on_ground(const FocusedImage& slant, const core::Vec3& scene_m);

/// Where what an image of slant range shows at `place` appears on a ground grid: the point of the grid's plane with
/// that azimuth and that distance from the line. A target above the plane lies over towards the antenna.
[[nodiscard]] ImagePlace place_on_ground(const ImageFrame& grid, const ImageFrame& slant, const ImagePlace& place);

}  // namespace sarsim::signal
