#include "radar/earth/instant.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "radar/earth/leap_seconds.hpp"

namespace sarsim::radar {
namespace instant_test {

constexpr std::array<TimeScale, 5> scales{TimeScale::utc, TimeScale::tai, TimeScale::gps, TimeScale::tt,
                                          TimeScale::ut1};

Instant read(std::string_view text, TimeScale scale = TimeScale::utc, double dut1_s = 0.0) {
  const InstantReading reading = parse_instant(text, scale, dut1_s);
  EXPECT_TRUE(reading.instant.has_value()) << reading.failure;
  return reading.instant.value_or(Instant{});
}

std::string failure(std::string_view text, TimeScale scale = TimeScale::utc) {
  const InstantReading reading = parse_instant(text, scale);
  EXPECT_FALSE(reading.instant.has_value()) << text;
  return reading.failure;
}

std::string shown(const Instant& instant, TimeScale scale, double dut1_s = 0.0) {
  return format_civil(civil_of(instant, scale, dut1_s));
}

// The epoch of an orbit in a test of isce3, and the specification's constants.
TEST(Instant, HasTheTimesOfAllClocks) {
  const Instant instant = read("2021-07-01T03:19:50Z");
  EXPECT_EQ(shown(instant, TimeScale::tai), "2021-07-01T03:20:27");
  EXPECT_EQ(shown(instant, TimeScale::gps), "2021-07-01T03:20:08");
  EXPECT_EQ(shown(instant, TimeScale::tt), "2021-07-01T03:20:59.184");
  EXPECT_EQ(shown(instant, TimeScale::utc), "2021-07-01T03:19:50");
  EXPECT_EQ(shown(instant, TimeScale::ut1, -0.25), "2021-07-01T03:19:49.75");
  EXPECT_EQ(read("2021-07-01T03:20:27", TimeScale::tai), instant);
  EXPECT_EQ(read("2021-07-01T03:20:08", TimeScale::gps), instant);
  EXPECT_EQ(read("2021-07-01T03:20:59.184", TimeScale::tt), instant);
  EXPECT_EQ(read("2021-07-01T03:19:49.75", TimeScale::ut1, -0.25), instant);
}

TEST(Instant, CountsAtomicSecondsFromTheModifiedJulianDay) {
  EXPECT_EQ(read("2000-01-01T00:00:00", TimeScale::tai), (Instant{51544LL * 86400, 0.0}));
  EXPECT_EQ(read("2000-01-01T00:00:00Z"), (Instant{51544LL * 86400 + 32, 0.0}));
  EXPECT_EQ(read("1980-01-06T00:00:00", TimeScale::gps), read("1980-01-06T00:00:00Z"));
}

TEST(Instant, PassesThroughALeapSecond) {
  const Instant before = read("2016-12-31T23:59:59.5Z");
  EXPECT_EQ(later(before, 1.0), read("2016-12-31T23:59:60.5Z"));
  EXPECT_EQ(later(before, 2.0), read("2017-01-01T00:00:00.5Z"));
  EXPECT_EQ(shown(later(before, 0.5), TimeScale::utc), "2016-12-31T23:59:60");
  EXPECT_EQ(shown(later(before, 1.0), TimeScale::utc), "2016-12-31T23:59:60.5");
  EXPECT_EQ(shown(later(before, 1.5), TimeScale::utc), "2017-01-01T00:00:00");
  EXPECT_EQ(shown(later(before, 1.0), TimeScale::tai), "2017-01-01T00:00:36.5");
  EXPECT_EQ(seconds_between(read("2016-12-31T23:59:59Z"), read("2017-01-01T00:00:00Z")), 2.0);
  EXPECT_EQ(seconds_between(read("2017-12-31T23:59:59Z"), read("2018-01-01T00:00:00Z")), 1.0);
}

// UT1 does not jump: it goes on while UTC waits, and dUT1 grows by 1 s.
TEST(Instant, HasNoLeapInUt1) {
  const Instant in_leap = read("2016-12-31T23:59:60.5Z");
  EXPECT_EQ(shown(in_leap, TimeScale::ut1, -0.4), "2017-01-01T00:00:00.1");
  EXPECT_EQ(shown(later(in_leap, 1.0), TimeScale::ut1, 0.6), "2017-01-01T00:00:01.1");
  EXPECT_EQ(read("2017-01-01T00:00:01.5", TimeScale::ut1, 0.5), read("2017-01-01T00:00:01Z"));
  EXPECT_EQ(read("2016-12-31T23:59:58.5", TimeScale::ut1, -0.5), read("2016-12-31T23:59:59Z"));
  EXPECT_EQ(read("2017-01-01T00:00:00.25", TimeScale::ut1, 0.5), read("2016-12-31T23:59:59.75Z"));
}

TEST(Instant, RefusesTimesThatAClockDoesNotShow) {
  EXPECT_NE(failure("2015-12-31T23:59:60Z").find("no leap second there"), std::string::npos);
  EXPECT_NE(failure("2016-12-31T23:59:60", TimeScale::gps).find("GPS has no leap seconds"), std::string::npos);
  EXPECT_NE(failure("2016-12-31T23:59:60", TimeScale::tt).find("TT has no leap seconds"), std::string::npos);
  EXPECT_NE(failure("2016-12-31T23:59:59Z", TimeScale::gps).find("means UTC"), std::string::npos);
  EXPECT_NE(failure("1971-12-31T23:59:59Z").find("before 1972"), std::string::npos);
  EXPECT_NE(failure("1972-01-01T00:00:09.9", TimeScale::tai).find("before 1972"), std::string::npos);
  EXPECT_EQ(read("1972-01-01T00:00:10", TimeScale::tai), read("1972-01-01T00:00:00Z"));
  EXPECT_FALSE(parse_instant("2024-01-01T00:00:00", TimeScale::ut1, 1.5).instant);
  EXPECT_FALSE(parse_instant("2024-01-01T00:00:00", TimeScale::ut1, std::numeric_limits<double>::quiet_NaN()).instant);
  for (const CivilTime& odd :
       {CivilTime{2024, 2, 30, 0, 0, 0, 0.0}, CivilTime{2024, 1, 1, 24, 0, 0, 0.0},
        CivilTime{2024, 1, 1, 0, -1, 0, 0.0}, CivilTime{2024, 1, 1, 0, 0, 61, 0.0}, CivilTime{2024, 1, 1, 0, 0, 0, 1.0},
        CivilTime{2024, 1, 1, 0, 0, 0, -0.1}, CivilTime{2024, 1, 1, 0, 0, 0, std::numeric_limits<double>::quiet_NaN()},
        CivilTime{1970, 1, 1, 0, 0, 0, 0.0}})
    EXPECT_FALSE(instant_of(odd, TimeScale::utc).failure.empty());
}

TEST(Instant, LeadsBackFromEveryClock) {
  std::mt19937 random(51);
  std::uniform_int_distribution<std::int64_t> second(41318LL * 86400, 80000LL * 86400);
  std::uniform_real_distribution<double> fraction(0.0, 1.0), dut1(-0.9, 0.9);
  for (int i = 0; i < 20'000; ++i) {
    const Instant instant{second(random), fraction(random)};
    const double dut1_s = dut1(random);
    for (const TimeScale scale : scales) {
      const InstantReading back = instant_of(civil_of(instant, scale, dut1_s), scale, dut1_s);
      ASSERT_TRUE(back.instant) << back.failure;
      EXPECT_NEAR(seconds_between(instant, *back.instant), 0.0, 4e-16);
    }
  }
}

// Every second about every leap second, in all clocks without a jump of dUT1.
TEST(Instant, LeadsBackAboutAllLeapSeconds) {
  for (const LeapStep& step : leap_steps().subspan(1))
    for (std::int64_t offset = -5; offset <= 5; ++offset)
      for (const double fraction : {0.0, 0.999999}) {
        const Instant instant{step.day_mjd * 86400 + step.tai_minus_utc_s + offset, fraction};
        const CivilTime utc = civil_of(instant, TimeScale::utc);
        EXPECT_EQ(utc.second == 60, offset == -1);
        EXPECT_EQ(instant_of(utc, TimeScale::utc).instant, instant);
        EXPECT_EQ(read(format_civil(utc) + "Z"), instant);
      }
}

TEST(Instant, MovesBothWaysAndKeepsAPicosecond) {
  const Instant instant = read("2024-04-01T22:59:42.123456789012Z");
  EXPECT_EQ(shown(later(instant, 1e-12), TimeScale::utc), "2024-04-01T22:59:42.123456789013");
  EXPECT_NEAR(seconds_between(later(instant, -42.123456789012), read("2024-04-01T22:59:00Z")), 0.0, 4e-15);
  EXPECT_EQ(shown(later(instant, 86400.0), TimeScale::utc), "2024-04-02T22:59:42.123456789012");
  EXPECT_NEAR(seconds_between(instant, later(instant, 5400.125)), 5400.125, 1e-12);
  EXPECT_NEAR(seconds_between(later(instant, 1e-15), instant), -1e-15, 2.3e-16);
  EXPECT_EQ(later({100, 0.0}, -1e-30), (Instant{100, 0.0}));
  EXPECT_LT(instant, later(instant, 1e-15));
  EXPECT_GT(instant, later(instant, -1.0));
}

TEST(Instant, IsWrittenRoundedIntoTheNextSecond) {
  const Instant before = read("2016-12-31T23:59:59.9996Z");
  EXPECT_EQ(format_instant(before, TimeScale::utc), "2016-12-31T23:59:59.9996Z");
  EXPECT_EQ(format_instant(before, TimeScale::utc, 3), "2016-12-31T23:59:60Z");
  EXPECT_EQ(format_instant(later(before, 1.0), TimeScale::utc, 3), "2017-01-01T00:00:00Z");
  EXPECT_EQ(format_instant(before, TimeScale::gps, 3), "2017-01-01T00:00:17");
  EXPECT_EQ(format_instant(before, TimeScale::gps, 3, DateForm::day_of_year), "2017-001T00:00:17");
  const Instant instant = read("2024-04-01T22:59:42.123456789012Z");
  EXPECT_EQ(format_instant(later(instant, -42.123456789012), TimeScale::utc), "2024-04-01T22:59:00Z");
  EXPECT_EQ(format_instant({60401LL * 86400, 1.0 - 1.2e-16}, TimeScale::tai, 15), "2024-04-01T00:00:01");
  EXPECT_EQ(format_instant(instant, TimeScale::utc, 0), "2024-04-01T22:59:42Z");
  EXPECT_EQ(format_instant(instant, TimeScale::tt, 3), "2024-04-01T23:00:51.307");
}

// Also where the clock's own fraction is rounded: nothing is left just below the next second.
TEST(Instant, IsWrittenRoundedByEveryClock) {
  std::mt19937 random(52);
  std::uniform_real_distribution<double> dut1(-0.9, 0.9), before(0.0, 4.99e-4);
  for (int i = 0; i < 5'000; ++i) {
    const double dut1_s = dut1(random), before_s = before(random);
    const Instant whole = read("2024-04-01T22:59:42", TimeScale::ut1, dut1_s);
    EXPECT_EQ(format_instant(later(whole, -before_s), TimeScale::ut1, 3, DateForm::calendar, dut1_s),
              "2024-04-01T22:59:42");
    EXPECT_EQ(format_instant(later(whole, -1e-3 * before_s), TimeScale::ut1, 6, DateForm::calendar, dut1_s),
              "2024-04-01T22:59:42");
    EXPECT_EQ(format_instant(later(whole, -1e-9 * before_s), TimeScale::ut1, 12, DateForm::calendar, dut1_s),
              "2024-04-01T22:59:42");
  }
}

TEST(Instant, ShowsTheDayOfTheClock) {
  const Instant instant = read("2024-12-31T23:59:50.25Z");
  const DayTime utc = day_time_of(instant, TimeScale::utc), tai = day_time_of(instant, TimeScale::tai);
  EXPECT_EQ(utc.day_mjd, 60675);
  EXPECT_EQ(utc.second, 86390);
  EXPECT_EQ(utc.fraction_s, 0.25);
  EXPECT_EQ(tai.day_mjd, 60676);
  EXPECT_EQ(tai.second, 27);
  EXPECT_EQ(day_time_of({-1, 0.5}, TimeScale::tai).day_mjd, -1);
  EXPECT_EQ(day_time_of({-1, 0.5}, TimeScale::tai).second, 86399);
}

TEST(LeapSecondBetween, SeesWhatTouchesOne) {
  const auto at = [](const char* text) { return read(text); };
  EXPECT_TRUE(leap_second_between(at("2016-12-31T23:50:00Z"), at("2017-01-01T00:10:00Z")));
  EXPECT_TRUE(leap_second_between(at("2016-12-31T23:59:60.5Z"), at("2016-12-31T23:59:60.75Z")));
  EXPECT_TRUE(leap_second_between(at("2016-12-31T23:59:00Z"), at("2016-12-31T23:59:60Z")));
  EXPECT_FALSE(leap_second_between(at("2016-12-31T23:50:00Z"), at("2016-12-31T23:59:59.999Z")));
  EXPECT_FALSE(leap_second_between(at("2017-01-01T00:00:00Z"), at("2030-01-01T00:00:00Z")));
  EXPECT_FALSE(leap_second_between(at("1972-01-01T00:00:00Z"), at("1972-01-02T00:00:00Z")));
}

}  // namespace instant_test
}  // namespace sarsim::radar
