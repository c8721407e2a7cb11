#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "core/maths/constants.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

constexpr double pulse_width_s = 1.3e-6;
constexpr double pulse_rate_hz = 20e6;
constexpr double swept_hz = 15e6;

// The filter's response, written out from docs/decisions/0005-band-limited-pulse.md; F is half the band.
double filter_response(double t, double half_band_hz) {
  const double reach_s = 28.0 / half_band_hz;
  if (std::abs(t) >= reach_s) return 0.0;
  const double cutoff_hz = 0.92 * half_band_hz;
  const double x = 2.0 * core::pi * cutoff_hz * t;
  return 2.0 * cutoff_hz * (x == 0.0 ? 1.0 : std::sin(x) / x) *
         std::exp(14.0 * (std::sqrt(1.0 - t * t / (reach_s * reach_s)) - 1.0));
}

using OfTime = std::function<std::complex<double>(double)>;

// Integral of f over [begin, end] by Boole's rule in steps of 1/256 of a cycle of the band: its error is below 1e-11.
std::complex<double> integral(const OfTime& f, double begin, double end, double band_hz) {
  const int pieces = std::max(4, static_cast<int>(std::ceil((end - begin) * band_hz * 64.0)));
  const double h = (end - begin) / (4.0 * pieces);
  std::complex<double> sum;
  for (int i = 0; i < pieces; ++i) {
    const double t = begin + 4.0 * h * i;
    sum += 7.0 * f(t) + 32.0 * f(t + h) + 12.0 * f(t + 2.0 * h) + 32.0 * f(t + 3.0 * h) + 7.0 * f(t + 4.0 * h);
  }
  return sum * (2.0 * h / 45.0);
}

struct Coded {
  std::string name;
  scene::Radar::Pulse pulse;
  std::vector<double> borders_s;  // Between them the pulse is smooth.
  OfTime value;                   // Against the time after the leading edge.
  double nominal_band_hz;
};

std::vector<Coded> coded_pulses() {
  constexpr double rate = swept_hz / pulse_width_s;
  const auto chirp = [](double t) { return std::polar(1.0, core::pi * rate * std::pow(t - 0.5 * pulse_width_s, 2)); };
  const auto barker = [](double t) -> std::complex<double> {
    static constexpr const char* code = "+++++--++-+-+";
    return code[std::clamp(static_cast<int>(t / (pulse_width_s / 13.0)), 0, 12)] == '+' ? 1.0 : -1.0;
  };
  std::vector<double> chips;
  for (int i = 0; i <= 13; ++i) chips.push_back(i * pulse_width_s / 13.0);
  return {{"chirp", scene::Radar::Pulse::chirp, {0.0, pulse_width_s}, chirp, swept_hz},
          {"Barker code", scene::Radar::Pulse::barker, chips, barker, 13.0 / pulse_width_s}};
}

// The sent pulse behind the filter, at a time after its leading edge.
std::complex<double> filtered(const Coded& coded, double t, double band_hz) {
  std::complex<double> sum;
  for (std::size_t i = 0; i + 1 < coded.borders_s.size(); ++i) {
    const double middle = 0.5 * (coded.borders_s[i] + coded.borders_s[i + 1]);
    const OfTime value = coded.borders_s.size() > 2 ? [c = coded.value(middle)](double) { return c; } : coded.value;
    const double begin = std::max(coded.borders_s[i], t - 56.0 / band_hz);
    const double end = std::min(coded.borders_s[i + 1], t + 56.0 / band_hz);
    if (begin >= end) continue;
    sum += integral([&](double s) { return value(s) * filter_response(t - s, 0.5 * band_hz); }, begin, end,
                    std::max(band_hz, coded.nominal_band_hz));
  }
  return sum;
}

// The largest deviation of every `step`-th sample of an echo from the filtered pulse, over the echo's amplitude.
double worst_sample(const Coded& coded, double oversampling, std::size_t step) {
  constexpr double range_m = 1000.0;
  scene::Scene scene = radar_at_origin();
  scene.options.pulse = scene::PulseDefinition::band_limited;
  scene::Radar& radar = scene.radars[0];
  radar.pulse = coded.pulse;
  radar.barker_code = 6;
  radar.bandwidth_hz = swept_hz;
  radar.pulse_width_s = pulse_width_s;
  scene.simulations[0].oversampling = oversampling;
  scene.simulations[0].width_factor = 3.0;
  add_target(scene, {range_m, 0.0, 0.0});
  set_window(scene, range_m - 300.0, range_m + 500.0, pulse_rate_hz);
  const auto samples = recorded(scene).samples;
  const double delay_s = 2.0 * range_m / core::exact_light_speed_mps;
  const double amplitude_v =
      std::sqrt(1000.0) * core::exact_light_speed_mps / 1e9 / (std::pow(4.0 * core::pi, 1.5) * range_m * range_m);
  const std::complex<double> turn = std::polar(amplitude_v, -2.0 * core::pi * std::remainder(1e9 * delay_s, 1.0));
  const double band_hz = oversampling > 1.0 ? coded.nominal_band_hz : pulse_rate_hz;
  double worst = 0.0;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    const double t = 2.0 * (range_m - 300.0) / core::exact_light_speed_mps + static_cast<double>(i) / pulse_rate_hz;
    const double after_edge_s = t - delay_s;
    const bool kept = oversampling <= 1.0 || std::abs(after_edge_s - 0.5 * pulse_width_s) < 1.5 * pulse_width_s;
    const std::complex<double> expected = kept ? turn * filtered(coded, after_edge_s, band_hz) : 0.0;
    worst = std::max(worst, std::abs(samples[i] - expected) / amplitude_v);
  }
  return worst;
}

}  // namespace

void measure_band_limit(Record& record) {
  constexpr const char* source = "the filter's integral, docs/decisions/0005-band-limited-pulse.md";
  const std::size_t step = record.quick() ? 11 : 3;
  for (const Coded& coded : coded_pulses()) {
    record.at_most("Band-limited " + coded.name + ": deviation of its samples", "", 1e-8,
                   worst_sample(coded, 1.0, step), source);
    record.at_most("Band-limited " + coded.name + " of its own band: deviation of its samples", "", 1e-8,
                   worst_sample(coded, 1.2, step), source);
  }
}

}  // namespace sarsim::workflow::verify
