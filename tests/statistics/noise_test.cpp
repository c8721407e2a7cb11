// Thermal noise in recordings.

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/fft.hpp"
#include "support/moments.hpp"
#include "support/scenes.hpp"

namespace sarsim {
namespace noise_test {

using namespace test;

constexpr double temperature_k = 290.0;
constexpr std::size_t pulses = 64;
constexpr std::size_t columns = 1000;

// Nothing but noise: 64 pulses of 1000 samples.
scene::Scene noisy_scene(scene::Profile profile) {
  scene::Scene scene = radar_at_origin(profile);
  scene.radars[0].noise_temperature_k = temperature_k;
  const double spacing_m = 0.5 * core::exact_light_speed_mps / 20e6;
  set_window(scene, 0.0, static_cast<double>(columns) * spacing_m, 20e6);
  set_pulses(scene, -10, static_cast<int>(pulses) - 11);
  return scene;
}

struct Parts {
  std::vector<double> in_phase;
  std::vector<double> quadrature;
};

Parts parts_of(const simulate::Recording& recording) {
  Parts parts;
  for (const auto& sample : recording.samples) {
    parts.in_phase.push_back(sample.real());
    parts.quadrature.push_back(sample.imag());
  }
  return parts;
}

void expect_variance(const Parts& parts, double variance) {
  for (const auto* part : {&parts.in_phase, &parts.quadrature}) {
    EXPECT_NEAR(mean(*part), 0.0, mean_gate(std::sqrt(variance), part->size()));
    EXPECT_NEAR(mean_square(*part), variance, variance_gate(variance, part->size()));
  }
}

TEST(Noise, HasThePowerKTFsHalfInIAndHalfInQ) {
  const simulate::Recording recording = recorded(noisy_scene(scene::Profile::physical));
  ASSERT_EQ(recording.samples.size(), pulses * columns);
  expect_variance(parts_of(recording), 0.5 * core::boltzmann_j_per_k * temperature_k * 20e6);
}

TEST(Noise, OfTheClassicProfileHasKTBInIAndInQ) {
  scene::Scene scene = noisy_scene(scene::Profile::classic);
  expect_variance(parts_of(recorded(scene)), core::classic_boltzmann_j_per_k * temperature_k / 5e-6);
  scene.radars[0].pulse = scene::Radar::Pulse::chirp;
  scene.radars[0].bandwidth_hz = 50e6;
  expect_variance(parts_of(recorded(scene)), core::classic_boltzmann_j_per_k * temperature_k * 50e6);
}

TEST(Noise, IsNormal) {
  // Third and fourth moment of n normal values: 0 +- sqrt(15/n), 3 +- sqrt(96/n) in units of sigma.
  const Parts parts = parts_of(recorded(noisy_scene(scene::Profile::physical)));
  const double sigma_v = std::sqrt(0.5 * core::boltzmann_j_per_k * temperature_k * 20e6);
  const auto n = static_cast<double>(parts.in_phase.size());
  double third = 0.0;
  double fourth = 0.0;
  for (const double v : parts.in_phase) {
    third += std::pow(v / sigma_v, 3) / n;
    fourth += std::pow(v / sigma_v, 4) / n;
  }
  EXPECT_NEAR(third, 0.0, gate_sigmas * std::sqrt(15.0 / n));
  EXPECT_NEAR(fourth, 3.0, gate_sigmas * std::sqrt(96.0 / n));
}

TEST(Noise, IsWhite) {
  const Parts parts = parts_of(recorded(noisy_scene(scene::Profile::physical)));
  EXPECT_NEAR(correlation_coefficient(parts.in_phase, parts.quadrature), 0.0, correlation_gate(parts.in_phase.size()));
  const double variance = mean_square(parts.in_phase);
  for (const std::size_t lag : {1U, 2U, 3U, 10U, 100U, 999U})
    EXPECT_NEAR(mean_product(parts.in_phase, lag) / variance, 0.0, correlation_gate(parts.in_phase.size() - lag))
        << lag;
}

TEST(Noise, HasAFlatSpectrum) {
  // Mean power of 64 pulses in 10 bands of 100 bins: chi-square with 12 800 degrees of freedom each.
  const simulate::Recording recording = recorded(noisy_scene(scene::Profile::physical));
  const core::Fft fft(columns);
  std::vector<double> band(10, 0.0);
  for (std::size_t row = 0; row < pulses; ++row) {
    std::vector<std::complex<double>> spectrum(
        recording.samples.begin() + static_cast<std::ptrdiff_t>(row * columns),
        recording.samples.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns));
    fft.forward(spectrum);
    for (std::size_t k = 0; k < columns; ++k) band[k / 100] += std::norm(spectrum[k]);
  }
  const double samples = static_cast<double>(pulses) * 100.0;
  const double expected = core::boltzmann_j_per_k * temperature_k * 20e6 * static_cast<double>(columns);
  for (const double power : band) EXPECT_NEAR(power / samples / expected, 1.0, gate_sigmas / std::sqrt(samples));
}

TEST(Noise, OfDifferentPulsesIsNotCorrelated) {
  const simulate::Recording recording = recorded(noisy_scene(scene::Profile::physical));
  const Parts parts = parts_of(recording);
  const std::span<const double> all(parts.in_phase);
  const double gate = correlation_gate(columns);
  for (std::size_t a = 0; a < 12; ++a)
    for (std::size_t b = a + 1; b < 12; ++b)
      EXPECT_NEAR(correlation_coefficient(all.subspan(a * columns, columns), all.subspan(b * columns, columns)), 0.0,
                  gate)
          << a << ' ' << b;
}

TEST(Noise, OfTwoRadarsIsNotCorrelated) {
  scene::Scene scene = noisy_scene(scene::Profile::physical);
  const Parts first = parts_of(recorded(scene));
  scene.radars[0].name = "Radar2";
  scene.simulations[0].radar = "Radar2";
  const Parts second = parts_of(recorded(scene));
  EXPECT_NEAR(correlation_coefficient(first.in_phase, second.in_phase), 0.0, correlation_gate(first.in_phase.size()));
  EXPECT_NEAR(correlation_coefficient(first.in_phase, second.quadrature), 0.0, correlation_gate(first.in_phase.size()));
}

TEST(Noise, AfterTheMatchedFilterIsDownByTheCompressionGain) {
  // Signal to noise P Tp/(kT): the filter of N = Tp fs equal taps of 1/N leaves kT fs/N.
  scene::Scene scene = noisy_scene(scene::Profile::physical);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  const simulate::Recording recording = recorded(scene);
  std::vector<double> apart;  // samples further apart than the pulse are independent
  for (std::size_t row = 0; row < recording.report.rows; ++row)
    for (std::size_t i = 0; i < recording.report.columns; i += 100)
      apart.push_back(recording.samples[row * recording.report.columns + i].real());
  const double variance = 0.5 * core::boltzmann_j_per_k * temperature_k / 5e-6;
  EXPECT_NEAR(mean_square(apart), variance, variance_gate(variance, apart.size()));
}

TEST(Noise, IsMultipliedByTheStcGainOfItsRange) {
  scene::Scene scene = noisy_scene(scene::Profile::physical);
  scene.radars[0].stc = scene::Radar::Stc::range_law;
  const simulate::Recording with = recorded(scene);
  scene.radars[0].stc = scene::Radar::Stc::none;
  const simulate::Recording without = recorded(scene);
  const double spacing_m = 0.5 * core::exact_light_speed_mps / 20e6;
  for (const std::size_t i : {1U, 500U, 999U}) {
    const double range_m = static_cast<double>(i) * spacing_m;
    EXPECT_LT(std::abs(with.samples[i] - range_m * range_m * without.samples[i]), 1e-12 * std::abs(with.samples[i]));
  }
}

}  // namespace noise_test
}  // namespace sarsim
