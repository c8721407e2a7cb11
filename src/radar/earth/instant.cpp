#include "radar/earth/instant.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "radar/earth/leap_seconds.hpp"

namespace sarsim::radar {

namespace {

constexpr std::int64_t day_s = 86'400;

// TAI at which a value of TAI - UTC begins to hold: the end of the leap second before it.
std::int64_t tai_of(const LeapStep& step) { return step.day_mjd * day_s + step.tai_minus_utc_s; }

// The value of TAI - UTC at a whole second, and whether that is a leap second: the last of its day, at the old value.
struct UtcState {
  std::int64_t tai_minus_utc_s = 0;
  bool in_leap_second = false;
};

UtcState utc_state(std::int64_t tai_s) {
  const std::span<const LeapStep> steps = leap_steps();
  std::size_t i = steps.size() - 1;
  while (i > 0 && tai_s < tai_of(steps[i])) --i;
  return {steps[i].tai_minus_utc_s, i + 1 < steps.size() && tai_s == tai_of(steps[i + 1]) - 1};
}

// A shift of TAI in whole seconds and the rest.
struct Shift {
  std::int64_t whole_s = 0;
  double rest_s = 0.0;
};

// What a clock that has no leap seconds shows less TAI; for UT1 at the moment for which TAI - UTC is given.
Shift shift_of(TimeScale scale, std::int64_t tai_minus_utc, double dut1_s) {
  switch (scale) {
    case TimeScale::gps: return {-19, 0.0};
    case TimeScale::tt: return {32, 0.184};
    case TimeScale::utc: return {-tai_minus_utc, 0.0};
    case TimeScale::ut1: return {-tai_minus_utc, dut1_s};
    case TimeScale::tai: break;
  }
  return {};
}

Instant shifted(const Instant& instant, std::int64_t whole_s, double rest_s) {
  const double rest = instant.fraction_s + rest_s;
  const double carry = std::floor(rest);
  // What is just below 0 may round up to 1.
  const double fraction = std::min(rest - carry, std::nextafter(1.0, 0.0));
  return {instant.tai_s + whole_s + static_cast<std::int64_t>(carry), fraction};
}

// Day and second of a count of seconds that has 86400 every day.
DayTime split(const Instant& clock) {
  std::int64_t day = clock.tai_s / day_s;
  if (clock.tai_s % day_s < 0) --day;
  return {day, clock.tai_s - day * day_s, clock.fraction_s};
}

// What is wrong with a time of that clock; empty where nothing is.
std::string fault_of(const CivilTime& time, TimeScale scale) {
  const auto within = [](int value, int last) { return value >= 0 && value <= last; };
  const auto day = mjd_of_date(time.year, time.month, time.day);
  if (!day) return "the date does not exist";
  if (*day < first_utc_day_mjd) return "the time is before 1972, when UTC got whole seconds";
  if (!(time.fraction_s >= 0.0 && time.fraction_s < 1.0)) return "the fraction of the second is not below 1";
  if (!within(time.hour, 23) || !within(time.minute, 59) || !within(time.second, 60)) return "no day has such a time";
  if (time.second < 60) return {};
  if (scale != TimeScale::utc) return fmt::format("{} has no leap seconds", name_of(scale));
  if (time.hour != 23 || time.minute != 59 || !has_leap_second(*day)) return "UTC has no leap second there";
  return {};
}

}  // namespace

Instant later(const Instant& instant, double seconds) {
  CORE_EXPECT(std::abs(seconds) < 1e15);
  const double whole = std::floor(seconds);
  return shifted(instant, static_cast<std::int64_t>(whole), seconds - whole);
}

double seconds_between(const Instant& from, const Instant& to) {
  return static_cast<double>(to.tai_s - from.tai_s) + (to.fraction_s - from.fraction_s);
}

DayTime day_time_of(const Instant& instant, TimeScale scale, double dut1_s) {
  const UtcState utc = utc_state(instant.tai_s);
  const Shift shift = shift_of(scale, utc.tai_minus_utc_s, dut1_s);
  if (scale != TimeScale::utc || !utc.in_leap_second) return split(shifted(instant, shift.whole_s, shift.rest_s));
  DayTime before = split(shifted(instant, shift.whole_s - 1, 0.0));
  ++before.second;
  return before;
}

CivilTime civil_of(const Instant& instant, TimeScale scale, double dut1_s) {
  const DayTime clock = day_time_of(instant, scale, dut1_s);
  const std::int64_t minutes = std::min<std::int64_t>(clock.second / 60, 1439);
  CivilTime time = date_of_mjd(clock.day_mjd);
  time.hour = static_cast<int>(minutes / 60);
  time.minute = static_cast<int>(minutes % 60);
  time.second = static_cast<int>(clock.second - 60 * minutes);
  time.fraction_s = clock.fraction_s;
  return time;
}

InstantReading instant_of(const CivilTime& time, TimeScale scale, double dut1_s) {
  std::string fault = fault_of(time, scale);
  if (fault.empty() && !(std::abs(dut1_s) <= 1.0)) fault = "UT1 - UTC is not within a second";
  if (!fault.empty()) return {std::nullopt, fmt::format("{}: {}", format_civil(time), fault)};
  const std::int64_t day = mjd_of_date(time.year, time.month, time.day).value_or(0);
  const int second_of_day = 3600 * time.hour + 60 * time.minute + time.second;
  const std::int64_t second = day * day_s + second_of_day;
  // UT1 - UTC may lead to the day before or after.
  const bool is_ut1 = scale == TimeScale::ut1;
  const std::int64_t utc_day = is_ut1 ? split(shifted({second, time.fraction_s}, 0, -dut1_s)).day_mjd : day;
  const Shift shift = shift_of(scale, tai_minus_utc_s(utc_day), dut1_s);
  const Instant instant = shifted({second, time.fraction_s}, -shift.whole_s, -shift.rest_s);
  if (instant.tai_s < tai_of(leap_steps().front()))
    return {std::nullopt, fmt::format("{}: the time is before 1972 in UTC", format_civil(time))};
  return {instant, {}};
}

InstantReading parse_instant(std::string_view text, TimeScale scale, double dut1_s) {
  CivilReading reading = parse_civil(text);
  if (!reading.time) return {std::nullopt, std::move(reading.failure)};
  if (reading.marked_utc && scale != TimeScale::utc)
    return {std::nullopt, fmt::format("'{}' ends in Z, which means UTC, but times are in {}", text, name_of(scale))};
  return instant_of(*reading.time, scale, dut1_s);
}

std::string format_instant(const Instant& instant, TimeScale scale, int digits, DateForm form, double dut1_s) {
  const double unit_s = std::pow(10.0, -std::clamp(digits, 0, 15));
  CivilTime time = civil_of(instant, scale, dut1_s);
  const double left_s = 1.0 - time.fraction_s;
  if (left_s <= 0.5 * unit_s) time = civil_of(later(instant, left_s + 0.25 * unit_s), scale, dut1_s);
  return format_civil(time, digits, form) + (scale == TimeScale::utc ? "Z" : "");
}

std::string_view name_of(TimeScale scale) {
  switch (scale) {
    case TimeScale::utc: return "UTC";
    case TimeScale::tai: return "TAI";
    case TimeScale::gps: return "GPS";
    case TimeScale::tt: return "TT";
    case TimeScale::ut1: return "UT1";
  }
  return {};
}

bool leap_second_between(const Instant& from, const Instant& to) {
  const auto steps = leap_steps().subspan(1);
  return std::any_of(steps.begin(), steps.end(), [&](const LeapStep& step) {
    return to.tai_s >= tai_of(step) - 1 && from < Instant{tai_of(step), 0.0};
  });
}

}  // namespace sarsim::radar
