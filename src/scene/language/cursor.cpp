#include "scene/language/cursor.hpp"

#include <algorithm>
#include <optional>

#include "core/text/letters.hpp"
#include "core/toml/scan.hpp"
#include "core/toml/values.hpp"
#include "scene/schema/quantity.hpp"
#include "scene/schema/unit_source.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene::language {

namespace toml = core::toml;

namespace {

std::string path_below(const std::string& table, std::string_view name) {
  return table.empty() ? std::string(name) : table + "." + std::string(name);
}

bool is_blank_rest(std::string_view rest) {
  rest = core::trimmed(rest);
  return rest.empty() || rest.front() == '#';
}

// The name within the brackets of a line that is a header and nothing else. Only such as begin with a letter: an array
// may have rows like ["x"].
std::optional<std::string_view> header_name(std::string_view line) {
  line = core::trimmed(line);
  if (!line.starts_with('[')) return std::nullopt;
  const std::string_view closing = line.starts_with("[[") ? "]]" : "]";
  const std::size_t begin = toml::skip(line, closing.size(), toml::blank_byte);
  if (!begins_word(toml::byte_at(line, begin))) return std::nullopt;
  const std::size_t end = toml::key_end(line, begin);
  const std::string_view rest = line.substr(toml::skip(line, end, toml::blank_byte));
  if (!rest.starts_with(closing) || !is_blank_rest(rest.substr(closing.size()))) return std::nullopt;
  return line.substr(begin, end - begin);
}

// A header that is being typed.
struct HeaderText {
  toml::Span all;         // from its first bracket to its last, or to what there is of it
  toml::Span name;        // without blanks at its ends
  std::size_t inner = 0;  // behind the opening brackets
  bool complete = false;
};

// @param line   begins with a bracket
// @param begin  of the line, in the text
HeaderText header_text(std::string_view line, std::size_t begin) {
  const std::string_view closing = line.starts_with("[[") ? "]]" : "]";
  HeaderText header;
  header.complete = header_name(line).has_value();
  header.inner = begin + closing.size();
  const std::string_view open = line.substr(0, line.find(header.complete ? closing : "#"));
  const std::string_view name = core::trimmed(open.substr(std::min(closing.size(), open.size())));
  const std::size_t name_begin =
      name.empty() ? header.inner : begin + static_cast<std::size_t>(name.data() - line.data());
  header.name = toml::span_of(name_begin, name_begin + name.size());
  const std::size_t end = header.complete ? open.size() + closing.size() : core::trimmed(open).size();
  header.all = toml::span_of(begin, std::max(begin + end, header.inner));
  return header;
}

// Where reading goes on after a bracket that is not closed.
bool is_header_or_assignment(std::string_view line) {
  if (header_name(line)) return true;
  const std::size_t begin = toml::skip(line, 0, toml::blank_byte);
  const std::size_t end = toml::key_end(line, begin);
  return end > begin && toml::byte_at(line, toml::skip(line, end, toml::blank_byte)) == '=';
}

// Begin of the object that a byte stands in, by the headers of the lines up to it.
std::size_t object_begin(std::string_view text, std::size_t offset) {
  for (std::size_t end = toml::line_feed(text, offset);;) {
    const std::size_t feed = end == 0 ? std::string_view::npos : text.rfind('\n', end - 1);
    const std::size_t begin = feed == std::string_view::npos ? 0 : feed + 1;
    if (begin == 0 || begins_object(text.substr(begin, end - begin))) return begin;
    end = feed;
  }
}

// Reads an object from its header to the next one, and notes what stands at a place on the way.
class CursorScan {
 public:
  CursorScan(std::string_view text, std::size_t offset)
      : text_(text), offset_(std::min(offset, text.size())), at_(object_begin(text, offset_)), begin_(at_) {}

  Cursor run() {
    if (at_ == 0 && text_.starts_with("\xEF\xBB\xBF")) begin_ = at_ = 3;
    while (at_ <= text_.size() && !ended_) statement();
    return std::move(cursor_);
  }

 private:
  void statement();
  void header();
  void entry();
  std::string key(const std::string& table);
  void assigned(const std::string& path);
  void value(const std::string& path);
  void string(const std::string& path);
  void word(const std::string& path);
  void array(const std::string& path);
  bool space_in_array(const std::string& path, bool due);
  void table(const std::string& path);
  void comment();
  void end_line();

  [[nodiscard]] char here() const { return toml::byte_at(text_, at_); }
  [[nodiscard]] bool at_line_end() const { return at_ >= text_.size() || toml::line_end_length(text_, at_) > 0; }
  [[nodiscard]] std::size_t line_end() const {
    const std::size_t end = toml::line_feed(text_, at_);
    return end > at_ && text_[end - 1] == '\r' ? end - 1 : end;
  }
  void skip_blanks() { at_ = toml::skip(text_, at_, toml::blank_byte); }

  // The place is within [begin, end], and nothing was found there yet.
  bool found_in(std::size_t begin, std::size_t end, Site site) {
    if (found_ || offset_ < begin || offset_ > end) return false;
    found_ = true;
    cursor_.site = site;
    cursor_.rows = rows_;
    cursor_.word = toml::span_of(offset_, offset_);
    return true;
  }
  // The same before `end`, where nothing is typed yet.
  bool found_before(std::size_t begin, std::size_t end, Site site, const std::string& path) {
    if (end == begin || !found_in(begin, end - 1, site)) return false;
    (site == Site::key ? cursor_.table : cursor_.path) = path;
    return true;
  }
  // The key whose value begins here; null where that is at the place, or this an element of its array.
  KeyText* key_at(const std::string& path) {
    if (cursor_.said.empty()) return nullptr;
    KeyText& last = cursor_.said.back();
    return last.path == path && last.rows == rows_ ? &last : nullptr;
  }
  void found_word(std::size_t begin, std::size_t end) {
    cursor_.word = toml::span_of(begin, end);
    cursor_.typed = text_.substr(begin, offset_ - begin);
  }

  std::string_view text_;
  std::size_t offset_;
  std::size_t at_;
  std::size_t begin_;           // of the object
  std::size_t line_begin_ = 0;  // of the statement
  Cursor cursor_;
  std::string prefix_;  // path of the table of the last header
  std::vector<std::size_t> rows_;
  std::size_t depth_ = 0;
  bool found_ = false;
  bool lost_ = false;  // out of all brackets, at the begin of a line
  bool ended_ = false;
};

void CursorScan::statement() {
  line_begin_ = at_;
  skip_blanks();
  if (at_line_end()) {
    cursor_.alone = found_before(line_begin_, at_ + 1, Site::key, prefix_) || cursor_.alone;
  } else if (here() == '[') {
    header();
  } else if (here() != '#') {
    entry();
  }
  if (ended_ || lost_) {
    lost_ = false;
    return;
  }
  end_line();
}

// A comment and the end of the line.
void CursorScan::end_line() {
  skip_blanks();
  if (here() == '#') comment();
  const std::size_t end = toml::line_feed(text_, at_);
  found_before(at_, end + 1, Site::nothing, {});
  at_ = end + 1;
}

void CursorScan::comment() {
  const std::size_t end = toml::line_feed(text_, at_);
  if (offset_ > at_) found_in(at_, end, Site::comment);
  at_ = end;
}

void CursorScan::header() {
  const HeaderText header = header_text(text_.substr(at_, line_end() - at_), at_);
  std::vector<std::string> paths;  // of the name, part by part
  std::string upto;
  toml::Span rest = header.name;
  while (const auto part = toml::next_key_part(text_, rest)) {
    if (part->begin == part->end) break;
    paths.push_back(path_below(paths.empty() ? "" : paths.back(), toml::decoded_key_part(text_, *part)));
    if (upto.empty() || part->begin <= offset_) upto = paths.back();
  }
  const bool is_dotted = paths.size() > 1;
  const bool is_first = line_begin_ == begin_ || (cursor_.kind.empty() && is_dotted);
  if (is_first && !paths.empty()) cursor_.kind = paths.front();
  ended_ = !is_first && header.complete && !is_dotted;
  if (ended_) return;
  const std::string below = is_dotted ? paths.back().substr(paths.front().size() + 1) : std::string();
  if (at_ < offset_ && found_in(at_, header.all.end, Site::header)) {
    cursor_.path = upto;
    cursor_.complete = header.complete;
    cursor_.word = header.all;
    cursor_.typed = core::trimmed(toml::piece(text_, toml::span_of(header.inner, std::max(offset_, header.inner))));
  } else if (is_dotted) {
    cursor_.said.push_back({below, {}});
  }
  if (header.complete) prefix_ = below;
  at_ = header.all.end;
}

// A key, dotted perhaps, up to its equals sign. Returns its path.
std::string CursorScan::key(const std::string& table) {
  const bool was_found = found_;
  std::string path = table;
  for (bool more = true; more;) {
    const std::size_t begin = at_;
    const std::size_t end = toml::key_part_end(text_, begin);
    const std::string name = toml::decoded_key_part(text_, toml::span_of(begin, end));
    if (found_in(begin, end, Site::key)) {
      cursor_.table = path;
      cursor_.path = path_below(path, name);
      found_word(begin, end);
    }
    path = path_below(path, name);
    at_ = toml::skip(text_, end, toml::blank_byte);
    more = here() == '.';
    if (!more) at_ = end;
    if (more) {
      ++at_;
      const std::size_t behind = at_;
      skip_blanks();
      found_before(behind, at_, Site::key, path);
    }
  }
  const bool is_here = found_ && !was_found;
  const std::size_t behind = at_;
  skip_blanks();
  found_before(behind, at_, Site::nothing, {});
  if (is_here)
    cursor_.complete = here() == '=';
  else
    cursor_.said.push_back({path, {}, rows_});
  return path;
}

void CursorScan::entry() {
  const std::size_t begin = at_;
  const bool was_found = found_;
  const std::string path = key(prefix_);
  if (here() != '=') {
    const bool is_here = found_ && !was_found && cursor_.site == Site::key;
    if (is_here) cursor_.alone = cursor_.table == prefix_ && at_line_end();
    if (at_ == begin) ++at_;
    found_before(at_, line_end(), Site::nothing, {});
    at_ = line_end();
    return;
  }
  assigned(path);
}

// An equals sign and what follows.
void CursorScan::assigned(const std::string& path) {
  const std::size_t behind = ++at_;
  skip_blanks();
  const bool is_missing = at_line_end() || here() == '#' || here() == ',' || here() == '}';
  found_before(behind, at_ + (is_missing ? 1 : 0), Site::value, path);
  if (!is_missing) value(path);
}

void CursorScan::value(const std::string& path) {
  const char c = here();
  if (c == '"' || c == '\'') return string(path);
  if ((c == '[' || c == '{') && depth_ < toml::deepest_nesting) {
    ++depth_;
    c == '[' ? array(path) : table(path);
    --depth_;
    return;
  }
  word(path);
}

void CursorScan::string(const std::string& path) {
  const toml::Quotes quotes = toml::read_quotes(text_, at_, true);
  const bool closed = quotes.end > 0;
  const std::size_t begin = closed ? quotes.inner.begin : at_ + 1;
  const std::size_t end = closed ? quotes.inner.end : std::max(begin, line_end());
  if (found_in(begin, end, Site::string)) {
    cursor_.path = path;
    cursor_.complete = closed;
    found_word(begin, end);
  }
  if (KeyText* const key = key_at(path)) key->word = text_.substr(begin, end - begin);
  at_ = closed ? quotes.end : end;
}

void CursorScan::word(const std::string& path) {
  const std::size_t begin = at_;
  at_ = std::min(text_.find_first_of(" \t\r\n,[]{}#", begin), text_.size());
  if (at_ == begin && !at_line_end()) ++at_;
  if (found_in(begin, at_, Site::value)) {
    cursor_.path = path;
    found_word(begin, at_);
  }
  if (KeyText* const key = key_at(path)) key->word = text_.substr(begin, at_ - begin);
}

void CursorScan::array(const std::string& path) {
  ++at_;
  rows_.push_back(0);
  bool due = false;  // a comma
  while (!lost_ && space_in_array(path, due)) {
    if (here() == ']') {
      ++at_;
      break;
    }
    if (here() == ',') {
      ++at_;
      ++rows_.back();
      due = false;
      continue;
    }
    value(path);
    due = true;
  }
  rows_.pop_back();
}

// Blanks, lines and comments; false at the end of the text, or where the array is not closed.
bool CursorScan::space_in_array(const std::string& path, bool due) {
  const Site site = due ? Site::nothing : Site::value;
  for (;;) {
    const std::size_t begin = at_;
    skip_blanks();
    const bool is_end = at_line_end() || here() == '#' || here() == ']' || here() == ',';
    found_before(begin, at_ + (is_end ? 1 : 0), site, path);
    if (here() == '#') comment();
    if (at_ >= text_.size()) {
      lost_ = true;
      at_ = text_.size() + 1;
      return false;
    }
    if (toml::line_end_length(text_, at_) == 0) return true;
    at_ = toml::line_feed(text_, at_) + 1;
    if (is_header_or_assignment(text_.substr(at_, toml::line_feed(text_, at_) - at_))) {
      lost_ = true;
      return false;
    }
  }
}

// An inline table, which ends with its line.
void CursorScan::table(const std::string& path) {
  ++at_;
  for (bool due = false; !lost_;) {
    const std::size_t begin = at_;
    skip_blanks();
    const bool is_open = at_line_end() || here() == '#';
    const bool is_end = is_open || here() == ',' || here() == '}';
    found_before(begin, at_ + (is_end ? 1 : 0), due ? Site::nothing : Site::key, path);
    if (is_open) return;
    if (here() == '}') {
      ++at_;
      return;
    }
    if (here() == ',') {
      ++at_;
      due = false;
      continue;
    }
    const std::size_t key_begin = at_;
    const std::string key_path = key(path);
    if (here() == '=')
      assigned(key_path);
    else if (at_ == key_begin)
      ++at_;
    due = true;
  }
}

// Where an expression's operand ends that begins at a place: a word, or a number with its unit.
std::size_t operand_end(std::string_view text, std::size_t at) {
  if (!begins_number(toml::byte_at(text, at))) return at + std::max<std::size_t>(word_at(text, at).size(), 1);
  const std::size_t end = at + std::max<std::size_t>(number_length(text.substr(at)), 1);
  const std::size_t unit = toml::skip(text, end, toml::blank_byte);
  const std::size_t length = word_at(text, unit).size();
  return length == 0 ? end : unit + length;
}

}  // namespace

bool begins_object(std::string_view line) {
  const auto name = header_name(line);
  return name && name->find('.') == std::string_view::npos;
}

Cursor cursor_at(std::string_view text, std::size_t offset) { return CursorScan(text, offset).run(); }

std::size_t piece_end(std::string_view line, std::size_t offset) {
  if (header_name(line) && toml::byte_at(line, offset) == '[') return line.rfind(']', line.find('#')) + 1;
  for (std::size_t at = 0; at < line.size() && at <= offset;) {
    const char c = line[at];
    if (c == '#') break;
    if (c == '"' || c == '\'') {
      const toml::Quotes quotes = toml::read_quotes(line, at, true);
      const std::size_t end = quotes.end > 0 ? quotes.end : line.size();
      const std::size_t inner_end = quotes.end > 0 ? quotes.inner.end : line.size();
      if (offset == at) return end;
      if (offset < inner_end) {
        const std::size_t operand = operand_end(line.substr(0, inner_end), offset);
        return offset == quotes.inner.begin ? inner_end : operand;
      }
      at = end;
      continue;
    }
    if (at == offset) {
      if (c == '[' || c == '{') return toml::bracket_end(line, at);
      const std::size_t key = toml::key_end(line, at);
      const std::size_t scalar = std::min(line.find_first_of(" \t,[]{}#=", at), line.size());
      return std::max({key, scalar, at + 1});
    }
    ++at;
  }
  return line.size();
}

}  // namespace sarsim::scene::language
