#include "radar/waveform/pulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

const std::vector<int>& barker_code(int index) {
  static const std::array<std::vector<int>, 7> codes{{{1, -1},
                                                      {1, 1, -1},
                                                      {1, 1, -1, 1},
                                                      {1, 1, 1, -1, 1},
                                                      {1, 1, 1, -1, -1, 1, -1},
                                                      {1, 1, 1, -1, -1, -1, 1, -1, -1, 1, -1},
                                                      {1, 1, 1, 1, 1, -1, -1, 1, 1, -1, 1, -1, 1}}};
  return codes.at(static_cast<std::size_t>(index));
}

std::complex<double> Pulse::value(double t_s, double tolerance_s) const {
  const double gain = envelope_value(t_s);
  switch (kind) {
    case Kind::mono: return gain;
    case Kind::chirp: {
      const double u = t_s - 0.5 * width_s;
      return std::polar(1.0, core::pi * sweep_rate_hz_per_s() * u * u) * gain;
    }
    case Kind::code: {
      const auto length = static_cast<double>(code.size());
      const double chip = std::clamp(std::floor((t_s + tolerance_s) * length / width_s), 0.0, length - 1.0);
      return gain * code[static_cast<std::size_t>(chip)];
    }
    case Kind::user: return gain * std::complex(in_phase.value(t_s / width_s), quadrature.value(t_s / width_s));
  }
  return 0.0;
}

double Pulse::envelope_value(double t_s) const {
  switch (envelope) {
    case Envelope::rectangular: return 1.0;
    case Envelope::linear: {
      const double rising = t_s < rise_s ? t_s / rise_s : 1.0;
      const double falling = t_s > width_s - fall_s ? (width_s - t_s) / fall_s : 1.0;
      return std::max(0.0, std::min(rising, falling));
    }
    case Envelope::user: return envelope_gain.value(t_s / width_s);
  }
  return 1.0;
}

std::vector<double> Pulse::breaks_s() const {
  std::vector<double> breaks;
  const auto add = [&](double t) {
    if (t > 0.0 && t < width_s) breaks.push_back(t);
  };
  if (kind == Kind::code)
    for (std::size_t i = 1; i < code.size(); ++i)
      add(width_s * static_cast<double>(i) / static_cast<double>(code.size()));
  if (kind == Kind::user)
    for (const core::Interpolator* part : {&in_phase, &quadrature})
      for (const core::Knot& knot : part->knots()) add(knot.x * width_s);
  if (envelope == Envelope::linear) {
    // A rise that meets the fall goes no further.
    const bool meet = rise_s + fall_s > width_s;
    const double meeting_s = meet ? width_s * (rise_s / (rise_s + fall_s)) : 0.0;
    add(meet ? meeting_s : rise_s);
    add(meet ? meeting_s : width_s - fall_s);
  }
  if (envelope == Envelope::user)
    for (const core::Knot& knot : envelope_gain.knots()) add(knot.x * width_s);
  std::ranges::sort(breaks);
  const auto same = std::ranges::unique(breaks);
  breaks.erase(same.begin(), same.end());
  return breaks;
}

double bandwidth_hz(const Pulse& pulse) {
  switch (pulse.kind) {
    case Pulse::Kind::mono: return 1.0 / pulse.width_s;
    case Pulse::Kind::chirp: return std::abs(pulse.sweep_hz);
    case Pulse::Kind::code: return static_cast<double>(pulse.code.size()) / pulse.width_s;
    case Pulse::Kind::user: return energy_band_hz(pulse, 0.99);
  }
  return 0.0;
}

namespace {

constexpr std::size_t shape_samples = 4096;

// Energy at the frequencies of a transform of `size` points, of samples `step_s` apart in the middles of intervals.
std::vector<double> energy_spectrum(const Pulse& pulse, std::size_t size, double step_s) {
  std::vector<std::complex<double>> spectrum(size);
  for (std::size_t i = 0; i < shape_samples; ++i) spectrum[i] = pulse.value((static_cast<double>(i) + 0.5) * step_s);
  core::Fft(size).forward(spectrum);
  std::vector<double> energy(size);
  for (std::size_t i = 0; i < size; ++i) energy[i] = std::norm(spectrum[i]);
  return energy;
}

// |autocorrelation|^2 at a lag given in periods of the transform that made the spectrum.
double correlation_power(const std::vector<double>& energy, double lag_periods) {
  const std::complex<double> turn = std::polar(1.0, 2.0 * core::pi * lag_periods);
  std::complex<double> sum;
  std::complex<double> up = 1.0;
  const std::size_t half = energy.size() / 2;
  for (std::size_t k = 0; k < half; ++k, up *= turn) {
    sum += energy[k] * up;
    if (k > 0) sum += energy[energy.size() - k] * std::conj(up);
  }
  return std::norm(sum);
}

}  // namespace

double energy_band_hz(const Pulse& pulse, double share) {
  CORE_EXPECT(share >= 0.0 && share <= 1.0);
  constexpr std::size_t size = 16 * shape_samples;
  const double step_s = pulse.width_s / static_cast<double>(shape_samples);
  const std::vector<double> energy = energy_spectrum(pulse, size, step_s);
  double total = 0.0;
  for (const double bin : energy) total += bin;
  double inside = energy[0];
  std::size_t half = 0;
  while (inside < share * total && half + 1 < size / 2) {
    ++half;
    inside += energy[half] + energy[size - half];
  }
  const double bin_hz = 1.0 / (step_s * static_cast<double>(size));
  return 2.0 * (static_cast<double>(half) + 0.5) * bin_hz;
}

double half_power_width_s(const Pulse& pulse) {
  constexpr std::size_t size = 2 * shape_samples;
  const double step_s = pulse.width_s / static_cast<double>(shape_samples);
  const std::vector<double> energy = energy_spectrum(pulse, size, step_s);
  std::vector<std::complex<double>> correlation(energy.begin(), energy.end());
  core::Fft(size).inverse(correlation);
  const double half = 0.5 * std::norm(correlation[0]);
  if (!(half > 0.0)) return 0.0;
  std::size_t beyond = 1;
  while (beyond < size / 2 && std::norm(correlation[beyond]) > half) ++beyond;
  // Between two lags the peak of a pulse of much bandwidth has fallen by far more than half.
  const double half_at_zero = 0.5 * correlation_power(energy, 0.0);
  double low = static_cast<double>(beyond - 1);
  double high = static_cast<double>(beyond);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (correlation_power(energy, middle / static_cast<double>(size)) > half_at_zero ? low : high) = middle;
  }
  return (low + high) * step_s;
}

}  // namespace sarsim::radar
