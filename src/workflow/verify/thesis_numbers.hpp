#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"

namespace sarsim::workflow::verify {

/// One number that the thesis prints, and how the simulator arrives at it.
struct ThesisNumber {
  std::string name;      ///< Key of its row in docs/theory/thesis-numbers.md.
  std::string what;      ///< In words, for people.
  std::string unit;      ///< Empty for a pure number.
  double classic = 0.0;  ///< What is expected in either profile.
  double physical = 0.0;
  double tolerance = 0.0;
  std::function<double(scene::Profile)> value;
};

/// All of them, in the order of the table.
[[nodiscard]] std::vector<ThesisNumber> thesis_numbers();

}  // namespace sarsim::workflow::verify
