#pragma once

#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "workflow/focus/focus_pipeline.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/image/in_memory_image.hpp"

namespace sarsim::workflow {

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
