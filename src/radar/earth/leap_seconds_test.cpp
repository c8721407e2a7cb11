#include "radar/earth/leap_seconds.hpp"

#include <gtest/gtest.h>

#include "radar/earth/civil_time.hpp"

namespace sarsim::radar {
namespace leap_seconds_test {

std::int64_t day(int year, int month, int day_of_month) { return mjd_of_date(year, month, day_of_month).value_or(-1); }

TEST(LeapSeconds, GrowByOneAtTheMiddleOrTheEndOfAYear) {
  ASSERT_EQ(leap_steps().size(), 28U);
  for (std::size_t i = 0; i < leap_steps().size(); ++i) {
    const LeapStep& step = leap_steps()[i];
    const CivilTime date = date_of_mjd(step.day_mjd);
    EXPECT_EQ(step.tai_minus_utc_s, 10 + static_cast<std::int64_t>(i));
    EXPECT_EQ(date.day, 1);
    EXPECT_TRUE(date.month == 1 || date.month == 7) << date.year;
    if (i > 0) {
      EXPECT_GT(step.day_mjd, leap_steps()[i - 1].day_mjd);
    }
  }
}

TEST(LeapSeconds, HoldFromTheirDayOn) {
  EXPECT_EQ(tai_minus_utc_s(day(1971, 6, 1)), 10);
  EXPECT_EQ(tai_minus_utc_s(day(1972, 1, 1)), 10);
  EXPECT_EQ(tai_minus_utc_s(day(1972, 6, 30)), 10);
  EXPECT_EQ(tai_minus_utc_s(day(1972, 7, 1)), 11);
  EXPECT_EQ(tai_minus_utc_s(day(1980, 1, 6)), 19);  // the epoch of GPS
  EXPECT_EQ(tai_minus_utc_s(day(2000, 1, 1)), 32);
  EXPECT_EQ(tai_minus_utc_s(day(2016, 12, 31)), 36);
  EXPECT_EQ(tai_minus_utc_s(day(2017, 1, 1)), 37);
  EXPECT_EQ(tai_minus_utc_s(day(2500, 1, 1)), 37);
}

TEST(LeapSeconds, StandAtTheEndOfDays) {
  EXPECT_TRUE(has_leap_second(day(2016, 12, 31)));
  EXPECT_TRUE(has_leap_second(day(1972, 6, 30)));
  EXPECT_FALSE(has_leap_second(day(2017, 1, 1)));
  EXPECT_FALSE(has_leap_second(day(1971, 12, 31)));
  EXPECT_FALSE(has_leap_second(day(2024, 6, 30)));
  int count = 0;
  for (std::int64_t d = day(1970, 1, 1); d < day(2100, 1, 1); ++d) count += has_leap_second(d) ? 1 : 0;
  EXPECT_EQ(count, 27);
}

}  // namespace leap_seconds_test
}  // namespace sarsim::radar
