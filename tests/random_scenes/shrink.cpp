#include "random_scenes/shrink.hpp"

#include <vector>

#include "random_scenes/scene_maker.hpp"

namespace sarsim::test {

namespace {

using Change = std::function<void(Scene&)>;

template <class Object>
void leave_out(std::vector<Change>& changes, std::vector<Object> Scene::*list, const Scene& scene) {
  const std::size_t count = (scene.*list).size();
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  if (count > 3) {
    changes.push_back([list, half](Scene& s) { (s.*list).erase((s.*list).begin(), (s.*list).begin() + half); });
    changes.push_back([list, half](Scene& s) { (s.*list).erase((s.*list).begin() + half, (s.*list).end()); });
  }
  for (std::size_t i = 0; i < count; ++i)
    changes.push_back([list, i](Scene& s) { (s.*list).erase((s.*list).begin() + static_cast<std::ptrdiff_t>(i)); });
}

// Puts the initial value in the place of a member of one object.
template <class Object, class Member>
void reset(std::vector<Change>& changes, std::vector<Object> Scene::*list, std::size_t i, Member Object::*member) {
  changes.push_back([=](Scene& s) { (s.*list)[i].*member = Object().*member; });
}

void plainer_platforms(std::vector<Change>& changes, const Scene& scene) {
  for (std::size_t i = 0; i < scene.platforms.size(); ++i) {
    changes.push_back([i](Scene& s) {
      Platform& platform = s.platforms[i];
      if (platform.path != Platform::Path::trajectory) return;
      const auto start = [&](std::size_t axis) {
        const auto& knots = platform.trajectory_m.part[axis].knots;
        return knots.empty() ? 0.0 : knots.front().y;
      };
      platform.position_m = {start(0), start(1), start(2)};
      platform.path = Platform::Path::stationary;
      platform.trajectory_m = {};
      platform.aligned = false;
    });
    changes.push_back([i](Scene& s) {
      s.platforms[i].rotation_kind = Platform::Rotation::constant;
      s.platforms[i].rotation_deg = {};
      s.platforms[i].rotation = {};
    });
    changes.push_back([i](Scene& s) {
      s.platforms[i].position_error = Platform::MotionError::gaussian;
      s.platforms[i].position_envelope = {};
      s.platforms[i].position_stddev_m = {};
    });
    changes.push_back([i](Scene& s) {
      s.platforms[i].rotation_error = Platform::MotionError::gaussian;
      s.platforms[i].rotation_envelope = {};
      s.platforms[i].rotation_stddev = {};
    });
    reset(changes, &Scene::platforms, i, &Platform::rotation_rate);
    reset(changes, &Scene::platforms, i, &Platform::aligned);
  }
}

void plainer_targets(std::vector<Change>& changes, const Scene& scene) {
  for (std::size_t i = 0; i < scene.targets.size(); ++i)
    changes.push_back([i](Scene& s) {
      Target plain;
      plain.platform = s.targets[i].platform;
      plain.position_m = s.targets[i].position_m;
      s.targets[i] = plain;
    });
}

void plainer_radars(std::vector<Change>& changes, const Scene& scene) {
  for (std::size_t i = 0; i < scene.radars.size(); ++i) {
    const auto set = [&](const std::function<void(Radar&)>& change) {
      changes.push_back([i, change](Scene& s) { change(s.radars[i]); });
    };
    set([](Radar& r) {
      r.pulse = Radar::Pulse::mono, r.pulse_iq = {}, r.bandwidth_hz = Radar().bandwidth_hz, r.barker_code = 6;
    });
    set([](Radar& r) {
      r.envelope = Radar::Envelope::rectangular, r.envelope_gain = {}, r.rise_s = 0.0, r.fall_s = 0.0;
    });
    set([](Radar& r) { r.transmit_antenna = {}; });
    set([](Radar& r) { r.same_antenna = true, r.receive_antenna = {}; });
    set([](Radar& r) {
      r.beam = Radar::Beam::fixed, r.beam_target_world_m = {}, r.spot_world_m = {}, r.beam_rate = {};
    });
    set([](Radar& r) { r.window = Radar::Window::rectangular, r.window_gain = {}, r.hanning_pedestal = 1.0; });
    set([](Radar& r) { r.stc = Radar::Stc::none, r.stc_gain = {}; });
    reset(changes, &Scene::radars, i, &Radar::noise_temperature_k);
    reset(changes, &Scene::radars, i, &Radar::losses);
    reset(changes, &Scene::radars, i, &Radar::transmit_gain);
    reset(changes, &Scene::radars, i, &Radar::receive_gain);
    reset(changes, &Scene::radars, i, &Radar::power_w);
  }
}

std::vector<Change> plainer(const Scene& scene) {
  std::vector<Change> changes{keep_inline};
  leave_out(changes, &Scene::targets, scene);
  leave_out(changes, &Scene::surfaces, scene);
  leave_out(changes, &Scene::geometries, scene);
  leave_out(changes, &Scene::simulations, scene);
  leave_out(changes, &Scene::radars, scene);
  leave_out(changes, &Scene::platforms, scene);
  plainer_platforms(changes, scene);
  plainer_radars(changes, scene);
  plainer_targets(changes, scene);
  changes.push_back([](Scene& s) { s.options.pulse = PulseDefinition::ideal; });
  changes.push_back([](Scene& s) { s.options.profile = Profile::physical; });
  changes.push_back([](Scene& s) { s.options.tolerance = 1e-6; });
  changes.push_back([](Scene& s) { s.options.seed = 1; });
  for (std::size_t i = 0; i < scene.simulations.size(); ++i) {
    reset(changes, &Scene::simulations, i, &Simulation::processing);
    reset(changes, &Scene::simulations, i, &Simulation::oversampling);
    reset(changes, &Scene::simulations, i, &Simulation::width_factor);
    reset(changes, &Scene::simulations, i, &Simulation::pulse_position);
  }
  return changes;
}

}  // namespace

Scene shrunk(Scene scene, const std::function<bool(const Scene&)>& fails, int trials) {
  for (bool progress = true; progress;) {
    progress = false;
    // After a change that leaves an object out, later ones may mean objects that are no longer there: begin anew.
    for (const Change& change : plainer(scene)) {
      Scene candidate = scene;
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
