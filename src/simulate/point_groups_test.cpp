#include "simulate/point_groups.hpp"

#include <gtest/gtest.h>

#include "simulate/impossible_echo.hpp"
#include "simulate/simulate_test_scene.hpp"

namespace sarsim {
namespace {

Target directional(Target target, double azimuth_deg, Target::Gain gain = Target::Gain::cosine) {
  target.reflectivity = Target::Reflectivity::directional;
  target.azimuth = Angle::from_deg(azimuth_deg);
  target.gain = gain;
  if (gain == Target::Gain::user) target.gain_db.part[0] = lines({{0.0, 0.0}, {90.0, -10.0}, {180.0, -30.0}});
  return target;
}

Target jittering(Target target) {
  target.position_stddev_m = {0.1, 0.2, 0.3};
  target.rcs_stddev_m2 = 0.2;
  return target;
}

// Two platforms, one of which turns and moves, and targets of every sort in no order; a surface that faces the radar.
Scene mixed_scene() {
  Scene scene = one_target_scene();
  scene.platforms.push_back(moving("Ship", {900.0, 400.0, 10.0}, {-20.0, 90.0, 1.0}));
  scene.platforms.back().rotation = {Angle::from_deg(5), Angle::from_deg(-8), Angle::from_deg(30)};
  scene.platforms.back().rotation_rate = {Angle::from_deg(20), Angle::from_deg(0), Angle::from_deg(-70)};
  scene.targets.clear();
  for (int i = 0; i < 97; ++i) {
    const Vec3 at{600.0 + 3.0 * (i % 11) + (i % 2 == 0 ? 0.0 : 300.0), 7.0 * (i % 5) - 10.0, 2.0 * (i % 7)};
    Target target = target_on(i % 13 < 7 ? "Ship" : "Earth", at, 0.5 + i % 4);
    if (i % 6 == 1) target = directional(target, -90.0 + i % 40);
    if (i % 10 == 3) target = directional(target, 250.0, Target::Gain::user);
    if (i % 11 == 5) target = jittering(target);
    scene.targets.push_back(target);
  }
  Surface surface;
  surface.corner_m = {Vec3{1000.0, 10.0, 0.0}, Vec3{1000.0, -10.0, 0.0}, Vec3{1000.0, 0.0, 10.0}};
  scene.surfaces.push_back(surface);
  scene.radars[0].prf_hz = 10.0;
  return scene;
}

struct Echoes {
  EchoBatch plain, fast;
};

Echoes echoes_of(const Scene& scene, std::int64_t pulse) {
  const ResolvedScene resolved = resolve(scene);
  const ResolvedRadar radar = resolve_radar(scene, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  geometry.set_pulse(pulse);
  Echoes echoes;
  geometry.echoes(echoes.plain);
  echoes.fast.add(1.0, 1.0, 1.0);  // to be replaced
  fast_echoes(group_points(resolved), resolved, radar, geometry, echoes.fast);
  return echoes;
}

// One by one: the order is the same, the figures to rounding. Delays of 1e3 m are rounded to 2e-13 m each time.
void expect_same(const Echoes& echoes) {
  ASSERT_EQ(echoes.fast.size(), echoes.plain.size());
  double largest = 0.0;
  for (const double a : echoes.plain.amplitude_sqrt_w) largest = std::max(largest, std::abs(a));
  for (std::size_t k = 0; k < echoes.plain.size(); ++k) {
    EXPECT_NEAR(echoes.fast.delay_s[k], echoes.plain.delay_s[k], 1e-14 * echoes.plain.delay_s[k]) << k;
    EXPECT_NEAR(echoes.fast.amplitude_sqrt_w[k], echoes.plain.amplitude_sqrt_w[k], 1e-12 * largest) << k;
    EXPECT_NEAR(echoes.fast.speed_mps[k], echoes.plain.speed_mps[k], 1e-12 * 100.0) << k;
  }
}

TEST(FastEchoes, AreThoseOfPulseGeometryInTheSameOrder) {
  for (const std::int64_t pulse : {-3, 0, 7}) expect_same(echoes_of(mixed_scene(), pulse));
}

TEST(FastEchoes, AreTheSameUnderEveryAntennaBeamProfileAndStc) {
  for (const Antenna::Pattern pattern : {Antenna::Pattern::sinx, Antenna::Pattern::user})
    for (const bool same : {true, false})
      for (const Profile profile : {Profile::physical, Profile::classic})
        for (const Radar::Stc stc : {Radar::Stc::none, Radar::Stc::range_law}) {
          Scene scene = mixed_scene();
          Radar& radar = scene.radars[0];
          scene.options.profile = profile;
          radar.stc = stc;
          radar.transmit_antenna.pattern = pattern;
          radar.transmit_antenna.azimuth_beamwidth = Angle::from_deg(25.0);
          for (auto& part : radar.transmit_antenna.gain_db.part)
            part = lines({{0.0, 0.0}, {60.0, -20.0}, {180, -40.0}});
          radar.same_antenna = same;
          radar.receive_antenna.pattern = Antenna::Pattern::isotropic;
          radar.beam_azimuth = Angle::from_deg(80.0);
          radar.beam_elevation = Angle::from_deg(3.0);
          expect_same(echoes_of(scene, 2));
        }
}

TEST(GroupPoints, CollectsNeighboursOfOnePlatformAndLawAndKeepsTheOrder) {
  Scene scene = one_target_scene();
  scene.platforms.push_back(resting("Ship", {}));
  const Target plain = target_on("Earth", {1000, 0, 0}, 4.0);
  scene.targets = {plain,
                   plain,
                   directional(plain, 0.0),
                   directional(plain, 0.0, Target::Gain::user),
                   jittering(plain),
                   plain,
                   target_on("Ship", {1, 2, 3}, 9.0)};
  scene.surfaces.push_back({});
  const PointGroups groups = group_points(resolve(scene));
  const struct {
    std::size_t first, count, points, normals;
    bool plain, sheet;
  } expected[] = {{0, 2, 2, 0, true, false}, {2, 1, 1, 1, true, false}, {3, 2, 0, 0, false, false},
                  {5, 1, 1, 0, true, false}, {6, 1, 1, 0, true, false}, {0, 0, 0, 0, true, true}};
  ASSERT_EQ(groups.runs.size(), std::size(expected));
  for (std::size_t r = 0; r < groups.runs.size(); ++r) {
    const PointGroups::Run& run = groups.runs[r];
    EXPECT_EQ(run.plain, expected[r].plain) << r;
    EXPECT_EQ(run.sheet, expected[r].sheet) << r;
    EXPECT_EQ(run.first_target, expected[r].first) << r;
    if (run.sheet) {
      EXPECT_GT(run.count, 50u);  // 100 m^2, a point for each
      EXPECT_EQ(run.points.normal_x.size(), run.count);
      continue;
    }
    EXPECT_EQ(run.count, expected[r].count) << r;
    EXPECT_EQ(run.points.size(), expected[r].points) << r;
    EXPECT_EQ(run.points.normal_x.size(), expected[r].normals) << r;
  }
  EXPECT_DOUBLE_EQ(groups.runs[4].points.root_rcs_m[0], 3.0);
  EXPECT_DOUBLE_EQ(groups.runs[4].points.z_m[0], 3.0);
}

TEST(FastEchoes, OfASurfaceFromBehindAreNothing) {
  Scene scene = one_target_scene();
  scene.targets.clear();
  Surface surface;
  std::swap(surface.corner_m[0], surface.corner_m[1]);
  scene.surfaces.push_back(surface);
  const Echoes echoes = echoes_of(scene, 0);
  EXPECT_EQ(echoes.plain.size(), 0u);
  for (const double a : echoes.fast.amplitude_sqrt_w) EXPECT_EQ(a, 0.0);
}

TEST(FastEchoes, RefuseATargetAtTheRadarByItsNumber) {
  Scene scene = mixed_scene();
  scene.targets[10] = target_on("Earth", {});
  const ResolvedScene resolved = resolve(scene);
  const ResolvedRadar radar = resolve_radar(scene, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  geometry.set_pulse(0);
  EchoBatch echoes;
  try {
    fast_echoes(group_points(resolved), resolved, radar, geometry, echoes);
    FAIL() << "an infinite echo";
  } catch (const ImpossibleEcho& error) {
    EXPECT_EQ(error.problem.subject.kind, "target");
    EXPECT_EQ(error.problem.subject.index, 10u);
  }
}

}  // namespace
}  // namespace sarsim
