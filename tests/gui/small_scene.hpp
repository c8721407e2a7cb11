#pragma once

#include <set>
#include <string>

#include "gui/common/session.hpp"
#include "scene/edit/document.hpp"
#include "scene/script/writer.hpp"

/// Scenes for tests of the workbench.
namespace sarsim::test {

/// Platforms "Earth" and "Ship"; on Earth Radar1, two targets and a surface, on the Ship Radar2 and a target; a stored
/// simulation and a geometry table of Radar1.
inline scene::Scene small_scene() {
  scene::Scene scene;
  scene.platforms.emplace_back();
  scene.platforms.emplace_back().name = "Ship";
  scene.radars.emplace_back();
  scene.radars.emplace_back().name = "Radar2";
  scene.radars.back().platform = "Ship";
  for (const double x : {1000.0, 2000.0, 3000.0}) scene.targets.emplace_back().position_m = {x, 0.0, 0.0};
  scene.targets.back().platform = "Ship";
  scene.surfaces.emplace_back();
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_end_m = 2000.0;
  simulation.sample_rate_hz = 4e6;
  scene.simulations.push_back(simulation);
  scene.geometries.emplace_back().radar = "Radar1";
  return scene;
}

inline void open(gui::Session& session, const scene::Scene& scene) {
  session.take(scene::Document::from_text(scene::write_script(scene)));
}

inline scene::ObjectId target(std::size_t index) { return {scene::ObjectKind::target, index}; }
inline scene::ObjectId platform(std::size_t index) { return {scene::ObjectKind::platform, index}; }
inline scene::ObjectId radar(std::size_t index) { return {scene::ObjectKind::radar, index}; }

/// Targets 10 m apart, a hundred in a row, on one platform with a radar.
inline scene::Scene many_targets(std::size_t count) {
  scene::Scene scene;
  scene.platforms.emplace_back();
  scene.radars.emplace_back();
  for (std::size_t i = 0; i < count; ++i)
    scene.targets.emplace_back().position_m = {10.0 * static_cast<double>(i % 100), 10.0 * static_cast<double>(i / 100),
                                               0.0};
  return scene;
}

/// A scene whose simulation is a recording that takes minutes.
inline scene::Scene slow_scene() {
  scene::Scene scene = many_targets(2000);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_end_m = 20e3;
  simulation.time_end_s = 100.0;
  simulation.sample_rate_hz = 50e6;
  simulation.lsb_v = 1e-6;
  simulation.file = "slow.bin";
  scene.simulations = {simulation};
  for (scene::Target& target : scene.targets) target.position_m.x += 1000.0;
  return scene;
}

}  // namespace sarsim::test
