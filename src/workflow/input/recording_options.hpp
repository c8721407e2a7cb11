#pragma once

#include <string>

#include "workflow/input/recording_input.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::workflow {

/// --script and --simulation.
/// @param otherwise  the simulation of a script that is taken where none is named, in words
[[nodiscard]] OptionTable<RecordingArguments> recording_options(const std::string& otherwise = "the first");

/// --profile, --pulse, --tolerance and --seed, which stand in for values of the script.
[[nodiscard]] OptionTable<SceneOverrides> scene_override_options();

/// Both, of stepped recordings: the first simulation that suits is taken.
[[nodiscard]] OptionTable<RecordingArguments> stepped_recording_options();

}  // namespace sarsim::workflow
