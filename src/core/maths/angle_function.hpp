#pragma once

#include "core/maths/interpolator.hpp"

namespace sarsim::core {

/// How the angles of a table are interpreted.
enum class AngleRule {
  magnitude,  ///< Magnitudes: the function is even, and beyond its points its Interpolator's Beyond applies.
  azimuth,    ///< Signed, with a period of 360 degrees.
  elevation,  ///< Signed, from -90 to 90 degrees.
};

/// A function of an angle, given by points.
///
/// AngleRule::azimuth and AngleRule::elevation: a table without negative angles that ends at 180 degrees or before is
/// mirrored, f(-x) = f(x). Any other table is signed, and an angle outside it is shifted by 360 degrees if that brings
/// it inside. Beyond the points the function keeps the value of the nearer end; but an azimuth table whose gap from its
/// last point over 180 degrees to its first is at most twice its largest spacing is periodic: its method interpolates
/// across the gap as if the points were repeated with a period of 360 degrees; low-pass tables then use a grid of 360
/// degrees over their number of points.
class AngleFunction {
 public:
  /// 0 everywhere.
  AngleFunction() = default;
  /// A function of the angle's magnitude [deg]; implicit, since that is also a function of the angle.
  AngleFunction(Interpolator of_magnitude);  // NOLINT(google-explicit-constructor)
  /// @param function  against degrees, ascending
  /// @param rules     Beyond and LowPassRule apply to AngleRule::magnitude only; the other rules keep the end values
  ///                  and anchor low-pass grids at the first knot
  AngleFunction(const SampledFunction& function, InterpolationRules rules, AngleRule rule);

  /// @param angle_deg  -180 to 180
  [[nodiscard]] double value(double angle_deg) const { return function_.value(argument_deg(angle_deg)); }
  /// Whether an angle of -180 to 180 degrees is within the points, or within a gap that is interpolated across. True
  /// for a single point, and for none.
  [[nodiscard]] bool covers(double angle_deg) const;
  /// Whether f(-x) = f(x) by the rule: of magnitudes, or mirrored.
  [[nodiscard]] bool is_even() const { return even_; }
  /// Whether it is periodic: the gap over 180 degrees is interpolated across.
  [[nodiscard]] bool goes_round() const { return round_; }

  /// The function of the argument that `value` evaluates.
  [[nodiscard]] const Interpolator& function() const { return function_; }
  /// Argument of `function()` for an angle of -180 to 180 degrees [deg]: the magnitude for even functions; otherwise
  /// the angle plus a constant, with a jump of 360 degrees in the middle of the gap of a signed table.
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
