#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "radar/orbit/state_table.hpp"

/// What is not interpolated over, stated once for the states and the attitudes of a motion file.
namespace sarsim::workflow {

/// The hint of the error.
inline constexpr const char* no_way_over_gaps =
    "nothing is interpolated over a gap of more than 4 times the usual spacing";

/// Samples further apart than this, s, leave a gap between them: 4 times the median of the spacings; infinite for fewer
/// than 3 samples.
/// @param times_s  ascending
[[nodiscard]] inline double largest_gap_s(const std::vector<double>& times_s) {
  constexpr double usual_spacings = 4.0;
  if (times_s.size() < 3) return std::numeric_limits<double>::infinity();
  std::vector<double> spacings_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) spacings_s.push_back(times_s[i] - times_s[i - 1]);
  const auto middle = spacings_s.begin() + static_cast<std::ptrdiff_t>(spacings_s.size() / 2);
  std::ranges::nth_element(spacings_s, middle);
  return usual_spacings * *middle;
}

/// The first gap that touches the times that are needed; nothing where there is none.
[[nodiscard]] inline std::optional<radar::TimeSpan> gap_within(const std::vector<double>& times_s,
                                                               const radar::TimeSpan& needed) {
  const double largest_s = largest_gap_s(times_s);
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const radar::TimeSpan step{times_s[i - 1], times_s[i]};
    const bool touches = step.first_s <= needed.last_s && step.last_s >= needed.first_s;
    if (touches && step.last_s - step.first_s > largest_s) return step;
  }
  return std::nullopt;
}

}  // namespace sarsim::workflow
