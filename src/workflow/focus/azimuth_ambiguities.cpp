#include "workflow/focus/azimuth_ambiguities.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "radar/path/path.hpp"
#include "workflow/focus/target_aspects.hpp"

namespace sarsim::workflow {

namespace {

// The middle of some looks by their amplitudes.
struct Middle {
  double amplitude = 0.0;
  double moment = 0.0;

  void add(double index, double weight) {
    amplitude += weight;
    moment += weight * index;
  }
  [[nodiscard]] std::size_t index() const { return static_cast<std::size_t>(std::llround(moment / amplitude)); }
};

// The Doppler frequencies that hold the echoes' amplitudes but for `share` of them at either end.
std::pair<double, double> extent_of(std::span<const TargetAspect> seen, double share) {
  std::vector<std::pair<double, double>> parts;  // frequency, amplitude
  double all = 0.0;
  for (const TargetAspect& look : seen) {
    parts.emplace_back(look.doppler_hz, look.amplitude);
    all += look.amplitude;
  }
  std::ranges::sort(parts);
  const auto end_of = [&](const auto& from_the_end) {
    double sum = 0.0;
    for (const auto& [doppler_hz, amplitude] : from_the_end)
      if ((sum += amplitude) > share * all) return doppler_hz;
    return 0.0;
  };
  return {end_of(parts), end_of(parts | std::views::reverse)};
}

SarTarget target_of(const TargetAspects& looks, std::size_t number, std::span<const TargetAspect> seen) {
  SarTarget target;
  target.target = number;
  Middle middle;
  double strongest = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    middle.add(static_cast<double>(i), seen[i].amplitude);
    strongest = std::max(strongest, seen[i].amplitude);
  }
  if (!(middle.amplitude > 0.0)) return target;
  target.amplitude = middle.amplitude / static_cast<double>(seen.size());
  target.place = looks.place(seen[middle.index()], seen[middle.index()].doppler_hz);
  target.lowest_doppler_hz = INFINITY;
  target.highest_doppler_hz = -INFINITY;
  constexpr double unseen = 0.0005;
  std::tie(target.min_doppler_hz, target.max_doppler_hz) = extent_of(seen, unseen);
  constexpr double rounding = 1e-6;
  double recorded = 0.0;
  for (const TargetAspect& look : seen) recorded += look.amplitude * look.share;
  target.kept = recorded / middle.amplitude;
  target.recorded =
      std::ranges::any_of(seen, [](const TargetAspect& look) { return look.amplitude * look.share > 0.0; });
  for (const TargetAspect& look : seen) {
    if (look.amplitude < 0.1 * strongest) continue;
    target.lowest_doppler_hz = std::min(target.lowest_doppler_hz, look.doppler_hz);
    target.highest_doppler_hz = std::max(target.highest_doppler_hz, look.doppler_hz);
    target.in_swath = target.in_swath && look.share > 0.0;
    target.whole = target.whole && look.share > 1.0 - rounding;
  }
  return target;
}

// The looks at a target that fold alike.
struct Fold {
  Middle middle;
  signal::ImagePlace least{INFINITY, INFINITY};
  signal::ImagePlace most{-INFINITY, -INFINITY};
};

// Of the looks whose Doppler frequencies are kept.
void add_ambiguities(const TargetAspects& looks, std::size_t target, std::span<const TargetAspect> seen,
                     const DopplerBand& kept, std::vector<AzimuthAmbiguity>& ghosts) {
  constexpr double smallest_share = 0.01;
  const double prf_hz = 1.0 / looks.track().interval_s;
  std::map<int, Fold> fold_of;
  double all = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    all += seen[i].amplitude;
    const int folds = static_cast<int>(std::lround((seen[i].doppler_hz - kept.centroid_hz) / prf_hz));
    if (folds == 0) continue;
    const double folded_hz = seen[i].doppler_hz - folds * prf_hz;
    if (kept.width_hz > 0.0 && std::abs(folded_hz - kept.centroid_hz) > 0.5 * kept.width_hz) continue;
    Fold& fold = fold_of[folds];
    const signal::ImagePlace place = looks.place(seen[i], folded_hz);
    fold.middle.add(static_cast<double>(i), seen[i].amplitude);
    fold.least = {std::min(fold.least.azimuth_m, place.azimuth_m), std::min(fold.least.range_m, place.range_m)};
    fold.most = {std::max(fold.most.azimuth_m, place.azimuth_m), std::max(fold.most.range_m, place.range_m)};
  }
  for (const auto& [folds, fold] : fold_of) {
    if (!(fold.middle.amplitude > smallest_share * all)) continue;
    const TargetAspect& look = seen[fold.middle.index()];
    ghosts.push_back({.target = target,
                      .folds = folds,
                      .place = looks.place(look, look.doppler_hz - folds * prf_hz),
                      .azimuth_m = fold.most.azimuth_m - fold.least.azimuth_m,
                      .range_m = fold.most.range_m - fold.least.range_m,
                      .share = fold.middle.amplitude / all});
  }
}

std::vector<AzimuthAmbiguity> in_order(const std::vector<std::vector<AzimuthAmbiguity>>& ambiguities_of) {
  std::vector<AzimuthAmbiguity> all;
  for (const std::vector<AzimuthAmbiguity>& ghosts : ambiguities_of)
    all.insert(all.end(), ghosts.begin(), ghosts.end());
  return all;
}

void remark_on_wrapping(const TargetAspects& looks, const std::vector<AzimuthAmbiguity>& ghosts, AmbiguitiesIn image,
                        core::Problems& problems) {
  if (ghosts.empty() || image == AmbiguitiesIn::circle) return;
  const bool in_time = image == AmbiguitiesIn::time;
  std::vector<std::size_t> wrapped;
  double nearest_m = INFINITY;
  double farthest_m = -INFINITY;
  double largest = 0.0;
  double missing = 0.0;  // From the peak of a target: all of its ghosts.
  double max_missing = 0.0;
  for (const AzimuthAmbiguity& ghost : ghosts) {
    if (wrapped.empty() || wrapped.back() != ghost.target) {
      wrapped.push_back(ghost.target);
      missing = 0.0;
    }
    missing += ghost.share;
    max_missing = std::max(max_missing, missing);
    nearest_m = std::min(nearest_m, ghost.place.azimuth_m);
    farthest_m = std::max(farthest_m, ghost.place.azimuth_m);
    largest = std::max(largest, ghost.share);
  }
  const double lost_db = -core::amplitude_db(std::max(1.0 - max_missing, 1e-6));
  constexpr double little = 0.1;
  problems.push_back(
      core::ProblemBuilder(
          in_time && largest < little ? core::Severity::note : core::Severity::warning, "focus.ghosts",
          fmt::format(
              "echoes of {} of {} targets ({}) have Doppler frequencies beyond half the PRF of {:.6g} Hz: they cause "
              "smeared azimuth ambiguities of up to {:.0f} % of their amplitude, at azimuths from {:.0f} to {:.0f} m{}",
              wrapped.size(), looks.targets(), target_list(wrapped), 1.0 / looks.track().interval_s, 100.0 * largest,
              nearest_m, farthest_m,
              in_time ? "" : fmt::format(", and peaks lose up to {:.2g} dB, except by back-projection", lost_db)))
          .hint("raise the PRF, or process a smaller band with --doppler-bandwidth"));
}

// Some targets, and what of their echoes is not recorded.
struct PartlyRecorded {
  std::vector<std::size_t> numbers;
  std::size_t worst = 0;
  double kept = 1.0;  // the least

  void add(const SarTarget& target) {
    numbers.push_back(target.target);
    if (numbers.size() > 1 && target.kept >= kept) return;
    worst = target.target;
    kept = target.kept;
  }
  [[nodiscard]] double lost_db() const { return std::max(0.0, -core::amplitude_db(std::max(kept, 1e-6))); }
  [[nodiscard]] const char* among_others() const { return numbers.size() > 1 ? ", the most" : ""; }
};

void remark_on_swath(const std::vector<SarTarget>& targets, core::Problems& problems) {
  PartlyRecorded outside, leaving;
  for (const SarTarget& target : targets)
    if (target.amplitude > 0.0 && !target.in_swath) (target.recorded ? leaving : outside).add(target);
  const auto remark = [&](const PartlyRecorded& some, std::string message) {
    if (some.numbers.empty()) return;
    problems.push_back(core::warning("focus.targets-not-recorded", std::move(message)).hint("widen the range window"));
  };
  remark(outside,
         fmt::format("{} of {} targets ({}) are never within the recorded ranges and are missing from the image",
                     outside.numbers.size(), targets.size(), target_list(outside.numbers)));
  remark(leaving,
         fmt::format("{} of {} targets ({}) leave the recorded ranges for some pulses: their images are weaker "
                     "and wider, or missing; the peak of target {} loses {:.2g} dB{}",
                     leaving.numbers.size(), targets.size(), target_list(leaving.numbers), leaving.worst + 1,
                     leaving.lost_db(), leaving.among_others()));
}

void remark_on_cut_echoes(const std::vector<SarTarget>& targets, core::Problems& problems) {
  PartlyRecorded cut;
  for (const SarTarget& target : targets)
    if (target.amplitude > 0.0 && target.in_swath && !target.whole) cut.add(target);
  if (cut.numbers.empty()) return;
  problems.push_back(
      core::warning("focus.echoes-cut",
                    fmt::format("{} of {} targets ({}) are within a pulse length of the end of the raw recording, "
                                "which contains only the beginning of their echoes: their responses are weaker, and "
                                "wider in range; the peak of target {} loses {:.2g} dB{}",
                                cut.numbers.size(), targets.size(), target_list(cut.numbers), cut.worst + 1,
                                cut.lost_db(), cut.among_others()))
          .hint("extend the range window by c/2 times the pulse width, or focus the script"));
}

// The band that the azimuth beam of a sin(x)/x antenna holds: 2 V/wavelength times its width, two-way.
void remark_on_beam(const simulate::Acquisition& acquisition, const TargetAspects& looks, const DopplerBand& kept,
                    core::Problems& problems) {
  if (acquisition.link.transmit.kind != radar::AntennaPattern::Kind::sinx) return;
  const double wavelength_m = radar::wavelength_of(acquisition.carrier_hz(), acquisition.light_speed_mps());
  const double half_width = 0.5 * std::min(acquisition.link.transmit.azimuth_beamwidth_rad, 3.1);
  const double band_hz = 4.0 * looks.track().speed_mps / wavelength_m * std::sin(half_width);
  const double prf_hz = 1.0 / looks.track().interval_s;
  // What is beyond the kept band wraps around into it only from one repetition frequency away.
  const double kept_hz = kept.width_hz > 0.0 ? std::min(kept.width_hz, prf_hz) : prf_hz;
  if (band_hz <= 2.0 * prf_hz - kept_hz) return;
  problems.push_back(
      core::note("focus.beam-band", fmt::format("the beam has a Doppler band of {:.4g} Hz, wider than the PRF of "
                                                "{:.4g} Hz: targets away from beam centre may be aliased",
                                                band_hz, prf_hz)));
}

void remark_on_sampling(const signal::SarWaveform& waveform, core::Problems& problems) {
  const double ratio = waveform.sample_rate_hz / std::abs(waveform.bandwidth_hz);
  if (ratio < 1.0 || ratio >= 1.1) return;
  problems.push_back(
      core::warning(
          "focus.low-sampling-rate",
          fmt::format(
              "the sampling rate is only {:.3f} times the bandwidth: range interpolation has errors of a few per cent",
              ratio))
          .hint("sample at 1.2 times the bandwidth or more"));
}

}  // namespace

std::string target_list(const std::vector<std::size_t>& targets) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(targets.size(), most); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(targets[i] + 1);
  if (targets.size() > most) text += fmt::format(" and {} more", targets.size() - most);
  return text;
}

std::vector<SarTarget> sar_targets(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                   const core::WorkControl& control, std::size_t max_looks) {
  return sar_targets(TargetAspects(acquisition, echoes, {}, max_looks), control);
}

std::vector<SarTarget> sar_targets(const TargetAspects& looks, const core::WorkControl& control) {
  std::vector<SarTarget> targets(looks.targets());
  looks.each(control,
             [&](std::size_t t, std::span<const TargetAspect> seen) { targets[t] = target_of(looks, t, seen); });
  return targets;
}

std::vector<SarTarget> targets_from_line(const simulate::Acquisition& acquisition, signal::EchoRows echoes,
                                         const core::WorkControl& control, std::size_t max_looks) {
  echoes.compensated = true;
  return sar_targets(acquisition, echoes, control, max_looks);
}

std::vector<AzimuthAmbiguity> sar_ghosts(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                         const DopplerBand& kept, const core::WorkControl& control) {
  const TargetAspects looks(acquisition, echoes);
  std::vector<std::vector<AzimuthAmbiguity>> ambiguities_of(looks.targets());
  looks.each(control, [&](std::size_t t, std::span<const TargetAspect> seen) {
    add_ambiguities(looks, t, seen, kept, ambiguities_of[t]);
  });
  return in_order(ambiguities_of);
}

core::Problems diagnose_ghosts(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                               const DopplerBand& kept, AmbiguitiesIn image, const core::WorkControl& control) {
  core::Problems problems;
  remark_on_wrapping(TargetAspects(acquisition, echoes), sar_ghosts(acquisition, echoes, kept, control), image,
                     problems);
  return problems;
}

core::Problems diagnose_sar(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                            const DopplerBand& kept, AmbiguitiesIn image, const core::WorkControl& control) {
  core::Problems problems;
  remark_on_sampling(echoes.waveform, problems);
  if (acquisition.scene->scatterers.size() > max_examined_targets) return problems;
  const TargetAspects looks(acquisition, echoes);
  std::vector<SarTarget> targets(looks.targets());
  std::vector<std::vector<AzimuthAmbiguity>> ambiguities_of(looks.targets());
  looks.each(control, [&](std::size_t t, std::span<const TargetAspect> seen) {
    targets[t] = target_of(looks, t, seen);
    add_ambiguities(looks, t, seen, kept, ambiguities_of[t]);
  });
  remark_on_wrapping(looks, in_order(ambiguities_of), image, problems);
  remark_on_swath(targets, problems);
  remark_on_cut_echoes(targets, problems);
  remark_on_beam(acquisition, looks, kept, problems);
  return problems;
}

}  // namespace sarsim::workflow
