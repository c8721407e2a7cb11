#include "radar/orbit/kepler.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/orbit/orbit_test_support.hpp"

namespace sarsim::radar {
namespace kepler_test {

using core::pi;
using core::rad_per_deg;

constexpr KeplerElements sentinel{7070.5e3, 0.00114, 98.1817 * rad_per_deg, 1.0, 2.0, 3.0};

// The state in axes that stand still and coincide with the Earth-fixed ones at this moment.
OrbitState inertial(const OrbitState& earth_fixed) {
  const core::Vec3 w{0.0, 0.0, orbit_test::earth_rotation_rad_per_s};
  return {earth_fixed.position_m, earth_fixed.velocity_mps + core::cross(w, earth_fixed.position_m)};
}

double distance(const core::Vec3& a, const core::Vec3& b) { return core::norm(a - b); }

TEST(EccentricAnomaly, SatisfiesKeplersEquation) {
  for (const double e : {0.0, 1e-9, 0.01, 0.3, 0.7, 0.9, 0.97, 0.9899999})
    for (double m = -pi; m <= pi; m += 0.0037) {
      const long double x = eccentric_anomaly_rad(m, e);
      EXPECT_NEAR(static_cast<double>(x - static_cast<long double>(e) * std::sin(x)), m, 1e-14) << e << " " << m;
    }
}

// Where the equation is nearly a cubic, E^3 = 6 M.
TEST(EccentricAnomaly, HoldsNearThePerigeeOfLongEllipses) {
  for (const double e : {0.9, 0.99, 0.999999})
    for (double m = 1e-12; m < 0.1; m *= 1.7) {
      const long double x = eccentric_anomaly_rad(m, e);
      const auto excess = static_cast<double>(x - static_cast<long double>(e) * std::sin(x)) - m;
      EXPECT_LT(std::abs(excess), 1e-15 + 4e-16 * static_cast<double>(x)) << e << " " << m;
      EXPECT_EQ(eccentric_anomaly_rad(-m, e), -static_cast<double>(x));
    }
}

TEST(EccentricAnomaly, StaysInTheTurnOfTheMeanAnomaly) {
  for (const double turns : {-3.0, 1.0, 20.0})
    EXPECT_NEAR(eccentric_anomaly_rad(2.0 + 2.0 * pi * turns, 0.5), eccentric_anomaly_rad(2.0, 0.5) + 2.0 * pi * turns,
                1e-13);
}

TEST(TrueAnomaly, IsTheAngleOnTheEllipseAndBack) {
  for (const double e : {0.0, 0.01, 0.5, 0.95})
    for (double m = -9.0; m < 9.0; m += 0.13) {
      const double eccentric = eccentric_anomaly_rad(m, e);
      const double found = true_anomaly_rad(m, e);
      const double expected = std::atan2(std::sqrt(1.0 - e * e) * std::sin(eccentric), std::cos(eccentric) - e);
      EXPECT_NEAR(std::remainder(found - expected, 2.0 * pi), 0.0, 1e-13) << e << " " << m;
      EXPECT_LT(std::abs(found - m), pi) << e << " " << m;
      EXPECT_NEAR(mean_anomaly_rad(found, e), m, 1e-13) << e << " " << m;
    }
}

TEST(OsculatingElements, AreThoseOfThePublishedStates) {
  for (const auto& published : orbit_test::published_orbit_states) {
    const auto k = osculating_elements(inertial(published.earth_fixed));
    ASSERT_TRUE(k.has_value()) << published.name;
    EXPECT_NEAR(k->semi_major_axis_m / 1000.0, published.semi_major_axis_km, 0.5e-3) << published.name;
    EXPECT_NEAR(k->eccentricity, published.eccentricity, 0.5e-5) << published.name;
    EXPECT_NEAR(k->inclination_rad / rad_per_deg, published.inclination_deg, 0.5e-4) << published.name;
  }
}

TEST(OsculatingElements, GiveTheStateBack) {
  for (const auto& published : orbit_test::published_orbit_states) {
    const OrbitState state = inertial(published.earth_fixed);
    const OrbitState back = state_on_ellipse(*osculating_elements(state));
    EXPECT_LT(distance(back.position_m, state.position_m), 3e-8) << published.name;
    EXPECT_LT(distance(back.velocity_mps, state.velocity_mps), 3e-11) << published.name;
  }
}

// Ellipses of every shape and attitude, in the equator and circular ones among them, whose angles are undefined.
TEST(OsculatingElements, GiveStatesBackOnOrbitsOfAllKinds) {
  for (const double e : {0.0, 1e-13, 1e-8, 0.01, 0.6, 0.95})
    for (const double i : {0.0, 1e-13, 1e-8, 0.4, pi / 2.0, 2.5, pi - 1e-8, pi})
      for (double angle = 0.1; angle < 6.2; angle += 0.7) {
        const KeplerElements given{8.0e6, e, i, angle, 6.0 - 0.5 * angle, 1.3 * angle};
        const OrbitState state = state_on_ellipse(given);
        const auto k = osculating_elements(state);
        ASSERT_TRUE(k.has_value());
        const OrbitState back = state_on_ellipse(*k);
        // Rounding of r and v, 1e-16 of each, moves the place along the orbit by up to 1/(1 - e) times as much.
        const double tolerance = 1e-14 / (1.0 - e);
        EXPECT_LT(distance(back.position_m, state.position_m), tolerance * 8.0e6) << e << " " << i << " " << angle;
        EXPECT_LT(distance(back.velocity_mps, state.velocity_mps), 10.0 * tolerance * core::norm(state.velocity_mps))
            << e << " " << i << " " << angle;
      }
}

TEST(OsculatingElements, ReturnTheElementsThatMadeTheState) {
  for (double angle = 0.05; angle < 6.2; angle += 0.3) {
    const KeplerElements given{9.0e6, 0.1, 0.5, angle, 6.2 - angle, std::fmod(angle + 2.0, 6.2)};
    const auto k = osculating_elements(state_on_ellipse(given));
    ASSERT_TRUE(k.has_value());
    EXPECT_NEAR(k->semi_major_axis_m, given.semi_major_axis_m, 1e-7);
    EXPECT_NEAR(k->eccentricity, given.eccentricity, 1e-14);
    EXPECT_NEAR(k->inclination_rad, given.inclination_rad, 1e-14);
    EXPECT_NEAR(k->ascending_node_rad, given.ascending_node_rad, 1e-14);
    EXPECT_NEAR(k->perigee_rad, given.perigee_rad, 1e-13);
    EXPECT_NEAR(k->mean_anomaly_rad, given.mean_anomaly_rad, 1e-13);
  }
}

TEST(OsculatingElements, AreNothingForAnOpenPathAndForAFall) {
  EXPECT_FALSE(osculating_elements({{7.0e6, 0.0, 0.0}, {0.0, 11.0e3, 0.0}}).has_value());
  EXPECT_FALSE(osculating_elements({{7.0e6, 0.0, 0.0}, {100.0, 0.0, 0.0}}).has_value());
  EXPECT_FALSE(osculating_elements({}).has_value());
}

// 175 turns in 12 days is the orbit of Sentinel-1: 5924.5714 s. Secular J2 alone has 0.6 s less.
TEST(SecularOrbit, HasTheKnownRatesOfSentinel1) {
  const SecularOrbit orbit(sentinel);
  EXPECT_NEAR(orbit.nodal_period_s(), 5923.98, 0.005);
  EXPECT_NEAR(orbit.nodal_period_s(), 12.0 * 86400.0 / 175.0, 0.6);
  EXPECT_NEAR(orbit.rates().ascending_node_rad_per_s * 86400.0 / rad_per_deg, 0.9886, 0.5e-4);
}

TEST(SecularOrbit, CrossesTheEquatorAfterANodalPeriod) {
  KeplerElements elements = sentinel;
  elements.perigee_rad = 0.7;
  elements.mean_anomaly_rad = mean_anomaly_rad(-0.7, elements.eccentricity);
  // A circular one: on an ellipse the time between nodes also depends on where the perigee has turned to.
  elements.eccentricity = 0.0;
  elements.mean_anomaly_rad = -0.7;
  const SecularOrbit orbit(elements);
  EXPECT_NEAR(orbit.at(0.0).position_m.z, 0.0, 1e-6);
  EXPECT_NEAR(orbit.at(orbit.nodal_period_s()).position_m.z, 0.0, 1e-6);
  EXPECT_GT(orbit.at(orbit.nodal_period_s()).velocity_mps.z, 0.0);
}

// By differences of sixth order over 20 s, whose error is 1e-10 of the derivative here.
TEST(SecularOrbit, HasExactDerivatives) {
  for (const double e : {0.0, 0.00114, 0.3}) {
    KeplerElements elements = sentinel;
    elements.eccentricity = e;
    elements.semi_major_axis_m = 7.0e6 / (1.0 - e);
    const SecularOrbit orbit(elements);
    const auto difference = [&](auto&& member, double t) {
      constexpr double h = 10.0;
      const auto pair = [&](double s) { return member(orbit.at(t + s)) - member(orbit.at(t - s)); };
      return (1.0 / (60.0 * h)) * (45.0 * pair(h) - 9.0 * pair(2.0 * h) + pair(3.0 * h));
    };
    for (const double t : {-3000.0, 0.0, 1234.0, 86400.0}) {
      const OrbitMotion motion = orbit.at(t);
      const core::Vec3 v = difference([](const OrbitMotion& m) { return m.position_m; }, t);
      const core::Vec3 a = difference([](const OrbitMotion& m) { return m.velocity_mps; }, t);
      EXPECT_LT(distance(motion.velocity_mps, v), 1e-9 * core::norm(v)) << e << " " << t;
      EXPECT_LT(distance(motion.acceleration_mps2, a), 1e-9 * core::norm(a)) << e << " " << t;
    }
  }
}

TEST(SecularOrbit, IsKeplersWithoutJ2) {
  EarthGravity point;
  point.j2 = 0.0;
  const SecularOrbit orbit(sentinel, point);
  const OrbitMotion motion = orbit.at(1000.0);
  const OrbitState expected = state_on_ellipse(orbit.elements_at(1000.0), point);
  EXPECT_EQ(motion.position_m, expected.position_m);
  EXPECT_EQ(motion.velocity_mps, expected.velocity_mps);
  const double r = core::norm(motion.position_m);
  EXPECT_LT(distance(motion.acceleration_mps2, -point.mu_m3_per_s2 / (r * r * r) * motion.position_m), 1e-14);
}

// The rates as means of osculating rates over a turn on the ellipse, by Gauss' equations for the acceleration of J2.
TEST(J2Rates, AreTheMeansOfGaussEquations) {
  const EarthGravity g;
  for (const double inclination : {0.3, 1.1, 1.7}) {
    const KeplerElements k{8.0e6, 0.05, inclination, 0.4, 0.9, 0.0};
    const double e = k.eccentricity;
    const double p = k.semi_major_axis_m * (1.0 - e * e);
    const double h = std::sqrt(g.mu_m3_per_s2 * p);
    constexpr int steps = 720;
    double node = 0.0, perigee = 0.0;
    for (int j = 0; j < steps; ++j) {
      KeplerElements at = k;
      at.mean_anomaly_rad = 2.0 * pi * j / steps;
      const double f = true_anomaly_rad(at.mean_anomaly_rad, e);
      const double u = k.perigee_rad + f;
      const double r = p / (1.0 + e * std::cos(f));
      const double si = std::sin(inclination), ci = std::cos(inclination);
      const double size = 1.5 * g.j2 * g.mu_m3_per_s2 * g.radius_m * g.radius_m / (r * r * r * r);
      const double radial = -size * (1.0 - 3.0 * si * si * std::sin(u) * std::sin(u));
      const double along = -size * si * si * std::sin(2.0 * u);
      const double normal = -size * 2.0 * si * ci * std::sin(u);
      const double node_rate = r * std::sin(u) / (h * si) * normal;
      node += node_rate / steps;
      perigee += ((-p * std::cos(f) * radial + (p + r) * std::sin(f) * along) / (h * e) - ci * node_rate) / steps;
    }
    const OrbitRates rates = j2_rates(k);
    EXPECT_NEAR(node / rates.ascending_node_rad_per_s, 1.0, 1e-10) << inclination;
    EXPECT_NEAR(perigee / rates.perigee_rad_per_s, 1.0, 1e-10) << inclination;
  }
}

}  // namespace kepler_test
}  // namespace sarsim::radar
