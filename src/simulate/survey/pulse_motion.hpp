#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/task/parallel.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::simulate {

/// Phases left from which on a survey has a note, and a warning, rad.
inline constexpr double noted_motion_rad = 0.01;
inline constexpr double warned_motion_rad = 0.1;

/// What echoes leave out of the motion within a pulse, at most, and where.
struct PulseMotion {
  double phase_rad = 0.0;  ///< At the ends of the pulse.
  std::size_t target = 0;  ///< Position in the scene's list, from 0.
  std::int64_t pulse = 0;  ///< In the radar's schedule.
};

/// The third order of the motion within a pulse, which echoes leave out (docs/theory/echo-model.md, "What is left"):
///
///     pi f tau''' Tp^3/24,   tau''' = (2/c) (d''(t + Tp/2) - d''(t - Tp/2))/Tp
///
/// with d the distance between antenna and target, whose second derivative is that of positions, velocities and
/// accelerations. The largest over up to 1025 pulses (fewer for more than 400 targets, 65 at least), an even choice
/// with the first and the last, and over 16 more between the neighbours of the worst one. Where speeds and
/// accelerations of the platforms allow less than 1e-7 rad at 65 of the pulses, that bound is returned, with the first
/// of the targets; where 256 of the targets show less there, that is all that is looked at.
/// @param targets  positions in the scene's list
/// @return         0 by the light time of the thesis, which has a rule of its own, and without targets
/// @throw          Interrupted
[[nodiscard]] PulseMotion motion_left_in_pulse(const Acquisition& acquisition, std::span<const std::size_t> targets,
                                               const core::WorkControl& control = {});

}  // namespace sarsim::simulate
