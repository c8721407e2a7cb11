#pragma once

#include <array>
#include <cstddef>

#include "radar/orbit/sgp4_elements.hpp"

namespace sarsim::radar {

/// Resonance of a deep-space orbit with the turning Earth (Spacetrack Report 3, section 10; Hujsak 1979): orbits of
/// about 24 h, and eccentric ones of about 12 h. Two numbers are integrated from the epoch, in steps of 720 min: the
/// stroboscopic longitude lambda, and the mean motion n:
///
///     d lambda/dt = n + drift,   dn/dt = sum of amplitude sin(k lambda + j perigee - phase).
///
/// Every call integrates from the epoch, so that the result does not depend on earlier calls. It takes 0.1 to 0.4 us
/// for each 12 h between epoch and time. Units: minutes, radians.
class Sgp4Resonance {
 public:
  /// @param epoch       elements at the epoch
  /// @param zonal       rates of the Earth's flattening
  /// @param third_body  rates of Sun and Moon
  /// @param sidereal_angle_rad  Greenwich sidereal time of the epoch
  Sgp4Resonance(const Sgp4Elements& epoch, const Sgp4Rates& zonal, const Sgp4Rates& third_body,
                double sidereal_angle_rad);

  /// False for orbits without resonance: they need no call of `apply`.
  [[nodiscard]] bool active() const { return period_ != Period::none; }

  /// Replaces mean motion and mean anomaly of `mean` by those of the resonant orbit, `time_min` after the epoch. Node
  /// and perigee must have their secular terms.
  void apply(double time_min, Sgp4Elements& mean) const;

 private:
  enum class Period { none, half_day, day };
  struct Term {
    double amplitude = 0.0;  // rad/min^2
    double longitudes = 0.0;
    double perigees = 0.0;
    double phase = 0.0;
  };
  struct Point {
    double longitude = 0.0;
    double motion = 0.0;
  };
  struct Slopes {
    double longitude = 0.0;
    double motion = 0.0;
    double motion_rate = 0.0;
  };

  static Period period_of(const Sgp4Elements& epoch);
  void prepare_day(const Sgp4Elements& epoch);
  void prepare_half_day(const Sgp4Elements& epoch);
  void add(Term term) { terms_[count_++] = term; }
  [[nodiscard]] Slopes slopes_at(double time_min, const Point& point) const;
  [[nodiscard]] Point integrated(double time_min) const;

  Period period_ = Period::none;
  std::array<Term, 10> terms_;
  std::size_t count_ = 0;
  Point start_;
  double drift_ = 0.0;  // of the longitude beyond the mean motion, rad/min
  double sidereal_angle_ = 0.0;
  double perigee_ = 0.0;
  double perigee_rate_ = 0.0;
};

}  // namespace sarsim::radar
