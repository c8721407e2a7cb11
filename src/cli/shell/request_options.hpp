#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "workflow/options/option.hpp"

namespace sarsim::cli {

/// Adds an option that takes a word, or several times one.
/// @param take  gets each word that the option takes
CLI::Option* add_worded_option(CLI::App& app, const workflow::Option& option,
                               std::function<void(const std::string&)> take);

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
