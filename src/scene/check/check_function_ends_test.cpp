#include <functional>
#include <random>
#include <string>

#include "scene/check/check_test_scene.hpp"

namespace sarsim::scene {
namespace check_function_ends_test {

using testing::HasSubstr;

Scene with_stc(std::initializer_list<core::Knot> knots) {
  Scene scene = sound_scene();
  scene.radars[0].stc = Radar::Stc::user;
  scene.radars[0].stc_gain.part[0] = points(knots);
  return scene;
}

// The recording is from 10.01 to 10.51 km.
TEST(CheckFunctionEnds, TellsOfGainsOfTheReceiverBeyondTheirRanges) {
  const core::Problem held = expect_warning(with_stc({{0, 0.1}, {5000, 1}}), {"radar", 0, "stc_gain"});
  EXPECT_THAT(held.message, HasSubstr("keeps the value of the nearer end"));
  EXPECT_THAT(held.found, HasSubstr("points from 0 m to 5000 m"));
  EXPECT_THAT(held.found, HasSubstr("there it is 1"));
  Scene classic = with_stc({{0, 0.1}, {5000, 1}});
  classic.options.profile = Profile::classic;
  EXPECT_THAT(expect_warning(classic, {"radar", 0, "stc_gain"}).found, HasSubstr("there it is 1.9918"));
  EXPECT_TRUE(check(with_stc({{0, 0.1}, {10510, 1}})).empty());
  EXPECT_TRUE(check(with_stc({{0, 0.1}})).empty());
}

TEST(CheckFunctionEnds, TellsOfPulsesThatTheirPointsDoNotCover) {
  Scene scene = sound_scene();
  scene.radars[0].envelope = Radar::Envelope::user;
  scene.radars[0].envelope_gain.part[0] = points({{0.1, 1}, {0.5, 0.7}, {0.85, 0.4}});
  EXPECT_THAT(expect_warning(scene, {"radar", 0, "envelope_gain"}).found, HasSubstr("there it is 0.4"));
  scene.radars[0].envelope_gain.part[0] = points({{0, 1}, {0.99999, 0.4}});
  EXPECT_TRUE(check(scene).empty());
  scene = sound_scene();
  scene.radars[0].window = Radar::Window::user;
  scene.radars[0].window_gain.part[0] = points({{0, 0.2}, {0.5, 1}});
  EXPECT_THAT(expect_warning(scene, {"radar", 0, "window_gain"}).message, HasSubstr("matched-filter window"));
}

TEST(CheckFunctionEnds, TellsOfPointsThatAPulseNeverMeets) {
  Scene scene = sound_scene();
  scene.radars[0].envelope = Radar::Envelope::user;
  scene.radars[0].envelope_gain.part[0] = points({{0, 1}, {50, 0.7}, {100, 0.4}});
  const core::Problem problem = expect_warning(scene, {"radar", 0, "envelope_gain"});
  EXPECT_THAT(problem.message, HasSubstr("most of the pulse envelope is never used"));
  EXPECT_THAT(problem.found, HasSubstr("points from 0 to 100, 1 % of them within"));
  scene.radars[0].envelope_gain.part[0] = points({{-0.2, 1}, {0.5, 0.7}, {1.5, 0.4}});
  EXPECT_TRUE(check(scene).empty());
}

// From -0.5 to 1.499 s. Straight lines through two points are meant to go on.
TEST(CheckFunctionEnds, TellsOfMotionsThatEndBeforeTheRecording) {
  Scene scene = sound_scene();
  scene.platforms[0].rotation_kind = Platform::Rotation::user;
  scene.platforms[0].rotation_deg.part = {points({{0, 0}, {1, 90}}), points({{0, 0}}), points({{0, 0}})};
  EXPECT_TRUE(check(scene).empty());
  scene.platforms[0].rotation_deg.part[1] = points({{-0.5, 0}, {0, 1}, {0.5, 0}});
  const core::Problem problem = expect_warning(scene, {"platform", 0, "rotation_deg"});
  EXPECT_THAT(problem.message, HasSubstr("goes on at the last rate"));
  EXPECT_THAT(problem.found, HasSubstr("points from -500 ms to 500 ms"));
  EXPECT_THAT(problem.found, HasSubstr("there it is -1.998"));
  scene.platforms[0].rotation_deg.part[1] = points({{-0.5, 0}, {0, 1}, {1.4, 0}});  // less than a spacing is missing
  EXPECT_EQ(expect_single(scene, core::Severity::note, {"platform", 0, "rotation_deg"}).severity, core::Severity::note);
  scene.platforms[0].rotation_deg.part[1] = points({{-0.5, 0}, {0, 1}, {1.5, 0}});
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckFunctionEnds, TellsOfCutsOfMoreThanATurn) {
  Scene scene = sound_scene();
  scene.radars[0].transmit_antenna.pattern = Antenna::Pattern::user;
  scene.radars[0].transmit_antenna.gain_db.part = {points({{-180, -30}, {0, 0}, {200, -30}}), points({{0, 0}})};
  EXPECT_THAT(expect_warning(scene, {"radar", 0, "transmit_antenna"}).found, HasSubstr("-180 to 200 deg"));
  scene.radars[0].transmit_antenna.gain_db.part[0] = points({{0, -30}, {180, 0}, {360, -30}});
  EXPECT_TRUE(check(scene).empty());
}

// Functions that are given as far as they are used are no matter for remarks.
TEST(CheckFunctionEnds, IsSilentOfFunctionsThatReachAsFarAsTheyAreUsed) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> more(0.0, 2.0), gain(0.1, 1.0);
  for (int draw = 0; draw < 50; ++draw) {
    Scene scene = with_stc({{10010.0 - more(random), gain(random)}, {10510.0 + more(random), gain(random)}});
    scene.radars[0].envelope = Radar::Envelope::user;
    scene.radars[0].envelope_gain.part[0] = points({{0, gain(random)}, {0.4, 1}, {1, gain(random)}});
    scene.platforms[0].rotation_kind = Platform::Rotation::user;
    for (core::SampledFunction& part : scene.platforms[0].rotation_deg.part)
      part = points({{-0.5 - more(random), gain(random)}, {0, gain(random)}, {1.499 + more(random), gain(random)}});
    EXPECT_TRUE(check(scene).empty());
  }
}

}  // namespace check_function_ends_test
}  // namespace sarsim::scene
