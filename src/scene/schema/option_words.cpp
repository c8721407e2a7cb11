#include "scene/schema/option_words.hpp"

#include <algorithm>

#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

std::string in_small_letters(std::string_view word) {
  std::string small(word);
  std::ranges::transform(small, small.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return small;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> option_words(const RunOptions& options) {
  std::vector<std::pair<std::string, std::string>> words;
  for (const FieldOf<RunOptions>& field : table_of<RunOptions>().fields()) {
    if (field.alternative == nullptr) continue;
    const auto found = std::ranges::find(field.spec.choices, field.alternative(options), &Choice::value);
    if (found != field.spec.choices.end()) words.emplace_back(field.spec.id, in_small_letters(found->word));
  }
  return words;
}

bool take_option_word(RunOptions& options, std::string_view id, std::string_view word) {
  for (const FieldOf<RunOptions>& field : table_of<RunOptions>().fields()) {
    if (field.alternative == nullptr || field.spec.id != id) continue;
    for (const Choice& choice : field.spec.choices)
      if (in_small_letters(choice.word) == word) {
        field.put(options, choice.value);
        return true;
      }
  }
  return false;
}

}  // namespace sarsim::scene
