#include "scene/language/format_mark.hpp"

#include <algorithm>
#include <cstddef>

#include "core/text/letters.hpp"

namespace sarsim::scene {

namespace {

// A key, perhaps in quotes or with dots, and an equals sign.
bool is_assignment(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos || equals == 0) return false;
  constexpr std::string_view signs = "_-.\"' \t";
  return std::ranges::all_of(line.substr(0, equals), [&](char c) {
    return core::is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || signs.find(c) != signs.npos;
  });
}

bool may_begin_format_2(std::string_view line) {
  return line.front() == '#' || line.front() == '[' || is_assignment(line);
}

// Whether `visit` is true of a line, without the blanks before it.
template <class Visit>
bool any_line(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (visit(line.substr(std::min(line.find_first_not_of(" \t"), line.size())))) return true;
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return false;
}

// Whether free text is followed by commands of the language of 1998.
bool holds_command(std::string_view text) {
  return any_line(text, [](std::string_view line) {
    return line.size() > 1 && line[0] == '$' && core::lower(line[1]) >= 'a' && core::lower(line[1]) <= 'z';
  });
}

}  // namespace

bool states_format(std::string_view text) {
  bool root = true;
  return any_line(text, [&](std::string_view line) {
    root = root && !line.starts_with('[');
    return root && (line.starts_with("format") || line.starts_with("\"format\"")) && is_assignment(line);
  });
}

bool is_format_2(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return false;
  text.remove_prefix(begin);
  if (!may_begin_format_2(text.substr(0, text.find('\n')))) return false;
  return states_format(text) || !holds_command(text);
}

}  // namespace sarsim::scene
