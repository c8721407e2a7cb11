#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/report/problem.hpp"
#include "signal/sar/focusing.hpp"
#include "workflow/focus/autofocus.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/focus_request.hpp"
#include "workflow/image/image_output.hpp"
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

}  // namespace sarsim::workflow
