#include "raster/format/open_raster.hpp"

#include <gmock/gmock.h>

#include <chrono>

#include "raster/format/image_test_support.hpp"
#include "raster/table/computed_raster.hpp"

namespace sarsim::raster {
namespace raster_test {

namespace fs = std::filesystem;
using data_test::open_whole;
using data_test::put;
using data_test::read;
using data_test::read_all;
using data_test::sample_hints;
using data_test::test_product;
using data_test::TestFolder;
using data_test::text_of;
using testing::HasSubstr;

struct FormatCase {
  const char* name;
  scene::FileFormat format;
  bool counts;
};

class ImageOfFormat : public testing::TestWithParam<FormatCase> {};

TEST_P(ImageOfFormat, GivesTheSamplesOfAnyWindow) {
  const TestFolder folder;
  constexpr std::size_t rows = 23;
  constexpr std::size_t columns = 17;
  constexpr int bits = 12;
  const Product product = test_product(rows, columns, bits);
  const fs::path path = folder / GetParam().name;
  data_test::write_test_file(path, product, {GetParam().format, false, GetParam().counts, false});
  const auto source =
      open_whole(path, sample_hints(GetParam().format == scene::FileFormat::binary ? columns : 0, bits));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().format, &format_of(GetParam().format));
  EXPECT_EQ(source->info().value, ImageValue::complex);
  EXPECT_EQ(source->info().counts, GetParam().counts);
  ASSERT_EQ(source->rows(), rows);
  ASSERT_EQ(source->columns(), columns);
  EXPECT_EQ(source->indexed(), 1.0);
  const auto counts = data_test::test_counts(rows * columns, bits);
  const auto volts = data_test::test_volts(rows * columns);
  const auto expected = [&](std::size_t row, std::size_t column) {
    const std::size_t i = row * columns + column;
    if (!GetParam().counts) return std::complex<float>(volts[i]);
    return std::complex<float>(static_cast<float>(counts[2 * i]), static_cast<float>(counts[2 * i + 1]));
  };
  for (const ImageWindow& window :
       {ImageWindow{0, rows, 0, columns}, ImageWindow{5, 3, 2, 4}, ImageWindow{22, 1, 16, 1},
        ImageWindow{1, 8, 0, 6, 3, 3}, ImageWindow{0, 2, 16, 1, 22, 1}}) {
    const auto samples = read(*source, window, 2);
    for (std::size_t i = 0; i < window.rows; ++i)
      for (std::size_t k = 0; k < window.cols; ++k)
        ASSERT_EQ(samples[i * window.cols + k], expected(window.row(i), window.column(k))) << i << ", " << k;
  }
}

TEST_P(ImageOfFormat, RefusesWindowsThatAreNotInside) {
  const TestFolder folder;
  const fs::path path = folder / GetParam().name;
  data_test::write_test_file(path, test_product(4, 3, 8), {GetParam().format, false, GetParam().counts, false});
  const auto source = open_whole(path, sample_hints(GetParam().format == scene::FileFormat::binary ? 3 : 0, 8));
  ASSERT_TRUE(source);
  constexpr std::size_t huge = std::numeric_limits<std::size_t>::max();
  std::vector<std::complex<float>> samples(4);
  for (const ImageWindow& window :
       {ImageWindow{3, 2, 0, 2}, ImageWindow{0, 2, 2, 2}, ImageWindow{0, 2, 0, 2, 4, 1},
        ImageWindow{0, 2, 0, 2, 1, huge}, ImageWindow{huge, 2, 0, 2}, ImageWindow{0, 2, 0, 2, 0, 1}})
    EXPECT_THROW(source->read_window(window, samples), std::out_of_range);
  EXPECT_THROW(source->read_window({0, 1, 0, 2}, samples), std::invalid_argument);
  std::vector<Rgb> colours(4);
  EXPECT_THROW(source->read_rgb({0, 2, 0, 2}, colours), std::logic_error);
  source->read_window({2, 0, 1, 0}, {});
}

TEST_P(ImageOfFormat, CutWhileOpenGivesAMessageWithItsName) {
  const TestFolder folder;
  const fs::path path = folder / GetParam().name;
  data_test::write_test_file(path, test_product(3000, 40, 8), {GetParam().format, false, GetParam().counts, false});
  const auto source = open_whole(path, sample_hints(GetParam().format == scene::FileFormat::binary ? 40 : 0, 8));
  ASSERT_TRUE(source);
  fs::resize_file(path, fs::file_size(path) / 2);
  try {
    read(*source, {2990, 2, 0, 40});
    FAIL() << "read rows that are not there";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(path.string()));
  }
  EXPECT_EQ(read(*source, {0, 1, 0, 40}).size(), 40U);
}

INSTANTIATE_TEST_SUITE_P(Formats, ImageOfFormat,
                         testing::Values(FormatCase{"a.bin", scene::FileFormat::binary, true},
                                         FormatCase{"a.asc", scene::FileFormat::ascii, true},
                                         FormatCase{"a.csv", scene::FileFormat::csv, true},
                                         FormatCase{"a.brk", scene::FileFormat::bracket, true},
                                         FormatCase{"counts.npy", scene::FileFormat::npy, true},
                                         FormatCase{"volts.npy", scene::FileFormat::npy, false},
                                         FormatCase{"counts.h5", scene::FileFormat::hdf5, true},
                                         FormatCase{"volts.h5", scene::FileFormat::hdf5, false}),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           name.replace(name.find('.'), 1, "_");
                           return name;
                         });

TEST(Raster, OfHdf5CarriesAxesAndAttributes) {
  const TestFolder folder;
  data_test::write_test_file(folder / "a.h5", test_product(4, 3, 8), {scene::FileFormat::hdf5, false, false, false});
  const auto source = open_whole(folder / "a.h5");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().sample_rate_hz, 100e6);
  EXPECT_EQ(source->info().lsb_v, 2.5e-9);
  const auto axes = source->axes();
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->column_range_m[2], 1003.0);
}

TEST(Raster, BinaryOfEveryNumberOfBitsIsReadToTheNearestFloat) {
  const TestFolder folder;
  for (int bits = 1; bits <= 64; ++bits) {
    const auto product = test_product(3, 5, bits);
    data_test::write_test_file(folder / "a.bin", product, {scene::FileFormat::binary, true, true, false});
    const auto source = open_whole(folder / "a.bin", sample_hints(5, bits));
    ASSERT_TRUE(source);
    const auto samples = read_all(*source);
    const auto counts = data_test::test_counts(15, bits);
    for (std::size_t i = 0; i < 15; ++i)
      ASSERT_EQ(samples[i],
                std::complex<float>(static_cast<float>(counts[2 * i]), static_cast<float>(counts[2 * i + 1])))
          << bits;
  }
}

// --- Whole rows -------------------------------------------------------------------------------------------------

TEST(Raster, GivesCountsBeyondFloatInWholeRows) {
  const TestFolder folder;
  const auto hints = sample_hints(5, 53);
  data_test::write_test_file(folder / "a.bin", test_product(3, 5, 53), {scene::FileFormat::binary, true, true, false});
  data_test::write_test_file(folder / "a.csv", test_product(3, 5, 53), {scene::FileFormat::csv, true, true, false});
  const auto counts = data_test::test_counts(15, 53);
  for (const char* name : {"a.bin", "a.csv"}) {
    const auto raster = open_whole(folder / name, name[2] == 'b' ? hints : sample_hints(0, 53));
    ASSERT_TRUE(raster);
    const auto samples = data_test::read_all_rows(*raster);
    for (std::size_t i = 0; i < 15; ++i)
      ASSERT_EQ(samples[i],
                std::complex<double>(static_cast<double>(counts[2 * i]), static_cast<double>(counts[2 * i + 1])))
          << name;
  }
}

TEST(Raster, OfACustomFileHasToHoldAllItsRowsWhereItIsWorkedWith) {
  const TestFolder folder;
  const fs::path path = put(folder / "a.raw", "abcdef");
  RasterHints hints;
  hints.raw = RawLayout{.width = 2, .height = 4, .value = ImageValue::real};
  EXPECT_EQ(open_whole(path, hints)->rows(), 3U);
  const OpenedRaster whole = open_raster(Integrity::whole, path, hints);
  EXPECT_FALSE(whole.raster);
  EXPECT_THAT(text_of(whole.problems), HasSubstr("the file holds fewer rows"));
  hints.raw->height = 2;
  const OpenedRaster part = open_raster(Integrity::whole, path, hints);
  ASSERT_TRUE(part.raster);
  EXPECT_EQ(data_test::read_all_rows(*part.raster), (std::vector<std::complex<double>>{'a', 'b', 'c', 'd'}));
}

TEST(ComputedRaster, GivesWhatItsFunctionGives) {
  const auto raster = std::make_shared<
      ComputedRaster>(40, 30, [](const ImageWindow& window, std::span<std::complex<float>> out) {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = {static_cast<float>(window.row(i / window.cols)), static_cast<float>(window.column(i % window.cols))};
  });
  EXPECT_EQ(read(*raster, {2, 2, 3, 2, 5, 7}), (std::vector<std::complex<float>>{{2, 3}, {2, 10}, {7, 3}, {7, 10}}));
  EXPECT_EQ(data_test::read_all_rows(*raster)[39 * 30 + 29], std::complex<double>(39, 29));
  EXPECT_THROW(read(*raster, {40, 1, 0, 1}), std::out_of_range);
}

TEST(ComputedRaster, FirstRowsStayAsManyAsTheyWere) {
  const TestFolder folder;
  const fs::path path = put(folder / "a.bin", std::string(4 * 6, '\x80'));
  const auto growing = open_whole(path, sample_hints(3, 8));
  ASSERT_TRUE(growing);
  const auto first = first_rows(growing, growing->rows());
  std::ofstream(path, std::ios::binary | std::ios::app) << std::string(12, '\x81');
  EXPECT_EQ(growing->refresh(), 6U);
  EXPECT_EQ(first->rows(), 4U);
  EXPECT_EQ(read(*first, {3, 1, 2, 1})[0], std::complex<float>(1, 1));
}

// --- What is missing --------------------------------------------------------------------------------------------

TEST(Raster, SaysWhatAFileWithoutADescriptionNeeds) {
  const TestFolder folder;
  const auto refusal = [&](const fs::path& path) {
    const OpenedRaster opened = open_raster(Integrity::partial, path);
    EXPECT_FALSE(opened.raster);
    EXPECT_TRUE(core::has_errors(opened.problems));
    return text_of(opened.problems);
  };
  EXPECT_THAT(refusal(put(folder / "a.bin", "1234")), HasSubstr("does not say its own shape"));
  EXPECT_THAT(refusal(put(folder / "a.xyz", std::string("\0\1\2\3", 4))), HasSubstr("describe it as a custom file"));
  EXPECT_THAT(refusal(put(folder / "b.xyz", "")), HasSubstr("empty"));
  EXPECT_THAT(refusal(folder / "none"), HasSubstr("cannot read the file"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("it is a folder"));
}

// --- Growing files ----------------------------------------------------------------------------------------------

TEST(Raster, RefreshFindsWhatABinaryFileHasGrownAndLost) {
  const TestFolder folder;
  const fs::path path = put(folder / "a.bin", std::string(4 * 6, '\x80'));
  const auto source = open_whole(path, sample_hints(3, 8));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->rows(), 4U);
  std::ofstream(path, std::ios::binary | std::ios::app) << std::string(13, '\x81');
  EXPECT_EQ(source->refresh(), 6U);
  EXPECT_EQ(read(*source, {5, 1, 0, 1})[0], std::complex<float>(2, 2));
  fs::resize_file(path, 11);
  EXPECT_EQ(source->refresh(), 1U);
  EXPECT_THROW(read(*source, {1, 1, 0, 1}), std::out_of_range);
}

TEST(Raster, RefreshFindsNewRowsOfATextAndCompletesTheLast) {
  const TestFolder folder;
  const fs::path path = put(folder / "a.csv", "1,2,3,4\n5,6,7,8\n9,10");
  const auto source = open_whole(path);
  ASSERT_TRUE(source);
  EXPECT_EQ(source->rows(), 2U);
  EXPECT_TRUE(source->problems().empty());
  std::ofstream(path, std::ios::app) << ",11,12\n13,14,15,1";
  source->refresh();
  source->wait_until_indexed(nullptr);
  ASSERT_EQ(source->rows(), 4U);
  EXPECT_EQ(read(*source, {2, 1, 0, 2}), (std::vector<std::complex<float>>{{9, 10}, {11, 12}}));
  std::ofstream(path, std::ios::app) << "6\n17,18,19,20\n";
  source->refresh();
  source->wait_until_indexed(nullptr);
  ASSERT_EQ(source->rows(), 5U);
  EXPECT_EQ(read(*source, {3, 2, 1, 1}), (std::vector<std::complex<float>>{{15, 16}, {19, 20}}));
}

// --- Drafts and stopping ----------------------------------------------------------------------------------------

TEST(Raster, DraftIsCoarserWhereTheTimeIsShortAndStandsForItsNeighbours) {
  const TestFolder folder;
  std::string bytes;
  for (int i = 0; i < 64 * 64; ++i) bytes += static_cast<char>(i % 64 + i / 64);
  RawLayout layout;
  layout.width = 64;
  layout.value = ImageValue::real;
  RasterHints hints;
  hints.raw = layout;
  const auto source = open_whole(put(folder / "a.raw", bytes), hints);
  ASSERT_TRUE(source);
  const ImageWindow window{3, 61, 1, 60};
  std::vector<std::complex<float>> exact(window.samples());
  EXPECT_EQ(source->read_draft(window, 1.0, exact), window);
  EXPECT_EQ(exact, read(*source, window));
  std::vector<std::complex<float>> draft(window.samples());
  const ImageWindow coarse = source->read_draft(window, source->read_cost_s(window) / 20.0, draft);
  EXPECT_LE(source->read_cost_s(coarse), source->read_cost_s(window) / 20.0);
  ASSERT_GT(coarse.row_step * coarse.col_step, 1U);
  for (std::size_t i = 0; i < window.rows; ++i)
    for (std::size_t k = 0; k < window.cols; ++k) {
      const std::size_t row = i / coarse.row_step * coarse.row_step;
      const std::size_t column = k / coarse.col_step * coarse.col_step;
      ASSERT_EQ(draft[i * window.cols + k], exact[row * window.cols + column]);
    }
}

TEST(Raster, ReadingStopsWhereItIsAskedTo) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.bin", std::string(600, '\x80')), sample_hints(3, 8));
  ASSERT_TRUE(source);
  core::StopFlag stop;
  stop.request();
  std::vector<std::complex<float>> samples(300);
  EXPECT_THROW(source->read_window({0, 100, 0, 3}, samples, {1, &stop}), core::Interrupted);
}

}  // namespace raster_test
}  // namespace sarsim::raster
