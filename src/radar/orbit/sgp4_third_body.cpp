#include "radar/orbit/sgp4_third_body.hpp"

#include <cmath>

namespace sarsim::radar {

namespace {

// An angle by its cosine and sine, as the theory gives them.
struct Turn {
  double cosine;
  double sine;
};

Turn turn_of(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

// Unit vector at `u` from the ascending node in the plane of an orbit.
core::Vec3 direction_in_orbit(Turn u, Turn inclination, Turn node) {
  return {u.cosine * node.cosine - u.sine * inclination.cosine * node.sine,
          u.cosine * node.sine + u.sine * inclination.cosine * node.cosine, u.sine * inclination.sine};
}

void set_axes(ThirdBodyOrbit& body, Turn perigee, Turn inclination, Turn node) {
  body.perigee_axis = direction_in_orbit(perigee, inclination, node);
  body.ahead_axis = direction_in_orbit({-perigee.sine, perigee.cosine}, inclination, node);
}

// Constants of the theory: the Sun's orbit in the ecliptic, whose node is the equinox.
constexpr Turn ecliptic{0.91744867, 0.39785416};
constexpr Turn sun_perigee{0.1945905, -0.98088458};

double days_since_1900(double days_since_1950) { return days_since_1950 + 18261.5; }

// Components of a body's axis in the satellite's orbit: towards its node, 90 deg ahead in its plane, along its normal;
// and in the plane from its perigee.
struct AxisInOrbit {
  double node, across, normal, perigee, ahead;
};

AxisInOrbit axis_in_orbit(const core::Vec3& axis, const Sgp4Elements& satellite) {
  const Turn i = turn_of(satellite.inclination);
  const Turn o = turn_of(satellite.node);
  const Turn w = turn_of(satellite.perigee);
  AxisInOrbit a{};
  a.node = core::dot(axis, direction_in_orbit({1.0, 0.0}, i, o));
  a.across = core::dot(axis, direction_in_orbit({0.0, 1.0}, i, o));
  a.normal = core::dot(axis, core::Vec3{i.sine * o.sine, -i.sine * o.cosine, i.cosine});
  a.perigee = a.node * w.cosine + a.across * w.sine;
  a.ahead = a.across * w.cosine - a.node * w.sine;
  return a;
}

// A quadratic form of X and Y: XX + YY, XY + YX, YY - XX.
struct Quadratic {
  double sum, cross, difference;
};

template <class Form>
Quadratic quadratic(const AxisInOrbit& x, const AxisInOrbit& y, const Form& form) {
  const double xx = form(x, x);
  const double yy = form(y, y);
  return {xx + yy, form(x, y) + form(y, x), yy - xx};
}

}  // namespace

ThirdBodyOrbit sun_of_sgp4(double days_since_1950) {
  ThirdBodyOrbit sun;
  set_axes(sun, sun_perigee, ecliptic, {1.0, 0.0});
  sun.motion = 1.19459e-5;
  sun.eccentricity = 0.01675;
  sun.strength = 2.9864797e-6;
  sun.anomaly_at_epoch = sgp4_remainder(6.2565837 + 0.017201977 * days_since_1900(days_since_1950));
  return sun;
}

ThirdBodyOrbit moon_of_sgp4(double days_since_1950) {
  const double day = days_since_1900(days_since_1950);
  // The Moon's node turns on the ecliptic in 18.6 years: from it the inclination to the equator and the node there.
  const double node_on_ecliptic = sgp4_remainder(4.5236020 - 9.2422029e-4 * day);
  const Turn o = turn_of(node_on_ecliptic);
  Turn inclination{0.91375164 - 0.03568096 * o.cosine, 0.0};
  inclination.sine = std::sqrt(1.0 - inclination.cosine * inclination.cosine);
  Turn node{0.0, 0.089683511 * o.sine / inclination.sine};
  node.cosine = std::sqrt(1.0 - node.sine * node.sine);
  const double mean_perigee = 5.8351514 + 0.0019443680 * day;
  const double arc = std::atan2(ecliptic.sine * o.sine / inclination.sine,
                                node.cosine * o.cosine + ecliptic.cosine * node.sine * o.sine);
  ThirdBodyOrbit moon;
  set_axes(moon, turn_of(mean_perigee + arc - node_on_ecliptic), inclination, node);
  moon.motion = 1.5835218e-4;
  moon.eccentricity = 0.05490;
  moon.strength = 4.7968065e-7;
  moon.anomaly_at_epoch = sgp4_remainder(4.7199672 + 0.22997150 * day - mean_perigee);
  return moon;
}

ThirdBody::ThirdBody(const ThirdBodyOrbit& body, const Sgp4Elements& satellite)
    : motion_(body.motion), eccentricity_(body.eccentricity), anomaly_(body.anomaly_at_epoch) {
  const double e = satellite.eccentricity;
  const double e2 = e * e;
  const Turn w = turn_of(satellite.perigee);
  const AxisInOrbit x = axis_in_orbit(body.perigee_axis, satellite);
  const AxisInOrbit y = axis_in_orbit(body.ahead_axis, satellite);

  using Axis = const AxisInOrbit&;
  const auto apsidal = [](Axis a, Axis b) { return 12.0 * a.perigee * b.perigee - 3.0 * a.ahead * b.ahead; };
  const Quadratic for_e = quadratic(x, y, [](Axis a, Axis b) { return a.perigee * b.ahead; });
  const Quadratic for_perigee = quadratic(x, y, apsidal);
  const Quadratic for_longitude = quadratic(
      x, y, [&](Axis a, Axis b) { return 6.0 * (a.node * b.node + a.across * b.across) + (1.0 + e2) * apsidal(a, b); });
  const Quadratic for_inclination = quadratic(x, y, [&](Axis a, Axis b) {
    return -b.normal * (6.0 * a.node + e2 * (24.0 * a.perigee * w.cosine + 6.0 * a.ahead * w.sine));
  });
  const Quadratic for_node = quadratic(x, y, [&](Axis a, Axis b) {
    return b.normal * (6.0 * a.across + e2 * (24.0 * a.perigee * w.sine - 6.0 * a.ahead * w.cosine));
  });

  const double on_longitude = -body.strength / satellite.motion;
  const double on_node = -0.5 * on_longitude / std::sqrt(1.0 - e2);
  const double on_perigee = -on_longitude * std::sqrt(1.0 - e2);
  const double on_e = -15.0 * e * on_perigee;

  const double lunar_e = eccentricity_;
  on_eccentricity_ = {2.0 * on_e * for_e.cross, 2.0 * on_e * for_e.difference, 0.0};
  on_inclination_ = {-2.0 * on_node * for_inclination.cross, -2.0 * on_node * for_inclination.difference, 0.0};
  on_longitude_ = {2.0 * on_longitude * for_longitude.cross, 2.0 * on_longitude * for_longitude.difference,
                   2.0 * on_longitude * (-21.0 - 9.0 * e2) * lunar_e};
  on_perigee_ = {2.0 * on_perigee * for_perigee.cross, 2.0 * on_perigee * for_perigee.difference,
                 -18.0 * on_perigee * lunar_e};
  on_node_ = {2.0 * on_node * for_node.cross, 2.0 * on_node * for_node.difference, 0.0};

  rates_.eccentricity = on_e * motion_ * for_e.sum;
  rates_.inclination = -on_node * motion_ * for_inclination.sum;
  rates_.longitude = on_longitude * motion_ * (for_longitude.sum - 14.0 - 6.0 * e2);
  rates_.perigee = on_perigee * motion_ * (for_perigee.sum - 6.0);
  rates_.node = on_node * motion_ * for_node.sum;
}

ThirdBodyEffect ThirdBody::periodic_at(double time_min) const {
  const double m = anomaly_ + motion_ * time_min;
  const double f = m + 2.0 * eccentricity_ * std::sin(m);
  const double s = std::sin(f);
  const double c = std::cos(f);
  return {on_eccentricity_.at(s, c), on_inclination_.at(s, c), on_longitude_.at(s, c), on_perigee_.at(s, c),
          on_node_.at(s, c)};
}

}  // namespace sarsim::radar
