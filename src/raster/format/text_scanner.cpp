#include "raster/format/text_scanner.hpp"

#include <charconv>

#include "core/report/expect.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t scanner_buffer_bytes = std::size_t{1} << 16;

bool is_white(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool ends_token(int c) { return c == TextScanner::end || is_white(c) || c == ',' || c == '(' || c == ')'; }

// Exact for whole numbers of up to 20 digits; the others go through the general reader.
bool read_whole(std::string_view text, TextNumber& number) {
  number.negative = text.starts_with('-');
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const char* last = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), last, number.magnitude);
  if (error != std::errc{} || stop != last || text.empty()) return false;
  number.whole = true;
  number.value = number.negative ? -static_cast<double>(number.magnitude) : static_cast<double>(number.magnitude);
  return true;
}

}  // namespace

TextScanner::TextScanner(const core::InputFile& file, std::uint64_t offset, std::size_t line)
    : file_(file), buffer_(scanner_buffer_bytes), base_(offset), line_start_(offset), line_(line) {
  CORE_EXPECT(line >= 1);
}

bool TextScanner::fill() {
  base_ += next_;
  next_ = 0;
  filled_ = file_.read_at(base_, std::as_writable_bytes(std::span(buffer_)));
  return filled_ > 0;
}

void TextScanner::skip_more_blanks() {
  for (int c = peek(); is_white(c) && c != '\n'; c = peek()) advance();
}

std::size_t TextScanner::skip_more_white_space() {
  std::size_t lines = 0;
  for (int c = peek(); is_white(c); c = peek()) {
    lines += c == '\n' ? 1 : 0;
    advance();
  }
  return lines;
}

void TextScanner::skip_line() {
  int c = peek();
  for (; c != end && c != '\n'; c = peek()) advance();
  if (c == '\n') advance();
}

std::string TextScanner::take_token() {
  std::string token;
  for (int c = peek(); !ends_token(c) && token.size() < longest_token; c = peek()) {
    token += static_cast<char>(c);
    advance();
  }
  return token;
}

// A whole number of few digits, as nearly all are, that the buffer holds with the end of its token.
bool TextScanner::take_short_number(TextNumber& number) {
  constexpr std::ptrdiff_t max_digits = 19;  // Of any that 64 bits hold.
  if (peek() == end) return false;
  const char* at = buffer_.data() + next_;
  const char* const last = buffer_.data() + filled_;
  const bool negative = *at == '-';
  if (negative || *at == '+') ++at;
  const char* const digits = at;
  std::uint64_t magnitude = 0;
  for (; at < last && *at >= '0' && *at <= '9' && at - digits < max_digits; ++at)
    magnitude = 10 * magnitude + static_cast<std::uint64_t>(*at - '0');
  if (at == digits || at == last || !ends_token(static_cast<unsigned char>(*at))) return false;
  const auto value = static_cast<double>(magnitude);
  number = {true, negative, magnitude, negative ? -value : value};
  next_ = static_cast<std::size_t>(at - buffer_.data());
  return true;
}

bool TextScanner::take_number(TextNumber& number, std::string& token) {
  if (take_short_number(number)) return true;
  token.clear();
  for (int c = peek(); !ends_token(c) && token.size() < longest_token; c = peek()) {
    token += static_cast<char>(c);
    ++next_;  // No line feed can stand here.
  }
  number = {};
  if (read_whole(token, number)) return true;
  const auto value = token.size() < longest_token ? core::parse_number(token) : std::nullopt;
  if (!value) return false;
  number.whole = false;
  number.value = *value;
  return true;
}

}  // namespace sarsim::raster
