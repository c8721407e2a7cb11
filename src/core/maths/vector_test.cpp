#include "core/maths/vector.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

namespace sarsim::core {
namespace vector_test {

using std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(Vec3, AddsAndScalesByCoordinate) {
  const Vec3 a{1.0, -2.0, 4.0};
  const Vec3 b{0.5, 8.0, -1.0};
  EXPECT_EQ(a + b, (Vec3{1.5, 6.0, 3.0}));
  EXPECT_EQ(a - b, (Vec3{0.5, -10.0, 5.0}));
  EXPECT_EQ(-a, (Vec3{-1.0, 2.0, -4.0}));
  EXPECT_EQ(2.0 * a, (Vec3{2.0, -4.0, 8.0}));
}

TEST(Vec3, HasTheDotProductOfItsCoordinates) {
  EXPECT_EQ(dot(Vec3{1.0, 2.0, 3.0}, Vec3{4.0, -5.0, 6.0}), 12.0);
  EXPECT_EQ(norm(Vec3{2.0, -3.0, 6.0}), 7.0);
}

TEST(Vec3, HasARightHandedCrossProduct) {
  const Vec3 x{1.0, 0.0, 0.0};
  const Vec3 y{0.0, 1.0, 0.0};
  const Vec3 z{0.0, 0.0, 1.0};
  EXPECT_EQ(cross(x, y), z);
  EXPECT_EQ(cross(y, z), x);
  EXPECT_EQ(cross(z, x), y);
  EXPECT_EQ(cross(y, x), -z);
}

TEST(Mat3, IsTheIdentityUnlessSaid) { EXPECT_EQ(Mat3() * (Vec3{1.0, 2.0, 3.0}), (Vec3{1.0, 2.0, 3.0})); }

const Mat3 some{{Vec3{1.0, 2.0, 3.0}, Vec3{4.0, 5.0, 6.0}, Vec3{7.0, 8.0, 10.0}}};

TEST(Mat3, MultipliesByRows) { EXPECT_EQ(some * (Vec3{1.0, -1.0, 2.0}), (Vec3{5.0, 11.0, 19.0})); }

TEST(Mat3, ExchangesRowsAndColumnsWhenTransposed) {
  EXPECT_EQ(transposed(some).row[0], (Vec3{1.0, 4.0, 7.0}));
  EXPECT_EQ(transposed(some).row[2], (Vec3{3.0, 6.0, 10.0}));
  EXPECT_EQ(transposed(transposed(some)), some);
}

// Small whole numbers: every product and sum is exact.
TEST(Mat3, ProductActsLikeOneAfterTheOther) {
  const Mat3 other{{Vec3{0.0, 1.0, -2.0}, Vec3{3.0, 0.0, 1.0}, Vec3{1.0, 1.0, 1.0}}};
  const Vec3 v{2.0, -3.0, 5.0};
  EXPECT_EQ((some * other) * v, some * (other * v));
  EXPECT_NE(some * other, other * some);
}

TEST(Mat3, AddsAndScalesByCoordinate) {
  const Vec3 v{2.0, -3.0, 5.0};
  EXPECT_EQ((some + 2.0 * some) * v, 3.0 * (some * v));
}

TEST(Azimuth, RunsFromYClockwiseTowardsX) {
  EXPECT_EQ(azimuth_rad({0.0, 1.0, 0.0}), 0.0);
  EXPECT_EQ(azimuth_rad({1.0, 0.0, 0.0}), pi / 2.0);
  EXPECT_EQ(azimuth_rad({0.0, -1.0, 0.0}), pi);
  EXPECT_EQ(azimuth_rad({-1.0, 0.0, 0.0}), -pi / 2.0);
  EXPECT_EQ(azimuth_rad({1.0, 1.0, 816.0}), pi / 4.0);
}

TEST(Azimuth, OfAVerticalVectorIsZero) {
  EXPECT_EQ(azimuth_rad({0.0, 0.0, 1.0}), 0.0);
  EXPECT_EQ(azimuth_rad({0.0, -0.0, -1.0}), 0.0);
  EXPECT_EQ(azimuth_rad({0.0, 0.0, 0.0}), 0.0);
}

TEST(Elevation, IsTheAngleAboveTheXYPlane) {
  EXPECT_EQ(elevation_rad({0.0, 0.0, 2.0}), pi / 2.0);
  EXPECT_EQ(elevation_rad({0.0, 0.0, -2.0}), -pi / 2.0);
  EXPECT_EQ(elevation_rad({3.0, 4.0, 5.0}), pi / 4.0);
  EXPECT_EQ(elevation_rad({3.0, 4.0, 0.0}), 0.0);
  EXPECT_EQ(elevation_rad({0.0, 0.0, 0.0}), 0.0);
}

// Four roundings of numbers up to pi on the way there and back; near the zenith the azimuth gets worse by 1/cos(el),
// which the range below holds at 10.
TEST(Direction, HasTheAzimuthAndElevationItWasMadeFrom) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> azimuth(-pi, pi);
  std::uniform_real_distribution<double> elevation(-1.47, 1.47);
  for (int i = 0; i < 10'000; ++i) {
    const double az = azimuth(random);
    const double el = elevation(random);
    const Vec3 unit = direction(az, el);
    EXPECT_NEAR(norm(unit), 1.0, 4.0 * epsilon);
    EXPECT_NEAR(elevation_rad(unit), el, 4.0 * pi * epsilon * 10.0);
    EXPECT_NEAR(azimuth_rad(unit), az, 4.0 * pi * epsilon * 10.0);
  }
}

}  // namespace vector_test
}  // namespace sarsim::core
