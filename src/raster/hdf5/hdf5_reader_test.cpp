#include "raster/hdf5/hdf5_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <atomic>
#include <functional>
#include <numeric>
#include <string>
#include <thread>

#include "raster/format/data_test_support.hpp"
#include "raster/hdf5/hdf5_library.hpp"

namespace sarsim::raster {
namespace hdf5_reader_test {

using namespace data_test;
using testing::HasSubstr;

struct Layout {
  std::vector<hsize_t> shape{2, 3};
  std::function<void(hid_t)> storage = [](hid_t) {};
};

Hdf5Handle complex_float() {
  Hdf5Handle type(H5Tcreate(H5T_COMPOUND, 8), H5Tclose);
  H5Tinsert(type.get(), "r", 0, H5T_IEEE_F32LE);
  H5Tinsert(type.get(), "i", 4, H5T_IEEE_F32LE);
  return type;
}

Hdf5Handle create_file(const fs::path& path) {
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose};
}

void add_dataset(hid_t file, const char* name, hid_t type, const Layout& layout, const void* data = nullptr) {
  const auto& shape = layout.shape;
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  layout.storage(properties.get());
  const Hdf5Handle dataset(H5Dcreate2(file, name, type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                           H5Dclose);
  ASSERT_TRUE(dataset);
  if (data != nullptr) {
    ASSERT_GE(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), 0);
  }
}

std::string error_of(const fs::path& path) {
  const auto opened = open_raster(Integrity::whole, path);
  EXPECT_FALSE(opened.raster);
  EXPECT_EQ(opened.problems.size(), 1U);
  return opened.problems.empty() ? "" : core::to_string(opened.problems[0]);
}

constexpr std::array<float, 12> numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

TEST(Hdf5Reader, ReadsChunkedAndCompressedSamples) {
  const TestFolder folder;
  {
    const Hdf5Handle file = create_file(folder / "a.h5");
    add_dataset(file.get(), "samples", complex_float().get(),
                {{2, 3},
                 [](hid_t properties) {
                   const std::array<hsize_t, 2> chunk{1, 2};
                   H5Pset_chunk(properties, 2, chunk.data());
                   H5Pset_deflate(properties, 6);
                 }},
                numbers.data());
  }
  const auto opened = open_raster(Integrity::whole, folder / "a.h5");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_EQ(read_all_rows(*opened.raster),
            (std::vector<std::complex<double>>{{1, 2}, {3, 4}, {5, 6}, {7, 8}, {9, 10}, {11, 12}}));
  EXPECT_FALSE(opened.raster->axes());
  EXPECT_EQ(opened.raster->info().bits, 0);
}

// A pair of numbers as the file stores them.
Hdf5Handle stored_pair(hid_t number, bool real_first) {
  const std::size_t size = H5Tget_size(number);
  Hdf5Handle type(H5Tcreate(H5T_COMPOUND, 2 * size), H5Tclose);
  H5Tinsert(type.get(), "r", real_first ? 0 : size, number);
  H5Tinsert(type.get(), "i", real_first ? size : 0, number);
  return type;
}

TEST(Hdf5Reader, ReadsNumbersOfEachKind) {
  const TestFolder folder;
  const Hdf5Handle memory = stored_pair(H5T_NATIVE_DOUBLE, true);
  const std::vector<std::complex<double>> small{{1, 2}, {3, 4}, {127, 0}, {7, 8}, {9, 10}, {11, 12}};
  const std::vector<std::complex<double>> large{{-1, 2}, {3, -4}, {-128, 0}, {7, 8}, {9, 10}, {11, 12}};
  for (const hid_t number : {H5T_STD_I8LE, H5T_STD_U8LE, H5T_STD_I16LE, H5T_STD_I16BE, H5T_STD_I32LE, H5T_STD_I64LE,
                             H5T_IEEE_F32LE, H5T_IEEE_F32BE, H5T_IEEE_F64LE, H5T_IEEE_F64BE}) {
    for (const bool real_first : {true, false}) {
      const auto& samples = H5Tequal(number, H5T_STD_U8LE) > 0 ? small : large;
      {
        const Hdf5Handle file = create_file(folder / "a.h5");
        add_dataset(file.get(), "samples", stored_pair(number, real_first).get(), {{2, 3}}, nullptr);
        const Hdf5Handle dataset(H5Dopen2(file.get(), "samples", H5P_DEFAULT), H5Dclose);
        ASSERT_GE(H5Dwrite(dataset.get(), memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, samples.data()), 0);
      }
      const auto opened = open_raster(Integrity::whole, folder / "a.h5");
      ASSERT_TRUE(opened.raster) << text_of(opened.problems);
      EXPECT_EQ(read_all_rows(*opened.raster), samples) << H5Tget_size(number) << real_first;
      std::vector<std::complex<float>> window(2);
      opened.raster->read_window({0, 2, 2, 1}, window);
      EXPECT_EQ(std::complex<double>(window[0]), samples[2]);
      EXPECT_EQ(std::complex<double>(window[1]), samples[5]);
      std::vector<std::complex<float>> whole(6);
      opened.raster->read_window({0, 2, 0, 3}, whole);
      EXPECT_EQ(std::complex<double>(whole[4]), samples[4]);
    }
  }
}

// Places in the file count from its beginning, those of the library from behind what stands before it.
TEST(Hdf5Reader, ReadsRowsBehindAUserBlock) {
  const TestFolder folder;
  {
    const Hdf5Handle properties(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    ASSERT_GE(H5Pset_userblock(properties.get(), 1024), 0);
    const Hdf5Handle file(H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, properties.get(), H5P_DEFAULT), H5Fclose);
    add_dataset(file.get(), "samples", complex_float().get(), {{2, 3}}, numbers.data());
  }
  const auto opened = open_raster(Integrity::whole, folder / "a.h5");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_EQ(read_all_rows(*opened.raster),
            (std::vector<std::complex<double>>{{1, 2}, {3, 4}, {5, 6}, {7, 8}, {9, 10}, {11, 12}}));
}

TEST(Hdf5Reader, SaysWhichFileWasCutOffWhileItWasRead) {
  const TestFolder folder;
  constexpr std::size_t rows = 1000;
  {
    const Hdf5Handle file = create_file(folder / "a.h5");
    const std::vector<float> samples(2 * rows * 10, 1.5F);
    add_dataset(file.get(), "samples", complex_float().get(), {.shape = {rows, 10}}, samples.data());
  }
  const auto opened = open_raster(Integrity::whole, folder / "a.h5");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  fs::resize_file(folder / "a.h5", 10'000);
  std::vector<std::complex<double>> row(10);
  try {
    opened.raster->read_rows(rows - 1, 1, row);
    FAIL() << "a row that is not there was read";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.h5"));
  }
}

// The library would clear two buffers of a megabyte for each of them: 512 pages a row.
TEST(Hdf5Reader, ReadsShortRowsOneByOneWithoutClearingMegabytes) {
  const TestFolder folder;
  constexpr std::size_t rows = 2000;
  {
    const Hdf5Handle file = create_file(folder / "rows.h5");
    const std::vector<float> samples(2 * rows * 10, 1.5F);
    add_dataset(file.get(), "samples", complex_float().get(), {.shape = {rows, 10}}, samples.data());
  }
  OpenedRaster opened = open_raster(Integrity::whole, folder / "rows.h5");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  const auto faults = [] {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
  };
  std::vector<std::complex<double>> row(10);
  opened.raster->read_rows(0, 1, row);
  const long before = faults();
  for (std::size_t r = 0; r < rows; ++r) opened.raster->read_rows(r, 1, row);
  EXPECT_LT(faults() - before, 50'000);
  EXPECT_EQ(row[9], std::complex<double>(1.5, 1.5));
}

// A file is tried in a child process of little memory. All of this one but its structure is a hole, which takes no
// disk.
TEST(Hdf5Reader, OpensFilesWhoseAxesAreLargerThanTheMemoryOfTheTrial) {
  const TestFolder folder;
  constexpr hsize_t rows = 36'000'000;
  const auto hole = [](hid_t properties) {
    H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER);
  };
  {
    const Hdf5Handle file = create_file(folder / "a.h5");
    add_dataset(file.get(), "samples", complex_float().get(), {{rows, 1}, hole});
    for (const char* name : {"pulse_time_s", "carrier_hz"})
      add_dataset(file.get(), name, H5T_IEEE_F64LE, {{rows}, hole});
    add_dataset(file.get(), "slant_range_m", H5T_IEEE_F64LE, {{1}, hole});
  }
  const auto opened = open_raster(Integrity::whole, folder / "a.h5");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_EQ(opened.raster->rows(), rows);
}

TEST(Hdf5Reader, SaysWhatItCouldNotRead) {
  const TestFolder folder;
  {
    const Hdf5Handle file = create_file(folder / "a.h5");
    add_dataset(file.get(), "samples", complex_float().get(), {{2, 3}, [](hid_t properties) {
                                                                 const std::array<hsize_t, 2> chunk{2, 3};
                                                                 H5Pset_chunk(properties, 2, chunk.data());
                                                                 H5Pset_deflate(properties, 6);
                                                               }});
    const Hdf5Handle dataset(H5Dopen2(file.get(), "samples", H5P_DEFAULT), H5Dclose);
    const std::array<hsize_t, 2> begin{0, 0};
    const std::string garbage = "this is no stream of deflate";
    ASSERT_GE(H5Dwrite_chunk(dataset.get(), H5P_DEFAULT, 0, begin.data(), garbage.size(), garbage.data()), 0);
  }
  EXPECT_THAT(error_of(folder / "a.h5"), HasSubstr("inflate"));
}

// A file is tried in a child process; that must not begin with a copy of the library that another thread has locked.
TEST(Hdf5Reader, OpensFilesWhileOtherThreadsReadAndWriteSome) {
  const TestFolder folder;
  write_test_file(folder / "a.h5", test_product(20, 10, 8), {scene::FileFormat::hdf5});
  write_test_file(folder / "read.h5", test_product(2000, 100, 8), {scene::FileFormat::hdf5});
  const auto other = open_raster(Integrity::whole, folder / "read.h5");
  ASSERT_TRUE(other.raster) << text_of(other.problems);
  std::atomic<bool> ended = false;
  std::thread reads([&] {
    while (!ended) (void)read_all_rows(*other.raster);
  });
  std::thread writes([&] {
    while (!ended) write_test_file(folder / "write.h5", test_product(200, 10, 8), {scene::FileFormat::hdf5, true});
  });
  std::string refused;
  for (int i = 0; i < 60 && refused.empty(); ++i) {
    const auto opened = open_raster(Integrity::whole, folder / "a.h5");
    if (!opened.raster) refused = "opening number " + std::to_string(i) + ": " + text_of(opened.problems);
  }
  ended = true;
  reads.join();
  writes.join();
  EXPECT_EQ(refused, "");
}

TEST(Hdf5Reader, ReadsTheLayoutOf2015) {
  const TestFolder folder;
  {
    const Hdf5Handle file = create_file(folder / "a.h5");
    const Hdf5Handle group(H5Gcreate2(file.get(), "Data", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    const std::array<double, 8> data{1, 2, 3, 4, -5, 6, 7, -8};
    add_dataset(group.get(), "PulseNo_x_SampleNo_I&Q", H5T_IEEE_F64LE, {{2, 4}, [](hid_t) {}}, data.data());
  }
  const auto opened = open_raster(Integrity::whole, folder / "a.h5");
  ASSERT_TRUE(opened.raster) << text_of(opened.problems);
  EXPECT_TRUE(opened.raster->info().counts);
  EXPECT_EQ(read_all_rows(*opened.raster), (std::vector<std::complex<double>>{{1, 2}, {3, 4}, {-5, 6}, {7, -8}}));
}

TEST(Hdf5Reader, WhatIsNotHdf5IsAProblem) {
  const TestFolder folder;
  EXPECT_THAT(error_of(put(folder / "a.h5", "\x89HDF\r\n\x1a\n and then nothing")),
              HasSubstr("cannot be read as HDF5"));
  EXPECT_THAT(error_of(put(folder / "b.h5", "1 2\n")), HasSubstr("cannot be read as HDF5"));
}

TEST(Hdf5Reader, CutFilesAreProblems) {
  const TestFolder folder;
  write_test_file(folder / "a.h5", test_product(10, 100, 8), {scene::FileFormat::hdf5});
  const std::string whole = contents(folder / "a.h5");
  for (std::size_t size = whole.size() / 16; size < whole.size(); size += whole.size() / 16)
    EXPECT_THAT(error_of(put(folder / "b.h5", whole.substr(0, size))), HasSubstr("cannot be read as HDF5"));
}

TEST(Hdf5Reader, MissingSamplesAreAProblem) {
  const TestFolder folder;
  create_file(folder / "a.h5");
  EXPECT_THAT(error_of(folder / "a.h5"), HasSubstr("/samples is not in the file"));
}

TEST(Hdf5Reader, GroupsAndWrongTypesAndRanksAreProblems) {
  const TestFolder folder;
  {
    const Hdf5Handle file = create_file(folder / "group.h5");
    const Hdf5Handle group(H5Gcreate2(file.get(), "samples", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  }
  EXPECT_THAT(error_of(folder / "group.h5"), HasSubstr("is not a dataset"));
  add_dataset(create_file(folder / "type.h5").get(), "samples", H5T_IEEE_F32LE, {}, numbers.data());
  EXPECT_THAT(error_of(folder / "type.h5"), HasSubstr("compound of r and i"));
  add_dataset(create_file(folder / "rank1.h5").get(), "samples", complex_float().get(), {{6}, [](hid_t) {}},
              numbers.data());
  EXPECT_THAT(error_of(folder / "rank1.h5"), HasSubstr("wrong rank"));
  add_dataset(create_file(folder / "rank3.h5").get(), "samples", complex_float().get(), {{1, 2, 3}, [](hid_t) {}},
              numbers.data());
  EXPECT_THAT(error_of(folder / "rank3.h5"), HasSubstr("wrong rank"));
  add_dataset(create_file(folder / "empty.h5").get(), "samples", complex_float().get(), {{0, 3}, [](hid_t) {}});
  EXPECT_THAT(error_of(folder / "empty.h5"), HasSubstr("no whole rows"));
}

TEST(Hdf5Reader, ShapesLargerThanTheFileAreProblems) {
  const TestFolder folder;
  add_dataset(create_file(folder / "late.h5").get(), "samples", complex_float().get(),
              {{1000000000000, 3}, [](hid_t) {}});
  EXPECT_THAT(error_of(folder / "late.h5"), HasSubstr("beyond the end of the file"));
  add_dataset(create_file(folder / "chunks.h5").get(), "samples", complex_float().get(),
              {{1000000000000, 3}, [](hid_t properties) {
                 const std::array<hsize_t, 2> chunk{1, 3};
                 H5Pset_chunk(properties, 2, chunk.data());
               }});
  EXPECT_THAT(error_of(folder / "chunks.h5"), HasSubstr("larger than its file can hold"));
  add_dataset(create_file(folder / "chunk.h5").get(), "samples", complex_float().get(),
              {{100000, 300}, [](hid_t properties) {
                 const std::array<hsize_t, 2> chunk{100000, 300};
                 H5Pset_chunk(properties, 2, chunk.data());
               }});
  EXPECT_THAT(error_of(folder / "chunk.h5"), HasSubstr("chunks larger"));
}

TEST(Hdf5Reader, OtherFilesAreNeverOpened) {
  const TestFolder folder;
  write_test_file(folder / "good.h5", test_product(2, 3, 8), {scene::FileFormat::hdf5});
  const std::string good = (folder / "good.h5").string();
  {
    const Hdf5Handle file = create_file(folder / "link.h5");
    H5Lcreate_external(good.c_str(), "/samples", file.get(), "samples", H5P_DEFAULT, H5P_DEFAULT);
  }
  EXPECT_THAT(error_of(folder / "link.h5"), HasSubstr("is not in the file"));
  add_dataset(create_file(folder / "raw.h5").get(), "samples", complex_float().get(),
              {{2, 3}, [&](hid_t properties) { H5Pset_external(properties, good.c_str(), 0, 48); }});
  EXPECT_THAT(error_of(folder / "raw.h5"), HasSubstr("stored in other files"));
  {
    const Hdf5Handle file = create_file(folder / "virtual.h5");
    add_dataset(file.get(), "samples", complex_float().get(),
                {{2, 3}, [&](hid_t properties) {
                   const std::array<hsize_t, 2> size{2, 3};
                   const Hdf5Handle space(H5Screate_simple(2, size.data(), nullptr), H5Sclose);
                   H5Pset_virtual(properties, space.get(), good.c_str(), "/samples", space.get());
                 }});
  }
  EXPECT_THAT(error_of(folder / "virtual.h5"), HasSubstr("layout that is not read"));
}

// A filter that only this test knows, and only while it writes.
std::size_t copy_filter(unsigned, std::size_t, const unsigned*, std::size_t bytes, std::size_t*, void**) {
  return bytes;
}

TEST(Hdf5Reader, MissingFiltersAreProblems) {
  const TestFolder folder;
  const H5Z_class2_t filter{H5Z_CLASS_T_VERS, 300, 1, 1, "private", nullptr, nullptr, copy_filter};
  ASSERT_GE(H5Zregister(&filter), 0);
  add_dataset(create_file(folder / "a.h5").get(), "samples", complex_float().get(),
              {{2, 3},
               [](hid_t properties) {
                 const std::array<hsize_t, 2> chunk{1, 3};
                 H5Pset_chunk(properties, 2, chunk.data());
                 H5Pset_filter(properties, 300, 0, 0, nullptr);
               }},
              numbers.data());
  ASSERT_GE(H5Zunregister(300), 0);
  EXPECT_THAT(error_of(folder / "a.h5"), HasSubstr("filter that is not built in"));
}

TEST(Hdf5Sink, RecordsNoTimes) {
  const TestFolder folder;
  write_test_file(folder / "a.h5", test_product(2, 3, 8), {scene::FileFormat::hdf5});
  const Hdf5Handle file(H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  ASSERT_TRUE(file);
  for (const char* name : {"/", "/samples", "/pulse_time_s", "/carrier_hz", "/slant_range_m", "/platform_position_m"}) {
    H5O_info_t object{};
    ASSERT_GE(H5Oget_info_by_name2(file.get(), name, &object, H5O_INFO_TIME, H5P_DEFAULT), 0) << name;
    EXPECT_EQ(object.btime, 0) << name;
    EXPECT_EQ(object.mtime, 0) << name;
    EXPECT_EQ(object.ctime, 0) << name;
  }
}

TEST(Hdf5Reader, AxesOfTheWrongLengthAreRefused) {
  const TestFolder folder;
  {
    const Hdf5Handle file = create_file(folder / "a.h5");
    add_dataset(file.get(), "samples", complex_float().get(), {}, numbers.data());
    const std::array<double, 3> axis{1, 2, 3};
    for (const char* name : {"pulse_time_s", "carrier_hz", "slant_range_m"})
      add_dataset(file.get(), name, H5T_IEEE_F64LE, {{3}, [](hid_t) {}}, axis.data());
  }
  EXPECT_THAT(error_of(folder / "a.h5"), HasSubstr("the axis /pulse_time_s has not the length of the samples"));
}

}  // namespace hdf5_reader_test
}  // namespace sarsim::raster
