#pragma once

#include <optional>

#include "core/report/problem.hpp"
#include "signal/sar/focusing.hpp"
#include "simulate/plan/acquisition.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"

namespace sarsim::workflow {

/// Which echoes an image is made of.
enum class SeenPulses {
  sampled,  ///< Those whose Doppler frequencies lie within half the pulse repetition frequency of the centroid.
  all,
};

/// Share of a target's echoes that an image's spectrum may leave out at either end of each axis: together at most 0.07
/// dB of a peak.
inline constexpr double left_out_of_image = 0.002;

/// The wave numbers that the images of a scene's targets fill, but for `left_out_of_image`. Targets whose echoes are 40
/// dB below the strongest do not count, of more than `max_examined_targets` some are looked at. Nothing where there
/// are no echoes.
/// @param echoes  their waveform, track and window; no rows are read. Directions are those from the track's line
/// @throw  Interrupted
[[nodiscard]] std::optional<signal::ImageSpectrum> seen_spectrum(const simulate::Acquisition& acquisition,
                                                                 signal::EchoRows echoes, const DopplerBand& kept,
                                                                 SeenPulses pulses,
                                                                 const core::WorkControl& control = {});

/// What a user should know of an image whose samples are closer than those of the recording: how close, and why.
/// @param coarse  axes as the recording's sampling gives them
/// @param axes    those of the image
[[nodiscard]] core::Problems diagnose_grid(const signal::FocusedImage& coarse, const signal::FocusedImage& axes,
                                           const signal::ImageSpectrum& spectrum);

/// What carriers that change from pulse to pulse leave ambiguous: ranges, where they are further apart than the pulse's
/// band, and azimuths, where the spectrum holds more Doppler frequencies than each carrier's own pulses sample.
[[nodiscard]] core::Problems diagnose_carriers(const signal::EchoRows& echoes, const signal::ImageSpectrum& spectrum);

}  // namespace sarsim::workflow
