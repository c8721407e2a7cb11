#include "cli/shell/options.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "workflow/convert/convert_options.hpp"

namespace sarsim::cli {

namespace {

// "--threads" of "-j,--threads".
std::string shown_name(const std::string& names) { return names.substr(names.rfind(',') + 1); }

[[noreturn]] void refuse(const std::string& names, const std::string& text, const std::string& expected) {
  throw CLI::ValidationError(shown_name(names), fmt::format("'{}' is not {}", text, expected));
}

}  // namespace

CLI::Option* add_integer(CLI::App& app, const std::string& names, std::optional<std::int64_t>& value, std::int64_t low,
                         std::int64_t high, const std::string& description) {
  const auto read = [&value, names, low, high](const std::string& text) {
    const auto number = core::parse_integer(text);
    if (!number || *number < low || *number > high)
      refuse(names, text, fmt::format("a whole number from {} to {}", low, high));
    value = number;
  };
  return app.add_option_function<std::string>(names, read, description)->type_name("N");
}

CLI::Option* add_real(CLI::App& app, const std::string& names, std::optional<double>& value, const std::string& unit,
                      const std::string& description) {
  return add_real(
      app, names, value, unit, description, [](double) { return true; }, "a number");
}

CLI::Option* add_real(CLI::App& app, const std::string& names, std::optional<double>& value, const std::string& unit,
                      const std::string& description, bool (*meets)(double), const std::string& expected) {
  const auto read = [&value, names, meets, expected](const std::string& text) {
    value = core::parse_number(text);
    if (!value || !meets(*value)) refuse(names, text, expected);
  };
  return app.add_option_function<std::string>(names, read, description)->type_name(unit);
}

CLI::Option* add_two_reals(CLI::App& app, const std::string& names, std::vector<double>& values,
                           const std::string& type, const std::string& description) {
  const auto read = [&values, names](const std::vector<std::string>& texts) {
    values.clear();
    for (const std::string& text : texts) {
      const auto number = core::parse_number(text);
      if (!number) refuse(names, text, "a number");
      values.push_back(*number);
    }
  };
  return app.add_option_function<std::vector<std::string>>(names, read, description)->expected(2)->type_name(type);
}

CLI::Option* add_text(CLI::App& app, const std::string& names, std::string& value, const std::string& type,
                      const std::string& description) {
  const auto read = [&value, names, type](const std::string& text) {
    expect_word(names, text, {names, workflow::OptionKind::text, "", ""});
    value = text;
  };
  return app.add_option_function<std::string>(names, read, description)->type_name(type);
}

void expect_word(const std::string& names, const std::string& word, const workflow::Option& option) {
  if (const std::string mistake = workflow::mistake_in(option, word); !mistake.empty())
    throw CLI::ValidationError(shown_name(names), mistake);
}

CLI::Option* add_format(CLI::App& app, const std::string& names, std::optional<scene::FileFormat>& value,
                        const std::string& description) {
  return add_choice<scene::FileFormat>(app, names, value, workflow::format_choices(), description);
}

void add_examples(CLI::App& app, const std::vector<std::pair<std::string, std::string>>& commands_and_meanings) {
  std::size_t width = 0;
  for (const auto& [command, meaning] : commands_and_meanings) width = std::max(width, command.size());
  std::string text = "Examples:";
  for (const auto& [command, meaning] : commands_and_meanings)
    text += fmt::format("\n  {:<{}}  {}", command, width, meaning);
  app.footer(text);
}

}  // namespace sarsim::cli
