#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/schema/scene_grammar.hpp"
#include "scene/script/write_commands.hpp"

namespace sarsim::scene::script {

namespace {

// A key with the keyword of its value, and that keyword's meaning.
template <class Value, std::size_t N>
void write_choice(ScriptLines& lines, std::string_view key, const Alternatives<Value, N>& alternatives, Value chosen) {
  for (const auto& alternative : alternatives)
    if (alternative.value == chosen) lines.value(fmt::format("{} {}", key, alternative.word), alternative.meaning);
}

}  // namespace

void write_options(ScriptLines& lines, const RunOptions& options) {
  namespace grammar = options_grammar;
  const RunOptions initial;
  if (options == initial) return;
  lines.plain("$OPTIONS");
  if (options.profile != initial.profile) write_choice(lines, "PROFILE", grammar::profiles, options.profile);
  if (options.seed != initial.seed) lines.value(fmt::format("SEED {}", options.seed), comment_of(grammar::seed));
  if (options.pulse != initial.pulse) write_choice(lines, "PULSE", grammar::pulses, options.pulse);
  if (options.tolerance != initial.tolerance)
    lines.value("TOLERANCE " + core::format_number(options.tolerance), comment_of(grammar::tolerance));
  lines.blank();
}

}  // namespace sarsim::scene::script
