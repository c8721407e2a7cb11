#pragma once

#include <string>

#include "workflow/input/recording_input.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::workflow {

/// --script alone.
[[nodiscard]] OptionTable<RecordingArguments> script_file_option();

/// The same, --simulation and --dataset.
/// @param otherwise  the simulation of a script that is taken where none is named, in words
[[nodiscard]] OptionTable<RecordingArguments> script_options(const std::string& otherwise = "the first");

/// The same and what stands in for values of the script.
[[nodiscard]] OptionTable<RecordingArguments> recording_options(const std::string& otherwise = "the first");

/// --profile, --pulse, --tolerance and --seed, which stand in for values of the script, and --targets.
[[nodiscard]] OptionTable<SceneOverrides> run_choice_options();

/// The same and --set for any other value.
[[nodiscard]] OptionTable<SceneOverrides> scene_override_options();

}  // namespace sarsim::workflow
