#include "core/toml/scan.hpp"

#include "core/text/letters.hpp"

namespace sarsim::core::toml {

namespace {

// Length of the UTF-8 sequence that begins with a byte beyond ASCII; 0 where it is none: overlong, a surrogate, beyond
// U+10FFFF or cut off.
std::size_t sequence_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(byte_at(text, at + i)); };
  const unsigned first = byte(0);
  const std::size_t length = first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3 : 4;
  if (first < 0xC2 || first > 0xF4) return 0;
  // Only the second byte's range depends on the first one.
  const unsigned lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < lowest || byte(1) > highest) return 0;
  for (std::size_t i = 2; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  return length;
}

Escape read_unicode_escape(std::string_view text, std::size_t at, std::size_t digits) {
  char32_t character = 0;
  for (std::size_t i = 0; i < digits; ++i) {
    const char c = lower(byte_at(text, at + 2 + i));
    const bool letter = c >= 'a' && c <= 'f';
    if (!letter && !is_digit(c)) return {};
    character = 16 * character + static_cast<char32_t>(letter ? c - 'a' + 10 : c - '0');
  }
  if (character > 0x10FFFF || (character >= 0xD800 && character < 0xE000)) return {};
  return {2 + digits, character, false};
}

std::size_t find_closing(std::string_view text, std::size_t at, const Quotes& quotes, char quote) {
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\\' && quotes.basic && byte_at(text, at + 1) != '\n') {
      ++at;
    } else if (c == '\n' && !quotes.triple) {
      return std::string_view::npos;
    } else if (c == quote) {
      if (!quotes.triple) return at;
      if (byte_at(text, at + 1) == quote && byte_at(text, at + 2) == quote) return at;
    }
  }
  return std::string_view::npos;
}

// Four digits and a hyphen: "6.6e-34" has only the hyphen.
bool looks_like_date(std::string_view word) {
  return word.size() > 4 && word[4] == '-' && std::ranges::all_of(word.substr(0, 4), is_digit);
}

}  // namespace

std::size_t line_feed(std::string_view text, std::size_t at) { return std::min(text.find('\n', at), text.size()); }

Escape read_escape(std::string_view text, std::size_t at, bool multi_line) {
  switch (byte_at(text, at + 1)) {
    case 'b': return {2, '\b', false};
    case 't': return {2, '\t', false};
    case 'n': return {2, '\n', false};
    case 'f': return {2, '\f', false};
    case 'r': return {2, '\r', false};
    case '"': return {2, '"', false};
    case '\\': return {2, '\\', false};
    case 'u': return read_unicode_escape(text, at, 4);
    case 'U': return read_unicode_escape(text, at, 8);
    default: break;
  }
  std::size_t end = skip(text, at + 1, blank_byte);
  if (!multi_line || line_end_length(text, end) == 0) return {};
  while (line_end_length(text, end) != 0) end = skip(text, end + line_end_length(text, end), blank_byte);
  return {end - at, 0, true};
}

Quotes read_quotes(std::string_view text, std::size_t at, bool may_be_triple) {
  const char quote = byte_at(text, at);
  Quotes quotes;
  quotes.basic = quote == '"';
  quotes.triple = may_be_triple && byte_at(text, at + 1) == quote && byte_at(text, at + 2) == quote;
  std::size_t begin = at + (quotes.triple ? 3 : 1);
  if (quotes.triple) begin += line_end_length(text, begin);
  std::size_t closing = find_closing(text, begin, quotes, quote);
  if (closing == std::string_view::npos) return quotes;
  // Of five quotes in a row the last three close.
  for (int i = 0; i < 2 && quotes.triple && byte_at(text, closing + 3) == quote; ++i) ++closing;
  quotes.inner = span_of(begin, closing);
  quotes.end = closing + (quotes.triple ? 3 : 1);
  return quotes;
}

std::size_t key_part_end(std::string_view text, std::size_t at) {
  const char c = byte_at(text, at);
  if (c != '"' && c != '\'') return skip(text, at, bare_byte);
  const std::size_t end = read_quotes(text, at, false).end;
  return end == 0 ? at : end;
}

std::size_t key_end(std::string_view text, std::size_t at) {
  std::size_t end = at;
  for (std::size_t part = at;;) {
    const std::size_t part_end = key_part_end(text, part);
    if (part_end == part) return at;
    end = part_end;
    const std::size_t dot = skip(text, end, blank_byte);
    if (byte_at(text, dot) != '.') return end;
    part = skip(text, dot + 1, blank_byte);
  }
}

std::size_t scalar_end(std::string_view text, std::size_t at) {
  constexpr std::size_t date_length = 10;
  const std::size_t end = skip(text, at, scalar_byte);
  // A blank may part a date from its time.
  const bool time_follows = byte_at(text, end) == ' ' && is_digit(byte_at(text, end + 1)) &&
                            is_digit(byte_at(text, end + 2)) && byte_at(text, end + 3) == ':';
  if (end != at + date_length || !time_follows || !looks_like_date(text.substr(at, end - at))) return end;
  return skip(text, end + 1, scalar_byte);
}

Kind scalar_kind(std::string_view word) {
  constexpr std::size_t date_length = 10;
  if (word.starts_with('t') || word.starts_with('f')) return Kind::boolean;
  if (word.starts_with("0x") || word.starts_with("0o") || word.starts_with("0b")) return Kind::integer;
  if (word.size() > 2 && word[2] == ':') return Kind::local_time;
  if (looks_like_date(word)) {
    if (word.size() <= date_length) return Kind::local_date;
    const bool offset = word.find_first_of("Zz+-", date_length) != std::string_view::npos;
    return offset ? Kind::offset_date_time : Kind::local_date_time;
  }
  for (const char c : word)
    if (c == '.' || c == 'e' || c == 'E' || c == 'n') return Kind::floating;
  return Kind::integer;
}

std::size_t bracket_end(std::string_view text, std::size_t at) {
  std::size_t depth = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (!is(c, bracket_byte)) continue;
    if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      if (depth <= 1) return at + 1;
      --depth;
    } else if (c == '#') {
      at = line_feed(text, at);
    } else {
      const std::size_t end = read_quotes(text, at, true).end;
      if (end == 0) return text.size();
      at = end - 1;
    }
  }
  return text.size();
}

std::optional<Span> find_forbidden(std::string_view text, Span span, bool basic, bool lines) {
  const std::string_view part = text.substr(0, span.end);
  for (std::size_t at = span.begin;;) {
    while (at < part.size() && is(part[at], plain_byte) && (part[at] != '\\' || !basic)) ++at;
    if (at >= part.size()) return std::nullopt;
    const bool beyond_ascii = static_cast<unsigned char>(part[at]) >= 0x80;
    const std::size_t length = beyond_ascii       ? sequence_length(part, at)
                               : part[at] == '\\' ? read_escape(part, at, lines).length
                               : lines            ? line_end_length(part, at)
                                                  : 0;
    if (length == 0) return span_of(at, at + (part[at] == '\\' && at + 1 < part.size() ? 2 : 1));
    at += length;
  }
}

}  // namespace sarsim::core::toml
