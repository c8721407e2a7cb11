#include "simulate/survey/pulse_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/survey/derived.hpp"
#include "simulate/survey/survey.hpp"
#include "simulate/survey/survey_echoes.hpp"

namespace sarsim::simulate {
namespace pulse_motion_test {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double c = core::exact_light_speed_mps;
constexpr std::array<std::size_t, 1> first_target{0};

// pi f tau''' Tp^3/24 with tau''' = 2 d'''/c.
double phase_of(double third_mps3, double carrier_hz, double width_s) {
  return core::pi * carrier_hz * (2.0 * third_mps3 / c) * width_s * width_s * width_s / 24.0;
}

// 0.9 ms at 77 GHz, 1000 pulses a second about t = 0.
scene::Scene long_pulses(double half_time_s) {
  scene::Scene scene = one_target_scene();
  scene::Radar& radar = scene.radars[0];
  radar.carrier_hz = 77e9;
  radar.pulse_width_s = 0.9e-3;
  radar.prf_hz = 1000.0;
  scene::Simulation& simulation = scene.simulations[0];
  simulation.range_start_m = 0.0;
  simulation.range_end_m = 140e3;
  simulation.time_start_s = -half_time_s;
  simulation.time_end_s = half_time_s;
  simulation.sample_rate_hz = 1e5;
  return scene;
}

// A target turns about a far point on a circle of 2 m.
scene::Scene turning(double rate_rad_per_s) {
  scene::Scene scene = long_pulses(1.0);
  scene::Platform table = resting("Table", {1000.0, 0.0, 0.0});
  table.rotation_rate[2] = core::Angle::from_rad(rate_rad_per_s);
  scene.platforms.push_back(table);
  scene.targets = {target_on("Table", {2.0, 0.0, 0.0})};
  return scene;
}

std::string said(const scene::Scene& scene) {
  std::string text;
  for (const core::Problem& problem : survey(scene)) text += core::to_string(problem) + "\n";
  return text;
}

// The distance to a point of a circle is D + r cos(w t) but for parts of r/D: its third derivative is at most r w^3.
TEST(PulseMotion, OfACircleIsThatOfTheThirdDerivative) {
  const double rate = 40.0;
  const double exact = phase_of(2.0 * rate * rate * rate, 77e9, 0.9e-3);
  // Parts of r/D are 0.4 % at most; a pulse stands within w 0.5 ms = 0.02 rad of the sine's peak, 2e-4 below it.
  EXPECT_NEAR(motion_left_in_pulse(acquisition_of(turning(rate), 0), first_target).phase_rad, exact, 0.005 * exact);
}

// |d'''| = 3 V^3 x/(R^2 (1 + x^2)^(5/2)) with x = V t/R: most at x = 1/2, where it is 0.8587 V^3/R^2.
TEST(PulseMotion, OfAStraightPassHasTheBoundOfTheTheory) {
  scene::Scene scene = long_pulses(10.0);  // looks 20 ms apart, of a pass whose x = 1/2 comes after 83 ms
  scene.platforms.push_back(moving("Car", {5.0, 0.0, 0.0}, {0.0, 30.0, 0.0}));
  scene.targets = {target_on("Car", {})};
  const PulseMotion found = motion_left_in_pulse(acquisition_of(scene, 0), first_target);
  const double exact = phase_of(0.8587 * 27000.0 / 25.0, 77e9, 0.9e-3);
  // 3 ms off the peak are 0.018 in x, where the second derivative takes 2.4 x^2 of it: less than 1e-3.
  EXPECT_NEAR(found.phase_rad, exact, 1e-3 * exact);
  EXPECT_NEAR(std::abs(static_cast<double>(found.pulse)) * 1e-3, 0.5 * 5.0 / 30.0, 3e-3);
  EXPECT_EQ(found.target, 0U);
}

// Far below what anybody notes, the bound by speeds and accelerations is all that is looked at: the circle's phase and,
// of 3 w r (2 w^2 r + ...)/D with D = 1000 m and r = 2 m, 12 r/D of it more; a turning axis counts sqrt(2) at most.
TEST(PulseMotion, IsABoundWhereItIsFarTooSmallToNote) {
  const double rate = std::cbrt(1e-8 / phase_of(2.0, 77e9, 0.9e-3));
  const double exact = phase_of(2.0 * rate * rate * rate, 77e9, 0.9e-3);
  const double found = motion_left_in_pulse(acquisition_of(turning(rate), 0), first_target).phase_rad;
  EXPECT_GT(found, 0.999 * exact);
  EXPECT_LT(found, 1.5 * exact);
}

TEST(PulseMotion, IsNoneAtRestAndWithTheLightTimeOfTheThesis) {
  EXPECT_EQ(motion_left_in_pulse(acquisition_of(turning(0.0), 0), first_target).phase_rad, 0.0);
  EXPECT_EQ(motion_left_in_pulse(acquisition_of(turning(40.0), 0), {}).phase_rad, 0.0);
  scene::Scene classic = turning(40.0);
  classic.options.profile = scene::Profile::classic;
  EXPECT_EQ(motion_left_in_pulse(acquisition_of(classic, 0), first_target).phase_rad, 0.0);
}

TEST(PulseMotion, IsANoteFromOneHundredthRadianAndAWarningFromATenth) {
  const auto rate_of = [](double phase_rad) { return std::cbrt(phase_rad / phase_of(2.0, 77e9, 0.9e-3)); };
  EXPECT_THAT(said(turning(rate_of(0.009))), Not(HasSubstr("motion within a pulse")));
  EXPECT_THAT(said(turning(rate_of(0.02))), HasSubstr("note: motion within a pulse"));
  EXPECT_THAT(said(turning(rate_of(0.2))), HasSubstr("warning: motion within a pulse"));
  EXPECT_THAT(said(turning(rate_of(0.2))), HasSubstr("rad, for target 1 at "));
}

TEST(PulseMotion, IsAmongTheFiguresOfASimulation) {
  const Acquisition acquisition = acquisition_of(turning(40.0), 0);
  EXPECT_EQ(simulation_figures(acquisition, survey_echoes(acquisition)).pulse_motion_rad,
            motion_left_in_pulse(acquisition, first_target).phase_rad);
}

}  // namespace pulse_motion_test
}  // namespace sarsim::simulate
