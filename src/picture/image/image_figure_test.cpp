#include "picture/image/image_figure.hpp"

#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

#include <unistd.h>

#include <gtest/gtest.h>

#include "raster/format/open_raster.hpp"

namespace sarsim::picture {
namespace image_figure_test {

constexpr std::size_t rows = 6;
constexpr std::size_t columns = 4;

// Complex floats: row + 1 in every column, but a single point of 100 at row 3, column 2.
class ImageFigure : public testing::Test {
 protected:
  void SetUp() override {
    path_ = std::filesystem::temp_directory_path() / ("image_figure_" + std::to_string(::getpid()) + ".raw");
    std::ofstream file(path_, std::ios::binary);
    for (std::size_t r = 0; r < rows; ++r)
      for (std::size_t c = 0; c < columns; ++c) {
        const float pair[] = {r == 3 && c == 2 ? 100.0F : static_cast<float>(r + 1), 0.0F};
        file.write(reinterpret_cast<const char*>(pair), sizeof pair);
      }
    file.close();
    raster::RawLayout layout;
    layout.width = columns;
    layout.number = raster::RawNumber::float32;
    source_ = raster::open_raster(raster::Integrity::partial, path_, {.raw = layout}).raster;
    ASSERT_TRUE(source_);
  }
  void TearDown() override {
    source_.reset();
    std::filesystem::remove(path_);
  }

  [[nodiscard]] FigurePanel panel(const ImageLook& look, const PlotSize& size = {100, 100}) const {
    return image_figure(*source_, look, size).panels.at(0);
  }

  std::filesystem::path path_;
  std::shared_ptr<raster::Raster> source_;
};

// By count and place, whatever stands for them in the picture.
TEST_F(ImageFigure, NamesSamplesThatAreNotFinite) {
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  for (const auto& [row, column] : {std::pair<std::size_t, std::size_t>{2, 1}, {4, 0}}) {
    const float bad[] = {std::numeric_limits<float>::quiet_NaN(), 0.0F};
    file.seekp(static_cast<std::streamoff>((row * columns + column) * sizeof bad));
    file.write(reinterpret_cast<const char*>(bad), sizeof bad);
  }
  file.close();
  for (const PixelRule rule : {PixelRule::sample, PixelRule::peak}) {
    ImageLook look;
    look.pixel_rule = rule;
    core::Problems remarks;
    static_cast<void>(image_figure(*source_, look, {100, 100}, {}, &remarks));
    ASSERT_EQ(remarks.size(), 1U);
    const std::string text = core::to_string(remarks[0]);
    EXPECT_NE(text.find("warning: 2 of the samples are not finite"), std::string::npos) << text;
    EXPECT_NE(text.find("found 'row 2, sample 1 (from 0), the first of them'"), std::string::npos) << text;
  }
  ImageLook sound;
  sound.rows = 2;
  core::Problems remarks;
  static_cast<void>(image_figure(*source_, sound, {100, 100}, {}, &remarks));
  EXPECT_TRUE(remarks.empty());
}

TEST_F(ImageFigure, HasACellForEverySampleWhereThereIsRoom) {
  const FigurePanel shown = panel({});
  ASSERT_TRUE(shown.image);
  EXPECT_EQ(shown.image->width, columns);
  EXPECT_EQ(shown.image->height, rows);
  EXPECT_EQ(shown.x.label, "Sample");
  EXPECT_EQ(shown.x.first, -0.5);
  EXPECT_EQ(shown.y.last, 5.5);
  EXPECT_TRUE(shown.colour_bar);
}

// A map's first row is its northern one.
TEST_F(ImageFigure, HasTheLargerPlacesAboveWhereTheStepIsNegative) {
  ImageLook look;
  look.row_places = raster::ImagePlaces{"North", "m", 500.0, -100.0};
  const FigurePanel shown = panel(look);
  EXPECT_EQ(shown.y.first, -50.0);
  EXPECT_EQ(shown.y.last, 550.0);
  const FigureImage& image = shown.image.value();
  EXPECT_EQ(image.y_first, -50.0);
  EXPECT_EQ(image.y_last, 550.0);
  // The point of row 3 is at 200 m, in the third cell from below.
  EXPECT_EQ(image.cells.at(2 * columns + 2), shown.colour_bar->colours.back());
  EXPECT_NE(image.cells.at(3 * columns + 2), shown.colour_bar->colours.back());
}

TEST_F(ImageFigure, LosesAPointBetweenPixelsUnlessThePeakOfEachIsShown) {
  ImageLook look;
  EXPECT_NE(image_figure(*source_, look, {2, 3}).note, "Highest magnitude: 100");
  look.pixel_rule = PixelRule::peak;
  const Figure figure = image_figure(*source_, look, {2, 3});
  EXPECT_EQ(figure.note, "Highest magnitude: 100");
  const FigureImage& image = *figure.panels[0].image;
  ASSERT_EQ(image.width * image.height, 6U);
  // Rows 2 and 3, columns 2 and 3.
  EXPECT_EQ(image.cells[3], figure.panels[0].colour_bar->colours.back());
  EXPECT_NE(image.cells[2], image.cells[3]);
}

TEST_F(ImageFigure, PeaksOfPartsAtTheEndAreOfWhatIsThere) {
  ImageLook look;
  look.pixel_rule = PixelRule::peak;
  const Figure figure = image_figure(*source_, look, {3, 4});
  EXPECT_EQ(figure.panels[0].image->width, 2U);
  EXPECT_EQ(figure.panels[0].image->height, 3U);
  EXPECT_EQ(figure.note, "Highest magnitude: 100");
}

TEST_F(ImageFigure, StandsAtThePlacesThatTheLookNames) {
  ImageLook look;
  look.first_row = 2;
  look.row_places = raster::ImagePlaces{"Azimuth", "m", -10.0, 0.5};
  look.column_places = raster::ImagePlaces{"Slant range", "m", 1000.0, 2.0};
  const FigurePanel shown = panel(look);
  EXPECT_EQ(shown.y.label, "Azimuth");
  EXPECT_DOUBLE_EQ(shown.y.first, -9.25);
  EXPECT_DOUBLE_EQ(shown.y.last, -7.25);
  EXPECT_DOUBLE_EQ(shown.x.first, 999.0);
  EXPECT_DOUBLE_EQ(shown.x.last, 1007.0);
}

TEST_F(ImageFigure, AsSlicesHasACurveForEachRowWhoseLargestFillsThreeEighthsOfTheSpacing) {
  ImageLook look;
  look.draw_as = DrawAs::curves_per_pulse;
  const FigurePanel shown = panel(look, {200, 200});
  EXPECT_FALSE(shown.image);
  ASSERT_EQ(shown.curves.size(), rows);
  EXPECT_EQ(shown.curves[3].x, (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
  EXPECT_DOUBLE_EQ(shown.curves[3].y[2], 3.375);
  EXPECT_DOUBLE_EQ(shown.curves[0].y[0], 0.375 * 0.01);
}

TEST_F(ImageFigure, AsSlicesPerRangeGoesUpwardsAndAside) {
  ImageLook look;
  look.draw_as = DrawAs::curves_per_range;
  const FigurePanel shown = panel(look, {200, 200});
  ASSERT_EQ(shown.curves.size(), columns);
  EXPECT_DOUBLE_EQ(shown.curves[2].x[3], 2.375);
  EXPECT_DOUBLE_EQ(shown.curves[2].y[3], 3.0);
}

TEST_F(ImageFigure, LeavesOutSlicesThatWouldBeNearerThanTwentyPixels) {
  ImageLook look;
  look.draw_as = DrawAs::curves_per_pulse;
  const FigurePanel shown = panel(look, {200, 60});
  ASSERT_EQ(shown.curves.size(), 3U);
  // Rows 0, 2 and 4; the largest of them is 5.
  EXPECT_DOUBLE_EQ(shown.curves[1].y[2], 2.0 + 0.375 * 2.0 * 3.0 / 5.0);
}

TEST_F(ImageFigure, ChoosesSlicesByItselfWhereRowsAreFarApart) {
  ImageLook look;
  look.draw_as = DrawAs::automatic;
  EXPECT_FALSE(panel(look, {200, 120}).image);
  EXPECT_TRUE(panel(look, {200, 119}).image);
}

TEST_F(ImageFigure, SaysAUnitOnlyWhereItIsKnown) {
  EXPECT_EQ(panel({}).colour_bar->unit, "");
  ImageLook look;
  look.unit = "V";
  const Figure figure = image_figure(*source_, look, {100, 100});
  EXPECT_EQ(figure.panels[0].colour_bar->unit, "V");
  EXPECT_EQ(figure.note, "Highest magnitude: 100 V");
}

TEST_F(ImageFigure, RefusesAPartThatIsNotThere) {
  ImageLook look;
  look.first_column = columns;
  EXPECT_THROW((void)panel(look), std::invalid_argument);
}

TEST_F(ImageFigure, SaysTheUnitOfDecibelsOnce) {
  ImageLook look;
  look.quantity = DisplayQuantity::decibels;
  const FigurePanel shown = panel(look);
  EXPECT_EQ(shown.colour_bar->label, "Power");
  EXPECT_EQ(shown.colour_bar->unit, "dB");
}

}  // namespace image_figure_test
}  // namespace sarsim::picture
