#include "radar/earth/leap_seconds.hpp"

#include <algorithm>
#include <array>

namespace sarsim::radar {

namespace {

constexpr std::array<LeapStep, 28> steps{{
    {41317, 10},  // 1972-01-01
    {41499, 11},  // 1972-07-01
    {41683, 12},  // 1973-01-01
    {42048, 13},  // 1974-01-01
    {42413, 14},  // 1975-01-01
    {42778, 15},  // 1976-01-01
    {43144, 16},  // 1977-01-01
    {43509, 17},  // 1978-01-01
    {43874, 18},  // 1979-01-01
    {44239, 19},  // 1980-01-01
    {44786, 20},  // 1981-07-01
    {45151, 21},  // 1982-07-01
    {45516, 22},  // 1983-07-01
    {46247, 23},  // 1985-07-01
    {47161, 24},  // 1988-01-01
    {47892, 25},  // 1990-01-01
    {48257, 26},  // 1991-01-01
    {48804, 27},  // 1992-07-01
    {49169, 28},  // 1993-07-01
    {49534, 29},  // 1994-07-01
    {50083, 30},  // 1996-01-01
    {50630, 31},  // 1997-07-01
    {51179, 32},  // 1999-01-01
    {53736, 33},  // 2006-01-01
    {54832, 34},  // 2009-01-01
    {56109, 35},  // 2012-07-01
    {57204, 36},  // 2015-07-01
    {57754, 37},  // 2017-01-01
}};
static_assert(steps.front().day_mjd == first_utc_day_mjd);

bool begins_later(std::int64_t day_mjd, const LeapStep& step) { return day_mjd < step.day_mjd; }

}  // namespace

std::span<const LeapStep> leap_steps() { return steps; }

std::int64_t tai_minus_utc_s(std::int64_t utc_day_mjd) {
  const auto later = std::upper_bound(steps.begin() + 1, steps.end(), utc_day_mjd, begins_later);
  return (later - 1)->tai_minus_utc_s;
}

bool has_leap_second(std::int64_t utc_day_mjd) {
  return utc_day_mjd >= first_utc_day_mjd && tai_minus_utc_s(utc_day_mjd + 1) != tai_minus_utc_s(utc_day_mjd);
}

}  // namespace sarsim::radar
