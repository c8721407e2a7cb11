#include <algorithm>
#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/moments.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

constexpr double temperature_k = 290.0;
constexpr double sample_rate_hz = 20e6;
constexpr std::size_t columns = 1000;

// Nothing but noise.
scene::Scene noisy_scene(int pulses) {
  scene::Scene scene = radar_at_origin();
  scene.radars[0].noise_temperature_k = temperature_k;
  set_window(scene, 0.0, static_cast<double>(columns) * 0.5 * core::exact_light_speed_mps / sample_rate_hz,
             sample_rate_hz);
  set_pulses(scene, 0, pulses - 1);
  return scene;
}

struct Parts {
  std::vector<double> in_phase;
  std::vector<double> quadrature;
};

// I and Q in units of their standard deviation.
Parts parts_of(const simulate::Recording& recording, double stddev_v) {
  Parts parts;
  for (const auto& sample : recording.samples) {
    parts.in_phase.push_back(sample.real() / stddev_v);
    parts.quadrature.push_back(sample.imag() / stddev_v);
  }
  return parts;
}

double mean_power(std::span<const double> x, int power) {
  double sum = 0.0;
  for (const double v : x) sum += std::pow(v, power);
  return sum / static_cast<double>(x.size());
}

constexpr const char* five = "five standard deviations";

void add_histogram(Record& record, std::span<const double> x) {
  constexpr double step = 0.25;
  constexpr std::size_t bins = 32;
  std::vector<double> counts(bins, 0.0);
  for (const double v : x) {
    const double bin = (v + 0.5 * step * bins) / step;
    if (bin >= 0.0 && bin < bins) counts[static_cast<std::size_t>(bin)] += 1.0;
  }
  Curve measured{"recorded", {}, {}, true};
  for (std::size_t i = 0; i < bins; ++i) {
    measured.x.push_back((static_cast<double>(i) + 0.5 - 0.5 * bins) * step);
    measured.y.push_back(counts[i] / (static_cast<double>(x.size()) * step));
  }
  Curve normal{"normal", {}, {}, false};
  for (double v = -4.0; v <= 4.0; v += 0.05) {
    normal.x.push_back(v);
    normal.y.push_back(std::exp(-0.5 * v * v) / std::sqrt(2.0 * core::pi));
  }
  record.chart({{}, "Receiver noise, I", "standard deviations", "density", {normal, measured}, false, false});
}

void measure_moments(Record& record, const Parts& parts) {
  const std::size_t n = parts.in_phase.size();
  const auto count = static_cast<double>(n);
  for (const auto& [name, x] : {std::pair{"I", &parts.in_phase}, std::pair{"Q", &parts.quadrature}}) {
    record.near(fmt::format("Noise in {}: mean", name), "sigma", 0.0, mean(*x), mean_gate(1.0, n), five);
    record.near(fmt::format("Noise in {}: variance over kT fs/2", name), "", 1.0, mean_square(*x),
                variance_gate(1.0, n), five);
    record.near(fmt::format("Noise in {}: third moment", name), "sigma^3", 0.0, mean_power(*x, 3),
                gate_sigmas * std::sqrt(15.0 / count), five);
    record.near(fmt::format("Noise in {}: fourth moment", name), "sigma^4", 3.0, mean_power(*x, 4),
                gate_sigmas * std::sqrt(96.0 / count), five);
  }
  record.near("Noise: correlation of I and Q", "", 0.0, correlation_coefficient(parts.in_phase, parts.quadrature),
              correlation_gate(n), five);
  for (const std::size_t lag : {std::size_t{1}, std::size_t{10}, columns})
    record.near(lag == columns ? "Noise: correlation of neighbouring pulses"
                               : fmt::format("Noise: correlation of samples {} apart", lag),
                "", 0.0, mean_product(parts.in_phase, lag), correlation_gate(n - lag), five);
}

void measure_spectrum(Record& record, const simulate::Recording& recording) {
  const core::Fft fft(columns);
  std::vector<double> power(10, 0.0);
  const std::size_t rows = recording.report.rows;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto begin = recording.samples.begin() + static_cast<std::ptrdiff_t>(row * columns);
    std::vector<std::complex<double>> spectrum(begin, begin + static_cast<std::ptrdiff_t>(columns));
    fft.forward(spectrum);
    for (std::size_t k = 0; k < columns; ++k) power[k / 100] += std::norm(spectrum[k]);
  }
  const double bins = static_cast<double>(rows) * 100.0;
  const double expected = core::boltzmann_j_per_k * temperature_k * sample_rate_hz * static_cast<double>(columns);
  double worst = 0.0;
  for (const double p : power) worst = std::max(worst, std::abs(p / bins / expected - 1.0));
  record.at_most("Noise: largest deviation of ten bands from a flat spectrum", "", gate_sigmas / std::sqrt(bins), worst,
                 five);
}

void measure_filtered(Record& record, int pulses) {
  scene::Scene scene = noisy_scene(pulses);
  scene.simulations[0].processing = scene::Processing::matched_filter;
  const simulate::Recording recording = recorded(scene);
  std::vector<double> apart;  // Samples that are a pulse apart are independent.
  for (std::size_t i = 0; i < recording.samples.size(); i += 100) apart.push_back(recording.samples[i].real());
  const double variance = 0.5 * core::boltzmann_j_per_k * temperature_k / scene.radars[0].pulse_width_s;
  record.near("Noise after the matched filter over kT/(2 Tp)", "", 1.0, mean_square(apart) / variance,
              variance_gate(1.0, apart.size()), "signal to noise P Tp/(kT); five standard deviations");
}

void measure_seeds(Record& record, const Parts& first) {
  scene::Scene scene = noisy_scene(static_cast<int>(first.in_phase.size() / columns));
  scene.options.seed = 2;
  const double stddev_v = std::sqrt(0.5 * core::boltzmann_j_per_k * temperature_k * sample_rate_hz);
  const Parts second = parts_of(recorded(scene), stddev_v);
  record.near("Noise: correlation of seeds 1 and 2", "", 0.0, correlation_coefficient(first.in_phase, second.in_phase),
              correlation_gate(first.in_phase.size()), five);
}

// A target that jitters along the line of sight by a little of a wavelength turns the phase of its echo.
void measure_jitter(Record& record, int pulses) {
  scene::Scene scene = radar_at_origin();
  scene::Target& target = add_target(scene, {1000.0, 0.0, 0.0});
  constexpr double stddev_m = 1e-3;
  target.traits.edit().position_stddev_m = {stddev_m, 0.0, 0.0};
  set_window(scene, 1100.0, 1200.0, 4e6);
  set_pulses(scene, 0, pulses - 1);
  const auto samples = column(recorded(scene), 0);
  const double still_rad = -2.0 * core::pi * std::remainder(2000.0 * 1e9 / core::exact_light_speed_mps, 1.0);
  std::vector<double> moved_m;
  for (const auto& sample : samples)
    moved_m.push_back(wrapped_rad(std::arg(sample) - still_rad) * core::exact_light_speed_mps /
                      (-4.0 * core::pi * 1e9) / stddev_m);
  record.near("Jitter of a target: mean", "sigma", 0.0, mean(moved_m), mean_gate(1.0, moved_m.size()), five);
  record.near("Jitter of a target: variance", "sigma^2", 1.0, mean_square(moved_m), variance_gate(1.0, moved_m.size()),
              five);
  record.near("Jitter of a target: correlation from pulse to pulse", "", 0.0, mean_product(moved_m, 1),
              correlation_gate(moved_m.size() - 1), five);
}

// Motion errors of an envelope that is a box: 1 mm, correlated over 4 ms.
void measure_motion_errors(Record& record, int pulses) {
  constexpr double stddev_m = 1e-3;
  constexpr double box_s = 4e-3;
  scene::Scene scene = radar_at_origin();
  scene::Platform& ship = add_platform(scene, "Ship", {1000.0, 0.0, 0.0});
  ship.position_error = scene::Platform::MotionError::envelope;
  const double height = stddev_m / std::sqrt(box_s);
  ship.position_envelope.part[0] = {core::Interpolation::linear, {{0.0, height}, {box_s, height}}};
  add_target(scene, {}, 1.0, "Ship");
  set_window(scene, 1374.0, 1474.0, 4e6);  // The pulse's middle, where its Doppler phase is 0.
  set_pulses(scene, 0, pulses - 1);
  const auto samples = column(recorded(scene), 0);
  const double still_rad = -2.0 * core::pi * std::remainder(2000.0 * 1e9 / core::exact_light_speed_mps, 1.0);
  std::vector<double> moved;
  for (const auto& sample : samples)
    moved.push_back(wrapped_rad(std::arg(sample) - still_rad) * core::exact_light_speed_mps / (-4.0 * core::pi * 1e9) /
                    stddev_m);
  // The squares of a triangular correlation add up to two thirds of its half width.
  const double independent = static_cast<double>(pulses) / 1000.0 / (2.0 / 3.0 * box_s);
  const double gate = gate_sigmas * std::sqrt(2.0 / independent);
  record.near("Motion error: variance", "sigma^2", 1.0, mean_square(moved), gate, "integral of the envelope's square");
  for (const std::size_t lag : {std::size_t{1}, std::size_t{2}, std::size_t{6}})
    record.near(fmt::format("Motion error: correlation after {} ms", lag), "",
                std::max(0.0, 1.0 - 0.25 * static_cast<double>(lag)), mean_product(moved, lag), gate,
                "the box with itself, shifted; five standard deviations");
}

}  // namespace

void measure_statistics(Record& record) {
  const int pulses = record.quick() ? 16 : 128;
  const double stddev_v = std::sqrt(0.5 * core::boltzmann_j_per_k * temperature_k * sample_rate_hz);
  const simulate::Recording recording = recorded(noisy_scene(pulses));
  const Parts parts = parts_of(recording, stddev_v);
  measure_moments(record, parts);
  measure_spectrum(record, recording);
  measure_filtered(record, pulses);
  measure_seeds(record, parts);
  measure_jitter(record, record.quick() ? 500 : 5000);
  measure_motion_errors(record, record.quick() ? 4000 : 40000);
  add_histogram(record, parts.in_phase);
}

}  // namespace sarsim::workflow::verify
