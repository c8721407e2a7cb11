#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "signal/sar/focusing.hpp"
#include "workflow/focus/autofocus.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/focus_request.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/image/in_memory_image.hpp"
#include "workflow/input/earth_place.hpp"

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
[[nodiscard]] InMemoryImage in_memory_image(const FocusReport& report);

/// What `focus` with its usual options will say of an input, but for what the survey of the scene says itself (echoes
/// that the window cuts, the band of the beam, the rate of samples) and what it tells of its choice of a grid: motion
/// that compensation leaves, carriers that leave ambiguities, targets that move, ghosts. Reads no echoes.
/// @throw  core::InvalidRequest where the input cannot be focused so; Interrupted
[[nodiscard]] core::Problems diagnose_focus(FocusInput input, const core::WorkControl& control = {});

/// What theory says of the targets in the image that `focus` would make of a request. Reads no echoes but for a
/// Doppler centroid that is to be measured. Throws like `focus`.
[[nodiscard]] std::vector<TargetTheory> theory_of_focus(const FocusRequest& request, const core::Observer& observer);

/// A line of names, then one of numbers for each target, with commas; what does not exist is empty.
[[nodiscard]] std::string csv_of(const std::vector<TargetTheory>& targets);

/// Echoes that can be focused, and what is decided before the first sample of their image: `focus` in two steps, for
/// who makes many images of echoes that change a little.
struct FocusPipeline {
  FocusRequest request;  ///< Its algorithm is the one that will be used.
  FocusInput input;
  signal::FocusOptions options;
  core::Problems problems;  ///< Of the echoes, for these options.
  MotionOrder motion = MotionOrder::none;
  double strays_m = 0.0;              ///< From the straight line, before compensation.
  std::vector<SarTarget> to_show{};   ///< Targets that an image of slant range should show.
  std::optional<EarthPlace> place{};  ///< Where on the Earth a SICD image is.
};

/// Decides how an input is focused. Throws like `focus`.
[[nodiscard]] FocusPipeline begin_focus(FocusInput input, const FocusRequest& request,
                                        const core::WorkControl& control);

/// When it is said what is to be said of an image, which takes the geometry of all targets.
enum class FocusRemarks {
  first,  ///< Before the image is made.
  later,  ///< By `diagnose_image`, if at all.
};

/// Makes the image, and writes it where the request names an output. Throws like `focus`.
/// @param[in,out] work  its echoes are compensated
[[nodiscard]] FocusReport end_focus(FocusPipeline& work, const core::Observer& observer,
                                    FocusRemarks remarks = FocusRemarks::first);

/// What theory says of the targets that it has echoes of, their places in metres as the image has them.
/// @param begun  as `begin_focus` gave it
/// @param image  of it
/// @throw  Interrupted
[[nodiscard]] std::vector<TargetTheory> targets_on_image(const FocusPipeline& begun, const signal::FocusedImage& image,
                                                         const core::WorkControl& control);

/// What `end_focus` would have said first.
/// @param begun  as `begin_focus` gave it
/// @param ended  as `end_focus` left it
/// @throw  core::InvalidRequest with errors, Interrupted
[[nodiscard]] core::Problems diagnose_image(FocusPipeline begun, FocusPipeline ended, const signal::FocusedImage& image,
                                            const core::WorkControl& control);

/// Focuses the echoes of a script or of a recording (docs/theory/focusing.md), and writes the image where the request
/// names an output. Throws core::InvalidRequest with all problems where that cannot be done, Interrupted, and like the
/// sinks.
[[nodiscard]] FocusReport focus(const FocusRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
