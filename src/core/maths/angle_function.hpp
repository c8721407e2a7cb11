#pragma once

#include "core/maths/interpolator.hpp"

namespace sarsim::core {

/// What the angles of a table mean.
enum class AngleRule {
  magnitude,  ///< Magnitudes: the function is even, and continued as its Interpolator is.
  azimuth,    ///< Signed, with a period of 360 degrees.
  elevation,  ///< Signed, from -90 to 90 degrees.
};

/// A function of an angle, given by points.
///
/// AngleRule::azimuth and AngleRule::elevation: a table without negative angles that ends at 180 degrees or before is
/// mirrored, f(-x) = f(x). Any other is signed, and an angle that lies outside of it by itself and inside after a whole
/// turn is taken there. What no point reaches has the value of the nearer end of the table; but an azimuth table whose
/// gap from its last point over 180 degrees to its first is at most twice its largest spacing goes round: its method
/// runs across the gap, as if the points were repeated for ever; of low-pass tables on a grid of 360 degrees over their
/// number.
class AngleFunction {
 public:
  /// 0 everywhere.
  AngleFunction() = default;
  /// A function of the angle's magnitude [deg]; implicit, as such a function is one of the angle.
  AngleFunction(Interpolator of_magnitude);  // NOLINT(google-explicit-constructor)
  /// @param function  against degrees, ascending
  /// @param rules     Beyond and LowPassRule count for AngleRule::magnitude alone: the others hold, from the first knot
  AngleFunction(const SampledFunction& function, InterpolationRules rules, AngleRule rule);

  /// @param angle_deg  -180 to 180
  [[nodiscard]] double value(double angle_deg) const { return function_.value(argument_deg(angle_deg)); }
  /// Whether an angle of -180 to 180 degrees is within the points, or within a gap that is interpolated across. True
  /// for a single point, and for none.
  [[nodiscard]] bool covers(double angle_deg) const;
  /// Whether f(-x) = f(x) by the rule: of magnitudes, or mirrored.
  [[nodiscard]] bool is_even() const { return even_; }
  /// Whether it goes round: the gap over 180 degrees is interpolated across.
  [[nodiscard]] bool goes_round() const { return round_; }

  /// The function of the argument that `value` evaluates.
  [[nodiscard]] const Interpolator& function() const { return function_; }
  /// Where `function()` is evaluated for an angle of -180 to 180 degrees: a constant apart from it, but for a jump of
  /// 360 degrees where the gap of a signed table has its middle.
  [[nodiscard]] double argument_deg(double angle_deg) const;
  /// Middle of the table, half a turn from that of its gap [deg]; AngleRule::azimuth and elevation, if not even.
  [[nodiscard]] double middle_deg() const { return 0.5 * (first_deg_ + last_deg_); }

 private:
  Interpolator function_;
  bool even_ = true;
  bool round_ = false;
  double first_deg_ = 0.0;  // of the points as given
  double last_deg_ = 0.0;
};

}  // namespace sarsim::core
