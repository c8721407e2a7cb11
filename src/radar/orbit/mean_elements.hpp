#pragma once

namespace sarsim::radar {

/// Mean elements as two-line elements and OMM give them, at an epoch that is stored beside them. They are averages made
/// for the theory SGP4, and mean nothing to another one. Frame: true equator and mean equinox of the epoch (TEME).
struct MeanElements {
  double inclination_rad = 0.0;     ///< In [0, pi].
  double ascending_node_rad = 0.0;  ///< Right ascension.
  double eccentricity = 0.0;        ///< In [0, 1).
  double perigee_rad = 0.0;         ///< Argument of perigee.
  double mean_anomaly_rad = 0.0;
  double mean_motion_rad_per_s = 0.0;  ///< By Kozai's definition, as published.
  double drag_per_earth_radius = 0.0;  ///< B*, in 1/(6378.135 km); may be negative.
};

}  // namespace sarsim::radar
