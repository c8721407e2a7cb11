#pragma once

#include <span>

namespace sarsim::signal {

/// y = constant + slope x.
struct StraightLine {
  double constant = 0.0;
  double slope = 0.0;

  [[nodiscard]] double at(double x) const { return constant + slope * x; }
};

/// The line of the least squares, each weighted; 0 where all weights are 0, level where all x are equal.
/// @param x, y, weights  as many of each
[[nodiscard]] StraightLine best_line(std::span<const double> x, std::span<const double> y,
                                     std::span<const double> weights);

}  // namespace sarsim::signal
