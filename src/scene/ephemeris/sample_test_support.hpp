#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/maths/constants.hpp"
#include "radar/earth/ellipsoid.hpp"
#include "radar/earth/turning_frame.hpp"
#include "radar/orbit/kepler.hpp"
#include "radar/orbit/state_table.hpp"

/// Motions of satellites and vehicles at random, and samples of them, for tests of what reads samples.
namespace sarsim::scene::sample_test {

/// Positions and velocities at any time.
using SmoothMotion = std::function<radar::OrbitState(double time_s)>;

/// Numbers drawn for tests: the same ones in every run.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) { return low + (high - low) * unit_(engine_); }
  /// Evenly over the logarithm.
  double log(double low, double high) { return std::exp((*this)(std::log(low), std::log(high))); }
  double normal() { return normal_(engine_); }
  core::Vec3 noise(double sigma) { return {sigma * normal(), sigma * normal(), sigma * normal()}; }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> unit_;
  std::normal_distribution<double> normal_;
};

/// An orbit under J2, in axes that turn with the Earth.
inline SmoothMotion orbit(const radar::KeplerElements& elements) {
  const radar::SecularOrbit path(elements);
  return [path](double time_s) -> radar::OrbitState {
    const radar::OrbitMotion motion = path.at(time_s);
    const radar::StateVector turned =
        radar::turning_about_z(radar::earth_rate_rad_per_s * time_s, radar::earth_rate_rad_per_s)
            .to({motion.position_m, motion.velocity_mps});
    return {turned.position_m, turned.velocity_mps};
  };
}

/// The same with directions at random.
inline SmoothMotion orbit(double axis_m, double eccentricity, Draw& draw) {
  radar::KeplerElements elements{axis_m, eccentricity};
  elements.inclination_rad = draw(0.0, core::pi);
  elements.ascending_node_rad = draw(0.0, 6.28);
  elements.perigee_rad = draw(0.0, 6.28);
  elements.mean_anomaly_rad = draw(0.0, 6.28);
  return orbit(elements);
}

/// A circle at constant height.
inline SmoothMotion circle(double radius_m, double period_s, double phase_rad) {
  const double rate = 2.0 * core::pi / period_s;
  return [=](double time_s) -> radar::OrbitState {
    const double c = std::cos(rate * time_s + phase_rad), s = std::sin(rate * time_s + phase_rad);
    return {{radius_m * c, radius_m * s, 500.0}, {-radius_m * rate * s, radius_m * rate * c, 0.0}};
  };
}

/// A straight flight that sways.
inline SmoothMotion swaying(double speed_mps, double sway_m, double period_s) {
  const double rate = 2.0 * core::pi / period_s;
  return [=](double time_s) -> radar::OrbitState {
    return {
        {speed_mps * time_s, sway_m * std::sin(rate * time_s), 0.2 * sway_m * std::cos(0.7 * rate * time_s)},
        {speed_mps, sway_m * rate * std::cos(rate * time_s), -0.14 * sway_m * rate * std::sin(0.7 * rate * time_s)}};
  };
}

/// A motion and the time within which it bends around once.
struct DrawnMotion {
  SmoothMotion motion;
  double turn_s = 0.0;
  bool is_orbit = false;
};

inline DrawnMotion drawn_motion(Draw& draw, int kind) {
  if (kind % 3 == 0) {
    const double eccentricity = kind % 2 == 0 ? draw(0.0, 0.01) : draw(0.0, 0.75);
    const double axis_m = (6378e3 + draw(300e3, 1500e3)) / (1.0 - eccentricity);
    const double turn_s = 2.0 * core::pi * std::sqrt(axis_m * axis_m * axis_m / 3.986e14);
    return {orbit(axis_m, eccentricity, draw), turn_s * std::pow(1.0 - eccentricity, 1.5), true};
  }
  const double turn_s = draw.log(10.0, 600.0);
  if (kind % 3 == 1) return {circle(draw(200.0, 5000.0), turn_s, draw(0.0, 6.28)), turn_s, false};
  return {swaying(draw(20.0, 250.0), draw(0.1, 50.0), turn_s), turn_s, false};
}

inline radar::StateSamples samples_of(const SmoothMotion& motion, double first_s, double step_s, std::size_t count,
                                      bool velocities) {
  radar::StateSamples samples;
  for (std::size_t i = 0; i < count; ++i) {
    const double time_s = first_s + static_cast<double>(i) * step_s;
    const radar::OrbitState state = motion(time_s);
    samples.time_s.push_back(time_s);
    samples.position_m.push_back(state.position_m);
    if (velocities) samples.velocity_mps.push_back(state.velocity_mps);
  }
  return samples;
}

/// Flights in straight pieces, turns of up to 1 g, climbs and accelerations, one after another, with noise.
inline radar::StateSamples flown_samples(Draw& draw, std::size_t count, double step_s, bool velocities, bool regular,
                                         double noise_m) {
  radar::StateSamples samples;
  core::Vec3 position_m{draw(-1e4, 1e4), draw(-1e4, 1e4), 500.0};
  double speed = draw(20.0, 250.0), heading = draw(0.0, 6.28), turn = 0.0, pull = 0.0, climb = 0.0, wanted = 0.0;
  double left_s = 0.0, time_s = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    samples.time_s.push_back(time_s);
    samples.position_m.push_back(position_m + draw.noise(noise_m));
    if (velocities)
      samples.velocity_mps.push_back(core::Vec3{speed * std::sin(heading), speed * std::cos(heading), climb} +
                                     draw.noise(0.1 * noise_m));
    const double length_s = regular ? step_s : step_s * std::exp(draw(-1.0, 1.0));
    constexpr int parts = 20;
    for (int part = 0; part < parts; ++part) {
      const double dt = length_s / parts;
      if (left_s <= 0.0) {
        left_s = draw(1.0, 60.0) * step_s;
        turn = draw(0.0, 1.0) < 0.5 ? 0.0 : std::clamp(draw(-0.05, 0.05) / step_s, -10.0 / speed, 10.0 / speed);
        pull = draw(0.0, 1.0) < 0.7 ? 0.0 : draw(-2.0, 2.0);
        wanted = draw(0.0, 1.0) < 0.7 ? wanted : draw(-5.0, 5.0);
      }
      left_s -= dt;
      speed = std::clamp(speed + pull * dt, 5.0, 300.0);
      climb += std::clamp(wanted - climb, -2.0 * dt, 2.0 * dt);
      const double middle = heading + 0.5 * turn * dt;
      position_m = position_m + dt * core::Vec3{speed * std::sin(middle), speed * std::cos(middle), climb};
      heading += turn * dt;
    }
    time_s += length_s;
  }
  return samples;
}

}  // namespace sarsim::scene::sample_test
