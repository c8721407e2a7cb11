#include <gtest/gtest.h>

#include "raster/format/data_test_support.hpp"
#include "support/folders.hpp"

// Reads what the programs of 1997 to 2015 wrote; those of 1998 are part of the project, the others are not.
namespace sarsim::raster {
namespace reference_files_test {

using namespace data_test;

using test::reference_folder;

struct Shape {
  const char* file;
  std::size_t rows;
  std::size_t columns;
};

class ReferenceFile : public testing::TestWithParam<Shape> {};

INSTANTIATE_TEST_SUITE_P(Old, ReferenceFile,
                         testing::Values(Shape{"original/examples/sim1.asc", 19, 146},
                                         Shape{"original/helvin/sims1.asc", 1, 160},
                                         Shape{"original/helvin/sims2.asc", 5, 200},
                                         Shape{"original/helvin/exam1_sim2_first6pulses.asc", 6, 53},
                                         Shape{"original/linux/exam2.asc", 19, 146},
                                         Shape{"original/linux/final.h5", 19, 146},
                                         Shape{"original/stc/sim3_third.asc", 1, 5003}));

void expect_shape(const fs::path& path, const Shape& shape) {
  const auto opened = open_raster(Integrity::whole, path);
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_TRUE(opened.problems.empty()) << text_of(opened.problems);
  EXPECT_EQ(opened.raster->rows(), shape.rows);
  EXPECT_EQ(opened.raster->info().columns, shape.columns);
  EXPECT_TRUE(opened.raster->info().counts);
  const auto samples = read_all_rows(*opened.raster);
  EXPECT_TRUE(std::ranges::any_of(samples, [](const auto& sample) { return sample != 0.0; }));
}

TEST_P(ReferenceFile, HasItsShapeAndIsNotEmpty) {
  const fs::path path = reference_folder() / GetParam().file;
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not here; SARSIM_REFERENCE names the folder";
  expect_shape(path, GetParam());
}

TEST(ReferenceFiles, OfTheProgramOf1998HaveTheirShapes) {
  for (const Shape& shape :
       {Shape{"a2_mono_raw.asc", 2, 53}, Shape{"sar_c_band_receding.asc", 121, 500}, Shape{"a4_search.asc", 201, 4}})
    expect_shape(test::direct_reference_folder() / shape.file, shape);
}

TEST(ReferenceFiles, TheOldHdf5HoldsItsParameters) {
  const fs::path path = reference_folder() / "original/linux/final.h5";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not here; SARSIM_REFERENCE names the folder";
  const auto opened = open_raster(Integrity::whole, path);
  ASSERT_TRUE(opened.raster);
  EXPECT_EQ(opened.raster->info().bits, 8);
  EXPECT_TRUE(opened.raster->info().lsb_v);
  EXPECT_TRUE(opened.raster->info().sample_rate_hz);
  EXPECT_FALSE(opened.raster->info().attributes.empty());
}

TEST(ReferenceFiles, TheOldHdf5HoldsTheCountsOfTheText) {
  const fs::path folder = reference_folder() / "original/linux";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not here; SARSIM_REFERENCE names the folder";
  const auto text = open_raster(Integrity::whole, folder / "exam2.asc");
  const auto hdf5 = open_raster(Integrity::whole, folder / "final.h5");
  ASSERT_TRUE(text.raster && hdf5.raster);
  const auto a = read_all_rows(*text.raster);
  const auto b = read_all_rows(*hdf5.raster);
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) same += a[i] == b[i] ? 1U : 0U;
  EXPECT_EQ(same, a.size());
}

}  // namespace reference_files_test
}  // namespace sarsim::raster
