#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/model/scene.hpp"

/// Options that commands share in kind: each reads one value strictly and says what it takes.
namespace sarsim::cli {

/// A whole number from `low` to `high`.
CLI::Option* add_integer(CLI::App& app, const std::string& names, std::optional<std::int64_t>& value, std::int64_t low,
                         std::int64_t high, const std::string& description);

/// A whole number from 0 to 2^64 - 1.
CLI::Option* add_seed(CLI::App& app, const std::string& names, std::optional<std::uint64_t>& value,
                      const std::string& description);

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

/// Throws CLI::ValidationError that says what `names` takes, with the nearest word.
[[noreturn]] void refuse_word(const std::string& names, const std::string& word, const std::vector<std::string>& words);

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

#include "core/text/number_text.hpp"

namespace sarsim::cli {

template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& names, std::optional<Value>& value,
                        const std::vector<std::pair<std::string, Value>>& choices, const std::string& description) {
  std::vector<std::string> words;
  std::string type;
  for (const auto& [word, unused] : choices) {
    words.push_back(word);
    type += (type.empty() ? "" : "|") + word;
  }
  const auto read = [&value, names, choices, words](const std::string& text) {
    for (const auto& [word, meaning] : choices)
      if (core::equal_ignoring_case(word, text)) {
        value = meaning;
        return;
      }
    refuse_word(names, text, words);
  };
  return app.add_option_function<std::string>(names, read, description)->type_name(type);
}

}  // namespace sarsim::cli
