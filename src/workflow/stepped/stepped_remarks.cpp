#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "signal/stepped/stepped_limits.hpp"
#include "simulate/plan/target_ranges.hpp"
#include "workflow/stepped/stepped_grid.hpp"
#include "workflow/stepped/stepped_rows.hpp"

namespace sarsim::workflow {

namespace {

std::string hz_text(double hz) { return core::with_prefix(hz, "Hz"); }

// Speeds of the targets that are in the burst in the middle.
struct SpeedRange {
  double lowest_mps = 0.0;
  double highest_mps = 0.0;
};

SpeedRange speeds_of(const std::vector<BurstTruth>& truth) {
  SpeedRange range;
  bool any = false;
  for (const BurstTruth& target : truth) {
    if (!(target.amplitude > 0.0)) continue;
    range.lowest_mps = any ? std::min(range.lowest_mps, target.speed_mps) : target.speed_mps;
    range.highest_mps = any ? std::max(range.highest_mps, target.speed_mps) : target.speed_mps;
    any = true;
  }
  return range;
}

void remark_on_band(core::Problems& problems, const signal::SteppedBand& band, const signal::SteppedLimits& limits) {
  const signal::SteppedWaveform& w = band.waveform();
  if (w.steps < 2) return;
  const double step_hz = std::abs(w.carrier_step_hz);
  if (w.subband_hz > 0.0 && band.gap_share() > 1e-9 && w.subband_hz < step_hz * (1.0 - 1e-9))
    problems.push_back(
        core::warning("stepped.gaps", "the steps are wider than the band of the pulses: the joined band has gaps")
            .found(fmt::format("steps of {}, sub-bands of {}", hz_text(step_hz), hz_text(w.subband_hz)))
            .expected("steps up to the bandwidth of the pulse")
            .hint(fmt::format("targets get grating lobes {:.4g} m apart; use smaller steps or a wider chirp",
                              limits.unambiguous_range_m)));
  if (w.subband_hz > 0.0 || limits.seen_m <= limits.unambiguous_range_m * (1.0 + 1e-9)) return;
  problems.push_back(
      core::warning("stepped.gate-folds",
                    "the range gate is longer than the unambiguous profile: targets may alias onto each other")
          .found(fmt::format("a gate covers {:.4g} m, a profile {:.4g} m", limits.seen_m, limits.unambiguous_range_m))
          .expected(
              fmt::format("steps up to {} or a pulse up to {:.4g} ns", hz_text(1.0 / w.pulse_width_s), 1e9 / step_hz))
          .hint("use smaller steps, a shorter pulse or chirps"));
}

void remark_on_gates(core::Problems& problems, const signal::SteppedBand& band) {
  const signal::SteppedWaveform& w = band.waveform();
  if (w.subband_hz > 0.0 || w.sample_rate_hz * (w.seen_to_s - w.seen_from_s) >= 1.0 - 1e-9) return;
  problems.push_back(
      core::warning("stepped.gates-apart",
                    "the range gates are farther apart than the pulse is long: targets between them are lost")
          .found(fmt::format("gates {:.4g} m apart", radar::range_of_cycle(w.sample_rate_hz, w.light_speed_mps)))
          .expected(fmt::format("at least {}", hz_text(1.0 / (w.seen_to_s - w.seen_from_s))))
          .hint("raise the sampling frequency"));
}

void remark_on_targets(core::Problems& problems, const SteppedRows& rows, const signal::SteppedLimits& limits) {
  const signal::SteppedWaveform& w = rows.band->waveform();
  if (w.subband_hz > 0.0 || w.steps < 2) return;
  const simulate::RangeExtent extent =
      simulate::target_ranges(*rows.acquisition->scene, rows.acquisition->link, rows.acquisition->timing.pulses);
  const double extent_m = extent.farthest_m - extent.nearest_m;
  // Within what one gate sees, targets so far apart share their bins.
  if (extent.empty() || extent_m <= limits.unambiguous_range_m || limits.seen_m <= limits.unambiguous_range_m) return;
  problems.push_back(
      core::warning("stepped.targets-fold", "the targets extend farther than the unambiguous length of a profile")
          .found(fmt::format("{:.4g} m", extent_m))
          .expected(fmt::format("up to {:.4g} m, c/2 over the step", limits.unambiguous_range_m))
          .hint("some of them appear at aliased ranges; use smaller steps"));
}

void remark_on_speed(core::Problems& problems, const SteppedRows& rows, const signal::SteppedLimits& limits,
                     std::optional<double> compensated_mps) {
  const SpeedRange speeds = speeds_of(truth_of_burst(rows, rows.bursts / 2));
  const double taken = compensated_mps.value_or(0.0);
  const double left = std::max(std::abs(speeds.lowest_mps - taken), std::abs(speeds.highest_mps - taken));
  if (left <= limits.tolerable_mps) return;
  const double widest = std::abs(speeds.highest_mps - taken) >= std::abs(speeds.lowest_mps - taken)
                            ? speeds.highest_mps - taken
                            : speeds.lowest_mps - taken;
  const double smear = limits.smear_cells(widest);
  const double shift = limits.shift_m(widest);
  if (smear <= 0.5 + 1e-9 && std::abs(shift) < limits.resolution_m) return;
  problems.push_back(
      core::warning(
          "stepped.targets-smear",
          fmt::format("targets move during a burst: they are smeared over {:.3g} cells and shifted by {:.4g} m", smear,
                      shift))
          .found(fmt::format("{:.4g} m/s{}", widest, compensated_mps ? " beyond the speed that is compensated" : ""))
          .expected(fmt::format("up to {:.3g} m/s", limits.tolerable_mps))
          .hint(compensated_mps ? "the targets have speeds of their own; compensate the one that matters"
                                : "compensate it: --velocity scene, estimated or a number"));
  if (rows.band->waveform().subband_hz > 0.0 || std::abs(shift) <= 0.5 * limits.seen_m) return;
  problems.push_back(core::warning("stepped.targets-lost",
                                   "targets are so fast that they appear outside their range gates: they are lost")
                         .found(fmt::format("shifted by {:.4g} m", shift))
                         .expected(fmt::format("up to {:.4g} m, half a range gate", 0.5 * limits.seen_m))
                         .hint("compensate their speed: --velocity scene, estimated or a number"));
}

// The first carriers of a list.
std::string carriers_text(const radar::CarrierPlan& carrier) {
  constexpr std::int64_t shown = 4;
  std::string text;
  for (std::int64_t n = 0; n < shown; ++n) text += hz_text(carrier.carrier_hz(n)) + ", ";
  return text + "...";
}

}  // namespace

core::Problems problems_of_stepped(const simulate::Acquisition& acquisition, SteppedUse use, bool recorded) {
  core::Problems problems;
  const std::optional<SteppedGrid> grid = stepped_grid(acquisition.link.carrier, acquisition.timing.pulses.first);
  const std::size_t steps = grid ? grid->steps : 1;
  const bool mono = acquisition.link.pulse.kind == radar::Pulse::Kind::mono;
  if (!grid)
    problems.push_back(core::error("the carriers of the list are not evenly spaced")
                           .found(carriers_text(acquisition.link.carrier))
                           .expected("each carrier as often as the others, all of them multiples of one step apart")
                           .hint("leave out what does not fit, or use a carrier of type \"stepped\""));
  else if (steps > 1 && grid->step_hz == 0.0)
    problems.push_back(
        core::error("the frequency step is zero").found("0 Hz").expected("a step up to the bandwidth of the pulse"));
  else if (use == SteppedUse::profiles && steps < 2)
    problems.push_back(core::error("synthetic range profiles need a carrier with at least two frequency steps")
                           .found("one carrier")
                           .expected("a carrier of type \"stepped\" or \"list\"")
                           .hint("for chirps on one carrier compress the recording: processing = \"matched-filter\""));
  else if (use == SteppedUse::isar && steps < 2 && mono)
    problems.push_back(
        core::error("the carrier is not stepped and the pulse is not modulated: there is no range resolution")
            .found("a pulse of type \"mono\" on one carrier")
            .expected("a carrier of type \"stepped\" or \"list\", or a modulated pulse"));
  if (recorded && acquisition.reception.is_profile())
    problems.push_back(core::error("the file holds range profiles already, not the echoes of single pulses")
                           .found("processing \"srp\"")
                           .expected("\"raw\" or \"matched-filter\"")
                           .hint("record the pulses with processing = \"raw\""));
  if (recorded && acquisition.reception.is_compressed() &&
      acquisition.scene->conventions.compression != simulate::Conventions::Compression::keeps_peak)
    problems.push_back(core::error("the classic profile repeats or leaves out samples of this compressed recording")
                           .hint("use raw data, or the physical profile"));
  const std::int64_t burst = grid ? grid->burst_pulses() : 1;
  const std::int64_t first = radar::floor_divide(acquisition.timing.pulses.first + burst - 1, burst);
  if (radar::floor_divide(acquisition.timing.pulses.last + 1, burst) <= first)
    problems.push_back(
        core::error("the recording holds no whole burst")
            .found(fmt::format("pulses {} to {}", acquisition.timing.pulses.first, acquisition.timing.pulses.last))
            .expected(fmt::format("all {0} pulses of a burst; a burst begins at each multiple of {0}", burst))
            .hint("lengthen the azimuth window"));
  return problems;
}

core::Problems diagnose_stepped(const SteppedRows& rows, SteppedUse use, std::optional<double> speed_mps) {
  core::Problems problems;
  const signal::SteppedLimits limits =
      signal::limits_of(*rows.band, rows.acquisition->link.repetition.mean_interval_s());
  remark_on_band(problems, *rows.band, limits);
  remark_on_gates(problems, *rows.band);
  remark_on_targets(problems, rows, limits);
  // Images take the motion of each pulse out.
  if (use == SteppedUse::profiles) remark_on_speed(problems, rows, limits, speed_mps);
  if (rows.dropped_pulses > 0)
    problems.push_back(core::note("stepped.incomplete-bursts", "pulses of incomplete bursts at the ends are left out")
                           .found(fmt::format("{}", rows.dropped_pulses)));
  return problems;
}

}  // namespace sarsim::workflow
