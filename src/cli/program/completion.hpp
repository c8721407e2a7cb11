#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace sarsim::cli {

/// An option as a shell completes it.
struct CompletedOption {
  std::vector<std::string> names;  ///< With their dashes.
  std::string description;
  bool takes_value = false;
  std::vector<std::string> values;  ///< What it takes, where that is a choice.
  bool takes_file = false;          ///< The name of a file or folder.
};

/// A command as a shell completes it.
struct CompletedCommand {
  std::string name;
  std::string description;
  std::vector<CompletedOption> options;
};

/// All commands of an application with their options, taken from the application itself so that they cannot drift.
/// The first entry, without a name, is the application.
[[nodiscard]] std::vector<CompletedCommand> completed_commands(const CLI::App& root);

/// Completion scripts for three shells.
[[nodiscard]] std::string bash_completion(const std::vector<CompletedCommand>& commands);
[[nodiscard]] std::string zsh_completion(const std::vector<CompletedCommand>& commands);
[[nodiscard]] std::string fish_completion(const std::vector<CompletedCommand>& commands);

}  // namespace sarsim::cli
