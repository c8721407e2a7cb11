#pragma once

#include <optional>
#include <vector>

#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "signal/sar/focusing.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/focus_input.hpp"

namespace sarsim::workflow {

/// What back projection can do that the other methods cannot.
struct BackProjectionChoice {
  bool ground = false;             ///< Columns are places on level ground, not slant ranges.
  std::optional<double> ground_m;  ///< Height of the ground, world; nothing: that of the middle of the scene.
  bool start_stop = false;         ///< As if the antenna rested while a pulse travels.
};

/// Refuses an image that the area asked for leaves without samples.
void expect_samples(const signal::FocusedImage& axes);

/// The axes and the frame of the image of slant range that `back_projected` makes, without values.
/// @param targets  from the line of the track (`targets_from_line`)
[[nodiscard]] signal::FocusedImage back_projection_axes(const signal::EchoRows& echoes,
                                                        const std::vector<SarTarget>& targets,
                                                        const signal::FocusOptions& options);

/// Focuses by back projection to the slant-range image that the methods in the frequency domain make: the same axes,
/// phases and amplitudes, with closer rows where the pulses do not sample the targets' Doppler frequencies. A Doppler
/// bandwidth keeps the pulses that see a point at such frequencies from the line of flight; the azimuth window is over
/// them, or, where all are kept, over the record. Amplitudes are means over the pulses that are there: near the ends of
/// the flight, where a part of the band was not flown, they do not fade as those of the other methods do. Or to an
/// image of level ground. Throws core::InvalidRequest where the echoes need more memory than allowed or the ground is
/// out of reach.
/// @param axes  `back_projection_axes` of these echoes, or those of a ground grid
[[nodiscard]] signal::FocusedRows back_projected(const FocusInput& input, signal::FocusedImage axes,
                                                 const BackProjectionChoice& choice,
                                                 const signal::FocusOptions& options, const core::WorkControl& control,
                                                 const core::ProgressReport& progress);

}  // namespace sarsim::workflow
