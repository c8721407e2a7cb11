#pragma once

#include <cstddef>
#include <string>

#include "core/report/problem.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/survey/survey.hpp"

namespace sarsim::simulate {

/// Adds what is computed although nature, a receiver or a processor would differ, each with its number:
///
/// - a Doppler shift that moves more than 5 % of an echo's spectrum out of the sampled band, where it aliases,
/// - a radar below the ground: more than 1 m below z = 0 of a flat world and below all of its targets; more than 120 m
///   below the ellipsoid, deeper than any geoid,
/// - dispersion by the ionosphere within the band, which echoes leave out, above half a range cell,
/// - rays that would bend by more than a sixteenth of a wavelength beside the straight line that echoes follow,
/// - targets on both sides of a synthetic aperture of antennas without azimuth pattern,
/// - targets at the same position, and targets within one cell of range and Doppler,
/// - targets whose Doppler frequency is a multiple of the PRF other than 0 (blind speeds).
///
/// @param index  of the simulation
/// @param scope  how much of the recording the survey has seen, for messages; may be empty
void check_limits(const Plan& plan, const EchoSurvey& survey, std::size_t index, const std::string& scope,
                  core::Problems& problems);

}  // namespace sarsim::simulate
