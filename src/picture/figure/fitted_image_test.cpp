#include "picture/figure/fitted_image.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace sarsim::picture::fitted_image_test {

namespace {

constexpr raster::Rgb low{0, 0, 0};
constexpr raster::Rgb middle{120, 120, 120};
constexpr raster::Rgb high{255, 255, 0};
constexpr raster::Rgb foreign{1, 2, 3};

FigureColourBar bar_from(double first, double last, ColourMapKind kind = ColourMapKind::sequential) {
  return {"", "dB", first, last, {low, middle, high}, kind};
}

FigureImage image_of(std::size_t width, std::size_t height, raster::Rgb ground) {
  return {width, height, 0.0, 1.0, 0.0, 1.0, std::vector<raster::Rgb>(width * height, ground)};
}

TEST(FittedImage, StaysAsItIsWhereItHasNoMoreCellsThanDots) {
  const FigureImage image = image_of(3, 2, low);
  EXPECT_EQ(fitted(image, bar_from(-50.0, 0.0), 3, 2), image);
  EXPECT_EQ(fitted(image, std::nullopt, 100, 100), image);
}

TEST(FittedImage, LosesNoPointOfOneCellWhereverItIs) {
  constexpr std::size_t width = 37;
  constexpr std::size_t height = 23;
  for (std::size_t place = 0; place < width * height; ++place) {
    FigureImage image = image_of(width, height, low);
    image.cells[place] = high;
    const FigureImage out = fitted(image, bar_from(-50.0, 0.0), 36, 9);
    ASSERT_EQ(out.width, 36U);
    ASSERT_EQ(out.height, 9U);
    ASSERT_EQ(out.cells.size(), 36U * 9U);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < out.cells.size(); ++i) {
      if (out.cells[i] == low) continue;
      ++seen;
      // Where it was, to a dot.
      EXPECT_NEAR((static_cast<double>(i % 36) + 0.5) / 36.0, (static_cast<double>(place % width) + 0.5) / width,
                  1.0 / 36);
      EXPECT_NEAR((static_cast<double>(i / 36) + 0.5) / 9.0, (static_cast<double>(place / width) + 0.5) / height,
                  1.0 / 9);
    }
    ASSERT_EQ(seen, 1U) << place;
  }
}

TEST(FittedImage, ShrinksOnlyTheSideThatIsTooLong) {
  FigureImage image = image_of(2, 4, low);
  image.cells[1] = middle;
  const FigureImage out = fitted(image, bar_from(0.0, 1.0), 10, 2);
  EXPECT_EQ(out.cells, (std::vector<raster::Rgb>{low, middle, low, low}));
  EXPECT_EQ(out.x_last, image.x_last);
  EXPECT_EQ(out.y_last, image.y_last);
}

TEST(FittedImage, TakesTheLargestValueOrOfDivergingMapsTheOneFurthestFromZero) {
  FigureImage image = image_of(3, 1, middle);
  image.cells[2] = low;
  EXPECT_EQ(fitted(image, bar_from(-1.0, 1.0), 1, 1).cells.front(), middle);
  EXPECT_EQ(fitted(image, bar_from(-1.0, 1.0, ColourMapKind::diverging), 1, 1).cells.front(), low);
  EXPECT_EQ(fitted(image, bar_from(0.0, 1.0, ColourMapKind::diverging), 1, 1).cells.front(), middle);
}

TEST(FittedImage, TakesTheFirstWhereNoValueIsStronger) {
  FigureImage image = image_of(3, 1, middle);
  image.cells[2] = high;
  EXPECT_EQ(fitted(image, bar_from(-180.0, 180.0, ColourMapKind::cyclic), 1, 1).cells.front(), middle);
  EXPECT_EQ(fitted(image, std::nullopt, 1, 1).cells.front(), middle);
}

TEST(FittedImage, TakesAnyColourOfTheBarBeforeOneThatIsNotInIt) {
  FigureImage image = image_of(2, 1, foreign);
  image.cells[1] = low;
  EXPECT_EQ(fitted(image, bar_from(-50.0, 0.0), 1, 1).cells.front(), low);
}

TEST(FittedImage, NeedsADot) {
  EXPECT_THROW(static_cast<void>(fitted(image_of(1, 1, low), std::nullopt, 0, 1)), std::invalid_argument);
}

}  // namespace

}  // namespace sarsim::picture::fitted_image_test
