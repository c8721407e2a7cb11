#include "scene/script/tokens.hpp"

#include <algorithm>
#include <array>
#include <atomic>

namespace sarsim::scene::script {

namespace {

// Bytes that end a word, as a table: this is the innermost loop of reading.
constexpr std::array<bool, 256> make_word_ends() {
  std::array<bool, 256> ends{};
  for (const char c : {' ', '\t', ',', '\r', '\n', '!'}) ends[static_cast<unsigned char>(c)] = true;
  return ends;
}
constexpr std::array<bool, 256> word_ends = make_word_ends();

constexpr std::size_t control_block = 256;
constexpr char end_of_file_mark = 0x1A;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view without_end_marks(std::string_view text) {
  while (!text.empty() && text.back() == end_of_file_mark) text.remove_suffix(1);
  return text;
}

constexpr bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 && c != '\t' && c != '\n' && c != '\r';
}

// Of whole blocks, without branches, so that it is done on many bytes at once.
bool holds_control(const char* block) {
  unsigned char any = 0;
  for (std::size_t i = 0; i < control_block; ++i) {
    const auto byte = static_cast<unsigned char>(block[i]);
    const bool allowed = (byte >= 0x20) | (byte == '\t') | (byte == '\n') | (byte == '\r');
    any = static_cast<unsigned char>(any | static_cast<unsigned char>(!allowed));
  }
  return any != 0;
}

std::size_t find_control_within(std::string_view text, std::size_t begin, std::size_t end) {
  while (end - begin >= control_block && !holds_control(text.data() + begin)) begin += control_block;
  for (; begin < end; ++begin)
    if (is_control(text[begin])) return begin;
  return std::string_view::npos;
}

}  // namespace

std::string name_text(const Token& token) {
  if (!token.doubled_quotes) return std::string(token.text);
  std::string name;
  for (std::size_t i = 0; i < token.text.size(); ++i) {
    name += token.text[i];
    if (token.text[i] == '"') ++i;
  }
  return name;
}

std::string quoted_where_needed(std::string_view name) {
  const bool plain = !name.empty() && name.front() != '"' && name.front() != '$' &&
                     std::ranges::none_of(name, [](char c) { return word_ends[static_cast<unsigned char>(c)]; });
  if (plain) return std::string(name);
  std::string quoted = "\"";
  for (const char c : name) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  return quoted + '"';
}

std::size_t find_control_byte(std::string_view text, const core::WorkControl& control) {
  constexpr std::size_t range_bytes = std::size_t{1} << 20;
  text = without_end_marks(text);
  std::atomic<std::size_t> first{std::string_view::npos};
  core::parallel_ranges(text.size(), range_bytes, control, [&](std::size_t begin, std::size_t end) {
    const std::size_t found = find_control_within(text, begin, end);
    std::size_t known = first.load();
    while (found < known && !first.compare_exchange_weak(known, found)) {
    }
  });
  return first.load();
}

Token token_at(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  Token token;
  token.line = 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
  const std::size_t line_feed = before.rfind('\n');
  token.column = offset - (line_feed == std::string_view::npos ? 0 : line_feed + 1) + 1;
  return token;
}

Tokens::Tokens(std::string_view text) : text_(without_end_marks(text)) {
  if (text_.starts_with(byte_order_mark)) position_ = byte_order_mark.size();
  line_start_ = position_;
  if (text_.find('\n') == std::string_view::npos) line_end_ = '\r';
  scan();
}

Tokens Tokens::from_line(std::size_t offset, std::size_t line) const {
  Tokens tokens = *this;
  tokens.position_ = tokens.line_start_ = offset;
  tokens.line_ = line;
  tokens.scan();
  return tokens;
}

const Token& Tokens::pass() {
  ahead_ = 1 - ahead_;
  scan();
  return last();
}

void Tokens::skip_values() {
  while (peek().is_value()) scan();
}

void Tokens::skip_comment() { position_ = std::min(text_.find(line_end_, position_), text_.size()); }

void Tokens::skip_separators() {
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (c == '!') {
      skip_comment();
      continue;
    }
    if (!is_separator(c)) return;
    ++position_;
    if (c == line_end_) {
      ++line_;
      line_start_ = position_;
    }
  }
}

Token& Tokens::begin_token(TokenKind kind, std::size_t start) {
  Token& token = slots_[ahead_];
  token.line = line_;
  token.column = start - line_start_ + 1;
  token.kind = kind;
  token.text = {};
  token.comment_follows = token.open_quote = token.doubled_quotes = false;
  return token;
}

void Tokens::scan() {
  skip_separators();
  if (position_ == text_.size()) {
    begin_token(TokenKind::end, position_);
    return;
  }
  if (text_[position_] == '$') return scan_command();
  if (text_[position_] == '"') return scan_quoted();
  return scan_word(TokenKind::word, position_);
}

void Tokens::scan_word(TokenKind kind, std::size_t start) {
  Token& token = begin_token(kind, start);
  std::size_t end = position_;
  while (end < text_.size() && !word_ends[static_cast<unsigned char>(text_[end])]) ++end;
  token.text = text_.substr(position_, end - position_);
  token.comment_follows = end > position_ && end < text_.size() && text_[end] == '!';
  position_ = end;
}

void Tokens::scan_quoted() {
  Token& token = begin_token(TokenKind::quoted, position_);
  const std::size_t begin = ++position_;
  while (position_ < text_.size() && text_[position_] != '\n' && text_[position_] != '\r') {
    if (text_[position_] == '"') {
      if (position_ + 1 == text_.size() || text_[position_ + 1] != '"') break;
      token.doubled_quotes = true;
      ++position_;
    }
    ++position_;
  }
  token.text = text_.substr(begin, position_ - begin);
  token.open_quote = position_ == text_.size() || text_[position_] != '"';
  if (!token.open_quote) ++position_;
}

void Tokens::scan_command() {
  const std::size_t start = position_;
  while (position_ < text_.size() && text_[position_] != line_end_ &&
         (text_[position_] == '$' || is_separator(text_[position_])))
    ++position_;
  return scan_word(TokenKind::command, start);
}

}  // namespace sarsim::scene::script
