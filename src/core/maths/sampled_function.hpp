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

/// The value of a sampled function before its first knot and after its last. scene/model/function_role.hpp assigns one
/// to each function of a scene. A single knot is a constant everywhere.
enum class Beyond {
  extended,  ///< Extrapolated by its method: along straight lines, or as its low-pass filter ends (LowPassRule).
  held,      ///< It keeps the value of the nearer end.
  zero,      ///< It is 0.
};

/// What a cubic spline does at its first and last knot (decision 17).
enum class CubicEnds {
  chords,      ///< Slopes of the first and last chord: wrong by half a segment's bend, an error that decays inwards.
  not_a_knot,  ///< One cubic through the first three knots and one through the last three: a cubic is met exactly.
};

}  // namespace sarsim::core
