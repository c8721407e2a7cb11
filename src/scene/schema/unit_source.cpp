#include "scene/schema/unit_source.hpp"

#include <algorithm>

#include "scene/schema/unit_table.hpp"

namespace sarsim::scene {

std::string_view word_at(std::string_view text, std::size_t place) {
  if (place >= text.size() || !begins_word(text[place])) return {};
  std::size_t end = place + 1;
  while (end < text.size() && (begins_word(text[end]) || core::is_digit(text[end]))) ++end;
  return text.substr(place, end - place);
}

Source::Source(std::string_view text) : typed_(text), plain_(text) {
  if (std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80U; })) return;
  made_ = plain_expression(text, origins_);
  plain_ = made_;
}

std::string Source::quote(std::size_t begin, std::size_t end) const { return quoted(part(begin, end)); }

std::vector<ExpressionWord> words_of(std::string_view text) {
  const Source source(text);
  const std::string_view plain = source.plain();
  std::vector<ExpressionWord> words;
  for (std::size_t at = 0; at < plain.size();) {
    const std::string_view word = word_at(plain, at);
    if (!word.empty()) words.push_back({std::string(word), source.origin(at), source.origin(at + word.size())});
    const std::size_t number = begins_number(plain[at]) ? number_length(plain.substr(at)) : 0;
    at += std::max<std::size_t>({word.size(), number, 1});
  }
  return words;
}

}  // namespace sarsim::scene
