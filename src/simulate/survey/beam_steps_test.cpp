#include "simulate/survey/beam_steps.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/survey/survey.hpp"

namespace sarsim::simulate {
namespace beam_steps_test {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

// A beam of 2 degrees that turns by so many degrees from pulse to pulse, 1000 a second.
scene::Scene turning_scene(double step_deg, double time_s) {
  scene::Scene scene = one_target_scene();
  scene.targets = {target_on("Earth", {0.0, 1000.0, 0.0})};
  scene.radars[0].prf_hz = 1000.0;
  scene.radars[0].transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  scene.radars[0].transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(2.0);
  scene.radars[0].transmit_antenna.elevation_beamwidth = core::Angle::from_deg(20.0);
  scene.radars[0].beam = scene::Radar::Beam::rotating;
  scene.radars[0].beam_rate = core::Angle::from_deg(1000.0 * step_deg);
  scene.simulations[0].time_end_s = time_s;
  return scene;
}

TEST(BeamSteps, SayWhatABeamThatJumpsNeverIlluminates) {
  // Ten directions, each 2 degrees wide.
  for (const double step_deg : {36.0, -36.0, 324.0}) {
    const auto steps = beam_steps(acquisition_of(turning_scene(step_deg, 1.0), 0));
    ASSERT_TRUE(steps) << step_deg;
    EXPECT_NEAR(steps->step_rad, std::abs(step_deg) * core::pi / 180.0, 1e-9);
    EXPECT_NEAR(steps->width_rad, 2.0 * core::pi / 180.0, 0.03 * steps->width_rad);
    EXPECT_NEAR(steps->sector_rad, 2.0 * core::pi, 1e-9);
    EXPECT_NEAR(steps->unlit_share, 1.0 - 10.0 * 2.0 / 360.0, 0.005);
  }
  // Four steps of 3 degrees in a sector, of which each illuminates 2.
  EXPECT_NEAR(beam_steps(acquisition_of(turning_scene(3.0, 0.0045), 0)).value().unlit_share, 1.0 / 3.0, 0.01);
  // A whole turn from pulse to pulse: one direction.
  EXPECT_NEAR(beam_steps(acquisition_of(turning_scene(360.0, 1.0), 0)).value().unlit_share, 1.0 - 2.0 / 360.0, 1e-3);
  EXPECT_THAT(survey(turning_scene(36.0, 1.0)),
              Contains(AllOf(Field(&core::Problem::message, HasSubstr("94 % of the directions")),
                             Field(&core::Problem::found, HasSubstr("a turn of 36 deg from pulse to pulse")))));
}

TEST(BeamSteps, AreNothingWhereEveryDirectionIsIlluminated) {
  EXPECT_FALSE(beam_steps(acquisition_of(turning_scene(1.9, 1.0), 0)));
  // 2.1 degrees a pulse: those of later turns lie between those of the first.
  EXPECT_NEAR(beam_steps(acquisition_of(turning_scene(2.11, 4.0), 0)).value().unlit_share, 0.0, 1e-9);
  for (const double step_deg : {1.9, 2.11})
    for (const core::Problem& problem : survey(turning_scene(step_deg, 4.0)))
      EXPECT_THAT(problem.message, Not(HasSubstr("never illuminated")));
}

// An antenna that is fixed to a platform that turns does the same.
TEST(BeamSteps, AreThoseOfAPlatformThatTurns) {
  scene::Scene scene = turning_scene(0.0, 1.0);
  scene.radars[0].beam = scene::Radar::Beam::fixed;
  scene.platforms.push_back(resting("Mast", {}));
  scene.platforms.back().rotation_rate[2] = core::Angle::from_deg(36000.0);
  scene.radars[0].platform = "Mast";
  EXPECT_NEAR(beam_steps(acquisition_of(scene, 0)).value().unlit_share, 1.0 - 10.0 * 2.0 / 360.0, 0.005);
}

}  // namespace beam_steps_test
}  // namespace sarsim::simulate
