#include "radar/motion/ship.hpp"

#include <array>
#include <cmath>

#include "radar/motion/level_turn.hpp"

namespace sarsim::radar {

namespace {

// Mean of cos over -x to x: sin(x)/x.
double mean_of_wave(double x) { return std::abs(x) < 1e-3 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

// Slope at 0 of the line that fits sin best (least squares) over -x to x: 3 (sin x - x cos x)/x^3.
double slope_of_wave(double x) {
  return std::abs(x) < 1e-2 ? 1.0 - x * x / 10.0 : 3.0 * (std::sin(x) - x * std::cos(x)) / (x * x * x);
}

// w0^2/(w0^2 - w^2 + 2 j zeta w0 w).
std::complex<double> roll_resonance(const Hull& hull, double w) {
  const double w0 = 2.0 * core::pi / roll_period_s(hull);
  return w0 * w0 / std::complex<double>(w0 * w0 - w * w, 2.0 * hull.roll_damping * w0 * w);
}

using Amplitudes = std::array<std::complex<double>, 3>;  // heave, roll, pitch

constexpr std::array<SineAxis, 3> ship_axes{SineAxis::z, SineAxis::roll, SineAxis::pitch};

Amplitudes amplitudes_at(const Hull& hull, const Course& course, double w) {
  const WaveResponse r = response_of(hull, course, w);
  return {r.heave, r.roll_rad_per_m, r.pitch_rad_per_m};
}

// Mean squares of the response over the part of the spectrum that a wave stands for.
std::array<double, 3> mean_squares(const Hull& hull, const Course& course, const Sea& sea, const Wave& wave) {
  constexpr int points = 32;
  std::array<double, 3> sum{};
  for (int i = 0; i < points; ++i) {
    const double share = wave.from_share + (wave.to_share - wave.from_share) * (i + 0.5) / points;
    const Amplitudes a = amplitudes_at(hull, course, frequency_of_share_rad_per_s(sea, share));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += std::norm(a[axis]) / points;
  }
  return sum;
}

// re(a exp(j (we t + phase))) as a sine.
Sine sine_of(SineAxis axis, double amplitude, double phase_rad, double encounter_rad_per_s) {
  return {axis, amplitude, encounter_rad_per_s / (2.0 * core::pi), phase_rad + core::pi / 2.0};
}

}  // namespace

double encounter_frequency_rad_per_s(const Course& course, double w) {
  return w - w * w * course.speed_mps * std::cos(course.waves_to_rad) / standard_gravity_mps2;
}

double roll_period_s(const Hull& hull) {
  const double c = 0.373 + 0.023 * hull.beam_m / hull.draught_m - 0.043 * hull.length_m / 100.0;
  return 2.0 * c * hull.beam_m / std::sqrt(hull.metacentric_height_m);
}

// The surface around the ship is cos(k (x cos mu + y sin mu) - we t), x ahead, y to port, or re(exp(j we t - j k ...)):
// a slope along x is -j k cos mu. Bow up is +, port side down: a slope along y counts as -.
WaveResponse response_of(const Hull& hull, const Course& course, double w) {
  constexpr std::complex<double> j{0.0, 1.0};
  const double k = w * w / standard_gravity_mps2;
  const double along = std::cos(course.waves_to_rad);
  const double across = std::sin(course.waves_to_rad);
  const double half_length = 0.5 * k * hull.length_m * along;
  const double half_beam = 0.5 * k * hull.beam_m * across;
  const double weak = std::exp(-0.5 * k * hull.draught_m);
  WaveResponse response;
  response.heave = weak * mean_of_wave(half_length) * mean_of_wave(half_beam);
  response.pitch_rad_per_m = -j * (weak * k * along * slope_of_wave(half_length) * mean_of_wave(half_beam));
  response.roll_rad_per_m = j * (weak * k * across * mean_of_wave(half_length) * slope_of_wave(half_beam)) *
                            roll_resonance(hull, encounter_frequency_rad_per_s(course, w));
  return response;
}

std::vector<Sine> surface_sines(const Sea& sea, const Course& course, int count, const core::RandomStream& stream) {
  std::vector<Sine> sines;
  const double amplitude = std::sqrt(2.0 * wave_variance_m2(sea) / count);
  for (const Wave& wave : waves_of(sea, count, stream))
    sines.push_back(sine_of(SineAxis::z, amplitude, wave.phase_rad,
                            encounter_frequency_rad_per_s(course, wave.frequency_rad_per_s)));
  return sines;
}

std::vector<Sine> ship_sines(const Hull& hull, const Course& course, const Sea& sea, int count,
                             const core::RandomStream& stream) {
  std::vector<Sine> sines;
  for (const Wave& wave : waves_of(sea, count, stream)) {
    const double w = wave.frequency_rad_per_s;
    const Amplitudes at_wave = amplitudes_at(hull, course, w);
    const std::array<double, 3> squares = mean_squares(hull, course, sea, wave);
    for (std::size_t axis = 0; axis < 3; ++axis)
      sines.push_back(sine_of(ship_axes[axis], std::sqrt(2.0 * wave_variance_m2(sea) / count * squares[axis]),
                              wave.phase_rad + std::arg(at_wave[axis]), encounter_frequency_rad_per_s(course, w)));
  }
  return sines;
}

}  // namespace sarsim::radar
