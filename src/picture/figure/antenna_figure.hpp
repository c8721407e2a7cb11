#pragma once

#include "picture/colour/display_quantity.hpp"
#include "picture/figure/figure.hpp"
#include "simulate/resolve/conventions.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::picture {

/// How antenna patterns are looked at.
struct AntennaLook {
  DisplayQuantity quantity = DisplayQuantity::magnitude;  ///< Real (with its sign), magnitude or decibels.
  double first_deg = -90.0;                               ///< Offsets from the beam's middle that are seen.
  double last_deg = 90.0;
  double span_db = 60.0;  ///< Of decibels, below the largest.
};

/// The patterns of a radar's antennas, one way, against the offset from the beam's middle: cuts in azimuth and in
/// elevation, of the receiving antenna only where it is another. Curves that coincide are one. The first one's
/// half-power points are marked: the nearest offsets at which the power is half that in the middle, in the profile's
/// reading of the pattern (decision 9).
/// @throws std::invalid_argument for another quantity
[[nodiscard]] Figure antenna_figure(const simulate::Link& radar, radar::PatternRule rule, const AntennaLook& look);

}  // namespace sarsim::picture
