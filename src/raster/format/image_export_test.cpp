#include "raster/format/image_export.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/report/invalid_request.hpp"
#include "raster/format/data_test_support.hpp"
#include "raster/table/product_attributes.hpp"

namespace sarsim::raster {
namespace image_export_test {

namespace fs = std::filesystem;
using data_test::put;
using data_test::TestFolder;

std::shared_ptr<Raster> open_whole(const fs::path& path, const RasterHints& hints = {}) {
  const OpenedRaster opened = open_raster(Integrity::partial, path, hints);
  EXPECT_TRUE(opened.raster) << data_test::text_of(opened.problems);
  if (opened.raster) opened.raster->wait_until_indexed(nullptr);
  return opened.raster;
}

std::vector<std::complex<float>> read_all(const Raster& source) {
  std::vector<std::complex<float>> samples(source.rows() * source.columns());
  source.read_window({0, source.rows(), 0, source.columns()}, samples);
  return samples;
}

RasterHints shape(std::size_t columns, int bits) {
  RasterHints hints;
  hints.columns = columns;
  hints.bits = bits;
  return hints;
}

// Two rows of two samples in volts, as a file of bare numbers.
std::shared_ptr<Raster> open_volts(const fs::path& path, const std::array<float, 8>& volts) {
  RawLayout layout;
  layout.width = 2;
  layout.number = RawNumber::float32;
  RasterHints hints;
  hints.raw = layout;
  return open_whole(put(path, {reinterpret_cast<const char*>(volts.data()), sizeof volts}), hints);
}

constexpr ImageWindow part{2, 5, 1, 4, 3, 2};

class ExportTo : public testing::TestWithParam<scene::FileFormat> {};

TEST_P(ExportTo, KeepsTheCountsOfASelection) {
  const TestFolder folder;
  data_test::write_test_file(folder / "a.bin", data_test::test_product(20, 9, 12),
                             {scene::FileFormat::binary, false, true, false});
  const auto source = open_whole(folder / "a.bin", shape(9, 12));
  ASSERT_TRUE(source);
  ImageExport options;
  options.sink.format = GetParam();
  options.sink.counts = true;
  const RunReport report = export_window(*source, part, folder / "out", options);
  EXPECT_EQ(report.rows, 5U);
  EXPECT_EQ(report.saturated, 0U);
  RasterHints hints = shape(4, 12);
  hints.format = GetParam();
  const auto stored = open_whole(folder / "out", hints);
  ASSERT_TRUE(stored);
  ASSERT_EQ(stored->rows(), 5U);
  ASSERT_EQ(stored->columns(), 4U);
  std::vector<std::complex<float>> expected(part.samples());
  source->read_window(part, expected);
  EXPECT_EQ(read_all(*stored), expected);
}

INSTANTIATE_TEST_SUITE_P(Formats, ExportTo,
                         testing::Values(scene::FileFormat::ascii, scene::FileFormat::binary,
                                         scene::FileFormat::bracket, scene::FileFormat::hdf5, scene::FileFormat::csv,
                                         scene::FileFormat::npy));

TEST(ExportWindow, RefusesVoltsThatSinglePrecisionCannotHold) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.asc", "1 -2\n3 0\n\n0 0\n5 7\n\n"));
  ASSERT_TRUE(source);
  ImageExport options;
  options.sink.format = scene::FileFormat::npy;
  options.lsb_v = 1e38;
  try {
    export_window(*source, {0, 2, 0, 2}, folder / "b.npy", options);
    FAIL() << "7e38 is infinite in single precision";
  } catch (const core::InvalidRequest& refused) {
    EXPECT_THAT(data_test::text_of(refused.problems), testing::HasSubstr("row 1, sample 1 (from 0) is too large"));
    EXPECT_THAT(data_test::text_of(refused.problems), testing::HasSubstr("5e+38 + 7e+38j V"));
  }
  EXPECT_FALSE(fs::exists(folder / "b.npy"));
  options.sink.doubles = true;
  EXPECT_NO_THROW(export_window(*source, {0, 2, 0, 2}, folder / "b.npy", options));
}

TEST(ExpectSinglePrecision, PassesTheLargestAndWhatIsNotFinite) {
  constexpr double most = std::numeric_limits<float>::max();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::complex<double> passing[] = {{most, -most}, {infinite, std::nan("")}};
  EXPECT_NO_THROW(expect_single_precision(passing, 0, 2));
  const std::complex<double> failing[] = {{0.0, -1.001 * most}};
  EXPECT_THROW(expect_single_precision(failing, 0, 1), core::InvalidRequest);
}

TEST(ExportWindow, KeepsVoltsAndTheAxesOfWhatIsTaken) {
  const TestFolder folder;
  data_test::write_test_file(folder / "a.h5", data_test::test_product(20, 9, 12),
                             {scene::FileFormat::hdf5, false, false, false});
  const auto source = open_whole(folder / "a.h5");
  ASSERT_TRUE(source);
  ImageExport options;
  options.sink.format = scene::FileFormat::hdf5;
  export_window(*source, part, folder / "b.h5", options);
  const auto stored = open_whole(folder / "b.h5");
  ASSERT_TRUE(stored);
  std::vector<std::complex<float>> expected(part.samples());
  source->read_window(part, expected);
  EXPECT_EQ(read_all(*stored), expected);
  const auto axes = stored->axes();
  ASSERT_TRUE(axes);
  EXPECT_DOUBLE_EQ(axes->row_time_s[1], 0.5 + 0.005);
  EXPECT_DOUBLE_EQ(axes->row_carrier_hz[4], 1e9 + 14e6);
  EXPECT_DOUBLE_EQ(axes->column_range_m[3], 1000.0 + 7 * 1.5);
  ASSERT_EQ(axes->row_pose.size(), part.rows);
  EXPECT_THAT(axes->row_pose[1].position_m, testing::ElementsAre(500.0, -0.5, 3.0));
  EXPECT_THAT(axes->row_pose[4].rotation_rad, testing::ElementsAre(0.125, 0.0, -14.0));
  EXPECT_EQ(stored->info().sample_rate_hz, 50e6);
}

TEST(ExportWindow, KeepsWhatTheSourceSaysOfItsOrigin) {
  const TestFolder folder;
  Product product = data_test::test_product(20, 9, 12);
  product.radar = "Another";
  product.processing = scene::Processing::matched_filter;
  product.options = {scene::Profile::classic, 18446744073709551615U, scene::PulseDefinition::band_limited, 1e-3};
  data_test::write_test_file(folder / "a.h5", product, {scene::FileFormat::hdf5, false, false, false});
  const auto source = open_whole(folder / "a.h5");
  ASSERT_TRUE(source);
  ImageExport options;
  options.sink.format = scene::FileFormat::hdf5;
  export_window(*source, part, folder / "b.h5", options);
  Product back;
  take_origin(open_whole(folder / "b.h5")->info().attributes, back);
  EXPECT_EQ(back.radar, product.radar);
  EXPECT_EQ(back.processing, product.processing);
  EXPECT_EQ(back.options, product.options);
  EXPECT_EQ(back.engine, "selection of a.h5");
}

TEST(ExportWindow, SaysNothingThatTheSourceDoesNotSay) {
  const TestFolder folder;
  const auto source = open_volts(folder / "a.raw", {0.5F, 0.0F, -2.0F, 0.0F, 0.0F, 1.0F, 0.008F, 0.0F});
  ASSERT_TRUE(source);
  ImageExport options;
  options.sink.format = scene::FileFormat::hdf5;
  export_window(*source, {0, 2, 0, 2}, folder / "a.h5", options);
  const auto stored = open_whole(folder / "a.h5");
  ASSERT_TRUE(stored);
  EXPECT_FALSE(stored->axes());
  EXPECT_FALSE(stored->info().lsb_v);
  EXPECT_FALSE(stored->info().sample_rate_hz);
  EXPECT_EQ(stored->info().bits, 0);
  Product back;
  take_origin(stored->info().attributes, back);
  EXPECT_EQ(back.unknown, (std::vector<std::string>{"radar", "processing", "profile", "pulse", "cubic_ends",
                                                    "ambiguous_echoes", "eclipsing", "seed", "tolerance"}));
  EXPECT_EQ(back.engine, "selection of a.raw");
}

TEST(ExportWindow, TurnsVoltsIntoCountsThatUseTheWholeRange) {
  const TestFolder folder;
  const auto source = open_volts(folder / "a.raw", {0.5F, 0.0F, -2.0F, 0.0F, 0.0F, 1.0F, 0.008F, std::nanf("")});
  ASSERT_TRUE(source);
  ImageExport options;
  options.sink.format = scene::FileFormat::ascii;
  options.bits = 8;
  const RunReport report = export_window(*source, {0, 2, 0, 2}, folder / "a.asc", options);
  EXPECT_DOUBLE_EQ(report.lsb_v, 2.0 / 127.0);
  EXPECT_DOUBLE_EQ(report.range_used, 1.0);
  EXPECT_EQ(data_test::contents(folder / "a.asc"), "32 0\n-127 0\n\n0 64\n1 0\n\n");
  options.lsb_v = 0.01;
  options.sink.replace = true;
  const RunReport clipped = export_window(*source, {0, 2, 0, 2}, folder / "a.asc", options);
  EXPECT_EQ(clipped.saturated, 1U);
  EXPECT_EQ(clipped.not_numbers, 1U);
  EXPECT_EQ(data_test::contents(folder / "a.asc"), "50 0\n-127 0\n\n0 100\n1 0\n\n");
}

TEST(ExportWindow, TurnsCountsIntoVoltsByTheLsb) {
  const TestFolder folder;
  RasterHints hints = shape(1, 8);
  hints.lsb_v = 0.25;
  const auto source = open_whole(put(folder / "a.bin", "\x81\x7d"), hints);
  ASSERT_TRUE(source);
  ImageExport options;
  options.sink.format = scene::FileFormat::npy;
  export_window(*source, {0, 1, 0, 1}, folder / "a.npy", options);
  const auto stored = open_whole(folder / "a.npy");
  ASSERT_TRUE(stored);
  EXPECT_EQ(read_all(*stored)[0], std::complex<float>(0.5F, -0.5F));
}

TEST(ExportWindow, LeavesNothingBehindWhereItDoesNotEnd) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.bin", std::string(600, '\x80')), shape(3, 8));
  ASSERT_TRUE(source);
  ImageExport options;
  EXPECT_THROW(export_window(*source, {0, 101, 0, 3}, folder / "b.bin", options), std::out_of_range);
  EXPECT_THROW(export_window(*source, {0, 0, 0, 3}, folder / "b.bin", options), std::out_of_range);
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW(export_window(*source, {0, 100, 0, 3}, folder / "b.bin", options, {1, &stop}), core::Interrupted);
  EXPECT_EQ(folder.entries(), 1U);
  put(folder / "c.bin", "mine");
  EXPECT_THROW(export_window(*source, {0, 100, 0, 3}, folder / "c.bin", options), std::system_error);
  EXPECT_EQ(data_test::contents(folder / "c.bin"), "mine");
}

TEST(ExportWindow, ReportsProgressUpToTheEnd) {
  const TestFolder folder;
  const auto source = open_whole(put(folder / "a.bin", std::string(2 << 20, '\x80')), shape(256, 8));
  ASSERT_TRUE(source);
  std::size_t last = 0;
  export_window(*source, {0, source->rows(), 0, 256}, folder / "b.bin", {}, {}, [&](const core::Progress& progress) {
    EXPECT_GT(progress.done, last);
    EXPECT_EQ(progress.total, 4096U);
    last = progress.done;
  });
  EXPECT_EQ(last, 4096U);
}

}  // namespace image_export_test
}  // namespace sarsim::raster
