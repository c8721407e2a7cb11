#include "picture/live/incremental_echoes.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/report/invalid_request.hpp"
#include "scene/check/check.hpp"
#include "simulate/plan/range_ambiguities.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t grain = 16;  // rows that a thread takes at once
// Each rest that is made of the one before adds a rounding; after so many, all echoes are computed again.
constexpr std::size_t max_rests = 64;
// Of more targets, echoes are as soon computed anew.
constexpr std::size_t max_changed = 256;

// Random deviations belong to the number of a target in its scene.
bool is_steady(const scene::Target& target) {
  const scene::TargetTraits& traits = *target.traits;
  return traits.position_stddev_m == core::Vec3{} && traits.rcs_stddev_m2 == 0.0 &&
         traits.azimuth_stddev.rad() == 0.0 && traits.elevation_stddev.rad() == 0.0;
}

// What a plan needs of a scene besides its resolved targets.
scene::Scene without_targets(const scene::Scene& scene, std::size_t simulation) {
  scene::Scene small;
  small.platforms = scene.platforms;
  small.radars = scene.radars;
  small.options = scene.options;
  small.world = scene.world;
  small.atmosphere = scene.atmosphere;
  small.simulations.push_back(scene.simulations.at(simulation));
  return small;
}

void expect_sound(const scene::Scene& scene, std::size_t simulation, const core::WorkControl& control) {
  core::Problems problems = scene::check(scene, control);
  const std::size_t radar = scene::find_radar(scene, scene.simulations.at(simulation).radar);
  std::erase_if(problems, [&](const core::Problem& problem) {
    const core::Subject& subject = problem.subject;
    return problem.severity != core::Severity::error || subject.kind == "geometry" ||
           (subject.kind == "simulation" && subject.index != simulation) ||
           (subject.kind == "radar" && subject.index != radar);
  });
  if (!problems.empty()) throw core::InvalidRequest(core::ranked(std::move(problems)));
}

std::size_t points_of(const simulate::ResolvedScene& scene) {
  std::size_t points = scene.scatterers.size();
  for (const simulate::ScattererSheet& sheet : scene.sheets) points += sheet.points_m.size();
  return points;
}

}  // namespace

std::optional<std::vector<std::size_t>> changed_targets(const scene::Scene& before, const scene::Scene& now,
                                                        std::size_t simulation, std::size_t most) {
  if (simulation >= before.simulations.size() || simulation >= now.simulations.size()) return std::nullopt;
  const bool alike = before.targets.size() == now.targets.size() &&
                     before.simulations[simulation] == now.simulations[simulation] && before.radars == now.radars &&
                     before.options == now.options && before.world == now.world &&
                     before.atmosphere == now.atmosphere && before.platforms == now.platforms &&
                     before.surfaces == now.surfaces && before.clouds == now.clouds;
  if (!alike) return std::nullopt;
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < now.targets.size(); ++i) {
    if (before.targets[i] == now.targets[i]) continue;
    if (changed.size() == most || !is_steady(before.targets[i]) || !is_steady(now.targets[i])) return std::nullopt;
    changed.push_back(i);
  }
  return changed;
}

scene::Scene scene_of_targets(const scene::Scene& scene, std::size_t simulation,
                              const std::vector<std::size_t>& targets) {
  scene::Scene some = without_targets(scene, simulation);
  for (const std::size_t target : targets) some.targets.push_back(scene.targets.at(target));
  for (scene::Radar& radar : some.radars) radar.noise_temperature_k = 0.0;
  some.options.ambiguous_echoes = scene::AmbiguousEchoes::none;
  return some;
}

scene::Scene thinned_targets(const scene::Scene& scene, std::size_t simulation, std::size_t most) {
  scene::Scene some = without_targets(scene, simulation);
  const std::size_t count = std::min(most, scene.targets.size());
  double all = 0.0;
  double chosen = 0.0;
  for (const scene::Target& target : scene.targets) all += target.rcs_m2;
  for (std::size_t i = 0; i < count; ++i) {
    some.targets.push_back(scene.targets[i * scene.targets.size() / count]);
    chosen += some.targets.back().rcs_m2;
  }
  if (chosen > 0.0)
    for (scene::Target& target : some.targets) target.rcs_m2 *= all / chosen;
  return some;
}

// Whether rows hold echoes of pulses other than their own.
bool IncrementalEchoes::hears_others(const simulate::Acquisition& acquisition) {
  return !simulate::asked_for(simulate::find_range_ambiguities(acquisition),
                              acquisition.scene->options.ambiguous_echoes)
              .pulses.empty();
}

IncrementalEchoes::Opened IncrementalEchoes::opened(const scene::Scene& scene, std::size_t simulation,
                                                    const core::WorkControl& control) {
  const auto resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(scene, control));
  scene::Scene small = without_targets(scene, simulation);
  Opened opened{workflow::focus_input_of(small, 0, resolved), points_of(*resolved)};
  if (core::has_errors(opened.input.problems))
    throw core::InvalidRequest(core::ranked(std::move(opened.input.problems)));
  opened.input.simulation = simulation;
  return opened;
}

void IncrementalEchoes::follow(std::shared_ptr<const scene::Scene> scene, std::size_t simulation,
                               const core::WorkControl& control) {
  if (scene_ == scene && simulation_ == simulation) return;
  if (scene_ && simulation_ == simulation)
    if (const auto changed = changed_targets(*scene_, *scene, simulation, max_changed)) {
      if (changed->empty()) {
        scene_ = std::move(scene);
        return;
      }
      if (take_changed(scene, *changed, control)) return;
    }
  take_whole(scene, simulation, control);
}

bool IncrementalEchoes::follows_cheaply(const scene::Scene& scene, std::size_t simulation) const {
  return scene_ && simulation_ == simulation && !hears_others_ &&
         (scene_.get() == &scene || changed_targets(*scene_, scene, simulation, max_changed));
}

void IncrementalEchoes::take_whole(const std::shared_ptr<const scene::Scene>& scene, std::size_t simulation,
                                   const core::WorkControl& control) {
  expect_sound(*scene, simulation, control);
  Opened opened = IncrementalEchoes::opened(*scene, simulation, control);
  const signal::EchoRows& echoes = opened.input.echoes;
  auto rows = std::make_shared<Rows>(echoes.rows * echoes.columns);
  // A row of many targets takes milliseconds, for which a cancel waits.
  constexpr std::size_t many = 4096;
  core::parallel_ranges(echoes.rows, opened.targets > many ? 1 : grain, control,
                        [&](std::size_t begin, std::size_t end) {
                          for (std::size_t r = begin; r < end; ++r)
                            echoes.read(r, std::span(*rows).subspan(r * echoes.columns, echoes.columns));
                        });
  echoes_ += opened.targets * echoes.rows;
  scene_ = scene;
  simulation_ = simulation;
  input_ = std::move(opened.input);
  hears_others_ = hears_others(*input_.acquisition);
  rows_ = std::move(rows);
  plan_is_old_ = false;
  moving_.clear();
  rest_.reset();
  rests_ = 0;
}

// Adds the echoes of some targets, or takes them away. False where they are not sampled like those that are held.
bool IncrementalEchoes::add(const scene::Scene& scene, const std::vector<std::size_t>& targets, float sign, Rows& rows,
                            const core::WorkControl& control) {
  const scene::Scene some = scene_of_targets(scene, simulation_, targets);
  expect_sound(some, 0, control);
  const Opened opened = IncrementalEchoes::opened(some, 0, control);
  const signal::EchoRows& echoes = opened.input.echoes;
  if (echoes.rows * echoes.columns != rows.size()) return false;
  core::parallel_ranges(echoes.rows, grain, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<float>> row(echoes.columns);
    for (std::size_t r = begin; r < end; ++r) {
      echoes.read(r, row);
      std::complex<float>* const at = rows.data() + r * echoes.columns;
      for (std::size_t k = 0; k < row.size(); ++k) at[k] += sign * row[k];
    }
  });
  echoes_ += opened.targets * echoes.rows;
  return true;
}

bool IncrementalEchoes::take_changed(const std::shared_ptr<const scene::Scene>& scene,
                                     const std::vector<std::size_t>& changed, const core::WorkControl& control) {
  if (hears_others_) return false;
  const bool same_hand = rest_ && std::ranges::includes(moving_, changed);
  if (!same_hand) {
    if (rests_ == max_rests) return false;
    auto rest = std::make_shared<Rows>(*rows_);
    if (!add(*scene_, changed, -1.0F, *rest, control)) return false;
    rest_ = std::move(rest);
    moving_ = changed;
    ++rests_;
  }
  auto rows = std::make_shared<Rows>(*rest_);
  if (!add(*scene, moving_, 1.0F, *rows, control)) return false;
  scene_ = scene;
  rows_ = std::move(rows);
  plan_is_old_ = true;
  return true;
}

void IncrementalEchoes::renew_plan(const core::WorkControl& control) {
  if (!plan_is_old_) return;
  const auto resolved = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(*scene_, control));
  scene::Scene small = without_targets(*scene_, simulation_);
  workflow::FocusInput input = workflow::focus_input_of(small, 0, resolved);
  if (core::has_errors(input.problems)) throw core::InvalidRequest(core::ranked(std::move(input.problems)));
  // Which of them are heard depends on all targets.
  if (hears_others(*input.acquisition)) {
    take_whole(std::shared_ptr<const scene::Scene>(scene_), simulation_, control);
    return;
  }
  input.simulation = simulation_;
  input_ = std::move(input);
  plan_is_old_ = false;
}

workflow::FocusInput IncrementalEchoes::input() const {
  workflow::FocusInput input = input_;
  input.echoes.copy =
      core::rows_in_memory(std::shared_ptr<const Rows>(rows_), input_.echoes.rows, input_.echoes.columns).copy;
  return input;
}

std::size_t IncrementalEchoes::take_echoes() { return std::exchange(echoes_, 0); }

}  // namespace sarsim::picture
