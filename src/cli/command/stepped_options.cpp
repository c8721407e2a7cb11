#include "cli/command/stepped_options.hpp"

#include "cli/shell/recording_options.hpp"
#include "cli/shell/scene_options.hpp"

namespace sarsim::cli {

void add_stepped_input_arguments(CLI::App& app, workflow::RecordingArguments& arguments) {
  add_recording_arguments(app, arguments, "the first that suits");
  add_scene_overrides(app, arguments.overrides);
}

}  // namespace sarsim::cli
