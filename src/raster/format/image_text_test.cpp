#include "raster/format/open_raster.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <thread>

#include "raster/format/image_test_support.hpp"
#include "support/processor_time.hpp"

namespace sarsim::raster {
namespace image_text_test {

namespace fs = std::filesystem;
using data_test::open_whole;
using data_test::put;
using data_test::read;
using data_test::read_all;
using data_test::sample_hints;
using data_test::TestFolder;
using data_test::text_of;
using testing::HasSubstr;

TEST(Raster, TextsAreReadAnywhereFromRememberedRows) {
  const TestFolder folder;
  constexpr std::size_t rows = 9000;
  std::string text;
  for (std::size_t row = 0; row < rows; ++row)
    text += "(" + std::to_string(row) + ",-1) (" + std::to_string(2 * row) + ",0.5) (7,8)\n";
  const auto source = open_whole(put(folder / "a.brk", text));
  ASSERT_TRUE(source);
  ASSERT_EQ(source->rows(), rows);
  const ImageWindow window{1, 3000, 0, 2, 3, 1};
  const auto samples = read(*source, window, 2);
  for (std::size_t i = 0; i < window.rows; ++i) {
    ASSERT_EQ(samples[2 * i], std::complex<float>(static_cast<float>(window.row(i)), -1.0F));
    ASSERT_EQ(samples[2 * i + 1], std::complex<float>(static_cast<float>(2 * window.row(i)), 0.5F));
  }
  EXPECT_EQ(read(*source, {rows - 1, 1, 0, 3})[0].real(), static_cast<float>(rows - 1));
  EXPECT_EQ(read(*source, {0, 1, 0, 3})[0].real(), 0.0F);
}

TEST(Raster, RowsOfATextThatAreUnevenAreShownWithAWarning) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.csv", "1,2,3,4\n5,6\n1,2,3,4,5,6\n7,8,9,10\n"));
  ASSERT_TRUE(source);
  ASSERT_EQ(source->rows(), 4U);
  EXPECT_EQ(read_all(*source),
            (std::vector<std::complex<float>>{{1, 2}, {3, 4}, {5, 6}, {0, 0}, {1, 2}, {3, 4}, {7, 8}, {9, 10}}));
  EXPECT_EQ(source->problems().size(), 2U);
  EXPECT_THAT(text_of(source->problems()), HasSubstr("a.csv:2"));
  EXPECT_FALSE(core::has_errors(source->problems()));
}

TEST(Raster, ValuesThatNoConverterGivesEndAText) {
  const TestFolder folder;
  RasterHints hints;
  hints.bits = 8;
  const auto rows_and_problems = [&](const char* text) {
    const OpenedRaster opened = open_raster(Integrity::partial, put(folder / "a.csv", text), hints);
    EXPECT_TRUE(opened.raster) << text;
    opened.raster->wait_until_indexed(nullptr);
    return std::pair(opened.raster->rows(), text_of(opened.raster->problems()));
  };
  EXPECT_EQ(rows_and_problems("0,0\n255,127\n"), std::pair(std::size_t{2}, std::string()));
  for (const char* text : {"0,0\n127,127\n-5,3\n1,1\n", "0,0\n127,127\n256,3\n1,1\n", "0,0\n127,127\n1.5,3\n1,1\n"}) {
    const auto [rows, problems] = rows_and_problems(text);
    EXPECT_EQ(rows, 2U) << text;
    EXPECT_THAT(problems, HasSubstr("a.csv:3")) << text;
    EXPECT_THAT(problems, HasSubstr("0 to 255")) << text;
  }
}

TEST(Raster, TextIsShownUpToTheFirstPlaceThatIsMalformed) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.csv", "1,2\n3,4\nfive,6\n7,8\n"));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->rows(), 2U);
  EXPECT_THAT(text_of(source->problems()), testing::AllOf(HasSubstr("a.csv:3:1"), HasSubstr("five")));
}

TEST(Raster, CsvOfSingleNumbersIsReal) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.csv", "x,y,z\n1,2,3\n4,5,6.5\n"));
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().value, ImageValue::real);
  EXPECT_EQ(read_all(*source), (std::vector<std::complex<float>>{1, 2, 3, 4, 5, 6.5F}));
}

TEST(Raster, AsciiIsCutIntoRowsByCountingWhereTheSamplesAreGiven) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.asc", "1 2\n3 4\n5 6\n7 8\n9 10\n"), sample_hints(2, 8));
  ASSERT_TRUE(source);
  ASSERT_EQ(source->rows(), 2U);
  EXPECT_EQ(read(*source, {1, 1, 0, 2}), (std::vector<std::complex<float>>{{5, 6}, {7, 8}}));
}

TEST(Raster, MayBeReadFromManyThreadsWhileATextIsLookedThrough) {
  const TestFolder folder;
  std::string text;
  for (int row = 0; row < 60000; ++row) text += std::to_string(row) + ",1,2," + std::to_string(row) + "\n";
  const OpenedRaster opened = open_raster(Integrity::partial, put(folder / "a.csv", text));
  ASSERT_TRUE(opened.raster);
  std::atomic<int> wrong{0};
  {
    std::vector<std::jthread> readers;
    for (unsigned seed = 0; seed < 3; ++seed)
      readers.emplace_back([&, seed] {
        std::mt19937 random(seed);
        for (int i = 0; i < 300; ++i) {
          const std::size_t known = opened.raster->rows();
          if (known == 0) continue;
          const std::size_t row = random() % known;
          const auto samples = read(*opened.raster, {row, 1, 0, 2});
          if (samples[1] != std::complex<float>(2.0F, static_cast<float>(row))) ++wrong;
          (void)opened.raster->indexed();
        }
      });
  }
  EXPECT_EQ(wrong, 0);
  opened.raster->wait_until_indexed(nullptr);
  EXPECT_EQ(opened.raster->rows(), 60000U);
}

TEST(Raster, EndsAtOnceWhileATextIsStillLookedThrough) {
  const TestFolder folder;
  std::string text;
  for (int row = 0; row < 400000; ++row) text += "10,20,30,40,50,60,70,80\n";
  const fs::path path = put(folder / "a.csv", text);
  const auto seconds_of = [&](bool to_the_end) {
    const sarsim::test::ProcessorTime time;
    const OpenedRaster opened = open_raster(Integrity::partial, path);
    if (to_the_end) opened.raster->wait_until_indexed(nullptr);
    return time;  // which goes on until the raster has been closed
  };
  const double whole_s = seconds_of(true).seconds();
  // The least of several: a thread that waits for a processor may come to its end only when all is looked through.
  double least_s = whole_s;
  for (int i = 0; i < 10; ++i) least_s = std::min(least_s, seconds_of(false).seconds());
  EXPECT_LT(least_s, 0.5 * whole_s);
  core::StopFlag stop;
  stop.request();
  const OpenedRaster opened = open_raster(Integrity::partial, path);
  ASSERT_TRUE(opened.raster);
  EXPECT_THROW(opened.raster->wait_until_indexed(&stop), core::Interrupted);
}

TEST(Raster, LongRowsAreReadInPiecesAndFarSamplesOneByOne) {
  const TestFolder folder;
  constexpr std::size_t columns = 700'001;
  std::string bytes(3 * columns, '\0');
  std::mt19937 random(2);
  for (char& byte : bytes) byte = static_cast<char>(random());
  RawLayout layout;
  layout.width = columns;
  layout.value = ImageValue::real;
  layout.number = RawNumber::int8;
  RasterHints hints;
  hints.raw = layout;
  const auto source = open_whole(put(folder / "a.raw", bytes), hints);
  ASSERT_TRUE(source);
  for (const ImageWindow& window : {ImageWindow{1, 2, 1, columns - 1}, ImageWindow{0, 2, 2, columns / 3, 2, 3},
                                    ImageWindow{0, 3, 7, 140, 1, 4999}, ImageWindow{2, 1, 0, 2, 1, columns - 1}}) {
    const auto samples = read(*source, window, 2);
    for (std::size_t i = 0; i < window.rows; ++i)
      for (std::size_t k = 0; k < window.cols; ++k)
        ASSERT_EQ(samples[i * window.cols + k].real(),
                  static_cast<float>(static_cast<signed char>(bytes[window.row(i) * columns + window.column(k)])))
            << i << ", " << k << ", " << window.col_step;
  }
}

}  // namespace image_text_test
}  // namespace sarsim::raster
