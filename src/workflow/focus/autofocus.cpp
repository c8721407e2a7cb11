#include "workflow/focus/autofocus.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/report/refused.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/autofocus.hpp"
#include "signal/sar/sar_track.hpp"

namespace sarsim::workflow {

namespace {

// What the targets say of the apertures that they are seen with, within 20 dB.
struct Apertures {
  double mean_m = 0.0;   // along the flight; all of it where there are no targets
  double band_hz = 0.0;  // of Doppler frequencies about the centroid that holds those of all targets; 0: none known
};

Apertures apertures_of(const signal::EchoRows& echoes, const std::vector<SarTarget>& targets,
                       const signal::FocusOptions& options) {
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  const double flight_m = track.speed_mps * track.interval_s * static_cast<double>(echoes.track.size());
  const signal::SarWaveform& wave = echoes.waveform;
  Apertures apertures;
  double sum_m = 0.0;
  double count = 0.0;
  for (const SarTarget& target : targets) {
    if (!(target.amplitude > 0.0)) continue;
    const double band_hz = target.highest_doppler_hz - target.lowest_doppler_hz;
    sum_m +=
        radar::range_of_cycle(wave.carrier_hz, wave.light_speed_mps) * target.place.range_m * band_hz / track.speed_mps;
    count += 1.0;
    apertures.band_hz = std::max({apertures.band_hz, 2.0 * (target.highest_doppler_hz - options.doppler_centroid_hz),
                                  2.0 * (options.doppler_centroid_hz - target.lowest_doppler_hz)});
  }
  apertures.mean_m = count > 0.0 ? std::min(sum_m / count, flight_m) : flight_m;
  if (options.doppler_bandwidth_hz > 0.0 && apertures.band_hz > 0.0)
    apertures.band_hz = std::min(apertures.band_hz, options.doppler_bandwidth_hz);
  return apertures;
}

// Image and copies of it, and one piece at a time in double precision.
void expect_memory(const signal::FocusedImage& image, double piece_m, std::size_t memory_bytes) {
  const auto columns = static_cast<double>(image.range.count);
  const double rows = static_cast<double>(image.azimuth.count);
  const double bytes = columns * (3.0 * 8.0 * rows + 3.0 * 16.0 * piece_m / image.azimuth.step_m);
  if (memory_bytes == 0 || bytes <= static_cast<double>(memory_bytes)) return;
  throw core::Refused(fmt::format("autofocus holds the image in memory, {}, but --memory allows {}",
                                  core::bytes_text(bytes), core::bytes_text(static_cast<double>(memory_bytes))),
                      "allow more, or do without --autofocus");
}

// Of a piece, in metres.
double piece_of(const signal::FocusedImage& axes, const AutofocusChoice& choice, double aperture_m) {
  constexpr double share_of_aperture = 0.1;
  constexpr double least_rows = 16.0;
  const double least_m = least_rows * axes.azimuth.step_m;
  const double length_m = static_cast<double>(axes.azimuth.count) * axes.azimuth.step_m;
  if (!(length_m >= least_m))
    throw core::Refused(
        fmt::format("autofocus needs an image of {:.0f} rows or more; this one has {}", least_rows, axes.azimuth.count),
        "record more pulses, or do without --autofocus");
  if (!(choice.piece_m > 0.0)) return std::clamp(share_of_aperture * aperture_m, least_m, length_m);
  if (!(choice.piece_m >= least_m && choice.piece_m <= length_m))
    throw core::Refused(
        fmt::format("autofocus cannot work on pieces of {:.4g} m", choice.piece_m),
        fmt::format("--autofocus-piece: {:.4g} to {:.4g} m, sixteen rows to the whole image", least_m, length_m));
  return choice.piece_m;
}

// The phase along the flight, where the antenna was.
void take_phase(const signal::StripmapAutofocusResult& result, const signal::EchoRows& echoes,
                AutofocusFinding& finding) {
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  const double first_m = track.speed_mps * track.time_s(0.0);
  const double last_m = track.speed_mps * track.time_s(static_cast<double>(echoes.track.size()) - 1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < result.along_m.size(); ++i) {
    if (result.along_m[i] < first_m || result.along_m[i] > last_m) continue;
    finding.along_m.push_back(result.along_m[i]);
    finding.phase_rad.push_back(result.phase_rad[i]);
    sum += result.phase_rad[i] * result.phase_rad[i];
  }
  if (!finding.along_m.empty()) finding.rms_rad = std::sqrt(sum / static_cast<double>(finding.along_m.size()));
}

}  // namespace

void expect_autofocus(const signal::FocusedImage& axes, const signal::EchoRows& echoes,
                      const std::vector<SarTarget>& targets, const AutofocusChoice& choice,
                      const signal::FocusOptions& options) {
  expect_memory(axes, piece_of(axes, choice, apertures_of(echoes, targets, options).mean_m), choice.memory_bytes);
}

std::pair<signal::FocusedRows, AutofocusFinding> autofocused(
    const signal::FocusedRows& rows, const signal::EchoRows& echoes, const std::vector<SarTarget>& targets,
    const AutofocusChoice& choice, const signal::FocusOptions& options, const core::WorkControl& control) {
  const Apertures apertures = apertures_of(echoes, targets, options);
  AutofocusFinding finding;
  finding.piece_m = piece_of(rows.image, choice, apertures.mean_m);
  expect_memory(rows.image, finding.piece_m, choice.memory_bytes);
  const signal::FocusedImage blurred = signal::in_memory(rows);
  const signal::AutofocusOptions how{.band_per_m = apertures.band_hz / rows.image.frame.speed_mps};
  signal::StripmapAutofocusResult result = signal::autofocus_strip(blurred, finding.piece_m, how, control);
  finding.entropy_before = signal::image_entropy(blurred);
  finding.entropy_after = signal::image_entropy(result.image);
  take_phase(result, echoes, finding);
  finding.applied = failure_of(finding).empty();

  signal::FocusedRows sharp = signal::rows_of(
      std::make_shared<const signal::FocusedImage>(finding.applied ? std::move(result.image) : blurred));
  sharp.image = rows.image;
  sharp.on_disk = rows.on_disk;
  return {std::move(sharp), std::move(finding)};
}

std::string failure_of(const AutofocusFinding& finding) {
  constexpr double much_rad = 0.5;
  constexpr double least_gain = 0.02;
  const double gain = finding.entropy_before - finding.entropy_after;
  if (!(gain > 0.0)) return "the image was sharper before";
  if (!(finding.rms_rad > much_rad)) return {};
  if (gain < least_gain)
    return fmt::format("the entropy of the image hardly changes, from {:.3f} to {:.3f}", finding.entropy_before,
                       finding.entropy_after);
  return {};
}

core::Problems remarks_on_autofocus(const AutofocusFinding& finding) {
  const std::string failure = failure_of(finding);
  if (failure.empty() || !(finding.rms_rad > 0.0)) return {};
  // A small error found in a sharp image needs no advice.
  constexpr double small_rad = 0.1;
  const bool matters = finding.rms_rad > small_rad;
  return {core::problem_of(
      matters ? core::Severity::warning : core::Severity::note,
      fmt::format(
          "autofocus failed: it found {:.3g} rad rms in pieces of {:.4g} m, but {}; the image is left as it was",
          finding.rms_rad, finding.piece_m, failure),
      {}, {}, matters ? "try another --autofocus-piece, or give focus the flown track with --script" : "")};
}

void write_phase(const AutofocusFinding& finding, const std::filesystem::path& path, bool replace) {
  std::string text = "along_m,phase_rad\n";
  for (std::size_t i = 0; i < finding.along_m.size(); ++i) {
    core::append_number(text, finding.along_m[i]);
    text += ',';
    core::append_number(text, finding.phase_rad[i]);
    text += '\n';
  }
  core::OutputFile file(path, replace);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
}

}  // namespace sarsim::workflow
