#include "signal/stepped/stepped_overlay.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "core/maths/sinc.hpp"

namespace sarsim::signal {
namespace stepped_overlay_test {

constexpr ImagePlace cell{1.0, 1.0};

// Points a whole number of cells apart, so that none disturbs another's peak.
std::vector<OverlayPoint> four_points() {
  return {{{0.0, 0.0}, 1.0}, {{6.0, 0.0}, 1.0}, {{-6.0, 1.0}, 0.7}, {{2.0, -2.0}, 0.5}};
}

// What shows them, moved: two samples for each cell.
FocusedImage image_of(const std::vector<OverlayPoint>& points, const ImagePlace& shift) {
  FocusedImage image;
  image.azimuth = {-16.0, 0.5, 65};
  image.range = {-16.0, 0.5, 65};
  for (std::size_t r = 0; r < 65; ++r)
    for (std::size_t c = 0; c < 65; ++c) {
      double sum = 0.0;
      for (const OverlayPoint& point : points)
        sum += point.amplitude *
               core::sinc(image.azimuth.at(static_cast<double>(r)) - point.place.azimuth_m - shift.azimuth_m) *
               core::sinc(image.range.at(static_cast<double>(c)) - point.place.range_m - shift.range_m);
      image.values.emplace_back(static_cast<float>(sum), 0.0F);
    }
  return image;
}

// The side lobes of the others pull a peak by up to a twentieth of a cell.
void expect_shift(const FocusedImage& image, const std::vector<OverlayPoint>& points, const ImagePlace& expected) {
  const auto shift = shift_upon_image(image, points, cell);
  ASSERT_TRUE(shift);
  EXPECT_NEAR(shift->azimuth_m, expected.azimuth_m, 0.1);
  EXPECT_NEAR(shift->range_m, expected.range_m, 0.1);
}

TEST(ShiftUponImage, IsRightWhicheverOfTwoEqualPointsIsTheStrongerInTheImage) {
  const ImagePlace moved{2.3, -3.6};
  for (const std::size_t stronger : {0U, 1U}) {
    std::vector<OverlayPoint> shown = four_points();
    shown[stronger].amplitude *= 1.02;
    expect_shift(image_of(shown, moved), four_points(), moved);
  }
}

TEST(ShiftUponImage, DoesNotDependOnTheOrderOfThePoints) {
  const ImagePlace moved{-1.2, 4.3};
  std::vector<OverlayPoint> points = four_points();
  std::swap(points[0], points[1]);
  expect_shift(image_of(four_points(), moved), points, moved);
}

TEST(ShiftUponImage, IsRightThoughTheStrongestPointIsOutsideTheImage) {
  const ImagePlace moved{2.3, -3.6};
  std::vector<OverlayPoint> points = four_points();
  points.insert(points.begin(), {{40.0, 0.0}, 2.0});
  expect_shift(image_of(four_points(), moved), points, moved);
}

TEST(ShiftUponImage, IsRightThoughTheImageShowsSomethingStrongerThanAnyPoint) {
  const ImagePlace moved{2.3, -3.6};
  std::vector<OverlayPoint> shown = four_points();
  shown.push_back({{-10.0, 10.0}, 3.0});
  expect_shift(image_of(shown, moved), four_points(), moved);
}

TEST(ShiftUponImage, IsThatOfTheOnlyPoint) {
  const ImagePlace moved{-9.7, 7.1};
  const std::vector<OverlayPoint> point{{{1.0, 2.0}, 0.01}};
  expect_shift(image_of(point, moved), point, moved);
}

TEST(ShiftUponImage, IsNoneOfAnEmptyImageOrWithoutPoints) {
  FocusedImage image = image_of(four_points(), {});
  EXPECT_FALSE(shift_upon_image(image, {}, cell));
  EXPECT_FALSE(shift_upon_image(image, std::array{OverlayPoint{}}, cell));
  image.values.assign(image.values.size(), {});
  EXPECT_FALSE(shift_upon_image(image, four_points(), cell));
  EXPECT_FALSE(shift_upon_image({}, four_points(), cell));
}

}  // namespace stepped_overlay_test
}  // namespace sarsim::signal
