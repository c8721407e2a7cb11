#pragma once

#include <vector>

#include "signal/sar/focusing.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"

namespace sarsim::workflow {

/// The targets that an image of slant range should show: at rest, with recorded echoes within 20 dB of those of the
/// strongest, whose Doppler frequencies the image has. Of more than `max_examined_targets` an even choice.
/// @param echoes  their track, waveform and window; no rows are read
/// @param kept    Doppler frequencies of the image; a width of 0: all
/// @throw  Interrupted
[[nodiscard]] std::vector<SarTarget> targets_to_show(const simulate::Acquisition& acquisition,
                                                     const signal::EchoRows& echoes, const DopplerBand& kept,
                                                     const core::WorkControl& control = {});

/// Makes the image reach those of them that lie outside of it, nearest first, as long as it has no more than four times
/// the samples, or four million. An axis whose area is given stays as it is. The image ends at the recorded ranges as
/// the middle of the beam sees them: another direction sees other closest distances.
/// @param echoes  at least two pulses, and a speed
void reach_targets(const std::vector<SarTarget>& targets, const signal::EchoRows& echoes,
                   signal::FocusOptions& options);

/// Whether a place is within the axes of an image of slant range.
[[nodiscard]] bool shows(const signal::FocusedImage& image, const signal::ImagePlace& place);

/// A warning where targets lie outside of an image, with their places and what the image covers. Nothing is said of an
/// axis whose area is given.
/// @param image  of slant range; its axes
[[nodiscard]] core::Problems diagnose_outside(const std::vector<SarTarget>& targets, const signal::FocusedImage& image,
                                              const signal::FocusOptions& options, bool in_time);

}  // namespace sarsim::workflow
