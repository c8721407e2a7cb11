#pragma once

#include <cmath>
#include <complex>
#include <functional>

#include "core/maths/vector.hpp"

/// The path of a pulse, computed independently of what is verified: in long double, from the places at each time.
namespace sarsim::workflow::verify {

/// A place [m] in long double.
struct Place {
  long double x = 0.0L;
  long double y = 0.0L;
  long double z = 0.0L;

  friend Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Place operator*(long double s, const Place& a) { return {s * a.x, s * a.y, s * a.z}; }
};

[[nodiscard]] inline long double dot_of(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline long double length_of(const Place& a) { return std::sqrt(dot_of(a, a)); }
[[nodiscard]] inline Place cross_of(const Place& a, const Place& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Place place(const core::Vec3& v) { return {v.x, v.y, v.z}; }

/// `v` turned about the axis `k` of length 1 by a right-handed angle (Rodrigues' formula).
[[nodiscard]] inline Place turned(const Place& v, const Place& k, long double angle_rad) {
  const long double c = std::cos(angle_rad);
  return c * v + std::sin(angle_rad) * cross_of(k, v) + ((1.0L - c) * dot_of(k, v)) * k;
}

/// Where something is at a time [s], world.
using Motion = std::function<Place(long double)>;

/// Something at rest.
[[nodiscard]] inline Motion at_rest(const Place& where) {
  return [where](long double) { return where; };
}
/// Something that is at `start` at t = 0 and moves straight on.
[[nodiscard]] inline Motion straight_motion(const Place& start, const Place& velocity) {
  return [start, velocity](long double t) { return start + t * velocity; };
}

/// Seconds from sending at `sent_s` to receiving: |P(t1) - X(t0)| = c (t1 - t0), |X(t2) - P(t1)| = c (t2 - t1), by
/// fixed-point iteration, all motions at their own times.
[[nodiscard]] long double two_way_s(const Motion& radar, const Motion& point, long double sent_s);

/// What a receiver that mixes with exp(-j 2 pi f t) gets `after_send_s` after t(n) = `middle_s`, at which the middle of
/// a pulse exp(j 2 pi f t + j pi K t^2) left. Of amplitude 1, by solving for the time at which it was sent.
[[nodiscard]] std::complex<double> echo_received(const Motion& radar, const Motion& point, double middle_s,
                                                 double after_send_s, double carrier_hz, double rate_hz_per_s = 0.0);

}  // namespace sarsim::workflow::verify
