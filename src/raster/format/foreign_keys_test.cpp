// What keys of other programs' files change is followed or refused by name (docs/formats/samples.md).

#include <gmock/gmock.h>

#include <random>

#include <fmt/format.h>

#include "core/hash/sha512.hpp"
#include "raster/format/data_test_support.hpp"
#include "raster/format/envi.hpp"

namespace sarsim::raster::foreign_keys_test {

using namespace data_test;
using testing::HasSubstr;

// A key with a value that changes what bytes mean, and what the message says.
struct KeyCase {
  std::string key;  // As it stands in the file, with its value.
  std::string message;
};

// Two rows of three samples: 24 bytes of cf32_le would be 3; here ci16_le, 4 bytes each.
std::string sigmf_text(const std::string& global, const std::string& captures) {
  return fmt::format(R"({{"global": {{"core:datatype": "ci16_le", "core:version": "1.2.0"{}}}, "captures": [{}]}})",
                     global, captures);
}

std::string sigmf_bytes(std::size_t samples) {
  std::string bytes;
  for (std::size_t i = 0; i < 2 * samples; ++i) bytes += {static_cast<char>(i), '\0'};
  return bytes;
}

OpenedRaster open_sigmf_with(const TestFolder& folder, const std::string& text, const std::string& bytes,
                             std::size_t columns = 0) {
  put(folder / "a.sigmf-meta", text);
  put(folder / "a.sigmf-data", bytes);
  RasterHints hints;
  hints.columns = columns;
  return open_raster(Integrity::whole, folder / "a.sigmf-meta", hints);
}

constexpr const char* two_captures = R"({"core:sample_start": 0}, {"core:sample_start": 3})";

std::vector<std::complex<double>> first_counts(std::size_t samples) {
  std::vector<std::complex<double>> counts(samples);
  for (std::size_t i = 0; i < samples; ++i)
    counts[i] = {2.0 * static_cast<double>(i), 2.0 * static_cast<double>(i) + 1.0};
  return counts;
}

TEST(SigmfKeys, ThoseThatSayWhereSamplesLieAreFollowed) {
  const TestFolder folder;
  const std::string bytes = sigmf_bytes(6);
  core::Sha512 sum;
  sum.add(std::as_bytes(std::span(bytes)));
  const std::tuple<std::string, std::string, std::string> cases[] = {
      {"", two_captures, bytes},
      {"", R"({"core:sample_start": 0, "core:header_bytes": 512}, {"core:sample_start": 3})",
       std::string(512, 'h') + bytes},
      {R"(, "core:trailing_bytes": 7)", two_captures, bytes + "trailer"},
      {R"(, "core:offset": 100)", R"({"core:sample_start": 100}, {"core:sample_start": 103})", bytes},
      {fmt::format(R"(, "core:sha512": "{}")", sum.digest()), two_captures, bytes},
      {R"(, "core:num_channels": 1, "core:dataset": "a.sigmf-data", "core:metadata_only": false)", two_captures, bytes},
      {R"(, "core:extensions": [{"name": "antenna", "version": "1.0.0", "optional": true}])", two_captures, bytes}};
  for (const auto& [global, captures, content] : cases) {
    const auto opened = open_sigmf_with(folder, sigmf_text(global, captures), content);
    ASSERT_TRUE(opened.raster) << global << text_of(opened.problems);
    EXPECT_EQ(opened.raster->rows(), 2U) << global;
    EXPECT_EQ(read_all_rows(*opened.raster), first_counts(6)) << global << captures;
  }
}

TEST(SigmfKeys, OthersThatChangeSamplesAreRefusedByName) {
  const TestFolder folder;
  const KeyCase globals[] = {
      {R"(, "core:num_channels": 2)", "core:num_channels"},
      {R"(, "core:metadata_only": true)", "core:metadata_only"},
      {R"(, "core:dataset": "other.bin")", "core:dataset"},
      {R"(, "core:extensions": [{"name": "spatial", "version": "1.0.0", "optional": false}])", "core:extensions"},
      {fmt::format(R"(, "core:sha512": "{}")", std::string(128, 'a')), "core:sha512"},
      {R"(, "core:extensions": [{"name": "spatial", "version": "1.0.0"}])", "core:extensions"},
      {R"(, "core:extensions": [{"name": "spatial", "optional": "true"}])", "core:extensions"},
      {R"(, "core:extensions": [{"name": "spatial", "optional": null}])", "core:extensions"},
      {R"(, "core:extensions": ["spatial"])", "core:extensions"},
      {R"(, "core:extensions": "spatial")", "core:extensions"},
      {R"(, "core:sample_rate": 1e300)", "the sampling rate of the file cannot be"},
      {R"(, "sarsim:lsb_v": true)", "lsb_v of the file cannot be read"},
      {R"(, "other:x": {"a": 1, "a": 2})", "a is there twice"},
      {R"(, "core:sha512": "abc")", "core:sha512"},
      {R"(, "core:trailing_bytes": -1)", "core:trailing_bytes"},
      {R"(, "core:trailing_bytes": 5)", "core:trailing_bytes"},
      {R"(, "core:sample_rate": "1e6")", "core:sample_rate"},
      {R"(, "core:sample_rate": 0)", "core:sample_rate"},
      {R"(, "core:version": "3.0.0")", "core:version"},
      {R"(, "core:datatype": "cf32_le")", "core:datatype is there twice"},
      {R"(, "sarsim:samples_per_pulse": 2)", "captures are not as many as the rows"},
      {R"(, "sarsim:slant_range_m": [1, 2])", "sarsim:slant_range_m"},
      {R"(, "sarsim:slant_range_m": "near")", "sarsim:slant_range_m"},
      {R"(, "core:offset": 9)", "core:sample_start"},
      {R"(, "sarsim:lsb_v": 1e300)", "lsb_v"},
      {R"(, "sarsim:bits": 99)", "bits"}};
  for (const KeyCase& c : globals) {
    const auto opened = open_sigmf_with(folder, sigmf_text(c.key, two_captures), sigmf_bytes(6));
    EXPECT_FALSE(opened.raster) << c.key;
    EXPECT_THAT(text_of(opened.problems), HasSubstr(c.message)) << c.key;
  }
  const KeyCase captures[] = {
      {R"({"core:sample_start": 0}, {"core:sample_start": 3, "core:header_bytes": 8})", "core:header_bytes"},
      {R"({"core:sample_start": 0}, {"core:sample_start": "3"})", "core:sample_start"},
      {R"({"core:sample_start": 0}, {"core:sample_start": 3}, {"core:sample_start": 1})", "core:sample_start"},
      {R"({"core:sample_start": 0}, {"core:sample_start": 3}, {"core:sample_start": 6})", "core:sample_start"},
      {R"({"core:sample_start": 0}, {"core:sample_start": 2})", "captures"},
      {R"({"core:sample_start": 0, "core:frequency": "L band"}, {"core:sample_start": 3})", "core:frequency"},
      {R"(7)", "captures"}};
  for (const KeyCase& c : captures) {
    const auto opened = open_sigmf_with(folder, sigmf_text("", c.key), sigmf_bytes(6));
    EXPECT_FALSE(opened.raster) << c.key;
    EXPECT_THAT(text_of(opened.problems), HasSubstr(c.message)) << c.key;
  }
  const std::string gap = R"({"core:sample_start": 0, "core:global_index": 0}, )"
                          R"({"core:sample_start": 2, "core:global_index": 99}, )"
                          R"({"core:sample_start": 5, "core:global_index": 102})";
  EXPECT_THAT(text_of(open_sigmf_with(folder, sigmf_text("", gap), sigmf_bytes(6), 6).problems),
              HasSubstr("core:global_index"));
}

// Pictures are drawn of files that are opened without reading them through.
TEST(SigmfKeys, WhoeverWaitsForAllOfTheSamplesHasThemCompared) {
  const TestFolder folder;
  const std::string wrong = fmt::format(R"(, "core:sha512": "{}")", std::string(128, 'a'));
  static_cast<void>(open_sigmf_with(folder, sigmf_text(wrong, two_captures), sigmf_bytes(6)));
  const auto opened = open_raster(Integrity::partial, folder / "a.sigmf-meta");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_TRUE(opened.raster->problems().empty());
  opened.raster->wait_until_indexed(nullptr);
  EXPECT_THAT(text_of(opened.raster->problems()), HasSubstr("core:sha512"));
}

TEST(SigmfKeys, RatesThatContradictEachOtherAreWarnedOf) {
  const TestFolder folder;
  const auto twice = open_sigmf_with(
      folder, sigmf_text(R"(, "core:sample_rate": 2e6, "sarsim:sample_rate_hz": 1e6)", two_captures), sigmf_bytes(6));
  ASSERT_TRUE(twice.raster);
  EXPECT_THAT(text_of(twice.problems), HasSubstr("warning: core:sample_rate contradicts sarsim:sample_rate_hz"));
  EXPECT_EQ(twice.raster->info().sample_rate_hz, 1e6);
  const auto opened = open_sigmf_with(
      folder, sigmf_text(R"(, "core:sample_rate": 1e6, "sarsim:sample_rate_hz": 1000000)", two_captures),
      sigmf_bytes(6));
  EXPECT_EQ(text_of(opened.problems), "");
  ASSERT_TRUE(opened.raster);
  EXPECT_EQ(opened.raster->info().sample_rate_hz, 1e6);
}

// A changed letter of the metadata is refused, or what is read are samples of the file in their order.
TEST(SigmfKeys, ChangedLettersGiveRefusalsOrTheSamples) {
  const TestFolder folder;
  const std::string text = sigmf_text(R"(, "core:trailing_bytes": 4, "core:sample_rate": 1e6, "core:num_channels": 1)",
                                      R"({"core:sample_start": 0, "core:header_bytes": 4}, {"core:sample_start": 3})");
  const std::string bytes = "head" + sigmf_bytes(6) + "tail";
  std::mt19937_64 random(7);
  std::size_t refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::string other = text;
    other[random() % other.size()] = static_cast<char>(' ' + random() % 95);
    const auto opened = open_sigmf_with(folder, other, bytes);
    EXPECT_EQ(opened.raster == nullptr, core::has_errors(opened.problems));
    refused += opened.raster == nullptr ? 1U : 0U;
    if (!opened.raster) continue;
    const auto read = read_all_rows(*opened.raster);
    ASSERT_LE(read.size(), 8U) << other;
  }
  EXPECT_GT(refused, 100U);
}

std::string envi_text(const std::string& more) {
  return "ENVI\nsamples = 3\nlines = 2\nbands = 1\nheader offset = 0\nfile type = ENVI Standard\ndata type = 6\n"
         "interleave = bsq\nbyte order = 0\n" +
         more;
}

std::string envi_problems(const std::string& text) { return text_of(read_envi_header(text, "a.hdr").problems); }

TEST(EnviKeys, ThoseThatDoNothingPass) {
  for (const char* const more :
       {"", "minor frame offsets = {0, 0}\n", "data gain values = {1.0}\n", "reflectance scale factor = 1\n",
        "data offset values = { 0 }\n", "data ignore value = 0\n", "data ignore value = NaN\n",
        "file compression = 0\n", "x start = 12\n", "wavelength units = nm\n",
        "map info = {UTM, 1, 1, 0, 0, 30, 30, 33, North}\n", "description = {a = 1\n  b = 2, {c\n}\n", "lines = 2\n",
        "x start = 1\nrange first m = 4\n"})
    EXPECT_EQ(envi_problems(envi_text(more)), "") << more;
}

TEST(EnviKeys, OthersAreRefusedByName) {
  const KeyCase cases[] = {{"minor frame offsets = {128, 4}\n", "'minor frame offsets'"},
                           {"major frame offsets = {16, 0}\n", "'major frame offsets'"},
                           {"reflectance scale factor = 10000\n", "'reflectance scale factor'"},
                           {"data gain values = {0.5}\n", "'data gain values'"},
                           {"data offset values = {3}\n", "'data offset values'"},
                           {"data reflectance gain values = {2}\n", "'data reflectance gain values'"},
                           {"data ignore value = -9999\n", "'data ignore value'"},
                           {"file compression = 1\n", "'file compression'"},
                           {"minor frame offsets = some\n", "'minor frame offsets'"},
                           {"lines = 4\n", "'lines' twice"},
                           {"data type = 4\n", "'data type' twice"},
                           {"band names = {one\n", "the brace of 'band names' is not closed"},
                           {"band names = {one\nlines = 3\nother = {4}\n", "the brace of 'band names' is not closed"},
                           {"x start = 100\nrange first m = 4\n", "'x start' contradicts"},
                           {"y start = 7\nazimuth first m = 4\n", "'y start' contradicts"}};
  for (const KeyCase& c : cases) {
    const std::string problems = envi_problems(envi_text(c.key));
    EXPECT_THAT(problems, HasSubstr("error")) << c.key;
    EXPECT_THAT(problems, HasSubstr(c.message)) << c.key;
  }
  const std::pair<const char*, const char*> others[] = {{"file type = ENVI Standard", "file type = ENVI Meta File"},
                                                        {"interleave = bsq", "interleave = tiled"},
                                                        {"byte order = 0", "byte order = 1"}};
  for (const auto& [old, by] : others) {
    std::string text = envi_text("");
    text.replace(text.find(old), std::string_view(old).size(), by);
    EXPECT_THAT(envi_problems(text), HasSubstr("is not supported")) << by;
  }
}

TEST(EnviKeys, AFileThatIsLongerThanItsHeaderSaysIsWarnedOf) {
  const TestFolder folder;
  put(folder / "a.hdr", envi_text(""));
  put(folder / "a.img", std::string(56, '\0'));
  const auto opened = open_raster(Integrity::whole, folder / "a.img");
  ASSERT_TRUE(opened.raster);
  EXPECT_THAT(text_of(opened.problems), HasSubstr("warning: the file is longer than its header says"));
}

void replace_in(const fs::path& file, const std::string& old, const std::string& by) {
  std::string text = contents(file);
  const std::size_t at = text.find(old);
  ASSERT_NE(at, std::string::npos) << old << text;
  put(file, text.replace(at, old.size(), by));
}

std::string zarr_problem(const fs::path& store) {
  const auto opened = open_raster(Integrity::whole, store);
  return opened.raster ? "" : text_of(opened.problems);
}

class ZarrKeys : public testing::Test {
 protected:
  void SetUp() override {
    write_test_file(store_, test_product(4, 3, 8), {scene::FileFormat::zarr});
    fs::remove(store_ / ".zmetadata");
  }
  TestFolder folder_;
  fs::path store_ = folder_ / "a.zarr";
};

TEST_F(ZarrKeys, AttributesOfSamplesAndAxesAreFollowed) {
  replace_in(store_ / "samples/.zattrs", "{", R"({"scale_factor": 2, )");
  replace_in(store_ / "pulse_time_s/.zattrs", R"("units": "s")", R"("units": "ms")");
  replace_in(store_ / "slant_range_m/.zattrs", R"("units": "m")", R"("units": "km")");
  const auto opened = open_raster(Integrity::whole, store_);
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  const auto read = read_all_rows(*opened.raster);
  const auto stored = test_volts(12);
  for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i], 2.0 * stored[i]);
  std::vector<std::complex<float>> window(3);
  opened.raster->read_window({1, 1, 0, 3}, window);
  EXPECT_EQ(std::complex<double>(window[1]), 2.0 * stored[4]);
  const auto axes = opened.raster->axes();
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->row_time_s[1], 0.501 * 1e-3);
  EXPECT_EQ(axes->column_range_m[1], 1001.5 * 1e3);
}

TEST_F(ZarrKeys, WhatCannotBeFollowedIsRefusedByName) {
  const std::tuple<const char*, const char*, const char*, const char*> cases[] = {
      {"samples/.zattrs", "{", R"({"add_offset": 1.5, )", "add_offset"},
      {"samples/.zattrs", R"("units": "V")", R"("units": "dB")", "units"},
      {"samples/.zattrs", R"("pulse_time_s")", R"("slant_range_m")", "dimensions are in the wrong order"},
      {"carrier_hz/.zattrs", R"("units": "Hz")", R"("units": "m")", "units"},
      {".zattrs", "2.5E-09", "1e300", "lsb_v"},
      {".zattrs", "\"bits\": 8", "\"bits\": -8", "bits"},
      {"samples/.zattrs", "{", R"({"scale_factor": {"re": 0.5}, )", "scale_factor"},
      {"samples/.zattrs", "{", R"({"scale_factor": true, )", "scale_factor"},
      {"samples/.zattrs", "{", R"({"scale_factor": 1, "scale_factor": 2, )", "scale_factor is there twice"},
      {"samples/.zattrs", "{", R"({"_FillValue": null, )", "_FillValue"},
      {"samples/.zattrs", R"("units": "V")", R"("units": ["mV"])", "units"},
      {"samples/.zattrs", R"("pulse_time_s")", R"("pulse_time_s", "iq")", "_ARRAY_DIMENSIONS"},
      {"samples/.zarray", R"("order")", R"("shape": [3, 4], "order")", "shape is there twice"},
      {"slant_range_m/.zattrs", "{", R"({"scale_factor": {"re": 2}, )", "scale_factor"},
      {"slant_range_m/.zattrs", "{", R"({"_FillValue": 1001.5, )", "stands for none; found '1001.5 at position 1'"},
      {"slant_range_m/.zarray", "<f8", ">f8", "big-endian"},
      {"platform_position_m/.zarray", "<f8", "<U2", "type"},
      {".zattrs", "{", R"({"bits": 8, )", "bits is there twice"},
      {".zattrs", "2.5E-09", "[1, 2]", "lsb_v of the file cannot be read"},
      {"pulse_time_s/.zarray", R"("shape": [)", R"("shape": [1, )", "pulse_time_s"}};
  for (const auto& [file, old, by, key] : cases) {
    const std::string before = contents(store_ / file);
    std::string text = before;
    if (const std::size_t at = text.find(old); at != std::string::npos)
      text.replace(at, std::string_view(old).size(), by);
    ASSERT_NE(text, before) << file << before;
    put(store_ / file, text);
    EXPECT_THAT(zarr_problem(store_), HasSubstr(key)) << file;
    put(store_ / file, before);
  }
  EXPECT_EQ(zarr_problem(store_), "");
}

TEST_F(ZarrKeys, LinksAreNotFollowed) {
  for (const char* const part : {"samples", "samples/.zarray", "pulse_time_s", "samples/0.0"}) {
    const fs::path elsewhere = folder_ / "elsewhere";
    fs::rename(store_ / part, elsewhere);
    fs::create_symlink(elsewhere, store_ / part);
    EXPECT_THAT(zarr_problem(store_), HasSubstr("link")) << part;
    fs::remove(store_ / part);
    fs::rename(elsewhere, store_ / part);
  }
  EXPECT_EQ(zarr_problem(store_), "");
}

TEST_F(ZarrKeys, AxesAreThereAsAWhole) {
  fs::remove(store_ / "slant_range_m/0");
  EXPECT_THAT(zarr_problem(store_), HasSubstr("slant_range_m"));
}

// The value is that of each number, of which a sample has two.
TEST(ZarrFill, AMissingChunkOfPairsHasItInIAndInQ) {
  const TestFolder folder;
  const fs::path array = folder / "a.zarr";
  fs::create_directory(array);
  put(array / ".zarray", R"({"zarr_format": 2, "shape": [2, 2, 2], "chunks": [1, 2, 2], "dtype": "<i2",
                             "compressor": null, "fill_value": 3, "order": "C", "filters": null})");
  put(array / ".zattrs", R"({"scale_factor": 1.5})");
  put(array / "0.0.0", std::string("\1\0\2\0\4\0\5\0", 8));
  const auto opened = open_raster(Integrity::whole, array);
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_THAT(text_of(opened.problems), HasSubstr("warning: chunks of the array are missing"));
  EXPECT_EQ(read_all_rows(*opened.raster),
            (std::vector<std::complex<double>>{{1.5, 3.0}, {6.0, 7.5}, {4.5, 4.5}, {4.5, 4.5}}));
}

TEST(ZarrMetadata, ConsolidatedMetadataHaveToAgree) {
  const TestFolder folder;
  write_test_file(folder / "a.zarr", test_product(4, 3, 8), {scene::FileFormat::zarr});
  EXPECT_EQ(zarr_problem(folder / "a.zarr"), "");
  const std::string all = contents(folder / "a.zarr/.zmetadata");
  for (const char* const name : {"samples/.zattrs", "slant_range_m/.zattrs", "slant_range_m/.zarray", ".zattrs"}) {
    const std::string own = contents(folder / "a.zarr" / name);
    replace_in(folder / "a.zarr" / name, "{", R"({"scale_factor": 2, )");
    EXPECT_THAT(zarr_problem(folder / "a.zarr"), HasSubstr(".zmetadata")) << name;
    fs::remove(folder / "a.zarr" / name);
    EXPECT_THAT(zarr_problem(folder / "a.zarr"), HasSubstr(".zmetadata")) << name;
    put(folder / "a.zarr" / name, own);
  }
  // The array alone is a part of the store as well.
  replace_in(folder / "a.zarr/samples/.zattrs", "{", R"({"scale_factor": 2, )");
  EXPECT_THAT(zarr_problem(folder / "a.zarr/samples"), HasSubstr(".zmetadata"));
  replace_in(folder / "a.zarr/samples/.zattrs", R"("scale_factor": 2, )", "");
  EXPECT_EQ(zarr_problem(folder / "a.zarr/samples"), "");
  for (const char* const text : {"[]", "{", "{}", R"({"metadata": 3})", R"({"metadata": {}})"}) {
    put(folder / "a.zarr/.zmetadata", text);
    EXPECT_THAT(zarr_problem(folder / "a.zarr"), HasSubstr(".zmetadata")) << text;
  }
  put(folder / "a.zarr/.zmetadata", all);
  EXPECT_EQ(zarr_problem(folder / "a.zarr"), "");
  // An array that was put beside the samples later.
  for (const char* const text : {".zarray", ".zattrs"})
    replace_in(folder / "a.zarr/.zmetadata", std::string("slant_range_m/") + text, std::string("other/") + text);
  EXPECT_EQ(zarr_problem(folder / "a.zarr"), "");
}

// One rule for what files of all formats say of themselves.
TEST(RasterGate, RefusesFactsThatCannotBe) {
  const TestFolder folder;
  for (const scene::FileFormat format : {scene::FileFormat::zarr, scene::FileFormat::sigmf}) {
    const bool zarr = format == scene::FileFormat::zarr;
    const fs::path file = folder / (zarr ? "a.zarr" : "a.sigmf-meta");
    write_test_file(file, test_product(4, 3, 8), {format});
    if (zarr) fs::remove(file / ".zmetadata");
    const fs::path text_file = zarr ? file / ".zattrs" : file;
    const std::string prefix = zarr ? "\"" : "\"sarsim:";
    const std::string text = contents(text_file);
    const std::tuple<std::string, std::string> facts[] = {
        {"lsb_v", "1e300"},          {"lsb_v", "-1"}, {"lsb_v", "\"much\""}, {"sample_rate_hz", "-5"},
        {"sample_rate_hz", "1e200"}, {"bits", "7.5"}, {"bits", "65"}};
    for (const auto& [name, value] : facts) {
      const std::size_t key = text.find(prefix + name + "\"");
      ASSERT_NE(key, std::string::npos) << text;
      const std::size_t begin = text.find(':', key + prefix.size() + name.size()) + 1;
      std::string other = text;
      other.replace(begin, text.find_first_of(",\n}", begin) - begin, " " + value);
      put(text_file, other);
      EXPECT_THAT(text_of(open_raster(Integrity::whole, file).problems), HasSubstr("error: " + name)) << name << value;
      const auto partial = open_raster(Integrity::partial, file);
      EXPECT_TRUE(partial.raster) << name << value;
      EXPECT_THAT(text_of(partial.problems), HasSubstr("warning: " + name)) << name << value;
    }
  }
}

}  // namespace sarsim::raster::foreign_keys_test
