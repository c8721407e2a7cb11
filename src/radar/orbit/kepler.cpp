#include "radar/orbit/kepler.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

using core::Vec3;

constexpr double turn_rad = 2.0 * core::pi;

double in_one_turn(double angle_rad) {
  const double rest = std::fmod(angle_rad, turn_rad);
  return rest < 0.0 ? rest + turn_rad : rest;
}

// For mean anomalies in [-pi, pi]. The root is within e of M, and the function rises everywhere.
double eccentric_anomaly_in_turn(double m, double e) {
  double low = m - e;
  double high = m + e;
  double x = m + 0.85 * std::copysign(e, m);
  for (int i = 0; i < 64; ++i) {
    const double excess = x - e * std::sin(x) - m;
    (excess > 0.0 ? high : low) = x;
    double next = x - excess / (1.0 - e * std::cos(x));
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    // Newton's steps square their error: the next one would be below 1e-15 of x.
    if (std::abs(next - x) <= 1e-8 * std::abs(x)) return next;
    x = next;
  }
  return x;
}

// True minus eccentric anomaly, without loss where they are nearly equal; `beta` = e/(1 + sqrt(1 - e^2)).
double true_minus_eccentric(double e, double eccentric) {
  const double beta = e / (1.0 + std::sqrt(1.0 - e * e));
  return 2.0 * std::atan2(beta * std::sin(eccentric), 1.0 - beta * std::cos(eccentric));
}

// Axes of the ellipse: to its perigee, 90 deg ahead of it, along its normal.
struct EllipseAxes {
  Vec3 perigee;
  Vec3 ahead;
  Vec3 normal;
};

EllipseAxes ellipse_axes(const KeplerElements& k) {
  const double so = std::sin(k.ascending_node_rad), co = std::cos(k.ascending_node_rad);
  const double si = std::sin(k.inclination_rad), ci = std::cos(k.inclination_rad);
  const double sw = std::sin(k.perigee_rad), cw = std::cos(k.perigee_rad);
  const Vec3 node{co, so, 0.0};
  const Vec3 across{-ci * so, ci * co, si};
  return {cw * node + sw * across, cw * across - sw * node, Vec3{si * so, -si * co, ci}};
}

// Motion on an ellipse that stands still, with a mean motion of its own.
OrbitMotion motion_in_ellipse(const KeplerElements& k, const EllipseAxes& axes, double mean_motion) {
  const double e = k.eccentricity;
  const double a = k.semi_major_axis_m;
  const double b = a * std::sqrt(1.0 - e * e);
  const double anomaly = eccentric_anomaly_rad(std::remainder(k.mean_anomaly_rad, turn_rad), e);
  const double s = std::sin(anomaly), c = std::cos(anomaly);
  const double radius_by_a = 1.0 - e * c;
  const double rate = mean_motion / radius_by_a;
  OrbitMotion motion;
  motion.position_m = a * (c - e) * axes.perigee + b * s * axes.ahead;
  motion.velocity_mps = -a * s * rate * axes.perigee + b * c * rate * axes.ahead;
  motion.acceleration_mps2 = -mean_motion * mean_motion / (radius_by_a * radius_by_a * radius_by_a) * motion.position_m;
  return motion;
}

double mean_motion_of(const KeplerElements& k, const EarthGravity& gravity) {
  const double a = k.semi_major_axis_m;
  return std::sqrt(gravity.mu_m3_per_s2 / a) / a;
}

bool is_ellipse(const KeplerElements& k) {
  return k.semi_major_axis_m > 0.0 && std::isfinite(k.semi_major_axis_m) && k.eccentricity >= 0.0 &&
         k.eccentricity < 1.0 && std::isfinite(k.inclination_rad) && std::isfinite(k.ascending_node_rad) &&
         std::isfinite(k.perigee_rad) && std::isfinite(k.mean_anomaly_rad);
}

}  // namespace

double eccentric_anomaly_rad(double mean_anomaly_rad, double eccentricity) {
  CORE_EXPECT(eccentricity >= 0.0 && eccentricity < 1.0);
  const double in_turn = std::remainder(mean_anomaly_rad, turn_rad);
  return mean_anomaly_rad - in_turn + eccentric_anomaly_in_turn(in_turn, eccentricity);
}

double true_anomaly_rad(double mean_anomaly_rad, double eccentricity) {
  const double eccentric = eccentric_anomaly_rad(mean_anomaly_rad, eccentricity);
  return eccentric + true_minus_eccentric(eccentricity, eccentric);
}

double mean_anomaly_rad(double true_anomaly_rad, double eccentricity) {
  CORE_EXPECT(eccentricity >= 0.0 && eccentricity < 1.0);
  const double beta = eccentricity / (1.0 + std::sqrt(1.0 - eccentricity * eccentricity));
  const double difference =
      2.0 * std::atan2(beta * std::sin(true_anomaly_rad), 1.0 + beta * std::cos(true_anomaly_rad));
  const double eccentric = true_anomaly_rad - difference;
  return eccentric - eccentricity * std::sin(eccentric);
}

std::optional<KeplerElements> osculating_elements(const OrbitState& state, const EarthGravity& gravity) {
  constexpr double vanishing = 1e-15;
  const double mu = gravity.mu_m3_per_s2;
  const Vec3& r = state.position_m;
  const Vec3& v = state.velocity_mps;
  const double radius = core::norm(r);
  const Vec3 momentum = core::cross(r, v);
  const double h = core::norm(momentum);
  const double inverse_axis = 2.0 / radius - core::dot(v, v) / mu;
  if (!(inverse_axis > 0.0) || !(h > 0.0) || !(radius > 0.0)) return std::nullopt;

  KeplerElements k;
  k.semi_major_axis_m = 1.0 / inverse_axis;
  const double e_cos = 1.0 - radius * inverse_axis;  // of the eccentric anomaly
  const double e_sin = core::dot(r, v) * std::sqrt(inverse_axis / mu);
  k.eccentricity = std::hypot(e_cos, e_sin);
  if (!(k.eccentricity < 1.0)) return std::nullopt;
  const double level = std::hypot(momentum.x, momentum.y);
  k.inclination_rad = std::atan2(level, momentum.z);
  const bool inclined = level > vanishing * h;
  k.ascending_node_rad = inclined ? in_one_turn(std::atan2(momentum.x, -momentum.y)) : 0.0;
  const double so = std::sin(k.ascending_node_rad), co = std::cos(k.ascending_node_rad);
  const Vec3 node{co, so, 0.0};
  const double latitude = std::atan2(core::dot(r, core::cross(momentum, node)) / h, core::dot(r, node));
  if (k.eccentricity <= vanishing) {
    k.mean_anomaly_rad = in_one_turn(latitude);
    return k;
  }
  const double eccentric = std::atan2(e_sin, e_cos);
  k.mean_anomaly_rad = in_one_turn(eccentric - e_sin);
  k.perigee_rad = in_one_turn(latitude - eccentric - true_minus_eccentric(k.eccentricity, eccentric));
  return k;
}

OrbitState state_on_ellipse(const KeplerElements& elements, const EarthGravity& gravity) {
  CORE_EXPECT(is_ellipse(elements));
  const OrbitMotion motion = motion_in_ellipse(elements, ellipse_axes(elements), mean_motion_of(elements, gravity));
  return {motion.position_m, motion.velocity_mps};
}

OrbitRates j2_rates(const KeplerElements& elements, const EarthGravity& gravity) {
  CORE_EXPECT(is_ellipse(elements));
  const double b2 = 1.0 - elements.eccentricity * elements.eccentricity;
  const double n = mean_motion_of(elements, gravity);
  const double radius_by_p = gravity.radius_m / (elements.semi_major_axis_m * b2);
  const double k = 1.5 * gravity.j2 * radius_by_p * radius_by_p * n;
  const double s = std::sin(elements.inclination_rad);
  return {-k * std::cos(elements.inclination_rad), k * (2.0 - 2.5 * s * s),
          n + k * std::sqrt(b2) * (1.0 - 1.5 * s * s)};
}

SecularOrbit::SecularOrbit(const KeplerElements& elements, const EarthGravity& gravity)
    : SecularOrbit(elements, j2_rates(elements, gravity)) {}

KeplerElements SecularOrbit::elements_at(double time_s) const {
  KeplerElements k = elements_;
  k.ascending_node_rad += rates_.ascending_node_rad_per_s * time_s;
  k.perigee_rad += rates_.perigee_rad_per_s * time_s;
  k.mean_anomaly_rad += rates_.mean_anomaly_rad_per_s * time_s;
  return k;
}

OrbitMotion SecularOrbit::at(double time_s) const {
  const KeplerElements k = elements_at(time_s);
  const EllipseAxes axes = ellipse_axes(k);
  OrbitMotion motion = motion_in_ellipse(k, axes, rates_.mean_anomaly_rad_per_s);
  // The axes turn with the node about z and with the perigee about the normal, which itself turns about z.
  const Vec3 about_z{0.0, 0.0, rates_.ascending_node_rad_per_s};
  const Vec3 about_normal = rates_.perigee_rad_per_s * axes.normal;
  const Vec3 turning = about_z + about_normal;
  const Vec3 carried = core::cross(turning, motion.position_m);
  motion.acceleration_mps2 = motion.acceleration_mps2 + 2.0 * core::cross(turning, motion.velocity_mps) +
                             core::cross(turning, carried) +
                             core::cross(core::cross(about_z, about_normal), motion.position_m);
  motion.velocity_mps = motion.velocity_mps + carried;
  return motion;
}

double SecularOrbit::nodal_period_s() const {
  return turn_rad / (rates_.mean_anomaly_rad_per_s + rates_.perigee_rad_per_s);
}

// The velocity of the turning ellipse differs by about 1e-3 from that on one that stands still; each round makes the
// rest as much smaller.
std::optional<KeplerElements> secular_elements(const OrbitState& state, const EarthGravity& gravity) {
  constexpr int max_rounds = 20;
  constexpr double settled_mps = 1e-10;
  OrbitState sought = state;
  std::optional<KeplerElements> elements = osculating_elements(sought, gravity);
  for (int i = 0; elements && i < max_rounds; ++i) {
    const core::Vec3 miss = state.velocity_mps - SecularOrbit(*elements, gravity).at(0.0).velocity_mps;
    if (core::norm(miss) < settled_mps) break;
    sought.velocity_mps = sought.velocity_mps + miss;
    elements = osculating_elements(sought, gravity);
  }
  return elements;
}

}  // namespace sarsim::radar
