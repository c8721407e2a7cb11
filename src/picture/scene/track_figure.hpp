#pragma once

#include "picture/figure/figure.hpp"
#include "radar/orbit/state_table.hpp"
#include "scene/model/scene.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::picture {

/// Times for which a scene is looked at: those of its recordings and tables, otherwise those that its paths mention, at
/// least 1 s.
[[nodiscard]] radar::TimeSpan shown_times(const scene::Scene& scene);

/// Where the platforms of a scene go: a map with their paths, the places at which the middles of the beams meet the
/// ground, and the targets where they are in the middle of the times; below it the heights of the platforms against
/// time. Longitude and latitude and the height over the ellipsoid over an Earth, otherwise x, y and z. Paths are those
/// of pulse 0, with motion errors; at most 1000 targets, evenly chosen, without points of clouds. The ground is at the
/// mean height of the targets that do not move, or at 0.
/// @param times  first before last
[[nodiscard]] Figure track_figure(const scene::Scene& scene, const simulate::ResolvedScene& resolved,
                                  const radar::TimeSpan& times);

/// What a radar sees of the ground: the outlines within which its transmitting antenna has at least half the power of
/// the middle of the beam, one way, at nine times from the first to the last, with the way of the beam's middle and the
/// targets. Parts of an outline that miss the ground are left out.
/// @param times  first before last
/// @throws core::InvalidRequest for antennas without a lobe, and where no outline meets the ground
[[nodiscard]] Figure footprint_figure(const scene::Scene& scene, const simulate::ResolvedScene& resolved,
                                      std::size_t radar, const radar::TimeSpan& times);

}  // namespace sarsim::picture
