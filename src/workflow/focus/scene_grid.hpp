#pragma once

#include <optional>

#include "signal/sar/focusing.hpp"
#include "workflow/focus/focus_input.hpp"

namespace sarsim::workflow {

/// Whether a flight follows the line that fits it, to which images in slant range refer: not a circle, nor a turn by
/// more than about 50 degrees (`signal::straightness`).
[[nodiscard]] bool flies_along_a_line(const signal::EchoRows& echoes);

/// Axes and frame of an image of level ground around the illuminated targets, for any flight: those whose echoes are
/// recorded and within 40 dB of the strongest, with a margin of a tenth of their extent, or 48 samples, on each side;
/// without targets, a square around the middle of the scene as wide as the range window. Azimuth is along the
/// horizontal part of the line that fits the track, both coordinates count from the middle of the scene. The samples
/// are as close as the directions that were flown require, a tenth closer than the width of their spectrum.
/// @param ground_m  height of the ground, world; nothing: that of the middle of the scene
/// @throw  Interrupted
[[nodiscard]] signal::FocusedImage scene_grid_axes(const FocusInput& input, std::optional<double> ground_m,
                                                   const core::WorkControl& control);

}  // namespace sarsim::workflow
