#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace sarsim::test {

/// One number that the thesis prints, and how the simulator arrives at it.
struct ThesisNumber {
  std::string name;  ///< Key of its row in docs/theory/thesis-numbers.md.
  std::function<double(Profile)> value;
};

/// All of them, in the order of the table.
[[nodiscard]] std::vector<ThesisNumber> thesis_numbers();

}  // namespace sarsim::test
