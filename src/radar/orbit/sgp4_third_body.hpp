#pragma once

#include <array>
#include <cstddef>

#include "core/maths/vector.hpp"
#include "radar/orbit/sgp4_elements.hpp"

namespace sarsim::radar {

/// What Sun or Moon changes of an orbit: secular rates, or periodic terms at one time.
struct ThirdBodyEffect {
  double eccentricity = 0.0;
  double inclination = 0.0;
  double longitude = 0.0;  ///< Of the mean anomaly.
  double perigee = 0.0;    ///< Of the argument of perigee, plus cos(inclination) times that of the node.
  double node = 0.0;       ///< Of the node times sin(inclination).
};

/// Orbit of Sun or Moon around the Earth. Units: minutes, radians.
struct ThirdBodyOrbit {
  core::Vec3 perigee_axis;  ///< Unit vector to its perigee; equatorial frame.
  core::Vec3 ahead_axis;    ///< Unit vector 90 deg ahead of it in the plane of its orbit.
  double motion = 0.0;      ///< Mean motion, rad/min.
  double eccentricity = 0.0;
  double strength = 0.0;          ///< Its attraction, rad/min.
  double anomaly_at_epoch = 0.0;  ///< Mean anomaly, rad.
};

/// Orbits of Sun and Moon as SGP4 takes them, as ellipses that stand still from the epoch on.
/// @param days_since_1950  the epoch, see `days_since_1950`
[[nodiscard]] ThirdBodyOrbit sun_of_sgp4(double days_since_1950);
[[nodiscard]] ThirdBodyOrbit moon_of_sgp4(double days_since_1950);

/// Effect of Sun or Moon on an orbit, to first order (Hujsak 1979; Spacetrack Report 3, section 10). With the
/// direction of the body written as X cos u + Y sin u, each effect is a quadratic form of X and Y; this class holds the
/// forms in the frame of the satellite's orbit at the epoch.
class ThirdBody {
 public:
  /// @param body       the Sun or the Moon
  /// @param satellite  at the epoch
  ThirdBody(const ThirdBodyOrbit& body, const Sgp4Elements& satellite);

  /// Secular rates, 1/min and rad/min.
  [[nodiscard]] const ThirdBodyEffect& rates() const { return rates_; }
  /// Periodic terms at a time after the epoch.
  [[nodiscard]] ThirdBodyEffect periodic_at(double time_min) const;

 private:
  // Factors of sin^2(f)/2 - 1/4, of -sin(f) cos(f)/2 and of sin(f), f near the body's true anomaly.
  struct Wave {
    double cross = 0.0;
    double difference = 0.0;
    double sine = 0.0;
    [[nodiscard]] double at(double sin_f, double cos_f) const {
      return cross * (0.5 * sin_f * sin_f - 0.25) - 0.5 * difference * sin_f * cos_f + sine * sin_f;
    }
  };

  double motion_;
  double eccentricity_;
  double anomaly_;
  ThirdBodyEffect rates_;
  Wave on_eccentricity_, on_inclination_, on_longitude_, on_perigee_, on_node_;
};

}  // namespace sarsim::radar
