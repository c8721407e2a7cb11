// Range history, delay and Doppler of recorded echoes.

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenes.hpp"

namespace sarsim {
namespace geometry_test {

using test::recorded;

constexpr double light_speed_mps = core::exact_light_speed_mps;

// Radar at rest, a 1 m^2 target that moves along a straight line; long monochrome pulses, a few samples of each.
scene::Scene moving_target(const core::Vec3& start_m, const core::Vec3& velocity_mps, double carrier_hz) {
  scene::Scene scene = test::radar_at_origin();
  scene.radars[0].carrier_hz = carrier_hz;
  scene.radars[0].pulse_width_s = 10e-6;
  test::add_mover(scene, "Mover", start_m, velocity_mps);
  test::add_target(scene, {}, 1.0, "Mover");
  return scene;
}

// Phase of (6.22) at two-way time t in long double: -2 pi f tau - 2 pi (2v/c) f u, tau = 2 R/(c - v), as a fraction of
// a cycle.
double expected_phase_rad(long double range_m, long double speed_mps, long double time_s, long double carrier_hz,
                          long double width_s) {
  const long double c = light_speed_mps;
  const long double delay_s = 2.0L * range_m / (c - speed_mps);
  const long double u = time_s - delay_s - 0.5L * width_s;
  const long double cycles = -carrier_hz * delay_s - 2.0L * speed_mps / c * carrier_hz * u;
  return static_cast<double>(2.0L * static_cast<long double>(core::pi) * (cycles - std::round(cycles)));
}

TEST(RangeHistory, OfAStraightPassIsTheHyperbolaInPhaseToAMillionthOfARadian) {
  // C band at 10 km, 200 m/s, 2 s: approaching for half of the pulses, receding for the other half.
  const double carrier_hz = 5.3e9;
  const double closest_m = 10198.0;
  const double along_mps = 200.0;
  scene::Scene scene = moving_target({closest_m, 0.0, 0.0}, {0.0, along_mps, 0.0}, carrier_hz);
  test::set_pulses(scene, -1000, 1000);
  test::set_window(scene, 10400.0, 10550.0, 1e6);
  const simulate::Recording recording = recorded(scene);
  ASSERT_EQ(recording.report.rows, 2001u);
  ASSERT_EQ(recording.report.columns, 1u);
  double worst_rad = 0.0;
  for (std::size_t row = 0; row < recording.report.rows; ++row) {
    const long double t = (static_cast<double>(row) - 1000.0) / scene.radars[0].prf_hz;
    const long double range_m = std::hypot(static_cast<long double>(closest_m), along_mps * t);
    const long double speed_mps = along_mps * along_mps * t / range_m;
    const double expected =
        expected_phase_rad(range_m, speed_mps, 2.0L * 10400.0L / light_speed_mps, carrier_hz, 10e-6L);
    worst_rad = std::max(worst_rad, std::abs(test::wrapped_rad(std::arg(recording.samples[row]) - expected)));
  }
  EXPECT_LT(worst_rad, 1e-6);
}

TEST(Delay, SolvesTheLightTimeEquationForEitherDirectionOfMotion) {
  for (const double speed_mps : {-3000.0, -50.0, 50.0, 3000.0}) {
    scene::Scene scene = moving_target({1000.0, 0.0, 0.0}, {speed_mps, 0.0, 0.0}, 1e9);
    const simulate::Plan plan = simulate::make_plan(scene, 0);
    simulate::PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
    geometry.set_pulse(0);
    // The pulse reaches the target where it is then: out = (1000 + v out)/c, and comes back from there.
    double out_s = 0.0;
    for (int i = 0; i < 20; ++i) out_s = (1000.0 + speed_mps * out_s) / light_speed_mps;
    EXPECT_NEAR(geometry.view(0).delay_s, 2.0 * out_s, 1e-20) << speed_mps;
  }
}

TEST(Delay, IsNeverRoundedToASample) {
  // A compressed chirp turns by 4 pi dR/lambda and keeps its shape while the target moves through a sample in steps.
  const double rate_hz = 120e6;
  const double cell_m = light_speed_mps / (2.0 * rate_hz);
  for (int step = 0; step <= 8; ++step) {
    scene::Scene scene = test::radar_at_origin();
    scene.radars[0].pulse = scene::Radar::Pulse::chirp;
    scene.radars[0].pulse_width_s = 1e-6;
    const double range_m = 800.0 * cell_m + step * cell_m / 8.0;
    test::add_target(scene, {range_m, 0.0, 0.0});
    test::set_window(scene, 800.0 * cell_m, 1000.0 * cell_m, rate_hz);
    const simulate::Recording recording = recorded(scene);
    const double amplitude = std::abs(recording.samples[10]);
    for (std::size_t i = 2; i < 119; ++i) {
      const double t = static_cast<double>(i) / rate_hz - 2.0 * step * cell_m / 8.0 / light_speed_mps;
      const double u = t - 0.5e-6;
      const std::complex<double> expected = std::polar(
          amplitude, core::pi * 50e12 * u * u - 4.0 * core::pi * std::remainder(range_m * 1e9 / light_speed_mps, 0.5));
      EXPECT_LT(std::abs(recording.samples[i] - expected), 1e-9 * amplitude) << step << ' ' << i;
    }
  }
}

TEST(Delay, DecidesWhichSamplesOfAHardEdgedPulseAreOn) {
  // A pulse of 120 sampling intervals is on in 120 samples, from the first at or after its delay.
  const double cell_m = light_speed_mps / (2.0 * 120e6);
  for (int eighths = 0; eighths <= 8; ++eighths) {
    scene::Scene scene = test::radar_at_origin();
    scene.radars[0].pulse_width_s = 1e-6;
    test::add_target(scene, {810.0 * cell_m + eighths * cell_m / 8.0, 0.0, 0.0});
    test::set_window(scene, 800.0 * cell_m, 1000.0 * cell_m, 120e6);
    const simulate::Recording recording = recorded(scene);
    const std::size_t first = eighths == 0 ? 10 : 11;
    for (std::size_t i = 0; i < recording.samples.size(); ++i)
      EXPECT_EQ(recording.samples[i] != std::complex<double>(), i >= first && i < first + 120) << eighths << ' ' << i;
  }
}

// Mean turn between neighbouring samples.
double turn_per_sample_rad(const std::vector<std::complex<double>>& samples) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) sum += samples[i] * std::conj(samples[i - 1]);
  return std::arg(sum);
}

TEST(Doppler, OfApproachingAndRecedingTargetsIsEqualAndOpposite) {
  const double carrier_hz = 1e9;
  const double speed_mps = 30.0;
  double turn_rad[2];
  for (const int sign : {-1, 1}) {
    scene::Scene scene = moving_target({1000.0, 0.0, 0.0}, {sign * speed_mps, 0.0, 0.0}, carrier_hz);
    test::set_pulses(scene, 0, 200);
    test::set_window(scene, 1300.0, 1450.0, 1e6);
    turn_rad[(sign + 1) / 2] = turn_per_sample_rad(test::column(recorded(scene), 0));
  }
  // Per pulse -2 pi f (2v/c) PRI; the sum of the two is the second order in v/c.
  const double expected_rad = 2.0 * core::pi * carrier_hz * 2.0 * speed_mps / light_speed_mps / 1000.0;
  EXPECT_NEAR(turn_rad[0], expected_rad, 1e-6 * expected_rad);
  EXPECT_NEAR(turn_rad[1], -expected_rad, 1e-6 * expected_rad);
}

TEST(Doppler, WithinAPulseIsTheSameShift) {
  const double carrier_hz = 10e9;
  const double speed_mps = 3000.0;
  for (const int sign : {-1, 1}) {
    scene::Scene scene = moving_target({1000.0, 0.0, 0.0}, {sign * speed_mps, 0.0, 0.0}, carrier_hz);
    test::set_window(scene, 1010.0, 2400.0, 100e6);
    const double shift_hz = turn_per_sample_rad(recorded(scene).samples) * 100e6 / (2.0 * core::pi);
    // A ten millionth of the shift of 200 kHz over 9.3 us is a phase of 1e-6 rad.
    const double expected_hz = -sign * 2.0 * speed_mps / (light_speed_mps + sign * speed_mps) * carrier_hz;
    EXPECT_NEAR(shift_hz, expected_hz, 1e-7 * std::abs(expected_hz));
  }
}

TEST(Doppler, StretchesTheSweepOfAChirp) {
  // K e^2/2 - f tau - f D u, e = (1 - D) u, D = 2v/(c + v); at 3 km/s the sweep loses 0.0125 cycles twice.
  const double width_s = 100e-6;
  const double rate_hz_per_s = 50e6 / width_s;
  for (const double speed_mps : {-3000.0, 3000.0}) {
    scene::Scene scene = moving_target({1000.0, 0.0, 0.0}, {speed_mps, 0.0, 0.0}, 1e9);
    scene.radars[0].pulse = scene::Radar::Pulse::chirp;
    scene.radars[0].bandwidth_hz = 50e6;
    scene.radars[0].pulse_width_s = width_s;
    test::set_window(scene, 1100.0, 15000.0, 1e6);
    const auto samples = recorded(scene).samples;
    const double delay_s = 2000.0 / (light_speed_mps - speed_mps);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double u = 2200.0 / light_speed_mps + static_cast<double>(i) * 1e-6 - delay_s - 0.5 * width_s;
      const double modulation = 0.5 * rate_hz_per_s * u * u;
      const double stretch = 2.0 * speed_mps / (light_speed_mps + speed_mps);
      const double cycles = (1.0 - stretch) * (1.0 - stretch) * modulation - 1e9 * delay_s - stretch * 1e9 * u;
      // 7000 cycles in doubles: 1e-12 cycles each.
      EXPECT_NEAR(test::wrapped_rad(std::arg(samples[i]) - 2.0 * core::pi * cycles), 0.0, 1e-10)
          << speed_mps << ' ' << i;
    }
  }
}

TEST(Doppler, OfASquintedLookIsTwoVSinOverLambda) {
  // The radar moves, the target rests: d|r|/dt = -V sin(squint) at the moment the target is ahead by the squint angle.
  const double squint_rad = 10.0 * core::pi / 180.0;
  scene::Scene scene = test::radar_at_origin();
  test::add_mover(scene, "Craft", {}, {0.0, 150.0, 0.0});
  scene.radars[0].platform = "Craft";
  test::add_target(scene, {5000.0 * std::cos(squint_rad), 5000.0 * std::sin(squint_rad), 0.0});
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  simulate::PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  geometry.set_pulse(0);
  // The radar flies on until the echo is back: V^2 cos^2/c more, 2 f V^2/c^2 of Doppler shift abeam.
  const double flown_mps = std::pow(150.0 * std::cos(squint_rad), 2) / light_speed_mps;
  EXPECT_NEAR(geometry.view(0).speed_mps, -150.0 * std::sin(squint_rad) + flown_mps, 1e-10);
}

TEST(Speed, OfATurningPlatformsPointIsTheArmTimesTheRate) {
  // A point 20 m from the axis turns at 36 deg/s; seen edge on it moves along the line of sight.
  scene::Scene scene = test::radar_at_origin();
  scene::Platform& turning = test::add_platform(scene, "Turning", {1000.0, 0.0, 0.0});
  turning.rotation_rate[2] = core::Angle::from_deg(36.0);
  test::add_target(scene, {0.0, 20.0, 0.0}, 1.0, "Turning");
  const simulate::Plan plan = simulate::make_plan(scene, 0);
  simulate::PulseGeometry geometry(*plan.acquisition.scene, plan.acquisition.link);
  geometry.set_pulse(0);
  // Positive rotation about z turns +y towards +x: away from the radar. The line of sight is 20 m off over 1 km.
  const double arm_rate_mps = 20.0 * 36.0 * core::pi / 180.0;
  // The pulse meets the point 3.3 us later: turned by 2.1e-6 rad, which takes 20 m/1 km of that from the speed.
  const double met_rad = 36.0 * core::pi / 180.0 * std::hypot(1000.0, 20.0) / light_speed_mps;
  const core::Vec3 met_m{1000.0 + 20.0 * std::sin(met_rad), 20.0 * std::cos(met_rad), 0.0};
  const core::Vec3 velocity_mps{arm_rate_mps * std::cos(met_rad), -arm_rate_mps * std::sin(met_rad), 0.0};
  EXPECT_NEAR(geometry.view(0).speed_mps, core::dot(met_m, velocity_mps) / core::norm(met_m), 1e-10);
}

}  // namespace geometry_test
}  // namespace sarsim
