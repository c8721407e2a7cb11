#include <algorithm>
#include <array>
#include <sstream>

#include "cli/program/completion.hpp"

namespace sarsim::cli {

namespace {

// Types of values that name files; see the functions that add options.
constexpr std::array<std::string_view, 9> file_types{"FILE",  "FILE.csv", "DIR", "SCENE",  "IN",
                                                     "IMAGE", "OUT",      "CSV", "PICTURE"};

// The words between the bars of a type.
std::vector<std::string> parts(const std::string& type) {
  std::vector<std::string> words;
  std::istringstream stream(type);
  for (std::string word; std::getline(stream, word, '|');) words.push_back(word);
  return words;
}

// Words to be typed as they are; others, such as HZ, stand for a value.
std::vector<std::string> alternatives(const std::string& type) {
  std::vector<std::string> words = parts(type);
  if (words.size() < 2) return {};
  std::erase_if(words, [](const std::string& word) {
    return word.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") != std::string::npos;
  });
  return words;
}

bool names_file(const std::string& type) {
  return std::ranges::any_of(
      parts(type), [](const std::string& part) { return std::ranges::find(file_types, part) != file_types.end(); });
}

CompletedOption completed(const CLI::Option& option) {
  CompletedOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  result.description = option.get_description();
  result.takes_value = option.get_type_size_max() > 0;
  if (!result.takes_value) return result;
  result.values = alternatives(option.get_type_name());
  result.takes_file = names_file(option.get_type_name());
  return result;
}

CompletedCommand completed(const CLI::App& app, const std::string& name) {
  CompletedCommand command{name, app.get_description(), {}};
  for (const CLI::Option* option : app.get_options())
    if (!option->get_snames().empty() || !option->get_lnames().empty()) command.options.push_back(completed(*option));
  return command;
}

}  // namespace

std::vector<CompletedCommand> completed_commands(const CLI::App& root) {
  std::vector<CompletedCommand> commands{completed(root, "")};
  for (const CLI::App* app : root.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(completed(*app, app->get_name()));
  return commands;
}

}  // namespace sarsim::cli
