#include "random_scenes/shrink.hpp"

#include <vector>

#include "random_scenes/scene_maker.hpp"

namespace sarsim::test {

namespace {

using Change = std::function<void(scene::Scene&)>;

template <class Object>
void leave_out(std::vector<Change>& changes, std::vector<Object> scene::Scene::*list, const scene::Scene& scene) {
  const std::size_t count = (scene.*list).size();
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  if (count > 3) {
    changes.push_back([list, half](scene::Scene& s) { (s.*list).erase((s.*list).begin(), (s.*list).begin() + half); });
    changes.push_back([list, half](scene::Scene& s) { (s.*list).erase((s.*list).begin() + half, (s.*list).end()); });
  }
  for (std::size_t i = 0; i < count; ++i)
    changes.push_back(
        [list, i](scene::Scene& s) { (s.*list).erase((s.*list).begin() + static_cast<std::ptrdiff_t>(i)); });
}

// Puts the initial value in the place of a member of one object.
template <class Object, class Member>
void reset(std::vector<Change>& changes, std::vector<Object> scene::Scene::*list, std::size_t i,
           Member Object::*member) {
  changes.push_back([=](scene::Scene& s) { (s.*list)[i].*member = Object().*member; });
}

void plainer_platforms(std::vector<Change>& changes, const scene::Scene& scene) {
  for (std::size_t i = 0; i < scene.platforms.size(); ++i) {
    changes.push_back([i](scene::Scene& s) {
      scene::Platform& platform = s.platforms[i];
      if (platform.path != scene::Platform::Path::trajectory) return;
      const auto start = [&](std::size_t axis) {
        const auto& knots = platform.trajectory_m.part[axis].knots;
        return knots.empty() ? 0.0 : knots.front().y;
      };
      platform.position_m = {start(0), start(1), start(2)};
      platform.path = scene::Platform::Path::stationary;
      platform.trajectory_m = {};
      platform.aligned = false;
    });
    changes.push_back([i](scene::Scene& s) {
      s.platforms[i].rotation_kind = scene::Platform::Rotation::constant;
      s.platforms[i].rotation_deg = {};
      s.platforms[i].rotation = {};
    });
    changes.push_back([i](scene::Scene& s) {
      s.platforms[i].position_error = scene::Platform::MotionError::gaussian;
      s.platforms[i].position_envelope = {};
      s.platforms[i].position_stddev_m = {};
    });
    changes.push_back([i](scene::Scene& s) {
      s.platforms[i].rotation_error = scene::Platform::MotionError::gaussian;
      s.platforms[i].rotation_envelope = {};
      s.platforms[i].rotation_stddev = {};
    });
    reset(changes, &scene::Scene::platforms, i, &scene::Platform::rotation_rate);
    reset(changes, &scene::Scene::platforms, i, &scene::Platform::aligned);
  }
}

void plainer_targets(std::vector<Change>& changes, const scene::Scene& scene) {
  for (std::size_t i = 0; i < scene.targets.size(); ++i)
    changes.push_back([i](scene::Scene& s) {
      scene::Target plain;
      plain.platform = s.targets[i].platform;
      plain.position_m = s.targets[i].position_m;
      s.targets[i] = plain;
    });
}

void plainer_radars(std::vector<Change>& changes, const scene::Scene& scene) {
  for (std::size_t i = 0; i < scene.radars.size(); ++i) {
    const auto set = [&](const std::function<void(scene::Radar&)>& change) {
      changes.push_back([i, change](scene::Scene& s) { change(s.radars[i]); });
    };
    set([](scene::Radar& r) {
      r.pulse = scene::Radar::Pulse::mono, r.pulse_iq = {}, r.bandwidth_hz = scene::Radar().bandwidth_hz,
      r.barker_code = 6;
    });
    set([](scene::Radar& r) {
      r.envelope = scene::Radar::Envelope::rectangular, r.envelope_gain = {}, r.rise_s = 0.0, r.fall_s = 0.0;
    });
    set([](scene::Radar& r) { r.transmit_antenna = {}; });
    set([](scene::Radar& r) { r.same_antenna = true, r.receive_antenna = {}; });
    set([](scene::Radar& r) {
      r.beam = scene::Radar::Beam::fixed, r.beam_target_world_m = {}, r.spot_world_m = {}, r.beam_rate = {};
    });
    set([](scene::Radar& r) {
      r.window = scene::Radar::Window::rectangular, r.window_gain = {}, r.hanning_pedestal = 1.0;
    });
    set([](scene::Radar& r) { r.stc = scene::Radar::Stc::none, r.stc_gain = {}; });
    reset(changes, &scene::Scene::radars, i, &scene::Radar::noise_temperature_k);
    reset(changes, &scene::Scene::radars, i, &scene::Radar::losses);
    reset(changes, &scene::Scene::radars, i, &scene::Radar::transmit_gain);
    reset(changes, &scene::Scene::radars, i, &scene::Radar::receive_gain);
    reset(changes, &scene::Scene::radars, i, &scene::Radar::power_w);
  }
}

std::vector<Change> plainer(const scene::Scene& scene) {
  std::vector<Change> changes{keep_inline};
  leave_out(changes, &scene::Scene::targets, scene);
  leave_out(changes, &scene::Scene::surfaces, scene);
  leave_out(changes, &scene::Scene::geometries, scene);
  leave_out(changes, &scene::Scene::simulations, scene);
  leave_out(changes, &scene::Scene::radars, scene);
  leave_out(changes, &scene::Scene::platforms, scene);
  plainer_platforms(changes, scene);
  plainer_radars(changes, scene);
  plainer_targets(changes, scene);
  changes.push_back([](scene::Scene& s) { s.options.pulse = scene::PulseDefinition::ideal; });
  changes.push_back([](scene::Scene& s) { s.options.profile = scene::Profile::physical; });
  changes.push_back([](scene::Scene& s) { s.options.tolerance = 1e-6; });
  changes.push_back([](scene::Scene& s) { s.options.seed = 1; });
  for (std::size_t i = 0; i < scene.simulations.size(); ++i) {
    reset(changes, &scene::Scene::simulations, i, &scene::Simulation::processing);
    reset(changes, &scene::Scene::simulations, i, &scene::Simulation::oversampling);
    reset(changes, &scene::Scene::simulations, i, &scene::Simulation::width_factor);
    reset(changes, &scene::Scene::simulations, i, &scene::Simulation::pulse_position);
  }
  return changes;
}

}  // namespace

scene::Scene shrunk(scene::Scene scene, const std::function<bool(const scene::Scene&)>& fails, int trials) {
  for (bool progress = true; progress;) {
    progress = false;
    // After a change that leaves an object out, later ones may mean objects that are no longer there: begin anew.
    for (const Change& change : plainer(scene)) {
      scene::Scene candidate = scene;
      change(candidate);
      if (candidate == scene || trials-- <= 0 || !fails(candidate)) continue;
      scene = std::move(candidate);
      progress = true;
      break;
    }
  }
  return scene;
}

}  // namespace sarsim::test
