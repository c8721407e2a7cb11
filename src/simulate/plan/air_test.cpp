#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulate/plan/point_groups.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace air_test {

// A radar at 10 km that looks at targets of several heights, over a flat world or the Earth.
scene::Scene scene_below(bool earth) {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Aircraft", {0.0, 0.0, 10e3}, {100.0, 20.0, 0.0}));
  scene.radars[0].platform = "Aircraft";
  scene.targets.clear();
  for (int i = 0; i < 40; ++i)
    scene.targets.push_back(target_on("Earth", {20e3 + 300.0 * i, 50.0 * i, 3.0 * i}, 1.0 + i));
  if (earth) {
    scene.world.frame = scene::World::Frame::earth;
    scene.world.latitude = core::Angle::from_deg(47.0);
    scene.world.longitude = core::Angle::from_deg(11.0);
  }
  return scene;
}

struct Seen {
  std::vector<ScattererView> views;
  radar::EchoBatch plain;
  radar::EchoBatch fast;
};

Seen seen(const scene::Scene& scene) {
  const ResolvedScene resolved = resolve(scene);
  const ResolvedRadar radar = resolve_radar(scene, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  geometry.set_pulse(3);
  Seen all;
  for (std::size_t i = 0; i < scene.targets.size(); ++i) all.views.push_back(geometry.view(i));
  geometry.echoes(all.plain);
  fast_echoes(group_points(resolved, radar), geometry, all.fast);
  return all;
}

double range_m(const ScattererView& view) { return 0.5 * core::exact_light_speed_mps * view.delay_s; }

TEST(Air, OfAnAircraftIsTheIntegralAlongEachPath) {
  for (const bool earth : {false, true}) {
    scene::Scene scene = scene_below(earth);
    const Seen vacuum = seen(scene);
    scene.atmosphere.refraction = scene::Atmosphere::Refraction::exponential;
    const Seen air = seen(scene);
    for (std::size_t i = 0; i < scene.targets.size(); ++i) {
      const double low_m = scene.targets[i].position_m.z;
      const double distance_m = vacuum.views[i].distance_m;
      // 1e-6 of the integral of N over the height, along a straight line: d/(h2 - h1) times that of the vertical.
      const double expected_m =
          1e-6 * 315.0 * 7350.0 * (std::exp(-low_m / 7350.0) - std::exp(-10e3 / 7350.0)) * distance_m / (10e3 - low_m);
      EXPECT_NEAR(range_m(air.views[i]) - range_m(vacuum.views[i]), expected_m, (earth ? 2e-2 : 1e-6) * expected_m);
      EXPECT_DOUBLE_EQ(air.views[i].amplitude_sqrt_w, vacuum.views[i].amplitude_sqrt_w);
    }
  }
}

// What matters in a scene is how much the effects differ: between two targets 11.7 km apart, by their elevations.
TEST(Air, DiffersBetweenNearAndFar) {
  scene::Scene scene = scene_below(true);
  for (scene::Target& target : scene.targets) target.position_m.z = 0.0;
  const Seen vacuum = seen(scene);
  scene.atmosphere.refraction = scene::Atmosphere::Refraction::exponential;
  const Seen air = seen(scene);
  const auto excess_m = [&](std::size_t i) { return range_m(air.views[i]) - range_m(vacuum.views[i]); };
  const double ratio = vacuum.views.back().distance_m / vacuum.views.front().distance_m;
  EXPECT_NEAR(excess_m(39) / excess_m(0), ratio, 0.02 * ratio);
  EXPECT_GT(excess_m(39) - excess_m(0), 1.0);
}

TEST(Air, IsTheSameInTheFastWay) {
  for (const bool earth : {false, true}) {
    scene::Scene scene = scene_below(earth);
    scene.atmosphere.refraction = scene::Atmosphere::Refraction::linear;
    scene.atmosphere.gases = true;
    scene.atmosphere.rain_mm_per_h = 12.0;
    const Seen all = seen(scene);
    ASSERT_EQ(all.plain.size(), all.fast.size());
    double plain_sum = 0.0, fast_sum = 0.0;
    for (std::size_t i = 0; i < all.plain.size(); ++i) {
      plain_sum += all.plain.delay_s[i] * all.plain.amplitude_sqrt_w[i];
      fast_sum += all.fast.delay_s[i] * all.fast.amplitude_sqrt_w[i];
    }
    EXPECT_NEAR(fast_sum, plain_sum, 1e-9 * plain_sum);
  }
}

// The phase is that of the phase path, though the group is late: 10 units, 1.257 GHz, zenith, 2.5506 m each way.
TEST(Air, TheIonosphereAdvancesThePhase) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].carrier_hz = 1.257e9;
  scene.platforms.push_back(resting("Satellite", {0.0, 0.0, 700e3}));
  scene.radars[0].platform = "Satellite";
  scene.targets[0].position_m = {};
  const Seen vacuum = seen(scene);
  scene.atmosphere.tec_units = 10.0;
  const Seen plasma = seen(scene);
  const double excess_m = range_m(plasma.views[0]) - range_m(vacuum.views[0]);
  const double half_wavelength_m = 0.5 * core::exact_light_speed_mps / 1.257e9;
  EXPECT_NEAR(excess_m, 2.5506, 0.5 * half_wavelength_m);
  const double off_turns = (excess_m + 2.5506) / half_wavelength_m;
  EXPECT_NEAR(off_turns, std::round(off_turns), 1e-3);
}

}  // namespace air_test
}  // namespace sarsim::simulate
