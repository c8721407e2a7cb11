#include "raster/format/text_start.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/letters.hpp"
#include "core/text/missing_word.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::raster {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

TextScanner scanner_at_start(const core::InputFile& file) {
  std::array<char, 3> begin{};
  const std::size_t got = file.read_at(0, std::as_writable_bytes(std::span(begin)));
  const bool marked = std::string_view(begin.data(), got) == byte_order_mark;
  return {file, marked ? byte_order_mark.size() : 0U, 1};
}

// A value that is missing, not finite or in quotes: of samples, whose reader refuses it, and not of a line of names.
bool is_no_sample(std::string_view token) {
  const bool quoted =
      token.size() >= 2 && (token.front() == '"' || token.front() == '\'') && token.ends_with(token.front());
  if (quoted) token = core::trimmed(token.substr(1, token.size() - 2));
  return (quoted && core::parse_number(token)) || core::is_missing_word(token);
}

bool is_name(const std::string& token) {
  const char c = token.empty() ? '0' : token.front();
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '"' || c == '#';
}

// A header is a first line none of whose fields is a number and whose first field is a name.
// @param scanner  at the first line
bool is_at_header(const TextScanner& scanner, const core::InputFile& file) {
  TextScanner ahead(file, scanner.offset(), scanner.line());
  std::string token;
  TextNumber number;
  bool first = true;
  for (int c = ahead.peek(); c != TextScanner::end && c != '\n'; c = ahead.peek()) {
    if (c == ',' || c == '(' || c == ')') {
      ahead.advance();
      continue;
    }
    if (ahead.take_number(number, token) || is_no_sample(token) || (first && !is_name(token))) return false;
    first = false;
    ahead.skip_blanks();
  }
  return !first;
}

void skip_header(TextScanner& scanner, const core::InputFile& file) {
  scanner.skip_white_space();
  if (is_at_header(scanner, file)) scanner.skip_line();
}

}  // namespace

TextStyle style_of_text(const core::InputFile& file) {
  std::vector<char> begin(4096);
  begin.resize(file.read_at(0, std::as_writable_bytes(std::span(begin))));
  const auto control = [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 0x20 && !(code >= '\t' && code <= '\r')) || code == 0x7F;
  };
  if (std::ranges::any_of(begin, control)) return TextStyle::none;
  std::string_view text(begin.data(), begin.size());
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const std::size_t start = text.find_first_not_of(" \t\r\n\v\f");
  if (start == std::string_view::npos) return TextStyle::lines;
  text.remove_prefix(start);
  if (text.starts_with('(')) return TextStyle::brackets;
  return text.substr(0, text.find('\n')).find(',') != std::string_view::npos ? TextStyle::commas : TextStyle::lines;
}

TextScanner scanner_at_samples(const core::InputFile& file, TextStyle style) {
  TextScanner scanner = scanner_at_start(file);
  if (style == TextStyle::commas) skip_header(scanner, file);
  return scanner;
}

std::optional<std::string> line_of_names(const core::InputFile& file) {
  TextScanner scanner = scanner_at_start(file);
  scanner.skip_white_space();
  if (!is_at_header(scanner, file)) return std::nullopt;
  std::string line;
  for (int c = scanner.peek(); c != TextScanner::end && c != '\n'; c = scanner.peek()) {
    line += static_cast<char>(c);
    scanner.advance();
  }
  return line;
}

}  // namespace sarsim::raster
