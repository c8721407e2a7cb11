#include "raster/format/sun_raster.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

#include "raster/format/data_test_support.hpp"
#include "raster/format/open_raster.hpp"
#include "raster/format/sun_run_length.hpp"

namespace sarsim::raster {
namespace sun_raster_test {

namespace fs = std::filesystem;
using data_test::contents;
using data_test::put;
using data_test::TestFolder;
using data_test::text_of;
using testing::HasSubstr;

std::string number(std::uint32_t value) {
  std::string text;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) text += static_cast<char>(value >> shift);
  return text;
}

std::string header(std::uint32_t width, std::uint32_t height, std::uint32_t depth, std::uint32_t type,
                   std::uint32_t map_type = 0, std::uint32_t map_length = 0) {
  return number(0x59a66a95U) + number(width) + number(height) + number(depth) + number(0) + number(type) +
         number(map_type) + number(map_length);
}

std::vector<float> levels(const Raster& source) {
  std::vector<std::complex<float>> samples(source.rows() * source.columns());
  source.read_window({0, source.rows(), 0, source.columns()}, samples);
  std::vector<float> result;
  for (const auto& sample : samples) result.push_back(sample.real());
  return result;
}

std::vector<Rgb> colours(const Raster& source) {
  std::vector<Rgb> result(source.rows() * source.columns());
  source.read_rgb({0, source.rows(), 0, source.columns()}, result);
  return result;
}

std::shared_ptr<Raster> open_whole(const fs::path& path) {
  const OpenedRaster opened = open_raster(Integrity::partial, path);
  EXPECT_TRUE(opened.raster) << text_of(opened.problems);
  if (opened.raster) opened.raster->wait_until_indexed(nullptr);
  return opened.raster;
}

std::string refusal(const fs::path& path) {
  const OpenedRaster opened = open_raster(Integrity::partial, path);
  EXPECT_FALSE(opened.raster);
  EXPECT_EQ(opened.problems.size(), 1U);
  return text_of(opened.problems);
}

TEST(SunRaster, OfGreyLevelsIsReadBackWithItsPadding) {
  const TestFolder folder;
  const std::vector<std::uint8_t> grey{1, 2, 3, 250, 251, 252};
  write_sun_raster(folder / "a.ras", 3, 2, grey);
  EXPECT_EQ(contents(folder / "a.ras"),
            header(3, 2, 8, 1).replace(16, 4, number(8)) + std::string("\1\2\3\0\372\373\374\0", 8));
  const auto source = open_whole(folder / "a.ras");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().format, &sun_raster_format());
  EXPECT_EQ(source->info().value, ImageValue::real);
  EXPECT_THAT(levels(*source), testing::ElementsAre(1, 2, 3, 250, 251, 252));
}

TEST(SunRaster, OfColoursIsReadBackAndItsLuminanceToo) {
  const TestFolder folder;
  const std::vector<Rgb> picture{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {10, 20, 30}};
  write_sun_raster(folder / "a.ras", 1, 4, picture);
  const auto source = open_whole(folder / "a.ras");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().value, ImageValue::rgb);
  EXPECT_EQ(colours(*source), picture);
  EXPECT_NEAR(levels(*source)[1], 0.587 * 255, 1e-3);
}

TEST(SunRaster, WriterRefusesWhatTheFormatCannotHoldAndExistingFiles) {
  const TestFolder folder;
  const std::vector<std::uint8_t> grey(6);
  EXPECT_THROW(write_sun_raster(folder / "a.ras", 2, 2, grey), std::invalid_argument);
  EXPECT_THROW(write_sun_raster(folder / "a.ras", 0, 0, std::span<const std::uint8_t>()), std::invalid_argument);
  put(folder / "b.ras", "mine");
  EXPECT_THROW(write_sun_raster(folder / "b.ras", 3, 2, grey), std::system_error);
  EXPECT_EQ(contents(folder / "b.ras"), "mine");
  write_sun_raster(folder / "b.ras", 3, 2, grey, true);
  EXPECT_EQ(contents(folder / "b.ras").size(), 32U + 8U);
}

TEST(SunRaster, OfOneBitIsWhiteForZeroAndBlackForOneFromTheHighestBitOn) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.ras", header(10, 2, 1, 0) + "\x80\x40\x01\xff"));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().value, ImageValue::real);
  std::vector<float> expected(20, 255.0F);
  for (const std::size_t black : {0U, 9U, 17U, 18U, 19U}) expected[black] = 0.0F;
  EXPECT_EQ(levels(*source), expected);
}

TEST(SunRaster, ColourMapHoldsRedsThenGreensThenBlues) {
  const TestFolder folder;
  const std::string map("\1\2\3\4\5\6", 6);
  const auto source = open_whole(put(folder / "a.ras", header(4, 1, 8, 1, 1, 6) + map + std::string("\1\0\2\0", 4)));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().value, ImageValue::rgb);
  EXPECT_EQ(colours(*source), (std::vector<Rgb>{{2, 4, 6}, {1, 3, 5}, {0, 0, 0}, {1, 3, 5}}));
}

TEST(SunRaster, ColourMapOfGreysOnlyMakesGreyLevels) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.ras", header(2, 1, 8, 1, 1, 6) + "\7\11\7\11\7\11" + '\1' + '\0'));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().value, ImageValue::real);
  EXPECT_THAT(levels(*source), testing::ElementsAre(9, 7));
}

TEST(SunRaster, OrderOfColoursIsThatOfTheType) {
  const TestFolder folder;
  const auto one = open_whole(put(folder / "1.ras", header(1, 1, 24, 1) + "\1\2\3" + '\0'));
  const auto three = open_whole(put(folder / "3.ras", header(1, 1, 24, 3) + "\1\2\3" + '\0'));
  const auto padded = open_whole(put(folder / "32.ras", header(1, 1, 32, 1) + "\x9\1\2\3"));
  const auto padded_rgb = open_whole(put(folder / "32rgb.ras", header(1, 1, 32, 3) + "\x9\1\2\3"));
  ASSERT_TRUE(one && three && padded && padded_rgb);
  EXPECT_EQ(colours(*one)[0], (Rgb{3, 2, 1}));
  EXPECT_EQ(colours(*three)[0], (Rgb{1, 2, 3}));
  EXPECT_EQ(colours(*padded)[0], (Rgb{3, 2, 1}));
  EXPECT_EQ(colours(*padded_rgb)[0], (Rgb{1, 2, 3}));
}

TEST(SunRaster, RunsGoOnFromOneRowToTheNextAndTheEscapeStandsForItself) {
  const TestFolder folder;
  // Rows of 4: 5 5 5 5 | 5 5 80 80 | 7 80 1 2; 80 80 as a run of two.
  const std::string packed("\x80\x05\x05\x80\x01\x80\x07\x80\x00\x01\x02", 11);
  const auto source = open_whole(put(folder / "a.ras", header(4, 3, 8, 2) + packed));
  ASSERT_TRUE(source);
  EXPECT_THAT(levels(*source), testing::ElementsAre(5, 5, 5, 5, 5, 5, 128, 128, 7, 128, 1, 2));
  std::vector<std::complex<float>> part(2);
  source->read_window({1, 2, 2, 1, 1, 1}, part);
  EXPECT_EQ(part[0].real(), 128.0F);
  EXPECT_EQ(part[1].real(), 1.0F);
}

TEST(SunRaster, LongRunLengthPicturesAreReadAnywhereFromRememberedRows) {
  const TestFolder folder;
  constexpr std::uint32_t width = 300;
  constexpr std::uint32_t height = 400;
  // Runs of 7 bytes, which go on from row to row almost everywhere.
  const auto level = [](std::size_t row, std::size_t column) {
    return static_cast<std::uint8_t>((row * width + column) / 7 * 31 % 251);
  };
  std::string packed;
  for (std::size_t i = 0; i < width * height; i += 7) packed += {'\x80', '\6', static_cast<char>(level(0, i))};
  const auto source = open_whole(put(folder / "a.ras", header(width, height, 8, 2) + packed));
  ASSERT_TRUE(source);
  ASSERT_EQ(source->rows(), height);
  const ImageWindow window{3, 40, 5, 50, 9, 5};
  std::vector<std::complex<float>> samples(window.samples());
  source->read_window(window, samples, {2, nullptr});
  for (std::size_t i = 0; i < window.rows; ++i)
    for (std::size_t k = 0; k < window.cols; ++k)
      ASSERT_EQ(samples[i * window.cols + k].real(), level(window.row(i), window.column(k))) << i << " " << k;
}

TEST(SunRaster, RunLengthPictureThatEndsEarlyShowsTheRowsThatAreThere) {
  const TestFolder folder;
  const std::string packed(20, '\3');
  const auto source = open_whole(put(folder / "a.ras", header(8, 5, 8, 2) + packed));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->rows(), 2U);
  EXPECT_THAT(text_of(source->problems()), HasSubstr("ends within the picture"));
}

TEST(SunRaster, OtherTypesAndDepthsAreRefusedByName) {
  const TestFolder folder;
  EXPECT_THAT(refusal(put(folder / "4.ras", header(1, 1, 8, 4) + "ab")),
              testing::AllOf(HasSubstr("4 (TIFF)"), HasSubstr("2 (run-length)")));
  EXPECT_THAT(refusal(put(folder / "x.ras", header(1, 1, 8, 0xffff) + "ab")), HasSubstr("experimental"));
  EXPECT_THAT(refusal(put(folder / "d.ras", header(1, 1, 16, 1) + "ab")), HasSubstr("16 bits of a pixel"));
  EXPECT_THAT(refusal(put(folder / "m.ras", header(1, 1, 8, 1, 3) + "ab")), HasSubstr("type of colour map"));
}

TEST(SunRaster, SizesThatTheFileCannotHoldAreRefusedBeforeMemoryIsTaken) {
  const TestFolder folder;
  EXPECT_THAT(refusal(put(folder / "a.ras", header(0xffffffffU, 0xffffffffU, 32, 1) + "ab")),
              HasSubstr("ends within the picture"));
  EXPECT_THAT(refusal(put(folder / "b.ras", header(0xffffffffU, 0xffffffffU, 32, 2) + "ab")),
              HasSubstr("too short for the size"));
  EXPECT_THAT(refusal(put(folder / "c.ras", header(3, 2, 8, 1) + "1234567")), HasSubstr("ends within the picture"));
  EXPECT_THAT(refusal(put(folder / "d.ras", header(3, 0, 8, 1) + "1234567")), HasSubstr("no pixels"));
  EXPECT_THAT(refusal(put(folder / "e.ras", header(1, 1, 8, 1, 1, 768) + "1234567")),
              HasSubstr("ends within the colour map"));
  EXPECT_THAT(refusal(put(folder / "f.ras", header(1, 1, 8, 1, 1, 7) + "123456789")), HasSubstr("wrong length"));
  EXPECT_THAT(refusal(put(folder / "g.ras", header(1, 1, 8, 1).substr(0, 20))), HasSubstr("within the header"));
  EXPECT_THAT(refusal(put(folder / "h.ras", header(1, 1, 24, 1, 2, 0xfffffff0U) + "abcdef")),
              HasSubstr("ends within the colour map"));
}

TEST(SunRaster, CutWhileOpenGivesAMessage) {
  const TestFolder folder;
  write_sun_raster(folder / "a.ras", 100, 100, std::vector<std::uint8_t>(10000, 1));
  const auto source = open_whole(folder / "a.ras");
  ASSERT_TRUE(source);
  fs::resize_file(folder / "a.ras", 500);
  std::vector<std::complex<float>> samples(100);
  EXPECT_THROW(source->read_window({50, 1, 0, 100}, samples), std::runtime_error);
  source->read_window({0, 1, 0, 100}, samples);
  EXPECT_EQ(samples[99].real(), 1.0F);
}

// Pictures by another program, converted with it and compared with its own plain PPM of the same pixels.
class ForeignProgramImageMagick : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("convert -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ImageMagick's convert is not installed";
  }
  // Makes a picture with convert's arguments and returns it read by us and by means of the PPM.
  void compare(const std::string& arguments) {
    const std::string raster = (folder_ / "a.ras").string();
    const std::string plain = (folder_ / "a.ppm").string();
    ASSERT_EQ(std::system(("convert " + arguments + " sun:" + raster).c_str()), 0);
    ASSERT_EQ(std::system(("convert sun:" + raster + " -depth 8 ppm:" + plain).c_str()), 0);
    const auto source = open_whole(raster);
    ASSERT_TRUE(source);
    const std::string stored = contents(plain);
    const std::size_t bytes = 3 * source->rows() * source->columns();
    ASSERT_GT(stored.size(), bytes);
    const std::string pixels = stored.substr(stored.size() - bytes);
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(pixels[i]); };
    const bool coloured = source->info().value == ImageValue::rgb;
    const auto found = coloured ? colours(*source) : std::vector<Rgb>();
    const auto grey = levels(*source);
    for (std::size_t i = 0; i < grey.size(); ++i) {
      const Rgb expected{byte(3 * i), byte(3 * i + 1), byte(3 * i + 2)};
      if (coloured) {
        ASSERT_EQ(found[i], expected) << arguments << ", pixel " << i;
      } else {
        ASSERT_EQ(grey[i], static_cast<float>(expected.green)) << arguments << ", pixel " << i;
      }
    }
  }
  TestFolder folder_;
};

TEST_F(ForeignProgramImageMagick, TrueColourPicturesAreReadRight) { compare("-size 37x21 gradient:red-blue"); }
TEST_F(ForeignProgramImageMagick, PalettePicturesAreReadRight) {
  compare("-size 37x21 gradient:red-blue -colors 7 -type Palette");
}
TEST_F(ForeignProgramImageMagick, MonochromePicturesAreReadRight) {
  compare("-size 37x21 pattern:checkerboard -monochrome -type bilevel");
}
TEST_F(ForeignProgramImageMagick, GreyPicturesAreReadRight) { compare("-size 36x21 gradient: -type Grayscale"); }

TEST_F(ForeignProgramImageMagick, ReadsWhatWeWrite) {
  const std::string raster = (folder_ / "a.ras").string();
  const std::string plain = (folder_ / "a.ppm").string();
  const std::vector<Rgb> picture{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, {13, 14, 15}, {255, 0, 128}};
  write_sun_raster(raster, 3, 2, picture);
  ASSERT_EQ(std::system(("convert sun:" + raster + " -depth 8 ppm:" + plain).c_str()), 0);
  const std::string stored = contents(plain);
  ASSERT_GT(stored.size(), 18U);
  EXPECT_EQ(stored.substr(stored.size() - 18), std::string("\1\2\3\4\5\6\7\10\11\12\13\14\15\16\17\377\0\200", 18));
  write_sun_raster(raster, 3, 2, std::vector<std::uint8_t>{9, 8, 7, 6, 5, 200}, true);
  ASSERT_EQ(std::system(("convert sun:" + raster + " -depth 8 gray:" + plain).c_str()), 0);
  EXPECT_EQ(contents(plain), "\11\10\7\6\5\310");
}

}  // namespace sun_raster_test
}  // namespace sarsim::raster
