#pragma once

#include <optional>
#include <span>

#include "core/report/problem.hpp"
#include "scene/ephemeris/mean_elements_file.hpp"

namespace sarsim::scene {

/// A warning where sets of the same epoch as the chosen one have other elements: nothing tells which one counts. The
/// same set twice is nothing to tell.
/// @param sets  all of one satellite, the chosen one among them
[[nodiscard]] std::optional<core::Problem> problem_of_other_sets(std::span<const ElementSet> sets,
                                                                 const ElementSet& chosen);

}  // namespace sarsim::scene
