#pragma once

#include <optional>
#include <vector>

#include "core/maths/vector.hpp"
#include "radar/antenna/beam.hpp"
#include "radar/antenna/pattern.hpp"

namespace sarsim::picture {

/// What an antenna looks like, prepared once for many snapshots.
struct BeamShape {
  bool isotropic = true;
  double azimuth_width_rad = 0.0;  ///< 2 pi where the pattern never falls by 3 dB.
  double elevation_width_rad = 0.0;
  radar::BeamOffset middle;  ///< `beam_middle`.
  /// Directions in the antenna's frame (x across, y boresight, z up) times the one-way amplitude over its largest:
  /// [elevation][azimuth]. Empty where isotropic.
  std::vector<std::vector<core::Vec3>> lobe_antenna;
  std::vector<std::optional<radar::BeamOffset>> outline;  ///< `half_power_outline`; empty where isotropic.
};

/// The shape of a pattern. One that cannot be understood (a beamwidth that is not positive) is isotropic.
[[nodiscard]] BeamShape beam_shape(const radar::AntennaPattern& pattern, radar::PatternRule rule);

}  // namespace sarsim::picture
