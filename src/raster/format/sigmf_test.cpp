#include <gmock/gmock.h>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "raster/format/data_test_support.hpp"
#include "raster/format/sigmf.hpp"

namespace sarsim::raster {
namespace sigmf_test {

using namespace data_test;
using testing::HasSubstr;

constexpr std::string_view foreign_meta =
    R"({"global": {"core:datatype": "ci16_le", "core:version": "1.0.0", "core:sample_rate": 1000000},)"
    R"( "captures": [{"core:sample_start": 0}, {"core:sample_start": 3}, {"core:sample_start": 6}], "annotations": []})";

std::string meta_without(std::string_view what, std::string_view by) {
  std::string text(foreign_meta);
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string problems_of(const TestFolder& folder, std::string_view meta, std::size_t bytes, std::size_t columns = 0) {
  put(folder / "b.sigmf-meta", meta);
  put(folder / "b.sigmf-data", std::string(bytes, '\1'));
  RasterHints hints;
  hints.columns = columns;
  const auto opened = open_raster(Integrity::whole, folder / "b.sigmf-meta", hints);
  EXPECT_EQ(opened.raster == nullptr, core::has_errors(opened.problems));
  return text_of(opened.problems);
}

TEST(Sigmf, SaysPulseTimesCarriersAndUtc) {
  const TestFolder folder;
  Product product = test_product(3, 2, 8);
  product.script =
      "format = \"sarsim 2\"\n[world]\nframe = \"earth\"\nanchor = { latitude = \"52 deg\", longitude = "
      "\"13 deg\" }\nepoch = \"2024-04-01T22:59:42Z\"\n";
  write_test_file(folder / "a.sigmf-data", product, {scene::FileFormat::sigmf});
  const std::string meta = contents(folder / "a.sigmf-meta");
  EXPECT_THAT(meta, HasSubstr("\"core:datatype\": \"cf32_le\""));
  EXPECT_THAT(meta, HasSubstr("\"core:sample_start\": 4,\n      \"core:frequency\": 1002000000,\n"
                              "      \"core:datetime\": \"2024-04-01T22:59:42.502Z\",\n"
                              "      \"sarsim:pulse_time_s\": 0.502\n"));
  EXPECT_THAT(meta, HasSubstr("\"optional\": true"));
  EXPECT_EQ(fs::file_size(folder / "a.sigmf-data"), 48U);
  // Either name opens it.
  for (const char* name : {"a.sigmf-meta", "a.sigmf-data"}) {
    const auto opened = open_raster(Integrity::whole, folder / name);
    ASSERT_TRUE(opened.raster) << text_of(opened.problems);
    EXPECT_EQ(read_all_rows(*opened.raster), test_volts(6));
  }
}

TEST(Sigmf, ReadsCapturesOfEqualLengthAsRows) {
  const TestFolder folder;
  EXPECT_EQ(problems_of(folder, foreign_meta, 36), "");
  const auto opened = open_raster(Integrity::whole, folder / "b.sigmf-meta");
  EXPECT_EQ(opened.raster->rows(), 3U);
  EXPECT_EQ(opened.raster->columns(), 3U);
  EXPECT_TRUE(opened.raster->info().counts);
  EXPECT_EQ(opened.raster->info().sample_rate_hz, 1e6);
  EXPECT_EQ(read_all_rows(*opened.raster).front(), std::complex<double>(257.0, 257.0));
  EXPECT_FALSE(opened.raster->axes());
}

// The sum of all samples is that of the metadata, or not: nobody knows before all are read.
TEST(Sigmf, IsLeftWhereAStopIsRequested) {
  const TestFolder folder;
  const std::string meta = meta_without(
      "\"core:datatype\"", fmt::format("\"core:sha512\": \"{}\", \"core:datatype\"", std::string(128, '0')));
  EXPECT_THAT(problems_of(folder, meta, 36), HasSubstr("core:sha512"));
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)open_raster(Integrity::whole, folder / "b.sigmf-meta", {}, &stop), core::Interrupted);
}

TEST(Sigmf, SaysWhatIsNotRead) {
  const TestFolder folder;
  EXPECT_THAT(problems_of(folder, foreign_meta, 35), HasSubstr("no whole number of rows"));
  EXPECT_THAT(problems_of(folder, meta_without("ci16_le", "ru8"), 36), HasSubstr("of this type are not read"));
  EXPECT_THAT(problems_of(folder, meta_without("3}", "4}"), 36), HasSubstr("give --columns"));
  EXPECT_EQ(problems_of(folder, meta_without("3}", "4}"), 36, 9), "");
  EXPECT_THAT(problems_of(folder, "{\"global\": [", 36), HasSubstr("not JSON"));
  // The library's words would quote what it read last.
  EXPECT_THAT(problems_of(folder, "{\"global\": \"alpha bravo\" charlie", 36),
              testing::AllOf(HasSubstr("not JSON; found 'something else at byte"), testing::Not(HasSubstr("alpha"))));
  EXPECT_THAT(problems_of(folder, "{\"global\": []}", 36), HasSubstr("no object 'global'"));
  EXPECT_THAT(
      problems_of(folder,
                  meta_without("\"core:sample_rate\": 1000000", "\"sarsim:samples_per_pulse\": 18446744073709551615"),
                  36),
      HasSubstr("no whole number of rows"));
  fs::remove(folder / "b.sigmf-data");
  EXPECT_THAT(text_of(open_raster(Integrity::whole, folder / "b.sigmf-meta").problems), HasSubstr("b.sigmf-data"));
}

TEST(Sigmf, NamesAndBitsThatAreNoneOfItAreRefused) {
  const TestFolder folder;
  EXPECT_THROW(static_cast<void>(make_sink(folder / "a.dat", test_product(1, 1, 8), {scene::FileFormat::sigmf})),
               core::InvalidRequest);
  SinkOptions counts{scene::FileFormat::sigmf};
  counts.counts = true;
  EXPECT_THROW(static_cast<void>(make_sink(folder / "a.sigmf-meta", test_product(1, 1, 32), counts)),
               core::InvalidRequest);
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace sigmf_test
}  // namespace sarsim::raster
