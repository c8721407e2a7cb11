#include "core/toml/values.hpp"

#include <array>
#include <charconv>
#include <limits>
#include <optional>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/utf8.hpp"
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

namespace {

constexpr Complaint fine{};
constexpr const char* word_hint = "text needs straight quotes; write true and false in lower case";

// ---- numbers

// Takes digits, with single underscores between them, from the front of a word; how many, 0 for a mistake.
std::size_t take_digits(std::string_view& word, bool (*is_one)(char)) {
  std::size_t i = 0;
  std::size_t underscores = 0;
  while (i < word.size() && (is_one(word[i]) || word[i] == '_')) {
    const bool underscore = word[i] == '_';
    const bool between = i > 0 && word[i - 1] != '_' && i + 1 < word.size() && is_one(word[i + 1]);
    if (underscore && !between) return 0;
    underscores += underscore ? 1 : 0;
    ++i;
  }
  word.remove_prefix(i);
  return i - underscores;
}

constexpr Complaint bad_digits{"malformed number", "digits, with single underscores between them at most", ""};
constexpr Complaint too_large{"integer needs more than 64 bits", "-9223372036854775808 to 9223372036854775807",
                              "write it with a point (1.0e30) where it need not be exact"};

bool fits(std::string_view word) { return integer(word, {Kind::integer, span_of(0, word.size())}).has_value(); }

Complaint complaint_about_prefixed(std::string_view word) {
  std::string_view digits = word.substr(2);
  const char base = word[1];
  const std::size_t count =
      base == 'x'   ? take_digits(digits, [](char c) { return is_digit(c) || (lower(c) >= 'a' && lower(c) <= 'f'); })
      : base == 'o' ? take_digits(digits, [](char c) { return c >= '0' && c <= '7'; })
                    : take_digits(digits, [](char c) { return c == '0' || c == '1'; });
  if (count == 0 || !digits.empty()) return bad_digits;
  return count <= 15 || fits(word) ? fine : too_large;
}

// Behind the digits before the point.
Complaint complaint_about_fraction(std::string_view rest) {
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    if (take_digits(rest, is_digit) == 0)
      return {"malformed number", "digits on both sides of the point", "write 5.0 for 5., 0.5 for .5"};
  }
  if (!rest.empty() && lower(rest.front()) == 'e') {
    rest.remove_prefix(1);
    if (rest.starts_with('+') || rest.starts_with('-')) rest.remove_prefix(1);
    if (take_digits(rest, is_digit) == 0) return {"malformed number", "digits after the e", ""};
  }
  return rest.empty() ? fine : Complaint{"malformed number", "a number", "text needs straight quotes"};
}

Complaint complaint_about_number(std::string_view word) {
  if (word.size() > 2 && word[0] == '0' && (word[1] == 'x' || word[1] == 'o' || word[1] == 'b'))
    return complaint_about_prefixed(word);
  std::string_view rest = word;
  if (rest.starts_with('+') || rest.starts_with('-')) rest.remove_prefix(1);
  if (rest == "inf" || rest == "nan") return fine;
  if (rest.starts_with('.')) return complaint_about_fraction(rest.substr(0, 1));
  const char first = byte_at(rest, 0);
  if (!is_digit(first) && first != '_') return {"not a TOML value", "a value", word_hint};
  const std::size_t count = take_digits(rest, is_digit);
  if (count == 0) return bad_digits;
  if (count > 1 && first == '0') return {"number has a leading zero", "a number without it", ""};
  if (!rest.empty()) return complaint_about_fraction(rest);
  return count <= 18 || fits(word) ? fine : too_large;
}

// ---- dates and times

// Takes `count` digits from the front of a word; -1 where there are other characters.
int take_number(std::string_view& word, std::size_t count) {
  if (word.size() < count) return -1;
  int number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_digit(word[i])) return -1;
    number = 10 * number + (word[i] - '0');
  }
  word.remove_prefix(count);
  return number;
}

bool take(std::string_view& word, char c) {
  if (!word.starts_with(c)) return false;
  word.remove_prefix(1);
  return true;
}

int days_of(int year, int month) {
  constexpr std::array<int, 12> days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  return days.at(static_cast<std::size_t>(month - 1)) + (month == 2 && leap ? 1 : 0);
}

Complaint take_date(std::string_view& word, DateTime& date) {
  date.year = take_number(word, 4);
  const bool first = take(word, '-');
  date.month = take_number(word, 2);
  const bool second = take(word, '-');
  date.day = take_number(word, 2);
  if (!first || !second || date.year < 0 || date.month < 0 || date.day < 0)
    return {"date is not well formed", "year-month-day as 2024-04-01", ""};
  if (date.month < 1 || date.month > 12) return {"there is no such month", "01 to 12", ""};
  if (date.day < 1 || date.day > days_of(date.year, date.month))
    return {"that month has no such day", "a day of that month", ""};
  return fine;
}

Complaint take_time(std::string_view& word, DateTime& time) {
  time.hour = take_number(word, 2);
  const bool first = take(word, ':');
  time.minute = take_number(word, 2);
  if (!first || time.hour < 0 || time.minute < 0) return {"time is not well formed", "a time as 22:59:42", ""};
  if (!take(word, ':')) return {"time has no seconds", "a time as 22:59:42", "only TOML 1.1 lets them be left out"};
  time.second = take_number(word, 2);
  if (time.second < 0) return {"time is not well formed", "a time as 22:59:42", ""};
  if (time.hour > 23 || time.minute > 59 || time.second > 60)
    return {"there is no such time", "00:00:00 to 23:59:59", ""};
  if (!take(word, '.')) return fine;
  if (word.empty() || !is_digit(word[0])) return {"time is not well formed", "digits after the point", ""};
  for (int unit = 100'000'000; !word.empty() && is_digit(word[0]); unit /= 10)
    time.nanosecond += unit * take_number(word, 1);
  return fine;
}

Complaint take_offset(std::string_view& word, DateTime& time) {
  constexpr Complaint wrong{"offset from UTC is not well formed", "Z, or hours and minutes as +01:00", ""};
  if (take(word, 'Z') || take(word, 'z')) return fine;
  const bool west = take(word, '-');
  if (!west && !take(word, '+')) return wrong;
  const int hours = take_number(word, 2);
  const bool colon = take(word, ':');
  const int minutes = take_number(word, 2);
  if (!colon || hours < 0 || hours > 23 || minutes < 0 || minutes > 59) return wrong;
  time.offset_minutes = (west ? -1 : 1) * (60 * hours + minutes);
  return fine;
}

// RFC 3339, section 5.7: second 60 is that of a leap second only, which comes at 23:59:60 in UTC.
bool is_misplaced_leap_second(const DateTime& time) {
  constexpr int day = 24 * 60;
  const int minute = (60 * time.hour + time.minute - time.offset_minutes + day) % day;
  return time.second == 60 && minute != day - 1;
}

Complaint read_date_time(std::string_view word, Kind kind, DateTime& result) {
  const bool dated = kind != Kind::local_time;
  if (dated)
    if (const Complaint complaint = take_date(word, result); complaint.message != nullptr) return complaint;
  if (kind != Kind::local_date) {
    if (dated && !take(word, 'T') && !take(word, 't') && !take(word, ' '))
      return {"date is not well formed", "T or a blank between date and time", ""};
    if (const Complaint complaint = take_time(word, result); complaint.message != nullptr) return complaint;
  }
  if (kind == Kind::offset_date_time)
    if (const Complaint complaint = take_offset(word, result); complaint.message != nullptr) return complaint;
  if (!word.empty()) return {"unexpected text after the date or time", "", ""};
  if (is_misplaced_leap_second(result)) return {"there is no such time", "second 60 in 23:59:60 UTC only", ""};
  return fine;
}

}  // namespace

Complaint complaint_about(std::string_view word, Kind kind) {
  switch (kind) {
    case Kind::integer:
    case Kind::floating: return complaint_about_number(word);
    case Kind::boolean:
      if (word == "true" || word == "false") return fine;
      return {"not a TOML value", "a value", word_hint};
    default: break;
  }
  DateTime ignored;
  return read_date_time(word, kind, ignored);
}

std::optional<DateTime> date_time(std::string_view text, const Value& value) {
  if (value.kind < Kind::offset_date_time || value.kind > Kind::local_time) return std::nullopt;
  DateTime result;
  if (read_date_time(piece(text, value.span), value.kind, result).message != nullptr) return std::nullopt;
  return result;
}

}  // namespace sarsim::core::toml
