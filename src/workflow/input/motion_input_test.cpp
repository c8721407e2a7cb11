#include "workflow/input/motion_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "radar/earth/ellipsoid.hpp"
#include "radar/earth/turning_frame.hpp"
#include "radar/orbit/kepler.hpp"
#include "scene/model/read_path.hpp"
#include "scene/model/world_frame.hpp"
#include "support/test_folder.hpp"

namespace sarsim::workflow {
namespace motion_input_test {

using testing::HasSubstr;

scene::Scene earth_scene(double first_s, double last_s) {
  scene::Scene scene;
  scene.world.frame = scene::World::Frame::earth;
  scene.world.epoch = "2000-06-27T18:50:19.733571Z";
  scene.platforms.resize(1);
  scene.geometries.resize(1);
  scene.geometries[0].time_start_s = first_s;
  scene.geometries[0].time_end_s = last_s;
  return scene;
}

std::string messages(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems) text += core::to_string(problem) + "\n";
  return text;
}

TEST(MotionInput, AnOrbitIsTheEllipseThatJ2TurnsOverTheTurningEarth) {
  scene::Scene scene = earth_scene(0.0, 100.0);
  scene::Platform& platform = scene.platforms[0];
  platform.path = scene::Platform::Path::orbit;
  platform.semi_major_axis_m = 7071e3;
  platform.inclination = core::Angle::from_deg(98.0);
  ASSERT_EQ(messages(read_motions(scene, {})), "");
  const auto at = platform.read_path->states->at(50.0);
  // The anchor is at latitude and longitude 0: world x, y, z are ECEF y, z, x less the radius.
  const radar::OrbitMotion motion =
      radar::SecularOrbit({7071e3, 0.0, platform.inclination.rad(), 0.0, 0.0, 0.0}).at(50.0);
  const double turn = radar::earth_rate_rad_per_s * 50.0;
  const core::Vec3& p = motion.position_m;
  EXPECT_NEAR(at->position_m.x, -std::sin(turn) * p.x + std::cos(turn) * p.y, 1e-6);
  EXPECT_NEAR(at->position_m.y, p.z, 1e-6);
  EXPECT_NEAR(at->position_m.z, std::cos(turn) * p.x + std::sin(turn) * p.y - radar::wgs84_semi_major_m, 1e-6);
}

scene::Scene scene_with_state(const core::Vec3& position_m, const core::Vec3& velocity_mps) {
  scene::Scene scene = earth_scene(-60.0, 60.0);
  scene::Platform& platform = scene.platforms[0];
  platform.path = scene::Platform::Path::state;
  platform.state_position_m = position_m;
  platform.state_velocity_mps = velocity_mps;
  return scene;
}

constexpr core::Vec3 sentinel_m{2057735.247194, -6459802.571744, -2037501.319184};
constexpr core::Vec3 sentinel_mps{-886.585360, -2517.114487, 7108.167902};

// States of examples/satellite.EOF, which tests/examples/satellite_orbit.py integrates over the turning Earth.
TEST(MotionInput, AStateGoesOnUnderGravityOverTheTurningEarth) {
  scene::Scene scene = scene_with_state(sentinel_m, sentinel_mps);
  ASSERT_EQ(messages(read_motions(scene, {})), "");
  const scene::ReadPath& path = *scene.platforms[0].read_path;
  const std::pair<double, core::Vec3> expected[] = {{-60.0, {2106052.660777, -6295652.295544, -2459570.336658}},
                                                    {0.0, sentinel_m},
                                                    {60.0, {1999809.972282, -6597471.772572, -1607165.949963}}};
  const auto earth = scene::earth_of(scene.world);
  for (const auto& [time_s, ecef_m] : expected) {
    const auto at = path.states->at(time_s);
    ASSERT_TRUE(at);
    EXPECT_LT(core::norm(earth->ecef_from_world(at->position_m) - ecef_m), 2e-6) << time_s;
  }
  const auto now = path.states->at(0.0);
  EXPECT_LT(core::norm(earth->ecef_axes_from_world(now->velocity_mps) - sentinel_mps), 1e-7);
  EXPECT_EQ(path.description,
            "from a state, under gravity with J2: 7072.3 to 7084.9 km from the centre, inclination 98.1769 deg");
}

TEST(MotionInput, AStateIsMadeAnewWhereItChanged) {
  scene::Scene scene = scene_with_state(sentinel_m, sentinel_mps);
  ASSERT_EQ(messages(read_motions(scene, {})), "");
  const auto first = scene.platforms[0].read_path;
  scene.platforms[0].state_velocity_mps.z += 1.0;
  ASSERT_EQ(messages(read_motions(scene, {})), "");
  EXPECT_NE(scene.platforms[0].read_path.get(), first.get());
}

TEST(MotionInput, RefusesStatesThatAreNoOrbits) {
  const auto told = [](const core::Vec3& position_m, const core::Vec3& velocity_mps) {
    scene::Scene scene = scene_with_state(position_m, velocity_mps);
    const std::string said = messages(read_motions(scene, {}));
    return said + (scene.platforms[0].read_path ? "path" : "none");
  };
  EXPECT_THAT(told({6000e3, 0.0, 0.0}, {0.0, 7000.0, 0.0}),
              testing::AllOf(HasSubstr("error: the state of the orbit is inside the Earth"),
                             HasSubstr("-378.137 km above the ellipsoid"), testing::EndsWith("none")));
  // 7.5 km/s for 7500 m/s falls like a stone, from high enough not within the recording.
  EXPECT_THAT(told(sentinel_m, 1e-3 * sentinel_mps),
              testing::AllOf(HasSubstr("warning: the orbit comes down to the ground"), testing::EndsWith("path")));
  EXPECT_THAT(told({6378.2e3, 0.0, 0.0}, {-7000.0, 0.0, 0.0}),
              testing::AllOf(HasSubstr("error: the orbit meets the ground within the recordings"),
                             HasSubstr("above the ellipsoid at"), testing::EndsWith("none")));
  EXPECT_THAT(told(sentinel_m, 2.0 * sentinel_mps),
              testing::AllOf(HasSubstr("warning: the state belongs to no orbit"), testing::EndsWith("path")));
  scene::Scene late = scene_with_state(sentinel_m, sentinel_mps);
  late.geometries[0].time_end_s = 1e12;
  EXPECT_THAT(messages(read_motions(late, {})), HasSubstr("found '1000000000000 s from time 0'"));
  EXPECT_FALSE(late.platforms[0].read_path);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(told({nan, 0.0, 0.0}, {0.0, 7000.0, 0.0}), "none");
}

constexpr const char* vanguard =
    "1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753\n"
    "2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667\n";

TEST(MotionInput, ElementsOfATleAreEvaluatedBySgp4) {
  const test::TestFolder own;
  const std::filesystem::path& folder = own.path();
  std::ofstream(folder / "vanguard.tle") << vanguard;
  // 4320 min behind the epoch of the elements; earth-fixed place of the Spacetrack verification set, km.
  scene::Scene scene = earth_scene(0.0, 1.0);
  scene.world.epoch = "2000-06-30T18:50:19.733568Z";
  scene::Platform& platform = scene.platforms[0];
  platform.path = scene::Platform::Path::ephemeris;
  platform.ephemeris_file = "vanguard.tle";
  ASSERT_EQ(messages(read_motions(scene, folder)), "");
  const auto at = platform.read_path->states->at(0.0);
  const core::Vec3 ecef_km{6692.370040, -7681.662711, 813.686732};
  const double off_m = core::norm(at->position_m - 1e3 * core::Vec3{ecef_km.y, ecef_km.z, ecef_km.x} +
                                  core::Vec3{0.0, 0.0, radar::wgs84_semi_major_m});
  EXPECT_LT(off_m, 1.0);  // the reference turns the Earth by a slightly different UT1
  EXPECT_NEAR(core::norm(at->position_m + core::Vec3{0.0, 0.0, radar::wgs84_semi_major_m}), 1e3 * core::norm(ecef_km),
              1e-2);
}

TEST(MotionInput, IsMadeAnewOnlyWhereItDependsOnWhatChanged) {
  scene::Scene scene = earth_scene(0.0, 1.0);
  scene.platforms[0].path = scene::Platform::Path::orbit;
  ASSERT_EQ(messages(read_motions(scene, {})), "");
  const auto first = scene.platforms[0].read_path;
  ASSERT_EQ(messages(read_motions(scene, {})), "");
  EXPECT_EQ(scene.platforms[0].read_path, first);
  scene.geometries[0].time_end_s = 2000.0;
  ASSERT_EQ(messages(read_motions(scene, {})), "");
  EXPECT_NE(scene.platforms[0].read_path.get(), first.get());
  EXPECT_TRUE(scene.platforms[0].read_path->states->covers(0.0, 2000.0));
}

TEST(MotionInput, TellsOfASatelliteThatIsNotLookedFor) {
  const test::TestFolder own;
  std::ofstream table(own.path() / "t.csv");
  table << "t,x,y,z\n";
  for (int i = -5; i < 16; ++i) table << fmt::format("{},7000000,{},0\n", 10 * i, 70000 * i);
  table.close();
  scene::Scene scene = earth_scene(0.0, 100.0);
  scene::Platform& platform = scene.platforms[0];
  platform.path = scene::Platform::Path::ephemeris;
  platform.ephemeris_file = "t.csv";
  EXPECT_EQ(messages(read_motions(scene, own.path())), "");
  platform.satellite = "S1A";
  const std::string told = messages(read_motions(scene, own.path()));
  EXPECT_THAT(told, HasSubstr("warning: t.csv holds one path, and the satellite is not looked for; found 'S1A'"));
  EXPECT_TRUE(platform.read_path);
}

TEST(MotionInput, SaysWhatIsMissing) {
  const test::TestFolder own;
  const std::filesystem::path& folder = own.path();
  std::ofstream(folder / "t.csv") << "t,x,y,z\n0,7000000,0,0\n10,7000000,70000,0\n20,7000000,140000,0\n";
  scene::Scene scene = earth_scene(0.0, 100.0);
  scene::Platform& platform = scene.platforms[0];
  platform.path = scene::Platform::Path::ephemeris;
  platform.ephemeris_file = "none.csv";
  EXPECT_THAT(messages(read_motions(scene, folder)), HasSubstr("cannot be read"));
  platform.ephemeris_file = "t.csv";
  EXPECT_THAT(messages(read_motions(scene, folder)), HasSubstr("t.csv"));
  platform.path = scene::Platform::Path::orbit;
  scene.world.frame = scene::World::Frame::flat;
  EXPECT_THAT(messages(read_motions(scene, folder)), HasSubstr("the world is flat"));
}

// A circle of 120 s on a flat world, with a radar of 30 cm that flies it.
scene::Scene circling(const std::filesystem::path& folder, double step_s, bool velocities) {
  std::ofstream table(folder / "t.csv");
  table << (velocities ? "t,x,y,z,vx,vy,vz\n" : "t,x,y,z\n");
  const double rate = 2.0 * core::pi / 120.0;
  for (double t = -240.0; t <= 240.0; t += step_s) {
    table << fmt::format("{},{},{},500", t, 1000.0 * std::cos(rate * t), 1000.0 * std::sin(rate * t));
    if (velocities)
      table << fmt::format(",{},{},0", -1000.0 * rate * std::sin(rate * t), 1000.0 * rate * std::cos(rate * t));
    table << "\n";
  }
  scene::Scene scene = earth_scene(-10.0, 10.0);
  scene.world = {};
  scene.platforms[0].name = "Plane";
  scene.platforms[0].path = scene::Platform::Path::ephemeris;
  scene.platforms[0].ephemeris_file = "t.csv";
  scene.radars.resize(1);
  scene.radars[0].platform = "Plane";
  scene.geometries[0].radar = scene.radars[0].name;
  return scene;
}

TEST(MotionInput, WarnsOfStatesThatAreTooFarApartForTheWavelength) {
  const test::TestFolder own;
  scene::Scene scene = circling(own.path(), 30.0, false);
  const std::string told = messages(read_motions(scene, own.path()));
  EXPECT_THAT(told, HasSubstr("warning: t.csv: its states are too far apart"));
  EXPECT_THAT(told, HasSubstr("73.3 wavelengths of radar Radar1; a state every 30 s"));
  EXPECT_THAT(told, HasSubstr("less than 1/16 of a wavelength, 18.7 mm"));
  EXPECT_EQ(messages(read_motions(scene, own.path())), told);  // Also where nothing is read again.
  scene.radars[0].carrier_hz = 1e5;
  EXPECT_EQ(messages(read_motions(scene, own.path())), "");
  scene = circling(own.path(), 5.0, false);
  EXPECT_EQ(messages(read_motions(scene, own.path())), "");
  scene = circling(own.path(), 10.0, true);
  EXPECT_EQ(messages(read_motions(scene, own.path())), "");
  scene = circling(own.path(), 30.0, false);
  scene.radars[0].platform = "Earth";  // Nothing uses the platform.
  EXPECT_EQ(messages(read_motions(scene, own.path())), "");
}

// An orbit by its state at time 0, sampled every so often.
void write_orbit(const std::filesystem::path& file, double step_s, int reach) {
  std::ofstream table(file);
  table << "t,x,y,z,vx,vy,vz\n";
  const radar::SecularOrbit orbit({6786e3, 0.0005, 0.9, 1.0, 2.0, 3.0});
  for (int i = -reach; i <= reach; ++i) {
    const double t = step_s * i;
    const radar::OrbitMotion at = orbit.at(t);
    const radar::StateVector turned =
        radar::turning_about_z(radar::earth_rate_rad_per_s * t, radar::earth_rate_rad_per_s)
            .to({at.position_m, at.velocity_mps});
    const core::Vec3 &p = turned.position_m, &v = turned.velocity_mps;
    table << fmt::format("{},{:.6f},{:.6f},{:.6f},{:.9f},{:.9f},{:.9f}\n", t, p.x, p.y, p.z, v.x, v.y, v.z);
  }
}

TEST(MotionInput, RefusesStatesBetweenWhichNothingIsKnown) {
  const test::TestFolder own;
  const auto told = [&](double step_s) {
    write_orbit(own.path() / "o.csv", step_s, 6);
    scene::Scene scene = earth_scene(-1.0, 1.0);
    scene.platforms[0].path = scene::Platform::Path::ephemeris;
    scene.platforms[0].ephemeris_file = "o.csv";
    const std::string said = messages(read_motions(scene, own.path()));
    return said + (scene.platforms[0].read_path ? "path" : "none");
  };
  EXPECT_EQ(told(60.0), "path");
  EXPECT_EQ(told(900.0), "path");  // 40 m off, and no radar whose wavelength it could be compared with
  EXPECT_THAT(told(1800.0), testing::AllOf(HasSubstr("error: o.csv: between its states the path is not known"),
                                           testing::EndsWith("none")));
  EXPECT_THAT(told(5570.0), testing::AllOf(HasSubstr("error: o.csv: its states are too far apart to tell the orbit"),
                                           testing::EndsWith("none")));
}

// @param gap  seconds whose attitudes are left out: the first and the one behind the last
scene::Scene with_attitudes(const std::filesystem::path& folder, double flip_from_s, std::pair<int, int> gap = {0, 0}) {
  std::ofstream file(folder / "a.aem");
  file << "CCSDS_AEM_VERS = 1.0\nCREATION_DATE = 2024-04-02T00:00:00\nORIGINATOR = TEST\nMETA_START\nOBJECT_NAME = A\n"
          "OBJECT_ID = 1\nREF_FRAME_A = ITRF\nREF_FRAME_B = SC_BODY_1\nATTITUDE_DIR = A2B\nTIME_SYSTEM = UTC\n"
          "START_TIME = 2000-06-27T18:50:00\nSTOP_TIME = 2000-06-27T18:50:40\nATTITUDE_TYPE = QUATERNION\n"
          "QUATERNION_TYPE = LAST\nMETA_STOP\nDATA_START\n";
  for (int i = 0; i <= 40; ++i)
    if (i < gap.first || i >= gap.second)
      file << fmt::format("2000-06-27T18:50:{:02} {}\n", i, i < flip_from_s ? "0 0 0 1" : "1 0 0 0");
  file << "DATA_STOP\n";
  scene::Scene scene = earth_scene(-1.0, 1.0);
  scene.platforms[0].rotation_kind = scene::Platform::Rotation::quaternions;
  scene.platforms[0].attitude_file = "a.aem";
  return scene;
}

TEST(MotionInput, RefusesAttitudesThatJump) {
  const test::TestFolder own;
  scene::Scene scene = with_attitudes(own.path(), 100);
  EXPECT_EQ(messages(read_motions(scene, own.path())), "");
  scene = with_attitudes(own.path(), 20);
  EXPECT_THAT(
      messages(read_motions(scene, own.path())),
      testing::AllOf(HasSubstr("error: a.aem: an attitude is turned too far"), HasSubstr("180 deg within 1 s")));
  EXPECT_FALSE(scene.platforms[0].read_attitude);
  scene = with_attitudes(own.path(), 35);
  EXPECT_THAT(messages(read_motions(scene, own.path())),
              HasSubstr("warning: a.aem: an attitude beside the recordings"));
  EXPECT_TRUE(scene.platforms[0].read_attitude);
}

TEST(MotionInput, RefusesAttitudesWithAGapInTheRecordings) {
  const test::TestFolder own;
  // The recordings are from 18:50:19 to 18:50:21.
  scene::Scene scene = with_attitudes(own.path(), 100, {18, 21});
  EXPECT_THAT(messages(read_motions(scene, own.path())), HasSubstr("warning: "));
  EXPECT_TRUE(scene.platforms[0].read_attitude);  // Of 4 steps.
  scene = with_attitudes(own.path(), 100, {16, 22});
  EXPECT_THAT(messages(read_motions(scene, own.path())), HasSubstr("error: the attitudes of a.aem have a gap"));
  EXPECT_FALSE(scene.platforms[0].read_attitude);
  scene = with_attitudes(own.path(), 100, {2, 10});
  EXPECT_TRUE((static_cast<void>(read_motions(scene, own.path())), scene.platforms[0].read_attitude));
}

}  // namespace motion_input_test
}  // namespace sarsim::workflow
