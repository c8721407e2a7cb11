#include "workflow/focus/swath_remark.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/image_area.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/image_reach.hpp"
#include "workflow/focus/target_aspects.hpp"

namespace sarsim::workflow {

namespace {

// What an image that is right may lose.
constexpr double max_loss_db = 0.1;
constexpr double max_loss_rad = 0.02;

// Where a target is, and between which sines of directions most of its echoes are.
struct Candidate {
  std::size_t target = 0;
  signal::ImagePlace place{};
  double low_sine = 0.0;
  double high_sine = 0.0;
  bool in_swath = false;
  double amplitude = 0.0;  // Sum of its echoes.
  double told = 1.0;       // Share of them whose Doppler frequencies the pulses tell.
};

// Those of pulses whose Doppler frequency the pulses tell; the others have no weight.
std::vector<signal::SeenDirection> directions_of(const TargetAspects& looks, std::span<const TargetAspect> seen,
                                                 const signal::EchoRows& echoes, double centroid_hz) {
  const double per_hz =
      radar::range_of_cycle(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps) / looks.track().speed_mps;
  const double half_hz = 0.5 / looks.track().interval_s;
  std::vector<signal::SeenDirection> directions;
  for (const TargetAspect& look : seen) {
    const double sine = per_hz * look.doppler_hz;
    const bool told = std::abs(sine) < 1.0 && std::abs(look.doppler_hz - centroid_hz) <= half_hz;
    directions.push_back({told ? sine : 0.0, told ? look.amplitude * look.share : 0.0});
  }
  return directions;
}

Candidate candidate_of(const TargetAspects& looks, std::size_t target, std::span<const TargetAspect> seen,
                       std::span<const signal::SeenDirection> directions) {
  Candidate candidate{.target = target, .low_sine = 1.0, .high_sine = -1.0};
  const auto amplitude = [](const TargetAspect& look) { return look.amplitude * look.share; };
  double strongest = 0.0, strongest_of_all = 0.0, told = 0.0, all = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    strongest = std::max(strongest, directions[i].weight);
    strongest_of_all = std::max(strongest_of_all, amplitude(seen[i]));
  }
  // Within 20 dB: what the antenna's side lobes add to a peak is not what a processor is chosen for.
  for (std::size_t i = 0; i < seen.size(); ++i) {
    candidate.amplitude += amplitude(seen[i]);
    if (amplitude(seen[i]) < 0.1 * strongest_of_all) continue;
    told += directions[i].weight;
    all += amplitude(seen[i]);
  }
  if (all > 0.0) candidate.told = told / all;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!(strongest > 0.0) || directions[i].weight < 0.1 * strongest) continue;
    candidate.in_swath = true;
    candidate.low_sine = std::min(candidate.low_sine, directions[i].sine);
    candidate.high_sine = std::max(candidate.high_sine, directions[i].sine);
    candidate.place = looks.place(seen[i], seen[i].doppler_hz);
  }
  return candidate;
}

// The few that may lose most: of which most phase is left, and those seen under the widest angle, nearest and farthest.
std::vector<std::size_t> likely_worst(const std::vector<Candidate>& candidates, const signal::PointLosses& losses) {
  std::vector<std::size_t> likely;
  const auto add_most = [&](const auto& measure) {
    std::optional<std::size_t> most;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (candidates[i].in_swath && (!most || measure(candidates[i]) > measure(candidates[*most]))) most = i;
    if (most && std::ranges::find(likely, *most) == likely.end()) likely.push_back(*most);
  };
  add_most([&](const Candidate& c) { return losses.left_turns(c.place.range_m, c.low_sine, c.high_sine); });
  add_most([](const Candidate& c) { return std::max(std::abs(c.low_sine), std::abs(c.high_sine)); });
  add_most([](const Candidate& c) { return c.place.range_m; });
  add_most([](const Candidate& c) { return -c.place.range_m; });
  return likely;
}

double lost_db(double amplitude) {
  constexpr double nothing_left = 1e-6;
  return -core::amplitude_db(std::max(amplitude, nothing_left));
}

// Of two losses the one that is farther beyond what is right.
double grade_of(const signal::SwathLoss& loss) {
  return std::max(lost_db(loss.amplitude) / max_loss_db, std::abs(loss.phase_rad) / max_loss_rad);
}

std::string name_of_target(const MethodLoss& loss) {
  return loss.target ? fmt::format("target {}", *loss.target + 1) : "a point at the edge of the swath";
}

MethodLoss loss_at_edge(const signal::EchoRows& echoes, const signal::FocusOptions& options,
                        const signal::PointLosses& losses) {
  constexpr int count = 65;
  const signal::FocusedImage axes = signal::image_of(echoes, options);
  const double per_hz = radar::range_of_cycle(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps);
  const double middle = per_hz * options.doppler_centroid_hz / axes.frame.speed_mps;
  double low = middle, high = middle;
  if (options.spectrum) {
    low = per_hz * options.spectrum->azimuth.min_per_m;
    high = per_hz * options.spectrum->azimuth.max_per_m;
  }
  const double half = 0.5 * per_hz / (signal::fit_straight(echoes.track).interval_s * axes.frame.speed_mps);
  std::vector<signal::SeenDirection> directions;
  for (int i = 0; i < count; ++i) {
    const double sine = low + (high - low) * (i + 0.5) / count;
    directions.push_back({std::clamp(sine, std::max(middle - half, -0.99), std::min(middle + half, 0.99)), 1.0});
  }
  const double edge_m = axes.range.at(static_cast<double>(axes.range.count) - 1.0);
  return {std::nullopt, losses.middle_m(), losses.of(edge_m, directions), 1.0};
}

}  // namespace

std::optional<MethodLoss> worst_method_loss(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                            const signal::FocusOptions& options, const core::WorkControl& control) {
  constexpr std::size_t max_looks = 129;
  const signal::PointLosses losses(echoes, options);
  if (acquisition.scene->scatterers.size() > max_examined_targets) return loss_at_edge(echoes, options, losses);
  signal::FocusedImage image = signal::image_of(echoes, options);
  if (options.azimuth_area) signal::cut_axis(image.azimuth, *options.azimuth_area);
  signal::EchoRows from_line = echoes;
  from_line.compensated = true;
  const TargetAspects looks(acquisition, from_line, {}, max_looks);
  std::vector<Candidate> candidates(looks.targets());
  std::vector<std::vector<signal::SeenDirection>> directions(looks.targets());
  looks.each(control, [&](std::size_t t, std::span<const TargetAspect> seen) {
    directions[t] = directions_of(looks, seen, echoes, options.doppler_centroid_hz);
    candidates[t] = candidate_of(looks, t, seen, directions[t]);
    // What the image does not show it does not lose: `diagnose_outside` tells of such targets.
    candidates[t].in_swath = candidates[t].in_swath && shows(image, candidates[t].place);
  });
  std::optional<MethodLoss> worst;
  for (const std::size_t i : likely_worst(candidates, losses)) {
    const signal::SwathLoss loss = losses.of(candidates[i].place.range_m, directions[i]);
    if (!worst || grade_of(loss) > grade_of(worst->loss)) worst = {candidates[i].target, losses.middle_m(), loss, 1.0};
  }
  if (!worst) return worst;
  constexpr double weakest = 0.03;  // What is seen through side lobes alone decides nothing.
  const double strongest = std::ranges::max(candidates, {}, &Candidate::amplitude).amplitude;
  for (const Candidate& candidate : candidates) {
    if (!(candidate.in_swath && candidate.amplitude >= weakest * strongest && candidate.told < worst->told)) continue;
    worst->told = candidate.told;
    worst->min_told = candidate.target;
  }
  return worst;
}

double excess_of(const std::optional<MethodLoss>& loss) {
  return loss ? std::max(grade_of(loss->loss), lost_db(loss->told) / max_loss_db) : 0.0;
}

std::string text_of(const MethodLoss& loss) {
  if (lost_db(loss.told) > lost_db(loss.loss.amplitude))
    return fmt::format("{:.3g} dB of target {}, whose Doppler frequencies are aliased", lost_db(loss.told),
                       loss.min_told + 1);
  return fmt::format("{:.3g} dB of {}, whose Doppler frequencies are aliased at the upper end of the band",
                     lost_db(loss.loss.amplitude), name_of_target(loss));
}

core::Problems diagnose_swath_loss(const simulate::Acquisition& acquisition, const signal::EchoRows& echoes,
                                   const signal::FocusOptions& options, const core::WorkControl& control) {
  const std::optional<MethodLoss> worst = worst_method_loss(acquisition, echoes, options, control);
  if (!worst) return {};
  const double grade = grade_of(worst->loss);
  if (grade < 0.1) return {};
  const signal::SwathLoss& loss = worst->loss;
  const bool warns = grade >= 1.0;
  const core::Severity severity = warns ? core::Severity::warning : core::Severity::note;
  const std::string expected = warns ? fmt::format("below {:.1f} dB and {:.2f} rad", max_loss_db, max_loss_rad) : "";
  if (options.method == signal::FocusMethod::omega_k)
    return {core::ProblemBuilder(severity, "focus.omega-k-loss",
                                 fmt::format("omega-k loses {:.3g} dB of {}: part of its Doppler spectrum is aliased "
                                             "at the upper end of the band, or it is seen along the track",
                                             lost_db(worst->loss.amplitude), name_of_target(*worst)))
                .expected(expected)
                .hint("use --algorithm back-projection, or raise the PRF")};
  const bool scaled = options.method == signal::FocusMethod::chirp_scaling;
  return {core::ProblemBuilder(
              severity, "focus.swath-loss",
              fmt::format("{} focuses all ranges with the parameters of mid-swath at {:.1f} m: {}, {:.1f} m away, "
                          "loses {:.3g} dB, with a phase error of {:.3g} rad and a range error of {:.2g} m",
                          scaled ? "chirp scaling" : "range-Doppler", worst->middle_m, name_of_target(*worst),
                          std::abs(loss.from_middle_m), lost_db(loss.amplitude), loss.phase_rad,
                          std::abs(loss.shift.range_m)))
              .expected(expected)
              .hint("use --algorithm omega-k, which focuses each range exactly")};
}

core::Problems diagnose_area(const signal::EchoRows& echoes, const signal::FocusOptions& options) {
  if (!options.azimuth_area) return {};
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  const double far_s = echoes.first_delay_s + static_cast<double>(echoes.columns) / echoes.waveform.sample_rate_hz;
  const double far_m = radar::range_of(far_s, echoes.waveform.light_speed_mps);
  const double low_m = track.speed_mps * track.time_s(0.0) - far_m;
  const double high_m = track.speed_mps * track.time_s(static_cast<double>(echoes.track.size()) - 1.0) + far_m;
  const signal::AxisInterval& area = *options.azimuth_area;
  if (area.first_m <= high_m && area.last_m >= low_m) return {};
  return {core::warning("focus.area-without-echoes",
                        "the area in azimuth is outside everything recorded: the image is empty")
              .found(fmt::format("{:.6g} to {:.6g} m", area.first_m, area.last_m))
              .expected(fmt::format("a part of {:.6g} to {:.6g} m, the record and the farthest range on either side",
                                    low_m, high_m))
              .hint("give an --azimuth within it")};
}

}  // namespace sarsim::workflow
