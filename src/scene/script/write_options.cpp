#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

namespace {

// The key with the value and what that means.
void write_option(ScriptLines& lines, const FieldOf<RunOptions>& option, const RunOptions& options) {
  const FieldValue value = option.get(options);
  const std::string key = option_key(option.spec);
  if (const Choice* const choice = chosen_word(option.spec, value))
    lines.value(fmt::format("{} {}", key, choice->word), choice->meaning);
  else if (const auto* const seed = std::get_if<std::uint64_t>(&value))
    lines.value(fmt::format("{} {}", key, *seed), comment_of(option.in_script));
  else if (const auto* const number = std::get_if<double>(&value))
    lines.value(fmt::format("{} {}", key, core::format_number(*number)), comment_of(option.in_script));
}

}  // namespace

void write_command(ScriptLines& lines, const RunOptions& options) {
  const RunOptions initial;
  if (options == initial) return;
  lines.plain("$OPTIONS");
  for (const FieldOf<RunOptions>* const option : script_order<RunOptions>()) {
    RunOptions same = options;
    option->reset(same);
    if (!(same == options)) write_option(lines, *option, options);
  }
  lines.blank();
}

}  // namespace sarsim::scene::script
