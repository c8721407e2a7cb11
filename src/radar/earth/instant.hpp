#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "radar/earth/civil_time.hpp"

namespace sarsim::radar {

/// The clocks in which times are given.
enum class TimeScale {
  utc,  ///< TAI less the leap seconds.
  tai,  ///< Atomic time.
  gps,  ///< TAI - 19 s.
  tt,   ///< TAI + 32.184 s; what ephemerides count in.
  ut1,  ///< Rotation of the Earth: UTC + dUT1.
};

/// A moment of time: atomic seconds, whole and broken, since modified Julian day 0 (1858-11-17, 0 h TAI). A day and a
/// double of its seconds would keep 1.5e-11 s; this keeps 1.1e-16 s.
struct Instant {
  std::int64_t tai_s = 0;
  double fraction_s = 0.0;  ///< In [0, 1).

  friend auto operator<=>(const Instant&, const Instant&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The moment `seconds` after another one; also before. Rounding: 1.1e-16 s and half a unit of `seconds`, below 1e-12 s
/// up to two hours. Less than 1e15 s.
[[nodiscard]] Instant later(const Instant& instant, double seconds);

/// Seconds from one moment to another, to the rounding of the result: 1e-12 s up to two hours.
[[nodiscard]] double seconds_between(const Instant& from, const Instant& to);

/// A day of a time scale and how much of it is over.
struct DayTime {
  std::int64_t day_mjd = 0;  ///< Modified Julian day.
  std::int64_t second = 0;   ///< Whole seconds since its 0 h, 0 to 86399; 86400 in a leap second of UTC.
  double fraction_s = 0.0;   ///< In [0, 1).
};

/// What a clock shows at a moment. Before 1972, UTC counts as TAI - 10 s.
/// @param dut1_s  UT1 - UTC, for UT1 alone; in a leap second that of before
[[nodiscard]] DayTime day_time_of(const Instant& instant, TimeScale scale, double dut1_s = 0.0);
/// The same with a date, for `format_civil`.
[[nodiscard]] CivilTime civil_of(const Instant& instant, TimeScale scale, double dut1_s = 0.0);

/// A moment that was read, or why it could not be.
struct InstantReading {
  std::optional<Instant> instant;
  std::string failure;  ///< In words, for a problem's message; empty where there is a moment.
};

/// The moment at which a clock shows a time. Exact to 2.2e-16 s. Refuses what is not a date or a time
/// of day, times before 1972-01-01 of that clock or of UTC, and second 60 where UTC has none.
[[nodiscard]] InstantReading instant_of(const CivilTime& time, TimeScale scale, double dut1_s = 0.0);

/// Reads a text (`parse_civil`) of times of that clock. A Z at its end means UTC and is refused with another scale.
[[nodiscard]] InstantReading parse_instant(std::string_view text, TimeScale scale, double dut1_s = 0.0);

/// The text of a moment that `parse_instant` reads back, with a Z for UTC; decimals as of `format_civil`, but rounded
/// into the next second where that is nearer.
[[nodiscard]] std::string format_instant(const Instant& instant, TimeScale scale, int digits = 12,
                                         DateForm form = DateForm::calendar, double dut1_s = 0.0);

/// "UTC", "TAI", "GPS", "TT" or "UT1".
[[nodiscard]] std::string_view name_of(TimeScale scale);

/// True where a leap second of UTC touches the time from one moment to a later one, both included: UTC counts no even
/// seconds there.
[[nodiscard]] bool leap_second_between(const Instant& from, const Instant& to);

}  // namespace sarsim::radar
