#pragma once

#include <vector>

#include "core/maths/sampled_function.hpp"

namespace sarsim::radar {

/// A periodic function through points, of period 1: cubics with a continuous slope that never overshoot (monotone
/// between points, level at extremes; Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5, 1984). For joint angles, whose
/// few points a spline would leave by several degrees.
class GaitCurve {
 public:
  /// @param points  at any x, brought between 0 and 1 by whole periods; of two within 1e-9 the first counts. At least
  ///                one.
  explicit GaitCurve(const std::vector<core::Knot>& points);

  /// The value at any x.
  [[nodiscard]] double at(double x) const;

 private:
  std::vector<core::Knot> knots_;  // ascending; the first one again behind the last, a period later
  std::vector<double> slopes_;
};

}  // namespace sarsim::radar
