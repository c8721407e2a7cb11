#include "core/toml/scalars.hpp"

#include <optional>

#include "core/text/letters.hpp"
#include "core/toml/scan.hpp"

namespace sarsim::core::toml {

namespace {

constexpr Complaint fine{};
constexpr const char* word_hint = "text stands in quotes; true and false in small letters";

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

constexpr Complaint bad_digits{"number is not well formed", "digits, with single underscores between them at most", ""};
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
      return {"number is not well formed", "digits on both sides of the point", "write 5.0 for 5., 0.5 for .5"};
  }
  if (!rest.empty() && lower(rest.front()) == 'e') {
    rest.remove_prefix(1);
    if (rest.starts_with('+') || rest.starts_with('-')) rest.remove_prefix(1);
    if (take_digits(rest, is_digit) == 0) return {"number is not well formed", "digits behind the e", ""};
  }
  return rest.empty() ? fine : Complaint{"number is not well formed", "a number", "text stands in quotes"};
}

Complaint complaint_about_number(std::string_view word) {
  if (word.size() > 2 && word[0] == '0' && (word[1] == 'x' || word[1] == 'o' || word[1] == 'b'))
    return complaint_about_prefixed(word);
  std::string_view rest = word;
  if (rest.starts_with('+') || rest.starts_with('-')) rest.remove_prefix(1);
  if (rest == "inf" || rest == "nan") return fine;
  if (rest.starts_with('.')) return complaint_about_fraction(rest.substr(0, 1));
  const char first = byte_at(rest, 0);
  if (!is_digit(first) && first != '_') return {"value is not known", "a value", word_hint};
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
  if (word.empty() || !is_digit(word[0])) return {"time is not well formed", "digits behind the point", ""};
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

}  // namespace

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
  if (!word.empty()) return {"date or time goes on where it should end", "", ""};
  if (is_misplaced_leap_second(result)) return {"there is no such time", "second 60 in 23:59:60 UTC only", ""};
  return fine;
}

Complaint complaint_about(std::string_view word, Kind kind) {
  switch (kind) {
    case Kind::integer:
    case Kind::floating: return complaint_about_number(word);
    case Kind::boolean:
      if (word == "true" || word == "false") return fine;
      return {"value is not known", "a value", word_hint};
    default: break;
  }
  DateTime ignored;
  return read_date_time(word, kind, ignored);
}

}  // namespace sarsim::core::toml
