#pragma once

#include "cli/shell/recording_options.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/input/scene_input.hpp"

/// The names of the workflows, as the commands use them.
namespace sarsim::cli {

using workflow::named_sources;
using workflow::names_script;
using workflow::open_recording;
using workflow::open_script;
using workflow::RecordingArguments;
using workflow::records_pulses;
using workflow::ScriptedRecording;
using workflow::StoredRecording;
using workflow::Suits;

}  // namespace sarsim::cli
