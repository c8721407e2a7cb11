// User-defined motion errors, measured in the phase history of a recording: variance and autocorrelation are those of
// the integration envelope.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/moments.hpp"
#include "support/scenes.hpp"

namespace sarsim {
namespace motion_error_test {

using namespace test;

constexpr double wavelength_m = core::exact_light_speed_mps / 1e9;
constexpr double support_s = 0.2;

// A triangle in lag: 0 at 0, `height` at 0.1 s, 0 at 0.2 s.
core::SampledFunction triangle(double height) {
  return {core::Interpolation::linear, {{0.0, 0.0}, {0.5 * support_s, height}, {support_s, 0.0}}};
}

double triangle_value(double lag_s) {
  if (lag_s <= 0.0 || lag_s >= support_s) return 0.0;
  return lag_s < 0.5 * support_s ? 2.0 * lag_s / support_s : 2.0 - 2.0 * lag_s / support_s;
}

// Integral of h(u) h(u + s) du by the rule of midpoints on 20 000 panels.
double autocorrelation(double lag_s) {
  constexpr int panels = 20000;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    const double u = support_s * (i + 0.5) / panels;
    sum += triangle_value(u) * triangle_value(u + std::abs(lag_s));
  }
  return sum * support_s / panels;
}

// 12 000 pulses at 100 Hz: 600 times the support.
constexpr int pulses = 12000;
constexpr double prf_hz = 100.0;

std::vector<double> phase_history_rad(scene::Scene scene) {
  scene.radars[0].prf_hz = prf_hz;
  set_pulses(scene, 0, pulses - 1);
  set_window(scene, 1374.0, 1374.0 + 0.5 * core::exact_light_speed_mps / 4e6, 4e6);
  std::vector<double> phases;
  for (const auto& echo : recorded(scene).samples)
    phases.push_back(wrapped_rad(std::arg(echo) + 4.0 * core::pi * std::remainder(1000.0 / wavelength_m, 0.5)));
  return phases;
}

// Standard deviation of a sample autocorrelation at lag k of n values with autocorrelation r (Bartlett 1946):
// variance 1/n sum over m of (r(m)^2 + r(m + k) r(m - k)).
double bartlett_sigma(double scale, int lag) {
  const int reach = static_cast<int>(support_s * prf_hz);
  double sum = 0.0;
  for (int m = -2 * reach; m <= 2 * reach; ++m) {
    const auto r = [&](int k) { return scale * autocorrelation(k / prf_hz); };
    sum += r(m) * r(m) + r(m + lag) * r(m - lag);
  }
  return std::sqrt(sum / pulses);
}

void expect_autocorrelation(const std::vector<double>& x, double scale) {
  for (const int lag : {0, 3, 6, 10, 15, 20, 40}) {
    const double expected = scale * autocorrelation(lag / prf_hz);
    const double measured = mean_product(x, static_cast<std::size_t>(lag));
    const double sigma = bartlett_sigma(scale, lag);
    std::printf("lag %.2f s: %.4e, %.4e expected, sigma %.1e\n", lag / prf_hz, measured, expected, sigma);
    EXPECT_NEAR(measured, expected, gate_sigmas * sigma) << lag;
  }
}

TEST(MotionErrors, OfPositionHaveTheAutocorrelationOfTheirEnvelope) {
  scene::Scene scene = radar_at_origin();
  scene::Platform& shaking = add_platform(scene, "Shaking", {1000.0, 0.0, 0.0});
  add_target(scene, {}, 1.0, "Shaking");
  shaking.position_error = scene::Platform::MotionError::envelope;
  const double height = 0.02;  // m/sqrt(s): 5 mm of deviation
  shaking.position_envelope.part = {triangle(height), core::SampledFunction{}, core::SampledFunction{}};
  const double rad_per_m = 4.0 * core::pi / wavelength_m;
  expect_autocorrelation(phase_history_rad(scene), std::pow(height * rad_per_m, 2));
}

TEST(MotionErrors, OfRotationHaveTheAutocorrelationOfTheirEnvelope) {
  scene::Scene scene = radar_at_origin();
  // A point 10 m off the axis, across the line of sight; 1 km away.
  scene::Platform& shaking = add_platform(scene, "Shaking", {std::sqrt(1000.0 * 1000.0 - 100.0), 0.0, 0.0});
  add_target(scene, {0.0, 10.0, 0.0}, 1.0, "Shaking");
  shaking.rotation_error = scene::Platform::MotionError::envelope;
  const double height_deg = 0.1;
  shaking.rotation_envelope.part = {core::SampledFunction{}, core::SampledFunction{}, triangle(height_deg)};
  const double rad_per_deg = 4.0 * core::pi / wavelength_m * 10.0 * core::pi / 180.0 * std::sqrt(1.0 - 1e-4);
  expect_autocorrelation(phase_history_rad(scene), std::pow(height_deg * rad_per_deg, 2));
}

TEST(MotionErrors, OfDifferentAxesAndPlatformsAreNotCorrelated) {
  scene::Scene scene = radar_at_origin();
  scene::Platform& shaking = add_platform(scene, "Shaking", {1000.0, 0.0, 0.0});
  add_target(scene, {}, 1.0, "Shaking");
  shaking.position_error = scene::Platform::MotionError::envelope;
  const auto only = [&](int axis) {
    scene::Platform& p = scene.platforms.back();
    p.position_envelope.part = {};
    p.position_envelope.part[static_cast<std::size_t>(axis)] = triangle(0.02);
    p.position_m = {axis == 0 ? 1000.0 : 0.0, axis == 1 ? 1000.0 : 0.0, axis == 2 ? 1000.0 : 0.0};
    return phase_history_rad(scene);
  };
  const auto x = only(0);
  const auto y = only(1);
  scene.platforms.back().name = "Other";
  scene.targets[0].platform = "Other";
  const auto other = only(0);
  // Two independent histories of autocorrelation r: variance of the coefficient 1/n sum r(m)^2/r(0)^2.
  const double gate = gate_sigmas * bartlett_sigma(1.0, 400) / autocorrelation(0.0);
  EXPECT_NEAR(correlation_coefficient(x, y), 0.0, gate);
  EXPECT_NEAR(correlation_coefficient(x, other), 0.0, gate);
}

TEST(MotionErrors, MoveTheSpeedToo) {
  // The speed is the slope of the deviation: over a short step both agree.
  scene::Scene scene = radar_at_origin();
  scene::Platform& shaking = add_platform(scene, "Shaking", {1000.0, 0.0, 0.0});
  add_target(scene, {}, 1.0, "Shaking");
  shaking.position_error = scene::Platform::MotionError::envelope;
  shaking.position_envelope.part = {triangle(0.02), core::SampledFunction{}, core::SampledFunction{}};
  scene.radars[0].prf_hz = 1e6;
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  simulate::PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  int moving = 0;
  for (std::int64_t pulse = 100; pulse < 100000; pulse += 9973) {
    geometry.set_pulse(pulse);
    const simulate::ScattererView before = geometry.view(0);
    geometry.set_pulse(pulse + 1);
    const double step_m = geometry.view(0).distance_m - before.distance_m;
    // Distances near 1 km are rounded to 1e-13 m; a step takes 1 us.
    EXPECT_NEAR(step_m * 1e6, before.speed_mps, 1e-6);
    moving += std::abs(before.speed_mps) > 1e-3 ? 1 : 0;
  }
  EXPECT_GT(moving, 5);
}

}  // namespace motion_error_test
}  // namespace sarsim
