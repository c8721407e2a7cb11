#pragma once

#include <vector>

#include "core/maths/sampled_function.hpp"

namespace sarsim::core {

/// A function's value and its first two derivatives at a point.
struct Jet {
  double value = 0.0;
  double slope = 0.0;
  double curvature = 0.0;
};

/// Where the reconstruction grid of Interpolation::low_pass stands (decision 18).
enum class LowPassRule {
  first_knot,  ///< Anchored at the first knot, tapered sinc, end values held outside: exact at knots of a uniform grid.
  origin,      ///< Anchored at x = 0, bare sinc of 21 terms, decaying to 0 outside (the 1998 programs).
};

/// How sampled functions are continued and completed, whatever their method.
struct InterpolationRules {
  LowPassRule low_pass = LowPassRule::first_knot;
  CubicEnds cubic_ends = CubicEnds::chords;
  Beyond beyond = Beyond::extended;

  constexpr InterpolationRules() = default;
  constexpr InterpolationRules(LowPassRule low_pass_rule, CubicEnds ends = CubicEnds::chords,
                               Beyond beyond_knots = Beyond::extended)
      : low_pass(low_pass_rule), cubic_ends(ends), beyond(beyond_knots) {}
};

/// Evaluates a sampled function. No knots: 0; one knot: constant, for every method.
///
/// - linear: straight lines, the first and last of them extended; a knot belongs to the segment on its right, so that
///   the slope at a knot is the slope to the right.
/// - cubic: the spline through the true knots (de Boor, "A Practical Guide to Splines", ch. IV) with the end slopes of
///   CubicEnds; not a knot, it is the straight line through two knots and the parabola through three. Continued by
///   straight lines outside.
/// - low pass: sum over the nearest 21 grid points of a_k sinc(u - k), u = (x - anchor)/step,
///   step = (last - first)/(count - 1); a_k is the mean of the knots within half a step of grid point k (thesis 4.6.1).
///   With LowPassRule::first_knot the sinc carries a Hann taper that ends 11 steps away (22 points then), the weights
///   are normalised to sum 1, and a grid point without a knot near takes the linearly interpolated value.
///
/// The above describes Beyond::extended outside the knots. With Beyond::held the value is that at the nearer end (of
/// the first or last grid point, low pass), with Beyond::zero it is 0; derivatives are 0 for both.
///
/// Const members are safe to call from many threads. Knots must ascend in x.
class Interpolator {
 public:
  Interpolator() = default;
  /// Prepares a function.
  /// @param y_scale  factor on its values: from units of a script to SI units
  explicit Interpolator(const SampledFunction& function, InterpolationRules rules = {}, double y_scale = 1.0);

  [[nodiscard]] double value(double x) const { return jet(x).value; }
  /// Third derivative, to the right where it jumps. Exact for straight lines and cubics; for low pass the quotient of
  /// curvatures 1/500 of a step apart, to a relative 1e-5 of the largest one.
  [[nodiscard]] double third_derivative(double x) const;
  /// No second derivative exceeds this, in magnitude: exact for straight lines (0) and cubics; infinity for low pass.
  [[nodiscard]] double curvature_bound() const;
  /// Value and derivatives with respect to x; where the function bends, the derivatives to the right.
  [[nodiscard]] Jet jet(double x) const;
  [[nodiscard]] bool empty() const { return knots_.empty(); }
  [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }

 private:
  [[nodiscard]] std::size_t segment(double x) const;
  [[nodiscard]] Jet inner_jet(double x) const;
  [[nodiscard]] Jet outer_jet(double x) const;
  [[nodiscard]] Jet linear_jet(double x) const;
  [[nodiscard]] Jet cubic_jet(double x) const;
  [[nodiscard]] Jet tapered_jet(double x) const;
  [[nodiscard]] Jet bare_sinc_jet(double x) const;
  void prepare_cubic(CubicEnds ends);
  void prepare_low_pass();

  Interpolation method_ = Interpolation::linear;
  LowPassRule rule_ = LowPassRule::first_knot;
  Beyond beyond_ = Beyond::extended;
  std::vector<Knot> knots_;
  std::vector<double> slopes_;  // cubic: slope at each knot
  std::vector<double> grid_;    // low pass: a_k
  long grid_first_ = 0;         // low pass, origin: k of grid_[0]
  double step_ = 1.0;           // low pass
};

}  // namespace sarsim::core
