#include "workflow/focus/navigation_check.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::workflow {
namespace navigation_check_test {

using testing::HasSubstr;

constexpr double farthest_m = 3000.0;

template <class Position>
std::vector<signal::TrackPoint> track(const Position& position_at) {
  std::vector<signal::TrackPoint> points;
  for (int i = -100; i <= 100; ++i) {
    signal::TrackPoint& point = points.emplace_back();
    point.time_s = 0.01 * i;
    point.position_m = position_at(point.time_s);
  }
  return points;
}

std::vector<signal::TrackPoint> flown() {
  return track([](double t) { return core::Vec3{100.0 * t, -2500.0, 1500.0}; });
}

std::string told(const std::vector<signal::TrackPoint>& believed,
                 const std::vector<signal::TrackPoint>& recorded = flown()) {
  std::string all;
  for (const core::Problem& problem : problems_of_navigation("n.csv", recorded, believed, farthest_m))
    all += core::to_string(problem) + "\n";
  return all;
}

// Errors of navigation systems: metres of offset, drifts of centimetres a second, slow oscillations.
TEST(NavigationCheck, IsSilentOnErrorsOfNavigation) {
  std::mt19937 engine(54);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    const core::Vec3 offset{10.0 * draw(engine), 10.0 * draw(engine), 10.0 * draw(engine)};
    const core::Vec3 drift{0.3 * draw(engine), 0.3 * draw(engine), 0.3 * draw(engine)};
    const double sway = 0.1 * draw(engine), rate = 3.0 + draw(engine);
    EXPECT_EQ(told(track([&](double t) {
                return core::Vec3{100.0 * t, -2500.0 + sway * std::sin(rate * t), 1500.0} + offset + t * drift;
              })),
              "");
  }
}

TEST(NavigationCheck, RefusesWhatIsNotOfThisRecording) {
  const std::string back = told(track([](double t) { return core::Vec3{-100.0 * t, -2500.0, 1500.0}; }));
  EXPECT_THAT(back, HasSubstr("error: n.csv: the navigation flies in another direction"));
  EXPECT_THAT(back, HasSubstr("180 deg off"));
  const std::string away = told(track([](double t) { return core::Vec3{100.0 * t, 1e18, 1500.0}; }));
  EXPECT_THAT(away, HasSubstr("error: n.csv: the navigation is far from the track of the recording; found '1e+18 m"));
  const std::string other_unit = told(track([](double t) { return core::Vec3{0.1 * t, -2.5, 1.5}; }));
  EXPECT_THAT(other_unit,
              HasSubstr("error: n.csv: the navigation track has another length than that of the recording"));
  EXPECT_THAT(told(track([](double) { return core::Vec3{0.0, -2500.0, 1500.0}; })), HasSubstr("error"));
  EXPECT_THAT(told(track([](double t) { return core::Vec3{100.0 * t, std::nan(""), 1500.0}; })), HasSubstr("error"));
}

TEST(NavigationCheck, WarnsWithTheNumber) {
  EXPECT_THAT(told(track([](double t) {
                return core::Vec3{100.0 * t + 200.0, -2500.0, 1500.0};
              })),
              HasSubstr("warning: n.csv: the navigation is far from the track of the recording; found '200 m away"));
  EXPECT_THAT(
      told(track([](double t) {
        return core::Vec3{105.0 * t, -2500.0, 1500.0};
      })),
      HasSubstr(
          "warning: n.csv: the navigation track has another length than that of the recording; found '210 m long'"));
  EXPECT_THAT(
      told(track([](double t) {
        return core::Vec3{100.0 * t, -2500.0 + 5.0 * t, 1500.0};
      })),
      HasSubstr("warning: n.csv: the navigation flies in another direction than the recording; found '2.86 deg"));
}

// The way around a circle ends where it began; a radar at rest goes no way at all.
TEST(NavigationCheck, ComparesCirclesAndRest) {
  const auto circle = [](double sense, double offset_m) {
    return track([=](double t) {
      return core::Vec3{1000.0 * std::cos(sense * core::pi * t) + offset_m, 1000.0 * std::sin(sense * core::pi * t),
                        1500.0};
    });
  };
  EXPECT_EQ(told(circle(1.0, 5.0), circle(1.0, 0.0)), "");
  EXPECT_THAT(told(circle(-1.0, 0.0), circle(1.0, 0.0)), HasSubstr("far from the track"));
  const auto rest = [](double offset_m) { return track([=](double) { return core::Vec3{offset_m, 0.0, 10.0}; }); };
  EXPECT_EQ(told(rest(0.5), rest(0.0)), "");
}

}  // namespace navigation_check_test
}  // namespace sarsim::workflow
