#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/program/completion.hpp"

namespace sarsim::cli {

namespace {

std::string all_names(const CompletedCommand& command) {
  std::vector<std::string> names;
  for (const CompletedOption& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

std::string command_names(const std::vector<CompletedCommand>& commands) {
  std::vector<std::string> names;
  for (const CompletedCommand& command : commands)
    if (!command.name.empty()) names.push_back(command.name);
  return fmt::format("{}", fmt::join(names, " "));
}

// Characters that end or change a quoted description, left out.
std::string plain(std::string text) {
  std::erase_if(text, [](char c) { return c == '\'' || c == '[' || c == ']' || c == '\\' || c == '`' || c == '"'; });
  std::ranges::replace(text, ':', ',');
  return text;
}

// Takes every line of what some commands of bash print for a word: names of files have blanks.
std::string reply(const std::string& commands) { return "mapfile -t COMPREPLY < <(" + commands + ");"; }

// "case" arms of bash: what follows an option.
std::string bash_values(const CompletedCommand& command) {
  std::string text;
  for (const CompletedOption& option : command.options) {
    if (!option.takes_value) continue;
    std::string words = option.takes_file ? "compgen -f -- \"$file\"" : "";
    if (!option.values.empty())
      words += fmt::format("{}compgen -W '{}' -- \"$word\"", words.empty() ? "" : "; ", fmt::join(option.values, " "));
    text += fmt::format("        {}) {} return ;;\n", fmt::join(option.names, "|"), words.empty() ? "" : reply(words));
  }
  return text;
}

std::string zsh_argument(const CompletedOption& option) {
  std::string text;
  for (const std::string& name : option.names) {
    std::string action;
    if (option.takes_file)
      action = ":file:_files";
    else if (!option.values.empty())
      action = fmt::format(":value:({})", fmt::join(option.values, " "));
    else if (option.takes_value)
      action = ":value:";
    text += fmt::format(" \\\n        '{}[{}]{}'", name, plain(option.description), action);
  }
  return text;
}

}  // namespace

std::string bash_completion(const std::vector<CompletedCommand>& commands) {
  std::string text =
      "# Completion of sarsim for bash; put it into a file that ~/.bashrc sources.\n"
      "_sarsim() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}\n"
      "  local file=${word//\\\\/}\n"  // As it is called, not as it is typed.
      "  file=${file#[\\\"\\']}\n"
      "  COMPREPLY=()\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n";
  text +=
      "    " +
      reply(fmt::format(
          "compgen -W '{} {}' -- \"$word\"; compgen -f -X '!*.scr' -- \"$file\"; compgen -f -X '!*.toml' -- \"$file\"",
          command_names(commands), all_names(commands.front()))) +
      "\n";
  text += "    return\n  fi\n  case $command in\n";
  for (const CompletedCommand& command : commands) {
    if (command.name.empty()) continue;
    text += fmt::format("    {})\n      case $previous in\n{}      esac\n", command.name, bash_values(command));
    text += "      " + reply(fmt::format("compgen -W '{}' -- \"$word\"", all_names(command))) + ";\n";
  }
  text += "  esac\n  case $word in -*) ;; *) " + reply("compgen -f -- \"$file\"") + " ;; esac\n";
  text += "  if [ \"$command\" = completion ]; then " + reply("compgen -W 'bash zsh fish' -- \"$word\"") + " fi\n";
  text +=
      "}\n"
      "complete -o filenames -F _sarsim sarsim\n";
  return text;
}

std::string zsh_completion(const std::vector<CompletedCommand>& commands) {
  std::string text =
      "#compdef sarsim\n"
      "# Completion of sarsim for zsh; put it as _sarsim into a folder of $fpath.\n"
      "_sarsim() {\n"
      "  if (( CURRENT == 2 )); then\n"
      "    local -a commands\n"
      "    commands=(\n";
  for (const CompletedCommand& command : commands)
    if (!command.name.empty()) text += fmt::format("      '{}:{}'\n", command.name, plain(command.description));
  text += "    )\n    _describe command commands\n    _arguments";
  for (const CompletedOption& option : commands.front().options) text += zsh_argument(option);
  text += "\n    _files -g '*.(scr|toml)'\n    return\n  fi\n  case ${words[2]} in\n";
  for (const CompletedCommand& command : commands) {
    if (command.name.empty()) continue;
    text += fmt::format("    {})\n      _arguments", command.name);
    for (const CompletedOption& option : command.options) text += zsh_argument(option);
    text += command.name == "completion" ? " \\\n        '*:shell:(bash zsh fish)' ;;\n"
                                         : " \\\n        '*:file:_files' ;;\n";
  }
  return text + "  esac\n}\n_sarsim \"$@\"\n";
}

std::string fish_completion(const std::vector<CompletedCommand>& commands) {
  std::string text = "# Completion of sarsim for fish; put it into ~/.config/fish/completions/sarsim.fish.\n";
  for (const CompletedCommand& command : commands) {
    const std::string condition =
        command.name.empty() ? "__fish_use_subcommand" : "__fish_seen_subcommand_from " + command.name;
    if (!command.name.empty())
      text += fmt::format("complete -c sarsim -n __fish_use_subcommand -a {} -d '{}'\n", command.name,
                          plain(command.description));
    for (const CompletedOption& option : command.options) {
      text += fmt::format("complete -c sarsim -n '{}'", condition);
      for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (option.takes_file)
        text += " -r -F";
      else if (!option.values.empty())
        text += fmt::format(" -x -a '{}'", fmt::join(option.values, " "));
      else if (option.takes_value)
        text += " -x";
      text += fmt::format(" -d '{}'\n", plain(option.description));
    }
  }
  return text + "complete -c sarsim -n '__fish_seen_subcommand_from completion' -x -a 'bash zsh fish'\n";
}

}  // namespace sarsim::cli
