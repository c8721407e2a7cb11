#include "simulate/run/measure_machine.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "core/task/stop.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace measure_machine_test {

// Any machine is within a factor of a hundred of any other; a build with sanitizers is slow, none is idle.
TEST(MeasureMachine, FindsEveryPart) {
  const MachineSpeed speed = measure_machine();
  for (const double part :
       {speed.samples, speed.noise, speed.compression, speed.direct, speed.spectral, speed.reference}) {
    EXPECT_GT(part, 0.01);
    EXPECT_LE(part, 100.0);
  }
}

TEST(MeasureMachine, StopsWhenAsked) {
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)measure_machine(&stop), core::Interrupted);
}

// Parts of a speed act on the recordings that have them, and on no others.
TEST(MeasureMachine, PartsOfASpeedActOnTheirOwn) {
  scene::Scene scene = one_target_scene();
  const auto seconds = [&](const MachineSpeed& speed) {
    const Cost cost = estimated_cost(make_plan(scene, 0, nullptr, Engine::direct), 1, speed);
    return cost.seconds - cost.start_seconds;
  };
  const double once_s = seconds({});
  EXPECT_NEAR(seconds({.samples = 3.0, .direct = 3.0}), 3.0 * once_s, 1e-9 * once_s);
  EXPECT_EQ(seconds({.noise = 3.0, .compression = 3.0, .spectral = 3.0, .reference = 3.0}), once_s);
  scene.radars[0].noise_temperature_k = 290.0;
  EXPECT_GT(seconds({.noise = 3.0}), seconds({}));
}

}  // namespace measure_machine_test
}  // namespace sarsim::simulate
