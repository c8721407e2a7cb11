#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "core/report/problem.hpp"

namespace sarsim::core {

/// Thrown where a request cannot be carried out because of mistakes in what the user supplied: a script, a data file,
/// an option. Holds all of them; a failure of the world (disk, memory) is another exception.
struct InvalidRequest : std::runtime_error {
  explicit InvalidRequest(Problems all) : std::runtime_error("the request was refused"), problems(std::move(all)) {}
  /// One error, with a hint where there is one.
  explicit InvalidRequest(std::string message, std::string hint = {})
      : std::runtime_error(message), problems{error(std::move(message)).hint(std::move(hint))} {}
  Problems problems;
};

}  // namespace sarsim::core
