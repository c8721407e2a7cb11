#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <complex>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "raster/format/open_raster.hpp"
#include "raster/sicd/sicd_test_value.hpp"
#include "raster/sicd/sicd_writer.hpp"
#include "support/test_folder.hpp"

namespace sarsim::raster {
namespace sicd_reader_test {

namespace fs = std::filesystem;

using testing::HasSubstr;
using Samples = std::vector<std::complex<float>>;

// The sample of a row of ranges and a column along the track.
std::complex<float> sample_at(std::size_t row, std::size_t column) {
  return {static_cast<float>(row) + 0.25F, -static_cast<float>(column)};
}

std::string read_all(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_all(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

// A file of 4 rows and 3 columns.
std::string small_file(const fs::path& path, bool backwards = false) {
  const Sicd image = sicd_test_value(4, 3);
  SicdWriter writer(path, image, backwards, true);
  for (std::size_t line = 0; line < 3; ++line) {
    Samples row;
    for (std::size_t r = 0; r < 4; ++r) row.push_back(sample_at(r, backwards ? 2 - line : line));
    writer.append(row);
  }
  writer.finish();
  return read_all(path);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_EQ(from.size(), to.size());
  return text.replace(at, from.size(), to);
}

std::string put(std::string text, std::size_t at, const std::string& bytes) {
  return text.replace(at, bytes.size(), bytes);
}

// Places of fields in a file with one image segment.
constexpr std::size_t subheader = 360 + 3 + 16 + 9 + 3 + 13 + 13;
constexpr std::size_t columns_at = subheader + 341;
constexpr std::size_t kind_at = subheader + 349;
constexpr std::size_t compression_at = subheader + 433;
constexpr std::size_t mode_at = compression_at + 2 + 1 + 2 * 13 + 1;

class SicdReader : public testing::Test {
 protected:
  [[nodiscard]] Samples samples_of(const std::string& bytes) const {
    const fs::path path = folder_ / "read.nitf";
    write_all(path, bytes);
    const OpenedRaster opened = open_raster(Integrity::whole, path);
    EXPECT_NE(opened.raster, nullptr) << (opened.problems.empty() ? "" : opened.problems.front().message);
    if (!opened.raster) return {};
    Samples samples(opened.raster->rows() * opened.raster->columns());
    opened.raster->read_window({0, opened.raster->rows(), 0, opened.raster->columns(), 1, 1}, samples);
    return samples;
  }

  [[nodiscard]] std::string words_of(const std::string& bytes) const {
    const fs::path path = folder_ / "bad.nitf";
    write_all(path, bytes);
    const OpenedRaster opened = open_raster(Integrity::partial, path);
    EXPECT_EQ(opened.raster, nullptr);
    if (opened.problems.empty()) return {};
    return core::to_string(opened.problems.front());
  }

  test::TestFolder folder_;
};

TEST_F(SicdReader, ReadsWhatWasWritten) {
  for (const bool backwards : {false, true}) {
    const Samples samples = samples_of(small_file(folder_ / "a.nitf", backwards));
    ASSERT_EQ(samples.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(samples[i], sample_at(i / 3, i % 3)) << i;
  }
}

TEST_F(SicdReader, SaysWherePixelsAre) {
  small_file(folder_ / "a.nitf");
  const OpenedRaster opened = open_raster(Integrity::whole, folder_ / "a.nitf");
  ASSERT_NE(opened.raster, nullptr);
  EXPECT_EQ(opened.raster->info().format, &sicd_format());
  const auto& places = opened.raster->info().places;
  ASSERT_TRUE(places);
  EXPECT_EQ(places->azimuth, (ImagePlaces{"Slant range", "m", 2999.0, 0.5}));
  EXPECT_EQ(places->range, (ImagePlaces{"Azimuth", "m", -0.5, 0.5}));
  EXPECT_EQ(places->azimuth_centre_per_m, 0.25);
}

// The same bytes of pixels, taken for twice as many of 16-bit integers.
TEST_F(SicdReader, ReadsIntegers) {
  std::string file = small_file(folder_ / "a.nitf");
  file = put(file, columns_at, "00000006");
  file = put(file, kind_at, "SI ");
  file = put(file, mode_at + 1 + 8, "0006");  // NPPBH
  file = put(file, mode_at + 1 + 16, "16");   // NBPP
  file = replaced(file, "RE32F_IM32F", "RE16I_IM16I");
  file = replaced(file, "<NumCols>3<", "<NumCols>6<");
  const std::size_t data = std::stoul(file.substr(354, 6)) + std::stoul(file.substr(363, 6));
  file = put(file, data, std::string("\xff\xfe\x01\x02\x7f\xff\x80\x00", 8));
  const Samples samples = samples_of(file);
  ASSERT_EQ(samples.size(), 24U);
  EXPECT_EQ(samples[0], (std::complex<float>{-2.0F, 258.0F}));
  EXPECT_EQ(samples[1], (std::complex<float>{32767.0F, -32768.0F}));
}

TEST_F(SicdReader, ReadsAmplitudesWithPhases) {
  std::string file = small_file(folder_ / "a.nitf");
  file = put(file, columns_at, "00000012");
  file = put(file, kind_at, "INT");
  file = put(file, mode_at + 1 + 8, "0012");
  file = put(file, mode_at + 1 + 16, "08");
  file = replaced(file, "RE32F_IM32F", "AMP8I_PHS8I");
  // A number with two digits, whose blank is taken from the text before it.
  file = replaced(file, "\n    <NumCols>3<", "\n   <NumCols>12<");
  const std::size_t data = std::stoul(file.substr(354, 6)) + std::stoul(file.substr(363, 6));
  file = put(file, data, std::string("\x05\x00\x07\x40\x09\x80", 6));
  const Samples samples = samples_of(file);
  ASSERT_EQ(samples.size(), 48U);
  constexpr std::array<std::complex<float>, 3> wanted{{{5.0F, 0.0F}, {0.0F, 7.0F}, {-9.0F, 0.0F}}};
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_LT(std::abs(samples[i] - wanted[i]), 1e-5F) << i;
}

// Three segments of 10 GB, of which only what is written takes room on the disk.
TEST_F(SicdReader, ReadsAcrossSegments) {
  const fs::path path = folder_ / "large.nitf";
  constexpr std::size_t rows = 70'000;
  constexpr std::size_t columns = 40'000;
  const NitfLayout layout = lay_out_nitf(nitf_content(sicd_test_value(rows, columns)));
  {
    core::OutputFile file(path, false);
    file.resize(layout.size);
    for (const auto& [offset, text] : layout.texts) file.write_at(offset, std::as_bytes(std::span(text)));
    const auto mark = [&](std::size_t segment, std::size_t row, std::size_t column, float value) {
      const std::uint32_t bits = __builtin_bswap32(std::bit_cast<std::uint32_t>(value));
      file.write_at(layout.segments[segment].offset + (std::uint64_t{row} * columns + column) * 8,
                    std::as_bytes(std::span(&bits, 1)));
    };
    mark(0, 31'248, 5, 1.0F);
    mark(1, 0, 5, 2.0F);
    mark(2, 7'501, 39'999, 3.0F);  // The last pixel.
    file.secure();
    file.commit();
  }
  const OpenedRaster opened = open_raster(Integrity::whole, path);
  ASSERT_NE(opened.raster, nullptr) << core::to_string(opened.problems.front());
  ASSERT_EQ(opened.raster->rows(), rows);
  Samples samples(3);
  opened.raster->read_window({31'247, 3, 5, 1, 1, 1}, samples);
  EXPECT_EQ(samples, (Samples{0.0F, 1.0F, 2.0F}));
  Samples far(3);
  opened.raster->read_window({7'501, 3, 39'999, 1, 31'249, 1}, far);  // Steps from segment to segment.
  EXPECT_EQ(far[2], 3.0F);
  std::vector<std::complex<double>> whole(2 * columns);
  opened.raster->read_rows(31'248, 2, whole);
  EXPECT_EQ(whole[5], 1.0);
  EXPECT_EQ(whole[columns + 5], 2.0);
}

TEST_F(SicdReader, RefusesWhatItCannotRead) {
  const std::string good = small_file(folder_ / "a.nitf");
  const std::size_t text = good.find("<?xml");
  struct Bad {
    std::string bytes;
    const char* words;
  };
  const Bad table[] = {
      {good.substr(0, 100), "ends within its header"},
      {good.substr(0, 500), "ends within image segment 1"},
      {good.substr(0, good.size() - 1), "ends within data extension 1"},
      {put(good, 0, "NITF02.00"), "another version"},
      {put(good, 354, "000100"), "(HL)"},
      {put(good, 354, "00x100"), "HL of the file's header is not a number"},
      {put(good, 360, "999"), "ends within its field NUMI"},
      {put(good, subheader, "XX"), "no image header"},
      {put(good, compression_at, "C8"), "image"},
      {put(good, mode_at, "B"), "blocks or bands"},
      {put(good, mode_at + 1, "0002"), "blocks or bands"},
      {put(good, kind_at, "SI "), "not those of the XML text"},
      {put(good, columns_at, "00000004"), "columns"},
      {put(good, columns_at - 8, "00000005"), "its length does not fit"},
      {replaced(good, "urn:SICD:1.3.0 ", "urn:SIDD:1.3.0 "), "not a SICD one"},
      {replaced(good, "<SICD xmlns=\"urn:SICD:1.3.0\"", "<SICD xmlns=\"urn:SICD:0.3.0\""), "not one of SICD 1"},
      {replaced(good, "RE32F_IM32F", "RE64F_IM64F"), "PixelType"},
      {replaced(good, "<NumRows>4<", "<NumRows>5<"), "rows of the image segments"},
      {replaced(good, "<NumCols>3<", "<NumCols>x<"), "NumCols"},
      {replaced(good, "<SS>0.5<", "<SS>0.0<"), "Grid/Row/SS"},
      {replaced(good, "<SS>0.5<", "<SS>nan<"), "Grid/Row/SS"},
      {replaced(good, "<FirstRow>0<", "<FirstRow>x<"), "ImageData/FirstRow"},
      {replaced(good, "<FirstRow>0</FirstRow>", "<NumRows>9</NumRows>  "), "an element NumRows twice"},
      {replaced(good, "<Row>2<", "<Row>7<"),
       "(ImageData/SCPPixel/Row) lies outside the image; found '7', expected 0 to 3"},
      {put(good, text, "<!DOCTYPE a>"), "XML"},
      {put(good, text + 60, "<<<<"), "XML"},
      {replaced(good, "IMSICD000 ", "IMsomewhat"), "rows of the image segments"},
  };
  for (const Bad& bad : table) {
    EXPECT_THAT(words_of(bad.bytes), HasSubstr(bad.words));
  }
}

TEST_F(SicdReader, SaysWhereTheFileIsNotAsLongAsItsHeaderSays) {
  const std::string good = small_file(folder_ / "a.nitf");
  const auto remark_on = [&](const std::string& bytes) {
    write_all(folder_ / "long.nitf", bytes);
    const OpenedRaster opened = open_raster(Integrity::whole, folder_ / "long.nitf");
    EXPECT_NE(opened.raster, nullptr);
    return opened.problems.empty() ? std::string() : core::to_string(opened.problems.front());
  };
  constexpr std::size_t file_length_at = 342;
  EXPECT_EQ(remark_on(good), "");
  EXPECT_EQ(remark_on(put(good, file_length_at, "999999999999")), "");
  EXPECT_THAT(remark_on(put(good, file_length_at, "000000000999")), HasSubstr("(FL)"));
  EXPECT_THAT(remark_on(good + "12345678"), HasSubstr("bytes are left over behind the last segment"));
}

}  // namespace sicd_reader_test
}  // namespace sarsim::raster
