// Random deviations of targets, pulse by pulse.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace jitter_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int pulses = 20'000;

// Views of target `index` by the first `pulses` pulses.
std::vector<ScattererView> views_of(const scene::Scene& scene, std::size_t index = 0, int count = pulses) {
  const ResolvedScene resolved = resolve(scene);
  const Link radar = resolve_radar(scene, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  std::vector<ScattererView> views;
  for (int p = 0; p < count; ++p) {
    geometry.set_pulse(p);
    views.push_back(geometry.view(index));
  }
  return views;
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
  double neighbours = 0.0;  // correlation of successive values
};

template <class Value>
Moments moments(const std::vector<ScattererView>& views, const Value& value) {
  Moments m;
  const auto n = static_cast<double>(views.size());
  for (const auto& v : views) m.mean += value(v) / n;
  for (std::size_t i = 0; i < views.size(); ++i) {
    m.variance += std::pow(value(views[i]) - m.mean, 2.0) / n;
    if (i > 0) m.neighbours += (value(views[i]) - m.mean) * (value(views[i - 1]) - m.mean) / n;
  }
  m.neighbours /= m.variance;
  return m;
}

TEST(Jitter, RcsIsDrawnAnewForEveryPulseWithTheGivenDeviation) {
  scene::Scene scene = one_target_scene();
  scene.targets[0].rcs_m2 = 10.0;
  scene.targets[0].traits.edit().rcs_stddev_m2 = 1.5;
  const double unit = equation_amplitude(1000.0, 1.0, core::exact_light_speed_mps / 1e9);
  const Moments rcs =
      moments(views_of(scene), [&](const ScattererView& v) { return std::pow(v.amplitude_sqrt_w / unit, 2.0); });
  EXPECT_NEAR(rcs.mean, 10.0, 5.0 * 1.5 / std::sqrt(pulses));
  EXPECT_NEAR(rcs.variance, 2.25, 5.0 * 2.25 * std::sqrt(2.0 / pulses));
  EXPECT_NEAR(rcs.neighbours, 0.0, 5.0 / std::sqrt(pulses));
}

// Half of the draws are below 0; the others have the mean of half a normal distribution.
TEST(Jitter, NegativeRcsIsClippedToNothing) {
  scene::Scene scene = one_target_scene();
  scene.targets[0].rcs_m2 = 0.0;
  scene.targets[0].traits.edit().rcs_stddev_m2 = 2.0;
  const double unit = equation_amplitude(1000.0, 1.0, core::exact_light_speed_mps / 1e9);
  int silent = 0;
  double mean = 0.0;
  for (const ScattererView& v : views_of(scene)) {
    silent += v.amplitude_sqrt_w == 0.0;
    mean += std::pow(v.amplitude_sqrt_w / unit, 2.0) / pulses;
  }
  EXPECT_NEAR(silent, 0.5 * pulses, 5.0 * 0.5 * std::sqrt(pulses));
  EXPECT_NEAR(mean, 2.0 / std::sqrt(2.0 * core::pi), 5.0 * 2.0 / std::sqrt(pulses));
}

TEST(Jitter, MovesPositionsAlongEachAxisByItsOwnDeviation) {
  for (const core::Vec3& axis : {core::Vec3{1, 0, 0}, core::Vec3{0, 1, 0}, core::Vec3{0, 0, 1}}) {
    scene::Scene scene = one_target_scene();
    scene.targets[0].position_m = 1000.0 * axis;
    scene.targets[0].traits.edit().position_stddev_m = 0.3 * axis;
    const Moments distance = moments(views_of(scene), [](const ScattererView& v) { return v.distance_m; });
    EXPECT_NEAR(distance.mean, 1000.0, 5.0 * 0.3 / std::sqrt(pulses));
    EXPECT_NEAR(distance.variance, 0.09, 5.0 * 0.09 * std::sqrt(2.0 / pulses));
    EXPECT_NEAR(distance.neighbours, 0.0, 5.0 / std::sqrt(pulses));
  }
}

// Across the line of sight by 0.3 m at 1 km the radial part of a sideways speed changes by 0.3/1000, no more.
TEST(Jitter, LeavesSpeedsAlone) {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Car", {1000, 0, 0}, {70, 0, 0}));
  scene.platforms.back().position_stddev_m = {0.3, 0.0, 0.0};
  scene.targets[0] = target_on("Car", {});
  scene.targets[0].traits.edit().position_stddev_m = {0.2, 0.0, 0.0};
  for (const ScattererView& v : views_of(scene, 0, 500)) EXPECT_NEAR(v.speed_mps, 70.0, 1e4 * epsilon);
}

// A plate facing the radar whose azimuth jitters by s: the mean cosine is exp(-s^2/2), its variance s^4/2, nearly.
TEST(Jitter, TurnsTheNormalsOfDirectionalTargets) {
  scene::Scene scene = one_target_scene();
  scene::Target& plate = scene.targets[0];
  plate.traits.edit().reflectivity = scene::Target::Reflectivity::directional;
  plate.traits.edit().azimuth = core::Angle::from_deg(-90.0);
  const double unit = equation_amplitude(1000.0, 1.0, core::exact_light_speed_mps / 1e9);
  constexpr double s = 0.2;
  const double sigma = s * s / std::sqrt(2.0);
  const auto cosine = [&](const ScattererView& v) { return std::pow(v.amplitude_sqrt_w / unit, 2.0); };
  plate.traits.edit().azimuth_stddev = core::Angle::from_rad(s);
  EXPECT_NEAR(moments(views_of(scene), cosine).mean, std::exp(-0.5 * s * s), 5.0 * sigma / std::sqrt(pulses));
  plate.traits.edit().elevation_stddev = core::Angle::from_rad(s);
  EXPECT_NEAR(moments(views_of(scene), cosine).mean, std::exp(-s * s), 5.0 * 1.5 * sigma / std::sqrt(pulses));
}

TEST(Jitter, OfOneTargetDoesNotChangeWhenOthersAreAdded) {
  scene::Scene scene = one_target_scene();
  scene.targets[0].traits.edit().position_stddev_m = {1, 1, 1};
  scene.targets[0].traits.edit().rcs_stddev_m2 = 0.1;
  const auto before = views_of(scene, 0, 50);
  scene::Target other = target_on("Earth", {300, 400, 0}, 5.0);
  other.traits.edit().position_stddev_m = {2, 2, 2};
  scene.targets.push_back(other);
  scene.surfaces.push_back({});
  scene::Platform extra = resting("Extra", {1, 2, 3});
  extra.position_stddev_m = {1, 1, 1};
  scene.platforms.insert(scene.platforms.begin(), extra);
  const auto after = views_of(scene, 0, 50);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].distance_m, before[i].distance_m);
    EXPECT_EQ(after[i].amplitude_sqrt_w, before[i].amplitude_sqrt_w);
  }
}

TEST(Jitter, OfTwoTargetsIsIndependentAndFollowsTheSeed) {
  scene::Scene scene = one_target_scene();
  scene.targets[0].traits.edit().position_stddev_m = {1, 0, 0};
  scene.targets.push_back(scene.targets[0]);
  const auto first = views_of(scene, 0), second = views_of(scene, 1);
  double product = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
    product += (first[i].distance_m - 1000.0) * (second[i].distance_m - 1000.0);
  EXPECT_NEAR(product / pulses, 0.0, 5.0 / std::sqrt(pulses));
  scene.options.seed = 2;
  EXPECT_NE(views_of(scene, 0, 1)[0].distance_m, first[0].distance_m);
}

}  // namespace jitter_test
}  // namespace sarsim::simulate
