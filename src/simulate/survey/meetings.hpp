#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/survey/survey.hpp"

namespace sarsim::simulate {

/// Pulses at which targets have echoes that cannot be computed although those of the first pulse can: most of all where
/// the radar comes to the place of a target. Examined are the targets whose distance at the sampled pulses and speed
/// let the radar reach them between two of these, at most 64, the nearest first: in each case at the pulse with the
/// least distance between the neighbours of the nearest sampled pulse.
/// @param pulses  that the survey has examined, ascending
/// @return        at most one for each target, by target
/// @throw         Interrupted
[[nodiscard]] std::vector<ImpossiblePulse> impossible_pulses(const Acquisition& acquisition, const EchoSurvey& survey,
                                                             std::span<const std::int64_t> pulses,
                                                             const core::WorkControl& control);

}  // namespace sarsim::simulate
