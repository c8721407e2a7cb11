#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sarsim::radar {

/// A date and a time of day as people write them, Gregorian calendar, in a time scale that is known from elsewhere.
/// Times of one scale compare by time, leap seconds included.
struct CivilTime {
  int year = 0;
  int month = 0;            ///< 1 to 12.
  int day = 0;              ///< 1 to 31.
  int hour = 0;             ///< 0 to 23.
  int minute = 0;           ///< 0 to 59.
  int second = 0;           ///< 0 to 59; 60 in a leap second of UTC.
  double fraction_s = 0.0;  ///< Of the second, in [0, 1), so that 1e-16 s are kept.

  friend auto operator<=>(const CivilTime&, const CivilTime&) = default;  // NOLINT(modernize-use-nullptr)
};

/// True for a date of the calendar in the years 1 to 9999 and a time of day; second 60 exists at 23:59 only.
[[nodiscard]] bool is_valid(const CivilTime& time);

/// Seconds from one valid time to another as if every day had 86 400 s, to the rounding of the result: leap seconds
/// between them are not counted. That is how satellite catalogues count, and it needs no scale, so that it goes back
/// before 1972. With leap seconds: `seconds_between` of instants.
[[nodiscard]] double seconds_between(const CivilTime& from, const CivilTime& to);

/// What `parse_civil` reads, for messages.
inline constexpr std::string_view civil_time_forms = "YYYY-MM-DDThh:mm:ss[.fff][Z] or YYYY-DDDThh:mm:ss[.fff][Z]";

/// A time that was read, or why it could not be.
struct CivilReading {
  std::optional<CivilTime> time;
  bool marked_utc = false;  ///< It ended in Z.
  std::string failure;      ///< In words, for a problem's message; empty where there is a time.
};

/// Reads a whole text in one of the forms of ISO 8601 that CCSDS 301.0-B has as time codes A and B,
///
///     2024-04-01T22:59:42.123456Z     2024-092T22:59:42.123456Z
///
/// with or without the fraction, of any number of digits, and the Z; a space may stand for the T. Years are 1 to
/// 9999: epochs of the first satellites are read too. Refuses what is not a date of the calendar, times of day that do
/// not exist, other offsets than Z, and 24:00:00. Second 60 is read where minute 59 of hour 23 has it. Whether that day
/// has a leap second is for `instant_of` to say, which also refuses what is before 1972, when UTC got whole seconds.
[[nodiscard]] CivilReading parse_civil(std::string_view text);

/// How a date is written.
enum class DateForm {
  calendar,     ///< 2024-04-01
  day_of_year,  ///< 2024-092
};

/// The text that `parse_civil` reads back, without a Z, with up to `digits` decimals (0 to 15) and no zeros at its end.
/// Rounded to the last digit, but never up to the next second.
[[nodiscard]] std::string format_civil(const CivilTime& time, int digits = 12, DateForm form = DateForm::calendar);

/// Modified Julian day of a date of the Gregorian calendar (2000-01-01 is 51544); nothing for a date that does not
/// exist and for years outside 1 to 9999.
[[nodiscard]] std::optional<std::int64_t> mjd_of_date(int year, int month, int day);

/// The date of a modified Julian day, at 0 h.
[[nodiscard]] CivilTime date_of_mjd(std::int64_t day_mjd);

/// The date of a day of a year, from 1, at 0 h; nothing where the year has no such day or is not in 1 to 9999.
[[nodiscard]] std::optional<CivilTime> date_of_year_day(int year, int day_of_year);

}  // namespace sarsim::radar
