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
  const Link radar = resolve_radar(scene, resolved, 0);
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

// 40.3 TEC/f^2 at the zenith: 10 units at 1.257 GHz are 2.5506 m each way.
double zenith_group_m(double tec_units, double carrier_hz) { return 40.3e16 * tec_units / (carrier_hz * carrier_hz); }

scene::Scene scene_from_orbit(double carrier_hz) {
  scene::Scene scene = one_target_scene();
  scene.radars[0].carrier_hz = carrier_hz;
  scene.platforms.push_back(resting("Satellite", {0.0, 0.0, 700e3}));
  scene.radars[0].platform = "Satellite";
  scene.targets[0].position_m = {};
  return scene;
}

// The pulse is late by the group path, exactly, and the carrier early by as much.
TEST(Air, TheIonosphereDelaysThePulseAndAdvancesThePhase) {
  for (const double carrier_hz : {0.435e9, 1.257e9, 5.405e9, 9.65e9}) {
    scene::Scene scene = scene_from_orbit(carrier_hz);
    const Seen vacuum = seen(scene);
    scene.atmosphere.tec_units = 10.0;
    const Seen plasma = seen(scene);
    const double group_m = zenith_group_m(10.0, carrier_hz);
    const double vacuum_m = range_m(vacuum.views[0]);
    EXPECT_NEAR(range_m(plasma.views[0]) - vacuum_m, group_m, 1e-9 * vacuum_m);
    const double phase_m = 0.5 * core::exact_light_speed_mps * plasma.views[0].phase_delay_s(carrier_hz) - vacuum_m;
    EXPECT_NEAR(phase_m, -group_m, 1e-9 * vacuum_m);
    EXPECT_NEAR(plasma.views[0].ahead_turns, 4.0 * group_m * carrier_hz / core::exact_light_speed_mps, 1e-6);
    for (const radar::EchoBatch* echoes : {&plasma.plain, &plasma.fast}) {
      ASSERT_EQ(echoes->ahead_turns.size(), 1U);
      EXPECT_EQ(echoes->ahead_turns[0], plasma.views[0].ahead_turns);
    }
    EXPECT_TRUE(vacuum.plain.ahead_turns.empty());
    EXPECT_TRUE(vacuum.fast.ahead_turns.empty());
  }
}

TEST(Air, OfAnIonosphereIsTheSameInTheFastWay) {
  for (const bool earth : {false, true}) {
    scene::Scene scene = scene_below(earth);
    scene.platforms.back() = moving("Aircraft", {0.0, 0.0, 700e3}, {7000.0, 200.0, 0.0});
    scene.atmosphere.refraction = scene::Atmosphere::Refraction::exponential;
    scene.atmosphere.tec_units = 30.0;
    const Seen all = seen(scene);
    ASSERT_EQ(all.fast.ahead_turns.size(), all.plain.size());
    ASSERT_EQ(all.plain.ahead_turns.size(), all.plain.size());
    for (std::size_t i = 0; i < all.plain.size(); ++i) {
      EXPECT_GT(all.plain.ahead_turns[i], 100.0);
      EXPECT_NEAR(all.fast.ahead_turns[i], all.plain.ahead_turns[i], 1e-7);
      EXPECT_NEAR(all.fast.delay_s[i], all.plain.delay_s[i], 1e-18 + 1e-14 * all.plain.delay_s[i]);
    }
  }
}

// Each pulse of stepped carriers is delayed by 1/f^2 of its own.
TEST(Air, OfAnIonosphereIsThatOfTheCarrierOfEachPulse) {
  scene::Scene scene = scene_from_orbit(1.0e9);
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_step_hz = 100e6;
  scene.radars[0].carrier_steps = 5;
  scene.radars[0].pulses_per_step = 1;
  const double vacuum_m = range_m(seen(scene).views[0]);
  scene.atmosphere.tec_units = 10.0;
  const ResolvedScene resolved = resolve(scene);
  const Link radar = resolve_radar(scene, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  for (const std::int64_t pulse : {0, 2, 4}) {
    geometry.set_pulse(pulse);
    const double carrier_hz = 1.0e9 + 100e6 * static_cast<double>(pulse);
    ASSERT_NEAR(geometry.carrier_hz(), carrier_hz, 1.0);
    const double group_m = zenith_group_m(10.0, carrier_hz);
    EXPECT_NEAR(range_m(geometry.view(0)) - vacuum_m, group_m, 1e-9 * vacuum_m);
    EXPECT_NEAR(geometry.view(0).ahead_turns, 4.0 * group_m * carrier_hz / core::exact_light_speed_mps, 1e-6);
  }
}

}  // namespace air_test
}  // namespace sarsim::simulate
