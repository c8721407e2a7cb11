#include "raster/table/formats.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "raster/format/format_reader.hpp"
#include "raster/format/format_writer.hpp"
#include "support/folders.hpp"

namespace sarsim::raster {
namespace formats_test {

constexpr std::array all_formats{scene::FileFormat::ascii, scene::FileFormat::binary, scene::FileFormat::bracket,
                                 scene::FileFormat::hdf5,  scene::FileFormat::csv,    scene::FileFormat::npy,
                                 scene::FileFormat::zarr,  scene::FileFormat::sigmf};

TEST(Formats, NamesAndExtensionsLeadBackToTheFormat) {
  for (const scene::FileFormat format : all_formats) {
    EXPECT_EQ(format_from_name(name_of(format)), format);
    EXPECT_EQ(format_from_path("folder.x/file" + std::string(extension_of(format))), format);
  }
}

TEST(Formats, EveryFormatOfRecordingsCanBeReadAndWritten) {
  ASSERT_EQ(recording_formats().size(), all_formats.size());
  for (const scene::FileFormat format : all_formats) {
    const Format& row = format_of(format);
    EXPECT_EQ(row.recording, format);
    EXPECT_NE(row.open, nullptr) << row.word;
    ASSERT_NE(row.writer, nullptr) << row.word;
    EXPECT_NE(row.writer->encode, nullptr) << row.word;
    EXPECT_NE(row.writer->expected_bytes, nullptr) << row.word;
    EXPECT_EQ(row.writer->component_bytes == nullptr, row.is_text()) << row.word;
    EXPECT_NE(row.max_sample_bytes, nullptr) << row.word;
  }
}

TEST(Formats, ListsForPeopleHoldEachFormatOnce) {
  for (const auto place : {&FormatPlaces::saved, &FormatPlaces::exported, &FormatPlaces::image}) {
    const auto offered = offered_formats(place);
    // Selections go into one file, and images are not SigMF.
    const std::size_t left_out = place == &FormatPlaces::exported ? 2 : place == &FormatPlaces::image ? 1 : 0;
    EXPECT_EQ(offered.size(), all_formats.size() - left_out);
    for (std::size_t i = 0; i < offered.size(); ++i) EXPECT_EQ(offered[i]->places.*place, static_cast<int>(i) + 1);
  }
  EXPECT_EQ(format_words(), "ascii, binary, bracket, hdf5, csv, npy, zarr or sigmf");
  EXPECT_EQ(image_extensions(), ".npy, .h5, .zarr, .csv, .asc, .bin, .brk");
  EXPECT_EQ(image_extensions(true), ".npy, .h5, .zarr, .asc, .bin, .brk");
}

TEST(Formats, OnlyTextIsEstimatedFromAbove) {
  EXPECT_EQ(min_bytes(scene::FileFormat::csv, 1000.0), 400.0);
  EXPECT_EQ(min_bytes(scene::FileFormat::binary, 1000.0), 1000.0);
  EXPECT_EQ(min_bytes(scene::FileFormat::hdf5, 1000.0), 1000.0);
}

TEST(Formats, FilesOfOthersHaveRowsToo) {
  EXPECT_EQ(row_from_path("a.img"), &envi_format());
  EXPECT_EQ(row_from_path("a.SUN"), &sun_raster_format());
  EXPECT_EQ(row_from_path("a.cf32"), &custom_format());
  EXPECT_EQ(row_from_path("a.scr"), nullptr);
  EXPECT_EQ(word_of(envi_format()), "envi");
}

TEST(Formats, CaseDoesNotMatter) {
  EXPECT_EQ(format_from_name("hdf5"), scene::FileFormat::hdf5);
  EXPECT_EQ(format_from_path("A.NPY"), scene::FileFormat::npy);
  EXPECT_EQ(format_from_path("a.hdf5"), scene::FileFormat::hdf5);
}

// What a source says of formats by their names, line by line, but for the value of a member that nobody has set.
std::vector<std::string> names_of_formats(const std::filesystem::path& source) {
  std::vector<std::string> found;
  std::ifstream file(source);
  for (std::string line; std::getline(file, line);)
    if (line.find("FileFormat::") != std::string::npos && !line.starts_with("  scene::FileFormat format = "))
      found.push_back(source.string() + ": " + line);
  return found;
}

TEST(Formats, NobodyElseAsksForAFormatByName) {
  const std::filesystem::path sources = test::source_folder() / "src";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(sources)) {
    const std::filesystem::path& path = entry.path();
    const std::string name = path.filename().string();
    const bool source = path.extension() == ".cpp" || path.extension() == ".hpp";
    const std::string folder = path.lexically_relative(sources).begin()->string();
    if (!source || folder == "scene" || name.find("_test") != std::string::npos || name == "formats.cpp") continue;
    ++files;
    EXPECT_EQ(names_of_formats(path), std::vector<std::string>());
  }
  EXPECT_GT(files, 500U);
}

TEST(Formats, OthersAreNotKnown) {
  EXPECT_FALSE(format_from_name("ASC"));
  EXPECT_FALSE(format_from_path("asc"));
  EXPECT_FALSE(format_from_path("a.png"));
}

}  // namespace formats_test
}  // namespace sarsim::raster
