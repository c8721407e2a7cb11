#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "radar/simd/simd_test_support.hpp"

/// Pulses, rows and measures that the tests of the fast kernels share. Samples are 10 ns apart.
namespace sarsim::radar {

using ComplexRow = std::vector<std::complex<double>>;

inline constexpr double test_interval_s = 1e-8;

/// A hard-edged pulse of `samples` sampling intervals; `sweep` in cycles per sample.
inline EchoPulse test_pulse(Pulse::Kind kind, double samples, double sweep = 0.0) {
  EchoPulse pulse;
  pulse.pulse.kind = kind;
  pulse.pulse.width_s = samples * test_interval_s;
  pulse.pulse.sweep_hz = sweep / test_interval_s;
  if (kind == Pulse::Kind::code) pulse.pulse.code = barker_code(6);
  return pulse;
}

inline EchoPulse band_limited_test_pulse(double samples, double sweep) {
  EchoPulse pulse = test_pulse(Pulse::Kind::chirp, samples, sweep);
  pulse.band_limited.emplace(pulse.pulse, 0.5 / test_interval_s, 1.0 / test_interval_s, 0.0);
  return pulse;
}

/// A row of `count` samples from 20 us on.
inline SampleGrid test_grid(std::size_t count) { return {20e-6, test_interval_s, count}; }

/// Random echoes with leading edges up to `before` samples before the row and inside it, up to `speed_mps` fast,
/// with D = 2 v/c and bends up to `dilation_rate`.
inline EchoBatch random_echoes(int echo_count, const SampleGrid& grid, double before, double speed_mps,
                               unsigned seed = 5, double dilation_rate = 0.0) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> position(-before, static_cast<double>(grid.count)), unit(-1.0, 1.0);
  EchoBatch batch;
  for (int k = 0; k < echo_count; ++k) {
    const double delay_s = grid.first_s + position(random) * grid.interval_s;
    const double amplitude = unit(random);
    const double doppler = 2.0 / core::exact_light_speed_mps * speed_mps * unit(random);
    if (dilation_rate == 0.0)
      batch.add(delay_s, amplitude, doppler);
    else
      batch.add(delay_s, amplitude, PulseClock{doppler, dilation_rate * unit(random)});
  }
  return batch;
}

inline ComplexRow reference_row(const EchoPulse& pulse, const SampleGrid& grid, double carrier_hz,
                                const EchoBatch& echoes) {
  ComplexRow row(grid.count);
  add_echoes(row, grid, pulse, carrier_hz, echoes);
  return row;
}

template <class Kernel>
ComplexRow row_of(Kernel& kernel, const SampleGrid& grid, double carrier_hz, const EchoBatch& echoes) {
  ComplexRow row(grid.count);
  kernel.add(row, carrier_hz, echoes);
  return row;
}

inline double largest_difference(const ComplexRow& a, const ComplexRow& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) largest = std::max(largest, std::abs(a.at(i) - b[i]));
  return largest;
}

/// sqrt(sum |a|^2 ||p||^2) of the echoes that touch the row: what a kernel's error is relative to.
inline double strength_of(const EchoPulse& pulse, const SampleGrid& grid, const EchoBatch& echoes) {
  double energy = 0.0;
  for (double t = 0.0; t < pulse.pulse.width_s; t += grid.interval_s) energy += std::norm(pulse.pulse.value(t));
  double power = 0.0;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const SampleSpan on = touched_samples(pulse, grid, echoes.delay_s[k], pulse.clock_of(echoes, k));
    if (on.begin < on.end) power += echoes.amplitude_sqrt_w[k] * echoes.amplitude_sqrt_w[k];
  }
  return std::sqrt(power * energy);
}

/// ||got - expected|| over `strength`.
inline double relative_error(const ComplexRow& got, const ComplexRow& expected, double strength) {
  double error = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) error += std::norm(got.at(i) - expected[i]);
  return std::sqrt(error) / strength;
}

}  // namespace sarsim::radar
