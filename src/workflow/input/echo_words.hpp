#pragma once

#include <string>

#include "core/text/json.hpp"
#include "scene/model/scene.hpp"
#include "simulate/survey/survey.hpp"

/// What the survey of echoes says of a simulation, for people and for programs.
namespace sarsim::workflow {

/// Lines, each with its end: strongest and weakest echo, SNR of a pulse and with all pulses added, how far targets are
/// off the beam; that surfaces are left out, where there are some. Empty where there are none and no target is met.
[[nodiscard]] std::string echo_text(const scene::Scene& scene, const simulate::EchoSummary& summary);

/// The same as members of a JSON object that has been begun: `targets_in_window`, `strongest`, `weakest`.
void write_echoes(core::JsonWriter& json, const simulate::EchoSummary& summary);

/// How far a target is off the beam at its best pulse, and what that costs: "0.2 deg in azimuth and 1.1 deg in
/// elevation off the beam (-0.8 dB)". Positive to the right of the beam and above it; magnitudes in the profile
/// classic, whose antennas take no signs.
[[nodiscard]] std::string off_beam_text(const simulate::TargetVisibility& sight, scene::Profile profile);

/// A power ratio as "12.3 dB"; "none" for 0.
[[nodiscard]] std::string decibel_text(double ratio);

}  // namespace sarsim::workflow
