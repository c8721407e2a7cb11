#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/model/scene.hpp"
#include "workflow/options/option.hpp"

/// Options that commands share in kind: each reads one value strictly and says what it takes.
namespace sarsim::cli {

/// A whole number from `low` to `high`.
CLI::Option* add_integer(CLI::App& app, const std::string& names, std::optional<std::int64_t>& value, std::int64_t low,
                         std::int64_t high, const std::string& description);

/// A decimal number, finite.
CLI::Option* add_real(CLI::App& app, const std::string& names, std::optional<double>& value, const std::string& unit,
                      const std::string& description);

/// A decimal number within limits.
/// @param meets  whether a number is within them
/// @param expected  what is: "a number above 0"
CLI::Option* add_real(CLI::App& app, const std::string& names, std::optional<double>& value, const std::string& unit,
                      const std::string& description, bool (*meets)(double), const std::string& expected);

/// Two decimal numbers, finite; `values` stays empty where the option is not given.
/// @param type  names of both: "FROM TO"
CLI::Option* add_two_reals(CLI::App& app, const std::string& names, std::vector<double>& values,
                           const std::string& type, const std::string& description);

/// A text that is not an option by mistake ("--out --force").
CLI::Option* add_text(CLI::App& app, const std::string& names, std::string& value, const std::string& type,
                      const std::string& description);

/// Throws CLI::ValidationError where a word is none that a kind of option takes; only what concerns words is looked at.
void expect_word(const std::string& names, const std::string& word, const workflow::Option& option);

/// One of some words, ignoring case.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& names, std::optional<Value>& value,
                        const std::vector<std::pair<std::string, Value>>& choices, const std::string& description);

/// --format and the like: every format of sample files.
CLI::Option* add_format(CLI::App& app, const std::string& names, std::optional<scene::FileFormat>& value,
                        const std::string& description);

/// Examples at the end of a command's help; each line a command.
void add_examples(CLI::App& app, const std::vector<std::pair<std::string, std::string>>& commands_and_meanings);

}  // namespace sarsim::cli

// Implementation of the template.

namespace sarsim::cli {

template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& names, std::optional<Value>& value,
                        const std::vector<std::pair<std::string, Value>>& choices, const std::string& description) {
  workflow::Option option{names, workflow::OptionKind::choice, "", description};
  std::vector<Value> values;
  for (const auto& [word, meaning] : choices) {
    option.placeholder += (option.placeholder.empty() ? "" : "|") + word;
    option.words.push_back(word);
    values.push_back(meaning);
  }
  const auto read = [&value, option, values](const std::string& text) {
    expect_word(option.name, text, option);
    value = values.at(workflow::choice_in(option, text));
  };
  return app.add_option_function<std::string>(names, read, description)->type_name(option.placeholder);
}

}  // namespace sarsim::cli
