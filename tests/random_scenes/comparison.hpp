#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"

namespace sarsim::test {

/// Something that does not hold for a scene.
struct Finding {
  std::string check;  ///< Which of the comparisons; the same word for the same kind of failure.
  std::string text;   ///< What was found.
};

/// What came of a scene.
struct Examination {
  std::string refused;  ///< The first error of `check` or `survey`; empty where the scene could be simulated.
  std::vector<Finding> findings;
  double worst_error = 0.0;  ///< Largest error of a fast engine as a share of what is promised.
  std::size_t rows = 0;      ///< Rows compared.

  [[nodiscard]] bool sound() const { return findings.empty(); }
};

/// Holds a scene against everything that is promised of all scenes:
///
/// - its script is read again as the same scene, and written again as the same text;
/// - every engine gives the rows of the reference within the tolerance: for each row
///   ||s - s_ref|| <= tolerance sqrt(sum |a|^2 ||p||^2), times the largest gain of whatever linear follows
///   (sensitivity-time control, matched filter, range profile), plus the rounding of double arithmetic;
/// - a compressed recording is the raw recording of the same samples, convolved in the plain way with the taps, and a
///   range profile the profile of the raw pulses' means;
/// - the bytes of the file do not depend on the number of threads or on how the rows are divided;
/// - a geometry table can be made.
[[nodiscard]] Examination examine(const scene::Scene& scene);

}  // namespace sarsim::test
