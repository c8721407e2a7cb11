#include "simulate/survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "receiver/converter.hpp"
#include "simulate/impossible_echo.hpp"

namespace sarsim {

namespace {

constexpr std::size_t most_pulses = 64;        // decisions: "at most 64 pulses x all targets, labelled as an estimate"
constexpr std::size_t most_views = 1'000'000;  // targets times pulses: a look takes well below a second
constexpr double closest_m = 1e-9;             // a target nearer than this stands on the radar

// Pulse numbers to look at: all, or an even choice that includes the first and the last.
std::vector<std::int64_t> sampled_pulses(const PulseRange& range, std::size_t targets) {
  std::vector<std::int64_t> pulses;
  const std::int64_t count = range.count();
  const std::size_t affordable =
      std::clamp<std::size_t>(most_views / std::max<std::size_t>(targets, 1), 3, most_pulses);
  const std::int64_t looks = std::min<std::int64_t>(count, static_cast<std::int64_t>(affordable));
  for (std::int64_t i = 0; i < looks; ++i) {
    const double share = looks > 1 ? static_cast<double>(i) / static_cast<double>(looks - 1) : 0.0;
    pulses.push_back(range.first + std::llround(share * static_cast<double>(count - 1)));
  }
  return pulses;
}

void take_in(TargetSurvey& target, const ScattererView& view, double range_m, double doppler_hz, bool in_window) {
  target.nearest_m = std::min(target.nearest_m, range_m);
  target.farthest_m = std::max(target.farthest_m, range_m);
  target.lowest_doppler_hz = std::min(target.lowest_doppler_hz, doppler_hz);
  target.highest_doppler_hz = std::max(target.highest_doppler_hz, doppler_hz);
  target.largest_amplitude_v = std::max(target.largest_amplitude_v, std::abs(view.amplitude_sqrt_w));
  target.largest_speed_mps = std::max(target.largest_speed_mps, std::abs(view.speed_mps));
  target.in_window = target.in_window || in_window;
}

// A plane shows the same side to the radar at all of its points.
bool faces_radar(const ScattererSheet& sheet, const PulseGeometry& geometry) {
  if (sheet.points_m.empty()) return false;
  const Pose& pose = geometry.pose(sheet.platform);
  const Vec3 look_world_m = world_position_m(pose, sheet.points_m.front()) - geometry.radar_pose().position_world_m;
  return dot(pose.world_from_platform * sheet.normal_platform, look_world_m) < 0.0;
}

// The Doppler band of the echoes that matter: those in the window and within 40 dB of the strongest one.
void take_band(EchoSurvey& survey) {
  double strongest = 0.0;
  for (const TargetSurvey& t : survey.targets)
    if (t.in_window) strongest = std::max(strongest, t.largest_amplitude_v);
  bool any = false;
  for (const TargetSurvey& t : survey.targets) {
    if (!t.in_window || t.largest_amplitude_v < 0.01 * strongest) continue;
    survey.lowest_doppler_hz = any ? std::min(survey.lowest_doppler_hz, t.lowest_doppler_hz) : t.lowest_doppler_hz;
    survey.highest_doppler_hz = any ? std::max(survey.highest_doppler_hz, t.highest_doppler_hz) : t.highest_doppler_hz;
    any = true;
  }
}

// Collects the problems of one simulation.
class Surveyor {
 public:
  Surveyor(const Scene& scene, std::size_t index, Problems& problems)
      : scene_(scene), index_(index), simulation_(scene.simulations[index]), problems_(problems) {}

  void look(const std::shared_ptr<const ResolvedScene>& resolved) {
    const Plan plan = make_plan(scene_, index_, resolved);
    check_weights(plan);
    if (plan.profiler && !check_bursts(plan)) return;
    const EchoSurvey survey = survey_echoes(plan);
    scope_ = survey.all_pulses
                 ? ""
                 : fmt::format(" (estimate from {} of {} pulses)", survey.pulses_sampled, plan.pulses.count());
    if (!check_echoes(survey, plan)) return;
    check_surfaces(survey, plan);
    check_window(survey, plan);
    check_doppler(survey, plan);
    check_lsb(survey, plan);
    check_ambiguity(survey, plan);
  }

 private:
  void add(Severity severity, const char* field, std::string message, std::string found, std::string expected,
           std::string hint) {
    problems_.push_back({severity,
                         std::move(message),
                         std::move(found),
                         std::move(expected),
                         std::move(hint),
                         {},
                         {"simulation", index_, field},
                         1});
  }

  // A window that is 0 at its ends leaves nothing of a pulse, or a burst, of one or two samples.
  void check_weights(const Plan& plan) {
    double sum = 0.0;
    std::size_t count = 0;
    if (plan.profiler) {
      count = plan.profiler->steps();
      for (std::size_t n = 0; n < count; ++n)
        sum += count > 1 ? plan.radar.window(static_cast<double>(n) / static_cast<double>(count - 1)) : 1.0;
    } else if (plan.compressor) {
      const double pulse_samples = plan.radar.pulse.width_s * simulation_.sample_rate_hz;
      for (; count == 0 || static_cast<double>(count) < pulse_samples - 1e-9; ++count)
        sum += plan.radar.window(static_cast<double>(count) / pulse_samples);
    }
    if (count == 0 || sum != 0.0) return;
    add(Severity::warning, "radar", "the radar's window function leaves nothing: every sample of it is 0",
        fmt::format("{} samples", count), "a window that is above 0 somewhere",
        plan.profiler ? "take more frequency steps or another window" : "sample faster or take another window");
  }

  bool check_bursts(const Plan& plan) {
    if (plan.rows == 0) {
      add(Severity::error, "time_end_s", "the window holds no complete burst of stepped frequencies",
          fmt::format("{} pulses", plan.pulses.count()),
          fmt::format("at least {} from the start of a burst", plan.burst_pulses()),
          "lengthen the azimuth window; bursts start at pulse numbers that are multiples of steps times pulses per "
          "step");
      return false;
    }
    if (plan.dropped_pulses > 0)
      add(Severity::note, "time_end_s",
          fmt::format("{} pulses of incomplete bursts at the ends of the window are left out", plan.dropped_pulses), "",
          "", "");
    return true;
  }

  // Echoes that no recording can hold. A target is reported once, whatever else looks at it.
  bool check_echoes(const EchoSurvey& survey, const Plan& plan) {
    bool sound = true;
    for (std::size_t i = 0; i < survey.targets.size(); ++i) {
      const TargetSurvey& target = survey.targets[i];
      const EchoExtremes echo{target.nearest_m > closest_m ? target.nearest_m : 0.0, target.largest_speed_mps,
                              target.largest_amplitude_v};
      if (possible_echo(echo, plan.scene->conventions.light_speed_mps)) continue;
      sound = false;
      Problem problem = problem_of_echo("target", i, plan.radar.name, echo, plan.scene->conventions.light_speed_mps);
      const auto same_target = [&](const Problem& p) { return p.subject == problem.subject; };
      if (std::ranges::none_of(problems_, same_target)) problems_.push_back(std::move(problem));
    }
    return sound;
  }

  void check_surfaces(const EchoSurvey& survey, const Plan& plan) {
    for (std::size_t i = 0; i < survey.surface_faces_radar.size(); ++i)
      if (!survey.surface_faces_radar[i] && !plan.scene->sheets[i].points_m.empty())
        problems_.push_back({Severity::warning,
                             "the surface shows its back to the radar and gives no echo" + scope_,
                             "",
                             "a front, where (corner 2 - corner 1) x (corner 3 - corner 1) points, towards the radar",
                             "exchange its second and third corner",
                             {},
                             {"surface", i, "corner_m"},
                             1});
  }

  void check_window(const EchoSurvey& survey, const Plan& plan) {
    if (survey.targets.empty()) {
      if (plan.scene->sheets.empty())
        add(Severity::warning, "",
            "the scene has no target: the recording will hold " +
                std::string(plan.noise_stddev_v > 0 ? "noise only" : "zeros only"),
            "", "", "add a $TARGET");
      return;
    }
    if (std::ranges::any_of(survey.targets, &TargetSurvey::in_window) || !plan.scene->sheets.empty()) return;
    double nearest = survey.targets[0].nearest_m;
    double farthest = survey.targets[0].farthest_m;
    for (const TargetSurvey& t : survey.targets)
      nearest = std::min(nearest, t.nearest_m), farthest = std::max(farthest, t.farthest_m);
    const double reach_m = 0.5 * plan.scene->conventions.light_speed_mps * (plan.pulse.last_s() - plan.pulse.first_s());
    add(Severity::warning, "range_start_m",
        "no echo falls into the slant range window: the recording will be empty" + scope_,
        fmt::format("{} to {} m", format_number(simulation_.range_start_m), format_number(simulation_.range_end_m)),
        fmt::format("a window that touches the echoes from {:.6g} to {:.6g} m", nearest, farthest + reach_m),
        fmt::format("set the slant range window to about {:.0f} ... {:.0f} m", std::floor(nearest),
                    std::ceil(farthest + reach_m)));
  }

  void check_doppler(const EchoSurvey& survey, const Plan& plan) {
    if (plan.pulses.count() < 2 || plan.simulation.processing == Processing::srp) return;
    const double band_hz = survey.highest_doppler_hz - survey.lowest_doppler_hz;
    const double prf_hz = 1.0 / plan.radar.repetition.mean_interval_s();
    if (!(band_hz > prf_hz)) return;
    add(Severity::warning, "radar",
        "the PRF is below the Doppler band of the scene: azimuth spectra of the targets overlap" + scope_,
        fmt::format("PRF {}", with_prefix(prf_hz, "Hz", 4)), fmt::format("at least {}", with_prefix(band_hz, "Hz", 4)),
        fmt::format("targets away from the centre appear as ghosts {} apart after focusing; raise the PRF, shorten the "
                    "azimuth window or narrow the beam",
                    with_prefix(prf_hz, "Hz", 4)));
  }

  void check_lsb(const EchoSurvey& survey, const Plan& plan) {
    const bool counts = simulation_.format != FileFormat::hdf5 && simulation_.format != FileFormat::npy;
    const bool classic_compressed =
        plan.compressor && plan.scene->conventions.compression == Conventions::Compression::pulse_energy;
    if (!counts || classic_compressed || simulation_.lsb_v <= 0.0 || survey.targets.empty() || plan.stc_gain.size() > 0)
      return;
    const double strongest = strongest_in_window(survey) + 3.0 * plan.noise_stddev_v;
    if (strongest <= 0.0) return;
    const double full_v = simulation_.lsb_v * full_scale_count(simulation_.bits);
    const auto millivolts = [](double v) { return format_number(v, 3) + " mV"; };
    const auto rounded = [](double v) { return fmt::format("{:.6g} mV", v * 1e3); };
    if (strongest > 1.01 * full_v)
      add(Severity::warning, "lsb_v", "the least significant bit is too small: echoes will be clipped" + scope_,
          millivolts(simulation_.lsb_v), "about " + rounded(strongest / full_scale_count(simulation_.bits)),
          "set it to 0 to have it estimated from the data");
    else if (std::max(survey.largest_sum_v, strongest) < 0.5 * full_v)
      add(Severity::warning, "lsb_v",
          fmt::format("the least significant bit is too large: at most {:.2g} % of the converter's range will be used",
                      100.0 * std::max(survey.largest_sum_v, strongest) / full_v) +
              scope_,
          millivolts(simulation_.lsb_v), "about " + rounded(strongest / full_scale_count(simulation_.bits)),
          "set it to 0 to have it estimated from the data");
  }

  static double strongest_in_window(const EchoSurvey& survey) {
    double strongest = 0.0;
    for (const TargetSurvey& t : survey.targets)
      if (t.in_window) strongest = std::max(strongest, t.largest_amplitude_v);
    return strongest;
  }

  void check_ambiguity(const EchoSurvey& survey, const Plan& plan) {
    const double unambiguous_m =
        0.5 * plan.scene->conventions.light_speed_mps * plan.radar.repetition.shortest_interval_s();
    std::size_t late = 0;
    double farthest = 0.0;
    for (const TargetSurvey& t : survey.targets)
      if (t.in_window && t.farthest_m > unambiguous_m) ++late, farthest = std::max(farthest, t.farthest_m);
    if (late == 0) return;
    add(Severity::warning, "radar",
        fmt::format("echoes of {} of {} targets arrive after the next pulse has left; a row holds the echoes of its "
                    "own pulse only",
                    late, survey.targets.size()) +
            scope_,
        fmt::format("range {:.6g} m", farthest), fmt::format("at most {:.6g} m, the unambiguous range", unambiguous_m),
        "lower the PRF if a real receiver is meant");
  }

  const Scene& scene_;
  std::size_t index_;
  const Simulation& simulation_;
  Problems& problems_;
  std::string scope_;
};

}  // namespace

EchoSurvey survey_echoes(const Plan& plan) {
  EchoSurvey survey;
  survey.surface_faces_radar.assign(plan.scene->sheets.size(), false);
  const double infinity = std::numeric_limits<double>::infinity();
  survey.targets.assign(plan.scene->scatterers.size(), {infinity, 0.0, infinity, -infinity, 0.0, 0.0, 0.0, false});
  const std::vector<std::int64_t> pulses = sampled_pulses(plan.pulses, plan.scene->scatterers.size());
  survey.pulses_sampled = pulses.size();
  survey.all_pulses = static_cast<std::int64_t>(pulses.size()) == plan.pulses.count();
  const double c = plan.scene->conventions.light_speed_mps;
  PulseGeometry geometry(*plan.scene, plan.radar);
  for (const std::int64_t pulse : pulses) {
    geometry.set_pulse(pulse);
    const Pointing pointing = geometry.pointing();
    for (std::size_t i = 0; i < plan.scene->sheets.size(); ++i)
      if (faces_radar(plan.scene->sheets[i], geometry)) survey.surface_faces_radar[i] = true;
    double sum_v = 0.0;
    for (std::size_t i = 0; i < survey.targets.size(); ++i) {
      const ScattererView view = geometry.view(i, pointing);
      const SampleSpan touched = touched_samples(plan.pulse, plan.raw_grid, view.delay_s);
      const bool in_window = touched.begin < touched.end;
      if (in_window) sum_v += std::abs(view.amplitude_sqrt_w);
      take_in(survey.targets[i], view, 0.5 * c * view.delay_s, -2.0 * view.speed_mps * geometry.carrier_hz() / c,
              in_window);
    }
    survey.largest_sum_v = std::max(survey.largest_sum_v, sum_v);
  }
  const double noise_j = plan.scene->conventions.boltzmann_j_per_k * plan.radar.noise_temperature_k;
  if (noise_j > 0.0)
    for (TargetSurvey& t : survey.targets)
      t.snr = t.largest_amplitude_v * t.largest_amplitude_v * plan.radar.pulse.width_s / noise_j;
  take_band(survey);
  return survey;
}

Problems survey(const Scene& scene) {
  Problems problems;
  if (scene.simulations.empty()) return problems;
  const auto resolved = std::make_shared<const ResolvedScene>(resolve(scene));
  for (std::size_t i = 0; i < scene.simulations.size(); ++i) Surveyor(scene, i, problems).look(resolved);
  return problems;
}

}  // namespace sarsim
