#include "cli/shell/recording_options.hpp"

#include "cli/shell/options.hpp"

namespace sarsim::cli {

void add_recording_arguments(CLI::App& app, workflow::RecordingArguments& arguments, const std::string& otherwise) {
  add_text(app, "--script", arguments.script, "SCENE", "script that wrote the file of samples, where it carries none");
  add_integer(app, "--simulation", arguments.simulation, 1, std::int64_t{1} << 40,
              "which simulation of the script (default: the one with the file's name; of a script, " + otherwise + ")");
}

}  // namespace sarsim::cli
