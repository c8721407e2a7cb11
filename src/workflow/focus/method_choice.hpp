#pragma once

#include "core/task/parallel.hpp"
#include "workflow/focus/focus_pipeline.hpp"

namespace sarsim::workflow {

/// Chooses back-projection if a request leaves the algorithm open and only it can focus: carriers that change, flights
/// that turn back or around, pulses that are too unevenly spaced; a note gives the reason. Chooses the columns of the
/// image if the request leaves them open: slant ranges, or positions on level ground for flights around the scene.
/// @param[in,out] request  its algorithm may still be open; its grid is not
/// @param[in,out] input    its problems receive the note
void choose_beforehand(FocusRequest& request, FocusInput& input);

/// Decides the rest: the algorithm and the order of motion compensation.
///
/// What a method leaves counts: omega-k on the line that fits the track, with and without motion compensation, with
/// what it loses of a band whose upper end the pulses alias (`worst_method_loss`); and back-projection on its grid. Of
/// the flight that is phase and amplitude of the worst target (`worst_motion_residual`). Omega-k is taken where it
/// leaves at most half of what an image may have; else the better of both that is affordable. Both numbers are added to
/// the input's problems as a note, and a warning where the image that is made is not right.
/// @param[in,out] request  its algorithm becomes the one that will be used
/// @param[in,out] work     its motion, at first that which the shape of the track asks for, becomes what is
/// compensated;
///                         its Doppler centroid is known, and the spectrum of an image by omega-k
/// @throw  core::InvalidRequest where the ground is out of the reach of motion compensation; Interrupted
void choose_method(FocusRequest& request, FocusPipeline& work, const core::WorkControl& control);

}  // namespace sarsim::workflow
