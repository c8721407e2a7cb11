#include "picture/image/overview.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>
#include "raster/table/computed_raster.hpp"
#include "support/processor_time.hpp"

namespace sarsim::picture {
namespace overview_test {

namespace fs = std::filesystem;

using Magnitude = std::function<float(std::size_t, std::size_t)>;

// A plane whose samples have given magnitudes; counts how many were read.
raster::ComputedRaster::Read reader_of(const Magnitude& magnitude, std::atomic<std::uint64_t>* read = nullptr) {
  return [=](const raster::ImageWindow& window, std::span<std::complex<float>> out) {
    if (read != nullptr) *read += out.size();
    for (std::size_t i = 0; i < window.rows; ++i)
      for (std::size_t k = 0; k < window.cols; ++k) {
        const float value = magnitude(window.row0 + i * window.row_step, window.col0 + k * window.col_step);
        out[i * window.cols + k] = {0.6F * value, -0.8F * value};
      }
  };
}

using Plane = std::shared_ptr<const raster::Raster>;

Plane plane_of(std::size_t rows, std::size_t columns, const Magnitude& magnitude,
               std::atomic<std::uint64_t>* read = nullptr) {
  return std::make_shared<raster::ComputedRaster>(rows, columns, reader_of(magnitude, read));
}

float scrambled(std::size_t row, std::size_t column) {
  return static_cast<float>((row * 7919 + column * 104729) % 1013) + 1.0F;
}

// Peak or mean of a cell, by definition.
double cell_by_definition(OverviewKind kind, std::size_t rows, std::size_t columns, const Magnitude& magnitude,
                          std::size_t row0, std::size_t height, std::size_t col0, std::size_t width) {
  double peak = 0.0;
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t row = row0; row < std::min(rows, row0 + height); ++row)
    for (std::size_t column = col0; column < std::min(columns, col0 + width); ++column) {
      const auto value = static_cast<double>(magnitude(row, column));
      peak = std::max(peak, value);
      sum += value;
      count += 1.0;
    }
  return kind == OverviewKind::peak ? peak : sum / count;
}

std::vector<float> read(const Overview& overview, unsigned row_log2, unsigned col_log2) {
  const OverviewLevel level = overview.level(row_log2, col_log2);
  std::vector<float> cells(level.rows * level.columns);
  overview.read(row_log2, col_log2, 0, level.rows, 0, level.columns, cells);
  return cells;
}

class OverviewOfKind : public testing::TestWithParam<OverviewKind> {};

TEST_P(OverviewOfKind, HoldsPeaksOrMeansAtEveryStep) {
  constexpr std::size_t rows = 1237;
  constexpr std::size_t columns = 1811;
  OverviewOptions options;
  options.kind = GetParam();
  const Overview overview(plane_of(rows, columns, scrambled), options);
  overview.wait();
  ASSERT_EQ(overview.state(), OverviewState::complete) << overview.failure();
  EXPECT_EQ(overview.base().row_log2, 1U);
  EXPECT_EQ(overview.base().col_log2, 1U);
  EXPECT_EQ(overview.progress().done, overview.progress().total);
  for (const auto& [row_log2, col_log2] : {std::pair{1U, 1U}, {2U, 2U}, {1U, 5U}, {6U, 2U}, {4U, 4U}, {11U, 11U}}) {
    const OverviewLevel level = overview.level(row_log2, col_log2);
    const std::vector<float> cells = read(overview, row_log2, col_log2);
    for (std::size_t row = 0; row < level.rows; row += 1 + level.rows / 5)
      for (std::size_t column = 0; column < level.columns; column += 1 + level.columns / 5)
        ASSERT_NEAR(static_cast<double>(cells[row * level.columns + column]),
                    cell_by_definition(GetParam(), rows, columns, scrambled, row << row_log2, 1U << row_log2,
                                       column << col_log2, 1U << col_log2),
                    2e-3)
            << row_log2 << " " << col_log2 << " " << row << " " << column;
    // The last cell is cut off on both sides.
    EXPECT_NEAR(static_cast<double>(cells.back()),
                cell_by_definition(GetParam(), rows, columns, scrambled, (level.rows - 1) << row_log2, 1U << row_log2,
                                   (level.columns - 1) << col_log2, 1U << col_log2),
                2e-3);
  }
}

TEST_P(OverviewOfKind, OfPartsIsReadStraightFromThePlaneToo) {
  const Plane plane = plane_of(50, 70, scrambled);
  std::vector<float> cells(6 * 5);
  reduce_plane(*plane, GetParam(), 31, 6, 4, 40, 5, 7, cells);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 5; ++k) {
      const bool inside = 31 + 4 * i < 50 && 40 + 7 * k < 70;
      const double expected =
          inside ? cell_by_definition(GetParam(), 50, 70, scrambled, 31 + 4 * i, 4, 40 + 7 * k, 7) : 0.0;
      EXPECT_NEAR(static_cast<double>(cells[i * 5 + k]), expected, 1e-3) << i << " " << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, OverviewOfKind, testing::Values(OverviewKind::peak, OverviewKind::mean),
                         [](const auto& tested) { return tested.param == OverviewKind::peak ? "peak" : "mean"; });

TEST(Overview, ThinsOutTheLongerSideUntilItsCellsFit) {
  OverviewOptions options;
  options.max_cells = 10000;
  const Overview tall(plane_of(1 << 20, 64, [](std::size_t row, std::size_t) { return row == 777777 ? 5.0F : 1.0F; }),
                      options);
  EXPECT_EQ(tall.base().col_log2, 1U);
  EXPECT_EQ(tall.base().row_log2, 12U);
  EXPECT_LE(tall.base().rows * tall.base().columns, 10000U);
  tall.wait();
  const auto cells = read(tall, 12, 1);
  for (std::size_t row = 0; row < tall.base().rows; ++row)
    EXPECT_EQ(cells[row * tall.base().columns], row == (777777U >> 12U) ? 5.0F : 1.0F);
}

TEST(Overview, OfAHugePlaneShowsSomethingOfAllOfItBeforeItIsExact) {
  OverviewOptions options;
  options.max_cells = 1 << 16;
  std::atomic<std::uint64_t> samples{0};
  Overview overview(
      plane_of(
          1 << 18, 1 << 13, [](std::size_t row, std::size_t) { return row >= (1U << 17U) ? 2.0F : 1.0F; }, &samples),
      options);
  const OverviewLevel base = overview.base();
  const auto shown = [&] {
    const auto cells = read(overview, base.row_log2, base.col_log2);
    return cells.front() == 1.0F && cells[base.rows / 4 * base.columns] == 1.0F && cells.back() == 2.0F;
  };
  const auto begin = std::chrono::steady_clock::now();
  while (!shown() && std::chrono::steady_clock::now() - begin < std::chrono::seconds(20)) usleep(1000);
  EXPECT_TRUE(shown());
  EXPECT_EQ(overview.state(), OverviewState::building);
  EXPECT_LT(samples, (std::uint64_t{1} << 31U) / 10);
  const sarsim::test::ProcessorTime stopping;
  overview.stop();
  overview.wait();
  EXPECT_LT(stopping.seconds(), 1.0);
  EXPECT_EQ(overview.state(), OverviewState::stopped);
  EXPECT_EQ(overview.failure(), "");
}

TEST(Overview, ShowsTheNearestRowBeforeThoseThatHaveNotBeenLookedAt) {
  // Reading waits at the third row that is looked at.
  std::atomic<int> reads{0};
  std::atomic<bool> go_on{false};
  const auto sound = reader_of([](std::size_t row, std::size_t) { return 1.0F + static_cast<float>(row); });
  const auto waiting = [&](const raster::ImageWindow& window, std::span<std::complex<float>> out) {
    if (++reads > 2) {
      while (!go_on) usleep(100);
      throw std::runtime_error("enough");
    }
    sound(window, out);
  };
  const Plane plane = std::make_shared<raster::ComputedRaster>(1 << 18, 1 << 13, waiting);
  OverviewOptions options;
  options.max_cells = 1 << 16;
  const Overview overview(plane, options);
  while (reads < 3) usleep(100);
  const OverviewLevel base = overview.base();
  const auto cells = read(overview, base.row_log2, base.col_log2);
  go_on = true;
  EXPECT_EQ(cells[0], 1.0F);
  EXPECT_EQ(cells[63 * base.columns], 1.0F);
  EXPECT_EQ(cells[64 * base.columns], 1.0F + static_cast<float>(std::size_t{64} << base.row_log2));
  EXPECT_EQ(cells[100 * base.columns], cells[64 * base.columns]);
  EXPECT_EQ(cells[128 * base.columns], 0.0F);
}

TEST(Overview, OfLongRowsKeepsTheirColumnsApart) {
  constexpr std::size_t columns = 600'000;
  const Plane plane = plane_of(
      3, columns, [](std::size_t row, std::size_t column) { return static_cast<float>(row * columns + column); });
  std::vector<float> cells(600);
  reduce_plane(*plane, OverviewKind::peak, 0, 1, 3, 0, 600, 1000, cells);
  for (std::size_t k = 0; k < cells.size(); ++k)
    ASSERT_NEAR(cells[k], static_cast<float>(2 * columns + 1000 * k + 999), 0.5F) << k;
}

TEST(Overview, NamesWhatWentWrongAndKeepsWhatItHas) {
  const auto failing = [read = reader_of(scrambled)](const raster::ImageWindow& window,
                                                     std::span<std::complex<float>> out) {
    if (window.row0 >= 50) throw std::runtime_error("the disk is gone");
    read(window, out);
  };
  const Overview overview(std::make_shared<raster::ComputedRaster>(100, 100, failing));
  overview.wait();
  EXPECT_EQ(overview.state(), OverviewState::stopped);
  EXPECT_EQ(overview.failure(), "the disk is gone");
  EXPECT_EQ(overview.progress().done, 25U);
  EXPECT_GT(read(overview, 1, 1)[0], 0.0F);
}

TEST(Overview, TakesWhatIsNoNumberAsNothingAndTheInfiniteAsTheLargest) {
  for (const OverviewKind kind : {OverviewKind::peak, OverviewKind::mean}) {
    const auto strange = [](const raster::ImageWindow& window, std::span<std::complex<float>> out) {
      for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = window.col0 + i % window.cols < 2 ? std::complex<float>(std::numeric_limits<float>::quiet_NaN(), 0.0F)
                                                   : std::complex<float>(std::numeric_limits<float>::infinity(), 0.0F);
    };
    const Plane plane = std::make_shared<raster::ComputedRaster>(2, 4, strange);
    OverviewOptions options;
    options.kind = kind;
    const Overview overview(plane, options);
    overview.wait();
    EXPECT_EQ(read(overview, 1, 1), (std::vector<float>{0.0F, std::numeric_limits<float>::max()}));
  }
}

TEST(Overview, OfNothingIsComplete) {
  const Overview overview(plane_of(0, 0, scrambled));
  EXPECT_EQ(overview.state(), OverviewState::complete);
  overview.read(1, 1, 0, 0, 0, 0, {});
  std::vector<float> cell(1);
  EXPECT_THROW(overview.read(1, 1, 0, 1, 0, 1, cell), std::out_of_range);
}

TEST(Overview, RefusesCellsThatAreNotThere) {
  const Overview overview(plane_of(10, 10, scrambled));
  std::vector<float> cells(4);
  EXPECT_THROW(overview.read(0, 1, 0, 2, 0, 2, cells), std::out_of_range);
  EXPECT_THROW(overview.read(1, 1, 4, 2, 0, 2, cells), std::out_of_range);
  EXPECT_THROW(overview.read(1, 1, 0, 2, std::numeric_limits<std::size_t>::max(), 2, cells), std::out_of_range);
  EXPECT_THROW(overview.read(1, 1, 0, 2, 0, 1, cells), std::invalid_argument);
}

// --- The cache --------------------------------------------------------------------------------------------------

class CacheTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "sarsim_overview_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] OverviewOptions options(const std::string& identity) const {
    OverviewOptions result;
    result.cache = OverviewCache(folder_ / "cache", identity);
    return result;
  }
  // Builds or loads the overview of a plane; says whether it was loaded.
  static bool loaded(const OverviewOptions& options, std::size_t columns = 40) {
    const Overview overview(plane_of(30, columns, scrambled), options);
    overview.wait();
    EXPECT_EQ(overview.state(), OverviewState::complete);
    const Overview fresh(plane_of(30, columns, scrambled), {options.kind});
    fresh.wait();
    EXPECT_EQ(read(overview, 1, 1), read(fresh, 1, 1));
    EXPECT_EQ(read(overview, 3, 2), read(fresh, 3, 2));
    return overview.from_cache();
  }
  [[nodiscard]] std::size_t files() const {
    const auto begin = fs::directory_iterator(folder_ / "cache");
    return static_cast<std::size_t>(std::distance(begin, fs::directory_iterator()));
  }
  [[nodiscard]] fs::path only_file() const { return fs::directory_iterator(folder_ / "cache")->path(); }

  fs::path folder_;
};

TEST_F(CacheTest, KeepsAnOverviewUntilTheFileIsAnother) {
  EXPECT_FALSE(loaded(options("file a")));
  EXPECT_TRUE(loaded(options("file a")));
  EXPECT_FALSE(loaded(options("file b")));
  OverviewOptions mean = options("file a");
  mean.kind = OverviewKind::mean;
  EXPECT_FALSE(loaded(mean));
  EXPECT_FALSE(loaded(options("file a"), 41));
  EXPECT_TRUE(loaded(options("file a")));
  EXPECT_EQ(files(), 4U);
}

TEST_F(CacheTest, DoesNotKeepWhatWasChangedMeanwhile) {
  OverviewOptions changing = options("file a");
  changing.still_the_same = [] { return false; };
  EXPECT_FALSE(loaded(changing));
  EXPECT_FALSE(fs::exists(folder_ / "cache"));
}

TEST_F(CacheTest, IgnoresDamagedAndForeignFiles) {
  EXPECT_FALSE(loaded(options("file a")));
  const fs::path file = only_file();
  std::ifstream stream(file, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  const auto put = [&](const std::string& text) { std::ofstream(file, std::ios::binary) << text; };
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    put(damaged);
    ASSERT_FALSE(options("file a").cache->load("cells 1 0 30 40 1 1", 300)) << at;
  }
  put(whole.substr(0, whole.size() - 1));
  EXPECT_FALSE(loaded(options("file a")));
  EXPECT_TRUE(loaded(options("file a"))) << "it is made anew";
  put("some words of another program");
  EXPECT_FALSE(loaded(options("file a")));
}

TEST_F(CacheTest, RemovesTheOldestOfItsOwnFilesOnly) {
  const fs::path place = folder_ / "cache";
  const OverviewCache cache(place, "file", 3000);
  const std::vector<float> numbers(200, 1.0F);
  fs::create_directories(place);
  std::ofstream(place / "letter.txt") << std::string(5000, 'x');
  for (int i = 0; i < 5; ++i) {
    cache.store(std::to_string(i), numbers);
    std::error_code error;
    fs::last_write_time(cache.file_of(std::to_string(i)),
                        fs::file_time_type::clock::now() - std::chrono::seconds(100 - i), error);
  }
  EXPECT_FALSE(cache.load("0", 200));
  EXPECT_FALSE(cache.load("1", 200));
  EXPECT_TRUE(cache.load("2", 200));
  EXPECT_TRUE(cache.load("4", 200));
  EXPECT_TRUE(fs::exists(place / "letter.txt"));
  // A file that was just used outlives a younger one that was not.
  cache.store("5", numbers);
  EXPECT_FALSE(cache.load("3", 200));
  EXPECT_TRUE(cache.load("2", 200));
}

TEST_F(CacheTest, DoesWithoutAFolderThatCannotBeMade) {
  std::ofstream(folder_ / "cache") << "a file where the folder should be";
  EXPECT_FALSE(loaded(options("file a")));
  EXPECT_FALSE(loaded(options("file a")));
}

TEST_F(CacheTest, IdentityOfAFileChangesWithItsContent) {
  const fs::path file = folder_ / "a";
  std::ofstream(file) << "12345";
  const auto before = file_identity(file);
  ASSERT_TRUE(before);
  EXPECT_EQ(file_identity(folder_ / "." / "a"), before);
  std::ofstream(file, std::ios::app) << "6";
  const auto longer = file_identity(file);
  EXPECT_NE(longer, before);
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_NE(file_identity(file), longer);
  EXPECT_FALSE(file_identity(folder_ / "none"));
}

}  // namespace overview_test
}  // namespace sarsim::picture
