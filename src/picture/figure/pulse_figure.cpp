#include "picture/figure/pulse_figure.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include <fmt/format.h>

#include "core/maths/fft.hpp"
#include "core/text/number_text.hpp"
#include "picture/figure/figure_axes.hpp"

namespace sarsim::picture {

namespace {

constexpr double max_samples = 0x1p20;
constexpr std::size_t fewest_samples = 1024;

struct SentSamples {
  double interval_s = 0.0;
  std::vector<double> time_s;  // in the middles of the intervals, so that edges need no care
  std::vector<std::complex<double>> value;
};

SentSamples samples_of(const radar::Pulse& pulse, double bandwidth) {
  const double wanted = std::min(16.0 * pulse.width_s * bandwidth, max_samples / 8.0);
  const auto count = std::max(fewest_samples, static_cast<std::size_t>(std::ceil(wanted)));
  SentSamples samples;
  samples.interval_s = pulse.width_s / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    samples.time_s.push_back((static_cast<double>(i) + 0.5) * samples.interval_s);
    samples.value.push_back(pulse.value(samples.time_s.back()));
  }
  return samples;
}

FigurePanel pulse_panel(const SentSamples& samples, double width_s) {
  FigurePanel panel;
  panel.title = "Pulse";
  panel.x = {"Time since its beginning", "s", 0.0, width_s, {}};
  panel.y = {"Amplitude", "", 0.0, 1.0, {}};
  std::vector<double> in_phase;
  std::vector<double> quadrature;
  for (const std::complex<double>& value : samples.value) {
    in_phase.push_back(value.real());
    quadrature.push_back(value.imag());
  }
  std::vector<double> both = in_phase;
  both.insert(both.end(), quadrature.begin(), quadrature.end());
  fit(panel.y, both);
  panel.curves.push_back({"I", Role::curve, false, samples.time_s, std::move(in_phase)});
  panel.curves.push_back({"Q", Role::curve_2, false, samples.time_s, std::move(quadrature)});
  return panel;
}

FigurePanel spectrum_panel(const SentSamples& samples, double seen_hz, double span_db) {
  const std::size_t size = core::good_fft_size(8 * samples.value.size());
  std::vector<std::complex<double>> line = samples.value;
  line.resize(size);
  core::Fft(size).forward(line);
  std::vector<double> frequency_hz;
  std::vector<double> energy;
  const double spacing_hz = 1.0 / (static_cast<double>(size) * samples.interval_s);
  for (std::size_t i = 0; i < size; ++i) {
    const double f = (static_cast<double>(i) - static_cast<double>(size / 2)) * spacing_hz;
    if (std::abs(f) > seen_hz) continue;
    frequency_hz.push_back(f);
    energy.push_back(std::norm(line[(i + size - size / 2) % size]));
  }
  const double largest = *std::ranges::max_element(energy);
  if (largest > 0.0)
    for (double& value : energy) value /= largest;
  FigureAxis across = axis_along("Frequency from the carrier", "Hz", frequency_hz);
  return curve_panel("Energy spectrum", std::move(across), {"Below the largest", "dB", 0.0, 1.0, {}},
                     std::move(frequency_hz), decibels_of(std::move(energy), 10.0, span_db));
}

std::string words_of(const radar::Pulse& pulse, double bandwidth) {
  const std::string sizes = core::with_prefix(pulse.width_s, "s") + " long, bandwidth " +
                            core::with_prefix(bandwidth, "Hz") +
                            fmt::format(", time-bandwidth product {:.6g}", pulse.width_s * bandwidth);
  switch (pulse.kind) {
    case radar::Pulse::Kind::mono: return "One frequency, " + sizes;
    case radar::Pulse::Kind::chirp: return (pulse.sweep_hz < 0.0 ? "Down chirp, " : "Chirp, ") + sizes;
    case radar::Pulse::Kind::code: return fmt::format("Barker code of {}, ", pulse.code.size()) + sizes;
    case radar::Pulse::Kind::user: break;
  }
  return "User-defined pulse, " + sizes;
}

}  // namespace

Figure sent_pulse_figure(const radar::Pulse& pulse, double span_db) {
  const double measured = radar::bandwidth_hz(pulse);
  const double bandwidth = measured > 0.0 ? measured : 1.0 / pulse.width_s;
  const SentSamples samples = samples_of(pulse, bandwidth);
  // A chirp fills its band; the others have sidelobes worth seeing.
  const double seen_hz = (pulse.kind == radar::Pulse::Kind::chirp ? 1.5 : 5.0) * bandwidth;
  Figure figure;
  figure.note = words_of(pulse, bandwidth);
  figure.panels.push_back(pulse_panel(samples, pulse.width_s));
  figure.panels.push_back(spectrum_panel(samples, std::min(seen_hz, 0.5 / samples.interval_s), span_db));
  return figure;
}

}  // namespace sarsim::picture
