#include "simulate/survey/visibility_rules.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "scene/model/scene_index.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

constexpr double min_pattern = 0.01;   // two-way: below it, targets are seen by side lobes alone
constexpr double good_pattern = 0.25;  // two-way: within the half-power width
constexpr double min_snr = 10.0;       // 10 dB: below it nobody finds a target
constexpr double min_recorded = 0.9;   // of an echo

// Degrees, to a hundredth.
double shown_deg(double angle_rad) { return std::round(100.0 * core::deg_per_rad * angle_rad) / 100.0 + 0.0; }

std::string angles_text(double azimuth_rad, double elevation_rad) {
  return fmt::format("azimuth {:g} deg, elevation {:g} deg", shown_deg(azimuth_rad), shown_deg(elevation_rad));
}

class VisibilityRules {
 public:
  VisibilityRules(const VisibilityCase& sighted, core::Problems& problems)
      : sighted_(sighted), acquisition_(sighted.acquisition), sights_(sighted.summary.sights), problems_(problems) {
    scope_ = sights_.size() == sighted.summary.in_window
                 ? ""
                 : fmt::format(" (estimate from {} of {} targets)", sights_.size(), sighted.summary.in_window);
  }

  void check() {
    check_surface_points();
    if (sights_.empty() || !acquisition_.scene->sheets.empty()) return;
    if (check_beam()) check_noise();
    check_ends();
    check_passages();
    check_beam_band();
  }

 private:
  void add(std::string_view kind, const char* field, core::ProblemBuilder problem) {
    const std::size_t index =
        kind == "radar" ? scene::find_radar(sighted_.scene, acquisition_.simulation.radar) : sighted_.simulation;
    problems_.push_back(std::move(problem).at(std::string(kind), index, field));
  }

  [[nodiscard]] static double best_pattern(const std::vector<TargetVisibility>& sights) {
    double best = 0.0;
    for (const TargetVisibility& sight : sights) best = std::max(best, sight.best_pattern);
    return best;
  }

  // False where nothing useful is received.
  bool check_beam() {
    const double best = best_pattern(sights_);
    const bool silent = sighted_.summary.strongest().amplitude_v == 0.0;
    if (silent && best >= min_pattern) {
      // `check` has already warned of negative cross-sections.
      if (std::ranges::all_of(sights_, [&](const TargetVisibility& s) {
            return acquisition_.scene->scatterers[s.target].rcs_m2 < 0.0;
          }))
        return false;
      add("simulation", "",
          core::warning("targets.reflect-nothing",
                        "no echo is received: no target reflects towards the radar while it is illuminated" + scope_)
              .expected("a target with a radar cross-section above 0 that faces the radar"));
      return false;
    }
    if (best >= min_pattern) return true;
    const std::string what =
        silent ? "no echo is received: the beam points away from all targets"
               : fmt::format(
                     "the beam misses all targets: even the best of them is {:.1f} dB below the beam's two-way peak",
                     -core::power_db(best));
    const radar::Beam& beam = acquisition_.link.beam;
    const radar::BeamOffset to = sighted_.survey.direction();
    std::string found = beam.kind == radar::Beam::Kind::fixed
                            ? "a beam at " + angles_text(beam.azimuth_rad, beam.elevation_rad)
                        : beam.kind == radar::Beam::Kind::rotating
                            ? fmt::format("a beam at elevation {:g} deg", shown_deg(beam.elevation_rad))
                            : "";
    add("radar", "beam_elevation",
        core::warning("beam.misses-targets", what + scope_)
            .found(std::move(found))
            .expected("a beam on the targets, which are at " + angles_text(to.azimuth_rad, to.elevation_rad) +
                      " from the radar at the middle pulse")
            .hint(beam_hint(to)));
    return false;
  }

  [[nodiscard]] bool meets(const radar::Beam& beam) const {
    return best_pattern(sighted_.survey.look(beam, sighted_.control)) >= good_pattern;
  }

  // What to change in the beam: one of the usual mistakes, where it explains all.
  [[nodiscard]] std::string beam_hint(const radar::BeamOffset& to) const {
    const radar::Beam& beam = acquisition_.link.beam;
    radar::Beam other = beam;
    other.elevation_rad = -beam.elevation_rad;
    if (beam.kind == radar::Beam::Kind::rotating)
      return meets(other) ? upwards(beam)
                          : "Set the elevation of the beam to that of the targets; below the horizon it is negative.";
    if (beam.kind != radar::Beam::Kind::fixed)
      return "Aim the beam at the targets: its points are positions in the world, in metres.";
    if (meets(other)) return upwards(beam);
    other.azimuth_rad = beam.elevation_rad;
    other.elevation_rad = beam.azimuth_rad;
    if (meets(other)) return "Azimuth and elevation seem to be swapped: in a script the elevation comes first.";
    other = beam;
    other.azimuth_rad = beam.azimuth_rad + core::pi;
    if (meets(other)) return "The beam points the opposite way: add 180 degrees to its azimuth.";
    return fmt::format(
        "Set the azimuth to {:g} and the elevation to {:g} degrees. Angles are measured in the platform's frame: "
        "azimuth 0 "
        "is +y, 90 is +x, and an elevation below the horizon is negative.",
        shown_deg(to.azimuth_rad), shown_deg(to.elevation_rad));
  }

  [[nodiscard]] static std::string upwards(const radar::Beam& beam) {
    return fmt::format(
        "The sign of the elevation is wrong: write {:g}. Elevation is positive upwards; a beam that points down has a "
        "negative elevation.",
        shown_deg(-beam.elevation_rad));
  }

  void check_noise() {
    if (!sighted_.summary.noise) return;
    const TargetVisibility& best = *std::ranges::max_element(sights_, {}, &TargetVisibility::processed_snr);
    if (best.processed_snr >= min_snr) return;
    add("simulation", "",
        core::warning("noise.drowns-echoes",
                      "the echoes have too low an SNR for detection, even after integrating all pulses" + scope_)
            .found(fmt::format("target {}: SNR {:.1f} dB per pulse, {:.1f} dB with all pulses integrated",
                               best.target + 1, core::power_db(best.snr), core::power_db(best.processed_snr)))
            .expected(fmt::format("{:.0f} dB or more with all pulses integrated", core::power_db(min_snr)))
            .hint(fmt::format(
                "Raise power, antenna gains, pulse width or cross-sections by {:.0f} dB, or lower the noise "
                "temperature (0: no noise).",
                std::ceil(core::power_db(min_snr / best.processed_snr)))));
  }

  struct Extent {
    double first_m = 0.0;
    double last_m = 0.0;
  };

  // The share of an echo from this range that a raw window holds; of a compressed one all or nothing.
  [[nodiscard]] double recorded(double range_m) const {
    const double c = acquisition_.light_speed_mps();
    if (acquisition_.reception.compressor) {
      const double spacing_m = radar::range_of(acquisition_.reception.raw_grid.interval_s, c);
      return range_m > acquisition_.simulation.range_start_m - spacing_m &&
                     range_m < acquisition_.simulation.range_end_m + spacing_m
                 ? 1.0
                 : 0.0;
    }
    const double begin_s = radar::delay_of(range_m, c) - acquisition_.reception.pulse.lead_s;
    const double end_s = begin_s + acquisition_.link.pulse.width_s;
    const double window_end_s = acquisition_.reception.raw_grid.time_s(acquisition_.reception.raw_grid.count);
    return std::max(0.0, std::min(end_s, window_end_s) - std::max(begin_s, acquisition_.reception.raw_grid.first_s)) /
           acquisition_.link.pulse.width_s;
  }

  void check_ends() {
    if (acquisition_.reception.profiler) return;
    const double c = acquisition_.light_speed_mps();
    const double pulse_m =
        acquisition_.reception.compressor ? 0.0 : radar::range_of(acquisition_.link.pulse.width_s, c);
    const double lead_m =
        acquisition_.reception.compressor ? 0.0 : radar::range_of(acquisition_.reception.pulse.lead_s, c);
    const std::string raw =
        fmt::format("A raw echo is {:.4g} m long and begins {:.4g} m before its target's range.", pulse_m, lead_m);
    std::vector<std::size_t> cut;
    bool leaves = false;  // more than the end of an echo, which the focus of the script itself does not lose
    const Extent window{acquisition_.simulation.range_start_m, acquisition_.simulation.range_end_m};
    Extent wanted = window;
    double least = 1.0;
    for (const TargetVisibility& s : sights_) {
      const double share = std::min({recorded(s.range_m), recorded(s.nearest_m), recorded(s.farthest_m)});
      if (s.amplitude_v == 0.0 || share >= min_recorded) continue;
      cut.push_back(s.target + 1);
      least = std::min(least, share);
      leaves = leaves || s.nearest_m - lead_m < window.first_m || s.farthest_m > window.last_m;
      wanted.first_m = std::min(wanted.first_m, std::floor(s.nearest_m - lead_m));
      wanted.last_m = std::max(wanted.last_m, std::ceil(s.farthest_m + pulse_m - lead_m));
    }
    if (cut.empty()) return;
    const bool too_short = window.last_m - window.first_m < pulse_m;
    add("simulation", "range_start_m",
        core::ProblemBuilder(
            leaves ? core::Severity::warning : core::Severity::note, "range-window.cuts-echoes",
            too_short
                ? "the slant range window is shorter than the pulse: no echo is recorded completely"
                : fmt::format("the slant range window cuts the echoes of {} of {} targets ({}) while the beam is on "
                              "them: their images are weaker and wider, or missing{}",
                              cut.size(), sights_.size(), list_of(cut), scope_))
            .found(fmt::format("{} to {} m, which holds {:.0f} % of an echo", core::format_number(window.first_m),
                               core::format_number(window.last_m), 100.0 * least))
            .expected(fmt::format("about {:.0f} to {:.0f} m", wanted.first_m, wanted.last_m))
            .hint(acquisition_.reception.compressor ? "" : raw));
  }

  [[nodiscard]] static std::string list_of(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 5); ++i)
      text += (i > 0 ? ", " : "") + std::to_string(numbers[i]);
    return numbers.size() > 5 ? text + ", ..." : text;
  }

  // Targets that the beam is nearest to when the recording begins or ends, and not on: it passes them at other times.
  void check_passages() {
    if (acquisition_.link.beam.kind != radar::Beam::Kind::fixed || acquisition_.timing.pulses.count() < 16) return;
    PulseGeometry geometry(*acquisition_.scene, acquisition_.link);
    geometry.set_pulse(acquisition_.timing.pulses.first);
    if (core::norm(geometry.radar_pose().velocity_world_mps) == 0.0) return;
    std::vector<std::size_t> missed;
    for (const TargetVisibility& s : sights_)
      if ((s.pulse == acquisition_.timing.pulses.first || s.pulse == acquisition_.timing.pulses.last) &&
          s.best_pattern < good_pattern)
        missed.push_back(s.target + 1);
    if (missed.empty() || best_pattern(sights_) < min_pattern) return;
    add("simulation", "time_start_s",
        core::note("beam.passes-outside-window",
                   fmt::format("the beam passes {} of {} targets ({}) before or after the azimuth window: their images "
                               "are weak, at the image edge or outside the image{}",
                               missed.size(), sights_.size(), list_of(missed), scope_))
            .found(fmt::format("{} to {} s", core::format_number(acquisition_.simulation.time_start_s),
                               core::format_number(acquisition_.simulation.time_end_s)))
            .expected("a window in which the beam passes all targets of interest"));
  }

  // Points that fill a surface stand a metre apart: at short wavelengths they form a lattice that reflects to the side.
  void check_surface_points() {
    const double wavelength_m =
        radar::wavelength_of(acquisition_.link.carrier.highest_hz(), acquisition_.light_speed_mps());
    if (acquisition_.scene->sheets.empty() || wavelength_m >= 2.0) return;
    add("simulation", "radar",
        core::note("surfaces.too-few-points",
                   "surfaces are sampled at one point per square metre, too coarse for this wavelength: away from the "
                   "specular direction, grating lobes as strong as the specular echo appear")
            .found(fmt::format("a wavelength of {}", core::with_prefix(wavelength_m, "m", 3)))
            .expected("2 m or more")
            .hint("The specular echo has errors of up to 10 dB at wavelengths of 10 m to 1 m, and of 40 dB at 3 cm. "
                  "Use targets."));
  }

  // The Doppler band of the beam of an antenna that moves.
  void check_beam_band() {
    if (acquisition_.link.transmit.kind != radar::AntennaPattern::Kind::sinx ||
        acquisition_.timing.pulses.count() < 16 || acquisition_.reception.profiler ||
        acquisition_.link.beam.kind == radar::Beam::Kind::rotating)
      return;
    PulseGeometry geometry(*acquisition_.scene, acquisition_.link);
    geometry.set_pulse(acquisition_.timing.pulses.first + acquisition_.timing.pulses.count() / 2);
    const double speed_mps = core::norm(geometry.radar_pose().velocity_world_mps);
    const double wavelength_m = radar::wavelength_of(geometry.carrier_hz(), acquisition_.light_speed_mps());
    const double half_width = 0.5 * std::min(acquisition_.link.transmit.azimuth_beamwidth_rad, 3.1);
    const double band_hz = 4.0 * speed_mps / wavelength_m * std::sin(half_width);
    const double prf_hz = 1.0 / acquisition_.link.repetition.mean_interval_s();
    if (band_hz <= prf_hz) return;
    add("radar", "prf_hz",
        core::note("prf.below-beam-band",
                   "the beam's Doppler bandwidth exceeds the PRF: targets away from beam centre may be aliased")
            .found(fmt::format("PRF {}", core::with_prefix(prf_hz, "Hz", 4)))
            .expected(fmt::format("at least {} for all of the beam", core::with_prefix(band_hz, "Hz", 4))));
  }

  const VisibilityCase& sighted_;
  const Acquisition& acquisition_;
  const std::vector<TargetVisibility>& sights_;
  core::Problems& problems_;
  std::string scope_;
};

}  // namespace

void check_visibility(const VisibilityCase& sighted, core::Problems& problems) {
  VisibilityRules(sighted, problems).check();
}

}  // namespace sarsim::simulate
