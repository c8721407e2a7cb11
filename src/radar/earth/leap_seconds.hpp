#pragma once

#include <cstdint>
#include <span>

namespace sarsim::radar {

/// From the beginning of a UTC day on, TAI is so many seconds ahead of UTC.
struct LeapStep {
  std::int64_t day_mjd = 0;  ///< Modified Julian day whose 0 h UTC it is.
  std::int64_t tai_minus_utc_s = 0;
};

/// First day of UTC with whole seconds, 1972-01-01; no instant before it is read.
inline constexpr std::int64_t first_utc_day_mjd = 41317;

/// All 28 values of TAI - UTC since 1972, by day: 10 s, then 27 leap seconds up to 37 s since 2017 (IERS Bulletin C).
/// No file of the system is asked, because these expire. Later times count as 37 s until this table is extended; no
/// leap second is expected before 2035 (CGPM 2022, resolution 4).
[[nodiscard]] std::span<const LeapStep> leap_steps();

/// TAI - UTC on a UTC day, s; before 1972 the 10 s of 1972.
[[nodiscard]] std::int64_t tai_minus_utc_s(std::int64_t utc_day_mjd);

/// True where a UTC day has 86401 s: 23:59:60 is a time of it.
[[nodiscard]] bool has_leap_second(std::int64_t utc_day_mjd);

}  // namespace sarsim::radar
