#include "radar/earth/civil_time.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::radar {

namespace {

constexpr std::int64_t mjd_of_1970 = 40587;

// Takes the text apart from left to right; what is missing fails once and for all.
class TimeText {
 public:
  explicit TimeText(std::string_view text) : rest_(text) {}

  int number(std::size_t digits) {
    if (digits_ahead() < digits) ok_ = false;
    int value = 0;
    for (std::size_t i = 0; ok_ && i < digits; ++i) value = 10 * value + (rest_[i] - '0');
    skip(digits);
    return value;
  }
  bool take(std::string_view letters) {
    const bool there = ok_ && !rest_.empty() && letters.find(rest_.front()) != std::string_view::npos;
    if (there) skip(1);
    return there;
  }
  void need(std::string_view letters) {
    if (!take(letters)) ok_ = false;
  }
  // The digits behind a point.
  double fraction() {
    const std::size_t count = digits_ahead();
    if (count == 0) ok_ = false;
    const auto value = core::parse_number(rest_.substr(0, count), -static_cast<int>(count));
    skip(count);
    return ok_ && value ? *value : 0.0;
  }
  [[nodiscard]] std::size_t digits_ahead() const {
    return static_cast<std::size_t>(std::ranges::find_if_not(rest_, core::is_digit) - rest_.begin());
  }
  [[nodiscard]] bool done() const { return ok_ && rest_.empty(); }

 private:
  void skip(std::size_t count) {
    if (ok_) rest_.remove_prefix(count);
  }
  std::string_view rest_;
  bool ok_ = true;
};

CivilReading refused(std::string failure) { return {std::nullopt, false, std::move(failure)}; }

CivilReading refused_form(std::string_view text) {
  const std::size_t time = text.find_last_of("T ");
  const bool has_offset = time != std::string_view::npos && text.find_first_of("+-", time) != std::string_view::npos;
  if (has_offset) return refused(fmt::format("'{}' has an offset from UTC; write UTC with a Z", text));
  return refused(fmt::format("'{}' is not a time; expected {}", text, civil_time_forms));
}

bool has_date(const CivilTime& time) { return mjd_of_date(time.year, time.month, time.day).has_value(); }

bool has_time_of_day(const CivilTime& time) {
  const auto within = [](int value, int last) { return value >= 0 && value <= last; };
  const int last_second = time.hour == 23 && time.minute == 59 ? 60 : 59;
  return within(time.hour, 23) && within(time.minute, 59) && within(time.second, last_second) &&
         time.fraction_s >= 0.0 && time.fraction_s < 1.0;
}

// Of days that all have 86 400 s.
std::int64_t whole_seconds(const CivilTime& time) {
  const std::int64_t day = mjd_of_date(time.year, time.month, time.day).value_or(0);
  const int second_of_day = 3600 * time.hour + 60 * time.minute + time.second;
  return 86'400 * day + second_of_day;
}

}  // namespace

bool is_valid(const CivilTime& time) { return has_date(time) && has_time_of_day(time); }

double seconds_between(const CivilTime& from, const CivilTime& to) {
  CORE_EXPECT(is_valid(from) && is_valid(to));
  return static_cast<double>(whole_seconds(to) - whole_seconds(from)) + (to.fraction_s - from.fraction_s);
}

std::optional<std::int64_t> mjd_of_date(int year, int month, int day) {
  if (year < 1 || year > 9999 || month < 1 || day < 1) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (month > 12 || day > 31 || !date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count() + mjd_of_1970;
}

CivilTime date_of_mjd(std::int64_t day_mjd) {
  const std::chrono::sys_days day{std::chrono::days(day_mjd - mjd_of_1970)};
  const std::chrono::year_month_day date(day);
  CivilTime time;
  time.year = static_cast<int>(date.year());
  time.month = static_cast<int>(static_cast<unsigned>(date.month()));
  time.day = static_cast<int>(static_cast<unsigned>(date.day()));
  return time;
}

std::optional<CivilTime> date_of_year_day(int year, int day_of_year) {
  const auto new_year = mjd_of_date(year, 1, 1);
  const int days = std::chrono::year(year).is_leap() ? 366 : 365;
  if (!new_year || day_of_year < 1 || day_of_year > days) return std::nullopt;
  return date_of_mjd(*new_year + day_of_year - 1);
}

CivilReading parse_civil(std::string_view text) {
  TimeText rest(text);
  CivilReading reading;
  CivilTime time;
  time.year = rest.number(4);
  rest.need("-");
  const bool day_of_year = rest.digits_ahead() == 3;
  if (!day_of_year) {
    time.month = rest.number(2);
    rest.need("-");
  }
  time.day = rest.number(day_of_year ? 3 : 2);
  rest.need("T ");
  time.hour = rest.number(2);
  rest.need(":");
  time.minute = rest.number(2);
  rest.need(":");
  time.second = rest.number(2);
  if (rest.take(".")) time.fraction_s = std::min(rest.fraction(), std::nextafter(1.0, 0.0));
  reading.marked_utc = rest.take("Z");
  if (!rest.done()) return refused_form(text);
  if (day_of_year) {
    const CivilTime date = date_of_year_day(time.year, time.day).value_or(CivilTime{});
    time.month = date.month;
    time.day = date.day;
  }
  if (!has_date(time)) return refused(fmt::format("'{}' is not a date of the calendar", text));
  if (!has_time_of_day(time)) return refused(fmt::format("'{}' has no time of a day", text));
  reading.time = time;
  return reading;
}

std::string format_civil(const CivilTime& time, int digits, DateForm form) {
  digits = std::clamp(digits, 0, 15);
  std::string text = form == DateForm::calendar ? fmt::format("{:04}-{:02}-{:02}", time.year, time.month, time.day)
                                                : fmt::format("{:04}-{:03}", time.year,
                                                              mjd_of_date(time.year, time.month, time.day).value_or(0) -
                                                                  mjd_of_date(time.year, 1, 1).value_or(0) + 1);
  text += fmt::format("T{:02}:{:02}:{:02}", time.hour, time.minute, time.second);
  std::string fraction = fmt::format("{:.{}f}", time.fraction_s, digits);
  if (fraction.front() != '0') fraction = "0." + std::string(static_cast<std::size_t>(digits), '9');
  fraction.erase(fraction.find_last_not_of('0') + 1);
  return fraction.size() > 2 ? text + fraction.substr(1) : text;
}

}  // namespace sarsim::radar
