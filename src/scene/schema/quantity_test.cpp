#include "scene/schema/quantity.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>

#include "scene/schema/expression.hpp"

namespace sarsim::scene {

namespace quantity_test {

constexpr Quantity all_quantities[] = {Quantity::number,   Quantity::length,      Quantity::time,   Quantity::frequency,
                                       Quantity::angle,    Quantity::angle_rate,  Quantity::area,   Quantity::power,
                                       Quantity::ratio_db, Quantity::temperature, Quantity::voltage};

struct Typed {
  const char* text;
  Quantity quantity;
  double value;
};

TEST(Quantity, TypedTextsGiveExactValues) {
  const Typed table[] = {{"50 MHz", Quantity::frequency, 50e6},
                         {"3us", Quantity::time, 3e-6},
                         {"10 km", Quantity::length, 10e3},
                         {"1e3", Quantity::length, 1000.0},
                         {"  -2.5  mm ", Quantity::length, -2.5e-3},
                         {"+7", Quantity::number, 7.0},
                         {".5 GHz", Quantity::frequency, 0.5e9},
                         {"9.6 GHz", Quantity::frequency, 9.6e9},
                         {"50mhz", Quantity::frequency, 50e6},
                         {"50 MHZ", Quantity::frequency, 50e6},
                         {"800 ns", Quantity::time, 800e-9},
                         {"3 \xC2\xB5s", Quantity::time, 3e-6},
                         {"3 \xCE\xBCs", Quantity::time, 3e-6},
                         {"2 min", Quantity::time, 120.0},
                         {"\xE2\x88\x92"
                          "12\xC2\xB0",
                          Quantity::angle, -12.0},
                         {"30'", Quantity::angle, 0.5},
                         {"2 rpm", Quantity::angle_rate, 12.0},
                         {"5 deg/s", Quantity::angle_rate, 5.0},
                         {"2 m^2", Quantity::area, 2.0},
                         {"2 m\xC2\xB2", Quantity::area, 2.0},
                         {"5 cm2", Quantity::area, 5e-4},
                         {"20 dBsm", Quantity::area, 100.0},
                         {"3 mW", Quantity::power, 3e-3},
                         {"3 MW", Quantity::power, 3e6},
                         {"30 dBm", Quantity::power, 1.0},
                         {"30 dBW", Quantity::power, 1000.0},
                         {"x100", Quantity::ratio_db, 20.0},
                         {"12 dB", Quantity::ratio_db, 12.0},
                         {"290 K", Quantity::temperature, 290.0},
                         {"5 nV", Quantity::voltage, 5e-9},
                         {"100 ft", Quantity::length, 30.48},
                         {"2 nmi", Quantity::length, 3704.0},
                         {"42", Quantity::count, 42.0},
                         {"1e3", Quantity::count, 1000.0}};
  for (const Typed& typed : table) {
    const QuantityReading reading = read_quantity(typed.text, typed.quantity);
    ASSERT_TRUE(reading.value) << typed.text << ": " << reading.failure;
    EXPECT_DOUBLE_EQ(*reading.value, typed.value) << typed.text;
    EXPECT_EQ(reading.failure, "");
  }
  EXPECT_EQ(*read_quantity("50 MHz", Quantity::frequency).value, 50e6);
  EXPECT_EQ(*read_quantity("9.6 GHz", Quantity::frequency).value, 9.6e9);
  EXPECT_EQ(*read_quantity("800 ns", Quantity::time).value, 800e-9);
  EXPECT_NEAR(*read_quantity("1 rad", Quantity::angle).value, 57.295779513082323, 1e-13);
}

TEST(Quantity, ANumberWithoutAUnitIsInTheBareUnit) {
  EXPECT_EQ(*read_quantity("9.6", Quantity::frequency, "GHz").value, 9.6e9);
  EXPECT_EQ(*read_quantity("9.6", Quantity::frequency).value, 9.6);
  EXPECT_EQ(*read_quantity("9.6 MHz", Quantity::frequency, "GHz").value, 9.6e6);
  EXPECT_THROW(static_cast<void>(read_quantity("9.6", Quantity::frequency, "km")), std::invalid_argument);
}

struct Wrong {
  const char* text;
  Quantity quantity;
  const char* says;  // part of the failure
};

TEST(Quantity, WrongTextsAreRefusedWithTheReasonAndTheRemedy) {
  const Wrong table[] = {{"5 kg", Quantity::length, "'5 kg' is not a valid length; try m, nm"},
                         {"", Quantity::length, "nothing is typed; expected a length"},
                         {"5 m", Quantity::angle, "rad, mrad or minutes of arc (')"},
                         {"abc", Quantity::time, "'abc' is not a valid time"},
                         {"nan", Quantity::length, "'nan' is not a valid length"},
                         {"inf m", Quantity::length, "is not a valid length"},
                         {"1,5 m", Quantity::length, "the decimal mark is the point: 1.5"},
                         {",5", Quantity::length, "the decimal mark is the point: 0.5"},
                         {"1,000,000", Quantity::length, "has commas"},
                         {"100 1/s", Quantity::frequency, "has 1/s for a unit; write 100 Hz"},
                         {"60 MS/s", Quantity::frequency, "did you mean 'MHz'?"},
                         {"1 000", Quantity::length, "has a blank within the number; write 1000"},
                         {"5 mw", Quantity::power, "write mW or MW"},
                         {"5 mHz", Quantity::frequency, "write MHz"},
                         {"5 MV", Quantity::voltage, "write mV"},
                         {"1e999", Quantity::length, "is too large for a number"},
                         {"1e5000 dBm", Quantity::power, "is too large for a number"},
                         {"99999 dBW", Quantity::power, "is too large for a number"},
                         {"2.5", Quantity::count, "is not a valid whole number; try 3"},
                         {"3 m", Quantity::count, "has a unit, 'm'"},
                         {"x0", Quantity::ratio_db, "with a number above zero"},
                         {"x", Quantity::ratio_db, "a factor is written as x100"},
                         {"x1,5", Quantity::ratio_db, "a factor is written as x100"},
                         {"1.2.3", Quantity::number, "does not belong"},
                         {"-", Quantity::number, "is not a valid number"},
                         {"5 m s", Quantity::length, "is not a valid length"}};
  for (const Wrong& wrong : table) {
    const QuantityReading reading = read_quantity(wrong.text, wrong.quantity);
    EXPECT_FALSE(reading.value) << wrong.text;
    EXPECT_NE(reading.failure.find(wrong.says), std::string::npos) << wrong.text << " gives: " << reading.failure;
  }
}

TEST(Quantity, AFailureOfALongTextIsShort) {
  const QuantityReading reading = read_quantity("1 " + std::string(100000, 'k'), Quantity::length);
  EXPECT_FALSE(reading.value);
  EXPECT_LT(reading.failure.size(), 300U);
}

TEST(Quantity, ValuesAreShownWithTheUnitThatSuitsTheirSize) {
  EXPECT_EQ(quantity_text(5e7, Quantity::frequency), "50 MHz");
  EXPECT_EQ(quantity_text(999.0, Quantity::frequency), "999 Hz");
  EXPECT_EQ(quantity_text(1000.0, Quantity::frequency), "1 kHz");
  EXPECT_EQ(quantity_text(9.6e9, Quantity::frequency), "9.6 GHz");
  EXPECT_EQ(quantity_text(8e-7, Quantity::time), "800 ns");
  EXPECT_EQ(quantity_text(5e-6, Quantity::time), "5 us");
  EXPECT_EQ(quantity_text(3600.0, Quantity::time), "3600 s");
  EXPECT_EQ(quantity_text(1e-12, Quantity::time), "0.001 ns");
  EXPECT_EQ(quantity_text(0.05, Quantity::length), "50 mm");
  EXPECT_EQ(quantity_text(-12345.0, Quantity::length), "-12.345 km");
  EXPECT_EQ(quantity_text(0.0, Quantity::length), "0 m");
  EXPECT_EQ(quantity_text(0.5, Quantity::area), "0.5 m2");
  EXPECT_EQ(quantity_text(-3.5, Quantity::angle), "-3.5 deg");
  EXPECT_EQ(quantity_text(1e6, Quantity::power), "1 MW");
  EXPECT_EQ(quantity_text(30.0, Quantity::ratio_db), "30 dB");
  EXPECT_EQ(quantity_text(7.0, Quantity::count), "7");
  EXPECT_EQ(quantity_text(1e-6, Quantity::number), "1E-06");
}

TEST(Quantity, AValueCanBeShownInAGivenUnit) {
  EXPECT_EQ(quantity_text(5e7, Quantity::frequency, "GHz"), "0.05 GHz");
  EXPECT_EQ(quantity_text(1852.0, Quantity::length, "nmi"), "1 nmi");
  EXPECT_EQ(quantity_text(100.0, Quantity::area, "dBsm"), "20 dBsm");
  EXPECT_EQ(quantity_text(1.0, Quantity::power, "dBm"), "30 dBm");
  EXPECT_THROW(static_cast<void>(quantity_text(1.0, Quantity::length, "MHz")), std::invalid_argument);
}

TEST(Quantity, NumbersThatAreNoneAreShownAndRefused) {
  EXPECT_EQ(quantity_text(std::nan(""), Quantity::length), "nan m");
  EXPECT_EQ(quantity_text(-std::numeric_limits<double>::infinity(), Quantity::length), "-inf m");
}

TEST(Quantity, AnyValueIsReadBackBitForBit) {
  std::mt19937_64 engine(7);
  for (int i = 0; i < 200000; ++i) {
    auto value = std::bit_cast<double>(engine());
    if (i % 2 == 0) value = std::ldexp(static_cast<double>(engine() >> 11), static_cast<int>(engine() % 120) - 100);
    if (!std::isfinite(value) || value == 0.0) continue;
    const Quantity quantity = all_quantities[engine() % std::size(all_quantities)];
    const std::string text = quantity_text(value, quantity);
    const QuantityReading reading = read_quantity(text, quantity);
    // A few of the largest and smallest numbers leave double's range in the unit shown, never in the value.
    ASSERT_TRUE(reading.value) << text << ": " << reading.failure;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*reading.value), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

TEST(Quantity, TheMantissaShownIsBetweenOneAndAThousandWhereAUnitAllows) {
  std::mt19937_64 engine(8);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::pow(10.0, static_cast<double>(engine() % 1200) / 100.0);  // 1 to 1e12
    const std::string text = quantity_text(value, Quantity::frequency);
    const double mantissa = std::stod(text);
    EXPECT_GE(mantissa, 1.0) << text;
    if (value < 1e12) {
      EXPECT_LT(mantissa, 1000.0) << text;
    }
  }
}

TEST(Quantity, TheBaseUnitIsTheFirstThatMayBeTyped) {
  EXPECT_EQ(units_of(Quantity::length).front(), "m");
  EXPECT_EQ(units_of(Quantity::frequency), (std::vector<std::string_view>{"Hz", "kHz", "MHz", "GHz"}));
  EXPECT_TRUE(units_of(Quantity::count).empty());
  for (const Quantity quantity : all_quantities)
    for (const std::string_view unit : units_of(quantity))
      EXPECT_TRUE(read_quantity("1 " + std::string(unit), quantity).value) << unit;
}

TEST(Quantity, ASquareBelongsToAUnitAndNotToANumber) {
  EXPECT_EQ(read_quantity("2 m^2", Quantity::area).value, 2.0);
  EXPECT_EQ(read_quantity("2 m\xC2\xB2", Quantity::area).value, 2.0);
  EXPECT_FALSE(read_quantity("10^2 m", Quantity::length).value);
  EXPECT_FALSE(read_quantity("2\xC2\xB2", Quantity::number).value);
}

}  // namespace quantity_test

}  // namespace sarsim::scene

namespace sarsim::scene {
namespace quantity_test {

// Values by definition: 1 nmi = 1852 m, 1 ft = 0.3048 m, 1 mi = 1609.344 m, 6400 mil = 1 turn = 360 deg.
TEST(Quantity, KnowsTheUnitsOfAviatorsAndAntennaPeople) {
  struct Row {
    const char* text;
    Quantity quantity;
    double value;
  };
  const Row rows[]{{"100 kn", Quantity::speed, 100.0 * 1852.0 / 3600.0},
                   {"390 kt", Quantity::speed, 390.0 * 1852.0 / 3600.0},
                   {"36 km/h", Quantity::speed, 10.0},
                   {"10 ft/s", Quantity::speed, 3.048},
                   {"60 mph", Quantity::speed, 26.8224},
                   {"30 dBi", Quantity::ratio_db, 30.0},
                   {"10 dBd", Quantity::ratio_db, 12.15},
                   {"17 degC", Quantity::temperature, 290.15},
                   {"-40 \xC2\xB0"
                    "C",
                    Quantity::temperature, 233.15},
                   {"90 deg/min", Quantity::angle_rate, 1.5},
                   {"2 turn/min", Quantity::angle_rate, 12.0},
                   {"12 rpm", Quantity::angle_rate, 72.0},
                   {"0.5 rev/s", Quantity::angle_rate, 180.0},
                   {"1600 mil", Quantity::angle, 90.0},
                   {"30 arcmin", Quantity::angle, 0.5},
                   {"1800 arcsec", Quantity::angle, 0.5},
                   {"0.25 turn", Quantity::angle, 90.0},
                   {"10 NM", Quantity::length, 18520.0},
                   {"10 nmi", Quantity::length, 18520.0},
                   {"30000 ft", Quantity::length, 9144.0},
                   {"1 mi", Quantity::length, 1609.344},
                   {"3 in", Quantity::length, 0.0762},
                   {"250 ps", Quantity::time, 250e-12},
                   {"0.094 THz", Quantity::frequency, 94e9},
                   {"50 uW", Quantity::power, 50e-6},
                   {"60 dBm", Quantity::power, 1000.0},
                   {"0 dBkW", Quantity::power, 1000.0},
                   {"20 dBsm", Quantity::area, 100.0}};
  for (const Row& row : rows) {
    const QuantityReading read = read_quantity(row.text, row.quantity);
    ASSERT_TRUE(read.value) << row.text << ": " << read.failure;
    EXPECT_NEAR(*read.value, row.value, 1e-12 * std::abs(row.value)) << row.text;
    const QuantityResult evaluated = evaluate(row.text, row.quantity, {});
    ASSERT_TRUE(evaluated.value) << row.text << ": " << evaluated.fault->message;
    EXPECT_EQ(*evaluated.value, *read.value) << row.text;
  }
}

TEST(Quantity, SpellsOutWhatOtherSpellingsOfUnitsMean) {
  for (const auto& [text, quantity, says] :
       {std::tuple{"100 knots", Quantity::speed, "'kn'"}, std::tuple{"10 feet", Quantity::length, "'ft'"},
        std::tuple{"20 C", Quantity::temperature, "'degC'"}, std::tuple{"2 usec", Quantity::time, "'us'"},
        std::tuple{"5 degrees", Quantity::angle, "'deg'"}, std::tuple{"3 Watts", Quantity::power, "'W'"}}) {
    EXPECT_NE(read_quantity(text, quantity).failure.find(says), std::string::npos) << text;
    const QuantityResult result = evaluate(text, quantity, {});
    ASSERT_FALSE(result.value) << text;
    EXPECT_NE(result.fault->hint.find(says), std::string::npos) << text << ": " << result.fault->hint;
  }
}

TEST(Quantity, NamesOfLetComeBeforeTheFurtherUnits) {
  LetNames names;
  names.define("turn", 3.0);
  names.define("mil", std::string("2 km"));
  EXPECT_TRUE(names.resolve().empty());
  EXPECT_EQ(evaluate("turn", Quantity::number, names).value, 3.0);
  EXPECT_EQ(evaluate("mil * 2", Quantity::length, names).value, 4000.0);
  EXPECT_EQ(evaluate("turn", Quantity::angle, {}).value, 360.0);
}

}  // namespace quantity_test
}  // namespace sarsim::scene
