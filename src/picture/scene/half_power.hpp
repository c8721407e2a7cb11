#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radar/antenna/beam.hpp"
#include "radar/antenna/pattern.hpp"

namespace sarsim::picture {

/// Offset of the centre of a beam from its axis [rad]: the highest gain of each cut that is not even, unless the gain
/// on the axis is within half a decibel of it. 0 for all other patterns.
[[nodiscard]] radar::BeamOffset beam_middle(const radar::AntennaPattern& pattern);

/// Offsets from the axis of a beam [rad] at which one antenna's power has fallen to half that of its middle
/// (`beam_middle`), one way: `points` of them evenly about a beam that is narrow in one plane, the last where the first
/// is. Nothing in directions in which it does not fall so far within a quarter turn.
/// @param points  at least 2
[[nodiscard]] std::vector<std::optional<radar::BeamOffset>> half_power_outline(const radar::AntennaPattern& pattern,
                                                                               radar::PatternRule rule,
                                                                               std::size_t points);

/// The unit vector, in the world, at an offset from the axis of a beam as it points now.
[[nodiscard]] core::Vec3 beam_direction(const radar::Pointing& pointing, radar::PointingRule rule,
                                        const radar::BeamOffset& offset);

}  // namespace sarsim::picture
