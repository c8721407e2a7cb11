#include "scene/language/explanation_search.hpp"

#include <algorithm>

#include "core/text/letters.hpp"

namespace sarsim::scene::language {

namespace {

constexpr int whole_name = 8;
constexpr int begins_name = 6;
constexpr int whole_alias = 5;
constexpr int begins_alias = 3;
constexpr int in_meaning = 1;

bool is_word_letter(char c) {
  return core::is_digit(c) || core::is_letter(c) || static_cast<unsigned char>(c) >= 0x80U;
}

// In small letters.
std::vector<std::string> words_in(std::string_view text) {
  std::vector<std::string> words;
  bool within = false;
  for (const char c : text) {
    if (is_word_letter(c)) {
      if (!within) words.emplace_back();
      words.back() += core::lower(c);
    }
    within = is_word_letter(c);
  }
  return words;
}

// For a word of the text that is the one looked for, or begins with it; 0 where there is none.
int score(std::string_view wanted, const std::vector<std::string>& words, int whole, int beginning) {
  int best = 0;
  for (const std::string& word : words)
    if (word.starts_with(wanted)) best = std::max(best, word.size() == wanted.size() ? whole : beginning);
  return best;
}

// Of all words of a search; 0 where one of them is missing.
int score(const std::vector<std::string>& search, const SearchText& text) {
  const std::vector<std::string> name = words_in(text.name);
  const std::vector<std::string> aliases = words_in(text.aliases);
  const std::vector<std::string> meaning = words_in(text.meaning);
  int sum = 0;
  for (const std::string& wanted : search) {
    const int best =
        std::max({score(wanted, name, whole_name, begins_name), score(wanted, aliases, whole_alias, begins_alias),
                  score(wanted, meaning, in_meaning, in_meaning)});
    if (best == 0) return 0;
    sum += best;
  }
  return sum;
}

}  // namespace

std::vector<std::size_t> best_matches(std::string_view search, const std::vector<SearchText>& texts) {
  const std::vector<std::string> wanted = words_in(search);
  std::vector<int> scores(texts.size(), 0);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < texts.size() && !wanted.empty(); ++i) {
    scores[i] = score(wanted, texts[i]);
    if (scores[i] > 0) found.push_back(i);
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, [&](std::size_t i) { return scores[i]; });
  return found;
}

std::vector<GuideHeading> headings_with(std::string_view search) {
  const std::vector<std::string> wanted = words_in(search);
  std::vector<GuideHeading> found;
  for (const GuideHeading& one : guide_headings()) {
    const std::vector<std::string> words = words_in(one.heading.empty() ? one.title : one.heading);
    const bool has_all = !wanted.empty() && std::ranges::all_of(wanted, [&](const std::string& word) {
      return score(word, words, 1, 1) > 0;
    });
    if (has_all) found.push_back(one);
  }
  return found;
}

}  // namespace sarsim::scene::language
