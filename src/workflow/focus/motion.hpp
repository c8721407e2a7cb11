#pragma once

#include <optional>
#include <string>

#include "signal/sar/motion_compensation.hpp"
#include "workflow/focus/focus_input.hpp"

namespace sarsim::workflow {

/// Of what departs from a straight flight at constant speed, what is taken out of the echoes.
enum class MotionOrder {
  none,
  first,   ///< What the middle of the scene needs, for all ranges alike.
  second,  ///< Also what depends on range.
};

/// "none", "first" or "second".
[[nodiscard]] std::string to_string(MotionOrder order);

/// Whether what `signal::problems_of_focusing` found says that a track leaves the straight line, or is sampled so
/// unevenly, that focusing in the frequency domain suffers.
[[nodiscard]] bool wants_compensation(const core::Problems& problems);

/// Largest relative change of the distance between pulses, from one to the next, across which motion compensation
/// interpolates.
inline constexpr double max_uneven = 0.02;

/// core::InvalidRequest where the antenna does not fly the line that fits its track in one direction.
void expect_one_way(const signal::EchoRows& echoes);

/// What echoes of an input are compensated to: the line that fits their track best, for the middle of the scene under
/// the squint of the Doppler centroid. Their antenna moves. core::InvalidRequest where the ground is out of reach.
/// @param ground_m  height of the ground, world; nothing: that of the middle of the scene
[[nodiscard]] signal::MotionCompensation compensation_of(const FocusInput& input, MotionOrder order,
                                                         std::optional<double> ground_m,
                                                         const signal::FocusOptions& options);

/// Puts echoes compensated to the line that fits the track best in the place of those of an input. core::InvalidRequest
/// where the pulses are too unevenly spaced along the line to be interpolated or turn back, or the ground is out of
/// reach.
/// @param ground_m  height of the ground, world; nothing: that of the middle of the scene
/// @param options   their Doppler centroid says the squint; half of their memory is used
void compensate(FocusInput& input, MotionOrder order, std::optional<double> ground_m,
                const signal::FocusOptions& options, const core::WorkControl& control,
                const core::ProgressReport& progress);

}  // namespace sarsim::workflow
