#include "signal/sar/focus_frame.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/sinc_table.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "signal/row/sinc_row.hpp"

namespace sarsim::signal {

namespace {

// Samples of a range row with what each method needs beyond those recorded.
std::size_t padded_samples(const FocusFrame& frame) {
  switch (frame.options.method) {
    case FocusMethod::omega_k:
      return std::max(static_cast<std::size_t>(std::ceil(frame.row_samples * 4.0 / 3.0)), frame.range.count) +
             core::SincTable::taps;
    case FocusMethod::chirp_scaling:
      return frame.samples + static_cast<std::size_t>(std::ceil(dispersed_samples(frame.waveform))) +
             core::SincTable::taps;
    case FocusMethod::range_doppler: break;
  }
  return frame.samples + 2 * core::SincTable::taps;
}

// Closest distances of points that the recorded ranges hold in some direction whose Doppler frequency the pulses tell.
AxisInterval recordable_ranges(const FocusFrame& frame) {
  const double c = frame.waveform.light_speed_mps;
  const double near_m = radar::range_of(frame.first_delay_s, c);
  const double far_m = near_m + radar::range_of(static_cast<double>(frame.samples) / frame.waveform.sample_rate_hz, c);
  const double half_hz = 0.5 * frame.prf_hz();
  const auto sine_at = [&](double way) {
    return std::clamp(frame.sine(frame.options.doppler_centroid_hz + way * half_hz), -max_sine, max_sine);
  };
  const double low = sine_at(-1.0);
  const double high = sine_at(1.0);
  const double least = low < 0.0 && high > 0.0 ? 0.0 : std::min(std::abs(low), std::abs(high));
  const double most = std::max(std::abs(low), std::abs(high));
  return {near_m * std::sqrt(1.0 - most * most), far_m * std::sqrt(1.0 - least * least)};
}

// Adds columns so that the image covers an interval, as far as it can be recorded.
void reach_ranges(FocusFrame& frame, const std::optional<AxisInterval>& wanted) {
  if (!wanted || frame.options.method == FocusMethod::chirp_scaling) return;
  const AxisInterval recordable = recordable_ranges(frame);
  const double first_m = std::max({wanted->first_m, recordable.first_m, frame.range.step_m});
  const double last_m = std::min(wanted->last_m, recordable.last_m);
  if (!(first_m <= last_m)) return;
  ImageAxis& axis = frame.range;
  const double end = static_cast<double>(axis.count) - 1.0;
  const double before = std::min(0.0, std::floor(axis.index_of(first_m)));
  const double last = std::max(end, std::ceil(axis.index_of(last_m)));
  axis.first_m = axis.at(before);
  axis.count = static_cast<std::size_t>(last - before) + 1;
}

void set_range_axis(FocusFrame& frame) {
  const double c = frame.waveform.light_speed_mps;
  const double fs = frame.waveform.sample_rate_hz;
  const double cosine = frame.centroid_cosine;
  const bool scaled = frame.options.method == FocusMethod::chirp_scaling;
  frame.range.first_m = radar::range_of(frame.first_delay_s, c) * cosine;
  frame.range.step_m = radar::range_of_cycle(fs, c) * (scaled ? cosine : 1.0);
  const double samples = static_cast<double>(frame.samples);
  frame.range.count = scaled ? frame.samples : static_cast<std::size_t>(std::ceil(samples * cosine));
  frame.range.spectrum_centre_per_m = radar::turns_of(cosine - 1.0, frame.waveform.carrier_hz, c);
  frame.reference_range_m = frame.range.at(0.5 * static_cast<double>(frame.range.count));
  frame.range_middle_hz = frame.waveform.carrier_hz * (cosine - 1.0);
  reach_ranges(frame, frame.options.range_reach);
  reach_ranges(frame, frame.options.range_area);
}

// Pulses by which the beam's centre meets a target before (positive: the target lies ahead) its closest approach.
double lead_pulses(const FocusFrame& frame, double range_m) {
  const double tangent = frame.sine(frame.options.doppler_centroid_hz) / frame.centroid_cosine;
  return range_m * tangent / frame.track.speed_mps * frame.prf_hz();
}

// By how much the Doppler frequency of a far target falls in a second.
double far_rate_hzps(const FocusFrame& frame) {
  const double far_m = frame.range.at(static_cast<double>(frame.range.count)) / std::pow(frame.centroid_cosine, 3);
  return 2.0 * std::pow(frame.track.speed_mps, 2) / (frame.wavelength_m() * far_m);
}

// Pulses over which echoes of a target sweep half the band between two of its images.
double half_band_pulses(const FocusFrame& frame) {
  const double band_hz = frame.options.doppler_bandwidth_hz > 0.0 ? frame.options.doppler_bandwidth_hz : frame.prf_hz();
  return 0.5 * band_hz / far_rate_hzps(frame) * frame.prf_hz();
}

// The part of them that one flight can see.
double half_aperture_pulses(const FocusFrame& frame) {
  return std::min(half_band_pulses(frame), static_cast<double>(frame.pulses));
}

// Largest tangent of a direction in which a pulse meets a point of the image.
double farthest_tangent(const FocusFrame& frame) {
  const double last = static_cast<double>(frame.first_row) + static_cast<double>(frame.azimuth.count);
  const double ahead =
      std::max(std::abs(last), std::abs(static_cast<double>(frame.first_row) - static_cast<double>(frame.pulses)));
  return ahead * frame.track.speed_mps * frame.track.interval_s / std::max(frame.range.at(0.0), frame.range.step_m);
}

// What a target's echoes reach beyond the Doppler frequencies of the directions it is seen in: four Fresnel zones and
// three cells of resolution.
double blurred_pulses(const FocusFrame& frame) {
  const double rate_hzps = far_rate_hzps(frame);
  const double flight_s = static_cast<double>(frame.pulses) * frame.track.interval_s;
  return (4.0 / std::sqrt(rate_hzps) + 3.0 / (rate_hzps * flight_s)) * frame.prf_hz();
}

// And what the direction of a Doppler frequency changes over the band moves them by.
double turned_pulses(const FocusFrame& frame) {
  const double tangent = farthest_tangent(frame);
  const double far_m = frame.range.at(static_cast<double>(frame.range.count));
  const double turned_m = frame.half_band_share() * tangent * (1.0 + tangent * tangent) * far_m;
  return turned_m / frame.track.speed_mps * frame.prf_hz();
}

// Adds rows so that the image covers an area.
void reach_area(FocusFrame& frame, const AxisInterval& area) {
  const auto row_at = [&](double azimuth_m) {
    return azimuth_m / frame.azimuth.step_m + static_cast<double>(frame.track.middle_pulse);
  };
  const auto end = frame.first_row + static_cast<std::ptrdiff_t>(frame.azimuth.count);
  frame.first_row = std::min(frame.first_row, static_cast<std::ptrdiff_t>(std::floor(row_at(area.first_m))));
  const auto last = std::max(end, static_cast<std::ptrdiff_t>(std::ceil(row_at(area.last_m))) + 1);
  frame.azimuth.count = static_cast<std::size_t>(last - frame.first_row);
}

void set_azimuth_axis(FocusFrame& frame) {
  const double near = lead_pulses(frame, frame.range.at(0.0));
  const double far = lead_pulses(frame, frame.range.at(static_cast<double>(frame.range.count)));
  const double half_aperture = half_aperture_pulses(frame);
  // Targets beside the record's ends still have half their aperture in it: their responses are to be seen whole.
  const double margin = std::min(half_aperture, static_cast<double>(frame.pulses) / 8.0);
  frame.first_row = static_cast<std::ptrdiff_t>(std::floor(std::min(near, far) - margin));
  frame.azimuth.count = frame.pulses + static_cast<std::size_t>(std::ceil(std::abs(far - near) + 2.0 * margin));
  frame.azimuth.step_m = frame.track.speed_mps * frame.track.interval_s;
  if (frame.options.azimuth_reach) reach_area(frame, *frame.options.azimuth_reach);
  if (frame.options.azimuth_area) reach_area(frame, *frame.options.azimuth_area);
  frame.azimuth.first_m = frame.track.speed_mps * frame.track.time_s(static_cast<double>(frame.first_row));
  frame.azimuth.spectrum_centre_per_m = frame.options.doppler_centroid_hz / frame.track.speed_mps;
  // What lies beyond the image and one flight and a blur more is kept out of it.
  const double blurred = blurred_pulses(frame);
  const double reach = static_cast<double>(frame.pulses) + blurred + turned_pulses(frame);
  const double beyond = std::min(half_band_pulses(frame), reach);
  frame.azimuth_size = core::fast_fft_size(frame.azimuth.count + static_cast<std::size_t>(std::ceil(beyond)));
  frame.blur_m = blurred * frame.track.speed_mps * frame.track.interval_s;
  frame.doppler_middle_hz = frame.options.doppler_centroid_hz;
}

// The size of a transform back that gives samples `wanted_m` apart, or closer, if `size` gives `step_m`.
std::size_t upsampled_size(std::size_t size, double step_m, double wanted_m) {
  return wanted_m < step_m
             ? core::fast_fft_size(static_cast<std::size_t>(std::ceil(static_cast<double>(size) * step_m / wanted_m)))
             : size;
}

// Makes the samples of an axis closer by a factor.
void divide(ImageAxis& axis, double by) {
  axis.step_m /= by;
  axis.count = static_cast<std::size_t>(std::ceil(static_cast<double>(axis.count) * by));
}

void fit_range(FocusFrame& frame, const SpectrumExtent& extent) {
  ImageAxis& axis = frame.range;
  if (holds(axis, extent)) return;
  frame.image_bins = upsampled_size(frame.range_size, axis.step_m, step_for(axis, extent));
  divide(axis, static_cast<double>(frame.image_bins) / static_cast<double>(frame.range_size));
  axis.spectrum_centre_per_m = extent.middle_per_m();
  frame.range_middle_hz = radar::range_of(extent.middle_per_m(), frame.waveform.light_speed_mps);
}

void fit_azimuth(FocusFrame& frame, const SpectrumExtent& extent) {
  ImageAxis& axis = frame.azimuth;
  if (holds(axis, extent)) return;
  frame.unfolds = true;
  frame.image_rows = upsampled_size(frame.azimuth_size, axis.step_m, step_for(axis, extent));
  const double by = static_cast<double>(frame.image_rows) / static_cast<double>(frame.azimuth_size);
  divide(axis, by);
  frame.first_row = static_cast<std::ptrdiff_t>(std::floor(static_cast<double>(frame.first_row) * by));
  axis.first_m = frame.track.speed_mps * frame.track.time_s(static_cast<double>(frame.first_row) / by);
  axis.spectrum_centre_per_m = extent.middle_per_m();
  frame.doppler_middle_hz = axis.spectrum_centre_per_m * frame.track.speed_mps;
}

// The part of an axis that lies in the area.
ImageAxis part_of(const ImageAxis& axis, const std::optional<AxisInterval>& area, std::size_t& hidden) {
  if (!area) return axis;
  const double last_m = axis.at(static_cast<double>(axis.count) - 1.0);
  ImageAxis part = axis;
  const std::ptrdiff_t first = cut_axis(part, {std::max(area->first_m, axis.first_m), std::min(area->last_m, last_m)});
  hidden = part.count > 0 ? static_cast<std::size_t>(first) : 0;
  return part;
}

// Closest distances that are shown and recorded where the line of sight has this cosine.
struct StoltSpan {
  double cosine = 1.0;
  double min_m = 0.0;
  double max_m = 0.0;

  // Of the echoes of the nearest from those of a reference, and of the farthest.
  [[nodiscard]] double below_m(double reference_m) const { return (reference_m - min_m) / cosine; }
  [[nodiscard]] double above_m(double reference_m) const { return (max_m - reference_m) / cosine; }
};

// Those of one Doppler frequency at the lowest, the middle and the highest frequency of the pulse: an echo of the
// closest distance R stands (R - Rr)/D behind that of the reference Rr, D the cosine there.
struct StoltSpans {
  static constexpr double spare = 1.02;  // by which the span of a row may be wider than its samples
  std::vector<StoltSpan> spans;

  [[nodiscard]] const StoltSpan& lowest(double reference_m) const {
    return *std::ranges::max_element(spans, {}, [&](const StoltSpan& span) { return span.below_m(reference_m); });
  }
  [[nodiscard]] const StoltSpan& highest(double reference_m) const {
    return *std::ranges::max_element(spans, {}, [&](const StoltSpan& span) { return span.above_m(reference_m); });
  }
  [[nodiscard]] double half_span_m(double reference_m) const {
    if (spans.empty()) return 0.0;
    return std::max(lowest(reference_m).below_m(reference_m), highest(reference_m).above_m(reference_m));
  }
};

StoltSpans spans_of(const FocusFrame& frame, double doppler_hz) {
  constexpr double min_cosine = 1e-3;
  const SarWaveform& wave = frame.waveform;
  const double near_m = radar::range_of(frame.first_delay_s, wave.light_speed_mps);
  const double far_m =
      near_m + radar::range_of(static_cast<double>(frame.samples) / wave.sample_rate_hz, wave.light_speed_mps);
  StoltSpans spans;
  for (const double part : {-1.0, 0.0, 1.0}) {
    const double sine = frame.sine(doppler_hz) / (1.0 + part * frame.half_band_share());
    if (!(std::abs(sine) < 1.0)) continue;
    const StoltSpan span{.cosine = std::sqrt(1.0 - sine * sine),
                         .min_m = std::max(near_m * std::sqrt(1.0 - sine * sine), frame.range.at(0.0)),
                         .max_m = std::min(far_m * std::sqrt(1.0 - sine * sine),
                                           frame.range.at(static_cast<double>(frame.range.count)))};
    if (span.cosine > min_cosine && span.max_m > span.min_m) spans.spans.push_back(span);
  }
  return spans;
}

// The two halves of a transform's bins, in steps.
FrequencyRuns halves(std::size_t size, double step_hz) {
  const std::size_t positive = (size + 1) / 2;
  const double first_hz = -step_hz * static_cast<double>(size - positive);
  return {{{0, positive, 0.0, step_hz}, {positive, size - positive, first_hz, step_hz}}};
}

// Frequency of a transform's bin in steps: the second half is negative.
double signed_bin(std::size_t bin, std::size_t size) {
  const auto number = static_cast<double>(bin);
  return 2 * bin < size ? number : number - static_cast<double>(size);
}

}  // namespace

double FocusFrame::doppler_hz(std::size_t row) const {
  CORE_EXPECT(row < image_rows);
  const double base_hz = static_cast<double>(row) / static_cast<double>(azimuth_size) * prf_hz();
  const double period_hz = static_cast<double>(image_rows) / static_cast<double>(azimuth_size) * prf_hz();
  const double folds = std::floor((doppler_middle_hz - base_hz) / period_hz + 0.5);
  return base_hz + folds * period_hz;
}

// Of the second order in V/c, which the Doppler shift of radar/path does not have.
double FocusFrame::motion_doppler_hz(double hz) const {
  return 2.0 * hz * std::pow(track.speed_mps / waveform.light_speed_mps, 2);
}

FocusFrame::Sines FocusFrame::sines_at(double range_m) const {
  CORE_EXPECT(range_m > 0.0);
  const double first_m = track.speed_mps * track.time_s(0.0);
  const double last_m = track.speed_mps * track.time_s(static_cast<double>(pulses) - 1.0);
  const double behind_m = azimuth.first_m - last_m;
  const double ahead_m = azimuth.at(static_cast<double>(azimuth.count)) - first_m;
  // A Doppler frequency is that of the direction sin a at the carrier, and of sin a (f0 + f)/f0 at another frequency.
  const double share = half_band_share();
  const auto sine = [&](double along_m, double way) {
    const double of_direction = along_m / std::hypot(range_m, along_m);
    return of_direction + way * share * std::abs(of_direction);
  };
  Sines seen{
      .low = sine(behind_m - blur_m, -1.0), .high = sine(ahead_m + blur_m, 1.0), .low_edge = 0.0, .high_edge = 0.0};
  seen.low_edge = sine(behind_m - 0.5 * blur_m, -1.0) - seen.low;
  seen.high_edge = seen.high - sine(ahead_m + 0.5 * blur_m, 1.0);
  return seen;
}

FocusFrame::RowReference FocusFrame::row_reference(double doppler_hz) const {
  const StoltSpans spans = spans_of(*this, doppler_hz);
  const double recorded_m =
      radar::range_of(static_cast<double>(samples) / waveform.sample_rate_hz, waveform.light_speed_mps);
  RowReference found{reference_range_m, spans.half_span_m(reference_range_m)};
  // Where the middle of the swath does, it is the reference of all rows.
  if (found.half_span_m <= StoltSpans::spare * 0.5 * recorded_m) return found;
  constexpr int rounds = 4;
  for (int i = 0; i < rounds; ++i) {
    const StoltSpan& low = spans.lowest(found.range_m);
    const StoltSpan& high = spans.highest(found.range_m);
    found.range_m = (high.max_m * low.cosine + low.min_m * high.cosine) / (low.cosine + high.cosine);
  }
  found.half_span_m = spans.half_span_m(found.range_m);
  return found;
}

double FocusFrame::sine(double doppler_hz) const {
  return -radar::speed_of(doppler_hz, wavelength_m()) / track.speed_mps;
}

double FocusFrame::range_hz(std::size_t bin) const {
  const double step_hz = waveform.sample_rate_hz / static_cast<double>(range_size);
  return step_hz * signed_bin(bin, range_size);
}

double FocusFrame::image_hz(std::size_t bin) const {
  return waveform.sample_rate_hz / static_cast<double>(range_size) * signed_bin(bin, image_bins);
}

FrequencyRuns FocusFrame::range_runs() const {
  return halves(range_size, waveform.sample_rate_hz / static_cast<double>(range_size));
}

FrequencyRuns FocusFrame::image_runs() const {
  return halves(image_bins, waveform.sample_rate_hz / static_cast<double>(range_size));
}

FrequencyRuns FocusFrame::doppler_runs() const {
  const double step_hz = prf_hz() / static_cast<double>(azimuth_size);
  std::size_t fold = 1;
  while (fold < image_rows && doppler_hz(fold) > doppler_hz(fold - 1)) ++fold;
  const double folded_hz = fold < image_rows ? doppler_hz(fold) : 0.0;
  return {{{0, fold, doppler_hz(0), step_hz}, {fold, image_rows - fold, folded_hz, step_hz}}};
}

double FocusFrame::early_s(double doppler_hz) const {
  constexpr double min_turns = 5e-4;  // over the band
  const double delay_s = doppler_hz * waveform.pulse_width_s / waveform.bandwidth_hz;
  return std::abs(delay_s * waveform.bandwidth_hz) < min_turns ? 0.0 : delay_s;
}

RowRoom::RowRoom(const FocusFrame& frame)
    : turns(frame.row_length()),
      factors(frame.row_length()),
      whole(frame.row_length()),
      step(frame.row_length()),
      padded(frame.range_size + 2 * SincRow::margin) {}

namespace {

// The widest span of echoes that a row is interpolated for, in samples: that of those recorded, and more where one
// Doppler frequency has directions of very different cosines over the band. Bounded: what does not fit is lost.
double widest_row_samples(const FocusFrame& frame) {
  constexpr int steps = 64;
  constexpr double max_times = 4.0;
  const double recorded = static_cast<double>(frame.samples);
  const SarWaveform& wave = frame.waveform;
  const double spectrum_hz =
      frame.options.spectrum ? frame.options.spectrum->azimuth.width_per_m() * frame.track.speed_mps : 0.0;
  const double width_hz = std::max(frame.prf_hz(), spectrum_hz);
  const FocusFrame::Sines shown = frame.sines_at(std::max(frame.range.at(0.0), frame.range.step_m));
  double widest = recorded;
  for (int i = 0; i <= steps; ++i) {
    const double doppler_hz = frame.doppler_middle_hz + width_hz * (static_cast<double>(i) / steps - 0.5);
    if (const double sine = frame.sine(doppler_hz); sine < shown.low || sine > shown.high) continue;
    const double half_s = radar::delay_of(frame.row_reference(doppler_hz).half_span_m, wave.light_speed_mps);
    widest = std::max(widest, 2.0 * half_s * wave.sample_rate_hz);
  }
  return widest <= StoltSpans::spare * recorded ? recorded : std::min(widest, max_times * recorded);
}

}  // namespace

FocusFrame focus_frame(const EchoRows& echoes, const FocusOptions& options) {
  CORE_EXPECT(echoes.track.size() >= 2);
  CORE_EXPECT(echoes.waveform.sample_rate_hz > 0.0);
  CORE_EXPECT(echoes.waveform.light_speed_mps > 0.0);
  CORE_EXPECT(echoes.waveform.carrier_hz > 0.0);
  FocusFrame frame;
  frame.waveform = echoes.waveform;
  frame.track = fit_straight(echoes.track);
  frame.options = options;
  if (echoes.azimuth_zero_m)
    frame.azimuth_zero_m = core::dot(*echoes.azimuth_zero_m - frame.track.origin_m, frame.track.along);
  for (std::optional<AxisInterval>* area : {&frame.options.azimuth_area, &frame.options.azimuth_reach})
    if (*area) {
      (*area)->first_m += frame.azimuth_zero_m;
      (*area)->last_m += frame.azimuth_zero_m;
    }
  frame.pulses = echoes.track.size();
  frame.samples = echoes.columns;
  frame.first_delay_s = echoes.first_delay_s;
  const double sine = frame.sine(options.doppler_centroid_hz);
  frame.centroid_cosine = std::sqrt(1.0 - sine * sine);
  set_range_axis(frame);
  set_azimuth_axis(frame);
  frame.row_samples =
      options.method == FocusMethod::omega_k ? widest_row_samples(frame) : static_cast<double>(frame.samples);
  frame.range_size = core::fast_fft_size(padded_samples(frame));
  frame.image_rows = frame.azimuth_size;
  frame.image_bins = frame.range_size;
  if (options.spectrum) fit_range(frame, options.spectrum->range);
  if (options.spectrum) fit_azimuth(frame, options.spectrum->azimuth);
  frame.shown_azimuth = part_of(frame.azimuth, frame.options.azimuth_area, frame.hidden_rows);
  frame.shown_range = part_of(frame.range, options.range_area, frame.hidden_columns);
  return frame;
}

void weigh_by_frequency(const FocusFrame& frame, double sine, std::span<std::complex<float>> bins,
                        const FrequencyRuns& runs, std::span<float> factors) {
  const double f0 = frame.waveform.carrier_hz;
  const double cosine_squared = 1.0 - sine * sine;
  // The factor is (F/f0)^-q for small f, q = 1/2 + 3/2 tan^2 a; its mean over the band 1 + q (q + 1)/6 (B/2 f0)^2.
  const double power = 0.5 + 1.5 * sine * sine / cosine_squared;
  constexpr double least = 1e-3;
  if (power * (power + 1.0) / 6.0 * std::pow(frame.half_band_share(), 2) < least) return;
  const auto factor_at = [&](double hz) {
    const double stretch = 1.0 + hz / f0;
    const double there = stretch > 0.0 ? 1.0 - std::pow(sine / stretch, 2) : 0.0;
    if (!(there > 1.0 - max_sine * max_sine)) return 0.0;
    return std::pow(cosine_squared / there, 0.75) / std::sqrt(stretch);
  };
  for (const FrequencyRun& run : runs)
    for (std::size_t k = 0; k < run.count; ++k)
      factors[run.begin + k] = static_cast<float>(factor_at(run.hz(static_cast<double>(k))));
  scale_row(bins, factors.first(bins.size()), 1.0F);
}

double dispersed_samples(const SarWaveform& waveform) {
  CORE_EXPECT(waveform.sample_rate_hz >= 0.0);
  return dispersed_time_bandwidth * std::pow(waveform.sample_rate_hz / waveform.bandwidth_hz, 2);
}

double secondary_turns(const FocusFrame& frame, double range_hz, double sine, double cosine) {
  // Without the difference of two large numbers: with s = sqrt(...), s - f0 D = (s^2 - f0^2 D^2)/(s + f0 D).
  const double f0 = frame.waveform.carrier_hz;
  const double beta = frame.track.speed_mps / frame.waveform.light_speed_mps;
  const double along = f0 * sine + range_hz * beta;
  const double root = std::sqrt(std::max(0.0, (f0 + range_hz) * (f0 + range_hz) - along * along));
  const double square = (2.0 * f0 * (1.0 - sine * beta) + range_hz * (1.0 - beta * beta)) * range_hz;
  const double beyond = square / (root + f0 * cosine) - range_hz / cosine;
  return radar::delay_of(frame.reference_range_m, frame.waveform.light_speed_mps) * beyond;
}

}  // namespace sarsim::signal
