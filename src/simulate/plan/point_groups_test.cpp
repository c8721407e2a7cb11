#include "simulate/plan/point_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "radar/simd/simd_test_support.hpp"
#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::simulate {
namespace point_groups_test {

constexpr std::array methods{core::Interpolation::linear, core::Interpolation::cubic, core::Interpolation::low_pass};

scene::Target directional(scene::Target target, double azimuth_deg,
                          scene::Target::Gain gain = scene::Target::Gain::cosine) {
  target.traits.edit().reflectivity = scene::Target::Reflectivity::directional;
  target.traits.edit().azimuth = core::Angle::from_deg(azimuth_deg);
  target.traits.edit().gain = gain;
  return target;
}

// A reflectivity of one of nine sorts.
core::SampledFunction reflectivity_curve(std::size_t sort) {
  const std::vector<std::vector<core::Knot>> knots{
      {{0.0, 0.0}, {90.0, -10.0}, {180.0, -30.0}},
      {{5.0, 3.0}, {40.0, -2.0}, {42.0, -25.0}, {120.0, -20.0}},
      {{0.0, -1.0}, {20.0, 1.0}, {60.0, 0.0}, {100.0, -8.0}, {170.0, -9.0}}};
  return {methods[sort % 3], knots[sort / 3 % 3]};
}

// Deviations in one of twelve combinations, none among them.
scene::Target jittering(scene::Target target, int sort) {
  if (sort % 2 == 1) target.traits.edit().position_stddev_m = {0.1, sort % 4 == 1 ? 0.2 : 0.0, 0.0};
  if (sort % 3 == 1) target.traits.edit().position_stddev_m.z = 0.3;
  if (sort % 4 >= 2) target.traits.edit().rcs_stddev_m2 = 0.7;
  if (sort % 5 >= 3) target.traits.edit().azimuth_stddev = core::Angle::from_deg(20.0);
  if (sort % 5 == 4) target.traits.edit().elevation_stddev = core::Angle::from_deg(5.0);
  return target;
}

// Two platforms, one of which turns and moves, and targets of every sort in no order; surfaces that face the radar.
scene::Scene mixed_scene() {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Ship", {900.0, 400.0, 10.0}, {-20.0, 90.0, 1.0}));
  scene.platforms.back().rotation = {core::Angle::from_deg(5), core::Angle::from_deg(-8), core::Angle::from_deg(30)};
  scene.platforms.back().rotation_rate = {core::Angle::from_deg(20), core::Angle::from_deg(0),
                                          core::Angle::from_deg(-70)};
  scene.targets.clear();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> shift(-1.0, 1.0);
  for (int i = 0; i < 297; ++i) {
    const core::Vec3 at{600.0 + 3.0 * (i % 11) + (i % 2 == 0 ? 0.0 : 300.0) + shift(random), 7.0 * (i % 5) - 10.0,
                        2.0 * (i % 7) + shift(random)};
    scene::Target target = target_on(i % 13 < 7 ? "Ship" : "Earth", at, 0.5 + i % 4);
    if (i % 6 == 1) target = directional(target, -90.0 + i % 40);
    if (i % 5 >= 3) {
      target = directional(target, 250.0 + i % 60, scene::Target::Gain::user);
      target.traits.edit().gain_db.part[0] = reflectivity_curve(static_cast<std::size_t>(i / 5));
    }
    if (i % 7 >= 4) target = jittering(target, i / 7);
    scene.targets.push_back(target);
  }
  scene::Surface surface;
  surface.corner_m = {core::Vec3{1000.0, 10.0, 0.0}, core::Vec3{1000.0, -10.0, 0.0}, core::Vec3{1000.0, 0.0, 10.0}};
  scene.surfaces = {surface, surface};
  scene.surfaces[1].platform = "Ship";
  scene.radars[0].prf_hz = 10.0;
  return scene;
}

struct Echoes {
  radar::EchoBatch plain, fast;
  std::size_t points = 0;
};

Echoes echoes_of(const ResolvedScene& resolved, const Link& radar, std::int64_t pulse) {
  PulseGeometry geometry(resolved, radar);
  geometry.set_pulse(pulse);
  Echoes echoes;
  geometry.echoes(echoes.plain);
  echoes.fast.add(1.0, 1.0, 1.0);  // to be replaced
  const PointGroups groups = group_points(resolved, radar);
  echoes.points = groups.count;
  fast_echoes(groups, geometry, echoes.fast);
  return echoes;
}

Echoes echoes_of(const scene::Scene& scene, std::int64_t pulse) {
  const ResolvedScene resolved = resolve(scene);
  return echoes_of(resolved, resolve_radar(scene, resolved, 0), pulse);
}

struct Echo {
  double delay_s, amplitude, doppler, dilation_rate;
};

TEST(CertainEchoes, OfRunsAreThoseOfAllPointsTakenApart) {
  const scene::Scene scene = mixed_scene();
  const ResolvedScene resolved = resolve(scene);
  const Link radar = resolve_radar(scene, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  geometry.set_pulse(3);
  const PointGroups groups = group_points(resolved, radar);
  ASSERT_GT(groups.groups.size(), 3u);
  radar::EchoBatch all;
  fast_echoes(groups, geometry, all);
  for (const std::size_t length : {std::size_t{1}, std::size_t{7}, std::size_t{40}, groups.count}) {
    radar::EchoBatch run;
    for (std::size_t from = 0; from < groups.count; from += length) {
      const radar::PointSpan span{from, std::min(from + length, groups.count)};
      ASSERT_TRUE(certain_echoes(groups, geometry, span, run));
      ASSERT_EQ(run.size(), span.size());
      for (std::size_t k = 0; k < run.size(); ++k) {
        EXPECT_EQ(run.delay_s[k], all.delay_s[from + k]);
        EXPECT_EQ(run.amplitude_sqrt_w[k], all.amplitude_sqrt_w[from + k]);
        EXPECT_EQ(run.doppler[k], all.doppler[from + k]);
      }
    }
    EXPECT_TRUE(certain_echoes(groups, geometry, {groups.count, groups.count}, run));
    EXPECT_EQ(run.size(), 0u);
  }
}

// The echoes that are not 0, by their delays: the groups have an order of their own.
std::vector<Echo> sorted(const radar::EchoBatch& batch) {
  std::vector<Echo> echoes;
  for (std::size_t k = 0; k < batch.size(); ++k)
    if (batch.amplitude_sqrt_w[k] != 0.0)
      echoes.push_back({batch.delay_s[k], batch.amplitude_sqrt_w[k], batch.doppler[k], batch.clock(k).dilation_rate});
  std::ranges::sort(echoes, {}, &Echo::delay_s);
  return echoes;
}

// Delays of 1e3 m are rounded to 2e-13 m, a few times; amplitudes agree to rounding and the promise of the curves.
void expect_same(const Echoes& echoes, double tolerance) {
  EXPECT_EQ(echoes.fast.size(), echoes.points);
  const std::vector<Echo> plain = sorted(echoes.plain), fast = sorted(echoes.fast);
  ASSERT_EQ(fast.size(), plain.size());
  double largest = 0.0;
  for (const Echo& echo : plain) largest = std::max(largest, std::abs(echo.amplitude));
  for (std::size_t k = 0; k < plain.size(); ++k) {
    ASSERT_NEAR(fast[k].delay_s, plain[k].delay_s, 2e-15 * plain[k].delay_s) << k;
    ASSERT_NEAR(fast[k].amplitude, plain[k].amplitude, tolerance / 8.0 * std::abs(plain[k].amplitude) + 1e-12 * largest)
        << k;
    ASSERT_NEAR(fast[k].doppler, plain[k].doppler, 1e-15) << k;
    ASSERT_NEAR(fast[k].dilation_rate, plain[k].dilation_rate, 1e-12 * std::abs(plain[k].dilation_rate) + 1e-18) << k;
  }
}

TEST(FastEchoes, AreThoseOfPulseGeometry) {
  radar::at_every_simd_level([] {
    for (const std::int64_t pulse : {-3, 0, 7}) expect_same(echoes_of(mixed_scene(), pulse), 1e-6);
  });
}

TEST(FastEchoes, HaveTheSameRandomDeviationsForEverySeed) {
  scene::Scene scene = mixed_scene();
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{2}, ~std::uint64_t{0}}) {
    scene.options.seed = seed;
    for (const std::int64_t pulse : {-3000, 5}) expect_same(echoes_of(scene, pulse), 1e-6);
  }
}

scene::Antenna antenna_of(scene::Antenna::Pattern pattern, core::Interpolation method) {
  scene::Antenna antenna;
  antenna.pattern = pattern;
  antenna.azimuth_beamwidth = core::Angle::from_deg(25.0);
  antenna.gain_db.part[0] = {method, {{0.0, 0.0}, {10.0, -1.0}, {30.0, -20.0}, {60.0, -18.0}, {180.0, -40.0}}};
  antenna.gain_db.part[1] = {method, {{0.0, 1.0}, {5.0, -3.0}, {10.0, 0.0}, {15.0, -9.0}}};
  return antenna;
}

// One side unlike the other: in azimuth all the way round, in elevation with ends.
scene::Antenna lopsided(core::Interpolation method) {
  scene::Antenna antenna;
  antenna.pattern = scene::Antenna::Pattern::user;
  for (int i = 0; i < 24; ++i)
    antenna.gain_db.part[0].knots.push_back({15.0 * i - 40.0, -20.0 + 20.0 * std::cos(0.3 + 0.27 * i) - i % 3});
  antenna.gain_db.part[1].knots = {{-40.0, -25.0}, {-9.0, -4.0}, {1.0, 0.0}, {5.0, -3.0}, {10.0, 0.0}, {15.0, -9.0}};
  for (core::SampledFunction& cut : antenna.gain_db.part) cut.method = method;
  return antenna;
}

std::vector<scene::Antenna> antennas() {
  std::vector<scene::Antenna> all{{}, antenna_of(scene::Antenna::Pattern::sinx, {})};
  for (const core::Interpolation method : methods) {
    all.push_back(antenna_of(scene::Antenna::Pattern::user, method));
    all.push_back(lopsided(method));
  }
  return all;
}

scene::Radar pointed(scene::Radar radar, scene::Radar::Beam beam) {
  radar.beam = beam;
  radar.beam_azimuth = core::Angle::from_deg(80.0);
  radar.beam_elevation = core::Angle::from_deg(3.0);
  radar.beam_rate = core::Angle::from_deg(-2000.0);
  radar.spot_world_m = {700.0, 100.0, -30.0};
  radar.beam_target_world_m.part = {lines({{0.0, 600.0}, {1.0, 700.0}}), lines({{0.0, 20.0}}), lines({{0.0, 9.0}})};
  return radar;
}

// The radar flies and turns, so that its own rotation counts; it looks from below the scene.
scene::Scene flying_scene(scene::Radar::Beam beam, const scene::Antenna& transmit, const scene::Antenna& receive,
                          double tolerance) {
  scene::Scene scene = mixed_scene();
  scene.options.tolerance = tolerance;
  scene.platforms.push_back(moving("Plane", {-50.0, 30.0, -200.0}, {100.0, 40.0, 3.0}));
  scene.platforms.back().rotation = {core::Angle::from_deg(4), core::Angle::from_deg(7), core::Angle::from_deg(-12)};
  scene.radars[0] = pointed(scene.radars[0], beam);
  scene.radars[0].platform = "Plane";
  scene.radars[0].transmit_antenna = transmit;
  scene.radars[0].same_antenna = false;
  scene.radars[0].receive_antenna = receive;
  return scene;
}

TEST(FastEchoes, AreTheSameForEveryPairOfAntennasBeamAndRule) {
  for (const scene::Radar::Beam beam :
       {scene::Radar::Beam::fixed, scene::Radar::Beam::rotating, scene::Radar::Beam::spot, scene::Radar::Beam::user})
    for (const scene::Antenna& transmit : antennas())
      for (const scene::Antenna& receive : antennas())
        for (const radar::PointingRule pointing : {radar::PointingRule::boresight, radar::PointingRule::added_angles})
          for (const radar::PatternRule pattern : {radar::PatternRule::amplitude, radar::PatternRule::power}) {
            const scene::Scene scene = flying_scene(beam, transmit, receive, 1e-6);
            ResolvedScene resolved = resolve(scene);
            resolved.conventions.pointing = pointing;
            resolved.conventions.pattern = pattern;
            expect_same(echoes_of(resolved, resolve_radar(scene, resolved, 0), 2), 1e-6);
          }
}

// Right behind the beam the angle is half a turn, whatever the sign of a zero: the ends of a table with a gap there
// differ by 14 dB.
TEST(FastEchoes, AreTheSameRightBehindATableWhoseEndsDiffer) {
  scene::Antenna antenna;
  antenna.pattern = scene::Antenna::Pattern::user;
  antenna.gain_db.part[0] = lines({{-160.0, -19.0}, {0.0, 0.0}, {160.0, -5.0}});
  antenna.gain_db.part[1] = lines({{0.0, 0.0}});
  for (const double bearing_deg : {0.0, 30.0, 90.0, 180.0, -90.0, 123.456})
    for (const radar::PointingRule pointing : {radar::PointingRule::boresight, radar::PointingRule::added_angles}) {
      scene::Scene scene = one_target_scene();
      scene.radars[0].transmit_antenna = antenna;
      scene.radars[0].beam_azimuth = core::Angle::from_deg(bearing_deg);
      const double b = bearing_deg * core::rad_per_deg;
      scene.targets.clear();
      for (int i = 0; i < 40; ++i) {
        const double range_m = 600.0 + 3.7 * i;
        const core::Vec3 behind_m{-range_m * std::sin(b), -range_m * std::cos(b), 0.0};
        scene.targets.push_back(target_on("Earth", behind_m));
        if (bearing_deg == 0.0) scene.targets.back().position_m.x = i % 2 == 0 ? 0.0 : -0.0;
      }
      ResolvedScene resolved = resolve(scene);
      resolved.conventions.pointing = pointing;
      const Echoes echoes = echoes_of(resolved, resolve_radar(scene, resolved, 0), 0);
      EXPECT_EQ(echoes.points, 40u);
      expect_same(echoes, 1e-6);
    }
}

TEST(FastEchoes, AreTheSameInEveryProfileStcAndToleranceOnEveryInstructionSet) {
  radar::at_every_simd_level([] {
    for (const scene::Antenna& antenna : antennas())
      for (const scene::Profile profile : {scene::Profile::physical, scene::Profile::classic})
        for (const scene::Radar::Stc stc : {scene::Radar::Stc::none, scene::Radar::Stc::range_law})
          for (const double tolerance : {1e-3, 1e-10}) {
            scene::Scene scene = flying_scene(scene::Radar::Beam::fixed, antenna, antenna, tolerance);
            scene.options.profile = profile;
            scene.radars[0].stc = stc;
            scene.radars[0].same_antenna = true;
            expect_same(echoes_of(scene, 2), tolerance);
          }
  });
}

// Along the axes, at knots of the curves, right above and below, behind, and at right angles to the beam.
TEST(FastEchoes, AreTheSameInSpecialDirections) {
  radar::at_every_simd_level([] {
    for (const scene::Antenna& antenna : antennas())
      for (const scene::Profile profile : {scene::Profile::physical, scene::Profile::classic})
        for (const double azimuth_deg : {0.0, 90.0, -90.0, 180.0}) {
          scene::Scene scene = one_target_scene();
          scene.options.profile = profile;
          scene.radars[0].transmit_antenna = antenna;
          scene.radars[0].beam_azimuth = core::Angle::from_deg(azimuth_deg);
          scene.targets.clear();
          double distance_m = 1000.0;
          const auto place = [&](const core::Vec3& way) {
            scene::Target target = target_on("Earth", distance_m * way);
            scene.targets.push_back(target);
            target = directional(target, 180.0 + azimuth_deg, scene::Target::Gain::user);
            target.traits.edit().gain_db.part[0] = reflectivity_curve(scene.targets.size() % 9);
            target.position_m = (distance_m + 50.0) * way;
            scene.targets.push_back(target);
            distance_m += 100.0;
          };
          for (const double sign : {1.0, -1.0})
            for (const core::Vec3& way : {core::Vec3{sign, 0, 0}, core::Vec3{0, sign, 0}, core::Vec3{0, 0, sign}})
              place(way);
          for (const double offset_deg : {5.0, 10.0, 15.0, 30.0, 60.0, 120.0})
            place(core::direction((azimuth_deg + offset_deg) * core::pi / 180.0, 5.0 * core::pi / 180.0));
          expect_same(echoes_of(scene, 0), 1e-6);
        }
  });
}

TEST(FastEchoes, OfATargetDependOnItsPlaceInTheSceneOnlyByItsRandomNumbers) {
  scene::Scene scene = one_target_scene();
  scene::Target target = jittering(target_on("Earth", {900.0, 100.0, 5.0}), 7);
  scene.targets = {target_on("Earth", {500, 0, 0}), target, target};
  const Echoes echoes = echoes_of(scene, 4);
  expect_same(echoes, 1e-6);
  EXPECT_NE(echoes.plain.delay_s[1], echoes.plain.delay_s[2]);
}

TEST(GroupPoints, CollectsWhatSharesPlatformLawAndDeviationsInTheOrderOfTheScene) {
  scene::Scene scene = one_target_scene();
  scene.platforms.push_back(resting("Ship", {}));
  const scene::Target plain = target_on("Earth", {1000, 0, 0}, 4.0);
  scene::Target other = directional(plain, 0.0, scene::Target::Gain::user);
  other.traits.edit().gain_db.part[0] = reflectivity_curve(0);
  scene::Target moved = plain;
  moved.position_m.x = 7.0;
  scene.targets = {plain,
                   directional(plain, 0.0),
                   moved,
                   other,
                   jittering(plain, 1),
                   target_on("Ship", {1, 2, 3}, 9.0),
                   jittering(moved, 1),
                   other,
                   jittering(plain, 1)};
  scene.surfaces.push_back({});
  const ResolvedScene resolved = resolve(scene);
  const PointGroups groups = group_points(resolved, resolve_radar(scene, resolved, 0));
  const struct {
    radar::PointArrays::Law law;
    std::size_t points, deviations, curves;
  } expected[] = {{radar::PointArrays::Law::isotropic, 2, 0, 0},
                  {radar::PointArrays::Law::cosine, 1 + 100, 0, 0},
                  {radar::PointArrays::Law::curve, 2, 0, 2},
                  {radar::PointArrays::Law::isotropic, 3, 3, 0},
                  {radar::PointArrays::Law::isotropic, 1, 0, 0}};
  ASSERT_EQ(groups.groups.size(), std::size(expected));
  std::size_t count = 0;
  for (std::size_t g = 0; g < groups.groups.size(); ++g) {
    const radar::PointArrays& points = *groups.groups[g].points;
    EXPECT_EQ(points.law, expected[g].law) << g;
    EXPECT_NEAR(static_cast<double>(points.size()), static_cast<double>(expected[g].points), g == 1 ? 30.0 : 0.0) << g;
    EXPECT_EQ(points.jitter.position_key.size(), expected[g].deviations) << g;
    EXPECT_EQ(points.curve_cell.size(), expected[g].curves) << g;
    EXPECT_EQ(points.normal_x.size(), points.law == radar::PointArrays::Law::isotropic ? 0 : points.size()) << g;
    count += points.size();
  }
  EXPECT_EQ(groups.count, count);
  EXPECT_EQ(groups.groups[0].points->x_m, (std::vector<double>{1000.0, 7.0}));
  EXPECT_EQ(groups.groups[4].platform, 1u);
  EXPECT_DOUBLE_EQ(groups.groups[4].points->root_rcs_m[0], 3.0);
  EXPECT_EQ(groups.reflectivity.count, 1u);
}

TEST(FastEchoes, OfASurfaceFromBehindAreNothing) {
  scene::Scene scene = one_target_scene();
  scene.targets.clear();
  scene::Surface surface;
  std::swap(surface.corner_m[0], surface.corner_m[1]);
  scene.surfaces.push_back(surface);
  const Echoes echoes = echoes_of(scene, 0);
  EXPECT_EQ(echoes.plain.size(), 0u);
  for (const double a : echoes.fast.amplitude_sqrt_w) EXPECT_EQ(a, 0.0);
}

TEST(FastEchoes, OfASurfaceThroughTheRadarLeaveOutThePointAtTheRadar) {
  scene::Scene scene = one_target_scene();
  scene.surfaces.push_back({});
  ResolvedScene resolved = resolve(scene);
  resolved.sheets[0].points_m[5] = {};
  const Echoes echoes = echoes_of(resolved, resolve_radar(scene, resolved, 0), 0);
  EXPECT_EQ(echoes.fast.delay_s, echoes.plain.delay_s);
  EXPECT_EQ(echoes.fast.amplitude_sqrt_w, echoes.plain.amplitude_sqrt_w);
  for (const double a : echoes.fast.amplitude_sqrt_w) EXPECT_TRUE(std::isfinite(a));
}

// What PulseGeometry::echoes and fast_echoes say about a scene.
std::array<std::string, 2> complaints(const scene::Scene& scene) {
  const ResolvedScene resolved = resolve(scene);
  const Link radar = resolve_radar(scene, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  geometry.set_pulse(0);
  const PointGroups groups = group_points(resolved, radar);
  radar::EchoBatch echoes;
  const auto complaint = [&](const auto& compute) -> std::string {
    try {
      compute();
    } catch (const ImpossibleEcho& error) {
      return core::to_string(error.problem);
    }
    return "";
  };
  return {complaint([&] { geometry.echoes(echoes); }), complaint([&] { fast_echoes(groups, geometry, echoes); })};
}

TEST(FastEchoes, RefuseWhatPulseGeometryRefusesInTheSameWords) {
  std::vector<scene::Scene> scenes(5, mixed_scene());
  scenes[0].targets[20] = scenes[0].targets[11] = target_on("Earth", {});
  scenes[1].targets[33] = directional(target_on("Earth", {}), 10.0);
  scenes[2].targets[4].rcs_m2 = 1e300;
  scenes[3].targets[280].traits.edit().rcs_stddev_m2 = 1e300;
  scenes[3].targets[280].rcs_m2 = 1e300;
  scenes[4].platforms[1] = moving("Ship", {900.0, 400.0, 10.0}, {4e8, 0.0, 0.0});
  for (const scene::Scene& scene : scenes) {
    const auto [plain, fast] = complaints(scene);
    EXPECT_NE(plain, "");
    EXPECT_EQ(fast, plain);
  }
  EXPECT_EQ(complaints(mixed_scene()), (std::array<std::string, 2>{}));
}

TEST(FastEchoes, OfCurvesThatAreNotFiniteAreLookedUpOneByOne) {
  scene::Scene scene = mixed_scene();
  scene::Antenna antenna = antenna_of(scene::Antenna::Pattern::user, core::Interpolation::linear);
  antenna.gain_db.part[1] = lines({{0.0, 0.0}, {100.0, 0.0}, {170.0, -1e308}, {170.1, -1.7e308}});
  scene.radars[0].transmit_antenna = antenna;
  const ResolvedScene resolved = resolve(scene);
  const Link radar = resolve_radar(scene, resolved, 0);
  EXPECT_FALSE(group_points(resolved, radar).sound());
  const Echoes echoes = echoes_of(resolved, radar, 1);
  EXPECT_EQ(echoes.fast.amplitude_sqrt_w, echoes.plain.amplitude_sqrt_w);
}

}  // namespace point_groups_test
}  // namespace sarsim::simulate
