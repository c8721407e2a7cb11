#include "scene/ephemeris/json_records.hpp"

#include <algorithm>
#include <charconv>

#include "core/text/letters.hpp"
#include "core/text/utf8.hpp"
#include "scene/ephemeris/text_lines.hpp"

namespace sarsim::scene::ephemeris {

JsonRecords::JsonRecords(std::string_view text, FileProblems& problems)
    : rest_(without_mark(text)), problems_(problems) {}

JsonEvent JsonRecords::fail(const char* message, const char* expected) {
  part_ = Part::done;
  problems_.error(rest_, {message, core::clipped(rest_.substr(0, std::min(rest_.find('\n'), std::size_t{30}))),
                          expected, rest_.empty() ? "the file may be cut off" : ""});
  return JsonEvent::end;
}

void JsonRecords::skip_blanks() {
  while (!rest_.empty() && core::is_blank(rest_.front())) rest_.remove_prefix(1);
}

bool JsonRecords::take(char c) {
  skip_blanks();
  if (!rest_.starts_with(c)) return false;
  rest_.remove_prefix(1);
  return true;
}

bool JsonRecords::take_code(std::uint32_t& code) {
  if (rest_.size() < 4) return false;
  const auto [stop, error] = std::from_chars(rest_.data(), rest_.data() + 4, code, 16);
  if (error != std::errc{} || stop != rest_.data() + 4) return false;
  rest_.remove_prefix(4);
  return true;
}

// What follows a backslash.
bool JsonRecords::take_escape(std::string& value) {
  constexpr std::string_view letters = "\"\\/bfnrt";
  constexpr std::string_view characters = "\"\\/\b\f\n\r\t";
  if (rest_.empty()) return false;
  const char letter = rest_.front();
  rest_.remove_prefix(1);
  if (const std::size_t i = letters.find(letter); i != std::string_view::npos) {
    value += characters[i];
    return true;
  }
  std::uint32_t code = 0;
  if (letter != 'u' || !take_code(code)) return false;
  if (code >= 0xD800 && code < 0xDC00 && rest_.starts_with("\\u")) {
    std::uint32_t low = 0;
    rest_.remove_prefix(2);
    if (!take_code(low) || low < 0xDC00 || low >= 0xE000) return false;
    code = 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00);
  }
  if (!core::is_character(code)) return false;
  core::append_utf8(value, code);
  return true;
}

bool JsonRecords::take_string(std::string& value) {
  value.clear();
  if (!take('"')) return false;
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find_first_of("\"\\\n"), rest_.size());
    value += rest_.substr(0, end);
    rest_.remove_prefix(end);
    if (rest_.empty() || rest_.front() == '\n') return false;
    const bool closed = rest_.front() == '"';
    rest_.remove_prefix(1);
    if (closed) return true;
    if (!take_escape(value)) return false;
  }
  return false;
}

// An array or object within an object, without a look at its grammar.
bool JsonRecords::take_nested() {
  std::size_t depth = 0;
  std::string unused;
  while (!rest_.empty()) {
    const std::size_t next = std::min(rest_.find_first_of("[]{}\""), rest_.size());
    rest_.remove_prefix(next);
    if (rest_.empty()) return false;
    if (rest_.front() == '"') {
      if (!take_string(unused)) return false;
      continue;
    }
    const bool opens = rest_.front() == '[' || rest_.front() == '{';
    rest_.remove_prefix(1);
    depth = opens ? depth + 1 : depth - 1;
    if (depth == 0) return true;
  }
  return false;
}

bool JsonRecords::take_value() {
  skip_blanks();
  member_.value.clear();
  member_.at = rest_;
  if (rest_.empty()) return false;
  if (rest_.front() == '"') return take_string(member_.value);
  if (rest_.front() == '[' || rest_.front() == '{') return take_nested();
  const std::size_t end = std::min(rest_.find_first_of(",]}[{\" \t\r\n"), rest_.size());
  const std::string_view word = rest_.substr(0, end);
  if (word.empty()) return false;
  const bool number = core::is_digit(word.front()) || word.front() == '-';
  if (!number && word != "null" && word != "true" && word != "false") return false;
  if (number) member_.value = word;
  rest_.remove_prefix(end);
  return true;
}

JsonEvent JsonRecords::open_object() {
  at_ = rest_;
  if (!take('{')) return fail("an object of JSON is missing", "{");
  part_ = Part::members;
  first_ = true;
  return JsonEvent::open;
}

JsonEvent JsonRecords::next_object() {
  const bool done = in_array_ ? take(']') : !first_;
  if (done) {
    skip_blanks();
    if (!rest_.empty()) return fail("unexpected text after the end of the JSON", "the end of the file");
    part_ = Part::done;
    return JsonEvent::end;
  }
  if (in_array_ && !first_ && !take(',')) return fail("the array is not closed", "a comma or ]");
  skip_blanks();
  return open_object();
}

JsonEvent JsonRecords::next_member() {
  if (take('}')) {
    part_ = Part::objects;
    first_ = false;
    return JsonEvent::close;
  }
  if (!first_ && !take(',')) return fail("the object is not closed", "a comma or }");
  first_ = false;
  if (!take_string(member_.key)) return fail("the name of a member is missing", "a string in quotes");
  if (!take(':')) return fail("the value of a member is missing", "a colon");
  if (!take_value()) return fail("the value of a member is not JSON", "a string, a number, null, true or false");
  return JsonEvent::member;
}

JsonEvent JsonRecords::next() {
  if (part_ == Part::begin) {
    in_array_ = take('[');
    part_ = Part::objects;
  }
  if (part_ == Part::objects) return next_object();
  return part_ == Part::members ? next_member() : JsonEvent::end;
}

}  // namespace sarsim::scene::ephemeris
