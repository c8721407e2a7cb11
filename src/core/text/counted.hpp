#pragma once

#include <cstddef>
#include <string>

namespace sarsim::core {

/// A number of things: "1 turn", "3 turns".
[[nodiscard]] inline std::string counted(std::size_t count, const char* thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace sarsim::core
