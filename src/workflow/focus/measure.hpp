#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/task/observer.hpp"
#include "signal/measure/image_quality.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/image/image_fields.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::workflow {

/// What of an image is to be measured.
struct MeasureRequest {
  std::filesystem::path image;  ///< Complex image of `focus`, ENVI or NPY.
  /// The script that it was made from and its simulation, where they are others than the image's header says; no path.
  RecordingArguments input;
  std::optional<double> search_m;     ///< How far from its place a peak may be; nothing: three cells, or half way to
                                      ///< the next target.
  std::optional<std::size_t> target;  ///< Its number in the script, from 1; nothing: all.
  bool cuts = false;                  ///< Also the cuts through each target.
  std::filesystem::path pictures;     ///< Folder that pictures of the cuts will be in; empty: there will be none.
  bool force = false;                 ///< Pictures that exist may be replaced.
  unsigned threads = 0;               ///< 0: one for each core.
};

/// A target as it should be and as it is.
struct MeasuredTarget {
  TargetTheory theory;
  std::optional<signal::PointResponse> found;
  signal::PointCuts cuts;         ///< Where they are wanted and the target was found.
  std::filesystem::path picture;  ///< Where it will be, where one is wanted.

  /// Found phase less that of theory, in (-pi, pi]. Only of a target that was found.
  [[nodiscard]] double phase_error_rad() const;
  /// Found amplitude over that of theory, dB. Only of a target that was found.
  [[nodiscard]] double amplitude_error_db() const;
};

/// The targets of an image.
struct MeasureReport {
  ImageOrigin origin;                   ///< As the image's header has it.
  std::vector<MeasuredTarget> targets;  ///< In the order of the script.
  core::Problems problems;              ///< Of the way from the image to its script; they were handed to the observer.
};

/// Measures the point targets of a focused image against theory (docs/theory/focusing.md). Throws core::Refused where
/// the image is none of `focus`, its source cannot be read, the target is not there, or a picture exists; Interrupted.
[[nodiscard]] MeasureReport measure(const MeasureRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
