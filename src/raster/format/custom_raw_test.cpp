#include "raster/format/custom_raw.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <limits>
#include <numbers>

#include "raster/format/data_test_support.hpp"
#include "raster/format/open_raster.hpp"

namespace sarsim::raster {
namespace custom_raw_test {

namespace fs = std::filesystem;
using data_test::put;
using data_test::TestFolder;
using data_test::text_of;
using testing::HasSubstr;

template <class Number>
std::string stored(Number value, bool big_endian = false) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::shared_ptr<Raster> open_raw(const fs::path& path, const RawLayout& layout) {
  RasterHints hints;
  hints.raw = layout;
  const OpenedRaster opened = open_raster(Integrity::partial, path, hints);
  EXPECT_TRUE(opened.raster) << text_of(opened.problems);
  return opened.raster;
}

std::vector<std::complex<float>> all_of(const Raster& source) {
  std::vector<std::complex<float>> samples(source.rows() * source.columns());
  source.read_window({0, source.rows(), 0, source.columns()}, samples);
  return samples;
}

// A file of two rows of two complex samples with components 1, -2, 3, ... after 5 bytes, read back.
template <class Number>
void expect_read_back(RawNumber number) {
  const TestFolder folder;
  constexpr bool has_sign = std::numeric_limits<Number>::is_signed;
  for (const bool big_endian : {false, true}) {
    std::string bytes = "head.";
    std::vector<float> expected;
    for (int i = 1; i <= 8; ++i) {
      const auto value = static_cast<Number>(has_sign && i % 2 == 0 ? -i : 10 * i);
      bytes += stored(value, big_endian);
      expected.push_back(static_cast<float>(value) - 2.0F);
    }
    RawLayout layout;
    layout.header_bytes = 5;
    layout.width = 2;
    layout.number = number;
    layout.big_endian = big_endian;
    layout.offset = 2.0;
    const auto source = open_raw(put(folder / "a.raw", bytes), layout);
    ASSERT_TRUE(source);
    ASSERT_EQ(source->rows(), 2U);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(all_of(*source)[i], std::complex<float>(expected[2 * i], expected[2 * i + 1])) << name_of(number);
    layout.q_first = true;
    const auto turned = open_raw(folder / "a.raw", layout);
    ASSERT_TRUE(turned);
    EXPECT_EQ(all_of(*turned)[3], std::complex<float>(expected[7], expected[6]));
    layout.value = ImageValue::real;
    const auto real = open_raw(folder / "a.raw", layout);
    ASSERT_TRUE(real);
    ASSERT_EQ(real->rows(), 4U);
    EXPECT_EQ(all_of(*real)[5], std::complex<float>(expected[5], 0.0F));
  }
}

TEST(CustomRaw, EveryTypeAndByteOrderIsReadBack) {
  expect_read_back<std::int8_t>(RawNumber::int8);
  expect_read_back<std::uint8_t>(RawNumber::uint8);
  expect_read_back<std::int16_t>(RawNumber::int16);
  expect_read_back<std::uint16_t>(RawNumber::uint16);
  expect_read_back<std::int32_t>(RawNumber::int32);
  expect_read_back<std::uint32_t>(RawNumber::uint32);
  expect_read_back<float>(RawNumber::float32);
  expect_read_back<double>(RawNumber::float64);
}

TEST(CustomRaw, DoublesBeyondFloatAreInfinite) {
  const TestFolder folder;
  RawLayout layout;
  layout.width = 1;
  layout.number = RawNumber::float64;
  const auto source = open_raw(put(folder / "a.raw", stored(1e300) + stored(-1e300)), layout);
  ASSERT_TRUE(source);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(all_of(*source)[0], std::complex<float>(infinity, -infinity));
}

TEST(CustomRaw, HeightLimitsTheRowsAndWhatIsMissingOrLeftOverIsSaid) {
  RawLayout layout;
  layout.width = 4;
  layout.value = ImageValue::real;
  layout.height = 2;
  EXPECT_THAT(text_of(check_raw_layout(layout, "f", 11)), HasSubstr("3 bytes more"));
  EXPECT_EQ(raw_rows(layout, 11), 2U);
  layout.height = 5;
  EXPECT_THAT(text_of(check_raw_layout(layout, "f", 11)), HasSubstr("fewer rows"));
  EXPECT_EQ(raw_rows(layout, 11), 2U);
  layout.height = 0;
  EXPECT_TRUE(check_raw_layout(layout, "f", 12).empty());
  EXPECT_EQ(raw_rows(layout, 12), 3U);
  layout.header_bytes = 5;
  EXPECT_EQ(raw_rows(layout, 12), 1U);
  EXPECT_EQ(raw_rows(layout, 3), 0U);
}

TEST(CustomRaw, LayoutsThatCannotBeAreRefusedAllAtOnce) {
  RawLayout layout;
  layout.width = 0;
  layout.value = ImageValue::rgb;
  layout.offset = std::numeric_limits<double>::quiet_NaN();
  layout.header_bytes = 100;
  const core::Problems problems = check_raw_layout(layout, "f", 100);
  EXPECT_EQ(problems.size(), 4U) << text_of(problems);
  EXPECT_TRUE(core::has_errors(problems));
  RawLayout hostile;
  hostile.width = std::numeric_limits<std::size_t>::max();
  hostile.number = RawNumber::float64;
  EXPECT_THAT(text_of(check_raw_layout(hostile, "f", 100)), HasSubstr("single row"));
}

// Test data: rows of complex samples that look alike from row to row, as echoes of targets at their ranges do.
std::vector<std::complex<double>> echoes(std::size_t rows, std::size_t columns, double amplitude) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.03 * amplitude);
  std::vector<double> places(12);
  for (double& place : places) place = static_cast<double>(random() % columns);
  std::vector<std::complex<double>> result;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      std::complex<double> sum(noise(random), noise(random));
      for (std::size_t target = 0; target < places.size(); ++target) {
        const double distance = (static_cast<double>(column) - places[target]) / 4.0;
        const double phase = 0.4 * static_cast<double>(target + 1) * static_cast<double>(row) + 0.3 * distance;
        sum += amplitude * std::exp(-distance * distance) * std::polar(1.0, phase);
      }
      result.push_back(sum);
    }
  return result;
}

std::vector<RawGuess> guesses_for(const fs::path& path) {
  auto guesses = guess_raw_layout(path);
  EXPECT_TRUE(std::holds_alternative<std::vector<RawGuess>>(guesses));
  return std::get<std::vector<RawGuess>>(guesses);
}

template <class Number>
std::string file_of(const std::vector<std::complex<double>>& samples, bool big_endian, double offset = 0.0) {
  std::string bytes;
  const auto put_number = [&](double value) {
    if constexpr (std::numeric_limits<Number>::is_integer) value = std::round(value + offset);
    bytes += stored(static_cast<Number>(value), big_endian);
  };
  for (const auto& sample : samples) {
    put_number(sample.real());
    put_number(sample.imag());
  }
  return bytes;
}

template <class Number>
void expect_guessed(RawNumber number, bool big_endian, double amplitude, double offset, std::size_t header_bytes) {
  const TestFolder folder;
  constexpr std::size_t columns = 300;
  const auto bytes = file_of<Number>(echoes(200, columns, amplitude), big_endian, offset);
  const auto guesses = guesses_for(put(folder / "a.raw", std::string(header_bytes, 'h') + bytes));
  ASSERT_FALSE(guesses.empty());
  EXPECT_LE(guesses.size(), 10U);
  const RawGuess& best = guesses.front();
  EXPECT_EQ(best.layout.number, number) << to_string(best.layout) << ": " << best.reason;
  EXPECT_EQ(best.layout.value, ImageValue::complex) << best.reason;
  EXPECT_EQ(best.layout.width, columns) << best.reason;
  EXPECT_EQ(best.layout.header_bytes, header_bytes);
  EXPECT_EQ(best.layout.offset, offset);
  if (sizeof(Number) > 1) {
    EXPECT_EQ(best.layout.big_endian, big_endian) << best.reason;
  }
  EXPECT_THAT(best.reason, HasSubstr("300 apart"));
}

TEST(GuessRawLayout, FindsComplexFloats) {
  expect_guessed<float>(RawNumber::float32, false, 1e-6, 0.0, 0);
  expect_guessed<float>(RawNumber::float32, true, 50.0, 0.0, 128);
  expect_guessed<double>(RawNumber::float64, false, 3.0, 0.0, 16);
  expect_guessed<double>(RawNumber::float64, true, 3.0, 0.0, 0);
}

TEST(GuessRawLayout, FindsComplexIntegersAndTheOffsetOfTheConverter) {
  expect_guessed<std::int8_t>(RawNumber::int8, false, 40.0, 0.0, 0);
  expect_guessed<std::uint8_t>(RawNumber::uint8, false, 40.0, 127.0, 32);
  expect_guessed<std::int16_t>(RawNumber::int16, false, 900.0, 0.0, 512);
  expect_guessed<std::int16_t>(RawNumber::int16, true, 900.0, 0.0, 0);
  expect_guessed<std::uint16_t>(RawNumber::uint16, false, 700.0, 2047.0, 0);
  expect_guessed<std::int32_t>(RawNumber::int32, false, 1e6, 0.0, 0);
}

TEST(GuessRawLayout, FindsAPictureOfLevels) {
  const TestFolder folder;
  constexpr std::size_t width = 417;
  std::string bytes(32, '\0');
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 4.0);
  for (std::size_t row = 0; row < 300; ++row)
    for (std::size_t column = 0; column < width; ++column) {
      const double x = static_cast<double>(column) / width;
      const double level =
          90.0 + 60.0 * std::sin(19.0 * x * x) * std::cos(0.01 * static_cast<double>(row)) + noise(random);
      bytes += static_cast<char>(static_cast<std::uint8_t>(std::clamp(level, 0.0, 255.0)));
    }
  const auto guesses = guesses_for(put(folder / "a.raw", bytes));
  ASSERT_FALSE(guesses.empty());
  EXPECT_EQ(guesses[0].layout.number, RawNumber::uint8) << guesses[0].reason;
  EXPECT_EQ(guesses[0].layout.value, ImageValue::magnitude) << guesses[0].reason;
  EXPECT_EQ(guesses[0].layout.width, width) << guesses[0].reason;
  EXPECT_EQ(guesses[0].layout.header_bytes, 32U);
}

TEST(GuessRawLayout, OfferedLayoutsCanBeRead) {
  const TestFolder folder;
  std::mt19937 random(11);
  std::string bytes;
  for (int i = 0; i < 70000; ++i) bytes += static_cast<char>(random());
  for (const std::size_t size : {1U, 2U, 15U, 16U, 17U, 100U, 4099U, 70000U}) {
    const auto path = put(folder / "a.raw", bytes.substr(0, size));
    for (const RawGuess& guess : guesses_for(path)) {
      EXPECT_FALSE(core::has_errors(check_raw_layout(guess.layout, "f", size)))
          << size << ": " << to_string(guess.layout);
      EXPECT_FALSE(guess.reason.empty());
    }
  }
}

TEST(GuessRawLayout, NamesAFileThatIsNotThere) {
  const auto guesses = guess_raw_layout("/nowhere/at/all");
  ASSERT_TRUE(std::holds_alternative<core::Problem>(guesses));
  EXPECT_THAT(core::to_string(std::get<core::Problem>(guesses)), HasSubstr("/nowhere/at/all"));
}

}  // namespace custom_raw_test
}  // namespace sarsim::raster
