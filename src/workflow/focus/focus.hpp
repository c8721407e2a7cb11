#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "signal/sar/focusing.hpp"
#include "workflow/focus/autofocus.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/focus_request.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/image/kept_image.hpp"

namespace sarsim::workflow {

/// An image and how it came to be.
struct FocusReport {
  std::vector<std::filesystem::path> files;  ///< What was written.
  signal::FocusedRows image;                 ///< Its axes; its rows can be read as long as this object.
  ImageOrigin origin;                        ///< As the header of the image tells it.
  RecordingArguments input;                  ///< What it was made from.
  std::size_t simulation = 0;                ///< Position in the script's list.
  FocusAlgorithm algorithm = FocusAlgorithm::omega_k;
  FocusGrid grid = FocusGrid::slant;
  signal::FocusOptions options;            ///< As they were used: with the Doppler centroid.
  MotionOrder motion = MotionOrder::none;  ///< To which the echoes were compensated.
  double strays_m = 0.0;                   ///< Largest distance of the antenna from the straight line, where they were.
  std::optional<AutofocusFinding> autofocus;
  core::Problems problems;  ///< Warnings and notes, ranked; all were handed to the observer.
  double seconds = 0.0;
};

/// The image of a report, as it stays in memory.
[[nodiscard]] KeptImage kept_image(const FocusReport& report);

/// What `focus` with its usual options will say of an input, but for what the survey of the scene says itself (echoes
/// that the window cuts, the band of the beam, the rate of samples) and what it tells of its choice of a grid: motion
/// that compensation leaves, carriers that leave ambiguities, targets that move, ghosts. Reads no echoes.
/// @throw  core::Refused where the input cannot be focused so; Interrupted
[[nodiscard]] core::Problems remarks_of_focus(FocusInput input, const core::WorkControl& control = {});

/// What theory says of the targets in the image that `focus` would make of a request. Reads no echoes but for a
/// Doppler centroid that is to be measured. Throws like `focus`.
[[nodiscard]] std::vector<TargetTheory> theory_of_focus(const FocusRequest& request, const core::Observer& observer);

/// A line of names, then one of numbers for each target, with commas; what does not exist is empty.
[[nodiscard]] std::string csv_of(const std::vector<TargetTheory>& targets);

/// Focuses the echoes of a script or of a recording (docs/theory/focusing.md), and writes the image where the request
/// names an output. Throws core::Refused with all problems where that cannot be done, Interrupted, and like the sinks.
[[nodiscard]] FocusReport focus(const FocusRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
