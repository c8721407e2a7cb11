#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"
#include "radar/waveform/pulse.hpp"
#include "scene/check/check.hpp"
#include "scene/check/check_objects.hpp"
#include "scene/check/check_values.hpp"
#include "scene/model/limits.hpp"
#include "scene/model/radar_pulse.hpp"

namespace sarsim::scene {

namespace {

constexpr double exact_integers = 0x1p53;  // every whole number up to here is a double

// The part that recordings and geometry tables share: what is looked at, and when.
struct Window {
  double range_start_m;
  double range_end_m;
  double time_start_s;
  double time_end_s;
};

template <class Product>
Window window_of(const Product& product) {
  return {product.range_start_m, product.range_end_m, product.time_start_s, product.time_end_s};
}

bool check_ends(Findings& findings, const Window& window) {
  const bool range = computable(window.range_start_m) && computable(window.range_end_m);
  const bool time = computable(window.time_start_s) && computable(window.time_end_s);
  bool sound = range && time;
  if (range && window.range_end_m <= window.range_start_m) {
    sound = false;
    findings.error("range_end_m", {.id = "range-window.empty",
                                   .message = "the slant range window is empty",
                                   .found = fmt::format("{} to {}", value_text(window.range_start_m, "m"),
                                                        value_text(window.range_end_m, "m")),
                                   .expected = "an end beyond the start"});
  }
  if (time && window.time_end_s < window.time_start_s) {
    sound = false;
    findings.error("time_end_s", {.id = "azimuth-window.empty",
                                  .message = "the azimuth window ends before it starts",
                                  .found = fmt::format("{} to {}", value_text(window.time_start_s, "s"),
                                                       value_text(window.time_end_s, "s")),
                                  .expected = "an end at or after the start"});
  }
  return sound;
}

// The pulses of the window; none after reporting.
radar::PulseRange check_pulses(Findings& findings, const Window& window, const radar::Repetition& repetition) {
  const double farthest_s = std::max(std::abs(window.time_start_s), std::abs(window.time_end_s));
  if (farthest_s / repetition.mean_interval_s() >= exact_integers) {
    findings.error("time_end_s",
                   {.id = "azimuth-window.too-many-pulses",
                    .message = "the azimuth window is too long or too far from zero to number its pulses",
                    .found = fmt::format("{:.3g} pulses from zero", farthest_s / repetition.mean_interval_s()),
                    .expected = fmt::format("below {:.3g}", exact_integers)});
    return {};
  }
  const radar::PulseRange pulses = repetition.pulses_in(window.time_start_s, window.time_end_s);
  if (pulses.count() > 0) return pulses;
  findings.error(
      "time_end_s",
      {.id = "azimuth-window.no-pulse",
       .message = "no pulse is sent within the azimuth window",
       .found = fmt::format("{} to {}", value_text(window.time_start_s, "s"), value_text(window.time_end_s, "s")),
       .expected = fmt::format("a window that contains the transmit time of a pulse, for instance {} or {}",
                               value_text(repetition.send_time_s(pulses.first - 1), "s"),
                               value_text(repetition.send_time_s(pulses.first), "s")),
       .hint = "Pulse 0 is sent at 0 s."});
  return {};
}

double sample_count(const Simulation& simulation) {
  return std::floor(radar::turns_of(simulation.range_end_m - simulation.range_start_m, simulation.sample_rate_hz,
                                    core::exact_light_speed_mps) +
                    0.5);
}

void report_long_row(Findings& findings, std::string_view field, const char* message, double samples,
                     std::string found) {
  findings.error(field, {.id = "row.too-long",
                         .message = fmt::format("{} of {:.4g} samples is too long", message, samples),
                         .found = std::move(found),
                         .expected = fmt::format("up to {:g} samples", longest_row),
                         .hint = "Sample more slowly or take a shorter one; a row is made in memory."});
}

// What is kept in memory as samples: the row, and the pulse where it is correlated with or limited to a band.
bool check_row_length(Findings& findings, const Simulation& simulation, const Radar& radar, PulseDefinition pulse) {
  const double columns = sample_count(simulation);
  const double steps = simulation.processing == Processing::srp ? radar.carrier_steps : 1;
  if (columns * steps > longest_row) {
    report_long_row(findings, "range_end_m", "a row", columns * steps,
                    fmt::format("{} at {}", value_text(simulation.range_end_m - simulation.range_start_m, "m"),
                                value_text(simulation.sample_rate_hz, "Hz")));
    return false;
  }
  const bool kept = simulation.processing == Processing::matched_filter || pulse == PulseDefinition::band_limited;
  // A pulse that keeps its own band is filtered by 28 of its half bands before and after (decision 7).
  const auto band_hz = nominal_bandwidth_hz(radar);
  const bool own_band = pulse == PulseDefinition::band_limited && simulation.oversampling > 1.0 && band_hz;
  const double skirts_s = own_band ? 112.0 / std::max(*band_hz, 1.0 / radar.pulse_width_s) : 0.0;
  const double pulse_samples =
      (radar.pulse_width_s * std::max(simulation.width_factor, 1.0) + skirts_s) * simulation.sample_rate_hz;
  if (!kept || !(pulse_samples > longest_row)) return true;
  report_long_row(
      findings, "sample_rate_hz", "a pulse", pulse_samples,
      fmt::format("{} at {}", value_text(radar.pulse_width_s, "s"), value_text(simulation.sample_rate_hz, "Hz")));
  return false;
}

void check_samples(Findings& findings, const Simulation& simulation, double rows) {
  const double columns = sample_count(simulation);
  if (columns < 1.0) {
    findings.error("sample_rate_hz",
                   {.id = "range-window.no-sample",
                    .message = "the slant range window is too short for one sample",
                    .found = fmt::format("{} at {}", value_text(simulation.range_end_m - simulation.range_start_m, "m"),
                                         value_text(simulation.sample_rate_hz, "Hz")),
                    .expected = fmt::format(
                        "at least {:.4g} m or {}",
                        0.5 * radar::range_of_cycle(simulation.sample_rate_hz, core::exact_light_speed_mps),
                        value_text(radar::frequency_of_turns(0.5, simulation.range_end_m - simulation.range_start_m,
                                                             core::exact_light_speed_mps),
                                   "Hz")),
                    .hint = "Samples lie c/(2 fs) apart. Scripts give ranges in metres."});
    return;
  }
  if (std::max(rows, 1.0) * columns > exact_integers)
    findings.error("time_end_s", {.id = "recording.too-large",
                                  .message = fmt::format("a recording of {:.2g} samples cannot be made",
                                                         std::max(rows, 1.0) * columns),
                                  .found = fmt::format("{:.4g} pulses of {:.4g} samples", std::max(rows, 1.0), columns),
                                  .expected = fmt::format("fewer than {:.2g} samples", exact_integers),
                                  .hint = "Shorten the window or sample more slowly."});
}

void check_file(Findings& findings, std::string_view file) {
  const std::string_view base = file.substr(file.find_last_of("/\\") + 1);
  if (!base.empty() && base != "." && base != "..") return;
  findings.error("file", {.id = "output.no-name",
                          .message = "the output file has no name",
                          .found = std::string(file),
                          .expected = "the name of a file"});
}

// Only a band-limited pulse is shaped by them (decision 7).
void check_pulse_factors(Findings& findings, const Simulation& simulation, PulseDefinition pulse) {
  if (simulation.width_factor > 0.0 && simulation.width_factor < 1.0)
    findings.error("width_factor", {.id = "band-limited-pulse.too-short",
                                    .message = "the kept length of a band-limited pulse is below its nominal length",
                                    .found = value_text(simulation.width_factor, ""),
                                    .expected = "0, which keeps all of it, or 1 to 100 pulse widths"});
  const bool numbers =
      is_sound<&Simulation::oversampling>(simulation) && is_sound<&Simulation::width_factor>(simulation);
  if (!numbers || pulse != PulseDefinition::ideal) return;
  if (simulation.oversampling == 1.0 && simulation.width_factor <= 1.0) return;
  findings.note(
      simulation.oversampling == 1.0 ? "width_factor" : "oversampling",
      {.id = "ideal-pulse.needless-values",
       .message = "the pulse is ideal: its over-sampling factor and kept length have no effect",
       .found =
           fmt::format("{} and {}", value_text(simulation.oversampling, ""), value_text(simulation.width_factor, "")),
       .expected = "1 and 0, or a pulse that is limited to its band",
       .hint =
           simulation.oversampling == 1.0
               ? "They take effect with PULSE BAND_LIMITED in $OPTIONS (or --pulse band-limited) and a factor above 1."
               : "They take effect with PULSE BAND_LIMITED in $OPTIONS (or --pulse band-limited)."});
}

void check_converter(Findings& findings, const Simulation& simulation) {
  if (simulation.bits > 53)
    findings.warning(Consequence::surprise, "bits",
                     {.id = "bits.beyond-exact",
                      .message = "numbers are exact to 53 bits only; the lowest bits of larger ones are meaningless",
                      .found = std::to_string(simulation.bits),
                      .expected = "up to 53"});
}

// The band that sampling has to keep. A given shape has edges of any kind, and what lies beyond nine tenths of its
// energy is no more than what the band of an unmodulated pulse or a code leaves out.
std::optional<double> band_to_keep_hz(const Radar& radar) {
  const auto bandwidth_hz = nominal_bandwidth_hz(radar);
  if (!bandwidth_hz || radar.pulse != Radar::Pulse::user) return bandwidth_hz;
  return radar::energy_band_hz(pulse_of(radar), 0.9);
}

void check_bandwidth(Findings& findings, const Simulation& simulation, const Radar& radar, PulseDefinition pulse) {
  const auto bandwidth_hz = band_to_keep_hz(radar);
  // A part in 10^9 is rounding: 1/Tp of a width in nanoseconds need not be the double that was meant.
  if (!bandwidth_hz || simulation.sample_rate_hz >= *bandwidth_hz * (1.0 - 1e-9)) return;
  const double beyond_hz = *bandwidth_hz - simulation.sample_rate_hz;
  const bool folds = pulse == PulseDefinition::ideal;
  findings.warning(
      folds ? Consequence::false_signal : Consequence::lost_signal, "sample_rate_hz",
      {.id = "sampling.below-bandwidth",
       .message = "the sampling frequency is below the bandwidth of the pulse",
       .found = value_text(simulation.sample_rate_hz, "Hz"),
       .expected = fmt::format("at least {}{}", value_text(*bandwidth_hz, "Hz"),
                               radar.pulse == Radar::Pulse::user ? ", which contains 90 % of its energy" : ""),
       .hint = folds ? fmt::format(
                           "The outer {} of the spectrum alias back into the band and show as false or smeared echoes.",
                           value_text(beyond_hz, "Hz"))
                     : fmt::format("The outer {} of the spectrum are cut off, which costs range resolution.",
                                   value_text(beyond_hz, "Hz"))});
}

// With centred pulses, ranges are those of the middle of the echo, whose first half arrives earlier.
void check_ranges(Findings& findings, const Simulation& simulation, const Radar& radar,
                  const radar::Repetition& repetition) {
  const bool centred = simulation.pulse_position == Simulation::PulsePosition::centre;
  const double lead_m = centred ? radar::range_of(0.5 * radar.pulse_width_s, core::exact_light_speed_mps) : 0.0;
  if (simulation.range_start_m < -lead_m)
    findings.warning(
        Consequence::surprise, "range_start_m",
        {.id = "range-window.before-radar",
         .message = "the slant range window starts before the radar; that part is empty",
         .found = value_text(simulation.range_start_m, "m"),
         .expected = centred ? value_text(-lead_m, "m") + " or more, half a pulse before the radar" : "0 m or more"});
  const double unambiguous_m = radar::range_of(repetition.shortest_interval_s(), core::exact_light_speed_mps);
  if (simulation.range_end_m <= unambiguous_m) return;
  findings.warning(
      Consequence::lost_signal, "range_end_m",
      {.id = "range-window.beyond-unambiguous",
       .message = "the slant range window reaches beyond the unambiguous range",
       .found = value_text(simulation.range_end_m, "m"),
       .expected = fmt::format("up to {:.6g} m, c/2 times the shortest pulse interval", unambiguous_m),
       .hint = "Echoes from there arrive after the next pulse is sent, among its echoes. From orbit this is normal."});
}

void check_burst(Findings& findings, const Radar& radar, const radar::PulseRange& pulses) {
  const std::int64_t length = std::int64_t{radar.carrier_steps} * radar.pulses_per_step;
  const std::int64_t first = -radar::floor_divide(-pulses.first, length);
  const std::int64_t beyond = radar::floor_divide(pulses.last + 1, length);
  if (pulses.count() == 0 || first < beyond) return;
  findings.error("time_end_s", {.id = "bursts.none-complete",
                                .message = "the azimuth window contains no complete burst of frequency steps",
                                .found = fmt::format("pulses {} to {}", pulses.first, pulses.last),
                                .expected = fmt::format(
                                    "all {0} pulses of a burst; a burst begins at each multiple of {0}", length)});
}

// A range profile is synthesised from the steps of a burst: there have to be some, and they have to fit the pulse.
void check_profile(Findings& findings, const Radar& radar, const radar::PulseRange& pulses) {
  if (radar.carrier != Radar::Carrier::stepped || radar.carrier_steps < 2) {
    findings.error("processing",
                   {.id = "profiles.no-steps",
                    .message = "synthetic range profiles need a carrier with at least two frequency steps",
                    .found = radar.carrier == Radar::Carrier::stepped ? fmt::format("{} step", radar.carrier_steps)
                                                                      : std::string("a carrier that does not step"),
                    .expected = "STEPPED with 2 or more steps"});
    return;
  }
  if (!std::isfinite(radar.carrier_step_hz) || radar.pulses_per_step < 1) return;
  if (radar.carrier_step_hz == 0.0) {
    findings.error("processing", {.id = "profiles.zero-step",
                                  .message = "synthetic range profiles need a frequency step other than zero",
                                  .found = value_text(radar.carrier_step_hz, "Hz"),
                                  .expected = "a step up to the bandwidth of the pulse"});
    return;
  }
  check_burst(findings, radar, pulses);
  if (radar.pulse == Radar::Pulse::chirp || radar.pulse == Radar::Pulse::barker)
    findings.warning(Consequence::surprise, "processing",
                     {.id = "profiles.modulated-pulse",
                      .message = "the pulse is modulated, but its sub-bands are not joined: one sample of each step "
                                 "makes the profile",
                      .found = radar.pulse == Radar::Pulse::chirp ? "a chirp" : "a Barker code",
                      .expected = "MONO",
                      .hint = "The resolution is that of the steps alone."});
  const double step_hz = std::abs(radar.carrier_step_hz);
  if (radar.pulse_width_s * step_hz > 1.0 + 1e-9)
    findings.warning(
        Consequence::false_signal, "processing",
        {.id = "profiles.shorter-than-pulse",
         .message = "the frequency step exceeds 1/pulse width: the unambiguous profile is shorter than the pulse",
         .found = fmt::format("profile of {:.4g} m, pulse of {:.4g} m",
                              radar::range_of_cycle(step_hz, core::exact_light_speed_mps),
                              radar::range_of(radar.pulse_width_s, core::exact_light_speed_mps)),
         .expected = fmt::format("steps up to {} or a pulse up to {}", value_text(1.0 / radar.pulse_width_s, "Hz"),
                                 value_text(1.0 / step_hz, "s")),
         .hint = "Targets of one range gate alias onto each other."});
}

}  // namespace

void check_simulation(Findings& findings, NameCheck& radars, const Scene& scene, const Simulation& simulation) {
  const std::size_t index = radars.resolve(findings, "radar", simulation.radar);
  check_values(findings, simulation);
  const bool window_sound = check_ends(findings, window_of(simulation));
  const bool rate_sound = is_sound<&Simulation::sample_rate_hz>(simulation);
  check_converter(findings, simulation);
  check_pulse_factors(findings, simulation, scene.options.pulse);
  check_file(findings, simulation.file);

  const Radar* radar = index == not_found ? nullptr : &scene.radars[index];
  const auto repetition = radar == nullptr ? std::nullopt : repetition_of(*radar);
  radar::PulseRange pulses;
  if (window_sound && repetition) {
    pulses = check_pulses(findings, window_of(simulation), *repetition);
    check_ranges(findings, simulation, *radar, *repetition);
  }
  const bool rows_fit = !window_sound || !rate_sound || radar == nullptr ||
                        check_row_length(findings, simulation, *radar, scene.options.pulse);
  if (window_sound && rate_sound && rows_fit) check_samples(findings, simulation, static_cast<double>(pulses.count()));
  if (radar != nullptr && rate_sound) check_bandwidth(findings, simulation, *radar, scene.options.pulse);
  if (radar != nullptr && simulation.processing == Processing::srp) check_profile(findings, *radar, pulses);
  if (radar != nullptr && rate_sound) check_plausible_simulation(findings, scene, simulation, *radar, pulses);
}

void check_geometry_table(Findings& findings, NameCheck& radars, const Scene& scene, const GeometryTable& table) {
  const std::size_t index = radars.resolve(findings, "radar", table.radar);
  check_values(findings, table);
  const bool window_sound = check_ends(findings, window_of(table));
  if (table.columns < 0 || table.columns > 255)
    findings.error("columns", {.id = "geometry.columns",
                               .message = "the choice of columns is out of range",
                               .found = std::to_string(table.columns),
                               .expected = "0 to 255, the sum of the numbers of the columns"});
  check_file(findings, table.file);
  if (!scene.clouds.empty())
    findings.note(
        "", {.id = "geometry.no-clouds", .message = "the table lists targets only: cloud points have no columns"});
  const auto repetition = index == not_found ? std::nullopt : repetition_of(scene.radars[index]);
  if (window_sound && repetition) check_pulses(findings, window_of(table), *repetition);
}

void check_file_names(Findings& findings, const Scene& scene) {
  std::unordered_map<std::string_view, int> met;
  const auto meet = [&](std::string_view kind, std::size_t index, std::string_view file) {
    const std::string_view base = file.substr(file.find_last_of("/\\") + 1);
    const int times = ++met[base];
    if (times == 1 || base.empty()) return;
    const std::size_t dot = base.find_last_of('.');
    const std::string_view stem = base.substr(0, dot);
    const std::string_view extension = dot == std::string_view::npos ? std::string_view{} : base.substr(dot);
    findings.about(kind, index);
    findings.warning(Consequence::surprise, "file",
                     {.id = "output.same-name",
                      .message = "another product has the same file name",
                      .found = std::string(base),
                      .expected = "a name of its own",
                      .hint = fmt::format("This one is written as {}-{}{}.", stem, times, extension)});
  };
  for (std::size_t i = 0; i < scene.simulations.size(); ++i) meet("simulation", i, scene.simulations[i].file);
  for (std::size_t i = 0; i < scene.geometries.size(); ++i) meet("geometry", i, scene.geometries[i].file);
}

}  // namespace sarsim::scene
