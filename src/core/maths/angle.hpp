#pragma once

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::core {

/// An angle that remembers the degrees it was given in, so that a scene writes back what was typed.
/// Everything that computes takes `rad()`.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle from_deg(double degrees) { return Angle(degrees); }
  static constexpr Angle from_rad(double radians) { return Angle(radians * deg_per_rad); }

  [[nodiscard]] constexpr double deg() const { return degrees_; }
  [[nodiscard]] constexpr double rad() const { return degrees_ * rad_per_deg; }

  friend constexpr bool operator==(const Angle&, const Angle&) = default;

 private:
  constexpr explicit Angle(double degrees) : degrees_(degrees) {}
  double degrees_ = 0.0;
};

/// A power ratio that remembers the decibels it was given in. `factor()` is 10^(dB/10).
class PowerRatio {
 public:
  constexpr PowerRatio() = default;
  static constexpr PowerRatio from_db(double decibels) { return PowerRatio(decibels); }

  [[nodiscard]] constexpr double db() const { return decibels_; }
  [[nodiscard]] double factor() const { return std::pow(10.0, decibels_ / 10.0); }

  friend constexpr bool operator==(const PowerRatio&, const PowerRatio&) = default;

 private:
  constexpr explicit PowerRatio(double decibels) : decibels_(decibels) {}
  double decibels_ = 0.0;
};

}  // namespace sarsim::core
