#include "core/text/number_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace sarsim::core {
namespace number_text_test {

TEST(ParseNumber, ReadsDecimalNumbers) {
  EXPECT_EQ(parse_number("0"), 0.0);
  EXPECT_EQ(parse_number("-12.5"), -12.5);
  EXPECT_EQ(parse_number("+3"), 3.0);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number(".25"), 0.25);
  EXPECT_EQ(parse_number("007"), 7.0);
  EXPECT_EQ(parse_number("0.1"), 0.1);
}

TEST(WithMinusSign, IsForTheFirstCharacterAlone) {
  EXPECT_EQ(with_minus_sign("-30 m"), "−30 m");
  EXPECT_EQ(with_minus_sign("30 m"), "30 m");
  EXPECT_EQ(with_minus_sign("1e-6"), "1e-6");
  EXPECT_EQ(with_minus_sign(""), "");
}

TEST(ParseNumber, ReadsExponentsWithEitherLetter) {
  EXPECT_EQ(parse_number("1e3"), 1000.0);
  EXPECT_EQ(parse_number("1E+03"), 1000.0);
  EXPECT_EQ(parse_number("2.5d-2"), 0.025);
  EXPECT_EQ(parse_number("2.5D2"), 250.0);
  EXPECT_EQ(parse_number("1e0000000000000002"), 100.0);
}

// The literals on the right are correctly rounded by the compiler.
TEST(ParseNumber, ShiftsTheExponentInsteadOfMultiplying) {
  EXPECT_EQ(parse_number("800", -9), 800e-9);
  EXPECT_EQ(parse_number("5.3", 9), 5.3e9);
  EXPECT_EQ(parse_number("1.68257E-07", -3), 1.68257e-10);
  EXPECT_EQ(parse_number("0.1", 9), 1e8);
  EXPECT_EQ(parse_number("-0.7", 3), -700.0);
  int differ = 0;
  for (int i = 1; i < 1000; ++i) {
    const double value = parse_number(std::to_string(i), -9).value();
    EXPECT_EQ(value, static_cast<double>(static_cast<long double>(i) / 1e9L)) << i;
    differ += value == i * 1e-9 ? 0 : 1;
  }
  EXPECT_GT(differ, 100) << "or multiplying would have done";
}

// An exponent that changes nothing leads around the short way for few digits.
TEST(ParseNumber, GivesTheSameForShortLiteralsByEitherWay) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200'000; ++i) {
    std::string text = random() % 2 == 0 ? "-" : "";
    const std::size_t digits = 1 + random() % 20;
    const std::size_t point = random() % 25;
    for (std::size_t k = 0; k < digits; ++k) {
      if (k == point) text += '.';
      text += static_cast<char>('0' + random() % 10);
    }
    const int shift = static_cast<int>(random() % 61) - 30;
    const auto value = parse_number(text, shift);
    ASSERT_TRUE(value) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*value), std::bit_cast<std::uint64_t>(*parse_number(text + "e0", shift)))
        << text << " shifted by " << shift;
  }
}

TEST(ParseNumber, RefusesWhatIsNoWholeNumberText) {
  for (const char* text :
       {"",   " ",   "12abc", "nan", "NaN", "inf", "-infinity", ".",   "+",     "-",     "+.", "0x10",
        "1e", "1e+", "e5",    "1 ",  " 1",  "1,5", "--1",       "+-1", "1.2.3", "1e2.5", "1f", "\xef\xbc\x91"}) {
    EXPECT_FALSE(parse_number(text)) << '"' << text << '"';
    EXPECT_FALSE(parse_number(text, -9)) << '"' << text << '"';
  }
}

TEST(ParseNumber, RefusesOverflow) {
  for (const char* text :
       {"1e999", "-1e999", "1e309", "1.8e308", "1e99999999999", "123456789e301", "0.001e312", "9e99999999999999999999"})
    EXPECT_FALSE(parse_number(text)) << text;
  EXPECT_FALSE(parse_number("1e300", 9));
  EXPECT_FALSE(parse_number(std::string(400, '9')));
  EXPECT_FALSE(parse_number("1" + std::string(330, '0'), 3));
}

TEST(ParseNumber, ReadsTheLargestNumber) {
  EXPECT_EQ(parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number("1.7976931348623157e317", -9), std::numeric_limits<double>::max());
}

TEST(ParseNumber, TakesWhatIsTooSmallForZero) {
  for (const char* text :
       {"1e-999", "-1e-999", "1e-400", "1e-99999999999", "0.000001e-330", "9e-99999999999999999999", "123e-340"})
    EXPECT_EQ(parse_number(text), 0.0) << text;
  EXPECT_EQ(parse_number("1e-320", -9), 0.0);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1", 3), 0.0);
}

TEST(ParseNumber, KeepsWhatLeadingOrTrailingZerosOnlyMakeLookExtreme) {
  EXPECT_EQ(parse_number("1" + std::string(400, '0') + "e-400"), 1.0);
  EXPECT_EQ(parse_number("0." + std::string(399, '0') + "1e400"), 1.0);
  EXPECT_EQ(parse_number(std::string(400, '0') + "1"), 1.0);
  EXPECT_EQ(parse_number(std::string(400, '0') + "1", 2), 100.0);
  EXPECT_EQ(parse_number("0e99999999999"), 0.0);
  EXPECT_EQ(parse_number("0.000e999", 9), 0.0);
}

TEST(ParseNumber, DecidesBetweenZeroAndOverflowByTheMagnitudeNotTheText) {
  // Many zeros in front of the digits say nothing about the size.
  EXPECT_EQ(parse_number(std::string(500, '0') + "1e-400"), 0.0);
  EXPECT_EQ(parse_number(std::string(500, '0') + ".1e-400"), 0.0);
  EXPECT_FALSE(parse_number("0." + std::string(10, '0') + "1e400"));
  EXPECT_EQ(parse_number("0." + std::string(800, '0') + "1e400"), 0.0);
}

TEST(ParseNumber, ReadsSubnormalNumbers) {
  EXPECT_EQ(parse_number("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_number("1e-310"), 1e-310);
}

TEST(ParseInteger, ReadsWholeNumbersAndRefusesTheRest) {
  EXPECT_EQ(parse_integer("0"), 0);
  EXPECT_EQ(parse_integer("+12"), 12);
  EXPECT_EQ(parse_integer("-7"), -7);
  EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(parse_integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  for (const char* text : {"", "+", "-", "+-1", "-+1", "1.0", "1e3", "0x10", " 1", "1 ", "9223372036854775808", "abc"})
    EXPECT_FALSE(parse_integer(text)) << '"' << text << '"';
}

TEST(NumberText, WholeNumbersAreDigitsAlone) {
  EXPECT_EQ(parse_whole("0"), 0U);
  EXPECT_EQ(parse_whole("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(parse_whole("00ff", 16), 255U);
  for (const char* const text : {"", "+1", "-1", " 1", "1 ", "1.0", "0x1", "18446744073709551616"})
    EXPECT_FALSE(parse_whole(text)) << '"' << text << '"';
}

// Every finite double, also with the smallest exponents, as long as the shifted number stays within the range of
// doubles.
TEST(FormatNumber, IsReadBackAsExactlyTheSameNumber) {
  std::mt19937_64 random(20);
  for (const int shift : {0, 9, -9, 3, -3}) {
    for (int i = 0; i < 20'000; ++i) {
      const auto value = std::bit_cast<double>(random());
      if (!std::isfinite(value)) continue;
      const std::string text = format_number(value, shift);
      const auto back = parse_number(text, -shift);
      ASSERT_TRUE(back) << text << " shift " << shift;
      ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << text << " shift " << shift;
    }
  }
}

TEST(FormatNumber, OfNumbersOfEverydaySizeIsReadBackExactly) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> exponent(-12.0, 16.0);
  for (const int shift : {0, 9, -9, 3, -3}) {
    for (int i = 0; i < 20'000; ++i) {
      const double value = std::pow(10.0, exponent(random)) * (i % 2 == 0 ? 1.0 : -1.0);
      ASSERT_EQ(parse_number(format_number(value, shift), -shift), value) << format_number(value, shift);
    }
  }
}

TEST(FormatNumber, WritesWhatWasTyped) {
  for (const char* text :
       {"800", "5.3", "0.05", "-11.3", "300", "10010", "1.499", "0.15", "1.68257E-07", "0.1", "123456789", "-0.00025"})
    for (const int shift : {0, 9, -9, 3, -3})
      EXPECT_EQ(format_number(parse_number(text, shift).value(), -shift), text) << shift;
}

TEST(FormatNumber, ChoosesPlainDigitsForModerateExponents) {
  EXPECT_EQ(format_number(8e-7, 9), "800");
  EXPECT_EQ(format_number(0.0), "0");
  EXPECT_EQ(format_number(-0.0), "0");
  EXPECT_EQ(format_number(1e14), "100000000000000");
  EXPECT_EQ(format_number(1e15), "1E+15");
  EXPECT_EQ(format_number(1e-5), "0.00001");
  EXPECT_EQ(format_number(1.5e-6), "1.5E-06");
  EXPECT_EQ(format_number(-2.5e100), "-2.5E+100");
  EXPECT_EQ(format_number(120.0), "120");
  EXPECT_EQ(format_number(12.5), "12.5");
}

TEST(FormatNumber, NamesWhatIsNotFinite) {
  EXPECT_EQ(format_number(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::quiet_NaN(), 9), "nan");
  EXPECT_EQ(format_number(std::numeric_limits<double>::infinity(), -3), "inf");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(WithPrefix, ChoosesThePrefix) {
  EXPECT_EQ(with_prefix(5.3e9, "Hz"), "5.3 GHz");
  EXPECT_EQ(with_prefix(-800e-9, "s"), "-800 ns");
  EXPECT_EQ(with_prefix(0.0, "W"), "0 W");
  EXPECT_EQ(with_prefix(999.0, "m"), "999 m");
  EXPECT_EQ(with_prefix(1234.5678, "m", 3), "1.23 km");
  EXPECT_EQ(with_prefix(1e-15, "V"), "1e-15 V");
}

TEST(BytesText, ChoosesThePrefix) {
  EXPECT_EQ(bytes_text(0.0), "0 bytes");
  EXPECT_EQ(bytes_text(999.0), "999 bytes");
  EXPECT_EQ(bytes_text(1.5e6), "1.5 MB");
  EXPECT_EQ(bytes_text(999'999.0), "1 MB");
  EXPECT_EQ(bytes_text(2e12), "2 TB");
}

TEST(DurationText, ChoosesTheUnit) {
  EXPECT_EQ(duration_text(0.0), "below 1 ms");
  EXPECT_EQ(duration_text(0.25), "0.25 s");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(5.0 * 3600.0 + 7.0 * 60.0), "5 h 07 min");
  EXPECT_EQ(duration_text(3.5 * 24.0 * 3600.0), "3.5 days");
  EXPECT_EQ(about_duration_text(3.0), "about 3 s");
  EXPECT_EQ(about_duration_text(0.0), "below 1 ms");
}

// A remainder is cut, not rounded: no "1 min 60 s".
TEST(DurationText, NeverShowsAFullSmallerUnit) {
  EXPECT_EQ(duration_text(60.0), "1 min 00 s");
  EXPECT_EQ(duration_text(119.99), "1 min 59 s");
  EXPECT_EQ(duration_text(3599.9), "59 min 59 s");
  EXPECT_EQ(duration_text(3600.0), "1 h 00 min");
}

TEST(EqualIgnoringCase, ComparesAsciiLetters) {
  EXPECT_TRUE(equal_ignoring_case("Earth", "EARTH"));
  EXPECT_TRUE(equal_ignoring_case("", ""));
  EXPECT_FALSE(equal_ignoring_case("Earth", "Earth2"));
  EXPECT_FALSE(equal_ignoring_case("a[", "A{")) << "only letters have a case";
}

TEST(EditDistance, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("plane", "PLANE"), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("radar", "rader"), 1U);
}

TEST(NearestWord, IsTheClosestOrNone) {
  const std::vector<std::string> words{"STATIONARY", "TRAJECTORY", "CONST"};
  EXPECT_EQ(nearest_word("trajectry", words), "TRAJECTORY");
  EXPECT_EQ(nearest_word("konst", words), "CONST");
  EXPECT_EQ(nearest_word("banana", words), "");
  EXPECT_EQ(nearest_word("anything", std::vector<std::string>{}), "");
}

TEST(NearestWord, KeepsTheFirstOfEquallyNearWords) {
  EXPECT_EQ(nearest_word("bat", std::vector<std::string>{"cat", "rat"}), "cat");
}

// Two letters exchanged count as two changes, so that short words need more than a third of their length.
TEST(NearestWord, IsNotSoughtAmongWhatProgramsMade) {
  const std::string name(100000, 'x');
  EXPECT_EQ(nearest_word(name, std::vector<std::string>{name}), "");
  EXPECT_EQ(nearest_word("abd", std::vector<std::string>(1001, "abc")), "");
  EXPECT_EQ(nearest_word("abd", std::vector<std::string>(1000, "abc")), "abc");
}

TEST(NearestWord, AllowsOneChangeAndAThirdOfTheLength) {
  EXPECT_EQ(nearest_word("ab", std::vector<std::string>{"xb"}), "xb");
  EXPECT_EQ(nearest_word("ab", std::vector<std::string>{"xy"}), "");
  EXPECT_EQ(nearest_word("plnae", std::vector<std::string>{"plane"}), "plane");
  EXPECT_EQ(nearest_word("abcdef", std::vector<std::string>{"xyzdef"}), "xyzdef");
  EXPECT_EQ(nearest_word("abcdef", std::vector<std::string>{"xyzuef"}), "");
}

}  // namespace number_text_test
}  // namespace sarsim::core
