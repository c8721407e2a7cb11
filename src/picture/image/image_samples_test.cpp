#include "picture/image/image_samples.hpp"

#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"
#include "raster/format/custom_raw.hpp"
#include "raster/format/envi.hpp"

namespace sarsim::picture {
namespace image_samples_test {

namespace fs = std::filesystem;

// An image of 8 x 8 samples, 2 m apart, whose value is row + i column.
class ImageSamplesTest : public testing::Test {
 protected:
  ImageSamplesTest() {
    raster::EnviHeader header;
    header.samples = size;
    header.lines = size;
    header.pixel = raster::EnviHeader::Pixel::complex_float;
    raster::EnviWriter writer(file_, header, true);
    for (std::size_t r = 0; r < size; ++r) {
      std::vector<std::complex<float>> row;
      for (std::size_t c = 0; c < size; ++c) row.emplace_back(static_cast<float>(r), static_cast<float>(c));
      writer.append(row);
    }
    writer.finish();
    raster::RasterHints hints;
    hints.raw = raster::envi_layout(file_);
    part_.source = raster::open_raster(raster::Integrity::partial, file_, hints).raster;
    part_.focused = raster::FocusedPlaces{{"Azimuth", "m", 10.0, 2.0}, {"Slant range", "m", 100.0, 2.0}, 0, 0};
    part_.rows = {2, 6};
    part_.columns = {1, 8};
    part_.samples.row_place = part_.focused->azimuth.list(size);
    part_.samples.column_place = part_.focused->range.list(size);
  }
  ~ImageSamplesTest() override { fs::remove(file_), fs::remove(fs::path(file_).replace_extension(".hdr")); }

  static constexpr std::size_t size = 8;
  fs::path file_ = fs::temp_directory_path() / (std::string("image-samples-") +
                                                testing::UnitTest::GetInstance()->current_test_info()->name() + ".img");
  ImageSamples part_;
};

TEST_F(ImageSamplesTest, AreThoseOfThePartAtTheirPlaces) {
  ASSERT_TRUE(part_.source);
  begin_reading(part_, nullptr);
  EXPECT_EQ(part_.samples.row_place, (std::vector<double>{14.0, 16.0, 18.0, 20.0}));
  EXPECT_EQ(part_.samples.look.unit, "V");
  const EchoBlock block = part_.samples.read({1, 3}, {2, 4});
  EXPECT_EQ(block.time_s, (std::vector<double>{16.0, 18.0}));
  EXPECT_EQ(block.range_m, (std::vector<double>{106.0, 108.0}));
  EXPECT_EQ(block.samples, (std::vector<std::complex<double>>{{3, 3}, {3, 4}, {4, 3}, {4, 4}}));
}

TEST_F(ImageSamplesTest, OfAFinerCutPassThroughThoseOfTheFile) {
  ASSERT_TRUE(part_.source);
  begin_reading(part_, nullptr);
  make_finer(part_, true, nullptr);
  ASSERT_EQ(part_.samples.column_place.size(), 6 * upsampled_by + 1);
  const EchoBlock block = part_.samples.read({0, 1}, {0, part_.samples.column_place.size()});
  for (std::size_t c = 0; c < 7; ++c) {
    EXPECT_EQ(block.range_m[c * upsampled_by], 102.0 + 2.0 * static_cast<double>(c));
    EXPECT_LT(std::abs(block.samples[c * upsampled_by] - std::complex<double>(2.0, static_cast<double>(c) + 1.0)),
              1e-5);
  }
}

// One sample would spoil all that lies between the others.
TEST_F(ImageSamplesTest, RefusesASampleThatCannotBeComputedWith) {
  const float bad[] = {std::numeric_limits<float>::infinity(), 0.0F};
  std::fstream file(file_, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(static_cast<std::streamoff>((3 * size + 5) * sizeof bad));
  file.write(reinterpret_cast<const char*>(bad), sizeof bad);
  file.close();
  const auto refusal = [](const auto& read) {
    try {
      static_cast<void>(read());
    } catch (const core::InvalidRequest& refused) {
      return refused.problems.at(0).message;
    }
    return std::string();
  };
  const std::string expected = "row 3, sample 5 (from 0) is too large to compute with";
  begin_reading(part_, nullptr);
  EXPECT_EQ(refusal([&] { return part_.samples.read({0, 4}, {0, 7}); }), expected);
  EXPECT_EQ(refusal([&] { return part_.samples.read({0, 1}, {0, 7}); }), "");
  make_finer(part_, false, nullptr);
  EXPECT_EQ(refusal([&] { return part_.samples.read({0, part_.samples.row_place.size()}, {4, 5}); }), expected);
}

TEST(SayUnit, ExchangesTheWordsOfVolts) {
  Figure figure;
  figure.panels.resize(2);
  figure.panels[0].y.unit = "V";
  figure.panels[1].y.label = "Density above 1 W/Hz";
  say_unit(figure, "counts");
  EXPECT_EQ(figure.panels[0].y.unit, "counts");
  EXPECT_EQ(figure.panels[1].y.label, "Density above 1 counts^2/Hz");
}

}  // namespace image_samples_test
}  // namespace sarsim::picture
