#include "core/toml/parse.hpp"

#include <optional>
#include <utility>

#include "core/text/letters.hpp"
#include "core/text/quoted_word.hpp"
#include "core/toml/lines.hpp"
#include "core/toml/names.hpp"
#include "core/toml/scan.hpp"
#include "core/toml/values.hpp"

namespace sarsim::core::toml {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// A mistake whose parts are literals.
struct Fault {
  Span at;
  Complaint complaint;
};

// How reading a part of a line went on.
enum class Course : std::uint8_t {
  on,     // it stands behind the part, which may hold mistakes of its own
  stuck,  // at a mistake, which is noted: who called skips what cannot be read
  lost,   // somewhere else: at the line where reading goes on outside of all brackets
};

struct Bracket {
  char opening;
  std::size_t at;
};

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text), names_(text) {}

  Document run();

 private:
  void line();
  void header();
  void begin_table(Span header, bool element, bool named);
  void entry();
  void end_line();
  void comment();

  bool key();
  void key_fault(std::size_t begin);
  Course assignment(Names::Node table, Entry& entry);
  Course value(Value& value);
  Course string(Value& value);
  Course unclosed_string();
  Course scalar(Value& value);
  Course no_value();
  Course array(Value& value);
  Course array_element(bool comma_due);
  Course table(Value& value);
  Course table_items(Names::Node node);
  bool line_end_in_table();
  Course open_bracket(char opening);
  Course close_bracket(Value& value);
  Course missing(const char* expected);
  Course unclosed();
  void skip_item(char closing);

  Course stumble(const Fault& fault);
  void note(const Fault& fault);
  void note(const Clash& clash, bool header, bool element);
  void check_text(Span span, bool basic, bool lines);
  [[nodiscard]] bool looks_like_line(std::size_t begin) const;
  void name_lines();

  [[nodiscard]] char here() const { return byte_at(text_, position_); }
  [[nodiscard]] bool at_end() const { return position_ >= text_.size(); }
  void skip_blanks() { position_ = skip(text_, position_, blank_byte); }
  void skip_space();
  bool skip_line_end();
  void skip_line() { position_ = std::min(line_feed(text_, position_) + 1, text_.size()); }
  // The rest of the line or the next 100 bytes of it, for messages: a line may be all of the text.
  [[nodiscard]] Span rest_of_line(std::size_t begin) const {
    return span_of(begin, line_feed(text_.substr(0, begin + 100), begin));
  }

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_begin_ = 0;  // of the line of position_
  Document document_;
  Names names_;
  Names::Node table_ = Names::root;
  std::optional<Names::Node> astray_;  // holds the entries of a broken header
  Names::Parts parts_;                 // of the key read last
  std::vector<Bracket> open_;
  std::size_t tested_line_ = 0;  // begins where a mistake was noted last
  bool swallowed_ = false;       // a mistake in these brackets may have swallowed the closing one
  struct Reference {
    std::size_t mistake;
    std::uint32_t first;
  };
  std::vector<Reference> references_;  // mistakes whose hint names the line of something
};

// ---- lines

Document Parser::run() {
  if (text_.starts_with(byte_order_mark)) position_ = byte_order_mark.size();
  document_.tables.push_back({span_of(position_, position_), span_of(position_, position_), false, false, 0, 0});
  while (!at_end() && document_.mistakes.size() < max_mistakes) line();
  name_lines();
  std::ranges::stable_sort(document_.mistakes, {}, [](const Mistake& mistake) { return mistake.at.begin; });
  return std::move(document_);
}

void Parser::line() {
  line_begin_ = position_;
  skip_blanks();
  if (here() == '[')
    header();
  else if (here() != '#' && line_end_length(text_, position_) == 0 && !at_end())
    entry();
  else
    end_line();
}

void Parser::header() {
  const std::size_t begin = position_;
  const bool element = byte_at(text_, begin + 1) == '[';
  const std::string_view closing = element ? "]]" : "]";
  position_ += closing.size();
  skip_blanks();
  const bool named = key();
  const bool closed = named && piece(text_, rest_of_line(position_)).starts_with(closing);
  if (closed) position_ += closing.size();
  if (named && !closed) note({rest_of_line(position_), {"header is not closed", closing.data(), ""}});
  begin_table(span_of(begin, position_), element, named);
  closed ? end_line() : skip_line();
}

// The table of the entries that follow; nobody knows which one behind a broken header.
void Parser::begin_table(Span header, bool element, bool named) {
  if (astray_) names_.drop(*std::exchange(astray_, std::nullopt));
  const auto clash = named ? names_.add_header(parts_, element, table_) : std::nullopt;
  if (clash) note(*clash, true, element);
  const bool broken = clash || !named;
  if (broken) astray_ = table_ = names_.begin_nameless();
  const Span name = named ? Span{parts_.front().begin, parts_.back().end} : Span{header.end, header.end};
  const auto first_entry = static_cast<std::uint32_t>(document_.entries.size());
  document_.tables.push_back({header, name, element, broken, first_entry, 0});
}

void Parser::entry() {
  const std::size_t mistakes = document_.mistakes.size();
  open_.clear();
  swallowed_ = false;
  Entry entry;
  const Course course = assignment(table_, entry);
  const auto is_right = [&] { return course == Course::on && document_.mistakes.size() == mistakes; };
  if (is_right())
    end_line();
  else if (course != Course::lost)
    skip_line();
  if (!is_right()) return;
  document_.entries.push_back(entry);
  ++document_.tables.back().entries;
}

// Behind the last thing of a line.
void Parser::end_line() {
  skip_blanks();
  if (here() == '#') comment();
  if (skip_line_end() || at_end()) return;
  const bool alone = here() == '\r';
  note({rest_of_line(position_),
        alone ? Complaint{"carriage return without a line feed", "a line feed", ""}
              : Complaint{"unexpected text where the line should end", "a line end or a # comment",
                          "a value with a unit or of several words needs straight quotes"}});
  skip_line();
}

void Parser::comment() {
  std::size_t end = line_feed(text_, position_);
  if (end < text_.size() && text_[end - 1] == '\r') --end;
  check_text(span_of(position_, end), false, false);
  position_ = end;
}

bool Parser::skip_line_end() {
  const std::size_t length = line_end_length(text_, position_);
  position_ += length;
  if (length > 0) line_begin_ = position_;
  return length > 0;
}

// Blanks, line ends and comments.
void Parser::skip_space() {
  do {
    skip_blanks();
    if (here() == '#') comment();
  } while (skip_line_end());
}

// Whether a line is a header or begins with `key =`, as far as that can be told from it alone.
bool Parser::looks_like_line(std::size_t begin) const {
  begin = skip(text_, begin, blank_byte);
  const bool header = byte_at(text_, begin) == '[';
  const bool element = header && byte_at(text_, begin + 1) == '[';
  begin = skip(text_, begin + (element ? 2 : header ? 1 : 0), blank_byte);
  const std::size_t end = key_end(text_, begin);
  std::size_t behind = skip(text_, end, blank_byte);
  if (end == begin) return false;
  if (!header) return byte_at(text_, behind) == '=';
  if (!piece(text_, rest_of_line(behind)).starts_with(element ? "]]" : "]")) return false;
  behind = skip(text_, behind + (element ? 2 : 1), blank_byte);
  return behind >= text_.size() || byte_at(text_, behind) == '#' || line_end_length(text_, behind) != 0;
}

// ---- mistakes

void Parser::note(const Fault& fault) {
  auto& mistakes = document_.mistakes;
  if (mistakes.size() >= max_mistakes) return;
  const auto& [message, expected, hint] = fault.complaint;
  if (!mistakes.empty() && mistakes.back().at.begin >= line_begin_ && mistakes.back().message == message) return;
  std::string found = quoted_word(piece(text_, fault.at).substr(0, 100));
  mistakes.push_back({fault.at, message, std::move(found), expected, hint});
}

// Notes a mistake in a value. Where it stands in a line that looks like one outside of brackets, the brackets are not
// closed, and reading goes on with that line.
Course Parser::stumble(const Fault& fault) {
  const bool tested = std::exchange(tested_line_, line_begin_) == line_begin_;
  if (open_.empty() || line_begin_ <= open_.front().at || tested || !looks_like_line(line_begin_)) {
    note(fault);
    return Course::stuck;
  }
  position_ = line_begin_;
  return unclosed();
}

// Blames the innermost bracket that is still open where the line begins.
Course Parser::unclosed() {
  while (open_.size() > 1 && open_.back().at >= position_) open_.pop_back();
  const auto [opening, at] = open_.back();
  if (!swallowed_) {
    note({span_of(at, at + 1), opening == '[' ? Complaint{"array is not closed", "a closing ]", ""}
                                              : Complaint{"inline table is not closed", "a closing }", ""}});
  }
  return Course::lost;
}

void Parser::note(const Clash& clash, bool header, bool element) {
  static constexpr Complaint through_value{"value cannot be extended", "a name that has no value yet", ""};
  static constexpr Complaint twice{"key appears twice in its table", "each key once", ""};
  static constexpr Complaint is_table{"name is a table already", "a name that is not used yet", ""};
  static constexpr Complaint header_twice{"table appears twice", "each table once", ""};
  static constexpr Complaint dotted{"table was made by dotted keys, a header cannot make it again", "", ""};
  static constexpr Complaint array{"name is an array of tables", "[[ ]] for one more element", ""};
  static constexpr Complaint no_array{"name is a table, not an array of tables", "[ ] or another name", ""};
  static constexpr Complaint by_header{"dotted keys cannot add to a table with a header", "keys below that header", ""};
  const Complaint* complaint = &is_table;
  switch (clash.made) {
    case Made::as_value: complaint = clash.last && !header ? &twice : &through_value; break;
    case Made::as_elements: complaint = &array; break;
    case Made::by_path: complaint = element ? &no_array : &is_table; break;
    case Made::by_dots: complaint = element ? &no_array : header ? &dotted : &is_table; break;
    case Made::by_header:
      complaint = element ? &no_array : header ? &header_twice : clash.last ? &is_table : &by_header;
      break;
  }
  const std::size_t before = document_.mistakes.size();
  note({clash.part, *complaint});
  if (document_.mistakes.size() > before) references_.push_back({before, clash.first});
}

// Completes hints with the line numbers of what stood first, in one pass over the text.
void Parser::name_lines() {
  std::ranges::sort(references_, {}, &Reference::first);
  Lines lines(text_);
  for (const auto& [mistake, first] : references_)
    document_.mistakes[mistake].hint = "the first one is in line " + std::to_string(lines.at(first).line);
}

void Parser::check_text(Span span, bool basic, bool lines) {
  while (const auto forbidden = find_forbidden(text_, span, basic, lines)) {
    const char c = text_[forbidden->begin];
    const char escaped = byte_at(text_, forbidden->begin + 1);
    const bool newer = escaped == 'e' || escaped == 'x';
    if (c == '\\') {
      note({*forbidden,
            {"unknown escape sequence", "one of \\b \\t \\n \\f \\r \\\" \\\\ \\uXXXX \\UXXXXXXXX",
             newer ? "that one is of TOML 1.1" : "write \\\\ for a backslash, or the text in ' '"}});
    } else if (static_cast<unsigned char>(c) >= 0x80) {
      note({*forbidden, {"bytes are not UTF-8", "text in UTF-8", "save the file as UTF-8"}});
    } else {
      note({*forbidden,
            {"control character in a text", "printable characters and tabs",
             basic ? "write it as \\u and four hexadecimal digits" : ""}});
    }
    // One for a line.
    span.begin = static_cast<std::uint32_t>(std::min<std::size_t>(line_feed(text_, forbidden->begin), span.end));
    if (lines) line_begin_ = span.begin + std::size_t{1};
  }
}

// ---- keys and values

// Reads a dotted key into parts_; stands behind it and its blanks, or at a mistake.
bool Parser::key() {
  parts_.clear();
  for (;;) {
    const std::size_t begin = position_;
    position_ = key_part_end(text_, begin);
    if (position_ == begin) {
      key_fault(begin);
      return false;
    }
    const std::size_t mistakes = document_.mistakes.size();
    const char quote = text_[begin];
    if (quote == '"' || quote == '\'') check_text(span_of(begin + 1, position_ - 1), quote == '"', false);
    if (document_.mistakes.size() > mistakes) return false;
    parts_.push_back(span_of(begin, position_));
    skip_blanks();
    if (here() != '.') return true;
    ++position_;
    skip_blanks();
  }
}

void Parser::key_fault(std::size_t begin) {
  const char c = byte_at(text_, begin);
  if (c == '"' || c == '\'')
    note({rest_of_line(begin), {"key in quotes is not closed", "a closing quote", ""}});
  else if (static_cast<unsigned char>(c) >= 0x80)
    note({rest_of_line(begin), {"bare key contains a non-ASCII letter", "a key in quotes", ""}});
  else
    note({rest_of_line(begin),
          {"key is missing", "a key: letters, digits, _ and -, or any text in quotes",
           c == '!' ? "comments begin with #" : ""}});
}

// `key = value`
Course Parser::assignment(Names::Node table, Entry& entry) {
  if (!key()) return Course::stuck;
  entry.key = {parts_.front().begin, parts_.back().end};
  if (here() != '=') return stumble({rest_of_line(position_), {"missing = after the key", "key = value", ""}});
  ++position_;
  if (const auto clash = names_.add_key(table, parts_)) note(*clash, false, false);
  skip_blanks();
  return value(entry.value);
}

Course Parser::value(Value& value) {
  switch (here()) {
    case '"':
    case '\'': return string(value);
    case '[': return array(value);
    case '{': return table(value);
    default: return scalar(value);
  }
}

Course Parser::string(Value& value) {
  const Quotes quotes = read_quotes(text_, position_, true);
  if (quotes.end == 0) return unclosed_string();
  const std::size_t begin = std::exchange(position_, quotes.end);
  check_text(quotes.inner, quotes.basic, quotes.triple);
  value = {Kind::string, span_of(begin, quotes.end)};
  if (quotes.triple) {
    const std::size_t feed = text_.substr(begin, position_ - begin).rfind('\n');
    if (feed != std::string_view::npos) line_begin_ = begin + feed + 1;
  }
  return Course::on;
}

Course Parser::unclosed_string() {
  const std::size_t begin = position_;
  const bool triple = byte_at(text_, begin + 1) == text_[begin] && byte_at(text_, begin + 2) == text_[begin];
  swallowed_ = true;
  position_ = line_feed(text_, begin);
  if (!triple) {
    note({rest_of_line(begin),
          {"string is not closed", text_[begin] == '"' ? "a closing \"" : "a closing '",
           "a string of several lines needs three quotes"}});
    return Course::stuck;
  }
  note({rest_of_line(begin),
        {"string of several lines is not closed", text_[begin] == '"' ? "a closing \"\"\"" : "a closing '''", ""}});
  do {
    skip_line();
  } while (!at_end() && !looks_like_line(position_));
  return Course::lost;
}

Course Parser::scalar(Value& value) {
  const std::size_t end = scalar_end(text_, position_);
  if (end == position_) return no_value();
  const std::string_view word = text_.substr(position_, end - position_);
  value = {scalar_kind(word), span_of(position_, end)};
  const Complaint complaint = complaint_about(word, value.kind);
  if (complaint.message != nullptr && stumble({value.span, complaint}) == Course::lost) return Course::lost;
  position_ = end;
  return Course::on;
}

Course Parser::no_value() {
  const char c = here();
  const bool none = at_end() || c == '\n' || c == '\r' || c == '#' || c == ',' || c == ']' || c == '}';
  return stumble(
      {rest_of_line(position_), none ? Complaint{"value is missing", "a value", ""}
                                     : Complaint{"not a TOML value", "a value", "text needs straight quotes"}});
}

// ---- brackets

Course Parser::open_bracket(char opening) {
  if (open_.size() >= deepest_nesting) {
    note({span_of(position_, position_ + 1), {"brackets are nested too deeply", "at most 100 within each other", ""}});
    skip_line();
    return Course::lost;
  }
  open_.push_back({opening, position_++});
  return Course::on;
}

// At a closing bracket, perhaps of the wrong kind: that one is left to who waits for it.
Course Parser::close_bracket(Value& value) {
  const auto [opening, begin] = open_.back();
  const bool right = here() == (opening == '[' ? ']' : '}');
  if (!right) {
    const Fault fault{span_of(position_, position_ + 1),
                      {"closing bracket is of the wrong kind", opening == '[' ? "]" : "}", ""}};
    if (stumble(fault) == Course::lost) return Course::lost;
  }
  open_.pop_back();
  const char other = opening == '[' ? '{' : '[';
  const bool awaited = std::ranges::any_of(open_, [&](const Bracket& bracket) { return bracket.opening == other; });
  if (right || !awaited) ++position_;
  value = {opening == '[' ? Kind::array : Kind::table, span_of(begin, position_)};
  return Course::on;
}

Course Parser::array(Value& value) {
  if (open_bracket('[') == Course::lost) return Course::lost;
  bool comma_due = false;
  for (;;) {
    skip_space();
    if (at_end()) return unclosed();
    if (here() == ']' || here() == '}') return close_bracket(value);
    if (here() == ',' && comma_due) {
      ++position_;
      comma_due = false;
      continue;
    }
    if (array_element(comma_due) == Course::lost) return Course::lost;
    comma_due = true;
  }
}

Course Parser::array_element(bool comma_due) {
  if (comma_due && missing(", or ]") == Course::lost) return Course::lost;
  Value ignored;
  const Course course = value(ignored);
  if (course == Course::stuck) skip_item(']');
  return course;
}

Course Parser::missing(const char* expected) {
  // Where a string before was not closed, it has swallowed the comma.
  if (swallowed_ && skip(text_, line_begin_, blank_byte) == position_) return Course::on;
  return stumble({rest_of_line(position_), {"values are not separated by a comma", expected, ""}});
}

// To what may follow an item that cannot be read: a comma, a closing bracket or the line end.
void Parser::skip_item(char closing) {
  for (; !at_end() && here() != ',' && here() != closing && here() != '\n' && here() != '#'; ++position_) {
    if (here() != '"' && here() != '\'') continue;
    const std::size_t end = read_quotes(text_, position_, false).end;
    position_ = (end == 0 ? line_feed(text_, position_) : end) - 1;
  }
}

Course Parser::table(Value& value) {
  if (open_bracket('{') == Course::lost) return Course::lost;
  const Names::Node node = names_.begin_nameless();
  Course course = table_items(node);
  names_.drop(node);
  if (course == Course::on) course = close_bracket(value);
  return course;
}

// Up to the closing bracket.
Course Parser::table_items(Names::Node node) {
  enum class After : std::uint8_t { opening, item, comma } after = After::opening;
  for (;;) {
    skip_blanks();
    if (line_end_in_table()) continue;
    if (at_end()) return unclosed();
    if (here() == '}' || here() == ']') {
      if (after == After::comma && here() == '}')
        note({span_of(position_, position_ + 1),
              {"comma after the last item of an inline table", "no comma", "only TOML 1.1 allows it"}});
      return Course::on;
    }
    if (here() == ',' && after == After::item) {
      ++position_;
      after = After::comma;
      continue;
    }
    if (after == After::item && missing(", or }") == Course::lost) return Course::lost;
    Entry ignored;
    const Course course = assignment(node, ignored);
    if (course == Course::lost) return Course::lost;
    if (course == Course::stuck) skip_item('}');
    after = After::item;
  }
}

// A line end or comment in an inline table is a mistake; reading goes on as TOML 1.1 allows.
bool Parser::line_end_in_table() {
  if (here() != '#' && line_end_length(text_, position_) == 0) return false;
  if (!swallowed_)
    note({span_of(open_.back().at, position_),
          {"inline table does not end on its line", "a closing } in the same line",
           "only TOML 1.1 allows line breaks in it"}});
  swallowed_ = true;
  skip_space();
  return true;
}

}  // namespace

Document parse(std::string_view text) {
  if (text.size() <= longest_text) return Parser(text).run();
  Document document;
  document.tables.emplace_back();
  document.mistakes.push_back({{}, "text is longer than 1 GiB", "", "less", "keep bulk data in files of their own"});
  return document;
}

}  // namespace sarsim::core::toml
