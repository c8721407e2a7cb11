#include "scene/language/hover.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/language/cursor.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/path_facts.hpp"
#include "scene/script/order.hpp"

namespace sarsim::scene::language {

namespace {

std::optional<Explanation> known(std::string_view word) {
  Explanation explanation = explain(word);
  if (!explanation.failure.empty() || word.empty()) return std::nullopt;
  return explanation;
}

// One word of a choice: what the choice says of it.
std::optional<Explanation> explained_word(const std::string& choice, std::string_view word) {
  const Explanation whole = explain(choice);
  const auto found = std::ranges::find(whole.alternatives, word, &AlternativeExplanation::word);
  if (found == whole.alternatives.end()) return std::nullopt;
  Explanation one;
  one.name = fmt::format("{} of type {}", whole.name, word);
  one.meaning = found->meaning;
  one.example = found->example;
  one.in_script = found->in_script;
  const std::string kind = whole.name.substr(0, whole.name.find('.'));
  for (const std::string& field : found->fields) {
    const Explanation explanation = explain(fmt::format("{}.{}", kind, field));
    one.lines.push_back({explanation.name, explanation.initial, first_sentence(explanation.meaning)});
  }
  return one;
}

Explanation command_explained(std::string_view command, std::string_view meaning, std::string_view header) {
  Explanation explanation;
  explanation.name = fmt::format("${}", command);
  explanation.meaning = fmt::format("{} In format 2: {}.", meaning, plain_table(header)->header_line());
  explanation.takes = "values in this order, those that apply";
  return explanation;
}

void add_once(Explanation& explanation, std::string_view name) {
  if (std::ranges::find(explanation.lines, name, &ExplanationLine::name) == explanation.lines.end())
    explanation.lines.push_back({std::string(name), {}, {}});
}

}  // namespace

std::optional<Explanation> explanation_at(std::string_view text, std::size_t offset) {
  const Cursor cursor = cursor_at(text, offset);
  if (cursor.word.begin > offset || cursor.word.end <= offset) return std::nullopt;
  const std::string path = fmt::format("{}{}{}", cursor.kind, cursor.kind.empty() ? "" : ".", cursor.path);
  switch (cursor.site) {
    case Site::header: return known(cursor.path);
    case Site::key: return cursor.kind == "let" ? std::nullopt : known(path);
    case Site::string: return explained_word(path, core::toml::piece(text, cursor.word));
    default: return std::nullopt;
  }
}

std::optional<Explanation> explanation_of_command(std::string_view command) {
  std::optional<Explanation> found;
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    if (!core::equal_ignoring_case(kind.command, command)) return;
    found = command_explained(kind.command, kind.meaning, header_of(kind.kind));
    for (const FieldOf<Object>* const field : script::script_order<Object>()) add_once(*found, field->spec.words);
  });
  const PlainTable& options = *plain_table("options");
  if (!core::equal_ignoring_case(options.command, command)) return found;
  found = command_explained(options.command, options.meaning, options.header);
  for (const FieldOf<RunOptions>* const field : script::script_order<RunOptions>())
    add_once(*found, script::option_key(field->spec));
  return found;
}

}  // namespace sarsim::scene::language
