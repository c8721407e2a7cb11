#pragma once

#include <optional>

#include "signal/sar/focusing.hpp"
#include "workflow/focus/focus_input.hpp"

namespace sarsim::workflow {

/// Whether a flight goes along the line that fits it, by which images of slant range are counted: not a circle, nor a
/// turn by more than about 50 degrees (`signal::straightness`).
[[nodiscard]] bool flies_along_a_line(const signal::EchoRows& echoes);

/// Axes and frame of an image of level ground around what the beam lit, whatever the flight: the targets whose echoes
/// are within 40 dB of the strongest and recorded, and a tenth of their extent, or 48 samples, more on each side;
/// without targets, the middle of the scene and as much as the recorded ranges are long. Azimuth is along the
/// horizontal part of the line that fits the track, both coordinates count from the middle of the scene. The samples
/// are as close as the directions that were flown require, a tenth closer than the width of their spectrum.
/// @param ground_m  height of the ground, world; nothing: that of the middle of the scene
/// @throw  Interrupted
[[nodiscard]] signal::FocusedImage scene_grid_axes(const FocusInput& input, std::optional<double> ground_m,
                                                   const core::WorkControl& control);

}  // namespace sarsim::workflow
