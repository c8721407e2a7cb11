#include "radar/motion/ins_errors.hpp"

#include <cmath>

#include "core/report/expect.hpp"
#include "radar/motion/level_turn.hpp"

namespace sarsim::radar {

namespace {

core::Jet accelerometer_polynomial(double bias, double t) { return {0.5 * bias * t * t, bias * t, bias}; }

core::Jet gyro_polynomial(double tilt_rate, double t) {
  const double jerk = standard_gravity_mps2 * tilt_rate;
  return {jerk * t * t * t / 6.0, 0.5 * jerk * t * t, jerk * t};
}

core::Jet accelerometer_swing(double bias, double w, double t) {
  const double half_sine = std::sin(0.5 * w * t);
  return {2.0 * bias / (w * w) * half_sine * half_sine, bias / w * std::sin(w * t), bias * std::cos(w * t)};
}

// x - sin x, without the loss of digits near 0: three terms of the series are exact to 1e-16 below 0.01.
double minus_sine(double x) {
  if (std::abs(x) > 0.01) return x - std::sin(x);
  const double xx = x * x;
  return x * xx / 6.0 * (1.0 - xx / 20.0 * (1.0 - xx / 42.0));
}

core::Jet gyro_swing(double tilt_rate, double w, double t) {
  const double jerk = standard_gravity_mps2 * tilt_rate;
  const double half_sine = std::sin(0.5 * w * t);
  return {jerk / (w * w * w) * minus_sine(w * t), 2.0 * jerk / (w * w) * half_sine * half_sine,
          jerk / w * std::sin(w * t)};
}

}  // namespace

double schuler_frequency_rad_per_s() { return std::sqrt(standard_gravity_mps2 / schuler_radius_m); }

core::Interpolator gauss_markov_function(double sigma, double correlation_time_s) {
  CORE_EXPECT(correlation_time_s > 0.0);
  constexpr int steps = 256;
  constexpr double last = 8.0;
  core::SampledFunction function{core::Interpolation::cubic, {}};
  for (int i = 0; i <= steps; ++i) {
    const double x = last * i / steps;
    function.knots.push_back({x * correlation_time_s, sigma * std::sqrt(2.0 / correlation_time_s) * std::exp(-x)});
  }
  return core::Interpolator(function, {core::LowPassRule::first_knot, core::CubicEnds::not_a_knot});
}

core::Interpolator smooth_wander_function(double sigma, double correlation_time_s) {
  CORE_EXPECT(correlation_time_s > 0.0);
  constexpr int steps = 256;
  constexpr double last = 12.0;
  const double scale_s = 0.5 * correlation_time_s;
  core::SampledFunction function{core::Interpolation::cubic, {}};
  for (int i = 0; i <= steps; ++i) {
    const double x = last * i / steps;
    function.knots.push_back({x * scale_s, 2.0 * sigma / std::sqrt(scale_s) * x * std::exp(-x)});
  }
  return core::Interpolator(function, {core::LowPassRule::first_knot, core::CubicEnds::not_a_knot});
}

core::Interpolator random_walk_function(double density, double duration_s) {
  CORE_EXPECT(duration_s > 0.0);
  const double height = density / std::sqrt(2.0);
  return core::Interpolator({core::Interpolation::linear, {{0.0, height}, {duration_s, height}}});
}

core::Jet position_error(const InsBias& bias, InsModel model, double time_s) {
  const double t = time_s - bias.aligned_s;
  if (t <= 0.0) return {};
  const double w = schuler_frequency_rad_per_s();
  const bool swings = model == InsModel::schuler;
  const core::Jet a = swings ? accelerometer_swing(bias.accelerometer_mps2, w, t)
                             : accelerometer_polynomial(bias.accelerometer_mps2, t);
  const core::Jet g = swings ? gyro_swing(bias.gyro_rad_per_s, w, t) : gyro_polynomial(bias.gyro_rad_per_s, t);
  return {a.value + g.value, a.slope + g.slope, a.curvature + g.curvature};
}

double angle_walk_rad(double density_rad_per_root_s, double elapsed_s) {
  return density_rad_per_root_s * std::sqrt(elapsed_s);
}

double tilt_walk_position_m(double density_rad_per_root_s, double elapsed_s) {
  return standard_gravity_mps2 * density_rad_per_root_s * std::sqrt(std::pow(elapsed_s, 5) / 20.0);
}

double velocity_walk_position_m(double density_mps_per_root_s, double elapsed_s) {
  return density_mps_per_root_s * std::sqrt(elapsed_s * elapsed_s * elapsed_s / 3.0);
}

double paired_echo_db(double amplitude_m, double wavelength_m) {
  return 20.0 * std::log10(2.0 * core::pi * amplitude_m / wavelength_m);
}

}  // namespace sarsim::radar
