#include "raster/format/envi.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "raster/format/npy_header.hpp"
#include "support/processor_time.hpp"

namespace sarsim::raster {
namespace envi_test {

namespace fs = std::filesystem;

class Envi : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(file(name)) << text; }

  fs::path folder_;
};

EnviHeader small_header() {
  EnviHeader header;
  header.samples = 3;
  header.lines = 2;
  header.description = "two lines";
  header.fields = {{"azimuth first m", "-200.5"}, {"scene", "a, b"}};
  return header;
}

const std::vector<std::complex<float>> first_row{{1.0F, 2.0F}, {3.0F, -4.0F}, {0.0F, 0.5F}};
const std::vector<std::complex<float>> second_row{{-1.0F, 0.0F}, {6.0F, 8.0F}, {0.25F, 0.0F}};

TEST_F(Envi, ReadsWhatItWrote) {
  EnviWriter writer(file("image.img"), small_header(), false);
  writer.append(first_row);
  writer.append(second_row);
  EXPECT_FALSE(fs::exists(file("image.img")));
  writer.finish();
  const auto [image, problems] = EnviImage::open(file("image.img"));
  ASSERT_TRUE(image);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(image->header().samples, 3U);
  EXPECT_EQ(image->header().lines, 2U);
  EXPECT_EQ(image->header().description, "two lines");
  EXPECT_EQ(image->header().field("azimuth first m"), "-200.5");
  EXPECT_EQ(image->header().field("scene"), "a, b");
  EXPECT_EQ(image->header().field("missing"), std::nullopt);
  std::vector<std::complex<float>> read(2);
  image->read(1, 1, read);
  EXPECT_EQ(read[0], second_row[1]);
  EXPECT_EQ(read[1], second_row[2]);
}

TEST_F(Envi, AnImageCannotHaveTheNameOfItsHeader) {
  EXPECT_THROW(EnviWriter(file("image.hdr"), small_header(), false), std::invalid_argument);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Envi, TheHeaderOfAnArrayIsOneThatSaysWhatTheArraySays) {
  const std::array<std::size_t, 2> shape{2, 3};
  const std::string array = npy_header_text("<c8", shape);
  write("image.npy", array + std::string(48, '\0'));
  EXPECT_FALSE(has_envi_header(file("image.npy")));
  EnviHeader header = small_header();
  write("image.hdr", to_text(header));  // Of image.img: without an offset.
  EXPECT_FALSE(has_envi_header(file("image.npy")));
  EXPECT_FALSE(EnviImage::open(file("image.npy")).first);
  header.header_offset = array.size();
  write("image.hdr", to_text(header));
  EXPECT_TRUE(has_envi_header(file("image.npy")));
  EXPECT_TRUE(EnviImage::open(file("image.npy")).first);
  header.samples = 2;
  header.lines = 3;
  write("image.hdr", to_text(header));
  EXPECT_FALSE(has_envi_header(file("image.npy")));
  write("image.hdr", "something else");
  EXPECT_FALSE(has_envi_header(file("image.npy")));
}

TEST_F(Envi, ImageAndArrayOfOneStemHaveAHeaderEach) {
  const std::array<std::size_t, 2> shape{2, 3};
  const std::string array = npy_header_text("<c8", shape);
  write("image.img", std::string(48, '\0'));
  write("image.npy", array + std::string(48, '\0'));
  EnviHeader header = small_header();
  write("image.hdr", to_text(header));
  header.header_offset = array.size();
  write("image.npy.hdr", to_text(header));
  EXPECT_EQ(envi_header_of(file("image.img")), file("image.hdr"));
  EXPECT_EQ(envi_header_of(file("image.npy")), file("image.npy.hdr"));
  EXPECT_TRUE(EnviImage::open(file("image.npy")).first);
  // The other way round: the short name is the array's.
  write("image.hdr", to_text(header));
  write("image.img.hdr", to_text(small_header()));
  EXPECT_EQ(envi_header_of(file("image.npy")), file("image.hdr"));
  EXPECT_EQ(envi_header_of(file("image.img")), file("image.img.hdr"));
  EXPECT_TRUE(EnviImage::open(file("image.img")).first);
}

TEST_F(Envi, NamesTheHeadersThatAreLookedFor) {
  write("image.npy", std::string(48, '\0'));
  const core::Problem problem = EnviImage::open(file("image.npy")).second.at(0);
  EXPECT_EQ(problem.expected, file("image.hdr").string() + " or " + file("image.npy.hdr").string());
}

TEST_F(Envi, WritesMagnitudesOfARealImage) {
  EnviHeader header = small_header();
  header.pixel = EnviHeader::Pixel::real_float;
  EnviWriter writer(file("image.img"), header, false);
  writer.append(first_row);
  writer.append(second_row);
  writer.finish();
  EXPECT_EQ(fs::file_size(file("image.img")), 24U);
  const auto image = EnviImage::open(file("image.img")).first;
  ASSERT_TRUE(image);
  std::vector<std::complex<float>> read(3);
  image->read(1, 0, read);
  EXPECT_EQ(read[1], std::complex<float>(10.0F, 0.0F));
}

TEST_F(Envi, LeavesNothingWithoutFinish) {
  { EnviWriter writer(file("image.img"), small_header(), false); }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Envi, RefusesRowsThatDoNotBelong) {
  EnviWriter writer(file("image.img"), small_header(), false);
  EXPECT_THROW(writer.append(std::span(first_row).first(2)), std::logic_error);
  EXPECT_THROW(writer.finish(), std::logic_error);
}

TEST_F(Envi, KeepsExistingFilesUnlessToldToReplaceThem) {
  write("image.hdr", "old");
  EXPECT_THROW(EnviWriter(file("image.img"), small_header(), false), std::system_error);
  EXPECT_NO_THROW(EnviWriter(file("image.img"), small_header(), true));
}

TEST_F(Envi, ReadsHeadersOfOtherPrograms) {
  const auto reading = read_envi_header(
      "ENVI \r\ndescription = {\n  of several\n  lines}\nSamples = 10\nlines   = 20\nbands = 1\ndata type = 4\n"
      "band names = {\n a,\n b}\n; a remark\n",
      "x.hdr");
  ASSERT_TRUE(reading.header);
  EXPECT_EQ(reading.header->samples, 10U);
  EXPECT_EQ(reading.header->lines, 20U);
  EXPECT_EQ(reading.header->pixel, EnviHeader::Pixel::real_float);
  EXPECT_EQ(reading.header->field("band names"), "a,\n b");
}

TEST_F(Envi, NamesEverythingThatIsWrongWithAHeader) {
  const auto reading = read_envi_header("ENVI\nsamples = x\nbands = 3\ndata type = 12\nbyte order = 1\n", "x.hdr");
  EXPECT_FALSE(reading.header);
  EXPECT_EQ(reading.problems.size(), 5U);
  EXPECT_FALSE(read_envi_header("", "x.hdr").header);
  EXPECT_FALSE(read_envi_header("samples = 3", "x.hdr").header);
}

TEST_F(Envi, RefusesImagesThatAreTooShortOrHaveNoHeader) {
  write("image.img", "12345678");
  EXPECT_NE(EnviImage::open(file("image.img")).second.at(0).message.find("no header"), std::string::npos);
  write("image.img.hdr", to_text(small_header()));
  EXPECT_NE(EnviImage::open(file("image.img")).second.at(0).message.find("shorter"), std::string::npos);
  write("image.img.hdr", "ENVI\nsamples = 4294967296\nlines = 4294967296\ndata type = 6\n");
  EXPECT_FALSE(EnviImage::open(file("image.img")).first);
}

TEST_F(Envi, RefusesImagesWithoutPixels) {
  const auto reading = read_envi_header("ENVI\nsamples = 0\nlines = 0\ndata type = 6\n", "x.hdr");
  EXPECT_FALSE(reading.header);
  ASSERT_EQ(reading.problems.size(), 2U);
  EXPECT_EQ(reading.problems[0].message, "'samples' is not a whole number above 0");
}

TEST_F(Envi, WaitsForNoPipeInTheirPlace) {
  write("image.hdr", to_text(small_header()));
  ASSERT_EQ(::mkfifo(file("image.img").c_str(), 0600), 0);
  EXPECT_EQ(EnviImage::open(file("image.img")).second.at(0).message, "this is not a regular file");
  fs::remove(file("image.hdr"));
  fs::remove(file("image.img"));
  write("image.img", std::string(48, '\0'));
  ASSERT_EQ(::mkfifo(file("image.hdr").c_str(), 0600), 0);
  EXPECT_EQ(EnviImage::open(file("image.img")).second.at(0).message, "this is not a regular file");
}

TEST_F(Envi, ReadsNoMoreOfAHeaderThanAHeaderHas) {
  write("image.img", std::string(48, '\0'));
  write("image.hdr", to_text(small_header()) + std::string(std::size_t{1} << 20U, '\n') + "bands = 7\n");
  const sarsim::test::ProcessorTime time;
  EXPECT_TRUE(EnviImage::open(file("image.img")).first);
  // In one pass milliseconds; looking ahead from each line took 7 s.
  EXPECT_LT(time.seconds(), 2.0);
}

TEST_F(Envi, KeepsItsHeadersReadableWhateverTheirValuesHold) {
  EnviHeader header = small_header();
  header.description = "with {braces}\nand lines";
  const auto reading = read_envi_header(to_text(header), "x.hdr");
  ASSERT_TRUE(reading.header);
  EXPECT_EQ(reading.header->description, "with (braces) and lines");
  EXPECT_EQ(reading.header->field("scene"), "a, b");
}

}  // namespace envi_test
}  // namespace sarsim::raster
