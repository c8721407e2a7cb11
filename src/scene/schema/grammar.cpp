#include "scene/schema/grammar.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/model/kinds.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::scene::script {

namespace {

char upper(char c) { return (c >= 'a' && c <= 'z') ? static_cast<char>(c - 'a' + 'A') : c; }

bool letters_match(std::string_view typed, std::string_view word, std::size_t significant) {
  if (typed.empty()) return false;
  const std::size_t compared = std::min({typed.size(), word.size(), significant});
  return std::ranges::equal(typed.substr(0, compared), word.substr(0, compared), {}, upper);
}

// Every keyword of an object's command.
std::vector<std::string_view> keywords() {
  std::vector<std::string_view> words{stc_switch};
  for (const auto& method : interpolations) words.push_back(method.word);
  for (const auto& source : data_sources) words.push_back(source.word);
  for_each_kind([&](const auto& kind) {
    for (const auto& field : table_of(kind).fields())
      for (const Choice& choice : field.spec.choices)
        if (!choice.word.empty()) words.push_back(choice.word);
  });
  return words;
}

}  // namespace

Field parameter_of(const FieldSpec& spec) {
  return {spec.problem_place(), spec.words, script_unit(spec), script_shift(spec), spec.range, spec.detail};
}

std::string range_text(const Range& range) {
  const bool bounded_below = std::isfinite(range.low);
  const bool bounded_above = std::isfinite(range.high);
  if (bounded_below && bounded_above)
    return fmt::format(", {} to {}", core::format_number(range.low), core::format_number(range.high));
  if (!bounded_below) return bounded_above ? fmt::format(", at most {}", core::format_number(range.high)) : "";
  if (range.low == 0.0) return range.low_excluded ? ", above zero" : ", zero or more";
  return fmt::format(", at least {}", core::format_number(range.low));
}

bool keyword_matches(std::string_view typed, std::string_view keyword) { return letters_match(typed, keyword, 3); }

bool command_matches(std::string_view typed, std::string_view command) { return letters_match(typed, command, 5); }

bool is_keyword(std::string_view typed) {
  if (typed.size() < 3) return false;
  static const std::vector<std::string_view> words = keywords();
  return std::ranges::any_of(words, [&](std::string_view word) { return keyword_matches(typed, word); });
}

bool begins_like_number(std::string_view typed) {
  return !typed.empty() && std::string_view("+-.0123456789").find(typed.front()) != std::string_view::npos;
}

}  // namespace sarsim::scene::script
