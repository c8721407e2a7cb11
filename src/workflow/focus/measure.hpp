#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "core/text/facts.hpp"
#include "signal/measure/image_quality.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/image/image_fields.hpp"
#include "workflow/image/in_memory_image.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::workflow {

/// What of an image is to be measured.
struct MeasureRequest {
  std::filesystem::path image;  ///< Complex image of `focus`, ENVI, NPY or SICD.
  /// In place of that file, which is then only a name: an image that was kept, with its origin and input. Null: none.
  std::shared_ptr<const InMemoryImage> kept{};
  /// The script that it was made from and its simulation, where they are others than the image's header says; no path.
  RecordingArguments input;
  std::optional<double> search_m;     ///< How far from its place a peak may be; nothing: three cells, or half way to
                                      ///< the next target.
  double false_alarm = 1e-3;          ///< Probability that noise alone counts as a target, 1e-15 to 0.1.
  std::optional<std::size_t> target;  ///< Its number in the script, from 1; nothing: all.
  bool cuts = false;                  ///< Also the cuts through each target.
  std::filesystem::path pictures;     ///< Folder that pictures of the cuts will be in; empty: there will be none.
  bool force = false;                 ///< Pictures that exist may be replaced.
  unsigned threads = 0;               ///< 0: one for each core.
};

/// Result for a target in an image.
enum class TargetState {
  no_echoes,  ///< No echoes of it are expected.
  outside,    ///< Its expected position is not in the image, or its echoes are not recorded: it was not searched for.
  not_found,  ///< No peak above the detection threshold, or a displaced one that is 20 dB or more too weak.
  displaced,  ///< A peak off the expected position by more than half a -3 dB width and three standard deviations.
  weak,       ///< A peak at the expected position, below the expected amplitude by 3 dB and three standard deviations.
  strong,     ///< A peak at the expected position, above the expected amplitude by 3 dB and three standard deviations.
  found,      ///< A peak at the expected position with the expected amplitude.
};

/// "no echoes", "outside", "not found", "displaced", "weak", "strong", "found".
[[nodiscard]] const char* to_string(TargetState state);

/// A target, expected and measured.
struct MeasuredTarget {
  TargetTheory theory;
  TargetState state = TargetState::not_found;
  /// The peak of a target that is found; its phase is referred by the image's carrier to the expected position.
  std::optional<signal::PointResponse> found;
  /// The same for a peak above the threshold that is displaced, weak or strong.
  std::optional<signal::PointResponse> peak{};
  bool outside = false;    ///< Its place is not in the image, or not recorded: it was not looked for.
  double noise_v = 0.0;    ///< Root mean square of what the image shows beside its points, near this place; 0: nothing.
  double threshold = 0.0;  ///< Power over that of the noise that a peak in the area searched has to exceed.
  double search_m = 0.0;   ///< How far from its place, in both coordinates, it was looked for.
  double peak_v = 0.0;     ///< The largest peak there, found or not.
  /// Probability that noise or clutter with the level `noise_v` has a peak this large in the searched area; 1 without a
  /// peak.
  double false_alarm_probability = 1.0;
  signal::PointCuts cuts;         ///< Where they are wanted and the target was found.
  std::filesystem::path picture;  ///< Where it will be, where one is wanted.

  /// The peak that was measured, found or displaced, weak or strong; null: none.
  [[nodiscard]] const signal::PointResponse* response() const;
  /// Its phase less that of theory, in (-pi, pi]. Only where there is a response.
  [[nodiscard]] double phase_error_rad() const;
  /// Its amplitude over that of theory, dB. Only where there is a response.
  [[nodiscard]] double amplitude_error_db() const;
  /// Power of the largest peak over that of the noise, dB; infinite without noise.
  [[nodiscard]] double snr_db() const;
  /// The same of the peak that theory has.
  [[nodiscard]] double expected_snr_db() const;
  /// Whether theory has echoes of it.
  [[nodiscard]] bool expected() const { return theory.amplitude > 0.0; }
};

/// Many targets in a few numbers: those found, their errors least and largest.
struct MeasureSummary {
  std::size_t expected = 0;  ///< Targets that theory has echoes of, within the image.
  std::size_t outside = 0;   ///< Those beside it, or beside the recorded ranges.
  std::size_t found = 0;
  std::size_t displaced = 0, weak = 0, strong = 0;  ///< Of the others.
  double farthest_m = 0.0;                          ///< Largest distance from its place.
  double lowest_amplitude_db = 0.0, highest_amplitude_db = 0.0;
  double lowest_phase_rad = 0.0, highest_phase_rad = 0.0;
  double lowest_snr_db = 0.0, highest_snr_db = 0.0;
};

/// The targets of an image.
struct MeasureReport {
  ImageOrigin origin;                   ///< As the image's header has it.
  std::string truth;                    ///< File of the scene with the targets, as it was opened.
  std::vector<MeasuredTarget> targets;  ///< In the order of the script.
  double false_alarm = 0.0;             ///< Probability that noise alone counts as a target.
  core::Problems problems;              ///< Of the way from the image to its script; they were handed to the observer.
  signal::ImageFrame frame;             ///< Of the image.

  /// Where a place of the image is on the Earth: of ground grids over an Earth, whose plane its height is that of.
  [[nodiscard]] std::optional<radar::Geodetic> on_earth(const signal::ImagePlace& place) const;
};

/// The figures over all targets of a report; those of targets that were found are 0 where none was.
[[nodiscard]] MeasureSummary summary_of(const MeasureReport& report);

/// A target of a report: the columns of its table, those that a list of targets shows with labels.
[[nodiscard]] core::Facts columns_of(const MeasuredTarget& target, const MeasureReport& report);

/// A line of names, then one of numbers for each target, with commas: places and errors by axis in metres, figures and
/// theory beside each other. What does not exist is empty. Of ground grids over the Earth latitude and longitude of
/// both places and the height of the grid's plane come last, in degrees and m over the ellipsoid. Displaced, weak and
/// strong targets have the errors of their peaks; `found` is 1 only of those whose `state` it is.
[[nodiscard]] std::string csv_of(const MeasureReport& report);

/// State of a target whose largest peak is above the threshold: `found` within half the -3 dB width of its response
/// along and across the line of sight, or three standard deviations of the position at its signal-to-noise ratio, and
/// within 3 dB, or three standard deviations, of the expected amplitude.
/// @param axes  directions of the image's cuts
/// @param peak  its position, widths and amplitude
[[nodiscard]] TargetState state_of(const MeasuredTarget& target, const signal::PointResponse& peak,
                                   const signal::ResponseAxes& axes);

/// Measures the point targets of a focused image against theory (docs/theory/focusing.md). A peak counts if it exceeds
/// the threshold over the image's noise that noise alone exceeds in the searched area with probability `false_alarm`.
/// Throws core::InvalidRequest where the image is none of `focus`, its source cannot be read, the target is not there,
/// or a picture exists; Interrupted.
[[nodiscard]] MeasureReport measure(const MeasureRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
