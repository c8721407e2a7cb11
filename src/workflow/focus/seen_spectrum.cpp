#include "workflow/focus/seen_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "radar/path/path.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/target_aspects.hpp"

namespace sarsim::workflow {

namespace {

// Of a target, with the mean amplitude of its echoes.
struct TargetSpectrum {
  double amplitude = 0.0;
  std::optional<signal::ImageSpectrum> spectrum;
};

TargetSpectrum spectrum_of_target(std::span<const TargetAspect> seen, const signal::EchoRows& echoes, double band_hz,
                                  double centroid_hz, double speed_mps) {
  const double per_hz = radar::range_of_cycle(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps) / speed_mps;
  TargetSpectrum target;
  std::vector<signal::SeenDirection> directions;
  directions.reserve(seen.size());
  double all = 0.0;
  double used = 0.0;
  for (const TargetAspect& look : seen) {
    const double sine = per_hz * look.doppler_hz;
    const double weight = look.amplitude * look.share;
    all += weight;
    if (!(std::abs(sine) < 1.0) || !(weight > 0.0) || std::abs(look.doppler_hz - centroid_hz) > 0.5 * band_hz) continue;
    directions.push_back({sine, weight});
    used += weight;
  }
  // Of a target with few echoes among those that are used, what is beyond counts as part of all of them.
  constexpr double min_used = 0.05;
  if (!(used > min_used * all)) return target;
  target.amplitude = used / static_cast<double>(seen.size());
  target.spectrum = signal::spectrum_of(directions, echoes.waveform, left_out_of_image * all / used);
  return target;
}

// "columns 0.5 m apart instead of 1 m, for a spectrum of 1.7 cycles per metre from -4.7 to -3"
std::string text_of_axis(const char* what, const signal::ImageAxis& coarse, const signal::ImageAxis& fine,
                         const signal::SpectrumExtent& extent) {
  return fmt::format(
      "{} {:.4g} m apart instead of {:.4g} m, for a spectrum of {:.4g} cycles per metre from {:.4g} to "
      "{:.4g}",
      what, fine.step_m, coarse.step_m, extent.width_per_m(), extent.min_per_m, extent.max_per_m);
}

}  // namespace

std::optional<signal::ImageSpectrum> seen_spectrum(const simulate::Acquisition& acquisition, signal::EchoRows echoes,
                                                   const DopplerBand& kept, SeenPulses pulses,
                                                   const core::WorkControl& control) {
  constexpr std::size_t max_looks = 257;
  constexpr double weakest = 0.01;
  echoes.compensated = true;
  if (!echoes.carriers_hz.empty()) {
    const auto [low, high] = std::ranges::minmax(echoes.carriers_hz);
    echoes.waveform.bandwidth_hz = std::abs(echoes.waveform.bandwidth_hz) + high - low;
  }
  const TargetAspects looks(acquisition, echoes, {}, max_looks);
  const double prf_hz = 1.0 / looks.track().interval_s;
  double band_hz = pulses == SeenPulses::all ? std::numeric_limits<double>::infinity() : prf_hz;
  if (kept.width_hz > 0.0) band_hz = std::min(band_hz, kept.width_hz);
  const std::size_t every = (looks.targets() + max_examined_targets - 1) / max_examined_targets;
  std::vector<TargetSpectrum> targets(looks.targets());
  looks.each(
      control,
      [&](std::size_t t, std::span<const TargetAspect> seen) {
        targets[t] = spectrum_of_target(seen, echoes, band_hz, kept.centroid_hz, looks.track().speed_mps);
      },
      std::max<std::size_t>(every, 1));
  double strongest = 0.0;
  for (const TargetSpectrum& target : targets) strongest = std::max(strongest, target.amplitude);
  std::optional<signal::ImageSpectrum> all;
  for (const TargetSpectrum& target : targets)
    if (target.spectrum && target.amplitude >= weakest * strongest)
      all = all ? signal::joined(*all, *target.spectrum) : *target.spectrum;
  return all;
}

core::Problems diagnose_grid(const signal::FocusedImage& coarse, const signal::FocusedImage& axes,
                             const signal::ImageSpectrum& spectrum) {
  std::string text;
  if (axes.range.step_m < coarse.range.step_m)
    text += text_of_axis("columns", coarse.range, axes.range, spectrum.range);
  if (axes.azimuth.step_m < coarse.azimuth.step_m)
    text += (text.empty() ? "" : "; ") + text_of_axis("rows", coarse.azimuth, axes.azimuth, spectrum.azimuth);
  if (text.empty()) return {};
  return {core::note("focus.finer-grid",
                     "the image is sampled more finely than the recording, since squint, aperture and bandwidth "
                     "widen its spectrum: " +
                         text)};
}

core::Problems diagnose_carriers(const signal::EchoRows& echoes, const signal::ImageSpectrum& spectrum) {
  std::vector<double> carriers_hz = echoes.carriers_hz;
  std::ranges::sort(carriers_hz);
  carriers_hz.erase(std::ranges::unique(carriers_hz).begin(), carriers_hz.end());
  if (carriers_hz.size() < 2) return {};
  core::Problems problems;
  double gap_hz = 0.0;
  for (std::size_t i = 1; i < carriers_hz.size(); ++i) gap_hz = std::max(gap_hz, carriers_hz[i] - carriers_hz[i - 1]);
  if (gap_hz > std::abs(echoes.waveform.bandwidth_hz))
    problems.push_back(
        core::warning("focus.carriers-far-apart",
                      fmt::format("the carriers are up to {:.4g} MHz apart, more than the pulse's band: responses "
                                  "repeat every {:.4g} m of range",
                                  1e-6 * gap_hz, radar::range_of_cycle(gap_hz, echoes.waveform.light_speed_mps)))
            .hint("step by less than the bandwidth"));
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  const double rate_hz = 1.0 / (track.interval_s * static_cast<double>(carriers_hz.size()));
  const double band_hz = spectrum.azimuth.width_per_m() * track.speed_mps;
  if (band_hz > rate_hz)
    problems.push_back(
        core::warning(
            "focus.carriers-too-seldom",
            fmt::format("each of {} carriers is sent {:.4g} times a second, but the targets' Doppler frequencies are "
                        "{:.4g} Hz wide: each carrier has azimuth ambiguities, at different azimuths",
                        carriers_hz.size(), rate_hz, band_hz))
            .hint("raise the PRF, or use fewer carriers"));
  return problems;
}

}  // namespace sarsim::workflow
