#include <gmock/gmock.h>

#include <array>

#include <fmt/format.h>

#include "raster/format/data_test_support.hpp"
#include "raster/format/zarr_metadata.hpp"
#include "raster/format/zarr_store.hpp"

namespace sarsim::raster {
namespace zarr_test {

using namespace data_test;
using testing::HasSubstr;

constexpr std::string_view plain_array =
    R"({"zarr_format": 2, "dtype": "<c8", "order": "C", "shape": [3, 4], "chunks": [3, 4],)"
    R"( "compressor": null, "fill_value": null, "filters": null})";

std::string replaced(std::string_view text, std::string_view what, std::string_view by) {
  std::string result(text);
  const std::size_t at = result.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return result.replace(at, what.size(), by);
}

std::string problem_in(std::string_view text) {
  const auto read = parse_zarr_array(text);
  const auto* const problem = std::get_if<core::Problem>(&read);
  return problem == nullptr ? "" : core::to_string(*problem);
}

// Of whole stores, as processing asks for them.
std::string problems_of(const fs::path& path, Integrity integrity = Integrity::whole) {
  const auto opened = open_raster(integrity, path);
  EXPECT_EQ(opened.raster == nullptr, core::has_errors(opened.problems));
  return text_of(opened.problems);
}

// A store of somebody else: one array of complex64, whose sample at row r and column c is r + ci.
fs::path foreign_store(const fs::path& group, std::size_t rows, std::size_t columns, std::size_t chunk_rows,
                       std::size_t chunk_columns, char separator = '.', const std::string& name = "image") {
  const fs::path array = group / name;
  fs::create_directories(array);
  put(group / ".zgroup", R"({"zarr_format": 2})");
  put(array / ".zarray",
      fmt::format(R"({{"zarr_format":2,"dtype":"<c8","order":"C","shape":[{},{}],"chunks":[{},{}],"compressor":null,)"
                  R"("fill_value":[7.5,0.0],"filters":[],"dimension_separator":"{}"}})",
                  rows, columns, chunk_rows, chunk_columns, separator));
  for (std::size_t down = 0; down * chunk_rows < rows; ++down)
    for (std::size_t across = 0; across * chunk_columns < columns; ++across) {
      std::vector<std::complex<float>> chunk(chunk_rows * chunk_columns);
      for (std::size_t i = 0; i < chunk.size(); ++i)
        chunk[i] = {static_cast<float>(down * chunk_rows + i / chunk_columns),
                    static_cast<float>(across * chunk_columns + i % chunk_columns)};
      const fs::path file = array / fmt::format("{}{}{}", down, separator, across);
      fs::create_directories(file.parent_path());
      put(file, {reinterpret_cast<const char*>(chunk.data()), chunk.size() * sizeof chunk[0]});
    }
  return group;
}

TEST(Zarr, ChunksAreAlikeAndOfWholeRows) {
  EXPECT_EQ(zarr_chunk_rows(1240, 4000), 1240U);              // 5 MB in one.
  EXPECT_EQ(zarr_chunk_rows(10000, 8000), 1000U);             // 80 MB in ten of at most 8 MiB.
  EXPECT_EQ(zarr_chunk_rows(3, std::uint64_t{1} << 30), 1U);  // A row at least.
  EXPECT_EQ(zarr_chunk_rows(0, 0), 1U);
}

// Rows of 1 MiB: two chunks of six rows, the second with a row of zeros at its end.
TEST(Zarr, LastChunkIsFilledUp) {
  const TestFolder folder;
  const Product product = test_product(11, std::size_t{1} << 17, 8);
  write_test_file(folder / "a.zarr", product, {scene::FileFormat::zarr});
  EXPECT_EQ(fs::file_size(folder / "a.zarr/samples/0.0"), 6U << 20U);
  EXPECT_EQ(fs::file_size(folder / "a.zarr/samples/1.0"), 6U << 20U);
  EXPECT_FALSE(fs::exists(folder / "a.zarr/samples/2.0"));
  EXPECT_EQ(contents(folder / "a.zarr/samples/1.0").substr(5U << 20U), std::string(1U << 20U, '\0'));
  const auto opened = open_raster(Integrity::whole, folder / "a.zarr");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_EQ(read_all_rows(*opened.raster), test_volts(product.rows * product.columns));
}

TEST(Zarr, AllMetadataStandsTogetherToo) {
  const TestFolder folder;
  write_test_file(folder / "a.zarr", test_product(4, 3, 8), {scene::FileFormat::zarr});
  const std::string all = contents(folder / "a.zarr/.zmetadata");
  for (const char* name :
       {".zgroup", ".zattrs", "samples/.zarray", "samples/.zattrs", "pulse_time_s/.zarray", "carrier_hz/.zattrs",
        "slant_range_m/.zarray", "platform_position_m/.zarray", "world_axis/.zarray"})
    EXPECT_THAT(all, HasSubstr(fmt::format("\"{}\": {{", name)));
  EXPECT_THAT(all, HasSubstr("\"lsb_v\": 2.5E-09"));
  EXPECT_THAT(contents(folder / "a.zarr/samples/.zattrs"), HasSubstr("\"coordinates\": \"carrier_hz\""));
}

TEST(Zarr, ReadsWindowsOfStoresWithAnyChunks) {
  for (const auto& [chunk_rows, chunk_columns, separator] :
       {std::tuple(3, 4, '.'), std::tuple(7, 10, '/'), std::tuple(20, 30, '.'), std::tuple(1, 1, '/')}) {
    const TestFolder folder;
    const fs::path store = foreign_store(folder / "b", 7, 10, static_cast<std::size_t>(chunk_rows),
                                         static_cast<std::size_t>(chunk_columns), separator);
    for (const fs::path& path : {store, store / "image", store / ".zgroup", fs::path(store.string() + "/")}) {
      const auto opened = open_raster(Integrity::whole, path);
      ASSERT_TRUE(opened.raster) << text_of(opened.problems);
      EXPECT_TRUE(opened.problems.empty()) << text_of(opened.problems);
      ASSERT_EQ(opened.raster->rows(), 7U);
      const auto samples = read_all_rows(*opened.raster);
      for (std::size_t i = 0; i < samples.size(); ++i)
        ASSERT_EQ(samples[i], std::complex<double>(static_cast<double>(i / 10), static_cast<double>(i % 10)));
      for (const ImageWindow& window :
           {ImageWindow{0, 7, 0, 10}, ImageWindow{1, 3, 2, 4, 2, 2}, ImageWindow{6, 1, 9, 1},
            ImageWindow{0, 4, 1, 3, 2, 4}, ImageWindow{5, 2, 0, 10}}) {
        std::vector<std::complex<float>> part(window.samples());
        opened.raster->read_window(window, part);
        for (std::size_t i = 0; i < part.size(); ++i)
          ASSERT_EQ(part[i], std::complex<float>(static_cast<float>(window.row(i / window.cols)),
                                                 static_cast<float>(window.column(i % window.cols))));
      }
    }
  }
}

TEST(Zarr, ForeignChunksThatAreNowhereAreTheFillValue) {
  const TestFolder folder;
  const fs::path store = foreign_store(folder / "b", 4, 4, 2, 2);
  fs::remove(store / "image/1.0");
  const auto opened = open_raster(Integrity::whole, store);
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_THAT(text_of(opened.problems), HasSubstr("read as the fill value"));
  const auto samples = read_all_rows(*opened.raster);
  EXPECT_EQ(samples[8], std::complex<double>(7.5, 0.0));
  EXPECT_EQ(samples[10], std::complex<double>(2.0, 2.0));
}

TEST(Zarr, OwnStoresLackNothing) {
  const TestFolder folder;
  const fs::path store = folder / "a.zarr";
  write_test_file(store, test_product(11, std::size_t{1} << 17, 8), {scene::FileFormat::zarr});
  fs::resize_file(store / "samples/0.0", 100);
  EXPECT_THAT(problems_of(store), HasSubstr("has not the size of its array"));
  fs::remove(store / "samples/0.0");
  EXPECT_THAT(problems_of(store), HasSubstr("chunks of the array are missing"));
  EXPECT_THAT(problems_of(store), HasSubstr("1 of 2"));
  EXPECT_THAT(problems_of(store, Integrity::partial), HasSubstr("warning"));
  fs::create_symlink("/dev/zero", store / "samples/0.0");
  EXPECT_THAT(problems_of(store), HasSubstr("not a regular file"));
  fs::remove(store / "samples/0.0");
  fs::remove(store / "samples/1.0");
  EXPECT_THAT(problems_of(store), HasSubstr("nearly all chunks"));
}

TEST(Zarr, SaysWhatOfAForeignArrayIsNotRead) {
  const auto found = [](std::string_view what, std::string_view by) {
    return problem_in(replaced(plain_array, what, by));
  };
  EXPECT_EQ(problem_in(plain_array), "");
  EXPECT_THAT(found("\"compressor\": null", R"("compressor": {"id": "blosc"})"),
              HasSubstr("compressed; found '\"blosc\"'"));
  EXPECT_THAT(found("\"filters\": null", R"("filters": [{"id": "delta"}])"), HasSubstr("filtered"));
  EXPECT_THAT(found("\"C\"", "\"F\""), HasSubstr("not in C order"));
  EXPECT_THAT(found("\"zarr_format\": 2", "\"zarr_format\": 3"), HasSubstr("another version"));
  EXPECT_THAT(found("\"<c8\"", R"([["r", "<f4"], ["i", "<f4"]])"), HasSubstr("structures"));
  EXPECT_THAT(found("[3, 4]", "[3, -4]"), HasSubstr("no possible shape"));
  EXPECT_THAT(found("[3, 4]", "[9223372036854775807, 4]"), HasSubstr("no possible shape"));
  EXPECT_THAT(found("[3, 4]", "\"../../etc\""), HasSubstr("no possible shape"));
  EXPECT_THAT(found("\"chunks\": [3, 4]", "\"chunks\": [3, 0]"), HasSubstr("no possible chunks"));
  EXPECT_THAT(found("\"chunks\": [3, 4]", "\"chunks\": [3]"), HasSubstr("no possible chunks"));
  EXPECT_THAT(found("\"filters\"", R"("dimension_separator": "/../", "filters")"),
              HasSubstr("named in an unknown way"));
  EXPECT_THAT(problem_in(std::string(200000, '[')), HasSubstr("not JSON"));
  EXPECT_THAT(problem_in("{\"a\": \"alpha bravo\" charlie"),
              testing::AllOf(HasSubstr("something else at byte"), testing::Not(HasSubstr("alpha"))));
  EXPECT_THAT(problem_in(R"({"zarr_format": )" + std::string(100000, '[') + std::string(100000, ']') + "}"),
              HasSubstr("another version"));
  EXPECT_THAT(problem_in("[1]"), HasSubstr("not a JSON object"));
  EXPECT_THAT(problem_in("{\"a\": \"\xff\"}"), HasSubstr("not JSON"));
}

TEST(Zarr, StoresThatClaimMoreThanTheyHoldAreRefused) {
  const TestFolder folder;
  fs::create_directories(folder / "b/samples");
  put(folder / "b/.zgroup", R"({"zarr_format": 2})");
  put(folder / "b/samples/0.0", std::string(96, 'x'));
  const auto with_shape = [&](std::string_view shape, std::string_view chunks) {
    put(folder / "b/samples/.zarray",
        replaced(replaced(plain_array, "\"shape\": [3, 4]", fmt::format("\"shape\": {}", shape)), "\"chunks\": [3, 4]",
                 fmt::format("\"chunks\": {}", chunks)));
    return problems_of(folder / "b");
  };
  EXPECT_EQ(with_shape("[3, 4]", "[3, 4]"), "");
  EXPECT_THAT(with_shape("[1000000000, 1000000000]", "[3, 4]"), HasSubstr("more chunks than are read"));
  EXPECT_THAT(with_shape("[1000000000, 1000000000]", "[1000000000, 1000000000]"), HasSubstr("not the size"));
  EXPECT_THAT(with_shape("[4000, 4000]", "[3, 4]"), HasSubstr("nearly all chunks"));
  EXPECT_THAT(with_shape("[3]", "[3]"), HasSubstr("nearly all chunks"));
  EXPECT_THAT(with_shape("[3, 4, 5]", "[3, 4, 5]"), HasSubstr("not one of samples"));
  EXPECT_THAT(with_shape("[0, 4]", "[3, 4]"), HasSubstr("not one of samples"));
}

TEST(Zarr, OneOfSeveralArraysHasToBeNamed) {
  const TestFolder folder;
  foreign_store(folder / "b", 4, 4, 2, 2);
  foreign_store(folder / "b", 5, 4, 5, 4, '.', "other");
  EXPECT_THAT(problems_of(folder / "b"), HasSubstr("image, other"));
  EXPECT_EQ(problems_of(folder / "b/other"), "");
  foreign_store(folder / "b", 6, 4, 6, 4, '.', "samples");
  const auto opened = open_raster(Integrity::whole, folder / "b");
  ASSERT_TRUE(opened.raster);
  EXPECT_EQ(opened.raster->rows(), 6U);
  put(folder / "b/zarr.json", "{}");
  EXPECT_THAT(problems_of(folder / "b"), HasSubstr("version 3"));
  fs::create_directory(folder / "empty");
  EXPECT_THAT(problems_of(folder / "empty"), HasSubstr("folder"));
  put(folder / "file.zarr", "text");
  EXPECT_THAT(problems_of(folder / "file.zarr"), HasSubstr("a Zarr store is a folder"));
}

TEST(Zarr, OnlyOwnStoresAreReplaced) {
  const TestFolder folder;
  const fs::path store = folder / "a.zarr";
  const Product product = test_product(4, 3, 8);
  const SinkOptions force{.format = scene::FileFormat::zarr, .replace = true};
  write_test_file(store, product, {scene::FileFormat::zarr});
  EXPECT_TRUE(is_own_zarr_store(store));
  EXPECT_THROW(write_test_file(store, product, {scene::FileFormat::zarr}), std::system_error);
  write_test_file(store, test_product(5, 3, 8), force);
  EXPECT_EQ(folder.entries(), 1U);
  // With anything else in it, it belongs to somebody.
  for (const char* name : {"notes.txt", "samples/notes.txt", "samples/0..0", "samples/..0"}) {
    put(store / name, "mine");
    EXPECT_FALSE(is_own_zarr_store(store)) << name;
    EXPECT_THROW(write_test_file(store, product, force), std::system_error) << name;
    EXPECT_EQ(contents(store / name), "mine");
    fs::remove(store / name);
  }
  fs::create_directory_symlink("samples", store / "more");
  EXPECT_FALSE(is_own_zarr_store(store));
  fs::remove(store / "more");
  EXPECT_TRUE(is_own_zarr_store(store));
  foreign_store(folder / "b", 4, 4, 2, 2);
  EXPECT_FALSE(is_own_zarr_store(folder / "b"));
  EXPECT_EQ(folder.entries(), 2U);
}

}  // namespace zarr_test
}  // namespace sarsim::raster
