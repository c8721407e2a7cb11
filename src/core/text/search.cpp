#include "core/text/search.hpp"

#include <algorithm>
#include <limits>

#include "core/text/letters.hpp"

namespace sarsim::core {

namespace {

constexpr int no_match = std::numeric_limits<int>::min() / 2;

constexpr int letter_score = 1;
constexpr int row_score = 9;         // the letter before it matched the one before
constexpr int word_score = 8;        // at the beginning of a word
constexpr int beginning_score = 1;   // of the whole text, in addition
constexpr int whole_text_score = 4;  // nothing is left over

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_word_part(char c) { return is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80U; }

// After a blank or sign, or at a capital behind a small letter.
bool begins_word(std::string_view text, std::size_t i) {
  if (!is_word_part(text[i])) return false;
  return i == 0 || !is_word_part(text[i - 1]) || (is_upper(text[i]) && !is_upper(text[i - 1]));
}

// The best score of all ways to find the letters in the text in order, by dynamic programming: `ended[j]` is the best
// with the letters so far, the last of them at text[j].
int score_of(std::string_view letters, std::string_view text) {
  std::vector<int> ended(text.size(), no_match);
  std::vector<int> next(text.size(), no_match);
  for (std::size_t i = 0; i < letters.size(); ++i) {
    int best_before = i == 0 ? 0 : no_match;
    for (std::size_t j = 0; j < text.size(); ++j) {
      next[j] = no_match;
      if (lower(text[j]) == letters[i]) {
        const int in_row = i > 0 && j > 0 ? ended[j - 1] + row_score : no_match;
        const int place = begins_word(text, j) ? word_score + (j == 0 ? beginning_score : 0) : 0;
        const int before = std::max(best_before, in_row);
        if (before > no_match / 2) next[j] = before + letter_score + place;
      }
      if (i > 0) best_before = std::max(best_before, ended[j]);
    }
    std::swap(ended, next);
  }
  const int best = text.empty() ? no_match : *std::ranges::max_element(ended);
  return best + (letters.size() == text.size() ? whole_text_score : 0);
}

}  // namespace

std::vector<std::size_t> ranked_matches(std::string_view typed, const std::vector<std::string>& texts) {
  std::string letters;
  for (const char c : typed)
    if (c != ' ' && c != '\t') letters += lower(c);
  std::vector<std::size_t> matches;
  std::vector<int> scores(texts.size(), 0);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!letters.empty()) scores[i] = letters.size() <= texts[i].size() ? score_of(letters, texts[i]) : no_match;
    if (scores[i] > no_match / 2) matches.push_back(i);
  }
  std::ranges::stable_sort(matches, std::ranges::greater{}, [&](std::size_t i) { return scores[i]; });
  return matches;
}

}  // namespace sarsim::core
