#include "workflow/search/search_targets.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"
#include "signal/search/canceller.hpp"
#include "signal/search/swerling0.hpp"
#include "workflow/search/search_checks.hpp"

namespace sarsim::workflow {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The detector whose number of independent cells gives the factor of the correlated ones; probabilities follow it.
signal::CfarOptions equivalent_detector(const signal::CfarOptions& cfar, std::size_t rows, std::size_t columns) {
  const std::size_t all = signal::reference_cells(cfar, rows, columns);
  if (cfar.calibration == 1.0 || all == 0) return cfar;
  const double factor = signal::cfar_factor(all, cfar);
  signal::CfarOptions independent = cfar;
  independent.calibration = 1.0;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 50; ++i) {
    independent.independence = 0.5 * (low + high);
    (signal::cfar_factor(all, independent) > factor ? low : high) = independent.independence;
  }
  return independent;
}

// The ratio at which a steady target is found in half of all cases.
double even_snr(const signal::CfarOptions& cfar, std::size_t rows, std::size_t columns) {
  double low = 0.0;
  double high = 1.0;
  while (high < 1e5 && steady_probability(cfar, rows, columns, high) < 0.5) high *= 2.0;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (steady_probability(cfar, rows, columns, middle) < 0.5 ? low : high) = middle;
  }
  return high;
}

// Within half a period of 0.
double folded(double value, double period) { return value - period * std::floor(value / period + 0.5); }

std::size_t nearest_index(const std::vector<double>& ascending, double value) {
  const auto after = std::ranges::lower_bound(ascending, value);
  if (after == ascending.begin()) return 0;
  if (after == ascending.end()) return ascending.size() - 1;
  const auto index = static_cast<std::size_t>(after - ascending.begin());
  return value - ascending[index - 1] < ascending[index] - value ? index - 1 : index;
}

// Pulses that one look stands for: an odd number, which has a middle. A canceller takes what changes from one pulse to
// the next and needs each of them.
std::size_t pulses_of_look(const SearchOptions& options) {
  constexpr std::size_t max_looks = 64;
  if (options.canceller > 0) return 1;
  return (options.recorded_pulses() + max_looks - 1) / max_looks | 1U;
}

double probability_of(const signal::CfarOptions& cfar, std::size_t cells, double snr) {
  constexpr std::size_t max_ordered = 4096;
  if (cfar.kind == signal::CfarOptions::Kind::cell_averaging)
    return std::min(1.0, signal::cell_averaging_steady_probability(
                             cells, signal::cell_averaging_factor(cells, cfar.false_alarm), snr));
  cells = std::min(cells, max_ordered);
  const std::size_t rank = signal::cfar_rank(cells, cfar.rank_share);
  const double factor = signal::ordered_statistic_factor(cells, rank, cfar.false_alarm);
  return std::min(1.0, signal::ordered_statistic_steady_probability(cells, rank, factor, snr));
}

}  // namespace

double steady_probability(const signal::CfarOptions& cfar, std::size_t rows, std::size_t columns, double snr) {
  const std::size_t all = signal::reference_cells(cfar, rows, columns);
  if (all == 0) return 0.0;
  const double worth = std::clamp(equivalent_detector(cfar, rows, columns).independence * static_cast<double>(all), 1.0,
                                  static_cast<double>(all));
  const auto below = static_cast<std::size_t>(worth);
  const double share = worth - static_cast<double>(below);
  const double low = probability_of(cfar, below, snr);
  return share > 0.0 ? low + share * (probability_of(cfar, below + 1, snr) - low) : low;
}

std::vector<double> noise_gains(const std::vector<double>& weights, std::size_t canceller, std::size_t rows) {
  const std::vector<double> differences = signal::canceller_weights(canceller);
  std::vector<double> products(differences.size());
  for (std::size_t m = 0; m < products.size(); ++m)
    for (std::size_t n = 0; n + m < weights.size(); ++n) products[m] += weights[n] * weights[n + m];
  std::vector<double> gains(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const double cycles = (static_cast<double>(row) - static_cast<double>(rows / 2)) / static_cast<double>(rows);
    for (std::size_t k = 0; k < differences.size(); ++k)
      for (std::size_t l = 0; l < differences.size(); ++l) {
        const std::size_t apart = k > l ? k - l : l - k;
        gains[row] += differences[k] * differences[l] * products[apart] *
                      std::cos(2.0 * core::pi * cycles * static_cast<double>(apart));
      }
  }
  return gains;
}

SearchTargets::SearchTargets(const PulseRows& rows, const SearchOptions& options)
    : rows_(rows),
      options_(options),
      geometry_(*rows.acquisition->scene, rows.acquisition->link),
      gain_(*rows.acquisition, rows.samples(), rows.acquisition->link.window),
      weights_(signal::pulse_weights(coherent_interval(options))),
      differences_(signal::canceller_weights(options.canceller)),
      pulses_v_(options.pulses),
      look_pulses_(pulses_of_look(options)),
      looks_((options.recorded_pulses() + look_pulses_ - 1) / look_pulses_),
      prf_hz_(1.0 / rows.acquisition->link.repetition.mean_interval_s()) {
  cell_m_ = radar::range_of(std::max(1.0 / radar::bandwidth_hz(rows.acquisition->link.pulse),
                                     rows.acquisition->reception.raw_grid.interval_s),
                            rows.acquisition->light_speed_mps());
  noise_w_ = noise_gains(weights_, options.canceller, options.rows());
  for (double& noise_w : noise_w_) noise_w *= rows.noise_w;
  if (options.detect && rows.noise_w > 0.0)
    certain_snr_ = even_snr(equivalent_detector(detector_of(rows, options), options.rows(), rows.samples()),
                            options.rows(), rows.samples());
  half_beam_rad_ = half_beam_rad(*rows.acquisition);
  // An antenna that sees all directions says with single pulses nothing of where a target is, but where it points to.
  constexpr double still_widths = 1.5;
  if (!half_beam_rad_ && options.recorded_pulses() == 1 && !beam_turns(*rows.acquisition))
    half_beam_rad_ = still_widths * seen_width_rad(*rows.acquisition);
  targets_.resize(std::min(most, rows.acquisition->scene->scatterers.size()));
  for (std::size_t t = 0; t < targets_.size(); ++t) targets_[t].target = t;
}

// Some targets at a time, which bounds what is held of a long interval.
std::vector<TargetVisibility> SearchTargets::sights(const SearchInterval& interval) {
  constexpr std::size_t max_held = std::size_t{1} << 18;
  const std::size_t at_once = std::max<std::size_t>(1, max_held / looks_);
  std::vector<TargetVisibility> sights(targets_.size());
  for (std::size_t first = 0; first < sights.size(); first += at_once) {
    const std::span<TargetVisibility> some = std::span(sights).subspan(first, std::min(at_once, sights.size() - first));
    look(interval, first, some);
    for (std::size_t t = 0; t < some.size(); ++t)
      place(interval, std::span<const double>(amplitudes_v_).subspan(t * looks_, looks_), some[t]);
  }
  return sights;
}

// Where the targets from `first` on are in the interval, and the amplitudes of their echoes, look by look.
void SearchTargets::look(const SearchInterval& interval, std::size_t first, std::span<TargetVisibility> sights) {
  const simulate::ResolvedScene& scene = *rows_.acquisition->scene;
  const double light_speed_mps = scene.conventions.light_speed_mps;
  const std::size_t pulses = options_.recorded_pulses();
  amplitudes_v_.resize(sights.size() * looks_);
  for (std::size_t look = 0; look < looks_; ++look) {
    const std::size_t begin = look * look_pulses_;
    const std::size_t length = std::min(look_pulses_, pulses - begin);
    const std::size_t pulse = begin + length / 2;
    const double share = static_cast<double>(length) / static_cast<double>(pulses);
    geometry_.set_pulse(rows_.number(interval.first_pulse + pulse));
    const radar::Pointing pointing = geometry_.pointing();
    for (std::size_t t = 0; t < sights.size(); ++t) {
      const simulate::ScattererView view = geometry_.view(first + t, pointing);
      TargetVisibility& sight = sights[t];
      sight.range_m += radar::range_of(view.delay_s, share * light_speed_mps);
      sight.doppler_hz += radar::doppler_of(share * view.speed_mps, geometry_.carrier_hz(), light_speed_mps);
      amplitudes_v_[t * looks_ + look] =
          rows_.peak_gain * view.amplitude_sqrt_w * gain_.gain(view.delay_s) * gain_.held(view.delay_s);
      if (look != looks_ / 2) continue;
      const simulate::Scatterer& scatterer = scene.scatterers[first + t];
      sight.azimuth_rad =
          core::azimuth_rad(radar::world_position_m(geometry_.pose(scatterer.platform), scatterer.position_m) -
                            geometry_.radar_pose().position_world_m);
    }
  }
}

// The cell, and what of the echoes' amplitudes and of the noise comes there.
void SearchTargets::place(const SearchInterval& interval, std::span<const double> amplitudes_v,
                          TargetVisibility& sight) {
  sight.interval = interval.number;
  sight.time_s = interval.time_s;
  // A chirp that is shifted in frequency peaks early or late (docs/theory/compression.md).
  const double rate = rows_.acquisition->link.pulse.sweep_rate_hz_per_s();
  if (rate != 0.0) sight.range_m -= radar::range_of(sight.doppler_hz, rows_.acquisition->light_speed_mps()) / rate;
  const double step_m = rows_.samples() > 1 ? rows_.range_m[1] - rows_.range_m[0] : cell_m_;
  sight.in_window =
      sight.range_m > rows_.range_m.front() - 0.5 * step_m && sight.range_m < rows_.range_m.back() + 0.5 * step_m;
  sight.column = nearest_index(rows_.range_m, sight.range_m);
  take_pulses(amplitudes_v, sight.doppler_hz);
  if (options_.pulses > 1)
    take_strongest_row(interval, sight);
  else
    sight.amplitude_v = response(sight.doppler_hz, 0.0);
  if (!(sight.amplitude_v > 0.0)) return;
  const double delay_s = radar::delay_of(rows_.range_m[sight.column], rows_.acquisition->light_speed_mps());
  const double noise_w = noise_w_[sight.row] * gain_.noise(delay_s);
  sight.snr = noise_w > 0.0 ? sight.amplitude_v * sight.amplitude_v / noise_w : infinity;
}

// The echoes of one target behind the canceller, but for the turn of the Doppler frequency from one output to the next.
void SearchTargets::take_pulses(std::span<const double> amplitudes_v, double doppler_hz) {
  const std::complex<double> step = std::polar(1.0, 2.0 * core::pi * doppler_hz / prf_hz_);
  for (std::size_t p = 0; p < pulses_v_.size(); ++p) {
    std::complex<double> sum;
    // Horner's rule: equal echoes of a resting target leave exactly nothing.
    for (std::size_t k = differences_.size(); k-- > 0;) {
      sum = sum * step + differences_[k] * amplitudes_v[(p + k) / look_pulses_];
    }
    pulses_v_[p] = sum;
  }
}

// That of the Doppler frequency; behind a canceller, which takes away its middle, one beside it may be higher.
void SearchTargets::take_strongest_row(const SearchInterval& interval, TargetVisibility& sight) const {
  constexpr double rounding = 1e-9;
  sight.seen_doppler_hz = folded(sight.doppler_hz, prf_hz_);
  const auto rows = static_cast<std::ptrdiff_t>(options_.rows());
  const auto middle = static_cast<std::ptrdiff_t>(
      std::round((sight.seen_doppler_hz - interval.map.first_doppler_hz) / interval.map.doppler_step_hz));
  const auto take = [&](std::ptrdiff_t wanted) {
    const auto row = static_cast<std::size_t>(((wanted % rows) + rows) % rows);
    const double amplitude_v = response(sight.doppler_hz, interval.map.doppler_hz(row));
    if (wanted != middle && !(amplitude_v > (1.0 + rounding) * sight.amplitude_v)) return;
    sight.row = row;
    sight.amplitude_v = amplitude_v;
  };
  take(middle);
  if (options_.canceller == 0) return;
  const auto reach = rows / static_cast<std::ptrdiff_t>(options_.pulses);
  for (std::ptrdiff_t away = 1; away <= reach; ++away) {
    take(middle - away);
    take(middle + away);
  }
}

// Of the pulses that were taken, summed for one Doppler frequency, to another one.
double SearchTargets::response(double doppler_hz, double cell_hz) const {
  const std::complex<double> step = std::polar(1.0, 2.0 * core::pi * (doppler_hz - cell_hz) / prf_hz_);
  std::complex<double> sum;
  for (std::size_t p = weights_.size(); p-- > 0;) sum = sum * step + weights_[p] * pulses_v_[p];
  return std::abs(sum);
}

// Of a detection from a target, in cells; no number where that is too far.
double SearchTargets::distance(const SearchDetection& detection, const TargetVisibility& sight) const {
  constexpr double reach = 1.5;
  const double ranges = std::abs(detection.range_m - sight.range_m) / cell_m_;
  double dopplers = 0.0;
  if (options_.pulses > 1)
    dopplers = std::abs(folded(detection.doppler_hz - sight.seen_doppler_hz, prf_hz_)) *
               static_cast<double>(options_.pulses) / prf_hz_;
  return ranges <= reach && dopplers <= reach ? std::hypot(ranges, dopplers) : infinity;
}

// Range and Doppler do not tell targets in different directions apart: one that the beam does not see in the interval
// is not what was detected. High beams sweep a wider azimuth than their width.
bool SearchTargets::beside_beam(const SearchInterval& interval, const TargetVisibility& sight) const {
  constexpr double min_cosine = 0.02;
  if (!half_beam_rad_) return false;
  const core::Vec3& beam = interval.beam_world;
  const double cosine = std::max(std::hypot(beam.x, beam.y), min_cosine);
  const double away_rad = std::remainder(sight.azimuth_rad - core::azimuth_rad(beam), 2.0 * core::pi);
  return std::abs(away_rad) > interval.half_sector_rad + *half_beam_rad_ / cosine;
}

// What all targets whose cells are within reach of a detection should give there, beside the beam or not: an antenna's
// side lobe shows a strong target in the direction of another one.
SearchTargets::Strengths SearchTargets::strengths_at(const SearchDetection& detection,
                                                     const std::vector<TargetVisibility>& seen) const {
  Strengths there;
  for (const TargetVisibility& sight : seen) {
    if (!sight.in_window || !(sight.amplitude_v > 0.0) || distance(detection, sight) == infinity) continue;
    there.sum_v += sight.amplitude_v;
    there.largest_v = std::max(there.largest_v, sight.amplitude_v);
  }
  return there;
}

// Whether a detection is as strong as the target can be there: no more than 3 dB and three deviations of the noise
// above what all targets give together, of which the target gives half as much as the largest or more, and no more than
// 20 dB below what the target gives, which is spread over the cells that it passes.
bool SearchTargets::fits(const SearchDetection& detection, const TargetVisibility& sight,
                         const Strengths& there) const {
  constexpr double min_of_largest = 0.5;
  constexpr double min_of_expected = 0.1;
  constexpr double deviations = 3.0;
  if (sight.amplitude_v < min_of_largest * there.largest_v) return false;
  const double noise_v = deviations * sight.amplitude_v / std::sqrt(sight.snr);
  if (detection.magnitude_v > std::numbers::sqrt2 * there.sum_v + noise_v) return false;
  const double wavelength_m = radar::wavelength_of(geometry_.carrier_hz(), rows_.acquisition->light_speed_mps());
  const double passed_m =
      0.5 * wavelength_m * std::abs(sight.doppler_hz) * static_cast<double>(options_.recorded_pulses()) / prf_hz_;
  const double cells = 1.0 + passed_m / cell_m_;
  return detection.magnitude_v + noise_v >= min_of_expected * sight.amplitude_v / cells;
}

std::vector<std::optional<std::size_t>> SearchTargets::take(const SearchInterval& interval) {
  std::vector<std::optional<std::size_t>> of(interval.detections.size());
  std::vector<double> nearest(interval.detections.size(), infinity);
  const std::vector<TargetVisibility> seen_now = sights(interval);
  std::vector<Strengths> strengths;
  for (const SearchDetection& detection : interval.detections) strengths.push_back(strengths_at(detection, seen_now));
  for (TargetFinding& finding : targets_) {
    const TargetVisibility& seen = seen_now[finding.target];
    if (!seen.in_window) continue;
    if (!finding.sight.in_window || seen.amplitude_v > finding.sight.amplitude_v) finding.sight = seen;
    if (!(seen.amplitude_v > 0.0) || beside_beam(interval, seen)) continue;
    if (certain_snr_ > 0.0 && seen.snr >= certain_snr_) ++finding.expected;
    for (std::size_t d = 0; d < of.size(); ++d) {
      const double away = distance(interval.detections[d], seen);
      if (!(away < nearest[d]) || !fits(interval.detections[d], seen, strengths[d])) continue;
      nearest[d] = away;
      of[d] = finding.target;
    }
  }
  for (TargetFinding& finding : targets_) {
    bool found = false;
    for (std::size_t d = 0; d < of.size(); ++d) {
      if (of[d] != finding.target) continue;
      found = true;
      const SearchDetection& detection = interval.detections[d];
      if (finding.best && !(detection.magnitude_v > finding.best->magnitude_v)) continue;
      finding.best = detection;
      finding.best_range_error_m = detection.range_m - seen_now[finding.target].range_m;
    }
    if (found) ++finding.found;
  }
  return of;
}

std::vector<TargetFinding> SearchTargets::findings() const {
  std::vector<TargetFinding> findings = targets_;
  const signal::CfarOptions cfar = equivalent_detector(detector_of(rows_, options_), options_.rows(), rows_.samples());
  for (TargetFinding& finding : findings)
    if (certain_snr_ > 0.0 && finding.sight.in_window)
      finding.probability = steady_probability(cfar, options_.rows(), rows_.samples(), finding.sight.snr);
  return findings;
}

}  // namespace sarsim::workflow
