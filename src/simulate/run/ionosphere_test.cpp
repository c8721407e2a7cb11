// Recordings through an ionosphere: the pulse comes by the group path, the carrier by the phase path.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include "radar/path/path.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/plan/simulate_test_scene.hpp"

namespace sarsim::simulate {
namespace ionosphere_test {

constexpr double c = core::exact_light_speed_mps;
constexpr double height_m = 700e3;

using Row = std::vector<std::complex<double>>;

// 40.3 TEC/f^2, times the length of a straight way over the heights it climbs: above a flat world, of all shells.
double group_m(double tec_units, double carrier_hz, double distance_m, double climb_m = height_m) {
  return 40.3e16 * tec_units / (carrier_hz * carrier_hz) * distance_m / climb_m;
}

// A chirp of 20 MHz and 5 us from 700 km above the targets, which are seen up to 200 m farther than the next.
scene::Scene orbit_scene(double carrier_hz, const core::Vec3& velocity_mps) {
  scene::Scene scene;
  scene.platforms.push_back(resting("Earth", {}));
  scene.platforms.push_back(moving("Satellite", {0.0, 0.0, height_m}, velocity_mps));
  for (const double x_m : {0.0, 9e3, 14e3}) scene.targets.push_back(target_on("Earth", {x_m, 100.0, 0.0}, 1e6));
  scene::Radar radar;
  radar.platform = "Satellite";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 20e6;
  radar.pulse_width_s = 5e-6;
  radar.prf_hz = 100.0;
  radar.carrier_hz = carrier_hz;
  scene.radars.push_back(radar);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = height_m - 500.0;
  simulation.range_end_m = height_m + 1500.0;
  simulation.time_end_s = 0.025;
  simulation.sample_rate_hz = 30e6;
  scene.simulations.push_back(simulation);
  return scene;
}

Row recorded(const Plan& plan, unsigned threads = 1) {
  raster::RunControl control;
  control.threads = threads;
  return record(plan, control).samples;
}

// A p(t - tau_group) exp(-j 2 pi f tau_phase), stretched as without an atmosphere.
Row closed_form(const scene::Scene& vacuum, const Plan& plan, double tec_units) {
  const ResolvedScene resolved = resolve(vacuum);
  const Link radar = resolve_radar(vacuum, resolved, 0);
  PulseGeometry geometry(resolved, radar);
  const double width_s = vacuum.radars[0].pulse_width_s;
  Row all;
  for (std::size_t r = 0; r < plan.acquisition.timing.rows; ++r) {
    geometry.set_pulse(plan.acquisition.timing.first_pulse_of_row(r));
    const double carrier_hz = geometry.carrier_hz();
    Row row(plan.acquisition.reception.columns);
    for (std::size_t t = 0; t < vacuum.targets.size(); ++t) {
      const ScattererView view = geometry.view(t);
      const double excess_s = 2.0 * group_m(tec_units, carrier_hz, view.distance_m) / c;
      for (std::size_t i = 0; i < row.size(); ++i) {
        const double u = plan.acquisition.reception.raw_grid.time_s(i) - (view.delay_s + excess_s) +
                         plan.acquisition.reception.pulse.lead_s - 0.5 * width_s;
        const double late = view.clock.late(u);
        const double e = u - late;
        if (e < -0.5 * width_s || e >= 0.5 * width_s) continue;
        const double turns = 0.5 * vacuum.radars[0].bandwidth_hz / width_s * e * e -
                             std::remainder(carrier_hz * (view.delay_s - excess_s), 1.0) - carrier_hz * late;
        row[i] += std::polar(view.amplitude_sqrt_w, 2.0 * core::pi * turns);
      }
    }
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

double largest_difference(const Row& a, const Row& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) largest = std::max(largest, std::abs(a.at(i) - b[i]));
  return largest;
}

class IonosphereRows : public testing::TestWithParam<Engine> {};

INSTANTIATE_TEST_SUITE_P(Engines, IonosphereRows, testing::Values(Engine::reference, Engine::direct, Engine::spectral));

TEST_P(IonosphereRows, AreTheClosedForm) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const core::Vec3& velocity_mps : {core::Vec3{}, core::Vec3{70.0, 200.0, 0.0}})
    for (int draw = 0; draw < 10; ++draw) {
      const double carrier_hz = 0.4e9 * std::pow(25.0, share(random));
      const double tec_units = std::pow(100.0, share(random));
      scene::Scene scene = orbit_scene(carrier_hz, velocity_mps);
      scene.options.tolerance = 1e-9;
      const scene::Scene vacuum = scene;
      scene.atmosphere.tec_units = tec_units;
      const Plan plan = make_plan(scene, 0, nullptr, GetParam());
      const Row expected = closed_form(vacuum, plan, tec_units);
      double largest = 0.0;
      for (const std::complex<double>& sample : expected) largest = std::max(largest, std::abs(sample));
      ASSERT_GT(largest, 0.0);
      EXPECT_LT(largest_difference(recorded(plan), expected), 1e-6 * largest) << carrier_hz << " " << tec_units;
    }
}

// Each pulse by its own carrier.
TEST_P(IonosphereRows, OfSteppedCarriersAreTheClosedForm) {
  scene::Scene scene = orbit_scene(0.4e9, {});
  scene.options.tolerance = 1e-9;
  scene.radars[0].carrier = scene::Radar::Carrier::stepped;
  scene.radars[0].carrier_step_hz = 0.3e9;
  scene.radars[0].carrier_steps = 8;
  scene.radars[0].pulses_per_step = 1;
  scene.simulations[0].time_end_s = 0.075;
  const scene::Scene vacuum = scene;
  scene.atmosphere.tec_units = 20.0;
  const Plan plan = make_plan(scene, 0, nullptr, GetParam());
  ASSERT_EQ(plan.acquisition.timing.rows, 8U);
  const Row expected = closed_form(vacuum, plan, 20.0);
  double largest = 0.0;
  for (const std::complex<double>& sample : expected) largest = std::max(largest, std::abs(sample));
  EXPECT_LT(largest_difference(recorded(plan), expected), 1e-6 * largest);
}

// Circles about the target at a distance of 700 km while the way through the shell becomes longer.
scene::Scene circling_scene() {
  scene::Scene scene = orbit_scene(1.257e9, {});
  scene.targets = {target_on("Earth", {}, 1e6)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<core::Knot> knots;
    for (int i = 0; i <= 80; ++i) {
      const double angle = 0.2 + 0.005 * i;
      knots.push_back({0.5 * i, axis == 0 ? height_m * std::sin(angle) : axis == 2 ? height_m * std::cos(angle) : 0.0});
    }
    scene.platforms[1].trajectory_m.part[axis] = {core::Interpolation::cubic, knots};
  }
  scene.options.cubic_ends = core::CubicEnds::not_a_knot;
  scene.options.pulse = scene::PulseDefinition::band_limited;
  scene.options.tolerance = 1e-9;
  scene.radars[0].prf_hz = 10.0;
  scene.radars[0].bandwidth_hz = 80e6;
  scene.simulations[0].processing = scene::Processing::matched_filter;
  scene.simulations[0].sample_rate_hz = 320e6;
  scene.simulations[0].range_start_m = height_m - 100.0;
  scene.simulations[0].range_end_m = height_m + 100.0;
  scene.simulations[0].time_start_s = 1.0;
  scene.simulations[0].time_end_s = 39.0;
  scene.atmosphere.tec_units = 50.0;
  return scene;
}

struct Peak {
  double column = 0.0;
  double phase_rad = 0.0;
};

// The largest magnitude between the samples, by a sinc of 48 samples under a Hann window.
Peak peak_of(const std::complex<double>* row, std::size_t columns) {
  const auto* strongest =
      std::max_element(row, row + columns, [](const auto& a, const auto& b) { return std::norm(a) < std::norm(b); });
  const double middle = static_cast<double>(strongest - row);
  constexpr double reach = 24.0;
  const auto value = [&](double x) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < columns; ++i) {
      const double d = x - static_cast<double>(i);
      if (std::abs(d) >= reach) continue;
      const double sinc = d == 0.0 ? 1.0 : std::sin(core::pi * d) / (core::pi * d);
      sum += row[i] * (sinc * (0.5 + 0.5 * std::cos(core::pi * d / reach)));
    }
    return sum;
  };
  double low = middle - 1.0, high = middle + 1.0;
  for (int i = 0; i < 80; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    const bool right = std::abs(value(a)) < std::abs(value(b));
    (right ? low : high) = right ? a : b;
  }
  return {0.5 * (low + high), std::arg(value(0.5 * (low + high)))};
}

// Half a wavelength is 0.119 m, by which the place jumped.
TEST(IonosphereFlight, MovesThePeakSmoothlyAndTurnsThePhaseAsMuch) {
  const scene::Scene scene = circling_scene();
  const Plan plan = make_plan(scene, 0);
  const Row samples = recorded(plan);
  const double step_m = plan.acquisition.reception.column_range_m[1] - plan.acquisition.reception.column_range_m[0];
  std::vector<double> excess_m, expected_m, phase_rad;
  for (std::size_t r = 0; r < plan.acquisition.timing.rows; ++r) {
    const std::complex<double>* row = samples.data() + r * plan.acquisition.reception.columns;
    const double angle =
        0.2 + 0.01 * plan.acquisition.link.repetition.send_time_s(plan.acquisition.timing.first_pulse_of_row(r));
    expected_m.push_back(group_m(50.0, 1.257e9, 1.0, std::cos(angle)));
    const Peak peak = peak_of(row, plan.acquisition.reception.columns);
    excess_m.push_back(plan.acquisition.reception.column_range_m[0] + peak.column * step_m - height_m);
    phase_rad.push_back(peak.phase_rad - 4.0 * core::pi * 1.257e9 / c * expected_m.back());
  }
  ASSERT_GT(plan.acquisition.timing.rows, 300U);
  ASSERT_GT(expected_m.back() - expected_m.front(), 15.0 * 0.119);
  for (std::size_t r = 1; r + 1 < plan.acquisition.timing.rows; ++r) {
    EXPECT_LT(std::abs(excess_m[r + 1] - 2.0 * excess_m[r] + excess_m[r - 1]), 1e-3) << r;
    EXPECT_NEAR(excess_m[r] - expected_m[r], excess_m[0] - expected_m[0], 3e-3) << r;
    EXPECT_NEAR(std::remainder(phase_rad[r] - phase_rad[0], 2.0 * core::pi), 0.0, 0.01) << r;
  }
}

TEST(IonosphereFlight, DoesNotDependOnThreads) {
  for (const bool raw : {false, true}) {
    scene::Scene scene = circling_scene();
    scene.options.tolerance = 1e-6;
    if (raw) scene.simulations[0].processing = scene::Processing::raw;
    const Plan plan = make_plan(scene, 0);
    const Row one = recorded(plan);
    for (const unsigned threads : {2U, 5U}) EXPECT_EQ(recorded(plan, threads), one);
  }
}

}  // namespace ionosphere_test
}  // namespace sarsim::simulate
