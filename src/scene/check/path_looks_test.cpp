#include "scene/check/path_looks.hpp"

#include <limits>

#include "core/maths/constants.hpp"
#include "scene/check/check_test_scene.hpp"

namespace sarsim::scene {
namespace path_looks_test {

// A radar on a rotor on a ship, and one on the ground; a target on a mast of the ship.
Scene scene_of_ship() {
  Scene scene = sound_scene();
  scene.platforms.clear();
  scene.targets.clear();
  // Copies: an element of the list itself must not be assigned to it.
  scene.radars.assign(2, Radar(scene.radars.front()));
  scene.simulations.assign(2, Simulation(scene.simulations.front()));
  for (const char* const name : {"Ship", "Rotor", "Beside", "Ground"}) scene.platforms.emplace_back().name = name;
  scene.platforms[1].parent = "Ship";
  scene.platforms[1].position_m = {0.0, 0.0, 20.0};
  scene.platforms[2].path = Platform::Path::relative;
  scene.platforms[2].leader = "Ship";
  for (std::size_t i = 0; i < 2; ++i) {
    scene.radars[i].name = i == 0 ? "OnRotor" : "OnGround";
    scene.radars[i].platform = i == 0 ? "Rotor" : "Ground";
    scene.radars[i].carrier_hz = i == 0 ? 10e9 : 1e9;
    scene.simulations[i].radar = scene.radars[i].name;
  }
  return scene;
}

TEST(PathLooks, AreThoseOfRadarsThatThePlatformCarries) {
  const Scene scene = scene_of_ship();
  // Of two that look at one time with one beamwidth the shorter wavelength speaks for both.
  ASSERT_EQ(looks_of(scene).size(), 1U);
  EXPECT_EQ(looks_of(scene).front().radar, "OnRotor");
  for (const std::size_t platform : {0U, 1U}) {
    const std::vector<Look> looks = looks_of(scene, platform);
    ASSERT_EQ(looks.size(), 1U) << platform;
    EXPECT_EQ(looks[0].radar, "OnRotor");
    EXPECT_NEAR(looks[0].wavelength_m, 0.0299792458, 1e-12);
  }
  EXPECT_TRUE(looks_of(scene, 2).empty());
  EXPECT_EQ(looks_of(scene, 3).front().radar, "OnGround");
}

TEST(PathLooks, AreThoseOfAllRadarsWhereThePlatformReflects) {
  Scene scene = scene_of_ship();
  scene.targets.resize(3);
  scene.targets[2].platform = std::string("Beside");
  scene.targets[2].position_m = {3.0, 4.0, 0.0};
  scene.simulations[1].time_end_s += 1.0;
  EXPECT_EQ(looks_of(scene, 0).size(), 2U);  // Which leads the platform of the target.
  EXPECT_EQ(looks_of(scene, 2).size(), 2U);
  EXPECT_EQ(looks_of(scene, 1).size(), 1U);
  EXPECT_EQ(arm_m(scene, 0), 20.0);
  EXPECT_EQ(arm_m(scene, 2), 5.0);
}

TEST(PathLooks, KnowTheNarrowestCutOfTheBeam) {
  Scene scene = scene_of_ship();
  Antenna& antenna = scene.radars[0].transmit_antenna;
  scene.radars[0].same_antenna = true;
  antenna.pattern = Antenna::Pattern::isotropic;
  EXPECT_EQ(looks_of(scene, 0).front().beamwidth_rad, std::numeric_limits<double>::infinity());
  antenna.pattern = Antenna::Pattern::sinx;
  antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
  EXPECT_NEAR(looks_of(scene, 0).front().beamwidth_rad, 2.0 * core::rad_per_deg, 1e-12);
  antenna.pattern = Antenna::Pattern::user;
  antenna.gain_db.part[0].knots = {{-5.0, -20.0}, {-1.0, -3.0}, {0.0, 0.0}, {1.5, -3.0}, {5.0, -20.0}};
  EXPECT_NEAR(looks_of(scene, 0).front().beamwidth_rad, 2.0 * core::rad_per_deg, 1e-12);
}

}  // namespace path_looks_test
}  // namespace sarsim::scene
