#pragma once

#include "signal/sar/back_projection_kernel.hpp"

namespace sarsim::signal {

/// Where the aperture counts angles from: a vector of length 1, or 0 for a pulse that rests.
[[nodiscard]] core::Vec3 heading_of(const ProjectionPulse& pulse, const ProjectionAperture& aperture);

/// k of tau = k (d - r.V/c): 2/c, and 1/(1 - V^2/c^2) of that where the antenna flies on while the echo is under way.
[[nodiscard]] double slowness_of(const ProjectionPulse& pulse, const ProjectionConstants& constants);

/// One point and one pulse in double precision, as `project` defines them.
/// @param[in,out] re, im  sum over pulses
/// @param[in,out] weight  sum of weights; left alone by Kind::all
void project_point(const ProjectionPulse& pulse, const ProjectionConstants& constants,
                   const ProjectionAperture& aperture, const core::Vec3& point_m, float& re, float& im, float& weight);

}  // namespace sarsim::signal
