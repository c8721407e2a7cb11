#include "raster/table/formats.hpp"

#include <gtest/gtest.h>

#include <array>

namespace sarsim::raster {
namespace {

constexpr std::array all_formats{scene::FileFormat::ascii, scene::FileFormat::binary, scene::FileFormat::bracket,
                                 scene::FileFormat::hdf5,  scene::FileFormat::csv,    scene::FileFormat::npy};

TEST(Formats, NamesAndExtensionsLeadBackToTheFormat) {
  for (const scene::FileFormat format : all_formats) {
    EXPECT_EQ(format_from_name(name_of(format)), format);
    EXPECT_EQ(format_from_path("folder.x/file" + std::string(extension_of(format))), format);
  }
}

TEST(Formats, CaseDoesNotMatter) {
  EXPECT_EQ(format_from_name("hdf5"), scene::FileFormat::hdf5);
  EXPECT_EQ(format_from_path("A.NPY"), scene::FileFormat::npy);
  EXPECT_EQ(format_from_path("a.hdf5"), scene::FileFormat::hdf5);
}

TEST(Formats, OthersAreNotKnown) {
  EXPECT_FALSE(format_from_name("ASC"));
  EXPECT_FALSE(format_from_path("asc"));
  EXPECT_FALSE(format_from_path("a.png"));
}

}  // namespace
}  // namespace sarsim::raster
