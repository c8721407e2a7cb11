#include "workflow/search/search_checks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "signal/search/canceller.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/survey/beam_passes.hpp"
#include "simulate/survey/survey.hpp"
#include "simulate/survey/survey_echoes.hpp"
#include "workflow/focus/matched_filter_coverage.hpp"

namespace sarsim::workflow {

namespace {

// Whether all pulses of a plan follow each other at the same interval.
bool evenly_spaced(const simulate::Acquisition& acquisition) {
  const radar::Repetition& repetition = acquisition.link.repetition;
  return std::abs(repetition.shortest_interval_s() - repetition.mean_interval_s()) <
         1e-9 * repetition.mean_interval_s();
}

// Reaches to either side, as they are given: ranges, and Doppler rows where there are some.
std::string cells_text(const signal::CfarOptions& cfar, std::size_t rows, std::size_t columns) {
  const auto both = [](std::size_t along_columns, std::size_t along_rows) {
    return along_rows == 0 ? fmt::format("{}", along_columns) : fmt::format("{}:{}", along_columns, along_rows);
  };
  const auto beyond = [](std::size_t reach, std::size_t guard) { return reach - std::min(reach, guard); };
  return fmt::format(
      "--train {} --guard {} in a map of {} x {}",
      both(beyond(cfar.reference_columns, cfar.guard_columns), beyond(cfar.reference_rows, cfar.guard_rows)),
      both(cfar.guard_columns, cfar.guard_rows), rows, columns);
}

// Collects the remarks on one plan.
class Remarks {
 public:
  Remarks(const simulate::Acquisition& acquisition, const SearchOptions& options, const core::WorkControl& control)
      : acquisition_(acquisition),
        options_(options),
        survey_(simulate::survey_echoes(acquisition, control)),
        prf_hz_(1.0 / acquisition.link.repetition.mean_interval_s()),
        wavelength_m_(radar::wavelength_of(acquisition.link.carrier.highest_hz(), acquisition.light_speed_mps())) {}

  core::Problems all() {
    if (options_.pulses > 1) {
      doppler();
      range_walk();
    }
    if (options_.canceller > 0) blind_speeds();
    cut_echoes();
    dwell();
    unseen_end();
    still_beam();
    if (options_.detect) detector();
    return std::move(problems_);
  }

 private:
  [[nodiscard]] double speed_of(double doppler_hz) const { return -radar::speed_of(doppler_hz, wavelength_m_); }

  // Of the Doppler frequencies that a target shows, the one farthest from 0.
  static double extreme_hz(const simulate::TargetSurvey& target) {
    return std::abs(target.lowest_doppler_hz) > std::abs(target.highest_doppler_hz) ? target.lowest_doppler_hz
                                                                                    : target.highest_doppler_hz;
  }

  void doppler() {
    std::size_t count = 0;
    double max_hz = 0.0;
    for (const simulate::TargetSurvey& target : survey_.targets) {
      if (!target.in_window || std::abs(extreme_hz(target)) <= 0.5 * prf_hz_) continue;
      ++count;
      if (std::abs(extreme_hz(target)) > std::abs(max_hz)) max_hz = extreme_hz(target);
    }
    if (count == 0) return;
    // A radar that searches finds directions and ranges, and is built to fold speeds.
    problems_.push_back(
        core::ProblemBuilder(
            beam_turns(acquisition_) ? core::Severity::note : core::Severity::warning, "search.doppler-folds",
            fmt::format("{} of {} targets exceed the unambiguous speed: their Doppler frequencies are aliased", count,
                        survey_.targets.size()))
            .found(fmt::format("{:.4g} m/s, that is {}", std::abs(speed_of(max_hz)),
                               core::with_prefix(std::abs(max_hz), "Hz", 4)))
            .expected(fmt::format("at most {:.4g} m/s, lambda PRF/4", speed_of(0.5 * prf_hz_)))
            .hint(fmt::format("speeds are shown modulo {:.4g} m/s; a PRF of {} makes them unambiguous",
                              speed_of(prf_hz_), core::with_prefix(2.0 * std::abs(max_hz), "Hz", 4))));
  }

  void range_walk() {
    const double time_s = static_cast<double>(options_.recorded_pulses()) / prf_hz_;
    const double cell_m =
        radar::range_of_cycle(radar::bandwidth_hz(acquisition_.link.pulse), acquisition_.light_speed_mps());
    double max_mps = 0.0;
    for (const simulate::TargetSurvey& target : survey_.targets)
      if (target.in_window) max_mps = std::max(max_mps, target.largest_speed_mps);
    if (max_mps * time_s <= cell_m) return;
    problems_.push_back(
        core::warning("search.range-smears",
                      "targets migrate through more than a cell of range in an interval: their responses are smeared")
            .found(fmt::format("{:.4g} m at {:.4g} m/s", max_mps * time_s, max_mps))
            .expected(fmt::format("at most {:.4g} m, c/(2 B)", cell_m))
            .hint(fmt::format("use intervals of at most {:.0f} pulses",
                              std::max(1.0, std::floor(cell_m / max_mps * prf_hz_)))));
  }

  // Far from 0, where nothing rests.
  void blind_speeds() {
    constexpr double blind = 0.1;
    const double mean_gain = signal::canceller_noise_gain(options_.canceller);
    std::size_t count = 0;
    std::size_t first = 0;
    double first_hz = 0.0;
    for (std::size_t t = survey_.targets.size(); t-- > 0;) {
      const simulate::TargetSurvey& target = survey_.targets[t];
      const double doppler_hz = 0.5 * (target.lowest_doppler_hz + target.highest_doppler_hz);
      if (!target.in_window || std::abs(doppler_hz) < 0.5 * prf_hz_) continue;
      if (signal::canceller_gain(options_.canceller, doppler_hz, prf_hz_) > blind * mean_gain) continue;
      ++count;
      first = t + 1;
      first_hz = doppler_hz;
    }
    if (count == 0) return;
    const double gain = signal::canceller_gain(options_.canceller, first_hz, prf_hz_) / mean_gain;
    problems_.push_back(
        core::warning(
            "search.blind-speed",
            count == 1
                ? fmt::format("target {} moves near a blind speed of the canceller", first)
                : fmt::format("{} targets move near blind speeds of the canceller, target {} the first", count, first))
            .found(fmt::format("{:.4g} m/s, where its response is {:.0f} dB", std::abs(speed_of(first_hz)),
                               10.0 * std::log10(std::max(gain, 1e-30))))
            .expected(fmt::format("speeds away from multiples of {:.4g} m/s, lambda PRF/2", speed_of(prf_hz_)))
            .hint("change the PRF or the carrier"));
  }

  // Raw recordings end without the rest of the echoes that begin in their last pulse's length.
  void cut_echoes() {
    if (!acquisition_.reception.is_raw()) return;
    const double c = acquisition_.light_speed_mps();
    const double whole_m = radar::range_of(
        MatchedFilterCoverage(acquisition_, acquisition_.reception.columns, acquisition_.link.window).last_whole_s(),
        c);
    const double last_m = radar::range_of(acquisition_.reception.raw_grid.time_s(acquisition_.reception.columns - 1) +
                                              acquisition_.reception.pulse.lead_s,
                                          c);
    std::size_t count = 0;
    double farthest_m = 0.0;
    for (const simulate::TargetSurvey& target : survey_.targets) {
      if (!target.in_window || target.nearest_m > last_m || target.farthest_m <= whole_m) continue;
      ++count;
      farthest_m = std::max(farthest_m, target.farthest_m);
    }
    if (count == 0) return;
    problems_.push_back(
        core::warning("search.echoes-cut",
                      fmt::format("{} of {} targets are within a pulse length of the end of the raw recording, which "
                                  "contains only the beginning of their echoes: they appear weaker",
                                  count, survey_.targets.size()))
            .found(fmt::format("{:.6g} m", farthest_m))
            .expected(fmt::format("at most {:.6g} m", whole_m))
            .hint("extend the range window by c/2 times the pulse width, or take the script"));
  }

  void dwell() {
    const double width_rad = beam_width_rad(acquisition_);
    if (acquisition_.link.beam.kind != radar::Beam::Kind::rotating || width_rad <= 0.0) return;
    const double turn_rad =
        std::abs(acquisition_.link.beam.rate_rad_per_s) * static_cast<double>(options_.recorded_pulses()) / prf_hz_;
    if (turn_rad <= width_rad) return;
    const auto degrees = [](double rad) { return core::deg_per_rad * rad; };
    const double pulses = width_rad / std::abs(acquisition_.link.beam.rate_rad_per_s) * prf_hz_;
    problems_.push_back(
        core::warning(
            "search.beam-turns",
            "the beam rotates by more than its width in an interval: targets are illuminated for only part of it")
            .found(fmt::format("{:.3g} degrees in {} pulses", degrees(turn_rad), options_.recorded_pulses()))
            .expected(fmt::format("at most {:.3g} degrees", degrees(width_rad)))
            .hint(pulses >= 2.0
                      ? fmt::format("use intervals of at most {:.0f} pulses, or turn more slowly", std::floor(pulses))
                      : std::string("turn more slowly or raise the PRF")));
  }

  // The picture of a single turn stays black where its last pulses make no interval. Of several turns another one shows
  // it.
  void unseen_end() {
    const auto pulses = static_cast<std::size_t>(acquisition_.timing.pulses.count());
    const std::size_t intervals = interval_count(options_, pulses);
    if (!simulate::is_scanning(acquisition_.link.beam) || intervals == 0) return;
    const std::size_t taken = (intervals - 1) * options_.step_pulses() + options_.recorded_pulses();
    const double turn_deg = core::deg_per_rad * std::abs(acquisition_.link.beam.rate_rad_per_s) / prf_hz_;
    const double unseen_deg =
        std::min(turn_deg * static_cast<double>(pulses - taken), 360.0 - turn_deg * static_cast<double>(taken));
    constexpr double rounding_deg = 1e-6;
    if (unseen_deg < rounding_deg) return;
    problems_.push_back(
        core::note(
            "search.pulses-left-over",
            fmt::format("the last {} of {} pulses do not fill an interval: {:.3g} deg of the turn are not processed",
                        pulses - taken, pulses, unseen_deg))
            .hint(fmt::format("take intervals of another number of pulses, or record {} more",
                              taken + options_.step_pulses() - pulses)));
  }

  // Of single pulses nothing is left but the beam's azimuth and the range.
  void still_beam() {
    if (options_.recorded_pulses() > 1 || beam_turns(acquisition_)) return;
    simulate::PulseGeometry geometry(*acquisition_.scene, acquisition_.link);
    geometry.set_pulse(acquisition_.timing.pulses.first);
    const double azimuth_deg = core::deg_per_rad * core::azimuth_rad(geometry.pointing().axis_world());
    problems_.push_back(
        core::warning(
            "search.beam-still",
            "the beam does not rotate: every detection is shown at the azimuth of the beam, wherever its target is")
            .found(fmt::format("a beam that points to {:.3g} degrees all the time",
                               azimuth_deg + (azimuth_deg < 0.0 ? 360.0 : 0.0)))
            .expected("a beam of type \"rotating\"")
            .hint("targets outside the beam are not compared with detections"));
  }

  void detector() {
    if (acquisition_.reception.noise_stddev_v == 0.0)
      problems_.push_back(
          core::warning("search.no-noise",
                        "the radar has no noise: detections are compared with sidelobes and rounding errors")
              .found("0 K")
              .expected("a noise temperature above 0")
              .hint("give the receiver its temperature, 290 K for instance"));
    if (options_.canceller > 0 && options_.cfar.reference_rows > 0)
      problems_.push_back(core::warning("search.canceller-noise",
                                        "after a canceller the noise level differs from one Doppler row to the next: "
                                        "reference cells in other Doppler rows give a wrong threshold")
                              .found(fmt::format("{} rows", options_.cfar.reference_rows))
                              .expected("reference cells in the same row")
                              .hint("leave out the second number of --train"));
    const double pulse_cells =
        1.0 / (radar::bandwidth_hz(acquisition_.link.pulse) * acquisition_.reception.raw_grid.interval_s);
    if (pulse_cells > 1.5 && static_cast<double>(options_.cfar.guard_columns) < pulse_cells)
      problems_.push_back(
          core::warning("search.guard-too-small", "a response is wider than the guard cells: a target masks itself")
              .found(fmt::format("{} guard cells to either side", options_.cfar.guard_columns))
              .expected(fmt::format("at least {:.0f}, the samples of a range cell", std::ceil(pulse_cells)))
              .hint("give more with --guard"));
  }

  const simulate::Acquisition& acquisition_;
  const SearchOptions& options_;
  simulate::EchoSurvey survey_;
  double prf_hz_;
  double wavelength_m_;
  core::Problems problems_;
};

}  // namespace

core::Problems problems_of_search(const simulate::Acquisition& acquisition, const SearchOptions& options) {
  core::Problems problems;
  if (acquisition.reception.is_profile())
    problems.push_back(core::error("synthetic range profiles hold no pulses")
                           .found("processing \"srp\"")
                           .expected("processing \"raw\" or \"matched-filter\"")
                           .hint("take another recording with --simulation"));
  const bool trains = options.recorded_pulses() > 1;
  if (trains && !evenly_spaced(acquisition))
    problems.push_back(
        core::error("the pulses are not evenly spaced: Doppler frequencies and cancellers need even ones")
            .expected("one PRF")
            .hint("use a repetition of type \"constant\", or --interval 1 without a canceller"));
  if (trains && acquisition.link.carrier.lowest_hz() != acquisition.link.carrier.highest_hz())
    problems.push_back(core::error("the carrier changes from pulse to pulse: their phases cannot be compared")
                           .found(fmt::format("{:.9g} to {:.9g} Hz", acquisition.link.carrier.lowest_hz(),
                                              acquisition.link.carrier.highest_hz()))
                           .expected("one carrier")
                           .hint("use a carrier of type \"single\", or --interval 1 without a canceller"));
  const auto pulses = static_cast<std::size_t>(acquisition.timing.pulses.count());
  if (!acquisition.reception.is_profile() && options.recorded_pulses() > pulses)
    problems.push_back(core::error("an interval has more pulses than the recording")
                           .found(fmt::format("{}", options.recorded_pulses()))
                           .expected(fmt::format("at most {}", pulses))
                           .hint("give --interval less, or record for longer"));
  if (options.frequencies > 0 && options.frequencies < options.pulses)
    problems.push_back(core::error("a map has fewer Doppler frequencies than an interval has pulses")
                           .found(fmt::format("{}", options.frequencies))
                           .expected(fmt::format("at least {}", options.pulses))
                           .hint("give --frequencies more"));
  if (options.pulses == 1 && options.frequencies > 1)
    problems.push_back(core::error("a single pulse has no Doppler frequencies")
                           .found(fmt::format("{}", options.frequencies))
                           .expected("1")
                           .hint("give --interval more, or leave out --frequencies"));
  if (options.detect && !signal::has_reference_cells(options.cfar, options.rows(), acquisition.reception.columns))
    problems.push_back(core::error("no reference cells are left outside the guard")
                           .found(cells_text(options.cfar, options.rows(), acquisition.reception.columns))
                           .expected("more cells to train on than to guard, and a guard smaller than the map")
                           .hint("give --train more, or --guard less"));
  return problems;
}

core::Problems diagnose_search(const simulate::Acquisition& acquisition, const SearchOptions& options,
                               const core::WorkControl& control) {
  return Remarks(acquisition, options, control).all();
}

double beam_width_rad(const simulate::Acquisition& acquisition) {
  const auto width = [](const radar::AntennaPattern& pattern) {
    return pattern.kind == radar::AntennaPattern::Kind::sinx ? pattern.azimuth_beamwidth_rad : 0.0;
  };
  const double transmit = width(acquisition.link.transmit);
  const double receive = width(acquisition.link.receive);
  if (transmit > 0.0 && receive > 0.0) return std::min(transmit, receive);
  return std::max(transmit, receive);
}

std::optional<double> half_beam_rad(const simulate::Acquisition& acquisition) {
  const radar::PatternRule rule = acquisition.scene->conventions.pattern;
  const auto half = [rule](const radar::AntennaPattern& pattern) -> std::optional<double> {
    using Kind = radar::AntennaPattern::Kind;
    if (pattern.kind == Kind::isotropic) return std::nullopt;
    if (pattern.kind == Kind::sinx) return 0.5 * pattern.azimuth_beamwidth_rad;
    constexpr int steps = 3600;
    const auto power = [&](int step) {
      return std::pow(radar::one_way_amplitude(pattern, core::pi * step / steps, 0.0, rule), 2);
    };
    double most = 0.0;
    for (int step = -steps; step <= steps; ++step) most = std::max(most, power(step));
    double farthest_rad = 0.0;
    for (int step = -steps; step <= steps; ++step)
      if (power(step) >= 0.5 * most) farthest_rad = std::max(farthest_rad, core::pi * std::abs(step) / steps);
    return farthest_rad;
  };
  const auto transmit = half(acquisition.link.transmit);
  const auto receive = half(acquisition.link.receive);
  if (transmit && receive) return std::min(*transmit, *receive);
  return transmit ? transmit : receive;
}

bool beam_turns(const simulate::Acquisition& acquisition) {
  constexpr int looks = 16;
  simulate::PulseGeometry geometry(*acquisition.scene, acquisition.link);
  double first_rad = 0.0;
  for (int look = 0; look <= looks; ++look) {
    // Unevenly far apart, so that no turn fits between all of them.
    const double share = static_cast<double>(look * look) / (looks * looks);
    geometry.set_pulse(acquisition.timing.pulses.first +
                       std::llround(share * static_cast<double>(acquisition.timing.pulses.count() - 1)));
    const double here_rad = core::azimuth_rad(geometry.pointing().axis_world());
    if (look == 0) first_rad = here_rad;
    if (std::abs(std::remainder(here_rad - first_rad, 2.0 * core::pi)) > seen_width_rad(acquisition)) return true;
  }
  return false;
}

double seen_width_rad(const simulate::Acquisition& acquisition) {
  const double width_rad = beam_width_rad(acquisition);
  return width_rad > 0.0 ? width_rad : core::rad_per_deg;
}

std::size_t dwell_pulses(const simulate::Acquisition& acquisition) {
  const double rate = std::abs(acquisition.link.beam.rate_rad_per_s);
  if (acquisition.link.beam.kind != radar::Beam::Kind::rotating || rate == 0.0) return 1;
  const double pulses = 0.5 * beam_width_rad(acquisition) / rate / acquisition.link.repetition.mean_interval_s();
  return static_cast<std::size_t>(std::clamp(std::floor(pulses + 1e-9), 1.0, 64.0));
}

}  // namespace sarsim::workflow
