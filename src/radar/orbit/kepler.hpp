#pragma once

#include <optional>

#include "radar/orbit/orbit_state.hpp"

namespace sarsim::radar {

/// The Earth's field of gravity as far as its flattening, WGS-84 with J2 of EGM96.
struct EarthGravity {
  double mu_m3_per_s2 = 3.986004418e14;
  double radius_m = 6378137.0;
  double j2 = 1.082626683e-3;
};

/// An ellipse around the Earth and a place on it. Frame: x and y in the equator, z to the north pole; not turning.
struct KeplerElements {
  double semi_major_axis_m = 0.0;
  double eccentricity = 0.0;        ///< In [0, 1).
  double inclination_rad = 0.0;     ///< In [0, pi].
  double ascending_node_rad = 0.0;  ///< From the x axis; right ascension where that points to the equinox.
  double perigee_rad = 0.0;         ///< Argument of perigee.
  double mean_anomaly_rad = 0.0;
};

/// Solves Kepler's equation E - e sin E = M for the eccentric anomaly, in the turn of M. Newton's method between
/// bounds, at most 64 steps (usually 4). The equation holds to 1e-14 rad for e < 0.99 and M within half a turn; the
/// rounding of M adds to it in higher turns.
/// @param eccentricity  in [0, 1)
[[nodiscard]] double eccentric_anomaly_rad(double mean_anomaly_rad, double eccentricity);

/// True anomaly of a mean anomaly, in the same turn (Vallado, "Fundamentals of Astrodynamics", 2.2).
[[nodiscard]] double true_anomaly_rad(double mean_anomaly_rad, double eccentricity);
/// Mean anomaly of a true anomaly, in the same turn.
[[nodiscard]] double mean_anomaly_rad(double true_anomaly_rad, double eccentricity);

/// The elements of the ellipse on which a satellite would go on if the Earth were a point (osculating elements). Angles
/// are in [0, 2 pi). Without inclination (below 1e-15) the node is 0, without eccentricity the perigee is at the node.
/// Nothing for a state that is not bound to the Earth, and for one that falls straight down.
[[nodiscard]] std::optional<KeplerElements> osculating_elements(const OrbitState& state,
                                                                const EarthGravity& gravity = {});

/// The state on an ellipse without perturbations: the reverse of `osculating_elements`.
[[nodiscard]] OrbitState state_on_ellipse(const KeplerElements& elements, const EarthGravity& gravity = {});

/// Secular rates of an orbit, rad/s.
struct OrbitRates {
  double ascending_node_rad_per_s = 0.0;
  double perigee_rad_per_s = 0.0;
  double mean_anomaly_rad_per_s = 0.0;
};

/// The rates that J2 gives, to first order (Vallado 9.4; Brouwer 1959): with p = a(1 - e^2) and k = 3/2 J2 (R/p)^2 n,
///
///     node: -k cos i,   perigee: k (2 - 5/2 sin^2 i),   mean anomaly: n + k sqrt(1 - e^2) (1 - 3/2 sin^2 i).
[[nodiscard]] OrbitRates j2_rates(const KeplerElements& elements, const EarthGravity& gravity = {});

/// An ellipse that turns with constant rates: an orbit for studies. It leaves out the periodic terms of J2 (some km
/// along the orbit and in height) and all other forces.
class SecularOrbit {
 public:
  /// The orbit under J2; `gravity.j2` = 0 makes it Kepler's. Expects a > 0, 0 <= e < 1 and finite angles.
  /// @param elements  mean elements at time 0
  explicit SecularOrbit(const KeplerElements& elements, const EarthGravity& gravity = {});
  /// The orbit with other rates.
  SecularOrbit(const KeplerElements& elements, const OrbitRates& rates) : elements_(elements), rates_(rates) {}

  /// Position and its exact derivatives, in the frame of the elements (inertial). The velocity contains the turning of
  /// the ellipse, and so differs by about 1e-3 of itself from `state_on_ellipse`.
  [[nodiscard]] OrbitMotion at(double time_s) const;
  /// The elements at a time; angles are not reduced to one turn.
  [[nodiscard]] KeplerElements elements_at(double time_s) const;

  [[nodiscard]] const OrbitRates& rates() const { return rates_; }
  /// Mean time from one ascending node to the next, s.
  [[nodiscard]] double nodal_period_s() const;

 private:
  KeplerElements elements_;
  OrbitRates rates_;
};

/// The elements of the `SecularOrbit` that goes through a state at time 0 with its velocity: the reverse of
/// `SecularOrbit::at(0)`, to rounding. Nothing where `osculating_elements` finds none.
[[nodiscard]] std::optional<KeplerElements> secular_elements(const OrbitState& state, const EarthGravity& gravity = {});

}  // namespace sarsim::radar
