#pragma once

#include <vector>

namespace sarsim::core {

/// How values between the knots of a sampled function are found; the script's LINEAR, CUBIC, MFILTER.
enum class Interpolation { linear, cubic, low_pass };

/// One given point of a function.
struct Knot {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(const Knot&, const Knot&) = default;
};

/// A function given by points, ascending in x. No points: 0 everywhere; one: constant.
struct SampledFunction {
  Interpolation method = Interpolation::linear;
  std::vector<Knot> knots;

  friend bool operator==(const SampledFunction&, const SampledFunction&) = default;
};

}  // namespace sarsim::core
