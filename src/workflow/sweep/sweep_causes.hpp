#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

#include "core/report/problem.hpp"
#include "workflow/sweep/sweep_axes.hpp"

namespace sarsim::workflow {

/// The causes of problems of variations, each once, as the first variation that has it words it; the same whatever the
/// order in which variations come. May be added to from many threads.
class Causes {
 public:
  /// @param alike  so many variations have these problems
  void add(std::size_t variation, std::size_t alike, const core::Problems& problems);

  /// Errors first, then by the first variation. Hints say in which of `variations` they are met, where not in all.
  [[nodiscard]] core::Problems problems(const Sweep& sweep, std::size_t variations) const;

 private:
  struct Cause {
    core::Problem problem;
    std::size_t first = 0;  // Variation.
    std::size_t order = 0;  // Among the problems of that variation.
    std::size_t variations = 0;
  };
  using Key = std::tuple<core::Severity, std::string, std::string, std::size_t, std::string>;

  std::map<Key, Cause> causes_;
  std::mutex lock_;
};

}  // namespace sarsim::workflow
