#include "radar/earth/civil_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace sarsim::radar {
namespace civil_time_test {

CivilTime read(std::string_view text) {
  const CivilReading reading = parse_civil(text);
  EXPECT_TRUE(reading.time.has_value()) << text << ": " << reading.failure;
  EXPECT_TRUE(reading.failure.empty());
  return reading.time.value_or(CivilTime{});
}

std::string failure(std::string_view text) {
  const CivilReading reading = parse_civil(text);
  EXPECT_FALSE(reading.time.has_value()) << text;
  EXPECT_FALSE(reading.failure.empty());
  return reading.failure;
}

TEST(CivilTime, IsReadFromACalendarDate) {
  EXPECT_EQ(read("2024-04-01T22:59:42Z"), (CivilTime{2024, 4, 1, 22, 59, 42, 0.0}));
  EXPECT_EQ(read("2024-04-01T22:59:42"), (CivilTime{2024, 4, 1, 22, 59, 42, 0.0}));
  EXPECT_EQ(read("2024-04-01 22:59:42.5Z"), (CivilTime{2024, 4, 1, 22, 59, 42, 0.5}));
  EXPECT_EQ(read("2006-07-20T02:38:29.989786"), (CivilTime{2006, 7, 20, 2, 38, 29, 0.989786}));
  EXPECT_EQ(read("2024-02-29T00:00:00.000000000001Z"), (CivilTime{2024, 2, 29, 0, 0, 0, 1e-12}));
  EXPECT_TRUE(parse_civil("2024-04-01T22:59:42Z").marked_utc);
  EXPECT_FALSE(parse_civil("2024-04-01T22:59:42").marked_utc);
}

TEST(CivilTime, IsReadFromADayOfTheYear) {
  EXPECT_EQ(read("2024-092T22:59:42Z"), read("2024-04-01T22:59:42Z"));
  EXPECT_EQ(read("2023-091T00:00:00"), read("2023-04-01T00:00:00"));
  EXPECT_EQ(read("2024-366T23:59:59.25"), read("2024-12-31T23:59:59.25"));
  EXPECT_EQ(read("2024-001T00:00:00"), read("2024-01-01T00:00:00"));
}

TEST(CivilTime, IsReadInALeapSecond) {
  EXPECT_EQ(read("2016-12-31T23:59:60Z"), (CivilTime{2016, 12, 31, 23, 59, 60, 0.0}));
  EXPECT_EQ(read("2016-366T23:59:60.75Z"), (CivilTime{2016, 12, 31, 23, 59, 60, 0.75}));
  EXPECT_NE(failure("2016-12-31T22:59:60Z").find("no time of a day"), std::string::npos);
}

TEST(CivilTime, StaysBelowTheNextSecond) {
  EXPECT_LT(read("2024-04-01T22:59:42.99999999999999999999999999").fraction_s, 1.0);
  EXPECT_EQ(read("2024-04-01T22:59:42." + std::string(5000, '5')).fraction_s, 5.0 / 9.0);
}

TEST(CivilTime, OfNoCalendarIsRefused) {
  for (const std::string text :
       {"2023-02-29T00:00:00Z", "2024-13-01T00:00:00Z", "2024-00-01T00:00:00Z", "2024-01-00T00:00:00Z",
        "2024-04-31T00:00:00Z", "2024-000T00:00:00", "2023-366T00:00:00", "2024-367T00:00:00", "2024-999T00:00:00",
        "2100-02-29T00:00:00", "0000-01-01T00:00:00"})
    EXPECT_NE(failure(text).find("not a date of the calendar"), std::string::npos) << text;
  for (const std::string text : {"2024-04-01T24:00:00Z", "2024-04-01T22:60:00", "2024-04-01T22:59:61"})
    EXPECT_NE(failure(text).find("no time of a day"), std::string::npos) << text;
}

// Of TLE; it is no instant, see Instant.RefusesTimesThatAClockDoesNotShow.
TEST(CivilTime, IsReadFromBeforeUtc) {
  EXPECT_EQ(read("1957-10-04T19:28:34Z"), (CivilTime{1957, 10, 4, 19, 28, 34, 0.0}));
  EXPECT_EQ(read("1957-277T19:28:34Z"), read("1957-10-04T19:28:34Z"));
  EXPECT_EQ(read("0001-01-01T00:00:00"), (CivilTime{1, 1, 1}));
}

TEST(CivilTime, OfAnotherFormIsRefused) {
  for (const std::string text : {"",
                                 "Z",
                                 "2024",
                                 "2024-04-01",
                                 "2024-04-01T",
                                 "2024-04-01T22:59",
                                 "2024-04-01T22:59Z",
                                 "2024-4-1T22:59:42",
                                 "24-04-01T22:59:42",
                                 "2024-04-01T22:59:42.",
                                 "2024-04-01T22:59:42.Z",
                                 "2024-04-01T22:59:42ZZ",
                                 "2024-04-01T22:59:42.5.5",
                                 " 2024-04-01T22:59:42",
                                 "2024-04-01T22:59:42 ",
                                 "2024-04-01t22:59:42",
                                 "2024/04/01T22:59:42",
                                 "20240401T225942",
                                 "2024-0401T22:59:42",
                                 "2024-04-01T22:59:4e1",
                                 "2024-04-01T22:59:42.1e3",
                                 "-024-04-01T22:59:42",
                                 "2024-+4-01T22:59:42",
                                 "2024-04-01T22:59:42,5",
                                 "12024-04-01T22:59:42",
                                 "2024-04T22:59:42",
                                 "2024-04-01T22:59:4",
                                 "2024-04-01T22:59:nan"})
    EXPECT_NE(failure(text).find("expected YYYY-MM-DDThh:mm:ss"), std::string::npos) << text;
  EXPECT_NE(failure("2024-04-01T22:59:42+02:00").find("offset from UTC"), std::string::npos);
  EXPECT_NE(failure("2024-04-01T22:59:42-02:00").find("offset from UTC"), std::string::npos);
}

// No letter put in place of another one is read as the same time.
TEST(CivilTime, IsReadInFullOrNotAtAll) {
  const std::string text = "2024-092T22:59:42.125Z";
  for (std::size_t i = 0; i < text.size(); ++i)
    for (const char letter : std::string("0:-TZ. x\xff")) {
      std::string other = text;
      other[i] = letter;
      if (other == text) continue;
      const CivilReading reading = parse_civil(other);
      const bool same = reading.time && *reading.time == *parse_civil(text).time && reading.marked_utc;
      EXPECT_TRUE(!same || (letter == ' ' && text[i] == 'T')) << other;
    }
}

TEST(CivilTime, IsWrittenAsItIsRead) {
  for (const std::string text : {"2024-04-01T22:59:42", "2024-04-01T22:59:42.5", "1972-01-01T00:00:00.000000000001",
                                 "2016-12-31T23:59:60.123456789012", "9999-12-31T23:59:59.999999999999"})
    EXPECT_EQ(format_civil(read(text)), text);
  EXPECT_EQ(format_civil(read("2024-04-01T22:59:42.25"), 12, DateForm::day_of_year), "2024-092T22:59:42.25");
  EXPECT_EQ(format_civil(read("2024-12-31T00:00:00"), 0, DateForm::day_of_year), "2024-366T00:00:00");
}

TEST(CivilTime, IsRoundedWithinItsSecond) {
  const CivilTime time{2024, 4, 1, 23, 59, 59, 0.98765};
  EXPECT_EQ(format_civil(time, 3), "2024-04-01T23:59:59.988");
  EXPECT_EQ(format_civil(time, 1), "2024-04-01T23:59:59.9");
  EXPECT_EQ(format_civil(time, 0), "2024-04-01T23:59:59");
  EXPECT_EQ(format_civil({2024, 4, 1, 23, 59, 59, 1.0 - 1e-16}), "2024-04-01T23:59:59.999999999999");
  EXPECT_EQ(format_civil({2024, 4, 1, 23, 59, 59, 0.1}, 99), "2024-04-01T23:59:59.1");
}

TEST(CivilTime, IsValidWhereTheCalendarHasIt) {
  EXPECT_TRUE(is_valid({2024, 2, 29, 23, 58, 59, 0.999}));
  EXPECT_TRUE(is_valid({2024, 2, 29, 23, 59, 60, 0.999}));
  EXPECT_TRUE(is_valid({1, 1, 1}));
  for (const CivilTime& time :
       {CivilTime{}, CivilTime{2023, 2, 29}, CivilTime{2024, 13, 1}, CivilTime{2024, 0, 1}, CivilTime{2024, 1, -1},
        CivilTime{2024, 1, 1, 24}, CivilTime{2024, 1, 1, -1}, CivilTime{2024, 1, 1, 0, 60},
        CivilTime{2024, 1, 1, 0, -1}, CivilTime{2024, 1, 1, 0, 0, 60}, CivilTime{2024, 1, 1, 23, 0, 60},
        CivilTime{2024, 1, 1, 0, 59, 60}, CivilTime{2024, 1, 1, 23, 59, 61}, CivilTime{2024, 1, 1, 0, 0, -1},
        CivilTime{2024, 1, 1, 0, 0, 0, 1.0}, CivilTime{2024, 1, 1, 0, 0, 0, -1e-9},
        CivilTime{2024, 1, 1, 0, 0, 0, std::nan("")}})
    EXPECT_FALSE(is_valid(time)) << format_civil(time);
}

TEST(CivilTime, ComparesByTime) {
  EXPECT_GT(read("2016-12-31T23:59:60.25"), read("2016-12-31T23:59:59.999"));
  EXPECT_LT(read("2016-12-31T23:59:60.25"), read("2017-01-01T00:00:00"));
  EXPECT_LT(read("2016-12-31T23:59:59.25"), read("2016-12-31T23:59:59.5"));
}

TEST(CivilTime, SubtractsSecondsBeforeTheyAreLost) {
  const CivilTime noon{2024, 2, 28, 12, 0, 0, 0.125};
  EXPECT_EQ(seconds_between(noon, {2024, 3, 1, 12, 0, 0, 0.25}), 2.0 * 86400.0 + 0.125);
  EXPECT_EQ(seconds_between({2024, 3, 1, 12, 0, 0, 0.25}, noon), -2.0 * 86400.0 - 0.125);
  EXPECT_EQ(seconds_between({1957, 12, 31, 22, 58, 57, 0.5}, {1958, 1, 1, 1, 1, 1, 0.25}), 7323.75);
  EXPECT_EQ(seconds_between({2016, 12, 31, 23, 59, 59}, {2017, 1, 1}), 1.0);  // a leap second is not counted
}

TEST(CivilTime, KeepsFifteenDecimals) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  for (int i = 0; i < 1'000; ++i) {
    const CivilTime time{2024, 2, 29, 1, 2, 3, fraction(random)};
    EXPECT_NEAR(read(format_civil(time, 15)).fraction_s, time.fraction_s, 5.1e-16);
  }
}

TEST(ModifiedJulianDay, IsThatOfKnownDates) {
  EXPECT_EQ(mjd_of_date(1858, 11, 17), 0);
  EXPECT_EQ(mjd_of_date(1970, 1, 1), 40587);
  EXPECT_EQ(mjd_of_date(1980, 1, 6), 44244);
  EXPECT_EQ(mjd_of_date(2000, 1, 1), 51544);
  EXPECT_EQ(mjd_of_date(2000, 2, 29), 51603);
  EXPECT_EQ(mjd_of_date(1900, 2, 29), std::nullopt);
  EXPECT_EQ(mjd_of_date(2024, 257, 1), std::nullopt);  // 257 as a byte is 1
  EXPECT_EQ(mjd_of_date(2024, 1, 257), std::nullopt);
  EXPECT_EQ(mjd_of_date(0, 1, 1), std::nullopt);
  EXPECT_EQ(mjd_of_date(10000, 1, 1), std::nullopt);
  EXPECT_EQ(mjd_of_date(2024, -1, 1), std::nullopt);
}

TEST(ModifiedJulianDay, LeadsBackToItsDate) {
  for (std::int64_t day = 41317; day < 41317 + 150'000; day += 7) {
    const CivilTime date = date_of_mjd(day);
    EXPECT_EQ(mjd_of_date(date.year, date.month, date.day), day);
  }
}

TEST(DayOfAYear, HasADate) {
  EXPECT_EQ(date_of_year_day(2024, 1), (CivilTime{2024, 1, 1}));
  EXPECT_EQ(date_of_year_day(2024, 60), (CivilTime{2024, 2, 29}));
  EXPECT_EQ(date_of_year_day(2023, 60), (CivilTime{2023, 3, 1}));
  EXPECT_EQ(date_of_year_day(2024, 366), (CivilTime{2024, 12, 31}));
  EXPECT_EQ(date_of_year_day(1957, 277), (CivilTime{1957, 10, 4}));
  EXPECT_EQ(date_of_year_day(2023, 366), std::nullopt);
  EXPECT_EQ(date_of_year_day(2024, 367), std::nullopt);
  EXPECT_EQ(date_of_year_day(2024, 0), std::nullopt);
  EXPECT_EQ(date_of_year_day(0, 1), std::nullopt);
  EXPECT_EQ(date_of_year_day(10000, 1), std::nullopt);
}

}  // namespace civil_time_test
}  // namespace sarsim::radar
