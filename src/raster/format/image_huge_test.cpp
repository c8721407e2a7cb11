#include "raster/format/open_raster.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <random>

#include "raster/format/image_test_support.hpp"
#include "raster/format/npy_header.hpp"
#include "support/processor_time.hpp"

namespace sarsim::raster {
namespace image_huge_test {

namespace fs = std::filesystem;
using data_test::read;
using data_test::sample_hints;
using data_test::TestFolder;
using data_test::text_of;

double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  statm >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

// A file of 40 GB that takes hardly any place on the disk, with some samples that are not zero.
class HugeFile : public testing::Test {
 protected:
  static constexpr std::uint64_t bytes = std::uint64_t{40} << 30;

  bool make(const std::string& begin, std::uint64_t mark_at, const std::string& mark) {
    path_ = folder_ / "huge";
    const int file = ::open(path_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    if (file < 0) return false;
    const bool made =
        ::ftruncate(file, static_cast<off_t>(bytes)) == 0 &&
        ::pwrite(file, begin.data(), begin.size(), 0) == static_cast<ssize_t>(begin.size()) &&
        ::pwrite(file, mark.data(), mark.size(), static_cast<off_t>(mark_at)) == static_cast<ssize_t>(mark.size());
    ::close(file);
    return made;
  }

  // Reads windows of 1600 x 1000 at random places and spacings; processor seconds of a window on average.
  double window_seconds(const Raster& source) {
    std::mt19937_64 random(7);
    std::vector<std::complex<float>> samples(1600 * 1000);
    constexpr int windows = 12;
    const sarsim::test::ProcessorTime time;
    for (int i = 0; i < windows; ++i) {
      ImageWindow window{0, 1000, 0, 1600};
      window.row_step = 1 + random() % (source.rows() / 1001);
      window.col_step = 1 + random() % (source.columns() / 1601);
      window.row0 = random() % (source.rows() - 999 * window.row_step);
      window.col0 = random() % (source.columns() - 1599 * window.col_step);
      source.read_draft(window, 0.02, samples, {2, nullptr});
    }
    return time.seconds() / windows;
  }

  TestFolder folder_;
  fs::path path_;
};

TEST_F(HugeFile, OfBinaryOpensAtOnceAndIsReadAnywhereWithLittleMemory) {
  constexpr std::size_t columns = 4096;
  const std::uint64_t row = 2 * columns;
  if (!make("", 3'000'000 * row + 2 * 1234, "\x85\x86")) GTEST_SKIP() << "the disk does not take files with holes";
  const double before = resident_mb();
  const sarsim::test::ProcessorTime time;
  const OpenedRaster opened = open_raster(Integrity::partial, path_, [&] {
    RasterHints hints = sample_hints(columns, 8);
    hints.format = scene::FileFormat::binary;
    return hints;
  }());
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_LT(time.seconds(), 1.0);
  EXPECT_EQ(opened.raster->rows(), bytes / row);
  EXPECT_EQ(read(*opened.raster, {2'999'999, 3, 1234, 1})[1], std::complex<float>(6, 7));
  const double average = window_seconds(*opened.raster);
  RecordProperty("milliseconds_of_a_window", std::to_string(1e3 * average));
  EXPECT_LT(average, 0.2);  // 33 ms where nothing else runs: docs/formats/images.md.
  EXPECT_LT(resident_mb() - before, 300.0);
}

TEST_F(HugeFile, OfNumpyOpensAtOnceAndIsReadAnywhereWithLittleMemory) {
  constexpr std::size_t columns = 50'000;
  constexpr std::size_t rows = 107'000;
  const std::string header = npy_header_text("<c8", std::array<std::size_t, 2>{rows, columns});
  const float value = 2.5F;
  const std::string mark(reinterpret_cast<const char*>(&value), 4);
  if (!make(header, header.size() + 8 * (columns * 99'999ULL + 49'999), mark))
    GTEST_SKIP() << "the disk does not take files with holes";
  const double before = resident_mb();
  const sarsim::test::ProcessorTime time;
  const OpenedRaster opened = open_raster(Integrity::partial, path_);
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_LT(time.seconds(), 1.0);
  EXPECT_EQ(opened.raster->rows(), rows);
  EXPECT_EQ(read(*opened.raster, {99'990, 10, 49'990, 10})[99], std::complex<float>(2.5F, 0.0F));
  const double average = window_seconds(*opened.raster);
  RecordProperty("milliseconds_of_a_window", std::to_string(1e3 * average));
  EXPECT_LT(average, 0.2);
  EXPECT_LT(resident_mb() - before, 300.0);
}

}  // namespace image_huge_test
}  // namespace sarsim::raster
