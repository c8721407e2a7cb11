#pragma once

#include <optional>

#include "signal/sar/focusing.hpp"
#include "simulate/plan/acquisition.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"

namespace sarsim::workflow {

/// The wave numbers that the targets fill in an image of back-projection, from the places that the antenna really had:
/// also of a flight that is not straight. As `seen_spectrum`: all but `left_out_of_image`.
/// @param image    its frame: in slant range the line that fits the track, with the points on level ground
/// @param scene_m  world; a point of the ground, which gives its height and side of the line
/// @param kept     directions from that line that are kept, by their Doppler frequencies
/// @throw  Interrupted
[[nodiscard]] std::optional<signal::ImageSpectrum> flown_spectrum(const simulate::Acquisition& acquisition,
                                                                  const signal::EchoRows& echoes,
                                                                  const signal::ImageFrame& image,
                                                                  const core::Vec3& scene_m, const DopplerBand& kept,
                                                                  const core::WorkControl& control = {});

}  // namespace sarsim::workflow
