#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::workflow {

/// What the commands that work on a scene will say of it with their usual options, before anything is run: each remark
/// names its command, and its subject is the simulation. Only a command that suits the scene is asked, and that with
/// the first simulation of each radar that it takes:
///
/// - `search` where the radar has noise and its beam turns in azimuth,
/// - `doppler` where the radar has noise and rests, its beam does not turn and targets move without turning,
/// - `profiles` where the carrier steps, unless the radar alone moves,
/// - `isar` where the platform with the strongest targets turns, or moves before a stepped carrier,
/// - `focus` where the radar moves past targets that rest, for longer than the aperture L that makes lambda R/(2 L) <
/// L.
///
/// A command that would refuse the simulation has no remarks, except `focus`, whose first error becomes a note; nor has
/// `focus` if targets times pulses, of which it examines at most 2048, exceed a million. Without noise there are no
/// remarks on detection.
/// @param scene     has passed `check` and the survey without errors
/// @param resolved  what `resolve` gives for it
/// @throw  Interrupted
[[nodiscard]] core::Problems diagnose_commands(const scene::Scene& scene,
                                               const std::shared_ptr<const simulate::ResolvedScene>& resolved,
                                               const core::WorkControl& control = {});

}  // namespace sarsim::workflow
