#include "radar/receiver/convert_row.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <hwy/targets.h>

#include "core/report/expect.hpp"
#include "radar/receiver/converter.hpp"

namespace sarsim::radar {
namespace convert_row_test {

using Row = std::vector<std::complex<double>>;

struct Conversion {
  std::vector<std::int64_t> counts;
  ConversionTally tally;
};

void expect_equal(const ConversionTally& got, const ConversionTally& expected) {
  EXPECT_EQ(got.maximum_v, expected.maximum_v);
  EXPECT_EQ(got.saturated, expected.saturated);
  EXPECT_EQ(got.zero, expected.zero);
  EXPECT_EQ(got.not_numbers, expected.not_numbers);
}

// Counts and tally are those of the definition, on every instruction set; without counts the tally alone.
void expect_definition(const Converter& converter, const Row& volts) {
  Conversion expected;
  expected.counts.resize(2 * volts.size());
  converter.convert_plainly(volts, expected.counts, expected.tally);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    Conversion got;
    got.counts.assign(2 * volts.size(), 77);
    converter.convert(volts, got.counts, got.tally);
    EXPECT_EQ(got.counts, expected.counts) << converter.bits << " bits, " << converter.lsb_v;
    expect_equal(got.tally, expected.tally);
    ConversionTally alone;
    converter.convert(volts, {}, alone);
    expect_equal(alone, expected.tally);
  }
  hwy::SetSupportedTargetsForTest(0);
}

constexpr double lsbs_v[] = {1.0, 0.25, 0.1, 1.0 / 3.0, 1e-10, 3.7e-7, 0x1.fffffffffffffp-20, 0x1.0000000000001p3,
                             7e40};
constexpr int bits_of_converters[] = {1, 2, 8, 12, 16, 31, 32, 48, 50, 51, 53, 64};

// Halves, the numbers that round to them when they are multiplied or divided, and their neighbours.
Row around_halves(double lsb_v, double reach, std::mt19937_64& random) {
  std::uniform_real_distribution<double> count(-reach, reach);
  std::uniform_int_distribution<int> steps(-4, 4);
  const auto near_half = [&] {
    double v = (std::floor(count(random)) + 0.5) * lsb_v;
    const int step = steps(random);
    for (int i = 0; i < std::abs(step); ++i) v = std::nextafter(v, step > 0 ? 1e300 : -1e300);
    return v;
  };
  Row row;
  for (int i = 0; i < 999; ++i) row.emplace_back(near_half(), i % 3 == 0 ? near_half() : count(random) * lsb_v);
  return row;
}

TEST(Converter, GivesTheCountsOfTheDefinitionAroundHalves) {
  std::mt19937_64 random(1998);
  for (const int bits : bits_of_converters)
    for (const double lsb_v : lsbs_v)
      for (const double reach : {1.0, 3.0, 300.0, 1e6, std::ldexp(1.1, bits - 1)})
        expect_definition({bits, lsb_v}, around_halves(lsb_v, reach, random));
}

TEST(Converter, GivesTheCountsOfTheDefinitionForAnyNumbers) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> scale(-30.0, 30.0);
  for (const int bits : bits_of_converters)
    for (const double lsb_v : lsbs_v)
      for (const double spread : {0.3, 1.0, 100.0, std::ldexp(1.0, bits - 1)}) {
        Row row;
        for (int i = 0; i < 501; ++i)
          row.emplace_back(spread * lsb_v * normal(random), spread * lsb_v * normal(random));
        for (int i = 0; i < 60; ++i) row.emplace_back(std::pow(10.0, scale(random)), -std::pow(10.0, scale(random)));
        expect_definition({bits, lsb_v}, row);
      }
}

TEST(Converter, GivesTheCountsOfTheDefinitionAtTheEdgesOfNumbers) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  const std::vector<double> edges{0.0,    -0.0,    least,  -least, 1e-310, -1e-310, 1e-200,   1.0,
                                  -1.0,   127.5,   -127.5, 128.5,  -128.5, 0x1p49,  -0x1p50,  0x1p52,
                                  0x1p63, -0x1p63, 1e200,  most,   -most,  none,    infinite, -infinite};
  Row pairs;
  for (const double re : edges)
    for (const double im : edges) pairs.emplace_back(re, im);
  for (const int bits : bits_of_converters)
    for (const double lsb_v : {1.0, 0.1, least, 1e-309, 1e-300, 1e300, 1.7e308})
      expect_definition({bits, lsb_v}, pairs);
}

TEST(Converter, GivesTheCountsOfTheDefinitionForRowsOfAnyLength) {
  for (std::size_t length = 0; length < 70; ++length) {
    Row row;
    for (std::size_t i = 0; i < length; ++i)
      row.emplace_back(0.5 * static_cast<double>(i % 7), i % 11 == 5 ? 0.5 : -0.3 * static_cast<double>(i));
    expect_definition({8, 1.0}, row);
  }
}

TEST(TallyVolts, CountsSilenceAndWhatIsNoNumberAndKeepsTheLargestMagnitude) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t length = 5; length < 40; ++length) {
    Row row(length);
    row[0] = {3.0, -4.0};
    row[length - 1] = {none, 1.0};
    row[length / 2] = {1.0, none};
    row[length / 2 + 1] = {-0.0, 1e-300};
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      ConversionTally tally{1.0, 3, 10, 20};
      tally_volts(row, tally);
      expect_equal(tally, {5.0, 3, 10 + length - 4, 22});
    }
    hwy::SetSupportedTargetsForTest(0);
  }
  ConversionTally nothing;
  tally_volts({}, nothing);
  expect_equal(nothing, {});
}

TEST(ConvertVectors, ExpectsAnLsbWhoseInverseIsSoundAndCountsThatFit) {
  if (!core::checks_expectations()) GTEST_SKIP() << "this build does not check expectations";
  const Row volts(3);
  std::vector<std::int64_t> counts(5);
  ConversionTally tally;
  EXPECT_THROW(convert_vectors(volts, 1.0, -1.0, 2.0, counts, tally), core::BrokenExpectation);
  EXPECT_THROW(convert_vectors(volts, 1e-320, -1.0, 2.0, {}, tally), core::BrokenExpectation);
  EXPECT_THROW(convert_vectors(volts, 1.0, -1.0, 0x1p51, {}, tally), core::BrokenExpectation);
}

}  // namespace convert_row_test
}  // namespace sarsim::radar
