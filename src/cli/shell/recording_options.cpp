#include "cli/shell/recording_options.hpp"

#include "cli/shell/request_options.hpp"
#include "workflow/input/recording_options.hpp"

namespace sarsim::cli {

void add_recording_arguments(CLI::App& app, workflow::RecordingArguments& arguments, const std::string& otherwise) {
  for (const auto& option : workflow::script_options(otherwise))
    add_worded_option(app, option,
                      [take = option.take, &arguments](const std::string& word) { take(arguments, word); });
}

}  // namespace sarsim::cli
