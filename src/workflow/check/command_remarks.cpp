#include "workflow/check/command_remarks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/report/invalid_request.hpp"
#include "radar/path/path.hpp"
#include "scene/model/scene_index.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/survey/beam_passes.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/target_aspects.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/pulse_input.hpp"
#include "workflow/search/search_checks.hpp"
#include "workflow/stepped/isar.hpp"
#include "workflow/stepped/profiles.hpp"
#include "workflow/stepped/stepped_input.hpp"

namespace sarsim::workflow {

namespace {

constexpr double rest_mps = 1e-6;
constexpr std::size_t max_focus_looks = 1'000'000;  // half a second of two cores
constexpr std::int64_t min_pulses = 8;              // with fewer nobody makes maps or images

// How radar and targets move at the middle pulse.
struct Movement {
  bool radar = false;
  bool targets = false;   // some of them move ...
  bool resting = false;   // ... or rest
  bool turning = false;   // the platform of the strongest targets turns ...
  bool moving = false;    // ... or moves
  bool aperture = false;  // the radar flies far enough past targets that rest to focus them
};

bool rotates(const radar::Pose& pose) {
  const core::Mat3& rate = pose.world_from_platform_rate;
  return std::ranges::any_of(rate.row, [](const core::Vec3& row) { return core::norm(row) > 0.0; });
}

// Whether a flight shows a point under angles that differ by more than what a wavelength resolves over it.
bool makes_aperture(const core::Vec3& flown_m, const core::Vec3& sight_m, double wavelength_m) {
  const double distance_m = core::norm(sight_m);
  if (!(distance_m > 0.0)) return false;
  const core::Vec3 across_m = flown_m - core::dot(flown_m, sight_m) / (distance_m * distance_m) * sight_m;
  return 2.0 * core::dot(across_m, across_m) > wavelength_m * distance_m;
}

Movement movement_of(const simulate::Acquisition& acquisition) {
  Movement movement;
  simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
  geometry.set_pulse(acquisition.timing.pulses.first);
  const core::Vec3 first_m = geometry.radar_pose().position_world_m;
  geometry.set_pulse(acquisition.timing.pulses.last);
  core::Vec3 flown_m = geometry.radar_pose().position_world_m - first_m;
  geometry.set_pulse(acquisition.timing.pulses.first + acquisition.timing.pulses.count() / 2);
  // A flight around the scene ends where it began.
  if (const core::Vec3 half_m = geometry.radar_pose().position_world_m - first_m;
      core::norm(half_m) > core::norm(flown_m))
    flown_m = half_m;
  movement.radar = core::norm(geometry.radar_pose().velocity_world_mps) > rest_mps;
  const double wavelength_m = radar::wavelength_of(geometry.carrier_hz(), acquisition.light_speed_mps());
  for (const simulate::Scatterer& s : acquisition.scene->scatterers) {
    if (s.platform == acquisition.link.platform) continue;
    const radar::Pose& pose = geometry.pose(s.platform);
    const bool moves = core::norm(radar::world_velocity_mps(pose, s.position_m)) > rest_mps;
    movement.targets = movement.targets || moves;
    movement.resting = movement.resting || !moves;
    if (moves || movement.aperture) continue;
    const core::Vec3 sight_m = radar::world_position_m(pose, s.position_m) - geometry.radar_pose().position_world_m;
    movement.aperture = makes_aperture(flown_m, sight_m, wavelength_m);
  }
  if (const auto platform = platform_of_targets(acquisition)) {
    movement.turning = rotates(geometry.pose(*platform));
    movement.moving = core::norm(geometry.pose(*platform).velocity_world_mps) > rest_mps;
  }
  return movement;
}

// As `TargetAspects` takes them.
std::size_t looks_at_targets(const simulate::Acquisition& acquisition) {
  return std::min(static_cast<std::size_t>(acquisition.timing.pulses.count()), TargetAspects::usual_looks);
}

core::Problems diagnose_pulses(const simulate::Acquisition& acquisition, std::size_t pulses,
                               const core::WorkControl& control) {
  const SearchOptions options = search_options({}, acquisition, pulses);
  return problems_of_search(acquisition, options).empty() ? diagnose_search(acquisition, options, control)
                                                          : core::Problems{};
}

// What reflects is resolved already, and may be millions of objects.
scene::Scene without_reflectors(const scene::Scene& scene) {
  scene::Scene some;
  some.platforms = scene.platforms;
  some.simulations = scene.simulations;
  some.options = scene.options;
  return some;
}

// Asks the commands about the simulations of one scene.
class Asking {
 public:
  Asking(const scene::Scene& scene, const std::shared_ptr<const simulate::ResolvedScene>& resolved,
         const core::WorkControl& control)
      : scene_(without_reflectors(scene)), all_(scene), names_(scene), resolved_(resolved), control_(control) {}

  core::Problems all() {
    for (std::size_t i = 0; i < scene_.simulations.size(); ++i) ask(i);
    core::Problems problems;
    for (Said& said : said_) {
      said.remark.message = "sarsim " + said.commands + ": " + said.remark.message;
      problems.push_back(std::move(said.remark));
    }
    return problems;
  }

 private:
  using Answer = std::function<core::Problems()>;

  // By all that say the same.
  struct Said {
    std::string commands;
    core::Problem remark;
  };

  void ask(std::size_t index) {
    const scene::Simulation asked = scene_.simulations[index];
    // Alone: each question looks for it by its name.
    scene_.radars.assign(1, all_.radars.at(names_.radar(asked.radar)));
    const simulate::Acquisition acquisition = simulate::acquisition_of(scene_, index, resolved_, control_.stop);
    const Movement movement = movement_of(acquisition);
    const bool pulses = records_pulses(scene_, asked) && acquisition.timing.pulses.count() >= min_pulses;
    const bool detects = pulses && acquisition.reception.noise_stddev_v > 0.0;
    const bool sweeps = beam_turns(acquisition);
    const auto take = [&](const char* command, bool suits, const Answer& answer) {
      if (!suits || !asked_.insert({command, asked.radar}).second) return;
      add(command, index, answer);
      scene_.simulations[index] = asked;
    };
    take("search", detects && (simulate::is_scanning(acquisition.link.beam) || (sweeps && !movement.radar)),
         [&] { return search(index); });
    take("doppler", detects && !sweeps && !movement.radar && movement.targets && !movement.turning,
         [&] { return doppler(index); });
    take("profiles", suits_use(SteppedUse::profiles)(scene_, asked) && (movement.targets || !movement.radar),
         [&] { return profiles(index, acquisition); });
    const bool steps = suits_use(SteppedUse::profiles)(scene_, asked);
    take("isar", suits_use(SteppedUse::isar)(scene_, asked) && (movement.turning || (steps && movement.moving)),
         [&] { return isar(index, acquisition); });
    take("focus",
         pulses && movement.radar && movement.aperture && !simulate::is_scanning(acquisition.link.beam) &&
             acquisition.scene->scatterers.size() <= max_focus_looks / looks_at_targets(acquisition),
         [&] { return focus(index, acquisition); });
  }

  // A recording that a command refuses does not suit it; but an aperture is flown to be focused.
  void add(const char* command, std::size_t index, const Answer& answer) {
    core::Problems remarks;
    try {
      remarks = answer();
    } catch (const core::InvalidRequest& refused) {
      remarks = refused.problems;
    }
    if (core::has_errors(remarks)) {
      if (command != std::string_view("focus")) return;
      remarks = {refusal_of(remarks)};
    }
    for (core::Problem& remark : remarks) {
      remark.subject = {"simulation", index, ""};
      const auto [same, is_new] = places_.try_emplace({index, remark.message, remark.found}, said_.size());
      if (is_new)
        said_.push_back({command, std::move(remark)});
      else
        said_[same->second].commands += std::string(" and ") + command;
    }
  }

  // The first error, as a note.
  [[nodiscard]] static core::Problem refusal_of(const core::Problems& problems) {
    core::Problem refusal = *std::ranges::find(problems, core::Severity::error, &core::Problem::severity);
    refusal.severity = core::Severity::note;
    refusal.message = "will refuse this recording: " + refusal.message;
    return refusal;
  }

  [[nodiscard]] core::Problems search(std::size_t index) {
    const auto acquisition = acquisition_of_pulses(scene_, index, resolved_, control_.stop);
    return diagnose_pulses(*acquisition, dwell_pulses(*acquisition), control_);
  }

  [[nodiscard]] core::Problems doppler(std::size_t index) {
    const auto acquisition = acquisition_of_pulses(scene_, index, resolved_, control_.stop);
    return diagnose_pulses(*acquisition, doppler_pulses(*acquisition), control_);
  }

  [[nodiscard]] core::Problems profiles(std::size_t index, const simulate::Acquisition& acquisition) {
    const SteppedInput input = stepped_input_of(scene_, index, acquisition, SteppedUse::profiles);
    return core::has_errors(input.problems) ? core::Problems{} : diagnose_profiles(input.rows, {});
  }

  [[nodiscard]] core::Problems isar(std::size_t index, const simulate::Acquisition& acquisition) {
    const SteppedInput input = stepped_input_of(scene_, index, acquisition, SteppedUse::isar);
    if (core::has_errors(input.problems) || input.rows.bursts < 2) return {};
    IsarOptions options;
    options.platform = platform_of_targets(*input.rows.acquisition).value();
    return diagnose_isar(input.rows, {0}, input.rows.bursts, options, control_);
  }

  [[nodiscard]] core::Problems focus(std::size_t index, const simulate::Acquisition& acquisition) {
    FocusInput input = focus_input_of(scene_, index, acquisition);
    return core::has_errors(input.problems) ? input.problems : diagnose_focus(std::move(input), control_);
  }

  scene::Scene scene_;  // With the radar that is asked about, and no other.
  const scene::Scene& all_;
  scene::SceneIndex names_;
  const std::shared_ptr<const simulate::ResolvedScene>& resolved_;
  const core::WorkControl& control_;
  std::set<std::pair<std::string, std::string>> asked_;  // command, radar
  std::vector<Said> said_;
  std::map<std::tuple<std::size_t, std::string, std::string>, std::size_t> places_;  // In `said_`.
};

}  // namespace

core::Problems diagnose_commands(const scene::Scene& scene,
                                 const std::shared_ptr<const simulate::ResolvedScene>& resolved,
                                 const core::WorkControl& control) {
  return Asking(scene, resolved, control).all();
}

}  // namespace sarsim::workflow
