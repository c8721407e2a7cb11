#include "raster/format/custom_raw.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <complex>
#include <fstream>
#include <string>
#include <vector>

#include "raster/format/envi.hpp"
#include "raster/format/open_raster.hpp"

namespace sarsim::raster {
namespace envi_layout_test {

namespace fs = std::filesystem;

class EnviLayout : public testing::Test {
 protected:
  EnviLayout() { fs::create_directories(folder_); }
  ~EnviLayout() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, EnviHeader::Pixel pixel) const {
    EnviHeader header;
    header.samples = 3;
    header.lines = 2;
    header.pixel = pixel;
    EnviWriter writer(folder_ / name, header, true);
    for (float row = 0.0F; row < 2.0F; row += 1.0F) {
      const std::vector<std::complex<float>> values{{row, 1.0F}, {row, 2.0F}, {row, 3.0F}};
      writer.append(values);
    }
    writer.finish();
    return folder_ / name;
  }

  fs::path folder_ = fs::temp_directory_path() / ("sarsim_envi_layout_" + std::to_string(getpid()));
};

TEST_F(EnviLayout, OpensImagesOfBothKinds) {
  for (const auto pixel : {EnviHeader::Pixel::complex_float, EnviHeader::Pixel::real_float}) {
    const bool complex = pixel == EnviHeader::Pixel::complex_float;
    const fs::path file = write(complex ? "complex.img" : "real.img", pixel);
    raster::RasterHints hints;
    hints.raw = envi_layout(file);
    ASSERT_TRUE(hints.raw);
    const raster::OpenedRaster opened = raster::open_raster(raster::Integrity::partial, file, hints);
    ASSERT_TRUE(opened.raster);
    EXPECT_EQ(opened.raster->rows(), 2u);
    EXPECT_EQ(opened.raster->columns(), 3u);
    EXPECT_EQ(opened.raster->info().value, complex ? raster::ImageValue::complex : raster::ImageValue::magnitude);
    std::vector<std::complex<float>> read(1);
    opened.raster->read_window({1, 1, 2, 1, 1, 1}, read);
    EXPECT_FLOAT_EQ(std::abs(read[0]), std::hypot(1.0F, 3.0F));
  }
}

TEST_F(EnviLayout, IsNoneOfFilesWithoutASoundHeader) {
  EXPECT_FALSE(envi_layout(folder_ / "none.img"));
  const fs::path cut = write("cut.img", EnviHeader::Pixel::complex_float);
  fs::resize_file(cut, 5);
  EXPECT_FALSE(envi_layout(cut));
  std::ofstream(folder_ / "bad.img") << "data";
  std::ofstream(folder_ / "bad.hdr") << "no header";
  EXPECT_FALSE(envi_layout(folder_ / "bad.img"));
}

}  // namespace envi_layout_test
}  // namespace sarsim::raster
