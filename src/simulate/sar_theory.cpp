#include "simulate/sar_theory.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "simulate/sar_looks.hpp"

namespace sarsim {

namespace {

// The part that each look has in the image of its target.
class LookWeights {
 public:
  LookWeights(const SarLooks& looks, const FocusOptions& options, std::size_t pulses, bool time_domain)
      : looks_(looks),
        options_(options),
        pulses_(static_cast<double>(pulses)),
        weight_(weight_of(options.azimuth_window)),
        time_domain_(time_domain) {}

  [[nodiscard]] double of(std::size_t i, const SarLook& look) const {
    const double from_centroid_hz = look.doppler_hz - options_.doppler_centroid_hz;
    if (options_.doppler_bandwidth_hz > 0.0) return weight_(from_centroid_hz / options_.doppler_bandwidth_hz);
    return weight_((static_cast<double>(looks_.pulse(i)) + 0.5) / pulses_ - 0.5);
  }
  /// Whether its Doppler frequency is taken for what it is.
  [[nodiscard]] bool sampled(const SarLook& look) const {
    return time_domain_ || std::abs(look.doppler_hz - options_.doppler_centroid_hz) <= 0.5 / looks_.track().interval_s;
  }

 private:
  const SarLooks& looks_;
  const FocusOptions& options_;
  double pulses_;
  std::function<double(double)> weight_;
  bool time_domain_;
};

struct Tone {
  double per_m = 0.0;  // cycles
  double amplitude = 0.0;
};

std::optional<ResponseFigures> figures_of_tones(const std::vector<Tone>& tones) {
  constexpr double steps_per_cell = 48.0;
  constexpr std::ptrdiff_t half = 1200;  // 25 cells
  if (tones.empty()) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(tones, {}, &Tone::per_m);
  if (!(high.per_m > low.per_m)) return std::nullopt;
  const double step_m = 1.0 / ((high.per_m - low.per_m) * steps_per_cell);
  std::vector<std::complex<double>> response(2 * half + 1);
  for (const Tone& tone : tones) {
    const double cycles = (tone.per_m - low.per_m) * step_m;
    std::complex<double> term = std::polar(tone.amplitude, -2.0 * pi * cycles * static_cast<double>(half));
    const std::complex<double> turn = std::polar(1.0, 2.0 * pi * cycles);
    for (std::complex<double>& value : response) {
      value += term;
      term *= turn;
    }
  }
  auto figures = figures_of(response, half);
  if (!figures) return std::nullopt;
  figures->width *= step_m;
  figures->null *= step_m;
  return figures;
}

// Sum of the weights that focusing divides by: over the pulses, or over those that sweep the whole band.
double sum_of_weights(const SarLooks& looks, const LookWeights& weights, const FocusOptions& options,
                      const SarWaveform& waveform, const std::vector<SarLook>& seen, double range_m) {
  if (options.doppler_bandwidth_hz <= 0.0) {
    double sum = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) sum += weights.of(i, seen[i]);
    return sum;
  }
  const double wavelength_m = waveform.light_speed_mps / waveform.carrier_hz;
  const double speed = looks.track().speed_mps;
  const double sine = 0.5 * wavelength_m * options.doppler_centroid_hz / speed;
  const double rate_hzps = 2.0 * speed * speed * std::pow(1.0 - sine * sine, 1.5) / (wavelength_m * range_m);
  const double interval_s = looks.track().interval_s * static_cast<double>(looks.pulse(1));
  return mean_weight(options.azimuth_window) * options.doppler_bandwidth_hz / (rate_hzps * interval_s);
}

std::optional<ResponseFigures> range_theory(const Plan& plan, const SarWaveform& waveform, const SarWindow& window) {
  const Pulse& pulse = plan.radar.pulse;
  if (pulse.kind != Pulse::Kind::chirp || pulse.envelope != Pulse::Envelope::rectangular) return std::nullopt;
  const double band_hz = std::abs(waveform.bandwidth_hz);
  ResponseFigures figures =
      theoretical_figures(window, band_hz * waveform.pulse_width_s, waveform.sample_rate_hz / band_hz);
  const double cell_m = 0.5 * waveform.light_speed_mps / band_hz;
  figures.width *= cell_m;
  figures.null *= cell_m;
  return figures;
}

TargetTheory theory_of(const SarLooks& looks, const LookWeights& weights, const EchoRows& echoes,
                       const FocusOptions& options, std::size_t number) {
  TargetTheory theory;
  theory.target = number;
  const std::vector<SarLook>& seen = looks.of(number);
  std::vector<Tone> tones;
  double sum = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double part = weights.of(i, seen[i]) * seen[i].amplitude;
    if (!(part > 0.0) || !weights.sampled(seen[i])) continue;
    sum += part;
    moment += part * static_cast<double>(i);
    tones.push_back({seen[i].doppler_hz / looks.track().speed_mps, part});
  }
  if (!(sum > 0.0)) return theory;
  const SarLook& middle = seen[static_cast<std::size_t>(std::llround(moment / sum))];
  theory.place = looks.place(middle, middle.doppler_hz);
  theory.amplitude = sum / sum_of_weights(looks, weights, options, echoes.waveform, seen, theory.place.range_m);
  const double turns = 2.0 * theory.place.range_m * echoes.waveform.carrier_hz / echoes.waveform.light_speed_mps;
  theory.phase_rad = std::remainder(-2.0 * pi * turns, 2.0 * pi);
  theory.azimuth = figures_of_tones(tones);
  return theory;
}

}  // namespace

std::vector<TargetTheory> theory_of_targets(const Plan& plan, const EchoRows& echoes, const FocusOptions& options,
                                            bool time_domain) {
  const SarLooks looks(plan, echoes);
  const LookWeights weights(looks, options, echoes.track.size(), time_domain);
  const std::optional<ResponseFigures> range = range_theory(plan, echoes.waveform, options.range_window);
  std::vector<TargetTheory> theories;
  for (std::size_t t = 0; t < looks.targets(); ++t) {
    theories.push_back(theory_of(looks, weights, echoes, options, t));
    theories.back().range = range;
  }
  return theories;
}

}  // namespace sarsim
