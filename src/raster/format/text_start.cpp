#include "raster/format/text_start.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

TextScanner scanner_at_start(const core::InputFile& file) {
  std::array<char, 3> begin{};
  const std::size_t got = file.read_at(0, std::as_writable_bytes(std::span(begin)));
  const bool marked = std::string_view(begin.data(), got) == byte_order_mark;
  return {file, marked ? byte_order_mark.size() : 0U, 1};
}

// A value that is not finite: of samples, whose reader refuses it, and not of a line of names.
bool is_not_finite(std::string_view token) {
  if (token.starts_with('+') || token.starts_with('-')) token.remove_prefix(1);
  const std::string word = core::lower_case(token);
  return word == "nan" || word == "inf" || word == "infinity";
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
    if (ahead.take_number(number, token) || is_not_finite(token) || (first && !is_name(token))) return false;
    first = false;
    ahead.skip_blanks();
  }
  return !first;
}

void skip_header(TextScanner& scanner, const core::InputFile& file) {
  scanner.skip_white_space();
  if (is_at_header(scanner, file)) scanner.skip_line();
}

// The name of a column without quotes, number and unit: "q" of "Q12 [V]".
std::string bare_name(std::string_view field) {
  const std::string word = core::lower_case(core::trimmed(field));
  const std::size_t begin = std::min(word.find_first_not_of("\"'# "), word.size());
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto end = std::find_if_not(word.begin() + static_cast<std::ptrdiff_t>(begin), word.end(), is_letter);
  return {word.begin() + static_cast<std::ptrdiff_t>(begin), end};
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool names_i(std::string_view name) { return is_one_of(name, {"i", "re", "real", "inphase"}); }
bool names_q(std::string_view name) { return is_one_of(name, {"q", "im", "imag", "imaginary", "quadrature"}); }

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

std::optional<core::Problem> problem_of_heading(const core::InputFile& file) {
  TextScanner scanner = scanner_at_start(file);
  scanner.skip_white_space();
  if (!is_at_header(scanner, file)) return std::nullopt;
  constexpr std::size_t longest = std::size_t{1} << 16U;
  std::string line(longest, '\0');
  line.resize(file.read_at(scanner.offset(), std::as_writable_bytes(std::span(line))));
  line.resize(std::min(line.find('\n'), line.size()));
  std::string_view rest = line;
  for (std::size_t column = 0; !rest.empty(); ++column) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string name = bare_name(rest.substr(0, comma));
    const bool second = column % 2 == 1;
    if (second ? names_i(name) : names_q(name))
      return file_problem(file.path().string(), "the headings of the columns are not those of I and Q in turn",
                          fmt::format("{:.40} above column {}", core::trimmed(rest.substr(0, comma)), column + 1),
                          second ? "Q" : "I", "exchange the columns, or correct the headings");
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return std::nullopt;
}

}  // namespace sarsim::raster
