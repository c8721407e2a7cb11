#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "scene/check/carrier_span.hpp"
#include "scene/check/check.hpp"
#include "scene/check/check_objects.hpp"
#include "scene/check/check_values.hpp"
#include "scene/model/format_values.hpp"
#include "scene/model/limits.hpp"
#include "scene/model/scene_index.hpp"

/// Values that can be simulated but are probably mistakes.
namespace sarsim::scene {

namespace {

constexpr double min_time_bandwidth = 10.0;  // below it the spectrum of a chirp has no band
constexpr double max_oversampling = 20.0;
constexpr double min_oversampling = 1.05;
constexpr double widest_beam_deg = 40.0;
constexpr double longest_extrapolation = 200.0;  // times the points of a trajectory

bool has_band(const Radar& radar) { return radar.pulse == Radar::Pulse::chirp && radar.bandwidth_hz != 0.0; }

void check_usual_carrier(Findings& findings, const Radar& radar) {
  constexpr double highest_hz = 1e12;
  constexpr double lowest_hz = 1e5;
  const double carrier_hz = radar.carrier_hz;
  if (radar.carrier != Radar::Carrier::user && computable(carrier_hz) && carrier_hz > 0.0 &&
      (carrier_hz > highest_hz || carrier_hz < lowest_hz)) {
    const bool high = carrier_hz > highest_hz;
    findings.warning(
        Consequence::surprise, "carrier_hz",
        {.id = "carrier.unusual",
         .message = fmt::format("the carrier frequency is {} those that radars use", high ? "above" : "below"),
         .found = value_text(carrier_hz, "Hz"),
         .expected = "100 kHz to 1 THz",
         .hint = high ? fmt::format("Scripts give it in GHz: write {} for {}.",
                                    core::format_number(core::tidy(1e-12 * carrier_hz)),
                                    value_text(1e-3 * carrier_hz, "Hz"))
                      : "Scripts give it in GHz."});
  }
}

void check_band_above_zero(Findings& findings, const Radar& radar) {
  const auto carriers = carrier_span(radar);
  if (!has_band(radar) || !carriers) return;
  const double lowest_hz = carriers->lowest_hz;
  if (!(lowest_hz > 0.0) || lowest_hz >= 0.5 * std::abs(radar.bandwidth_hz)) return;
  findings.warning(
      Consequence::false_signal, "bandwidth_hz",
      {.id = "chirp.below-zero",
       .message = "the chirp's band reaches below 0 Hz, where no radar transmits",
       .found = fmt::format("{} around a carrier of {}", value_text(std::abs(radar.bandwidth_hz), "Hz"),
                            value_text(lowest_hz, "Hz")),
       .expected = fmt::format("a bandwidth up to {}, twice the carrier", value_text(2.0 * lowest_hz, "Hz")),
       .hint = "The samples follow the formula all the same; frequencies below 0 Hz have no physical meaning."});
}

void check_time_bandwidth(Findings& findings, const Radar& radar) {
  if (!has_band(radar) || radar.carrier == Radar::Carrier::stepped || !computable(radar.bandwidth_hz) ||
      !(radar.pulse_width_s > 0.0))
    return;
  const double product = std::abs(radar.bandwidth_hz) * radar.pulse_width_s;
  if (product >= min_time_bandwidth) return;
  const bool short_unit = 1e3 * product >= min_time_bandwidth;
  findings.warning(
      Consequence::surprise, "pulse_width_s",
      {.id = "chirp.time-bandwidth",
       .message = "the time-bandwidth product of the chirp is too small for pulse compression",
       .found = fmt::format("{:.3g}: {} in {}", product, value_text(std::abs(radar.bandwidth_hz), "Hz"),
                            value_text(radar.pulse_width_s, "s")),
       .expected = fmt::format("{:.0f} or more", min_time_bandwidth),
       .hint = short_unit ? fmt::format("Scripts give the pulse width in ns: write {} for {}.",
                                        core::format_number(core::tidy(1e12 * radar.pulse_width_s)),
                                        value_text(1e3 * radar.pulse_width_s, "s"))
                          : "Range resolution is that of the pulse, not c/(2 B). MONO is a pulse without a sweep."});
}

// Where the half power of sin(x)/x is: x = 1.39156, of the amplitude.
void check_beamwidth(Findings& findings, std::string_view field, std::string_view cut, double width_deg) {
  if (!(width_deg > widest_beam_deg)) return;
  const double half = 1.391557 / (0.88 * core::pi) * width_deg * core::rad_per_deg;
  findings.warning(
      Consequence::surprise, field,
      {.id = "antenna.beam-too-wide",
       .message = fmt::format("the {} beamwidth is too wide for a sin(x)/x beam", cut),
       .found = value_text(width_deg, "deg"),
       .expected = fmt::format("{:.0f} deg or less", widest_beam_deg),
       .hint = half < 1.0 ? fmt::format("The beam's half-power width would be {:.1f} degrees, and nothing is "
                                        "radiated beyond 90 degrees. Give such a beam by points (OTHER).",
                                        core::deg_per_rad * 2.0 * std::asin(half))
                          : fmt::format("The beam never falls to half power: it ends at 90 degrees, {:.1f} dB below "
                                        "its peak. Give such a beam by points (OTHER), or take ISOTROPIC.",
                                        -20.0 * std::log10(std::sin(1.391557 / half) / (1.391557 / half)))});
}

// An aperture of length L has a half-power width of 0.886 lambda/L.
// Those of sky and ground waves, below 50 MHz, are fields of masts.
void check_narrow_beam(Findings& findings, std::string_view field, std::string_view cut, double width_deg,
                       double wavelength_m) {
  constexpr double longest_sky_wave_m = 6.0;
  const double longest_antenna_m = wavelength_m > longest_sky_wave_m ? 3000.0 : 100.0;
  if (!(width_deg > 0.0)) return;
  const double length_m = 0.886 * wavelength_m / (width_deg * core::rad_per_deg);
  if (!(length_m > longest_antenna_m)) return;
  findings.warning(Consequence::surprise, field,
                   {.id = "antenna.too-long",
                    .message = fmt::format("the {} beamwidth needs an antenna {:.3g} m long", cut, length_m),
                    .found = value_text(width_deg, "deg"),
                    .expected = fmt::format("{} or more, an antenna of up to {:g} m",
                                            value_text(core::tidy(width_deg * length_m / longest_antenna_m, 3), "deg"),
                                            longest_antenna_m),
                    .hint = "Beamwidths are in degrees; the length is 0.886 times the wavelength over the width."});
}

// What a uniformly illuminated aperture of these beamwidths has: 4 pi 0.886^2/(product of the widths).
void check_gain(Findings& findings, std::string_view field, const Antenna& antenna, const core::PowerRatio& gain) {
  constexpr double directive = 100.0;
  const double widths = antenna.azimuth_beamwidth.rad() * antenna.elevation_beamwidth.rad();
  if (gain.db() != 0.0 || !(widths > 0.0)) return;
  const double directivity = 4.0 * core::pi * 0.886 * 0.886 / widths;
  if (!(directivity > directive) || !std::isfinite(directivity)) return;
  findings.note(field,
                {.id = "antenna.no-gain",
                 .message = "the antenna has a narrow beam and a gain of 0 dB: signal-to-noise ratios are too low",
                 .found = "0 dB",
                 .expected = fmt::format("about {:.0f} dB less the antenna's losses", 10.0 * std::log10(directivity)),
                 .hint = "The pattern is relative to the peak; the gain of the peak is a field of its own."});
}

void check_beams(Findings& findings, std::string_view field, const Antenna& antenna,
                 const std::optional<CarrierSpan>& carriers) {
  if (antenna.pattern != Antenna::Pattern::sinx) return;
  check_beamwidth(findings, field, "azimuth", antenna.azimuth_beamwidth.deg());
  check_beamwidth(findings, field, "elevation", antenna.elevation_beamwidth.deg());
  if (!carriers || !(carriers->highest_hz > 0.0)) return;
  const double wavelength_m = radar::wavelength_of(carriers->highest_hz, core::exact_light_speed_mps);
  check_narrow_beam(findings, field, "azimuth", antenna.azimuth_beamwidth.deg(), wavelength_m);
  check_narrow_beam(findings, field, "elevation", antenna.elevation_beamwidth.deg(), wavelength_m);
}

void check_hanning(Findings& findings, const Radar& radar) {
  if (radar.window != Radar::Window::hanning || radar.hanning_pedestal != 1.0) return;
  findings.warning(Consequence::surprise, "hanning_pedestal",
                   {.id = "window.no-effect",
                    .message = "a Hanning window with the constant 1 has no effect: all of its weights are 1",
                    .found = "1",
                    .expected = "0, the Hann window (side lobes of -31.5 dB), to 0.5",
                    .hint = "Write RECT for no weighting."});
}

void check_oversampling(Findings& findings, const Simulation& simulation, const Radar& radar) {
  if (!has_band(radar) || !computable(radar.bandwidth_hz) || simulation.processing == Processing::srp) return;
  const double bandwidth_hz = std::abs(radar.bandwidth_hz);
  const double ratio = simulation.sample_rate_hz / bandwidth_hz;
  const std::string found =
      fmt::format("{}, {:.4g} times the bandwidth", value_text(simulation.sample_rate_hz, "Hz"), ratio);
  if (ratio > max_oversampling)
    findings.warning(Consequence::surprise, "sample_rate_hz",
                     {.id = "sampling.far-above-bandwidth",
                      .message = "the sampling frequency is far above the bandwidth of the pulse",
                      .found = found,
                      .expected = fmt::format("about {}", value_text(1.25 * bandwidth_hz, "Hz")),
                      .hint = "Scripts give bandwidths and sampling frequencies in GHz. The file grows with the ratio "
                              "and contains no more information."});
  else if (ratio < min_oversampling && ratio >= 1.0 - 1e-9)
    findings.note("sample_rate_hz",
                  {.id = "sampling.hardly-above-bandwidth",
                   .message = "the sampling frequency only just exceeds the pulse bandwidth: the spectral skirts "
                              "alias, and range interpolation (focus, measure) has errors of a few per cent",
                   .found = found,
                   .expected = fmt::format("{} or more", value_text(1.2 * bandwidth_hz, "Hz"))});
}

// The filter of a band-limited pulse rings for 28 half bands before and after it (decision 7); what is cut off leaks.
void check_kept_length(Findings& findings, const Simulation& simulation, const Radar& radar,
                       const RunOptions& options) {
  const auto bandwidth_hz = nominal_bandwidth_hz(radar);
  if (options.pulse != PulseDefinition::band_limited || !(simulation.oversampling > 1.0) || !bandwidth_hz) return;
  const double whole = 1.0 + 112.0 / std::max(1.0, *bandwidth_hz * radar.pulse_width_s);
  const double wanted = std::min(std::ceil(10.0 * whole) / 10.0, 100.0);
  // The classic profile takes 0 for 1.
  const double kept =
      simulation.width_factor == 0.0 && options.profile == Profile::classic ? 1.0 : simulation.width_factor;
  if (kept >= wanted || !(kept >= 1.0)) return;
  findings.warning(
      Consequence::false_signal, "width_factor",
      {.id = "band-limited-pulse.cut",
       .message = "the kept length truncates the band-limited pulse, which is then no longer band-limited",
       .found = value_text(simulation.width_factor, ""),
       .expected = fmt::format("0 or {:.1f}, which keep all of it{}, or an over-sampling factor of 1", wanted,
                               options.profile == Profile::classic ? " (0 with the physical profile only)" : ""),
       .hint =
           "Cut to its own length, a chirp has -26 dB of its energy outside its band; kept whole, -120 dB or less."});
}

void check_single_precision(Findings& findings, const Simulation& simulation, const RunOptions& options) {
  constexpr double of_a_float = 6e-8;
  if (values_of(simulation.format) != SampleValues::volts) return;
  if (options.tolerance < of_a_float)
    findings.note("format", {.id = "tolerance.single-precision",
                             .message = "the file stores single precision, which is coarser than the tolerance",
                             .found = fmt::format("a tolerance of {:.3g}", options.tolerance),
                             .expected = fmt::format("{:.0e} or more", of_a_float),
                             .hint = "'sarsim run --double' writes double precision."});
  if (simulation.bits < 8)
    findings.note("bits",
                  {.id = "format.no-quantisation",
                   .message = "volts are not quantised: this format does not use the A/D converter",
                   .found = fmt::format("{} bits", simulation.bits),
                   .expected = "a format of counts (BINARY, ASCII, BRACKET, CSV)",
                   .hint = "'sarsim run --quantise' writes the converter's counts into HDF5, NPY, Zarr and SigMF."});
}

void check_single_pulse(Findings& findings, const Simulation& simulation, const radar::Repetition& repetition,
                        const radar::PulseRange& pulses) {
  const double window_s = simulation.time_end_s - simulation.time_start_s;
  // A window of up to a hundredth of a second may well be meant for one pulse.
  if (pulses.count() != 1 || !(window_s > 0.01)) return;
  findings.warning(
      Consequence::lost_signal, "time_end_s",
      {.id = "azimuth-window.single-pulse",
       .message = "the azimuth window contains a single pulse, too few for focusing or Doppler measurement",
       .found = fmt::format("{} at a PRF of {}", value_text(window_s, "s"),
                            value_text(1.0 / repetition.mean_interval_s(), "Hz")),
       .expected = "many pulses, or a window of no length for one",
       .hint = "Scripts give the PRF in Hz and times in s."});
}

// Straight lines through two points go on for ever, but hardly for hours where the points are seconds apart.
void check_extrapolation(Findings& findings, const Simulation& simulation, const Platform& platform) {
  if (platform.path != Platform::Path::trajectory) return;
  double first_s = simulation.time_end_s;
  double last_s = simulation.time_start_s;
  for (const core::SampledFunction& part : platform.trajectory_m.part) {
    if (part.knots.size() < 2) continue;
    if (part.knots.size() > 2) return;  // `check_function_ends` tells of it.
    first_s = std::min(first_s, part.knots.front().x);
    last_s = std::max(last_s, part.knots.back().x);
  }
  const double window_s = simulation.time_end_s - simulation.time_start_s;
  if (!(last_s > first_s) || !(window_s > longest_extrapolation * (last_s - first_s))) return;
  findings.warning(
      Consequence::surprise, "time_end_s",
      {.id = "azimuth-window.beyond-trajectory",
       .message = "the azimuth window is much longer than the time for which the radar's trajectory has points",
       .found = fmt::format("{}, with points of {} for {}", value_text(window_s, "s"), platform.name,
                            value_text(last_s - first_s, "s")),
       .expected = "a window about as long as the trajectory",
       .hint = "Times are in seconds. Beyond its points the trajectory is extrapolated."});
}

struct Extension {
  std::string_view extension;
  FileFormat format;
};

void check_extension(Findings& findings, const Simulation& simulation) {
  static constexpr Extension extensions[] = {{".npy", FileFormat::npy},   {".h5", FileFormat::hdf5},
                                             {".hdf5", FileFormat::hdf5}, {".csv", FileFormat::csv},
                                             {".zarr", FileFormat::zarr}, {".sigmf-meta", FileFormat::sigmf}};
  const std::string extension = std::filesystem::path(simulation.file).extension().string();
  for (const Extension& known : extensions) {
    if (!core::equal_ignoring_case(extension, known.extension) || known.format == simulation.format) continue;
    findings.warning(Consequence::surprise, "file",
                     {.id = "output.other-extension",
                      .message = "the file name has the extension of another format",
                      .found = simulation.file,
                      .expected = "an extension that fits the format of the simulation",
                      .hint = "Programs that go by the extension will not read it: change the name or the format."});
  }
}

}  // namespace

void check_plausible_radar(Findings& findings, const Radar& radar) {
  check_usual_carrier(findings, radar);
  check_band_above_zero(findings, radar);
  check_time_bandwidth(findings, radar);
  const auto carriers = carrier_span(radar);
  check_beams(findings, "transmit_antenna", radar.transmit_antenna, carriers);
  if (!radar.same_antenna) check_beams(findings, "receive_antenna", radar.receive_antenna, carriers);
  if (radar.noise_temperature_k > 0.0 && std::isfinite(radar.noise_temperature_k) &&
      radar.transmit_antenna.pattern == Antenna::Pattern::sinx)
    check_gain(findings, "transmit_gain", radar.transmit_antenna, radar.transmit_gain);
  check_hanning(findings, radar);
}

void check_plausible_simulation(Findings& findings, const Scene& scene, const Simulation& simulation,
                                const Radar& radar, const radar::PulseRange& pulses) {
  check_extension(findings, simulation);
  check_single_precision(findings, simulation, scene.options);
  check_kept_length(findings, simulation, radar, scene.options);
  check_oversampling(findings, simulation, radar);
  const auto repetition = repetition_of(radar);
  if (!repetition) return;
  if (is_sound<&Radar::prf_hz>(radar)) check_single_pulse(findings, simulation, *repetition, pulses);
  const std::size_t platform = find_platform(scene, radar.platform);
  if (platform != not_found) check_extrapolation(findings, simulation, scene.platforms[platform]);
}

}  // namespace sarsim::scene
