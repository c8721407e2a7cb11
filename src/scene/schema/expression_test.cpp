#include "scene/schema/expression.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <fmt/format.h>

namespace sarsim::scene {

namespace expression_test {

constexpr Quantity all_quantities[] = {
    Quantity::number,     Quantity::length, Quantity::time,  Quantity::frequency, Quantity::angle,
    Quantity::angle_rate, Quantity::area,   Quantity::power, Quantity::ratio_db,  Quantity::temperature,
    Quantity::voltage,    Quantity::speed,  Quantity::count};

constexpr double pi = std::numbers::pi;

LetNames named_values() {
  LetNames names;
  names.define("twice", "2 * speed");  // before what it uses
  names.define("speed", "240 m/s");
  names.define("azimuth", "30 deg");
  names.define("v", 3.0);
  names.define("lost", "1/0");
  names.define("uses_lost", "lost + 1");
  EXPECT_EQ(names.resolve().size(), 1U);
  return names;
}

struct Written {
  std::string text;
  Quantity quantity;
  double value;
  bool literal = false;
};

void expect_values(const std::vector<Written>& table) {
  const LetNames names = named_values();
  for (const Written& written : table) {
    const QuantityResult result = evaluate(written.text, written.quantity, names);
    ASSERT_TRUE(result.value) << written.text << ": " << result.fault->message;
    EXPECT_FALSE(result.fault);
    EXPECT_NEAR(*result.value, written.value, 4e-16 * std::abs(written.value)) << written.text;
    EXPECT_EQ(result.literal, written.literal) << written.text;
  }
}

TEST(Expression, EveryUnitHasItsClosedValue) {
  expect_values({{"7", Quantity::number, 7.0, true},
                 {"3 m", Quantity::length, 3.0, true},
                 {"3 nm", Quantity::length, 3e-9, true},
                 {"3 um", Quantity::length, 3e-6, true},
                 {"3 mm", Quantity::length, 3e-3, true},
                 {"3 cm", Quantity::length, 0.03, true},
                 {"3km", Quantity::length, 3000.0, true},
                 {"10 ft", Quantity::length, 3.048, true},
                 {"2 nmi", Quantity::length, 3704.0, true},
                 {"3us", Quantity::time, 3e-6, true},
                 {"3 \xC2\xB5s", Quantity::time, 3e-6, true},
                 {"2 min", Quantity::time, 120.0, true},
                 {"100 MHz", Quantity::frequency, 1e8, true},
                 {"5.3 GHz", Quantity::frequency, 5.3e9, true},
                 {"50mhz", Quantity::frequency, 5e7, true},
                 {"\xE2\x88\x92"
                  "12\xC2\xB0",
                  Quantity::angle, -12.0, true},
                 {"2 rad", Quantity::angle, 360.0 / pi, true},
                 {"5 mrad", Quantity::angle, 0.9 / pi, true},
                 {"30'", Quantity::angle, 0.5, true},
                 {"5 deg/s", Quantity::angle_rate, 5.0, true},
                 {"5 deg / s", Quantity::angle_rate, 5.0, true},
                 {"2 rpm", Quantity::angle_rate, 12.0, true},
                 {"1 rad/s", Quantity::angle_rate, 180.0 / pi, true},
                 {"2 m2", Quantity::area, 2.0, true},
                 {"2 m^2", Quantity::area, 2.0, true},
                 {"2 m\xC2\xB2", Quantity::area, 2.0, true},
                 {"5 cm^2", Quantity::area, 5e-4, true},
                 {"3 km^2", Quantity::area, 3e6, true},
                 {"20 dBsm", Quantity::area, 100.0, true},
                 {"-30 dBm", Quantity::power, 1e-6, true},
                 {"30 dBW", Quantity::power, 1000.0, true},
                 {"3 mW", Quantity::power, 3e-3, true},
                 {"3 MW", Quantity::power, 3e6, true},
                 {"-12 dB", Quantity::ratio_db, -12.0, true},
                 {"x100", Quantity::ratio_db, 20.0, true},
                 {"\xC3\x97 100", Quantity::ratio_db, 20.0, true},
                 {"290 K", Quantity::temperature, 290.0, true},
                 {"5 nV", Quantity::voltage, 5e-9, true},
                 {"240 m/s", Quantity::speed, 240.0, true},
                 {"7.5 km/s", Quantity::speed, 7500.0, true},
                 {"1e3", Quantity::count, 1000.0, true},
                 {"m/s", Quantity::speed, 1.0}});
}

TEST(Expression, OperationsFunctionsAndConstantsHaveTheirClosedValues) {
  expect_values({{"1 + 2 * 3 - 4 / 2", Quantity::number, 5.0},
                 {"8 / 4 / 2", Quantity::number, 1.0},
                 {"2 - 3 - 4", Quantity::number, -5.0},
                 {"2^3^2", Quantity::number, 512.0},
                 {"-2^2", Quantity::number, -4.0},
                 {"2^-1", Quantity::number, 0.5},
                 {"2 \xC3\x97 3", Quantity::number, 6.0},
                 {"--3", Quantity::number, 3.0, true},
                 {"sqrt(9)", Quantity::number, 3.0},
                 {"sqrt(4 m2)", Quantity::length, 2.0},
                 {"(4 m2)^0.5", Quantity::length, 2.0},
                 {"sin(90 deg)", Quantity::number, 1.0},
                 {"sin(180 deg)", Quantity::number, 0.0},
                 {"sin(-30 deg)", Quantity::number, -std::sin(pi / 6.0)},
                 {"sin(210 deg)", Quantity::number, -std::sin(pi / 6.0)},
                 {"cos(90 deg)", Quantity::number, 0.0},
                 {"cos(180 deg)", Quantity::number, -1.0},
                 {"tan(45 deg)", Quantity::number, 1.0},
                 {"sin(1)", Quantity::number, std::sin(1.0)},
                 {"cos(1)", Quantity::number, std::cos(1.0)},
                 {"tan(1)", Quantity::number, std::tan(1.0)},
                 {"asin(1)", Quantity::angle, 90.0},
                 {"acos(0)", Quantity::angle, 90.0},
                 {"atan(1)", Quantity::angle, 45.0},
                 {"atan2(-1 km, 1000 m)", Quantity::angle, -45.0},
                 {"abs(-3 m)", Quantity::length, 3.0},
                 {"min(3 m, 2 m, 2.5 m)", Quantity::length, 2.0},
                 {"max(3 m, 1 km)", Quantity::length, 1000.0},
                 {"max(1,5)", Quantity::number, 5.0},
                 {"log10(1000)", Quantity::number, 3.0},
                 {"pi", Quantity::number, pi},
                 {"c", Quantity::speed, 299792458.0},
                 {"c / (2 * 150 MHz)", Quantity::length, 299792458.0 / 3e8},
                 {"10*log10(100)", Quantity::ratio_db, 20.0},
                 {"3 dB + 2 * 4 dB", Quantity::ratio_db, 11.0},
                 {"0.5 dB/km * 4 km", Quantity::ratio_db, 2.0},
                 {"-30 dBm + 1 W", Quantity::power, 1.000001},
                 {"1 W - 30 dBm", Quantity::power, 0.0},
                 {"2 * 30 dBm", Quantity::power, 2.0},
                 {"-(30 dBm)", Quantity::power, -1.0},
                 {"2 Hz * 360 deg", Quantity::angle_rate, 720.0},
                 {"15 km * sin(azimuth)", Quantity::length, 15000.0 * std::sin(pi / 6.0)},
                 {"-speed * sin(azimuth)", Quantity::speed, -240.0 * std::sin(pi / 6.0)},
                 {"15 km / 2 s", Quantity::speed, 7500.0},
                 {"15 km / (240 m/s)", Quantity::time, 62.5},
                 {"twice / v", Quantity::speed, 160.0}});
}

TEST(Expression, ANumberWithAUnitIsReadExactlyAsAQuantityIs) {
  const LetNames none;
  std::mt19937_64 engine(1);
  for (int i = 0; i < 100000; ++i) {
    const Quantity quantity = all_quantities[engine() % std::size(all_quantities)];
    const auto units = units_of(quantity);
    const double number =
        static_cast<double>(engine() % 2000000) * std::pow(10.0, static_cast<double>(engine() % 12) - 9);
    const std::string_view unit = units.empty() ? "" : units[engine() % units.size()];
    const std::string text = fmt::format("{}{:.{}g} {}", engine() % 2 == 0 ? "-" : "", number, engine() % 17 + 1, unit);
    const QuantityReading reading = read_quantity(text, quantity);
    const QuantityResult result = evaluate(text, quantity, none);
    ASSERT_EQ(result.value, reading.value) << text;
    // The way through the grammar gives the same bits: with a sum that changes nothing, and in parentheses.
    if (!reading.value) continue;
    ASSERT_EQ(evaluate("(" + text + ")", quantity, none).value, reading.value) << text;
  }
  for (const char* text : {"9.6 GHz", "0.1 GHz", "1.1 um", "323.13010235415595 deg"})
    for (const Quantity quantity : all_quantities) {
      const auto value = read_quantity(text, quantity).value;
      if (!value) continue;
      EXPECT_EQ(evaluate(std::string("(") + text + ")", quantity, none).value, value);
    }
}

TEST(Expression, APureNumberCountsInTheBaseUnitAndIsBare) {
  const LetNames names = named_values();
  EXPECT_TRUE(evaluate("5.3", Quantity::frequency, names).bare);
  EXPECT_TRUE(evaluate("2 * 3", Quantity::frequency, names).bare);
  EXPECT_FALSE(evaluate("5.3 Hz", Quantity::frequency, names).bare);
  EXPECT_FALSE(evaluate("5.3", Quantity::number, names).bare);
  EXPECT_EQ(evaluate("12", Quantity::angle, names).value, 12.0);
}

struct Wrong {
  std::string text;
  Quantity quantity;
  std::string blamed;  // the characters of the range
  std::string says;    // part of message, expected and hint, which are joined with " | "
};

void expect_faults(const std::vector<Wrong>& table) {
  const LetNames names = named_values();
  for (const Wrong& wrong : table) {
    const QuantityResult result = evaluate(wrong.text, wrong.quantity, names);
    ASSERT_TRUE(result.fault) << wrong.text;
    EXPECT_FALSE(result.value) << wrong.text;
    const ExpressionFault& fault = *result.fault;
    ASSERT_LE(fault.begin, fault.end);
    ASSERT_LE(fault.end, wrong.text.size());
    EXPECT_EQ(wrong.text.substr(fault.begin, fault.end - fault.begin), wrong.blamed) << wrong.text;
    const std::string all = fault.message + " | " + fault.expected + " | " + fault.hint;
    EXPECT_NE(all.find(wrong.says), std::string::npos) << wrong.text << " gives: " << all;
  }
}

TEST(Expression, OtherDimensionsAreRefusedInTheWordsOfTheField) {
  expect_faults({
      {" 1 km", Quantity::area, "1 km", "'1 km' is a length; the field takes an area, in m2, cm2 or dBsm"},
      {"100 MHz", Quantity::time, "100 MHz", "is a frequency; the field takes a time, in s, ns, us, ms, min or h"},
      {"3 m", Quantity::number, "3 m", "'3 m' is a length; the field takes a number without a unit"},
      {"3 m", Quantity::count, "3 m", "the field takes a whole number without a unit"},
      {"5 m/s^2", Quantity::speed, "5 m/s^2", "is an acceleration; the field takes a speed"},
      {"20 dB", Quantity::area, "20 dB", "is a ratio in decibels; the field takes an area"},
      {"15 km / 240 m/s", Quantity::time, "15 km / 240 m/s", "write / (240 m/s) to divide by all of it"},
      {"5 deg/s * 3 m", Quantity::speed, "5 deg/s * 3 m", "an angle is a unit of its own; divide by 1 rad"},
      {"3 m / 1 s", Quantity::length, "3 m / 1 s", "is a speed"},
      {"5 + 3 m", Quantity::length, "5 + 3 m", "'5' is a pure number, '3 m' is a length"},
      {"5 + 3 m", Quantity::length, "5 + 3 m", "does '5' lack a unit?"},
      {"2 * (3 s - 1 m)", Quantity::length, "3 s - 1 m", "'3 s' is a time, '1 m' is a length"},
      {"2 - (-3 m + 1 s)", Quantity::length, "-3 m + 1 s", "'-3 m' is a length"},
      {"30 dBm + 3 dB", Quantity::power, "30 dBm + 3 dB", "multiply it by 10^(3/10)"},
      {"3 dB * 2 dB", Quantity::ratio_db, "3 dB * 2 dB", "decibels are added"},
      {"1 / 2 dB", Quantity::ratio_db, "1 / 2 dB", "decibels are added"},
      {"3 dB^2", Quantity::ratio_db, "dB^2", "has no power 2"},
      {"2^(1 m)", Quantity::number, "(1 m)", "a pure number as exponent"},
      {"2 * 4 m^1.5", Quantity::length, "m^1.5", "has no power 1.5"},
      {"(3 m)^0.5", Quantity::length, "(3 m)^0.5", "has no power 0.5"},
      {"1 m^100", Quantity::length, "m^100", "has no power 100"},
      {"m^60 * m^60", Quantity::length, "m^60 * m^60", "powers of units go to 99"},
      {"sin(3 m)", Quantity::number, "3 m", "an angle, or a pure number in radians, as argument of sin"},
      {"asin(3 m)", Quantity::angle, "3 m", "a pure number as argument of asin"},
      {"log10(3 m)", Quantity::number, "3 m", "a pure number as argument of log10"},
      {"sqrt(3 m)", Quantity::length, "3 m", "even powers"},
      {"atan2(1 m, 1 s)", Quantity::angle, "1 s", "a length as argument of atan2"},
      {"max(1 m, 2 m, 3)", Quantity::length, "3", "a length as argument of max"},
  });
}

TEST(Expression, MistakesOfWritingAreRefusedAtTheirPlace) {
  expect_faults({
      {"", Quantity::length, "", "nothing is written"},
      {"  ", Quantity::length, "  ", "nothing is written"},
      {"2 * ", Quantity::length, "*", "ends too early"},
      {"2 * (3", Quantity::number, "(", "'(' is not closed"},
      {"max(2, 3", Quantity::number, "(", "'(' is not closed"},
      {"2 * 3)", Quantity::number, ")", "')' closes nothing"},
      {"2 ** 3", Quantity::number, "*", "a power is written with ^"},
      {"()", Quantity::number, ")", "is missing before ')'"},
      {"1, 2", Quantity::number, "1,", "has a comma after the number"},
      {"v, 2", Quantity::number, ",", "outside the arguments"},
      {"1,5 m", Quantity::length, "1,5", "'1,5 m' has a comma; the decimal mark is the point: 1.5"},
      {"2 * 1,5 m", Quantity::length, "1,5", "the decimal mark is the point: 1.5"},
      {"max((1,5), 2)", Quantity::number, "1,5", "the decimal mark is the point: 1.5"},
      {",5 m", Quantity::length, ",5", "the decimal mark is the point: 0.5"},
      {"1,000,000", Quantity::length, "1,000,000", "has commas"},
      {"1 000 m", Quantity::length, "1 000", "has a blank within the number; write 1000"},
      {"100 1/s", Quantity::frequency, "100 1/s", "'100 1/s' has 1/s for a unit; write 100 Hz"},
      {"60 MS/s", Quantity::frequency, "MS/s", "'MS/s' is not a known unit |  | write 60 MHz"},
      {"2 * 1.5 GS/s", Quantity::frequency, "GS/s", "write 1.5 GHz"},
      {"900 kS/s", Quantity::frequency, "kS/s", "write 900 kHz"},
      {"60 MSa/s", Quantity::frequency, "MSa/s", "write 60 MHz"},
      {"60 Msps", Quantity::frequency, "Msps", "did you mean 'MHz'?"},
      {"12 bit", Quantity::count, "bit", "'bit' is not a known unit |  | write 12"},
      {"10 dBmW", Quantity::power, "dBmW", "did you mean 'dBm'?"},
      {"20 dBc", Quantity::ratio_db, "dBc", "did you mean 'dB'?"},
      {"1.2.3", Quantity::number, "1.2.3", "does not belong after one"},
      {".", Quantity::number, ".", "does not belong"},
      {"sin(1,5 deg)", Quantity::number, "sin(1,5 deg)", "the decimal mark is the point"},
      {"min(3)", Quantity::number, "min(3)", "'min(3)' has 1 argument | at least 2 for min"},
      {"atan2(1)", Quantity::angle, "atan2(1)", "2 for atan2"},
      {"sin 3", Quantity::number, "sin", "'sin' is a function"},
      {"foo(3)", Quantity::number, "foo", "is not a known function"},
      {"sine(3)", Quantity::number, "sine", "did you mean 'sin'?"},
      {"2 + dBm", Quantity::power, "dBm", "write 30 dBm"},
      {"5 kg", Quantity::length, "kg", "'kg' is not a known unit"},
      {"5 mHz", Quantity::frequency, "mHz", "write MHz with these capital"},
      {"2 * 5 mw", Quantity::power, "mw", "write mW or MW"},
      {"2 * mhz", Quantity::frequency, "mhz", "did you mean 'MHz'?"},
      {"5 v", Quantity::voltage, "5 v", "write 5*v"},
      {"5 pi", Quantity::number, "5 pi", "write 5*pi"},
      {"3 * sped", Quantity::speed, "sped", "did you mean 'speed'?"},
      {"x", Quantity::length, "x", "'x' is not a known name or unit"},
      {"speed 3", Quantity::speed, "3", "an operator is missing before '3'"},
      {"speed (3)", Quantity::speed, "(", "a product is written with *"},
      {"3 m \xE2\x82\xAC", Quantity::length, "\xE2\x82\xAC", "'\xE2\x82\xAC' does not belong in an expression"},
      {"2 * \xC2\xB5s @", Quantity::time, "@", "'@' does not belong"},
      {std::string("3 m\0x", 5), Quantity::length, std::string("\0", 1), "does not belong"},
      {"2.5", Quantity::count, "2.5", "'2.5' is not a whole number | a whole number | try 3"},
      {"7/2", Quantity::count, "7/2", "try 4"},
      {"x0", Quantity::ratio_db, "x0", "with a number above zero"},
  });
}

TEST(Expression, ValuesThatAreNoNumbersAreRefusedAtTheirPlace) {
  expect_faults({{"2 + 1/0", Quantity::number, "1/0", "'1/0' divides by zero"},
                 {"1 / (2 - 2)", Quantity::number, "1 / (2 - 2)", "divides by zero"},
                 {"3 * sqrt(-1 m2)", Quantity::length, "sqrt(-1 m2)", "has no value | an argument of 0 or more"},
                 {"asin(2)", Quantity::angle, "asin(2)", "from -1 to 1"},
                 {"acos(-2)", Quantity::angle, "acos(-2)", "from -1 to 1"},
                 {"log10(0)", Quantity::number, "log10(0)", "above 0"},
                 {"tan(90 deg)", Quantity::number, "tan(90 deg)", "has no value"},
                 {"0^-1", Quantity::number, "0^-1", "has no value"},
                 {"(-8)^(1/3)", Quantity::number, "(-8)^(1/3)", "has no value"},
                 {"2 * 10^400", Quantity::number, "10^400", "is too large"},
                 {"1e308 * 10", Quantity::number, "1e308 * 10", "is too large for a number"},
                 {"1e308 + 1e308", Quantity::number, "1e308 + 1e308", "is too large for a number"},
                 {"1e999 m", Quantity::length, "1e999 m", "is too large for a number"},
                 {"99999 dBm", Quantity::power, "99999 dBm", "is too large for a number"},
                 {"1e303 km^2", Quantity::area, "1e303 km^2", "is too large"},
                 {"lost + 2", Quantity::number, "lost", "'lost' of [let] has no value"}});
}

std::string said(const NameFault& fault) {
  return fmt::format("{} {} {}-{}: {} | {} | {}", fault.name, fault.of_name ? "name" : "value", fault.fault.begin,
                     fault.fault.end, fault.fault.message, fault.fault.expected, fault.fault.hint);
}

TEST(Expression, NamesThatCannotBeAreRefusedWithTheReason) {
  LetNames names;
  for (const char* name : {"m", "dBm", "pi", "c", "sin", "my-speed", "1x", "", "h\xC3\xB6he", "good_1"})
    names.define(name, 1.0);
  const auto faults = names.resolve();
  ASSERT_EQ(faults.size(), 9U);
  const char* says[] = {"'m' is the name of a unit",
                        "'dBm' is the name of a unit",
                        "'pi' is the name of a constant",
                        "'c' is the name of a constant",
                        "'sin' is the name of a function",
                        "write 'my_speed'",
                        "write '_1x'",
                        "'' is not a valid name",
                        "is not a valid name"};
  for (std::size_t i = 0; i < faults.size(); ++i) {
    EXPECT_TRUE(faults[i].of_name);
    EXPECT_EQ(faults[i].fault.end, faults[i].name.size());
    EXPECT_NE(said(faults[i]).find(says[i]), std::string::npos) << said(faults[i]);
  }
  EXPECT_EQ(names.all(), std::vector<std::string_view>{"good_1"});
  EXPECT_EQ(evaluate("5 * m", Quantity::length, names).value, 5.0);  // the metre, not the refused name
}

TEST(Expression, NamesAreUsedInAnyOrderAndCirclesAreToldWithTheirChain) {
  LetNames names;
  names.define("a", "1 + b");
  names.define("b", "2 * c1");
  names.define("c1", "a / 3");
  names.define("self", "self + 1");
  names.define("user", "a + 2");  // no fault of its own
  names.define("unknown", "3 * bb");
  names.define("endless", std::numeric_limits<double>::infinity());
  names.define("fine", "later^2");
  names.define("later", "3 m");
  const auto faults = names.resolve();
  ASSERT_EQ(faults.size(), 4U);
  EXPECT_NE(said(faults[0]).find("a value 4-5: 'a' depends on itself: a -> b -> c1 -> a"), std::string::npos);
  EXPECT_NE(said(faults[1]).find("self value 0-4: 'self' depends on itself: self -> self"), std::string::npos);
  EXPECT_NE(said(faults[2]).find("unknown value 4-6: 'bb' is not a known name or unit"), std::string::npos);
  EXPECT_NE(said(faults[2]).find("did you mean 'b'?"), std::string::npos);
  EXPECT_NE(said(faults[3]).find("endless value 0-0: inf is not a number"), std::string::npos);
  EXPECT_EQ(names.find("user"), nullptr);
  EXPECT_TRUE(names.contains("user"));
  EXPECT_EQ(names.find("fine")->value, 9.0);
  EXPECT_EQ(names.find("fine")->dimension, dimension_of(Quantity::area));
  EXPECT_TRUE(evaluate("user", Quantity::number, names).fault->follows);
  names.define("a", 6.0);  // the command line's --let
  EXPECT_EQ(names.resolve().size(), 3U);
  EXPECT_EQ(names.find("user")->value, 8.0);
  EXPECT_EQ(names.find("b")->value, 4.0);
}

TEST(Expression, ANameTakesTheValueOfItsTextBitForBit) {
  LetNames names;
  names.define("carrier", "9.6 GHz");
  names.define("azimuth", "323.13010235415595 deg");
  EXPECT_TRUE(names.resolve().empty());
  EXPECT_EQ(evaluate("carrier", Quantity::frequency, names).value, 9.6e9);
  EXPECT_EQ(evaluate("azimuth", Quantity::angle, names).value, 323.13010235415595);
}

// Random expressions of lengths and times, written and computed side by side.
class RandomExpression {
 public:
  explicit RandomExpression(std::uint64_t seed) : engine_(seed) {}

  double sum(std::string& text, int metres, int seconds, int depth) {
    double value = product(text, metres, seconds, depth);
    for (std::uint64_t i = draw(3); i > 0; --i) {
      const bool minus = draw(2) == 0;
      text += minus ? " - " : "+";
      const double next = product(text, metres, seconds, depth);
      value = kept(minus ? value - next : value + next);
    }
    return value;
  }

  // Whether all that was computed on the way is finite: the evaluation refuses what is not where it comes up.
  [[nodiscard]] bool all_finite() const { return all_finite_; }

 private:
  double kept(double value) {
    all_finite_ = all_finite_ && std::isfinite(value);
    return value;
  }

  std::uint64_t draw(std::uint64_t below) { return engine_() % below; }

  double product(std::string& text, int metres, int seconds, int depth) {
    const int a = static_cast<int>(draw(5)) - 2, b = static_cast<int>(draw(5)) - 2;
    switch (draw(4)) {
      case 0: {
        const double left = factor(text, metres - a, seconds - b, depth);
        text += draw(2) == 0 ? "*" : " \xC3\x97 ";
        return kept(left * factor(text, a, b, depth));
      }
      case 1: {
        const double left = factor(text, metres + a, seconds + b, depth);
        text += " /";
        return kept(left / factor(text, a, b, depth));
      }
      default: return factor(text, metres, seconds, depth);
    }
  }

  double factor(std::string& text, int metres, int seconds, int depth) {
    if (depth == 0) return literal(text, metres, seconds);
    double value = 0.0;
    switch (draw(6)) {
      case 0:
        text += "-(";
        value = -sum(text, metres, seconds, depth - 1);
        break;
      case 1:
        text += "abs( ";
        value = std::abs(sum(text, metres, seconds, depth - 1));
        break;
      case 2:
        text += "max(";
        value = sum(text, metres, seconds, depth - 1);
        text += ',';
        value = std::max(value, sum(text, metres, seconds, depth - 1));
        break;
      case 3:
        text += "sqrt(abs(";
        value = std::sqrt(std::abs(sum(text, 2 * metres, 2 * seconds, depth - 1)));
        text += ')';
        break;
      case 4:
        text += '(';
        value = sum(text, metres, seconds, depth - 1);
        break;
      default: return literal(text, metres, seconds);
    }
    text += ')';
    return value;
  }

  double literal(std::string& text, int metres, int seconds) {
    if (metres != 0 && seconds != 0) {
      text += '(';
      const double left = literal(text, metres, 0);
      text += "*";
      const double value = kept(left * literal(text, 0, seconds));
      text += ')';
      return value;
    }
    struct Prefix {
      const char* name;
      int exponent;
    };
    static constexpr Prefix lengths[] = {{"km", 3}, {"m", 0}, {"mm", -3}, {"nm", -9}};
    static constexpr Prefix times[] = {{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}};
    const std::string digits = fmt::format("{}.{}", draw(1000), draw(1000) + 1);
    const int power = metres + seconds;
    text += digits;
    if (power == 0) return kept(std::strtod(digits.c_str(), nullptr));
    const Prefix& unit = metres != 0 ? lengths[draw(4)] : times[draw(4)];
    text += fmt::format("{}{}", draw(2) == 0 ? " " : "", unit.name);
    if (power != 1 || draw(4) == 0) text += fmt::format("^{}", power);
    return kept(std::strtod(fmt::format("{}e{}", digits, unit.exponent * power).c_str(), nullptr));
  }

  std::mt19937_64 engine_;
  bool all_finite_ = true;
};

TEST(Expression, RandomExpressionsAgreeWithTheirComputationAlongside) {
  const LetNames none;
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    RandomExpression random(seed);
    const int kind = static_cast<int>(seed % 4);
    std::string text;
    const double value = random.sum(text,
                                    kind == 1   ? 1
                                    : kind == 2 ? 2
                                                : 0,
                                    kind == 3 ? 1 : 0, static_cast<int>(seed % 7 % 5));
    const Quantity quantities[] = {Quantity::number, Quantity::length, Quantity::area, Quantity::time};
    const QuantityResult result = evaluate(text, quantities[kind], none);
    if (!random.all_finite()) {
      EXPECT_TRUE(result.fault) << text;
      continue;
    }
    ++compared;
    ASSERT_TRUE(result.value) << text << ": " << result.fault->message;
    ASSERT_EQ(*result.value, value) << text;
  }
  EXPECT_GT(compared, 3600);
}

TEST(Expression, TextsReadBackBitForBit) {
  const LetNames none;
  std::mt19937_64 engine(3);
  using Limits = std::numeric_limits<double>;
  int count = 0;
  for (const Quantity quantity : all_quantities) {
    const auto check = [&](double value) {
      if (!std::isfinite(value) || (quantity == Quantity::count && value != std::floor(value))) return;
      const std::string text = exact_quantity_text(value, quantity);
      const QuantityResult result = evaluate(text, quantity, none);
      ASSERT_TRUE(result.value) << text;
      ASSERT_EQ(std::bit_cast<std::uint64_t>(*result.value), std::bit_cast<std::uint64_t>(value)) << text;
      if (++count % 10 == 0) {
        ASSERT_EQ(read_quantity(text, quantity).value, value) << text;
      }
      ASSERT_TRUE(result.literal);
    };
    for (const double value :
         {0.0, 1.0, 1e3, 999.9999999999999, 0.1, Limits::max(), Limits::min(), Limits::denorm_min(),
          Limits::min() - Limits::denorm_min(), 1e22, 1e23, 5e-324 * 12345.0})
      check(value), check(-value);
    for (int i = 0; i < 100000; ++i) {
      const std::uint64_t bits = engine();
      const double any = i % 4 == 0 ? std::bit_cast<double>(bits & 0x800FFFFFFFFFFFFFU)  // denormal
                         : i % 2 == 0
                             ? std::bit_cast<double>(bits)
                             : std::ldexp(static_cast<double>(bits >> 11), static_cast<int>(engine() % 120) - 100);
      check(quantity == Quantity::count ? std::round(any) : any);
    }
  }
  EXPECT_EQ(exact_quantity_text(-0.0, Quantity::length), "-0 m");
  EXPECT_EQ(exact_quantity_text(9.6e9, Quantity::frequency), "9.6 GHz");
}

TEST(Expression, NestingIsLimitedAndNotTooNarrow) {
  const LetNames none;
  const auto nested = [](const std::string& open, std::size_t count, const std::string& close) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += open;
    text += "1";
    for (std::size_t i = 0; i < count; ++i) text += close;
    return text;
  };
  EXPECT_EQ(evaluate(nested("(", 100, ")"), Quantity::number, none).value, 1.0);
  EXPECT_EQ(evaluate(nested("-", 100, ""), Quantity::number, none).value, 1.0);
  for (const auto& text : {nested("(", 101, ")"), nested("-", 101, ""), nested("abs(", 101, ")"), nested("1^", 101, ""),
                           nested("(", 1000000, ")"), nested("(", 1000000, "")}) {
    const QuantityResult result = evaluate(text, Quantity::number, none);
    ASSERT_TRUE(result.fault);
    EXPECT_EQ(result.fault->message, "the expression is nested more than 100 deep");
    EXPECT_LT(result.fault->message.size() + result.fault->hint.size(), 200U);
  }
}

std::string repeated(const std::string& piece, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += piece;
  return text;
}

TEST(Expression, LongTextsTakeTimeInProportionAndHaveShortFaults) {
  const LetNames names = named_values();
  EXPECT_EQ(evaluate("1" + repeated(" + 1", 300000), Quantity::number, names).value, 300001.0);
  EXPECT_EQ(evaluate("1" + repeated(" * -1", 300000), Quantity::number, names).value, 1.0);
  EXPECT_EQ(evaluate("max(0" + repeated(", 3 m / (3 m)", 100000) + ")", Quantity::number, names).value, 1.0);
  for (const std::string& text :
       {repeated("9", 1000000), repeated("1,", 300000), repeated("1 ", 300000), "2 * " + repeated("q", 1000000),
        "5 " + repeated("q", 1000000), repeated("1.", 300000), repeated("\xC2\xB5", 300000), repeated("\x80", 300000),
        "(" + repeated("1+", 300000) + "$", repeated("/", 300000),
        "3 m" + repeated(" / 3 m", 300000) + repeated(" / s", 300000)}) {
    const QuantityResult result = evaluate(text, Quantity::length, names);
    ASSERT_TRUE(result.fault) << text.substr(0, 20);
    EXPECT_LE(result.fault->end, text.size());
    EXPECT_LT(result.fault->message.size() + result.fault->expected.size() + result.fault->hint.size(), 600U);
  }
}

TEST(Expression, LongChainsAndWebsOfNamesAreResolved) {
  constexpr int count = 50000;
  LetNames chain;
  for (int i = 0; i < count; ++i) chain.define(fmt::format("n{}", i), fmt::format("n{} + 1", i + 1));
  chain.define(fmt::format("n{}", count), 1.0);
  EXPECT_TRUE(chain.resolve().empty());
  EXPECT_EQ(chain.find("n0")->value, count + 1.0);
  LetNames circle;  // each leads back to the first and on to the next, the last to the first
  for (int i = 0; i < count; ++i) circle.define(fmt::format("n{}", i), fmt::format("n0 + n{}", (i + 1) % count));
  const auto faults = circle.resolve();
  ASSERT_FALSE(faults.empty());
  for (const NameFault& fault : faults) EXPECT_LT(fault.fault.message.size(), 600U);
}

TEST(Expression, AnyBytesGiveAValueOrAFaultWithinTheText) {
  const LetNames names = named_values();
  const std::string_view pieces[] = {"1",        "2.5",  "e3",       "m",        "km",    "s",  "dB", "dBm",  "deg",
                                     "+",        "-",    "*",        "/",        "^",     "(",  ")",  ",",    " ",
                                     "pi",       "sin(", "max(",     "sqrt(",    "speed", "x",  "v",  "lost", "'",
                                     "\xC2\xB2", ".",    "\xC3\x97", "\xC2\xB0", "\xFF",  "^2", "0.5"};
  std::mt19937_64 engine(5);
  int values = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text;
    for (std::uint64_t n = engine() % 9; n > 0; --n) text += pieces[engine() % std::size(pieces)];
    const QuantityResult result = evaluate(text, all_quantities[engine() % std::size(all_quantities)], names);
    ASSERT_NE(result.value.has_value(), result.fault.has_value()) << text;
    if (result.value) {
      ++values;
      ASSERT_TRUE(std::isfinite(*result.value)) << text;
    } else {
      ASSERT_LE(result.fault->begin, result.fault->end) << text;
      ASSERT_LE(result.fault->end, text.size()) << text;
      ASSERT_FALSE(result.fault->message.empty()) << text;
    }
  }
  EXPECT_GT(values, 1000);
}

TEST(Expression, WhatReadQuantityReadsIsReadTheSame) {
  const LetNames none;
  const std::string_view pieces[] = {"1", "2.5", "-", "+",   " ",  "e3",  "M",   "m",        "HZ", "Hz", "w",
                                     "W", "s",   "x", "deg", "/s", "dBm", "m^2", "\xC2\xB0", "k",  "u"};
  std::mt19937_64 engine(6);
  int same = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text;
    for (std::uint64_t n = engine() % 5 + 1; n > 0; --n) text += pieces[engine() % std::size(pieces)];
    const Quantity quantity = all_quantities[engine() % std::size(all_quantities)];
    const auto reading = read_quantity(text, quantity).value;
    if (!reading) continue;
    ++same;
    ASSERT_EQ(evaluate(text, quantity, none).value, reading) << text;
  }
  EXPECT_GT(same, 5000);
}

}  // namespace expression_test

}  // namespace sarsim::scene
