#include "scene/script/pieces.hpp"

#include <algorithm>

namespace sarsim::scene::script {

namespace {

// Beginning of the first line from `from` on that begins with a command; the end of the text where there is none.
std::size_t next_command_line(const Tokens& whole, std::size_t from) {
  const std::string_view text = whole.text();
  for (std::size_t at = text.find('$', from); at != std::string_view::npos; at = text.find('$', at + 1)) {
    std::size_t begin = at;
    while (begin > from && text[begin - 1] != whole.line_end() && is_separator(text[begin - 1])) --begin;
    if (text[begin - 1] == whole.line_end()) return begin;
  }
  return text.size();
}

std::size_t count_of(char wanted, std::string_view text) {
  constexpr std::size_t block = 128;  // so that the inner count fits a byte and is done on many bytes at once
  std::size_t count = 0;
  while (text.size() >= block) {
    unsigned char found = 0;
    for (std::size_t i = 0; i < block; ++i) found = static_cast<unsigned char>(found + (text[i] == wanted ? 1 : 0));
    count += found;
    text.remove_prefix(block);
  }
  return count + static_cast<std::size_t>(std::ranges::count(text, wanted));
}

}  // namespace

std::vector<Piece> cut(const Tokens& whole, std::size_t piece_bytes, const core::WorkControl& control) {
  const std::string_view text = whole.text();
  std::vector<Piece> pieces(1);
  while (text.size() - pieces.back().begin > piece_bytes) {
    const std::size_t end = next_command_line(whole, pieces.back().begin + piece_bytes);
    if (end == text.size()) break;
    pieces.back().end = end;
    pieces.push_back({end});
  }
  pieces.back().end = text.size();
  std::vector<std::size_t> lines(pieces.size());
  core::parallel_ranges(pieces.size(), 1, control, [&](std::size_t i, std::size_t) {
    lines[i] = count_of(whole.line_end(), text.substr(pieces[i].begin, pieces[i].end - pieces[i].begin));
  });
  for (std::size_t i = 1; i < pieces.size(); ++i)
    pieces[i].first_line = pieces[i - 1].end_line = pieces[i - 1].first_line + lines[i - 1];
  return pieces;
}

}  // namespace sarsim::scene::script
