#include "raster/format/open_raster.hpp"

#include <gmock/gmock.h>

#include "raster/format/image_test_support.hpp"
#include "raster/format/npy_header.hpp"

namespace sarsim::raster {
namespace image_numpy_test {

namespace fs = std::filesystem;
using data_test::open_whole;
using data_test::put;
using data_test::read;
using data_test::read_all;
using data_test::TestFolder;
using data_test::text_of;
using testing::HasSubstr;

std::string npy(const std::string& type, const std::string& shape, const std::string& data, bool fortran = false) {
  std::string text =
      "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }\n";
  return std::string("\x93NUMPY\1\0", 8) + static_cast<char>(text.size()) + '\0' + text + data;
}

TEST(Raster, ReadsNumpyArraysOfEitherByteOrderAndOrder) {
  const TestFolder folder;
  const auto big =
      open_whole(put(folder / "a.npy", npy(">i2", "(2, 3)", std::string("\0\1\0\2\0\3\0\4\0\5\xff\xff", 12))));
  ASSERT_TRUE(big);
  EXPECT_EQ(big->info().value, ImageValue::real);
  EXPECT_EQ(read_all(*big), (std::vector<std::complex<float>>{1, 2, 3, 4, 5, -1}));
  const auto turned = open_whole(put(folder / "b.npy", npy("|u1", "(2, 3)", "\1\2\3\4\5\6", true)));
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->rows(), 2U);
  EXPECT_EQ(turned->columns(), 3U);
  EXPECT_EQ(read_all(*turned), (std::vector<std::complex<float>>{1, 3, 5, 2, 4, 6}));
  EXPECT_EQ(read(*turned, {1, 1, 0, 2, 1, 2}), (std::vector<std::complex<float>>{2, 6}));
  EXPECT_EQ(data_test::read_all_rows(*turned), (std::vector<std::complex<double>>{1, 3, 5, 2, 4, 6}));
  const auto row =
      open_whole(put(folder / "c.npy", npy("<i4", "(2, 2)", std::string("\1\0\0\0\2\0\0\0\3\0\0\0\4\0\0\0", 16))));
  ASSERT_TRUE(row);
  EXPECT_EQ(read_all(*row), (std::vector<std::complex<float>>{{1, 2}, {3, 4}}));
}

TEST(Raster, ReadsNumpyArraysOfColours) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.npy", npy("|u1", "(1, 3, 3)", "\1\2\3\4\5\6\377\376\375")));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().value, ImageValue::rgb);
  std::vector<Rgb> colours(2);
  source->read_rgb({0, 1, 0, 2, 1, 2}, colours);
  EXPECT_EQ(colours, (std::vector<Rgb>{{1, 2, 3}, {255, 254, 253}}));
  EXPECT_NEAR(read_all(*source)[1].real(), 0.299 * 4 + 0.587 * 5 + 0.114 * 6, 1e-5);
}

TEST(Raster, RefusesNumpyArraysThatAreNoImages) {
  const TestFolder folder;
  const auto refusal = [&](const std::string& bytes) {
    const OpenedRaster opened = open_raster(Integrity::partial, put(folder / "a.npy", bytes));
    EXPECT_FALSE(opened.raster);
    return text_of(opened.problems);
  };
  EXPECT_THAT(refusal(npy("<U4", "(2, 3)", std::string(96, 'x'))), HasSubstr("not one of numbers"));
  EXPECT_THAT(refusal(npy("<f4", "(2, 3, 4)", std::string(96, 'x'))), HasSubstr("not one of an image"));
  EXPECT_THAT(refusal(npy("<f4", "(0, 3)", "")), HasSubstr("not one of an image"));
  EXPECT_THAT(refusal(npy("<f4", "(2, 9223372036854775807)", "1234")), HasSubstr("ends within the array"));
  EXPECT_THAT(refusal(npy("<f4", "(3, 1, 2)", std::string(24, 'x'), true)), HasSubstr("Fortran"));
  EXPECT_THAT(refusal("\x93NUMPY"), HasSubstr("a.npy"));
}

TEST(Raster, ShowsTheRowsOfANumpyArrayThatIsStillBeingWritten) {
  const TestFolder folder;
  const fs::path path = put(folder / "a.npy", npy("|u1", "(4, 3)", "\1\2\3\4\5\6\7"));
  const OpenedRaster opened = open_raster(Integrity::partial, path);
  ASSERT_TRUE(opened.raster);
  EXPECT_THAT(text_of(opened.problems), HasSubstr("what is there is shown"));
  EXPECT_EQ(opened.raster->rows(), 2U);
  std::ofstream(path, std::ios::binary | std::ios::app) << "\10\11\12\13\14 and more";
  EXPECT_EQ(opened.raster->rows(), 2U);
  EXPECT_EQ(opened.raster->refresh(), 4U);
  EXPECT_EQ(read(*opened.raster, {3, 1, 1, 1})[0].real(), 11.0F);
}

}  // namespace image_numpy_test
}  // namespace sarsim::raster
