#include "core/toml/values.hpp"

#include <charconv>
#include <limits>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/utf8.hpp"
#include "core/toml/scalars.hpp"
#include "core/toml/scan.hpp"

namespace sarsim::core::toml {

namespace {

constexpr std::size_t npos = std::string_view::npos;

std::string decoded(std::string_view text, const Quotes& quotes) {
  const std::string_view inner = text.substr(0, quotes.inner.end);
  const std::string_view special = quotes.basic ? "\\\r" : "\r";
  std::string result;
  for (std::size_t at = quotes.inner.begin; at < inner.size();) {
    const std::size_t stop = std::min(inner.find_first_of(special, at), inner.size());
    result.append(inner, at, stop - at);
    at = stop;
    if (at == inner.size()) break;
    if (inner[at] == '\r') {
      if (line_end_length(inner, at) == 0) result += '\r';
      ++at;
      continue;
    }
    const Escape escape = read_escape(inner, at, quotes.triple);
    if (escape.length > 0 && !escape.line_break) append_utf8(result, escape.character);
    at += std::max<std::size_t>(escape.length, 1);
  }
  return result;
}

std::string without_underscores(std::string_view word) {
  std::string digits(word);
  std::erase(digits, '_');
  return digits;
}

// The end of any value; `at` itself where none begins.
std::size_t value_end(std::string_view text, std::size_t at, Kind& kind) {
  const char c = byte_at(text, at);
  if (c == '[' || c == '{') {
    kind = c == '[' ? Kind::array : Kind::table;
    return bracket_end(text, at);
  }
  if (c == '"' || c == '\'') {
    kind = Kind::string;
    const std::size_t end = read_quotes(text, at, true).end;
    return end == 0 ? at : end;
  }
  const std::size_t end = scalar_end(text, at);
  kind = scalar_kind(text.substr(at, end - at));
  return end;
}

// Behind blanks, commas, line ends and comments.
std::size_t skip_between(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_blank(text[at]) || text[at] == ',' || text[at] == '#'))
    at = text[at] == '#' ? line_feed(text, at) : at + 1;
  return at;
}

}  // namespace

Elements::Elements(std::string_view text, const Value& container) : keyed_(container.kind == Kind::table) {
  if (!keyed_ && container.kind != Kind::array) return;
  if (container.span.end > text.size() || container.span.end < container.span.begin + std::size_t{2}) return;
  text_ = text.substr(0, container.span.end - std::size_t{1});
  position_ = container.span.begin + std::size_t{1};
}

std::optional<Element> Elements::next() {
  Element element;
  std::size_t begin = skip_between(text_, position_);
  position_ = text_.size();  // Until all went well: a wrong text just ends.
  if (keyed_) {
    const std::size_t end = key_end(text_, begin);
    const std::size_t equals = skip(text_, end, blank_byte);
    if (end == begin || byte_at(text_, equals) != '=') return std::nullopt;
    element.key = span_of(begin, end);
    begin = skip(text_, equals + 1, blank_byte);
  }
  const std::size_t end = value_end(text_, begin, element.value.kind);
  if (end == begin) return std::nullopt;
  element.value.span = span_of(begin, end);
  position_ = end;
  return element;
}

std::string decoded_string(std::string_view text, const Value& value) {
  const std::string_view part = piece(text, value.span);
  if (value.kind != Kind::string || part.size() < 2) return {};
  return decoded(part, read_quotes(part, 0, true));
}

std::optional<Span> next_key_part(std::string_view text, Span& rest) {
  const std::string_view key = text.substr(0, rest.end);
  std::size_t begin = skip(key, rest.begin, blank_byte);
  if (byte_at(key, begin) == '.') begin = skip(key, begin + 1, blank_byte);
  const std::size_t end = key_part_end(key, begin);
  rest.begin = static_cast<std::uint32_t>(end);
  if (end == begin) return std::nullopt;
  return span_of(begin, end);
}

std::string decoded_key_part(std::string_view text, Span part) {
  const std::string_view typed = piece(text, part);
  if (!typed.starts_with('"') && !typed.starts_with('\'')) return std::string(typed);
  return decoded(typed, read_quotes(typed, 0, false));
}

std::vector<std::string> key_parts(std::string_view text, Span key) {
  std::vector<std::string> parts;
  while (const auto part = next_key_part(text, key)) parts.push_back(decoded_key_part(text, *part));
  return parts;
}

std::optional<double> number(std::string_view text, const Value& value) {
  if (const auto whole = integer(text, value)) return static_cast<double>(*whole);
  std::string_view word = piece(text, value.span);
  if (value.kind != Kind::floating || complaint_about(word, value.kind).message != nullptr) return std::nullopt;
  const bool negative = word.starts_with('-');
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (word.ends_with("nan")) return std::numeric_limits<double>::quiet_NaN();
  if (word.ends_with("inf")) return negative ? -infinity : infinity;
  std::string digits;
  if (word.find('_') != npos) word = digits = without_underscores(word);
  // A number in good form that is none for `parse_number` is too large for a double.
  return parse_number(word).value_or(negative ? -infinity : infinity);
}

std::optional<std::int64_t> integer(std::string_view text, const Value& value) {
  std::string_view word = piece(text, value.span);
  if (value.kind != Kind::integer) return std::nullopt;
  std::string digits;
  if (word.find('_') != npos) word = digits = without_underscores(word);
  const char letter = word.starts_with('0') ? byte_at(word, 1) : '\0';
  const int base = letter == 'x' ? 16 : letter == 'o' ? 8 : letter == 'b' ? 2 : 10;
  if (base == 10) return parse_integer(word);
  std::int64_t number = 0;
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data() + 2, last, number, base);
  if (error != std::errc{} || end != last || number < 0) return std::nullopt;
  return number;
}

std::optional<bool> boolean(std::string_view text, const Value& value) {
  const std::string_view word = piece(text, value.span);
  if (value.kind != Kind::boolean || (word != "true" && word != "false")) return std::nullopt;
  return word == "true";
}

std::optional<DateTime> date_time(std::string_view text, const Value& value) {
  if (value.kind < Kind::offset_date_time || value.kind > Kind::local_time) return std::nullopt;
  DateTime result;
  if (read_date_time(piece(text, value.span), value.kind, result).message != nullptr) return std::nullopt;
  return result;
}

}  // namespace sarsim::core::toml
