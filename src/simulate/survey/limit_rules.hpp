#pragma once

#include <cstddef>
#include <string>

#include "core/report/problem.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/survey/survey_echoes.hpp"

namespace sarsim::simulate {

/// Reports where real propagation, a receiver or a processor would differ from the simulation, each with its number:
///
/// - a Doppler shift that moves more than 5 % of an echo's spectrum out of the sampled band, where it aliases,
/// - a radar below the ground: more than 1 m below z = 0 of a flat world and below its targets; more than 120 m below
///   the ellipsoid, deeper than any geoid,
/// - ionospheric dispersion within the band, which is not simulated, above half a range cell,
/// - ray bending, which is not simulated, where it shortens the optical path by more than a sixteenth of a wavelength,
/// - targets on both sides of a synthetic aperture of antennas without azimuth pattern,
/// - targets at the same position (of up to 100 000), and targets within one cell of range and Doppler (of up to 64),
/// - targets whose Doppler frequency is within 2 % of the PRF of a multiple of it other than 0 (blind speeds).
///
/// Except for targets at the same position, targets in the window are examined at the middle pulse, of more than 64 an
/// even selection with the strongest and the weakest (`targets_in_window`).
/// @param index  of the simulation
/// @param scope  how much of the recording the survey has seen, for messages; may be empty
void check_limits(const Acquisition& acquisition, const EchoSurvey& survey, std::size_t index, const std::string& scope,
                  core::Problems& problems);

}  // namespace sarsim::simulate
