#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"
#include "simulate/resolve/resolved.hpp"
#include "workflow/focus/focus_input.hpp"

namespace sarsim::picture {

/// Targets that differ between two scenes that are equal in everything else that a recording hears, and that can take
/// each other's place in its echoes; nothing where more differs, or what differs does not simply add up.
/// @param most  targets
[[nodiscard]] std::optional<std::vector<std::size_t>> changed_targets(const scene::Scene& before,
                                                                      const scene::Scene& now, std::size_t simulation,
                                                                      std::size_t most);

/// A scene that holds some targets of another, without noise, and one of its simulations: what they alone return.
[[nodiscard]] scene::Scene scene_of_targets(const scene::Scene& scene, std::size_t simulation,
                                            const std::vector<std::size_t>& targets);

/// A scene with some of its targets, evenly chosen, which return as much power as all; its noise stays, its clouds and
/// surfaces are left out.
[[nodiscard]] scene::Scene thinned_targets(const scene::Scene& scene, std::size_t simulation, std::size_t most);

/// The compressed echoes of a scene in memory, as focusing wants them recorded, kept up to date by differences.
class IncrementalEchoes {
 public:
  using Rows = std::vector<std::complex<float>>;

  /// Brings the echoes to those of a simulation of a scene; where few targets changed, the plan stays that of the scene
  /// before. Where it throws, nothing is followed.
  /// @throws core::InvalidRequest with the scene's errors, core::Interrupted
  void follow(std::shared_ptr<const scene::Scene> scene, std::size_t simulation, const core::WorkControl& control);
  /// Whether following a scene would take the echoes of a few targets alone.
  [[nodiscard]] bool follows_cheaply(const scene::Scene& scene, std::size_t simulation) const;
  /// Whether the plan is that of a scene before.
  [[nodiscard]] bool plan_is_old() const { return plan_is_old_; }
  /// Plans the scene that is followed: where echoes lie, and what is heard of other pulses.
  void renew_plan(const core::WorkControl& control);
  /// The echoes and the plan, for focusing.
  [[nodiscard]] workflow::FocusInput input() const;
  /// Echoes, targets times pulses, that were computed since it was asked last.
  [[nodiscard]] std::size_t take_echoes();

 private:
  struct Opened {
    workflow::FocusInput input;
    std::size_t targets = 0;
  };
  [[nodiscard]] static bool hears_others(const simulate::Acquisition& acquisition);
  [[nodiscard]] static Opened opened(const scene::Scene& scene, std::size_t simulation,
                                     const core::WorkControl& control);
  void take_whole(const std::shared_ptr<const scene::Scene>& scene, std::size_t simulation,
                  const core::WorkControl& control);
  bool take_changed(const std::shared_ptr<const scene::Scene>& scene, const std::vector<std::size_t>& changed,
                    const core::WorkControl& control);
  bool add(const scene::Scene& scene, const std::vector<std::size_t>& targets, float sign, Rows& rows,
           const core::WorkControl& control);

  std::shared_ptr<const scene::Scene> scene_;  // null: nothing is held
  std::size_t simulation_ = 0;
  workflow::FocusInput input_;
  bool hears_others_ = false;
  bool plan_is_old_ = false;
  std::shared_ptr<Rows> rows_;
  std::vector<std::size_t> moving_;  // targets that are left out of
  std::shared_ptr<const Rows> rest_;
  std::size_t rests_ = 0;  // that were made of one another since all echoes were computed
  std::size_t echoes_ = 0;
};

}  // namespace sarsim::picture
