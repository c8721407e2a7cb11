#include "raster/format/encoder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "core/report/expect.hpp"
#include "raster/format/data_test_support.hpp"
#include "raster/format/decimal_digits.hpp"
#include "raster/format/format_writer.hpp"
#include "raster/table/count_range.hpp"

namespace sarsim::raster {
namespace encoder_test {

using data_test::text_of;

std::string encoded(scene::FileFormat format, int bits, std::vector<std::int64_t> counts, std::size_t rows = 1) {
  Block block;
  block.rows = rows;
  block.columns = counts.size() / 2 / rows;
  block.counts = counts;
  return text_of(encode_rows({format, true, bits}, block));
}

TEST(CountRange, EndsAreThoseOfTheConverter) {
  EXPECT_EQ(CountRange{1}.lowest(), -1);
  EXPECT_EQ(CountRange{1}.highest(), 2);
  EXPECT_EQ(CountRange{8}.lowest(), -127);
  EXPECT_EQ(CountRange{8}.highest(), 128);
  EXPECT_EQ(CountRange{31}.highest(), 1 << 30);
  EXPECT_EQ(CountRange{32}.highest(), std::int64_t{1} << 31);
  EXPECT_EQ(CountRange{64}.lowest(), -std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(CountRange{64}.highest(), std::numeric_limits<std::int64_t>::max());
}

TEST(CountRange, OffsetAndBackIsTheCountForEveryNumberOfBits) {
  for (int bits = 1; bits <= 64; ++bits) {
    const CountRange range{bits};
    for (const std::int64_t count :
         {range.lowest(), std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, range.highest()})
      EXPECT_EQ(range.without_offset(range.with_offset(count)), count) << bits;
    EXPECT_EQ(range.with_offset(range.lowest()), 0U) << bits;
    const std::uint64_t largest = bits == 1 ? 3U : (bits == 64 ? ~std::uint64_t{1} : (std::uint64_t{1} << bits) - 1U);
    EXPECT_EQ(range.with_offset(range.highest()), largest) << bits;
  }
}

TEST(DecimalDigits, AreThoseOfEveryLength) {
  std::vector<std::uint64_t> values{0, 42, 10001, 9999999900000001U, 18446744073709551615U};
  for (std::uint64_t power = 1; power <= 10'000'000'000'000'000'000U / 10; power *= 10)
    values.insert(values.end(), {power - 1, power, power + 1, 7 * power});
  for (const std::uint64_t value : values) {
    std::array<char, 40> text{};
    const char* end = decimal_digits().put(text.data(), value);
    EXPECT_EQ(std::string_view(text.data(), static_cast<std::size_t>(end - text.data())), std::to_string(value));
    const auto count = static_cast<std::int64_t>(value);
    end = decimal_digits().put_signed(text.data(), count);
    EXPECT_EQ(std::string_view(text.data(), static_cast<std::size_t>(end - text.data())), std::to_string(count));
    end = decimal_digits().put_signed(text.data(), static_cast<std::int64_t>(0U - value));
    EXPECT_EQ(std::string_view(text.data(), static_cast<std::size_t>(end - text.data())),
              std::to_string(static_cast<std::int64_t>(0U - value)));
  }
}

TEST(Encoder, AsciiIsAPairPerLineAndABlankLinePerPulse) {
  EXPECT_EQ(encoded(scene::FileFormat::ascii, 8, {0, 0, -127, 128, 5, -6, 0, 1}, 2), "0 0\n-127 128\n\n5 -6\n0 1\n\n");
}

TEST(Encoder, SmallNegativeValuesKeepTheirSignOnlyInTheClassicProfile) {
  const std::array<std::complex<double>, 2> volts{{{-0.3, 0.0}, {0.3, -0.2}}};
  const std::array<std::int64_t, 4> counts{0, 0, 0, 0};
  Block block;
  block.rows = 1;
  block.columns = 2;
  block.volts = volts;
  block.counts = counts;
  EXPECT_EQ(text_of(encode_rows({scene::FileFormat::ascii, true, 8, true}, block)), "-0 0\n0 -0\n\n");
  EXPECT_EQ(text_of(encode_rows({scene::FileFormat::bracket, true, 8, true}, block)), "(-0,0) (0,-0) \n");
  EXPECT_EQ(text_of(encode_rows({scene::FileFormat::ascii, true, 8, false}, block)), "0 0\n0 0\n\n");
}

TEST(Encoder, BracketIsALinePerPulse) {
  EXPECT_EQ(encoded(scene::FileFormat::bracket, 8, {0, 0, -127, 128, 5, -6, 0, 1}, 2),
            "(0,0) (-127,128) \n(5,-6) (0,1) \n");
}

TEST(Encoder, CsvAddsTheOffset) {
  EXPECT_EQ(encoded(scene::FileFormat::csv, 8, {37, 0, -127, 128, 5, -6, 0, 1}, 2), "164,127,0,255\n132,121,127,128\n");
}

TEST(Encoder, CsvHeaderNamesEveryComponent) { EXPECT_EQ(csv_header(2), "I0,Q0,I1,Q1\n"); }

TEST(Encoder, BinaryIsRightJustifiedAndLittleEndian) {
  EXPECT_EQ(encoded(scene::FileFormat::binary, 12, {-5, 2048}), "\xFA\x07\xFF\x0F");
  EXPECT_EQ(encoded(scene::FileFormat::binary, 1, {-1, 2}), std::string("\x00\x03", 2));
  EXPECT_EQ(encoded(scene::FileFormat::binary, 8, {-127, 37}), std::string("\x00\xA4", 2));
  EXPECT_EQ(encoded(scene::FileFormat::binary, 16, {0, 1}), std::string("\xFF\x7F\x00\x80", 4));
  EXPECT_EQ(encoded(scene::FileFormat::binary, 17, {0, -1}), std::string("\xFF\xFF\x00\xFE\xFF\x00", 6));
  EXPECT_EQ(encoded(scene::FileFormat::binary, 64, {std::numeric_limits<std::int64_t>::max(), 0}),
            "\xFE\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x7F");
}

TEST(Encoder, ExtremesOfEveryNumberOfBitsFitIntoTheBuffer) {
  for (const int bits : {1, 2, 8, 12, 16, 31, 32, 53, 64}) {
    const CountRange range{bits};
    const std::string text = encoded(scene::FileFormat::ascii, bits, {range.lowest(), range.lowest()});
    EXPECT_EQ(text, fmt::format("{} {}\n\n", range.lowest(), range.lowest()));
    const std::string csv = encoded(scene::FileFormat::csv, bits, {range.highest(), range.highest()});
    EXPECT_EQ(csv, fmt::format("{0},{0}\n", range.with_offset(range.highest())));
  }
}

TEST(Encoder, VoltsBecomeFloats) {
  const std::array<std::complex<double>, 1> volts{{{1.0, -2.0}}};
  Block block;
  block.rows = 1;
  block.columns = 1;
  block.volts = volts;
  EXPECT_EQ(text_of(encode_rows({scene::FileFormat::npy, false, 8}, block)), std::string("\0\0\x80\x3F\0\0\0\xC0", 8));
}

TEST(Encoder, IntegerCountsHaveFourBytesUpTo31Bits) {
  EXPECT_EQ(encoded(scene::FileFormat::npy, 31, {-1, 1 << 30}), std::string("\xFF\xFF\xFF\xFF\0\0\0\x40", 8));
  EXPECT_EQ(encoded(scene::FileFormat::npy, 32, {-1, 0}),
            std::string("\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\0\0\0\0\0\0\0\0", 16));
}

TEST(Encoder, RefusesCountsThatTheConverterCannotGive) {
  for (const scene::FileFormat format : {scene::FileFormat::ascii, scene::FileFormat::bracket, scene::FileFormat::csv,
                                         scene::FileFormat::binary, scene::FileFormat::npy}) {
    EXPECT_THROW((void)encoded(format, 8, {129, 0}), std::out_of_range);
    EXPECT_THROW((void)encoded(format, 8, {0, -128}), std::out_of_range);
    EXPECT_THROW((void)encoded(format, 64, {std::numeric_limits<std::int64_t>::min(), 0}), std::out_of_range);
  }
}

TEST(Encoder, RefusesBlocksOfTheWrongSize) {
  const std::array<std::int64_t, 2> counts{};
  Block block;
  block.rows = 1;
  block.columns = 2;
  block.counts = counts;
  EXPECT_THROW((void)encode_rows({scene::FileFormat::ascii, true, 8}, block), std::invalid_argument);
  EXPECT_THROW((void)encode_rows({scene::FileFormat::npy, false, 8}, block), std::invalid_argument);
}

TEST(Encoder, ExpectsBitsThatAConverterCanHave) {
  if (!core::checks_expectations()) GTEST_SKIP() << "this build does not check expectations";
  EXPECT_THROW(static_cast<void>(encode_rows({scene::FileFormat::binary, true, 65}, {})), core::BrokenExpectation);
}

}  // namespace encoder_test
}  // namespace sarsim::raster
