#pragma once

#include "core/task/parallel.hpp"
#include "workflow/focus/focus.hpp"

namespace sarsim::workflow {

/// Chooses back-projection if a request leaves the algorithm open and only it can focus: carriers that change, flights
/// that turn back or around, pulses that are too unevenly spaced; a note gives the reason. Chooses the columns of the
/// image if the request leaves them open: slant ranges, or positions on level ground for flights around the scene.
/// @param[in,out] request  its algorithm may still be open; its grid is not
/// @param[in,out] input    its problems receive the note
void choose_beforehand(FocusRequest& request, FocusInput& input);

/// Decides the rest: the algorithm and the order of motion compensation.
///
/// Compares the residual errors of omega-k on the line that fits the track, with and without motion compensation, and
/// of back-projection on its grid, as phase, amplitude and displacement of the worst target (`worst_motion_residual`).
/// Omega-k is chosen if its image is within the tolerance (`excess_of`), otherwise the better affordable method. Both
/// errors are added to the input's problems as a note, and a warning if the image is outside the tolerance.
/// @param[in,out] request  its algorithm becomes the one that will be used
/// @param[in,out] work     its motion, first that which the shape of the track requires, becomes the order used; its
///                         Doppler centroid is known
/// @throw  core::Refused where the ground is out of the reach of motion compensation; Interrupted
void choose_method(FocusRequest& request, FocusWork& work, const core::WorkControl& control);

}  // namespace sarsim::workflow
