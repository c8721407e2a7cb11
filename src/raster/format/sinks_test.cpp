#include "raster/format/sinks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "core/os/temporary_files.hpp"
#include "raster/format/data_test_support.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {
namespace sinks_test {

using namespace data_test;
using testing::HasSubstr;

struct Case {
  scene::FileFormat format;
  bool counts;
  int bits;
  bool doubles = false;
};

std::string name_of_case(const testing::TestParamInfo<Case>& info) {
  return std::string(name_of(info.param.format)) +
         (info.param.counts    ? "_counts_"
          : info.param.doubles ? "_double_volts_"
                               : "_volts_") +
         std::to_string(info.param.bits);
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const scene::FileFormat format :
       {scene::FileFormat::ascii, scene::FileFormat::csv, scene::FileFormat::bracket, scene::FileFormat::binary,
        scene::FileFormat::hdf5, scene::FileFormat::npy, scene::FileFormat::zarr})
    for (const int bits : {1, 8, 12, 16, 31, 32, 53, 64}) cases.push_back({format, true, bits});
  for (const int bits : {1, 15, 16, 31}) cases.push_back({scene::FileFormat::sigmf, true, bits});
  for (const scene::FileFormat format :
       {scene::FileFormat::hdf5, scene::FileFormat::npy, scene::FileFormat::zarr, scene::FileFormat::sigmf})
    for (const bool doubles : {false, true}) cases.push_back({format, false, 8, doubles});
  return cases;
}

class EveryFormat : public testing::TestWithParam<Case> {
 protected:
  [[nodiscard]] SinkOptions options() const {
    SinkOptions result;
    result.format = GetParam().format;
    result.counts = GetParam().counts;
    result.doubles = GetParam().doubles;
    return result;
  }
  [[nodiscard]] fs::path file(const TestFolder& folder, const std::string& stem = "a") const {
    return folder / (stem + std::string(extension_of(GetParam().format)));
  }
  // That a product becomes.
  [[nodiscard]] std::vector<fs::path> files(const TestFolder& folder, const std::string& stem = "a") const {
    return files_of(&format_of(GetParam().format), file(folder, stem));
  }
};

INSTANTIATE_TEST_SUITE_P(Sinks, EveryFormat, testing::ValuesIn(all_cases()), name_of_case);

TEST_P(EveryFormat, ReadsBackTheSameNumbers) {
  const TestFolder folder;
  const Product product = test_product(11, 7, GetParam().bits);
  write_test_file(file(folder), product, options());
  EXPECT_EQ(folder.entries(), files(folder).size());
  RasterHints hints;
  hints.columns = 7;
  hints.bits = GetParam().bits;
  const auto opened = open_raster(Integrity::whole, file(folder), hints);
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_TRUE(opened.problems.empty()) << text_of(opened.problems);
  const RasterInfo& info = opened.raster->info();
  EXPECT_EQ(info.format, &format_of(GetParam().format));
  EXPECT_EQ(opened.raster->rows(), 11U);
  EXPECT_EQ(info.columns, 7U);
  EXPECT_EQ(info.counts, GetParam().counts);
  const auto samples = read_all_rows(*opened.raster);
  const auto volts = test_volts(77);
  const auto counts = test_counts(77, GetParam().bits);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::complex<double> expected =
        GetParam().counts
            ? std::complex<double>(static_cast<double>(counts[2 * i]), static_cast<double>(counts[2 * i + 1]))
            : volts[i];
    ASSERT_EQ(samples[i], expected) << i;
  }
  std::vector<std::complex<double>> middle(14);
  opened.raster->read_rows(5, 2, middle);
  EXPECT_TRUE(std::equal(middle.begin(), middle.end(), samples.begin() + 35));
}

// A third has no float that is it.
TEST(Sinks, DoublesKeepWhatFloatsLose) {
  for (const scene::FileFormat format : {scene::FileFormat::hdf5, scene::FileFormat::npy, scene::FileFormat::zarr}) {
    const TestFolder folder;
    const fs::path path = folder / ("a" + std::string(extension_of(format)));
    const std::vector<std::complex<double>> third{{1.0 / 3.0, -1.0 / 7.0}};
    SinkOptions options;
    options.format = format;
    options.doubles = true;
    const Product product = test_product(1, 1, 8);
    auto sink = make_sink(path, product, options);
    sink->append(sink->encode({0, 1, 1, third, {}}), 0, 1);
    sink->finish({});
    const auto opened = open_raster(Integrity::whole, path, {});
    ASSERT_TRUE(opened.raster) << text_of(opened.problems);
    EXPECT_EQ(read_all_rows(*opened.raster), third);
  }
}

TEST_P(EveryFormat, SameInputGivesTheSameBytesWhateverTheBlocks) {
  const TestFolder folder;
  const Product product = test_product(11, 7, GetParam().bits);
  write_test_file(file(folder), product, options());
  const auto sink = make_sink(file(folder, "b"), product, options());
  const auto counts = test_counts(77, product.bits);
  const auto volts = test_volts(77);
  Block block{0, 11, 7, {}, {}};
  if (sink->wants_counts()) block.counts = counts;
  if (!sink->wants_counts()) block.volts = volts;
  sink->append(sink->encode(block), 0, 11);
  RunReport report;
  report.lsb_v = 2.5e-9;
  sink->finish(report);
  for (std::size_t i = 0; i < files(folder).size(); ++i)
    EXPECT_TRUE(contents(files(folder)[i]) == contents(files(folder, "b")[i]));
}

// As a second signal has it; in a process of its own, which has to end then.
TEST_P(EveryFormat, NothingIsLeftByAProcessThatEndsAtOnce) {
  const TestFolder folder;
  const Product product = test_product(11, 7, GetParam().bits);
  const auto end_at_once = [&] {
    const auto sink = make_sink(file(folder), product, options());
    const bool begun = folder.entries() == files(folder).size();
    core::remove_temporary_files();
    ::_exit(begun ? 0 : 1);
  };
  EXPECT_EXIT(end_at_once(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(folder.entries(), 0U);
}

TEST_P(EveryFormat, NothingStandsUnderTheNameWithoutFinish) {
  const TestFolder folder;
  const Product product = test_product(11, 7, GetParam().bits);
  {
    const auto sink = make_sink(file(folder), product, options());
    append_all(*sink, product, test_counts(77, product.bits), test_volts(77));
    EXPECT_FALSE(fs::exists(file(folder)));
  }
  EXPECT_EQ(folder.entries(), 0U);
}

TEST_P(EveryFormat, SizeIsAsExpected) {
  const TestFolder folder;
  const Product product = test_product(200, 20, GetParam().bits);
  write_test_file(file(folder), product, options());
  const auto size = static_cast<double>(stored_bytes(file(folder)));
  const bool exact = GetParam().format == scene::FileFormat::binary || GetParam().format == scene::FileFormat::npy;
  // The counts of the test are spread evenly, as the estimate for text supposes.
  EXPECT_NEAR(expected_bytes(product, options()), size, exact ? 0.0 : 0.05 * size);
}

TEST(Sinks, MinusZeroIsNeverWritten) {
  const std::vector<std::int64_t> counts{0, -0, -1, 0, 0, 1};
  for (const scene::FileFormat format :
       {scene::FileFormat::ascii, scene::FileFormat::bracket, scene::FileFormat::csv}) {
    const auto sink = make_discarding_sink(test_product(1, 3, 8), {format});
    EXPECT_THAT(text_of(sink->encode({0, 1, 3, {}, counts})), testing::Not(HasSubstr("-0")));
  }
}

class EveryDisk : public testing::TestWithParam<scene::FileFormat> {};

INSTANTIATE_TEST_SUITE_P(Sinks, EveryDisk,
                         testing::Values(scene::FileFormat::ascii, scene::FileFormat::csv, scene::FileFormat::bracket,
                                         scene::FileFormat::binary, scene::FileFormat::hdf5, scene::FileFormat::npy),
                         [](const auto& test) { return std::string(name_of(test.param)); });

// Writes until an error; returns its number, 0 where everything fitted.
int error_of_writing(const fs::path& path, const Product& product, SinkOptions options, std::string& what) {
  try {
    write_test_file(path, product, options);
  } catch (const std::system_error& error) {
    what = error.what();
    return error.code().value();
  }
  return 0;
}

TEST_P(EveryDisk, RefusesAnExistingFile) {
  const TestFolder folder;
  put(folder / "a", "old");
  std::string what;
  EXPECT_EQ(error_of_writing(folder / "a", test_product(2, 2, 8), {GetParam()}, what), EEXIST);
  EXPECT_EQ(contents(folder / "a"), "old");
  EXPECT_EQ(error_of_writing(folder / "a", test_product(2, 2, 8), {GetParam(), true}, what), 0);
  EXPECT_NE(contents(folder / "a"), "old");
}

TEST_P(EveryDisk, RefusesAFileThatAppearsMeanwhile) {
  const TestFolder folder;
  const Product product = test_product(2, 2, 8);
  const auto sink = make_sink(folder / "a", product, {GetParam()});
  append_all(*sink, product, test_counts(4, 8), test_volts(4));
  put(folder / "a", "theirs");
  EXPECT_THROW(sink->finish({}), std::system_error);
  EXPECT_EQ(contents(folder / "a"), "theirs");
}

TEST_P(EveryDisk, AFullDeviceIsOneCleanError) {
  std::string what;
  EXPECT_EQ(error_of_writing("/dev/full", test_product(2000, 50, 8), {GetParam()}, what), ENOSPC);
  EXPECT_THAT(what, HasSubstr("/dev/full"));
}

// Formats of folders, too.
class EveryStore : public testing::TestWithParam<scene::FileFormat> {};

INSTANTIATE_TEST_SUITE_P(Sinks, EveryStore,
                         testing::Values(scene::FileFormat::ascii, scene::FileFormat::csv, scene::FileFormat::bracket,
                                         scene::FileFormat::binary, scene::FileFormat::hdf5, scene::FileFormat::npy,
                                         scene::FileFormat::zarr),
                         [](const auto& test) { return std::string(name_of(test.param)); });

TEST_P(EveryStore, AFullDiskIsOneCleanErrorAtWhateverByteItFills) {
  const TestFolder folder;
  const Product product = test_product(400, 50, 8);
  for (const char* size : {"size=4k", "size=8k", "size=16k", "size=64k"}) {
    const SmallDisk disk(folder / "disk", size);
    if (!disk.mounted()) GTEST_SKIP() << "may not mount a file system here";
    std::string what;
    const int error = error_of_writing(folder.path() / "disk" / "a", product, {GetParam()}, what);
    const double needed = expected_bytes(product, {GetParam()});
    if (needed > 80e3) {
      EXPECT_EQ(error, ENOSPC) << size;
    }
    if (error != 0) {
      EXPECT_THAT(what, HasSubstr("disk/a")) << size;
    }
    EXPECT_TRUE(error == 0 || fs::is_empty(folder.path() / "disk")) << size;
  }
}

TEST_P(EveryStore, RowsMustComeInOrderAndCompletely) {
  const TestFolder folder;
  const Product product = test_product(3, 2, 8);
  const auto counts = test_counts(6, 8);
  const auto volts = test_volts(6);
  for (const bool discard : {false, true}) {
    const auto sink =
        discard ? make_discarding_sink(product, {GetParam()}) : make_sink(folder / "a", product, {GetParam()});
    const bool whole = sink->wants_counts();
    const auto bytes =
        sink->encode({0, 1, 2, whole ? std::span<const std::complex<double>>() : std::span(volts).first(2),
                      whole ? std::span(counts).first(4) : std::span<const std::int64_t>()});
    EXPECT_THROW(sink->append(bytes, 1, 1), std::logic_error);
    sink->append(bytes, 0, 1);
    EXPECT_THROW(sink->append(bytes, 0, 1), std::logic_error);
    EXPECT_THROW(sink->append(bytes, 1, 3), std::logic_error);
    EXPECT_THROW(sink->finish({}), std::logic_error);
  }
  EXPECT_EQ(folder.entries(), 0U);
}

TEST_P(EveryStore, EmptyProductsMakeAFile) {
  const TestFolder folder;
  std::string what;
  EXPECT_EQ(error_of_writing(folder / "a", test_product(0, 5, 8), {GetParam()}, what), 0) << what;
  EXPECT_EQ(error_of_writing(folder / "b", test_product(5, 0, 8), {GetParam()}, what), 0) << what;
  EXPECT_EQ(folder.entries(), 2U);
}

TEST(Sinks, RefuseBitsOutsideTheRange) {
  EXPECT_THROW((void)make_discarding_sink(test_product(1, 1, 0), {}), std::invalid_argument);
  EXPECT_THROW((void)make_discarding_sink(test_product(1, 1, 65), {}), std::invalid_argument);
}

TEST(Sinks, Hdf5CannotGoThroughAPipe) {
  const TestFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::thread reader([&] { (void)contents(folder / "pipe"); });
  EXPECT_THROW((void)make_sink(folder / "pipe", test_product(1, 1, 8), {scene::FileFormat::hdf5}), std::system_error);
  reader.join();
}

TEST(Sinks, CsvHasAHeaderOnlyWhenAsked) {
  const TestFolder folder;
  const Product product = test_product(1, 2, 8);
  SinkOptions options{scene::FileFormat::csv};
  write_test_file(folder / "a", product, options);
  EXPECT_EQ(contents(folder / "a"), "0,255,127,126\n");
  options.header = true;
  write_test_file(folder / "b", product, options);
  EXPECT_EQ(contents(folder / "b"), "I0,Q0,I1,Q1\n0,255,127,126\n");
}

class DescribedFile : public testing::TestWithParam<scene::FileFormat> {};

INSTANTIATE_TEST_SUITE_P(Sinks, DescribedFile,
                         testing::Values(scene::FileFormat::hdf5, scene::FileFormat::zarr, scene::FileFormat::sigmf),
                         [](const auto& test) { return std::string(name_of(test.param)); });

TEST_P(DescribedFile, CarriesEverythingThatIsKnown) {
  const TestFolder folder;
  Product product = test_product(20000, 2, 12);
  product.processing = scene::Processing::matched_filter;
  product.options.profile = scene::Profile::classic;
  product.script = std::string(100000, 'x') + "\xC3\xA9";
  const fs::path path = folder / ("a" + std::string(extension_of(GetParam())));
  write_test_file(path, product, {GetParam()});
  const auto opened = open_raster(Integrity::whole, path);
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  const RasterInfo& info = opened.raster->info();
  EXPECT_EQ(info.bits, 12);
  EXPECT_EQ(info.lsb_v, 2.5e-9);
  EXPECT_EQ(info.sample_rate_hz, 100e6);
  const std::map<std::string, std::string> attributes(info.attributes.begin(), info.attributes.end());
  EXPECT_EQ(attributes.at("script"), product.script);
  EXPECT_EQ(attributes.at("seed"), "18446744073709551615");
  EXPECT_EQ(attributes.at("profile"), "classic");
  EXPECT_EQ(attributes.at("pulse"), "ideal");
  EXPECT_EQ(attributes.at("processing"), "matched_filter");
  EXPECT_EQ(attributes.at("engine"), "reference");
  EXPECT_EQ(attributes.at("radar"), "Radar1");
  EXPECT_EQ(attributes.at("format_version"), "1");
  EXPECT_EQ(attributes.at("tolerance"), "1E-06");
  EXPECT_EQ(attributes.at("cubic_ends"), "chords");
  EXPECT_FALSE(attributes.at("program_version").empty());
  const auto axes = opened.raster->axes();
  ASSERT_TRUE(axes);
  for (std::size_t row = 0; row < product.rows; ++row) {
    ASSERT_EQ(axes->row_time_s[row], product.row_time_s(row));
    ASSERT_EQ(axes->row_carrier_hz[row], product.row_carrier_hz(row));
    if (axes->row_pose.empty()) continue;  // SigMF has no place for it.
    ASSERT_EQ(axes->row_pose.at(row).position_m, product.row_pose(row).position_m);
    ASSERT_EQ(axes->row_pose.at(row).rotation_rad, product.row_pose(row).rotation_rad);
  }
  EXPECT_EQ(axes->column_range_m, (std::vector<double>{1000.0, 1001.5}));
}

TEST(Sinks, ManyMayEncodeAtOnce) {
  const Product product = test_product(64, 1000, 16);
  const auto sink = make_discarding_sink(product, {scene::FileFormat::ascii});
  const auto counts = test_counts(64000, 16);
  const Block block{0, 64, 1000, {}, counts};
  const auto expected = sink->encode(block);
  std::vector<std::vector<std::byte>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) threads.emplace_back([&] { result = sink->encode(block); });
  for (auto& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, expected);
}

}  // namespace sinks_test
}  // namespace sarsim::raster
