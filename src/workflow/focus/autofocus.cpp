#include "workflow/focus/autofocus.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
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
  throw core::InvalidRequest(fmt::format("autofocus needs the whole image in memory, {}, but --memory allows {}",
                                         core::bytes_text(bytes), core::bytes_text(static_cast<double>(memory_bytes))),
                             "allow more, or do without --autofocus");
}

// Of a piece, in metres.
double piece_of(const signal::FocusedImage& axes, const AutofocusChoice& choice, double aperture_m) {
  constexpr double share_of_aperture = 0.1;
  constexpr double min_rows = 16.0;
  const double min_m = min_rows * axes.azimuth.step_m;
  const double length_m = static_cast<double>(axes.azimuth.count) * axes.azimuth.step_m;
  if (!(length_m >= min_m))
    throw core::InvalidRequest(
        fmt::format("autofocus needs an image of {:.0f} rows or more; this one has {}", min_rows, axes.azimuth.count),
        "record more pulses, or do without --autofocus");
  if (!(choice.piece_m > 0.0)) return std::clamp(share_of_aperture * aperture_m, min_m, length_m);
  if (!(choice.piece_m >= min_m && choice.piece_m <= length_m))
    throw core::InvalidRequest(
        fmt::format("autofocus cannot use sub-apertures of {:.4g} m", choice.piece_m),
        fmt::format("--autofocus-piece: {:.4g} to {:.4g} m, sixteen rows to the whole image", min_m, length_m));
  return choice.piece_m;
}

// The phase along the flight, where the antenna was.
void take_phase(const signal::StripmapAutofocusResult& result, const signal::EchoRows& echoes,
                AutofocusFinding& finding) {
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  const double first_m = track.speed_mps * track.time_s(0.0);
  const double last_m = track.speed_mps * track.time_s(static_cast<double>(echoes.track.size()) - 1.0);
  for (std::size_t i = 0; i < result.along_m.size(); ++i) {
    if (result.along_m[i] < first_m || result.along_m[i] > last_m) continue;
    finding.along_m.push_back(result.along_m[i]);
    finding.phase_rad.push_back(result.phase_rad[i]);
  }
  finding.rms_rad = result.rms_rad;
}

// Standard deviation of the powers over their mean.
double contrast_of(const signal::FocusedImage& image) {
  double sum = 0.0;
  double squares = 0.0;
  for (const std::complex<float> value : image.values) {
    const auto power = static_cast<double>(std::norm(value));
    sum += power;
    squares += power * power;
  }
  const auto count = static_cast<double>(image.values.size());
  if (!(sum > 0.0)) return 0.0;
  return std::sqrt(std::max(count * squares / (sum * sum) - 1.0, 0.0));
}

// A piece of an image, rows and columns [first, last).
struct Patch {
  std::size_t first_row = 0, last_row = 0, first_column = 0, last_column = 0;
};

// Powers of the largest and of a middling pixel.
struct PatchPower {
  double peak = 0.0;
  double noise = 0.0;  // mean of noise with that lower quartile
};

PatchPower power_in(const signal::FocusedImage& image, const Patch& patch) {
  std::vector<double> powers;
  for (std::size_t row = patch.first_row; row < patch.last_row; ++row)
    for (std::size_t column = patch.first_column; column < patch.last_column; ++column)
      powers.push_back(static_cast<double>(std::norm(image.values[row * image.range.count + column])));
  PatchPower power;
  if (powers.empty()) return power;
  power.peak = std::ranges::max(powers);
  const auto quartile = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 4);
  std::ranges::nth_element(powers, quartile);
  power.noise = *quartile / std::log(4.0 / 3.0);
  return power;
}

struct JudgedPoint {
  Patch patch;
  double expected_v = 0.0;  // of its peak; 0: not known
};

// The strongest targets in the image, with room for their blur.
std::vector<JudgedPoint> target_points(const signal::FocusedImage& image, const std::vector<SarTarget>& targets) {
  constexpr std::size_t most = 64;
  constexpr double rows_around = 24.0;
  constexpr double columns_around = 6.0;
  std::vector<SarTarget> inside;
  const auto is_in = [](const signal::ImageAxis& axis, double place_m) {
    const double index = axis.index_of(place_m);
    return index >= 0.0 && index <= static_cast<double>(axis.count) - 1.0;
  };
  for (const SarTarget& target : targets)
    if (target.amplitude > 0.0 && is_in(image.azimuth, target.place.azimuth_m) &&
        is_in(image.range, target.place.range_m))
      inside.push_back(target);
  std::ranges::stable_sort(inside, std::greater(), &SarTarget::amplitude);
  if (inside.size() > most) inside.resize(most);
  std::vector<JudgedPoint> points;
  for (const SarTarget& target : inside) {
    const auto span = [](const signal::ImageAxis& axis, double place_m, double around) {
      const double middle = std::round(axis.index_of(place_m));
      const auto last = static_cast<double>(axis.count);
      return std::pair(static_cast<std::size_t>(std::clamp(middle - around, 0.0, last)),
                       static_cast<std::size_t>(std::clamp(middle + around + 1.0, 0.0, last)));
    };
    const auto [first_row, last_row] = span(image.azimuth, target.place.azimuth_m, rows_around);
    const auto [first_column, last_column] = span(image.range, target.place.range_m, columns_around);
    points.push_back({{first_row, last_row, first_column, last_column}, target.amplitude});
  }
  return points;
}

// Parts of the image, whose brightest pixels are looked at.
std::vector<JudgedPoint> bright_points(const signal::FocusedImage& image) {
  constexpr std::size_t parts = 8;
  std::vector<JudgedPoint> points;
  for (std::size_t i = 0; i < parts; ++i)
    for (std::size_t j = 0; j < parts; ++j)
      points.push_back({{i * image.azimuth.count / parts, (i + 1) * image.azimuth.count / parts,
                         j * image.range.count / parts, (j + 1) * image.range.count / parts},
                        0.0});
  return points;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// The largest pixel of a patch before and after, in dB; nothing where it is not above what noise reaches in one of 1000
// such patches.
struct JudgedPeak {
  double gain_db = 0.0, before_db = 0.0, after_db = 0.0;
  double after_v = 0.0;
};

std::optional<JudgedPeak> judged(const signal::FocusedImage& before, const signal::FocusedImage& after,
                                 const Patch& patch) {
  constexpr double once_in = 1000.0;
  const PatchPower then = power_in(before, patch);
  const PatchPower now = power_in(after, patch);
  if (!(then.peak > 0.0 && then.noise > 0.0 && now.peak > 0.0 && now.noise > 0.0)) return std::nullopt;
  const auto pixels =
      static_cast<double>((patch.last_row - patch.first_row) * (patch.last_column - patch.first_column));
  if (std::max(then.peak / then.noise, now.peak / now.noise) < std::log(once_in * pixels)) return std::nullopt;
  return JudgedPeak{core::power_db(now.peak / then.peak), core::power_db(then.peak / then.noise),
                    core::power_db(now.peak / now.noise), std::sqrt(now.peak)};
}

// @return whether there were points to judge by
bool judge_by(const std::vector<JudgedPoint>& points, const signal::FocusedImage& before,
              const signal::FocusedImage& after, AutofocusFinding& finding) {
  std::vector<double> gains_db, before_db, after_db, levels_db;
  for (const JudgedPoint& point : points) {
    const auto peak = judged(before, after, point.patch);
    if (!peak) continue;
    gains_db.push_back(peak->gain_db);
    before_db.push_back(peak->before_db);
    after_db.push_back(peak->after_db);
    if (point.expected_v > 0.0) levels_db.push_back(core::amplitude_db(peak->after_v / point.expected_v));
  }
  finding.points = gains_db.size();
  if (gains_db.empty()) return false;
  finding.point_gain_db = median_of(std::move(gains_db));
  finding.point_snr_before_db = median_of(std::move(before_db));
  finding.point_snr_after_db = median_of(std::move(after_db));
  if (!levels_db.empty()) finding.point_level_db = median_of(std::move(levels_db));
  return true;
}

void judge(const signal::FocusedImage& before, const signal::FocusedImage& after, const std::vector<SarTarget>& targets,
           AutofocusFinding& finding) {
  finding.entropy_before = signal::image_entropy(before);
  finding.entropy_after = signal::image_entropy(after);
  finding.contrast_before = contrast_of(before);
  finding.contrast_after = contrast_of(after);
  if (!judge_by(target_points(before, targets), before, after, finding))
    judge_by(bright_points(before), before, after, finding);
}

// What half of an error that is taken out adds to the peak of a point, exp(-e^2) of its power, but no more than 3 dB.
double min_gain_db(double rms_rad) {
  constexpr double max_db = 3.0;
  return std::min(0.5 * core::power_db(std::exp(1.0)) * rms_rad * rms_rad, max_db);
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
  judge(blurred, result.image, targets, finding);
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
  constexpr double min_gain = 0.02;
  constexpr double dead_db = -10.0;
  const double gain = finding.entropy_before - finding.entropy_after;
  if (!(gain > 0.0)) return "the image was sharper before";
  if (finding.rms_rad > much_rad && gain < min_gain)
    return fmt::format("the entropy of the image hardly changes, from {:.3f} to {:.3f}", finding.entropy_before,
                       finding.entropy_after);
  if (!(finding.contrast_after > finding.contrast_before))
    return fmt::format("the contrast of the image does not grow, from {:.3g} to {:.3g}", finding.contrast_before,
                       finding.contrast_after);
  if (finding.points == 0) return "no point stands out of the image";
  if (finding.point_level_db && *finding.point_level_db < dead_db)
    return fmt::format("the points stay {:.1f} dB below the peaks expected from their echoes",
                       -*finding.point_level_db);
  // The SNR alone grows, too, where points smear and the noise around them, their side lobes, falls.
  if (!(finding.point_gain_db >= 0.0))
    return fmt::format("the peaks of the points fall by {:.2f} dB", -finding.point_gain_db);
  const double snr_gain_db = finding.point_snr_after_db - finding.point_snr_before_db;
  if (!(snr_gain_db >= min_gain_db(finding.rms_rad)))
    return fmt::format(
        "the peaks of the points change by {:+.2f} dB and their SNR by {:+.2f} dB, which should gain {:.2f} dB or more",
        finding.point_gain_db, snr_gain_db, min_gain_db(finding.rms_rad));
  return {};
}

core::Problems diagnose_autofocus(const AutofocusFinding& finding) {
  const std::string failure = failure_of(finding);
  if (failure.empty() || !(finding.rms_rad > 0.0)) return {};
  // A small error found in a sharp image needs no advice.
  constexpr double small_rad = 0.1;
  const bool matters = finding.rms_rad > small_rad;
  return {
      core::ProblemBuilder(matters ? core::Severity::warning : core::Severity::note, "focus.autofocus-failed",
                           fmt::format("autofocus failed: it estimated {:.3g} rad rms (sub-apertures of {:.4g} m), but "
                                       "{}; the image is unchanged",
                                       finding.rms_rad, finding.piece_m, failure))
          .hint(matters
                    ? "try another sub-aperture length (--autofocus-piece), or give focus the flown track with --script"
                    : "")};
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
