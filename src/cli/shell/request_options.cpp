#include "cli/shell/request_options.hpp"

#include <algorithm>
#include <utility>

#include "cli/shell/options.hpp"

namespace sarsim::cli {

CLI::Option* add_worded_option(CLI::App& app, const workflow::Option& option,
                               std::function<void(const std::string&)> take) {
  const auto read = [option, take = std::move(take)](const std::string& word) {
    if (const std::string mistake = workflow::mistake_in(option, word); !mistake.empty())
      throw CLI::ValidationError(option.name, mistake);
    take(word);
  };
  if (option.kind == workflow::OptionKind::texts)
    return app
        .add_option_function<std::vector<std::string>>(
            option.name, [read](const std::vector<std::string>& words) { std::ranges::for_each(words, read); },
            option.help)
        ->type_name(option.placeholder)
        ->allow_extra_args(false);
  // What is written has the same two names in every command.
  const std::string names = option.name == "--out" ? "-o,--out" : option.name;
  return app.add_option_function<std::string>(names, read, option.help)->type_name(option.placeholder);
}

workflow::GivenWords RequestArguments::given() const {
  workflow::GivenWords all = words;
  for (const auto& [name, set] : flags)
    if (set) all.emplace(name, "");
  return all;
}

void add_request_arguments(CLI::App& app, const std::vector<workflow::Option>& options, RequestArguments& arguments,
                           const std::string& input) {
  add_text(app, "input", arguments.input, "SCENE|DATA", input)->required();
  for (const workflow::Option& option : options) {
    if (option.kind == workflow::OptionKind::flag)
      app.add_flag(option.name, arguments.flags[option.name], option.help);
    else
      add_worded_option(app, option, [&arguments, name = option.name](const std::string& word) {
        arguments.words.emplace(name, word);
      });
    if (option.name != "--force") continue;
    app.add_flag("--json", arguments.json, "a report as JSON on standard output");
    app.add_flag("--quiet", arguments.quiet, "only errors on standard error");
  }
}

}  // namespace sarsim::cli
