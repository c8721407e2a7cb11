#pragma once

#include <string>
#include <vector>

#include "capi/sarsim.h"
#include "core/report/problem.hpp"
#include "core/task/observer.hpp"
#include "core/task/stop.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/record/scene_plan.hpp"

/// A text in UTF-8.
struct sarsim_text {
  std::string text;
};

/// A list of problems and of what the command prints of each.
struct sarsim_problems {
  std::vector<sarsim::core::Problem> problems;
  std::vector<std::string> texts;
};

/// A stop request.
struct sarsim_stop {
  sarsim::core::StopFlag flag;
};

/// A scene as it was read and changed.
struct sarsim_scene {
  sarsim::workflow::SceneInput input;
};

/// A plan with what its strings and axes are.
struct sarsim_plan {
  sarsim::workflow::ScenePlan planned;
  sarsim::simulate::Product product;
  std::string processing;
  std::string format;
  std::string file;
  std::string engine;
};
