#pragma once

#include <cstddef>
#include <optional>

#include "core/report/problem.hpp"
#include "signal/sar/motion_compensation.hpp"
#include "simulate/plan/plan.hpp"
#include "workflow/focus/motion.hpp"

namespace sarsim::workflow {

/// What motion compensation leaves in the echoes of a target.
struct MotionResidual {
  std::size_t target = 0;  ///< Position in the scene's list, from 0.
  double rms_rad = 0.0;    ///< Of the phase that is left, over its echoes by their amplitudes.
  double amplitude = 1.0;  ///< Of its peak, relative to the ideal one.
  double phase_rad = 0.0;  ///< Error of its peak's phase.
  double azimuth_m = 0.0;  ///< Displacement of its peak.
};

/// Phases above it make back-projection the better choice, rad.
inline constexpr double most_residual_rad = 0.1;

/// The target with the largest phase left, of up to 512, over some pulses; nothing where there are no echoes. Each
/// pulse is moved from P to Q on the line by what a point X of level ground at the target's distance, under the squint
/// angle, needs:
///
///     4 pi/lambda (|P - x| - |Q - x| - |P - X| + |Q - X|)
///
/// remains of a target at x. To the first order, X is at the distance of the middle of the scene.
/// @param echoes  their track as it was flown, and waveform; no rows are read
/// @param how     what they are compensated to (`compensation_of`)
/// @throw  Interrupted
[[nodiscard]] std::optional<MotionResidual> worst_motion_residual(const simulate::Plan& plan,
                                                                  const signal::EchoRows& echoes,
                                                                  const signal::MotionCompensation& how,
                                                                  const core::WorkControl& control = {});

/// A warning where more than `most_residual_rad` are left, with what it does to the target.
[[nodiscard]] core::Problems remarks_on_residual(const std::optional<MotionResidual>& residual);

}  // namespace sarsim::workflow
