#pragma once

#include "simulate/survey/survey.hpp"

namespace sarsim::simulate {

/// One simulation with what was seen of its targets.
struct SightCase {
  const scene::Scene& scene;
  std::size_t simulation = 0;
  const Acquisition& acquisition;
  const SightSurvey& survey;
  const EchoSummary& summary;
  const core::WorkControl& control;
};

/// Adds what a beam that misses its targets, noise, and the ends of the window do to a recording, with what to change.
void check_sights(const SightCase& sighted, core::Problems& problems);

}  // namespace sarsim::simulate
