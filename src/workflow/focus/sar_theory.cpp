#include "workflow/focus/sar_theory.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/ground_grid.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/sar_ghosts.hpp"
#include "workflow/focus/sar_looks.hpp"

namespace sarsim::workflow {

namespace {

// Whose pulses an image is made of.
enum class Domain {
  frequency,  // as they were sent
  resampled,  // interpolated to even places along the line
  time,       // as they were sent, each with its true Doppler frequency
};

// The part that each look has in the image of its target.
class LookWeights {
 public:
  LookWeights(const SarLooks& looks, const signal::FocusOptions& options, std::size_t pulses, Domain domain)
      : looks_(looks),
        options_(options),
        pulses_(static_cast<double>(pulses)),
        weight_(signal::weight_of(options.azimuth_window)),
        domain_(domain) {}

  [[nodiscard]] Domain domain() const { return domain_; }
  [[nodiscard]] double of(std::size_t i, std::span<const SarLook> seen) const {
    const double from_centroid_hz = seen[i].doppler_hz - options_.doppler_centroid_hz;
    if (options_.doppler_bandwidth_hz > 0.0)
      return weight_(from_centroid_hz / options_.doppler_bandwidth_hz) * density(i, seen);
    return weight_((pulse(i, seen) + 0.5) / pulses_ - 0.5) * density(i, seen);
  }
  /// Whether its Doppler frequency is taken for what it is.
  [[nodiscard]] bool sampled(const SarLook& look) const {
    return domain_ == Domain::time ||
           std::abs(look.doppler_hz - options_.doppler_centroid_hz) <= 0.5 / looks_.track().interval_s;
  }

 private:
  // That stands at the look's place in the image's record.
  [[nodiscard]] double pulse(std::size_t i, std::span<const SarLook> seen) const {
    const auto sent = static_cast<double>(looks_.pulse(i));
    const double length_s = seen.back().time_s - seen.front().time_s;
    if (domain_ != Domain::resampled || !(length_s > 0.0)) return sent;
    return (seen[i].time_s - seen.front().time_s) / length_s * static_cast<double>(looks_.pulse(seen.size() - 1));
  }
  // Of evenly spaced pulses where those that were sent stand this far apart, in parts of the mean.
  [[nodiscard]] double density(std::size_t i, std::span<const SarLook> seen) const {
    const double length_s = seen.back().time_s - seen.front().time_s;
    if (domain_ != Domain::resampled || !(length_s > 0.0)) return 1.0;
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, seen.size() - 1);
    return (seen[after].time_s - seen[before].time_s) / static_cast<double>(after - before) *
           static_cast<double>(seen.size() - 1) / length_s;
  }

  const SarLooks& looks_;
  const signal::FocusOptions& options_;
  double pulses_;
  std::function<double(double)> weight_;
  Domain domain_;
};

struct Tone {
  double per_m = 0.0;  // cycles
  double amplitude = 0.0;
};

std::optional<signal::ResponseFigures> figures_of_tones(const std::vector<Tone>& tones) {
  constexpr double steps_per_cell = 48.0;
  constexpr std::ptrdiff_t half = 1200;  // 25 cells
  if (tones.empty()) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(tones, {}, &Tone::per_m);
  if (!(high.per_m > low.per_m)) return std::nullopt;
  const double step_m = 1.0 / ((high.per_m - low.per_m) * steps_per_cell);
  std::vector<std::complex<double>> response(2 * half + 1);
  for (const Tone& tone : tones) {
    const double cycles = (tone.per_m - low.per_m) * step_m;
    std::complex<double> term = std::polar(tone.amplitude, -2.0 * core::pi * cycles * static_cast<double>(half));
    const std::complex<double> turn = std::polar(1.0, 2.0 * core::pi * cycles);
    for (std::complex<double>& value : response) {
      value += term;
      term *= turn;
    }
  }
  auto figures = signal::figures_of(response, half);
  if (!figures) return std::nullopt;
  figures->width *= step_m;
  figures->null *= step_m;
  return figures;
}

// Sine of the angle by which the beam's middle looks ahead.
double centroid_sine(const SarLooks& looks, const signal::FocusOptions& options, const signal::SarWaveform& waveform) {
  return radar::range_of_cycle(waveform.carrier_hz, waveform.light_speed_mps) * options.doppler_centroid_hz /
         looks.track().speed_mps;
}

// Sum of the weights that focusing divides by: over the pulses that it uses; in the frequency domain, over those that
// sweep the whole of a band, flown or not.
double sum_of_weights(const SarLooks& looks, const LookWeights& weights, const signal::FocusOptions& options,
                      const signal::SarWaveform& waveform, std::span<const SarLook> seen, double range_m) {
  if (options.doppler_bandwidth_hz <= 0.0 || weights.domain() == Domain::time) {
    double sum = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) sum += weights.of(i, seen);
    return sum;
  }
  const double wavelength_m = radar::wavelength_of(waveform.carrier_hz, waveform.light_speed_mps);
  const double speed = looks.track().speed_mps;
  const double sine = centroid_sine(looks, options, waveform);
  const double rate_hzps = 2.0 * speed * speed * std::pow(1.0 - sine * sine, 1.5) / (wavelength_m * range_m);
  const double interval_s = looks.track().interval_s * static_cast<double>(looks.pulse(1));
  return signal::mean_weight(options.azimuth_window) * options.doppler_bandwidth_hz / (rate_hzps * interval_s);
}

// The azimuth cut of a squinted response runs across the line of sight, on which it is narrower than along the track.
void cut_across_sight(std::optional<signal::ResponseFigures>& figures, double sine) {
  if (!figures || !(std::abs(sine) > 0.01)) return;  // signal/measure/image_quality.cpp cuts along the axes up to there
  const double cosine = std::sqrt(std::max(1.0 - sine * sine, 0.0));
  figures->width *= cosine;
  figures->null *= cosine;
}

bool is_plain_chirp(const radar::Pulse& pulse) {
  return pulse.kind == radar::Pulse::Kind::chirp && pulse.envelope == radar::Pulse::Envelope::rectangular;
}

// Of the radar, over the pulse, where it is in compressed data; nothing for an even one.
signal::WindowFunction recorded_window(const simulate::Plan& plan) {
  if (plan.simulation.processing != scene::Processing::matched_filter) return {};
  constexpr int points = 64;
  for (int i = 0; i <= points; ++i)
    if (plan.radar.window(static_cast<double>(i) / points) != 1.0) return plan.radar.window;
  return {};
}

// What weighs the samples of a pulse: windows over the band of a chirp are windows over its time.
signal::WindowFunction pulse_weight(const simulate::Plan& plan, const signal::SarWindow& window) {
  const signal::WindowFunction recorded = recorded_window(plan);
  if (plan.radar.pulse.kind != radar::Pulse::Kind::chirp) return recorded;
  return [recorded, focused = signal::weight_of(window)](double x) {
    return focused(std::clamp(x, 0.0, 1.0) - 0.5) * (recorded ? recorded(x) : 1.0);
  };
}

std::optional<signal::ResponseFigures> range_theory(const simulate::Plan& plan, const signal::SarWaveform& waveform,
                                                    const signal::SarWindow& window) {
  const double band_hz = std::abs(waveform.bandwidth_hz);
  // A pulse of less than a cycle of its sweep is no chirp: its length gives the resolution.
  if (!is_plain_chirp(plan.radar.pulse) || !(band_hz * waveform.pulse_width_s >= 1.0)) return std::nullopt;
  // Sampled so coarsely, it is nothing but ghosts of itself.
  constexpr double least_sampling = 1.0 / 16.0;
  if (!(waveform.sample_rate_hz >= least_sampling * band_hz)) return std::nullopt;
  signal::ResponseFigures figures = signal::theoretical_figures(
      window, band_hz * waveform.pulse_width_s, waveform.sample_rate_hz / band_hz, recorded_window(plan));
  const double cell_m = radar::range_of_cycle(band_hz, waveform.light_speed_mps);
  figures.width *= cell_m;
  figures.null *= cell_m;
  return figures;
}

TargetTheory theory_of(const SarLooks& looks, const LookWeights& weights, const signal::EchoRows& echoes,
                       const signal::FocusOptions& options, const std::optional<signal::ResponseFigures>& range,
                       std::size_t number, std::span<const SarLook> seen) {
  TargetTheory theory;
  theory.target = number;
  std::vector<Tone> tones;
  double sum = 0.0;
  double whole = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double part = weights.of(i, seen) * seen[i].amplitude;
    if (!(part > 0.0) || !weights.sampled(seen[i])) continue;
    whole += part;
    if (!(seen[i].share > 0.0)) continue;
    sum += part * seen[i].share;
    moment += part * seen[i].share * static_cast<double>(i);
    tones.push_back({seen[i].doppler_hz / looks.track().speed_mps, part * seen[i].share});
  }
  if (!(sum > 0.0)) return theory;
  const SarLook& middle = seen[static_cast<std::size_t>(std::llround(moment / sum))];
  theory.place = looks.place(middle, middle.doppler_hz);
  theory.amplitude = sum / sum_of_weights(looks, weights, options, echoes.waveform, seen, theory.place.range_m);
  const double turns =
      radar::turns_of(theory.place.range_m, echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps);
  theory.phase_rad = std::remainder(-2.0 * core::pi * turns, 2.0 * core::pi);
  theory.azimuth = figures_of_tones(tones);
  cut_across_sight(theory.azimuth, centroid_sine(looks, options, echoes.waveform));
  // A pulse of which a part is missing has another spectrum.
  constexpr double unseen = 1e-3;
  if (sum > (1.0 - unseen) * whole) theory.range = range;
  return theory;
}

}  // namespace

std::size_t listed_targets(const simulate::ResolvedScene& scene) {
  const std::size_t all = scene.scatterers.size();
  const std::size_t targets = scene.scatterers.targets();
  return all - targets > most_examined_targets ? targets : all;
}

std::vector<TargetTheory> theory_of_targets(const simulate::Plan& plan, const signal::EchoRows& echoes,
                                            const signal::FocusOptions& options, bool time_domain,
                                            const core::WorkControl& control) {
  const SarLooks looks(plan, echoes, pulse_weight(plan, options.range_window));
  const Domain domain = time_domain ? Domain::time : echoes.compensated ? Domain::resampled : Domain::frequency;
  const LookWeights weights(looks, options, echoes.track.size(), domain);
  // The band that stepped carriers fill together has no theory of its response.
  const std::optional<signal::ResponseFigures> range =
      echoes.carriers_hz.empty() ? range_theory(plan, echoes.waveform, options.range_window) : std::nullopt;
  std::vector<TargetTheory> theories(listed_targets(*plan.scene));
  looks.each(control, [&](std::size_t t, std::span<const SarLook> seen) {
    if (t >= theories.size()) return;
    theories[t] = theory_of(looks, weights, echoes, options, range, t, seen);
  });
  return theories;
}

namespace {

// On a ground grid ranges are as far apart as the ground is seen flat, and places along the flight as it climbs.
void lay_on_ground(TargetTheory& theory, const signal::ImageFrame& grid, const signal::ImageFrame& slant) {
  const signal::ImagePlace place = signal::place_on_ground(grid, slant, theory.place);
  const signal::ImagePlace farther =
      signal::place_on_ground(grid, slant, {theory.place.azimuth_m, theory.place.range_m + 1.0});
  const signal::ImagePlace ahead =
      signal::place_on_ground(grid, slant, {theory.place.azimuth_m + 1.0, theory.place.range_m});
  theory.place = place;
  if (theory.azimuth) {
    theory.azimuth->width *= ahead.azimuth_m - place.azimuth_m;
    theory.azimuth->null *= ahead.azimuth_m - place.azimuth_m;
  }
  if (!theory.range) return;
  theory.range->width *= farther.range_m - place.range_m;
  theory.range->null *= farther.range_m - place.range_m;
}

}  // namespace

std::vector<TargetTheory> theory_on_image(const FocusedEchoes& focused, const signal::ImageFrame& frame,
                                          const core::WorkControl& control) {
  signal::EchoRows echoes = focused.echoes;
  echoes.compensated = focused.time_domain || focused.compensated;
  std::vector<TargetTheory> theories =
      theory_of_targets(focused.plan, echoes, focused.options, focused.time_domain, control);
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  if (frame.plane == signal::ImagePlane::slant_range) {
    // Compensated pulses lie elsewhere along the line, and so does the image's origin.
    for (TargetTheory& theory : theories)
      theory.place.azimuth_m -= core::dot(frame.origin_m - track.origin_m, track.along);
    return theories;
  }
  const signal::ImageFrame slant{.plane = signal::ImagePlane::slant_range,
                                 .origin_m = track.origin_m,
                                 .along = track.along,
                                 .speed_mps = track.speed_mps};
  for (TargetTheory& theory : theories)
    if (theory.amplitude > 0.0) lay_on_ground(theory, frame, slant);
  return theories;
}

}  // namespace sarsim::workflow
