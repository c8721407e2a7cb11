#include "workflow/input/script_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "radar/earth/geoid_test_support.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/model/read_path.hpp"

namespace sarsim::workflow {
namespace script_sum_test {

// From 5000 to 5002 s.
scene::Scene needing_two_seconds() {
  scene::Scene scene;
  scene.platforms.resize(1);
  scene.geometries.resize(1);
  scene.geometries[0].time_start_s = 5000.0;
  scene.geometries[0].time_end_s = 5002.0;
  return scene;
}

// A state every second for 10 000 s, one of them moved.
std::string sum_with_states(double moved_at_s, double by_m) {
  radar::StateSamples samples;
  for (int i = 0; i <= 10'000; ++i) {
    const double time_s = i;
    samples.time_s.push_back(time_s);
    samples.position_m.push_back({7000.0 * time_s + (time_s == moved_at_s ? by_m : 0.0), 0.0, 7e6});
  }
  scene::Scene scene = needing_two_seconds();
  auto path = std::make_shared<scene::ReadPath>();
  path->states = std::make_shared<const radar::StateTable>(
      std::get<radar::StateTable>(radar::StateTable::from(samples, radar::lagrange_8_points)));
  path->usable = {0.0, 10'000.0};
  scene.platforms[0].read_path = std::shared_ptr<const scene::ReadPath>(std::move(path));
  return script_sum(scene);
}

TEST(ScriptSum, KnowsEveryStateThatARecordingNeeds) {
  const std::string sum = sum_with_states(-1.0, 0.0);
  EXPECT_EQ(sum_with_states(-1.0, 0.0), sum);
  for (const double at_s : {5000.0, 5001.0, 5002.0}) EXPECT_NE(sum_with_states(at_s, 0.01), sum) << at_s;
}

std::string sum_with_attitudes(double roll_rad) {
  radar::AttitudeSamples samples;
  for (int i = 0; i <= 100; ++i) {
    samples.time_s.push_back(4950.0 + i);
    const double half = 0.5 * (i == 51 ? roll_rad : 0.0);
    samples.world_from_platform.push_back({std::cos(half), std::sin(half), 0.0, 0.0});
  }
  scene::Scene scene = needing_two_seconds();
  scene.platforms[0].rotation_kind = scene::Platform::Rotation::quaternions;
  auto attitude = std::make_shared<scene::ReadAttitude>();
  attitude->attitudes =
      std::make_shared<const radar::AttitudeTable>(std::get<radar::AttitudeTable>(radar::AttitudeTable::from(samples)));
  attitude->usable = {4950.0, 5050.0};
  scene.platforms[0].read_attitude = std::shared_ptr<const scene::ReadAttitude>(std::move(attitude));
  return script_sum(scene);
}

TEST(ScriptSum, KnowsTheAttitudes) {
  EXPECT_EQ(sum_with_attitudes(0.0), sum_with_attitudes(0.0));
  EXPECT_NE(sum_with_attitudes(0.0), sum_with_attitudes(1e-6));
}

// Altitudes become heights as the scene is read, so that the grid counts where a place needs it.
TEST(ScriptSum, KnowsTheGeoidByThePlacesThatNeedIt) {
  const auto sum = [](float undulation_m) {
    std::string grid = radar::geoid_test::gtx_header(46.0, 7.0, 1.0, 1.0, 3, 3);
    for (int i = 0; i < 9; ++i) radar::geoid_test::append_float(grid, undulation_m);
    const scene::ScriptReading reading = scene::read_scene_text(
        "format = \"sarsim 2\"\n[world]\nframe = \"earth\"\nanchor = { latitude = \"47 deg\", longitude = \"8 deg\" }\n"
        "geoid = { file = \"g.gtx\" }\n[[target]]\nposition = { latitude = \"47 deg\", longitude = \"8 deg\", altitude "
        "= \"5 m\" }\n",
        "s.toml", [&](const std::string&) {
          return scene::DataFileText{"g.gtx", grid, {}};
        });
    EXPECT_FALSE(core::has_errors(reading.problems)) << core::to_string(reading.problems.front());
    return script_sum(reading.scene);
  };
  EXPECT_EQ(sum(40.0F), sum(40.0F));
  EXPECT_NE(sum(40.0F), sum(41.0F));
}

}  // namespace script_sum_test
}  // namespace sarsim::workflow
