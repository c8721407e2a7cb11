#include "radar/earth/geoid_grid.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "radar/earth/geoid_test_support.hpp"
#include "radar/earth/read_geoid.hpp"

namespace sarsim::radar {
namespace geoid_grid_test {

using core::rad_per_deg;

constexpr float none = std::numeric_limits<float>::quiet_NaN();

GeoidGrid grid_of(const GeoidLattice& lattice, std::vector<float> values) {
  std::variant<GeoidGrid, core::Problem> made = GeoidGrid::from(lattice, std::move(values));
  if (const auto* const problem = std::get_if<core::Problem>(&made)) ADD_FAILURE() << core::to_string(*problem);
  return std::get<GeoidGrid>(std::move(made));
}

core::Problem problem_of(const GeoidLattice& lattice, GeoidValues values) {
  const std::variant<GeoidGrid, core::Problem> made = GeoidGrid::from(lattice, std::move(values));
  const auto* const problem = std::get_if<core::Problem>(&made);
  EXPECT_NE(problem, nullptr);
  return problem == nullptr ? core::Problem{} : *problem;
}

std::optional<double> at(const GeoidGrid& grid, double latitude_deg, double longitude_deg) {
  return grid.undulation_m(latitude_deg * rad_per_deg, longitude_deg * rad_per_deg);
}

TEST(GeoidGrid, AgreesWithGeographicLib) {
  // By GeographicLib 2.1.2, Geoid with cubic = false, from the same bytes; its offset is added to levels in metres.
  constexpr std::array<std::array<double, 3>, 16> expected{{{90, 0, -70.9650000000},
                                                            {90, 123, -70.9650000000},
                                                            {89.5, -17, -69.3070550000},
                                                            {75, 15, -51.5812500000},
                                                            {60, 30, -17.1870000000},
                                                            {45.25, 359.9, -35.4042836667},
                                                            {10, -0.1, -7.8229500000},
                                                            {0, 0, 0.3060000000},
                                                            {-12.5, 180, -6.2772500000},
                                                            {-12.5, -180, -6.2772500000},
                                                            {-33.95, 18.46, 45.6639270000},
                                                            {-61, 345, 18.1691500000},
                                                            {-61, 330.001, -12.2715704833},
                                                            {-89.99, 77, 71.5292296333},
                                                            {-90, 0, 71.5770000000},
                                                            {27.99, 86.93, 53.3068439840}}};
  const auto reading = read_geoid_pgm(geoid_test::pgm_bytes(), "small.pgm");
  const auto* const grid = std::get_if<GeoidGrid>(&reading);
  ASSERT_NE(grid, nullptr);
  for (const auto& [latitude, longitude, undulation_m] : expected)
    for (const double turn : {-360.0, 0.0, 720.0}) {
      const std::optional<double> found = at(*grid, latitude, longitude + turn);
      ASSERT_TRUE(found) << latitude << ' ' << longitude;
      EXPECT_NEAR(*found, undulation_m, 1e-9) << latitude << ' ' << longitude;
    }
}

TEST(GeoidGrid, IsBilinearBetweenNodes) {
  const GeoidGrid grid = grid_of({10.0, 1.0, 20.0, 2.0, 3, 2}, {1.0F, 2.0F, 3.0F, 8.0F, 5.0F, 5.0F});
  EXPECT_NEAR(*at(grid, 10.0, 20.0), 1.0, 1e-12);
  EXPECT_NEAR(*at(grid, 10.0, 21.0), 1.5, 1e-12);
  EXPECT_NEAR(*at(grid, 10.5, 20.5), 0.5 * 1.25 + 0.5 * 4.25, 1e-12);
  EXPECT_NEAR(*at(grid, 11.75, 22.0), 0.25 * 8.0 + 0.75 * 5.0, 1e-12);
  EXPECT_NEAR(*at(grid, 12.0, 22.0), 5.0, 1e-12);
}

TEST(GeoidGrid, SaysNothingOutsideOfARegion) {
  const GeoidGrid grid = grid_of({10.0, 1.0, 350.0, 2.0, 2, 11}, std::vector<float>(22, 7.0F));
  EXPECT_FALSE(grid.is_ring());
  for (const double longitude : {350.0, -10.0, -5.0, 0.0, 10.0, 370.0}) EXPECT_TRUE(at(grid, 10.5, longitude));
  for (const double longitude : {349.999, -10.001, 10.001, 180.0, 10.001 + 3600.0})
    EXPECT_FALSE(at(grid, 10.5, longitude)) << longitude;
  EXPECT_FALSE(at(grid, 9.999, 0.0));
  EXPECT_FALSE(at(grid, 11.001, 0.0));
  EXPECT_FALSE(at(grid, 90.001, 0.0));
  EXPECT_FALSE(at(grid, std::nan(""), 0.0));
  EXPECT_FALSE(at(grid, 10.5, std::nan("")));
  EXPECT_FALSE(at(grid, 10.5, std::numeric_limits<double>::infinity()));
}

TEST(GeoidGrid, SaysNothingWhereANodeThatCountsHasNoValue) {
  const GeoidGrid grid = grid_of({0.0, 1.0, 0.0, 1.0, 2, 3}, {1.0F, 2.0F, none, 3.0F, 4.0F, 5.0F});
  EXPECT_TRUE(at(grid, 0.5, 0.5));
  EXPECT_FALSE(at(grid, 0.5, 1.5));
  EXPECT_FALSE(at(grid, 0.0, 2.0));
  // The missing node has no weight.
  EXPECT_NEAR(*at(grid, 1.0, 1.5), 4.5, 1e-12);
  EXPECT_NEAR(*at(grid, 0.5, 1.0), 3.0, 1e-12);
}

TEST(GeoidGrid, ClosesAroundTheEarth) {
  // Once with the first column repeated, once without; from -180 and from 0.
  const std::vector<float> once{1.0F, 2.0F, 3.0F, 4.0F, 1.0F, 2.0F, 3.0F, 4.0F};
  const std::vector<float> repeated{1.0F, 2.0F, 3.0F, 4.0F, 1.0F, 1.0F, 2.0F, 3.0F, 4.0F, 1.0F};
  for (const double first : {-180.0, 0.0}) {
    const GeoidGrid a = grid_of({-10.0, 20.0, first, 90.0, 2, 4}, once);
    const GeoidGrid b = grid_of({-10.0, 20.0, first, 90.0, 2, 5}, repeated);
    EXPECT_TRUE(a.is_ring());
    EXPECT_TRUE(b.is_ring());
    for (double longitude = -720.0; longitude <= 720.0; longitude += 7.5) {
      ASSERT_TRUE(at(a, 0.0, longitude));
      EXPECT_NEAR(*at(a, 0.0, longitude), *at(b, 0.0, longitude), 1e-12);
    }
    EXPECT_NEAR(*at(a, 0.0, first + 315.0), 2.5, 1e-12);
    EXPECT_FALSE(at(a, 10.1, 0.0));
  }
  // A step printed with few digits.
  const GeoidGrid rough = grid_of({0.0, 1.0, 0.0, 0.0166667, 2, 21600}, std::vector<float>(43200, 2.0F));
  EXPECT_TRUE(rough.is_ring());
  EXPECT_EQ(rough.lattice().longitude_step_deg, 360.0 / 21600.0);
  EXPECT_TRUE(at(rough, 0.5, 359.99999));
}

TEST(GeoidGrid, ReachesThePolesFromCells) {
  // Centres at +-60 and 0 deg: the last rows lie half a step from the poles.
  const std::vector<float> values{1.0F, 3.0F, 5.0F, 7.0F, 0.0F, 0.0F, 0.0F, 0.0F, 10.0F, 10.0F, 30.0F, 30.0F};
  const GeoidGrid grid = grid_of({60.0, -60.0, 45.0, 90.0, 3, 4}, values);
  for (const double longitude : {0.0, 45.0, 200.0, -10.0}) {
    EXPECT_NEAR(*at(grid, 90.0, longitude), 4.0, 1e-12);
    EXPECT_NEAR(*at(grid, -90.0, longitude), 20.0, 1e-12);
  }
  EXPECT_NEAR(*at(grid, 75.0, 45.0), 0.5 * (1.0 + 4.0), 1e-12);
  EXPECT_NEAR(*at(grid, -80.0, 315.0), 30.0 - 10.0 * 2.0 / 3.0, 1e-12);
  // Not where one of the row has no value, and not in a region.
  std::vector<float> holed = values;
  holed[1] = none;
  EXPECT_FALSE(at(grid_of({60.0, -60.0, 45.0, 90.0, 3, 4}, holed), 75.0, 45.0));
  EXPECT_TRUE(at(grid_of({60.0, -60.0, 45.0, 90.0, 3, 4}, holed), 60.0, 45.0));
  EXPECT_FALSE(at(grid_of({60.0, -60.0, 45.0, 30.0, 3, 4}, values), 75.0, 45.0));
}

TEST(GeoidGrid, RefusesWhatIsNoGrid) {
  const std::vector<float> four(4, 1.0F);
  EXPECT_EQ(problem_of({0.0, 1.0, 0.0, 1.0, 1, 4}, four).message, "the grid of the geoid is too small");
  EXPECT_EQ(problem_of({0.0, 1.0, 0.0, 1.0, 4, 1}, four).message, "the grid of the geoid is too small");
  EXPECT_EQ(problem_of({std::nan(""), 1.0, 0.0, 1.0, 2, 2}, four).message, "the place of the grid is not known");
  EXPECT_EQ(problem_of({0.0, 0.0, 0.0, 1.0, 2, 2}, four).message, "the grid of the geoid has no step");
  EXPECT_EQ(problem_of({0.0, 1.0, 0.0, -1.0, 2, 2}, four).message, "the grid of the geoid has no step");
  EXPECT_EQ(problem_of({80.0, 11.2, 0.0, 1.0, 2, 2}, four).message, "the rows of the grid reach beyond a pole");
  EXPECT_EQ(problem_of({-80.0, -12.0, 0.0, 1.0, 2, 2}, four).message, "the rows of the grid reach beyond a pole");
  EXPECT_EQ(problem_of({0.0, 1.0, 0.0, 400.0, 2, 2}, four).message,
            "the columns of the grid go around the Earth more than once");
  EXPECT_EQ(problem_of({0.0, 1.0, 0.0, 1.0, 2, 3}, four).message, "the grid has another number of values than nodes");
  const core::Problem high = problem_of({0.0, 1.0, 0.0, 1.0, 2, 2}, std::vector<float>{1.0F, 1.0F, 1.0F, -1001.0F});
  EXPECT_EQ(high.message, "no geoid is so high (row 2, column 2)");
  EXPECT_EQ(high.found, "-1001 m");
  EXPECT_EQ(problem_of({0.0, 1.0, 0.0, 1.0, 2, 2}, GeoidSteps{0.0, 1.0, {0, 0, 5000, 0}}).found, "5000 m");
  EXPECT_EQ(problem_of({0.0, 1.0, 0.0, 1.0, 2, 2}, GeoidSteps{std::nan(""), 1.0, {0, 0, 0, 0}}).message,
            "no geoid is so high (row 1, column 1)");
}

}  // namespace geoid_grid_test
}  // namespace sarsim::radar
