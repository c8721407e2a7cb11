#include "simulate/survey/survey.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "radar/receiver/converter.hpp"
#include "scene/model/format_values.hpp"
#include "scene/model/scene_index.hpp"
#include "simulate/survey/ambiguity.hpp"
#include "simulate/survey/beam_passes.hpp"
#include "simulate/survey/beam_steps.hpp"
#include "simulate/survey/limit_rules.hpp"
#include "simulate/survey/noise_energy.hpp"
#include "simulate/survey/pulse_motion.hpp"
#include "simulate/survey/survey_echoes.hpp"
#include "simulate/survey/table_rules.hpp"
#include "simulate/survey/visibility_rules.hpp"

namespace sarsim::simulate {

namespace {

// Collects the problems of one simulation.
class Surveyor {
 public:
  // @param impossible  targets that have been reported
  Surveyor(const scene::Scene& scene, std::size_t index, SurveyReport& report, std::set<std::size_t>& impossible)
      : scene_(scene),
        index_(index),
        simulation_(scene.simulations[index]),
        report_(report),
        problems_(report.problems),
        impossible_(impossible) {}

  void look(const std::shared_ptr<const ResolvedScene>& resolved, const core::WorkControl& control) {
    const Acquisition acquisition = acquisition_of(scene_, index_, resolved);
    check_weights(acquisition);
    if (acquisition.reception.profiler && !check_bursts(acquisition)) return;
    const EchoSurvey survey = survey_echoes(acquisition, control);
    scope_ = survey.all_pulses ? ""
                               : fmt::format(" (estimate from {} of {} pulses)", survey.pulses_sampled,
                                             acquisition.timing.pulses.count());
    if (!check_echoes(survey, acquisition)) return;
    check_surfaces(survey, acquisition);
    check_horizon(survey);
    const RangeAmbiguities others = find_range_ambiguities(acquisition, control.stop);
    check_window(survey, acquisition, others);
    check_doppler(survey, acquisition);
    check_lsb(survey, acquisition);
    check_range_ambiguities(acquisition, others, survey, index_, scope_, problems_);
    check_pulse_motion(survey, acquisition, control);
    check_limits(acquisition, survey, index_, scope_, problems_);
    check_beam_steps(acquisition);
    check_visibility(survey, acquisition, control);
  }

 private:
  static constexpr std::size_t max_sights = 64;

  void check_visibility(const EchoSurvey& survey, const Acquisition& acquisition, const core::WorkControl& control) {
    const VisibilitySurvey looked(acquisition, targets_in_window(survey, max_sights));
    EchoSummary summary{index_, survey.targets.size(), survey.totals.in_window, looked.look(control)};
    const auto directive = [](const radar::AntennaPattern& pattern) {
      return pattern.kind != radar::AntennaPattern::Kind::isotropic;
    };
    summary.directive = directive(acquisition.link.transmit) || directive(acquisition.link.receive);
    summary.noise = noise_energy_j(acquisition.scene->conventions, acquisition.link) > 0.0;
    const VisibilityCase sighted{scene_, index_, acquisition, looked, summary, control};
    simulate::check_visibility(sighted, problems_);
    check_tables(sighted, survey, problems_);
    report_.summaries.push_back(std::move(summary));
  }

  void check_pulse_motion(const EchoSurvey& survey, const Acquisition& acquisition, const core::WorkControl& control) {
    constexpr std::size_t max_targets = 4096;
    const PulseMotion left = motion_left_in_pulse(acquisition, targets_in_window(survey, max_targets), control);
    if (left.phase_rad < noted_motion_rad) return;
    add("radar",
        core::ProblemBuilder(
            left.phase_rad < warned_motion_rad ? core::Severity::note : core::Severity::warning, "motion.within-pulse",
            fmt::format("motion within a pulse is modelled to second order: the residual phase at the ends of the "
                        "pulse is up to {:.2g} rad, for target {} at {:.6g} s",
                        left.phase_rad, left.target + 1, acquisition.link.repetition.send_time_s(left.pulse)))
            .expected(fmt::format("below {:g} rad", noted_motion_rad))
            .hint("shorten the pulse: this phase grows with the third power of its width"));
  }

  // Neither targets nor clutter of a direction that the beam jumps over are in a recording.
  void check_beam_steps(const Acquisition& acquisition) {
    constexpr double min_unlit = 0.01;
    const auto steps = beam_steps(acquisition);
    if (!steps || steps->unlit_share < min_unlit) return;
    const auto degrees = [](double angle_rad) { return fmt::format("{:.4g} deg", core::deg_per_rad * angle_rad); };
    const double prf_hz = 1.0 / acquisition.link.repetition.mean_interval_s();
    add("radar", core::warning("beam.jumps", fmt::format("the beam rotates by more than its width from pulse to pulse: "
                                                         "{:.0f} % of the directions scanned are never illuminated",
                                                         100.0 * steps->unlit_share))
                     .found(fmt::format("a turn of {} from pulse to pulse, a beam of {}", degrees(steps->step_rad),
                                        degrees(steps->width_rad)))
                     .expected(fmt::format("at most {} from pulse to pulse", degrees(steps->width_rad)))
                     .hint(fmt::format("turn the beam more slowly, or raise the PRF to at least {}",
                                       core::with_prefix(prf_hz * steps->step_rad / steps->width_rad, "Hz", 4))));
    problems_.back().subject = {"radar", scene::find_radar(scene_, simulation_.radar), "beam_rate"};
  }

  void add(const char* field, core::ProblemBuilder problem) {
    problems_.push_back(std::move(problem).at("simulation", index_, field));
  }

  struct Weights {
    double sum = 0.0;
    double magnitudes = 0.0;
    std::size_t count = 0;

    void add(double weight) {
      sum += weight;
      magnitudes += std::abs(weight);
      ++count;
    }
  };

  // Of the radar's window over the steps of a burst, or over the samples of a pulse times their power.
  [[nodiscard]] Weights weights_of(const Acquisition& acquisition) const {
    Weights weights;
    if (acquisition.reception.profiler) {
      const std::size_t steps = acquisition.reception.profiler->steps();
      for (std::size_t n = 0; n < steps; ++n)
        weights.add(steps > 1 ? acquisition.link.window(static_cast<double>(n) / static_cast<double>(steps - 1)) : 1.0);
    } else if (acquisition.reception.compressor) {
      const radar::Pulse& pulse = acquisition.link.pulse;
      const double samples = pulse.width_s * simulation_.sample_rate_hz;
      for (std::size_t k = 0; k == 0 || static_cast<double>(k) < samples - 1e-9; ++k) {
        const double t_s = static_cast<double>(k) / simulation_.sample_rate_hz;
        weights.add(acquisition.link.window(t_s / pulse.width_s) *
                    std::norm(pulse.value(t_s, 1e-9 / simulation_.sample_rate_hz)));
      }
    }
    return weights;
  }

  // A window that is 0 at its ends leaves nothing of a pulse, or a burst, of one or two samples; one that is negative
  // for a half leaves no peak to keep.
  void check_weights(const Acquisition& acquisition) {
    const Weights weights = weights_of(acquisition);
    if (weights.count == 0 || !core::weights_cancel(weights.sum, weights.magnitudes)) return;
    if (weights.magnitudes == 0.0)
      add("radar", core::warning("window.zero", "the radar's window function is zero at every sample")
                       .found(fmt::format("{} samples", weights.count))
                       .expected("a window that is above 0 somewhere")
                       .hint(acquisition.reception.profiler ? "take more frequency steps or another window"
                                                            : "sample faster or take another window"));
    else
      add("radar", core::warning("window.cancels",
                                 "the radar's window function cancels: its weights, with their signs, sum to 0")
                       .expected("weights that leave a target its peak")
                       .hint("a target's peak is 0, so the output cannot be scaled; take another window"));
  }

  bool check_bursts(const Acquisition& acquisition) {
    if (acquisition.timing.rows == 0) {
      add("time_end_s",
          core::error("bursts.none-complete", "the window contains no complete burst of stepped frequencies")
              .found(fmt::format("{} pulses", acquisition.timing.pulses.count()))
              .expected(fmt::format("at least {} from the start of a burst", acquisition.timing.row_pulses))
              .hint("lengthen the azimuth window; bursts start at pulse numbers that are multiples of steps times "
                    "pulses per step"));
      return false;
    }
    if (acquisition.timing.dropped_pulses > 0)
      add("time_end_s", core::note("bursts.incomplete",
                                   fmt::format("{} pulses of incomplete bursts at the ends of the window are left out",
                                               acquisition.timing.dropped_pulses)));
    return true;
  }

  // Echoes that no recording can hold. A target is reported once, whatever else looks at it.
  bool check_echoes(const EchoSurvey& survey, const Acquisition& acquisition) {
    for (const std::size_t i : survey.totals.impossible) {
      if (!impossible_.insert(i).second) continue;
      const auto met = std::ranges::find(survey.impossible, i, &ImpossiblePulse::target);
      const bool at_pulse = met != survey.impossible.end();
      problems_.push_back(problem_of_echo("target", i, acquisition.link.name,
                                          at_pulse ? met->echo : extremes_of(survey.targets[i]),
                                          acquisition.light_speed_mps()));
      if (at_pulse) problems_.back().message += text_of_pulse(met->pulse, met->time_s);
    }
    return survey.totals.impossible.empty();
  }

  void check_surfaces(const EchoSurvey& survey, const Acquisition& acquisition) {
    for (std::size_t i = 0; i < survey.surface_faces_radar.size(); ++i)
      if (!survey.surface_faces_radar[i] && !acquisition.scene->sheets[i].points_m.empty())
        problems_.push_back({core::Severity::warning,
                             "the surface faces away from the radar and gives no echo" + scope_,
                             "",
                             "a front, where (corner 2 - corner 1) x (corner 3 - corner 1) points, towards the radar",
                             "exchange its second and third corner",
                             {},
                             {"surface", i, "corner_m"},
                             1});
  }

  // The sum of echoes knows no shadows.
  void check_horizon(const EchoSurvey& survey) {
    const SurveyTotals& totals = survey.totals;
    if (totals.hidden == 0) return;
    const std::size_t all = survey.targets.size();
    add("radar",
        core::warning("targets.behind-horizon",
                      "the Earth blocks the line of sight to targets: their echoes are computed nevertheless" + scope_)
            .found(fmt::format("{} of {} target{} behind the horizon, the first of them target {}; {} in the window",
                               totals.hidden, all, all == 1 ? "" : "s", totals.first_hidden + 1,
                               totals.hidden_in_window))
            .expected("targets to which the straight line does not pass through the ellipsoid")
            .hint("leave them out, or correct their positions or the orbit"));
  }

  void check_window(const EchoSurvey& survey, const Acquisition& acquisition, const RangeAmbiguities& others) {
    if (survey.targets.empty()) {
      if (acquisition.scene->sheets.empty())
        add("", core::warning("targets.none",
                              "the scene has no target: the recording will contain " +
                                  std::string(acquisition.reception.noise_stddev_v > 0 ? "noise only" : "zeros only"))
                    .hint("add a $TARGET"));
      return;
    }
    if (survey.totals.any_in_window || !acquisition.scene->sheets.empty() ||
        !asked_for(others, acquisition.scene->options.ambiguous_echoes).pulses.empty())
      return;
    const double nearest = survey.totals.nearest_m;
    const double farthest = survey.totals.farthest_m;
    const double reach_m = radar::range_of(acquisition.reception.pulse.last_s() - acquisition.reception.pulse.first_s(),
                                           acquisition.light_speed_mps());
    add("range_start_m",
        core::warning("range-window.no-echo",
                      "no echo falls into the slant range window: the recording will be empty" + scope_)
            .found(fmt::format("{} to {} m", core::format_number(simulation_.range_start_m),
                               core::format_number(simulation_.range_end_m)))
            .expected(
                fmt::format("a window that touches the echoes from {:.6g} to {:.6g} m", nearest, farthest + reach_m))
            .hint(fmt::format("set the slant range window to about {:.0f} ... {:.0f} m", std::floor(nearest),
                              std::ceil(farthest + reach_m))));
  }

  void check_doppler(const EchoSurvey& survey, const Acquisition& acquisition) {
    // Nobody makes an image along the track of what a turning beam sees.
    if (is_scanning(acquisition.link.beam) || acquisition.timing.pulses.count() < 2 ||
        acquisition.reception.is_profile())
      return;
    const double band_hz = survey.highest_doppler_hz - survey.lowest_doppler_hz;
    const double prf_hz = 1.0 / acquisition.link.repetition.mean_interval_s();
    if (!(band_hz > prf_hz)) return;
    add("radar",
        core::warning(
            "prf.below-doppler-band",
            "the PRF is below the Doppler bandwidth of the scene: azimuth spectra of the targets overlap" + scope_)
            .found(fmt::format("PRF {}", core::with_prefix(prf_hz, "Hz", 4)))
            .expected(fmt::format("at least {}", core::with_prefix(band_hz, "Hz", 4)))
            .hint(fmt::format("after focusing, targets have azimuth ambiguities {} apart; raise the PRF, shorten the "
                              "azimuth window or narrow the beam",
                              core::with_prefix(prf_hz, "Hz", 4))));
  }

  void check_lsb(const EchoSurvey& survey, const Acquisition& acquisition) {
    const bool counts = scene::values_of(simulation_.format) == scene::SampleValues::counts;
    const bool classic_compressed = acquisition.reception.compressor && acquisition.scene->conventions.compression ==
                                                                            Conventions::Compression::pulse_energy;
    if (!counts || classic_compressed || simulation_.lsb_v <= 0.0 || survey.targets.empty() ||
        acquisition.reception.stc_gain.size() > 0)
      return;
    const double strongest = survey.totals.strongest_v + 3.0 * acquisition.reception.noise_stddev_v;
    if (strongest <= 0.0) return;
    // Echoes that meet each other may add up to this.
    const double max_v = std::max(survey.largest_sum_v, strongest);
    const double full_v = simulation_.lsb_v * radar::full_scale_count(simulation_.bits);
    const auto millivolts = [](double v) { return core::format_number(v, 3) + " mV"; };
    const auto rounded = [](double v) { return fmt::format("{:.6g} mV", v * 1e3); };
    if (strongest > 1.01 * full_v)
      add("lsb_v",
          core::warning("lsb.too-small", "the least significant bit is too small: echoes will be clipped" + scope_)
              .found(millivolts(simulation_.lsb_v))
              .expected("about " + rounded(max_v / radar::full_scale_count(simulation_.bits)))
              .hint("set it to 0 to have it estimated from the data"));
    else if (max_v < 0.5 * full_v)
      add("lsb_v",
          core::warning(
              "lsb.too-large",
              fmt::format(
                  "the least significant bit is too large: at most {:.2g} % of the converter's range will be used",
                  100.0 * max_v / full_v) +
                  scope_)
              .found(millivolts(simulation_.lsb_v))
              .expected("about " + rounded(max_v / radar::full_scale_count(simulation_.bits)))
              .hint("set it to 0 to have it estimated from the data"));
  }

  const scene::Scene& scene_;
  std::size_t index_;
  const scene::Simulation& simulation_;
  SurveyReport& report_;
  core::Problems& problems_;
  std::set<std::size_t>& impossible_;
  std::string scope_;
};

}  // namespace

SurveyReport survey_report(const scene::Scene& scene, std::shared_ptr<const ResolvedScene> resolved,
                           const core::WorkControl& control) {
  SurveyReport report;
  if (scene.simulations.empty()) return report;
  if (!resolved) resolved = std::make_shared<const ResolvedScene>(resolve(scene, control));
  std::set<std::size_t> impossible;
  for (std::size_t i = 0; i < scene.simulations.size(); ++i)
    Surveyor(scene, i, report, impossible).look(resolved, control);
  return report;
}

core::Problems survey(const scene::Scene& scene, std::shared_ptr<const ResolvedScene> resolved,
                      const core::WorkControl& control) {
  return survey_report(scene, std::move(resolved), control).problems;
}

}  // namespace sarsim::simulate
