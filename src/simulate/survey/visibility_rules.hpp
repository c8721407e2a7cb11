#pragma once

#include <cstddef>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/survey/target_visibility.hpp"

namespace sarsim::simulate {

/// One simulation with what was seen of its targets.
struct VisibilityCase {
  const scene::Scene& scene;
  std::size_t simulation = 0;
  const Acquisition& acquisition;
  const VisibilitySurvey& survey;
  const EchoSummary& summary;
  const core::WorkControl& control;
};

/// Adds what a beam that misses its targets, noise, and the ends of the window do to a recording, with what to change.
void check_visibility(const VisibilityCase& sighted, core::Problems& problems);

}  // namespace sarsim::simulate
