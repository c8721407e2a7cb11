#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "workflow/options/option.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::cli {

/// Adds an option that takes a word, or several times one.
/// @param take  gets each word that the option takes
CLI::Option* add_worded_option(CLI::App& app, const workflow::Option& option,
                               std::function<void(const std::string&)> take);

/// Adds every option of a table, each of which takes its word into the request at once.
template <class Request>
void add_table_options(CLI::App& app, const workflow::OptionTable<Request>& table, Request& request);

/// What a command of a request was told; the words as they stand there.
struct RequestArguments {
  std::string input;
  workflow::GivenWords words;
  std::map<std::string, bool> flags;
  bool json = false;
  bool quiet = false;

  /// The words and the flags that are set, as requests take them.
  [[nodiscard]] workflow::GivenWords given() const;
};

/// Adds the input of a request, its options and, behind --force, what a terminal alone has: --json and --quiet.
/// @param input  what may be named as the input, for the help
void add_request_arguments(CLI::App& app, const std::vector<workflow::Option>& options, RequestArguments& arguments,
                           const std::string& input = "scene to simulate, or file of samples");

}  // namespace sarsim::cli

// Implementation of the template.

namespace sarsim::cli {

template <class Request>
void add_table_options(CLI::App& app, const workflow::OptionTable<Request>& table, Request& request) {
  for (const workflow::RequestOption<Request>& option : table) {
    const auto take = [take = option.take, &request](const std::string& word) { take(request, word); };
    if (option.kind == workflow::OptionKind::flag)
      app.add_flag_callback(
          option.name, [take] { take(""); }, option.help);
    else
      add_worded_option(app, option, take);
  }
}

}  // namespace sarsim::cli
