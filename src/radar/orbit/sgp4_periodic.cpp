#include "radar/orbit/sgp4_periodic.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim::radar {

namespace {

// Elements with the terms of long period: e cos(w), e sin(w) and the mean argument of latitude.
struct LongPeriod {
  double e_cos;
  double e_sin;
  double mean_latitude;
};

LongPeriod with_long_period(const Sgp4Elements& mean) {
  constexpr double j3_over_j2 = Sgp4Earth::j3 / Sgp4Earth::j2;
  const double s = std::sin(mean.inclination);
  const double c = std::cos(mean.inclination);
  // 1 + cos(i) is kept off 0 for equatorial orbits against the turning Earth.
  const double one_plus_c = std::abs(c + 1.0) > 1.5e-12 ? 1.0 + c : 1.5e-12;
  const double p = mean.axis * (1.0 - mean.eccentricity * mean.eccentricity);
  LongPeriod l{};
  l.e_cos = mean.eccentricity * std::cos(mean.perigee);
  l.e_sin = mean.eccentricity * std::sin(mean.perigee) - 0.5 * j3_over_j2 * s / p;
  l.mean_latitude = mean.anomaly + mean.perigee - 0.25 * j3_over_j2 * s * (3.0 + 5.0 * c) / one_plus_c * l.e_cos / p;
  return l;
}

// Kepler's equation in regular variables, for the eccentric anomaly plus the argument of perigee: Newton's method with
// steps of at most 0.95, as the published states were made.
double eccentric_latitude(const LongPeriod& l) {
  const double target = sgp4_remainder(l.mean_latitude);
  double u = target;
  double step = 1.0;
  for (int i = 0; i < 10 && std::abs(step) >= 1e-12; ++i) {
    const double s = std::sin(u);
    const double c = std::cos(u);
    step = (target - l.e_sin * c + l.e_cos * s - u) / (1.0 - c * l.e_cos - s * l.e_sin);
    step = std::clamp(step, -0.95, 0.95);
    u += step;
  }
  return u;
}

// Place and speed in the plane of the orbit (Earth radii; minutes over the root of the gravitational parameter).
struct InPlane {
  double radius;
  double radial_speed;
  double across_speed;
  double cosine;  // of the argument of latitude
  double sine;
  double p;
};

InPlane in_plane(const Sgp4Elements& mean, const LongPeriod& l, double e2) {
  const double a = mean.axis;
  const double u = eccentric_latitude(l);
  const double s = std::sin(u);
  const double c = std::cos(u);
  const double e_cos_anomaly = l.e_cos * c + l.e_sin * s;
  const double e_sin_anomaly = l.e_cos * s - l.e_sin * c;
  const double tilt = e_sin_anomaly / (1.0 + std::sqrt(1.0 - e2));
  InPlane place{};
  place.p = a * (1.0 - e2);
  place.radius = a * (1.0 - e_cos_anomaly);
  place.radial_speed = std::sqrt(a) * e_sin_anomaly / place.radius;
  place.across_speed = std::sqrt(place.p) / place.radius;
  place.cosine = a / place.radius * (c - l.e_cos + l.e_sin * tilt);
  place.sine = a / place.radius * (s - l.e_sin - l.e_cos * tilt);
  return place;
}

// A state from polar coordinates in a plane: argument of latitude, node, inclination.
OrbitState state_from(double latitude, double node, double inclination, double radius, double radial_speed,
                      double across_speed) {
  const double su = std::sin(latitude), cu = std::cos(latitude);
  const double so = std::sin(node), co = std::cos(node);
  const double si = std::sin(inclination), ci = std::cos(inclination);
  const core::Vec3 outward{co * cu - so * ci * su, so * cu + co * ci * su, si * su};
  const core::Vec3 ahead{-co * su - so * ci * cu, co * ci * cu - so * su, si * cu};
  const double length_m = 1000.0 * Sgp4Earth::radius_km;
  const double speed_mps = length_m * Sgp4Earth::root_mu() / 60.0;
  return {(length_m * radius) * outward, speed_mps * (radial_speed * outward + across_speed * ahead)};
}

}  // namespace

std::variant<OrbitState, const char*> sgp4_state(const Sgp4Elements& mean) {
  const LongPeriod l = with_long_period(mean);
  const double e2 = l.e_cos * l.e_cos + l.e_sin * l.e_sin;
  if (!(e2 < 1.0)) return "the eccentricity with its terms of long period is not below 1";
  const InPlane place = in_plane(mean, l, e2);

  // Terms of short period, by J2.
  const double sin_2u = 2.0 * place.sine * place.cosine;
  const double cos_2u = 1.0 - 2.0 * place.sine * place.sine;
  const double k = 0.5 * Sgp4Earth::j2 / place.p;
  const double k2 = k / place.p;
  const double ci = std::cos(mean.inclination);
  const double si = std::sin(mean.inclination);
  const double c2 = ci * ci;
  const double s2 = 1.0 - c2;
  const double radius =
      place.radius * (1.0 - 1.5 * k2 * std::sqrt(1.0 - e2) * (3.0 * c2 - 1.0)) + 0.5 * k * s2 * cos_2u;
  if (!(radius >= 1.0)) return "the satellite has decayed";
  const double latitude = std::atan2(place.sine, place.cosine) - 0.25 * k2 * (7.0 * c2 - 1.0) * sin_2u;
  const double node = mean.node + 1.5 * k2 * ci * sin_2u;
  const double inclination = mean.inclination + 1.5 * k2 * ci * si * cos_2u;
  const double n = mean.motion / Sgp4Earth::root_mu();
  return state_from(latitude, node, inclination, radius, place.radial_speed - n * k * s2 * sin_2u,
                    place.across_speed + n * k * (s2 * cos_2u + 1.5 * (3.0 * c2 - 1.0)));
}

}  // namespace sarsim::radar
