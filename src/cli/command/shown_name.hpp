#pragma once

#include <string>
#include <string_view>

#include "core/report/problem.hpp"

namespace sarsim::cli {

/// The name of a file as a terminal may show it: in one line, without control characters (`core::printable`).
[[nodiscard]] inline std::string shown_name(std::string_view name) {
  std::string shown;
  for (const char c : core::printable(name)) {
    if (c == '\n')
      shown += "\\x0a";
    else
      shown += c;
  }
  return shown;
}

}  // namespace sarsim::cli
