#include "signal/stepped/isar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

// Delay of the target's centre, at the origin of its frame.
double centre_delay_s(const TrackPoint& from, double light_speed_mps) {
  const double d = core::norm(from.position_m);
  const double v = core::dot(from.position_m, from.velocity_mps) / d;
  return radar::moving_delay_of(radar::there_and_back(d), v, light_speed_mps);
}

double repetition_hz(const std::vector<TrackPoint>& track) {
  const double span_s = track.back().time_s - track.front().time_s;
  core::expect(span_s > 0.0, "range-Doppler map: the times of the pulses do not ascend");
  return static_cast<double>(track.size() - 1) / span_s;
}

std::size_t step_of(const CoherentInterval& interval) {
  core::expect(interval.pulses > 0, "images of a turning target: a burst has no pulses");
  return interval.step > 0 ? interval.step : interval.pulses;
}

// Zeros of a transform beyond the largest shift, between the end of a pulse and its beginning.
constexpr std::size_t guard_samples = 32;

// By how many samples the centre's echo moves in a burst, at most to where pulses leave their window.
std::size_t largest_shift(const SarEchoes& seen, std::size_t pulses, std::size_t step) {
  double max_s = 0.0;
  for (std::size_t first = 0; first + pulses <= seen.track.size(); first += step) {
    const double middle_s = centre_delay_s(seen.track[first + pulses / 2], seen.waveform.light_speed_mps);
    for (std::size_t p = first; p < first + pulses; ++p)
      max_s = std::max(max_s, std::abs(centre_delay_s(seen.track[p], seen.waveform.light_speed_mps) - middle_s));
  }
  const double samples = std::ceil(max_s * seen.waveform.sample_rate_hz);
  return static_cast<std::size_t>(std::min(samples, static_cast<double>(seen.samples + guard_samples)));
}

// Moves a pulse by a shift and a turn: y(t) = x(t + late) exp(2 pi j turns). What is moved out of the window is lost.
void move_pulse(std::span<const std::complex<float>> from, std::span<std::complex<float>> to, const core::Fft& fft,
                double late_samples, double turns) {
  if (!(std::abs(late_samples) < static_cast<double>(from.size() + guard_samples))) {
    std::ranges::fill(to, std::complex<float>());
    return;
  }
  std::vector<std::complex<double>> row(fft.size());
  std::ranges::copy(from, row.begin());
  fft.forward(row);
  const auto size = static_cast<double>(fft.size());
  for (std::size_t k = 0; k < row.size(); ++k) {
    const double cycles = static_cast<double>(k) - (2 * k > row.size() ? size : 0.0);
    const double here = cycles / size * late_samples + turns;
    row[k] *= std::polar(1.0 / size, 2.0 * core::pi * (here - std::round(here)));
  }
  fft.inverse(row);
  for (std::size_t n = 0; n < to.size(); ++n) to[n] = std::complex<float>(row[n]);
}

}  // namespace

std::vector<TrackPoint> track_from_target(const std::vector<TrackPoint>& track, const std::vector<TargetPose>& poses) {
  core::expect(poses.size() == track.size(), "images of a turning target: not one pose for each pulse");
  std::vector<TrackPoint> seen = track;
  for (std::size_t p = 0; p < poses.size(); ++p) {
    const TargetPose& pose = poses[p];
    const core::Vec3 r = track[p].position_m - pose.centre_m;
    // The frame turns: what rests in the world moves in it, against the turning.
    const core::Vec3 v = track[p].velocity_mps - pose.velocity_mps - core::cross(pose.turn_rate_radps, r);
    const core::Mat3 target_from_world = core::transposed(pose.world_from_target);
    seen[p].position_m = target_from_world * r;
    seen[p].velocity_mps = target_from_world * v;
  }
  return seen;
}

SarEchoes seen_from_target(const SarEchoes& echoes, const std::vector<TargetPose>& poses) {
  CORE_EXPECT(poses.size() == echoes.track.size());
  SarEchoes seen = echoes;
  seen.track = track_from_target(echoes.track, poses);
  return seen;
}

std::vector<FocusedImage> isar_images(const SarEchoes& echoes, const std::vector<TargetPose>& poses,
                                      const core::Vec3& cross_range, const core::Vec3& range,
                                      const ImageAxis& cross_range_m, const ImageAxis& range_m,
                                      const IsarBursts& bursts, const core::WorkControl& control) {
  CORE_EXPECT(poses.size() == echoes.track.size());
  const std::vector<TrackPoint> track = track_from_target(echoes.track, poses);
  const std::size_t length = bursts.interval.pulses;
  const std::size_t step = step_of(bursts.interval);
  ImageFrame frame;
  frame.plane = ImagePlane::ground_grid;
  frame.along = cross_range;
  frame.across = range;
  std::vector<FocusedImage> images;
  SarEchoes burst{echoes.waveform, {}, echoes.samples, echoes.first_delay_s, {}};
  for (std::size_t first = 0; first + length <= track.size(); first += step) {
    const auto begin = static_cast<std::ptrdiff_t>(first);
    const auto end = static_cast<std::ptrdiff_t>(first + length);
    const auto samples = static_cast<std::ptrdiff_t>(echoes.samples);
    burst.track.assign(track.begin() + begin, track.begin() + end);
    burst.volts.assign(echoes.volts.begin() + begin * samples, echoes.volts.begin() + end * samples);
    const double count = static_cast<double>(length);
    double sum = 0.0;
    if (bursts.interval.window && length > 1) {
      for (std::size_t p = 0; p < length; ++p) {
        const double w = bursts.interval.window(static_cast<double>(p) / (count - 1.0));
        sum += w;
        for (std::size_t n = 0; n < echoes.samples; ++n) burst.volts[p * echoes.samples + n] *= static_cast<float>(w);
      }
      core::expect(std::abs(sum) > 1e-12, "images of a turning target: the weights of the window cancel");
      for (auto& v : burst.volts) v *= static_cast<float>(count / sum);
    }
    BackProjectionOptions options;
    options.range_window = bursts.range_window;
    images.push_back(back_project(burst, frame, cross_range_m, range_m, options, control));
  }
  return images;
}

std::vector<RangeDopplerMap> isar_range_doppler_maps(const SarEchoes& echoes, const std::vector<TargetPose>& poses,
                                                     const CoherentInterval& interval,
                                                     const core::WorkControl& control) {
  CORE_EXPECT(poses.size() == echoes.track.size());
  const SarEchoes seen = seen_from_target(echoes, poses);
  const SarWaveform& wave = seen.waveform;
  const std::size_t step = step_of(interval);
  core::expect(seen.samples > 0 && seen.volts.size() == seen.track.size() * seen.samples,
               "range-Doppler map: the number of samples is not pulses times samples of a pulse");
  std::vector<RangeDopplerMap> maps;
  if (seen.track.size() < interval.pulses) return maps;
  const double prf_hz = seen.track.size() > 1 ? repetition_hz(seen.track) : 1.0;
  const core::Fft fft(core::good_fft_size(seen.samples + largest_shift(seen, interval.pulses, step) + guard_samples));
  std::vector<std::complex<float>> burst(interval.pulses * seen.samples);
  for (std::size_t first = 0; first + interval.pulses <= seen.track.size(); first += step) {
    const double middle_s = centre_delay_s(seen.track[first + interval.pulses / 2], wave.light_speed_mps);
    core::parallel_ranges(interval.pulses, 8, control, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        const double delay_s = centre_delay_s(seen.track[first + p], wave.light_speed_mps);
        move_pulse(std::span(seen.volts).subspan((first + p) * seen.samples, seen.samples),
                   std::span(burst).subspan(p * seen.samples, seen.samples), fft,
                   (delay_s - middle_s) * wave.sample_rate_hz, wave.carrier_hz * delay_s);
      }
    });
    CoherentInterval alone = interval;
    alone.step = 0;
    maps.push_back(std::move(range_doppler_maps(burst, seen.samples, prf_hz, alone, control).front()));
    maps.back().first_pulse = first;
  }
  return maps;
}

double cross_range_m_per_hz(const SarEchoes& echoes, const std::vector<TargetPose>& poses) {
  CORE_EXPECT(poses.size() == echoes.track.size());
  CORE_EXPECT(echoes.waveform.carrier_hz > 0.0);
  CORE_EXPECT(echoes.waveform.light_speed_mps > 0.0);
  const std::vector<TrackPoint> track = track_from_target(echoes.track, poses);
  if (track.size() < 2) return std::numeric_limits<double>::infinity();
  const core::Vec3 first = track.front().position_m;
  const core::Vec3 last = track.back().position_m;
  const double angle_rad = std::atan2(core::norm(core::cross(first, last)), core::dot(first, last));
  const double span_s = track.back().time_s - track.front().time_s;
  return radar::range_of_cycle(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps) * span_s / angle_rad;
}

}  // namespace sarsim::signal
