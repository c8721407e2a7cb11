#include "radar/atmosphere/refractivity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace refractivity_test {

constexpr double radius_m = mean_earth_radius_m;
constexpr double flat = std::numeric_limits<double>::infinity();
using Real = long double;

// 1e-6 integral N ds by Simpson's rule in 80 bits, its steps short near the lower end; heights by the cosine rule.
template <class Air>
double by_simpson(const Air& air, const StraightPath& path) {
  const Real r1 = radius_m + std::min(path.height_a_m, path.height_b_m);
  const Real r2 = radius_m + std::max(path.height_a_m, path.height_b_m);
  const Real d = path.distance_m, along = (r2 * r2 - r1 * r1 - d * d) / (2.0L * d);
  constexpr int panels = 60'000;
  Real sum = 0.0L;
  for (int i = 0; i <= panels; ++i) {
    const Real t = static_cast<Real>(i) / panels, s = d * t * t * t;
    const Real h = (2.0L * along * s + s * s) / (std::sqrt(r1 * r1 + 2.0L * along * s + s * s) + r1) + (r1 - radius_m);
    const Real weight = i == 0 || i == panels ? 1.0L : (i % 2 == 1 ? 4.0L : 2.0L);
    sum += weight * air.value(static_cast<double>(h)) * 3.0L * d * t * t;
  }
  return static_cast<double>(1e-6L * sum / panels / 3.0L);
}

// A ray by Snell's law for spheres, n r cos(elevation) constant: optical length and angle at the centre, by Simpson's
// rule in the root of the height.
struct Ray {
  Real optical_m = 0.0L;
  Real angle_rad = 0.0L;
};

Ray trace(const ExponentialRefractivity& air, Real apparent_rad, Real top_m) {
  const auto index = [&](Real h) { return 1.0L + 1e-6L * air.surface * std::exp(-h / air.scale_height_m); };
  const Real constant = index(0.0L) * radius_m * std::cos(apparent_rad);
  constexpr int panels = 10'000;
  Ray ray;
  for (int i = 0; i <= panels; ++i) {
    const Real x = static_cast<Real>(i) / panels, root = std::sqrt(top_m) * x * x;  // h = top x^4
    const Real h = root * root, step = 4.0L * top_m * x * x * x / panels / 3.0L;
    const Real nr = index(h) * (radius_m + h);
    const Real weight = (i == 0 || i == panels ? 1.0L : (i % 2 == 1 ? 4.0L : 2.0L)) * step;
    const Real sine_nr = std::sqrt((nr - constant) * (nr + constant));
    ray.optical_m += weight * index(h) * nr / sine_nr;
    ray.angle_rad += weight * constant / (sine_nr * (radius_m + h));
  }
  return ray;
}

// Straight less bent for the ray that leaves at an apparent elevation, with the path between its ends.
struct Bent {
  StraightPath path;
  double too_long_m = 0.0;
};

Bent bent(double apparent_rad, double top_m) {
  const ExponentialRefractivity air;
  const Ray ray = trace(air, apparent_rad, top_m);
  const Real half = std::sin(0.5L * ray.angle_rad);
  const Real d = std::sqrt(static_cast<Real>(top_m) * top_m + 4.0L * radius_m * (radius_m + top_m) * half * half);
  const StraightPath path{0.0, top_m, static_cast<double>(d), radius_m};
  return {path, excess_path_m(air, path) - static_cast<double>(ray.optical_m - d)};
}

// The same at a true elevation, found by the secant rule.
Bent bent_at_true(double true_rad, double top_m) {
  double apparent_rad = true_rad + 0.003;
  for (int i = 0; i < 12; ++i) apparent_rad += true_rad - low_elevation_rad(bent(apparent_rad, top_m).path);
  return bent(apparent_rad, top_m);
}

TEST(ExponentialRefractivity, HasTheNumbersOfTheSpecification) {
  const ExponentialRefractivity air;
  EXPECT_NEAR(1e3 * air.gradient_at_per_m(0.0), -42.9, 0.05);
  EXPECT_NEAR(k_factor(air.gradient_at_per_m(0.0)), 1.376, 5e-4);
  EXPECT_NEAR(1e3 * gradient_of_k_per_m(4.0 / 3.0), -39.24, 5e-3);
  EXPECT_NEAR(k_factor(gradient_of_k_per_m(1.7)), 1.7, 1e-12);
  EXPECT_NEAR(air.value(7350.0), 315.0 / std::exp(1.0), 1e-10);
}

// Against rays traced by Snell's law.
TEST(BendingGain, IsWhatTheStraightLineIsTooLong) {
  const ExponentialRefractivity air;
  for (const double top_m : {3000.0, 10e3, 700e3})
    for (const double elevation_deg : {2.0, 5.0, 7.3, 10.0, 20.0, 30.0}) {
      const Bent ray = bent_at_true(elevation_deg * core::rad_per_deg, top_m);
      const double share = elevation_deg < 5.0 ? 0.25 : 0.05;
      EXPECT_NEAR(bending_gain_m(air, ray.path), ray.too_long_m, share * ray.too_long_m)
          << top_m << ' ' << elevation_deg;
    }
  EXPECT_NEAR(bending_gain_m(air, {0.0, 700e3, 700e3, radius_m}), 0.0, 1e-30);
}

// With an even gradient the angle is linear: 1/2 integral theta^2 = (N' cos e)^2 L^3/24.
TEST(BendingGain, OfAnEvenGradientIsAClosedForm) {
  const LinearRefractivity air;
  const double bend = 39.24e-9 * 8.0 / 10.0;
  EXPECT_NEAR(bending_gain_m(air, {0.0, 6000.0, 10e3, flat}), bend * bend * 1e12 / 24.0,
              1e-5 * bend * bend * 1e12 / 24.0);
  EXPECT_NEAR(bending_gain_m(air, {3000.0, 3000.0, 100e3, flat}), 39.24e-9 * 39.24e-9 * 1e15 / 24.0, 1e-6);
}

TEST(ExcessPath, IsTheClosedFormAtTheZenith) {
  const ExponentialRefractivity air;
  const auto path = path_at_elevation(0.0, core::pi / 2.0, 700e3, radius_m);
  EXPECT_NEAR(excess_path_m(air, *path), 2.315, 5e-4);
  EXPECT_NEAR(excess_path_m(air, *path), 315e-6 * 7350.0, 1e-13);
  EXPECT_NEAR(excess_path_m(air, {2000.0, 9000.0, 7000.0, radius_m}),
              1e-6 * 7350.0 * (air.value(2000.0) - air.value(9000.0)), 1e-14);
}

TEST(ExcessPath, IsTheClosedFormOverTheFlatEarth) {
  const ExponentialRefractivity air;
  EXPECT_NEAR(excess_path_m(air, {0.0, 3000.0, 6000.0, flat}), 2.0 * 2.31525 * -std::expm1(-3000.0 / 7350.0), 1e-14);
  EXPECT_NEAR(excess_path_m(air, {500.0, 500.0, 6000.0, flat}), 6e-3 * air.value(500.0), 1e-15);
  EXPECT_NEAR(excess_path_m(air, {500.0, 500.0 + 1e-7, 6000.0, flat}), 6e-3 * air.value(500.0), 2e-11);
  // A sphere of 1e14 m is flat.
  EXPECT_NEAR(excess_path_m(air, {0.0, 3000.0, 6000.0, 1e14}), excess_path_m(air, {0.0, 3000.0, 6000.0, flat}), 1e-9);
}

TEST(ExcessPath, IsTheIntegralOverTheSphere) {
  const ExponentialRefractivity air;
  for (const double top_m : {100.0, 3000.0, 12e3, 700e3})
    for (const double elevation_deg : {0.5, 1.0, 5.0, 20.0, 60.0, 90.0}) {
      const auto path = path_at_elevation(0.0, elevation_deg * core::rad_per_deg, top_m, radius_m);
      const double truth_m = by_simpson(air, *path);
      EXPECT_NEAR(excess_path_m(air, *path), truth_m, 1e-10 * truth_m) << top_m << ' ' << elevation_deg;
    }
  for (const StraightPath& path :
       {StraightPath{3000.0, 9000.0, 30e3, radius_m}, StraightPath{8000.0, 8000.0, 300e3, radius_m},
        StraightPath{8000.0, 11000.0, 500e3, radius_m}, StraightPath{36e6, -50.0, 41e6, radius_m}})
    EXPECT_NEAR(excess_path_m(air, path), by_simpson(air, path), 1e-9 * by_simpson(air, path));
}

TEST(ExcessPath, AddsUpAlongALine) {
  const ExponentialRefractivity air;
  const Climb whole = climb_of({8000.0, 11000.0, 500e3, radius_m});
  for (const double share : {0.1, 0.4, 0.45, 0.7}) {
    const double s = share * 500e3, middle_m = whole.height_at(s);
    const double sum_m = excess_path_m(air, {8000.0, middle_m, s, radius_m}) +
                         excess_path_m(air, {middle_m, 11000.0, 500e3 - s, radius_m});
    EXPECT_NEAR(sum_m, excess_path_m(air, {8000.0, 11000.0, 500e3, radius_m}), 1e-10);
  }
}

TEST(ExcessPath, FallsWithElevationAndHeightAndKnowsNoDirection) {
  const ExponentialRefractivity air;
  double last_m = 1e9;
  for (int i = 1; i <= 180; ++i) {
    const auto path = path_at_elevation(0.0, 0.5 * i * core::rad_per_deg, 700e3, radius_m);
    const double excess_m = excess_path_m(air, *path);
    EXPECT_LT(excess_m, last_m);
    EXPECT_EQ(excess_m, excess_path_m(air, {path->height_b_m, path->height_a_m, path->distance_m, radius_m}));
    last_m = excess_m;
  }
  EXPECT_LT(excess_path_m(air, *path_at_elevation(1000.0, 0.3, 700e3, radius_m)),
            excess_path_m(air, *path_at_elevation(0.0, 0.3, 700e3, radius_m)));
  EXPECT_EQ(excess_path_m(air, {5.0, 5.0, 0.0, radius_m}), 0.0);
}

TEST(ExcessPath, OfTheLinearModelEndsWhereItsAirEnds) {
  const LinearRefractivity air{315.0, gradient_of_k_per_m(4.0 / 3.0)};
  const double column_m = 0.5e-6 * 315.0 * air.top_m();  // a triangle
  EXPECT_NEAR(air.top_m(), 8028.0, 1.0);
  EXPECT_NEAR(excess_path_m(air, *path_at_elevation(0.0, core::pi / 2.0, 700e3, radius_m)), column_m, 1e-12);
  EXPECT_NEAR(excess_path_m(air, {0.0, 16e3, 32e3, flat}), 2.0 * column_m, 1e-12);
  EXPECT_EQ(excess_path_m(air, {9000.0, 700e3, 800e3, radius_m}), 0.0);
  EXPECT_GT(excess_path_m(air, {9000.0, 9000.0, 400e3, radius_m}), 0.0);  // dips into it
  for (const StraightPath& path : {StraightPath{0.0, 7000.0, 250e3, radius_m}, StraightPath{7e3, 7e3, 250e3, radius_m}})
    EXPECT_NEAR(excess_path_m(air, path), by_simpson(air, path), 1e-10);
}

// Straight less bent at true elevations, the table of the header.
TEST(StraightPath, IsLongerThanTheRayByTheTableOfTheHeader) {
  struct Row {
    double top_m;
    std::array<double, 5> too_long_m;
  };
  constexpr std::array<double, 5> elevations_deg{0.5, 2.0, 5.0, 10.0, 30.0};
  for (const auto& [top_m, expected_m] :
       {Row{3e3, {0.18, 0.021, 0.0019, 2.5e-4, 8.3e-6}}, Row{10e3, {0.91, 0.20, 0.027, 3.9e-3, 1.3e-4}},
        Row{700e3, {3.28, 0.97, 0.17, 0.029, 1.05e-3}}})
    for (std::size_t i = 0; i < elevations_deg.size(); ++i) {
      const Bent ray = bent_at_true(elevations_deg[i] * core::rad_per_deg, top_m);
      EXPECT_NEAR(ray.too_long_m, expected_m[i], 0.035 * expected_m[i]) << top_m << ' ' << elevations_deg[i];
    }
}

}  // namespace refractivity_test
}  // namespace sarsim::radar
