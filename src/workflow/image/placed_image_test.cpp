#include "workflow/image/placed_image.hpp"

#include <complex>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"
#include "raster/format/envi.hpp"

namespace sarsim::workflow {
namespace placed_image_test {

namespace fs = std::filesystem;

class PlacedImageTest : public testing::Test {
 protected:
  ~PlacedImageTest() override { fs::remove(file_), fs::remove(fs::path(file_).replace_extension(".hdr")); }

  // An image of 3 x 4 pixels with these fields in its header.
  void write(const std::vector<std::pair<std::string, std::string>>& fields) const {
    raster::EnviHeader header;
    header.samples = 4;
    header.lines = 3;
    header.pixel = raster::EnviHeader::Pixel::complex_float;
    header.fields = fields;
    raster::EnviWriter writer(file_, header, true);
    for (int row = 0; row < 3; ++row) writer.append(std::vector<std::complex<float>>(4, 1.0F));
    writer.finish();
  }
  [[nodiscard]] PlacedImage opened() const { return open_placed_image({file_.string(), {}, {}}, {}); }

  fs::path file_ = fs::temp_directory_path() / (std::string("placed-image-") +
                                                testing::UnitTest::GetInstance()->current_test_info()->name() + ".img");
};

TEST_F(PlacedImageTest, HasThePlacesOfItsHeader) {
  write({{"map", "ppi"}, {"x first m", "-10"}, {"x step m", "5"}, {"y first m", "100"}, {"y step m", "-2"}});
  const PlacedImage image = opened();
  EXPECT_EQ(image.source->rows(), 3U);
  ASSERT_TRUE(image.focused);
  EXPECT_EQ(image.focused->azimuth, (raster::ImagePlaces{"North", "m", 100.0, -2.0}));
  EXPECT_EQ(image.focused->range, (raster::ImagePlaces{"East", "m", -10.0, 5.0}));
  EXPECT_FALSE(image.has_times());
}

TEST_F(PlacedImageTest, NumbersWhatItsHeaderDoesNotPlace) {
  write({{"map", "ppi"}, {"x first m", "-10"}, {"x step m", "0"}});
  const PlacedImage image = opened();
  ASSERT_TRUE(image.focused);
  EXPECT_EQ(image.focused->azimuth, (raster::ImagePlaces{"Row", "", 0.0, 1.0}));
  EXPECT_EQ(image.focused->range, (raster::ImagePlaces{"Column", "", 0.0, 1.0}));
}

TEST_F(PlacedImageTest, PutsProfilesWhereTheTargetWasSeenFromOrWhen) {
  const auto rows_of = [&](const std::string& aspects, const std::string& times) {
    write({{"range first m", "100"}, {"range step m", "0.5"}, {"aspect deg", aspects}, {"time s", times}});
    return opened().focused.value().azimuth;
  };
  EXPECT_EQ(rows_of("10, 8, 6", "0, 1, 2"), (raster::ImagePlaces{"Aspect", "deg", 10.0, -2.0}));
  EXPECT_EQ(rows_of("10, 8, 7", "0, 0.5, 1"), (raster::ImagePlaces{"Time", "s", 0.0, 0.5}));
  EXPECT_EQ(rows_of("3, 3, 3", "0, 0.5, 1"), (raster::ImagePlaces{"Time", "s", 0.0, 0.5}));
  EXPECT_EQ(rows_of("", "0, 0.5, 3"), (raster::ImagePlaces{"Profile", "", 1.0, 1.0}));
  EXPECT_EQ(rows_of("1, x, 3", "0, 1"), (raster::ImagePlaces{"Profile", "", 1.0, 1.0}));
}

TEST_F(PlacedImageTest, IsLeftWhereAStopIsRequested) {
  const fs::path text = fs::path(file_).replace_extension(".csv");
  std::ofstream(text) << "1,2\n3,4\n";
  core::StopFlag stop;
  stop.request();
  core::Observer observer;
  observer.stop = &stop;
  EXPECT_THROW((void)open_placed_image({text.string(), {}, {}}, observer), core::Interrupted);
  fs::remove(text);
}

TEST_F(PlacedImageTest, NeedsNothingSaidWhereAHeaderSaysIt) {
  write({{"map", "ppi"}});
  PlacedImageRequest request{file_.string(), {}, {}};
  request.samples.bits = 8;
  EXPECT_THROW(static_cast<void>(open_placed_image(request, {})), core::InvalidRequest);
}

}  // namespace placed_image_test
}  // namespace sarsim::workflow
