#pragma once

#include "core/maths/angle_function.hpp"

namespace sarsim::radar {

/// What the sin(x)/x curve of thesis A.17 means (decision 9).
enum class PatternRule {
  amplitude,  ///< The one-way amplitude, sign and all.
  power,      ///< Its magnitude is the one-way power gain (thesis 6.14, the 1998 programs).
};

/// The gain of one antenna against the offset from the beam's axis.
struct AntennaPattern {
  /// Gain 1 everywhere; sin(x)/x by its beamwidths (thesis A.17); cuts given by points.
  enum class Kind { isotropic, sinx, user };

  Kind kind = Kind::isotropic;
  double azimuth_beamwidth_rad = 0.1;  ///< Kind::sinx.
  double elevation_beamwidth_rad = 0.1;
  core::AngleFunction azimuth_gain_db;  ///< One-way power [dB] against the offset [deg]; Kind::user.
  core::AngleFunction elevation_gain_db;
};

/// sin(x)/x with x = 0.88 pi sin(offset)/beamwidth; 0 where the offset is 90 degrees or more (thesis A.17).
/// @param offset_rad     any angle; wrapped to (-pi, pi].
/// @param beamwidth_rad  positive.
[[nodiscard]] double sinx_gain(double offset_rad, double beamwidth_rad);

/// Factor by which the antenna multiplies a voltage that passes it once, in the given direction:
/// isotropic 1; sinx the product of the cuts (PatternRule::amplitude) or the root of its magnitude
/// (PatternRule::power); user 10^((A + E)/20) of the two cuts at the wrapped offsets, signed or as magnitudes (decision
/// 10, core::AngleFunction).
/// Azimuth offsets are positive to the right of the beam, elevation offsets above it.
/// The two-way factor is the product of those of the two antennas.
[[nodiscard]] double one_way_amplitude(const AntennaPattern& pattern, double azimuth_offset_rad,
                                       double elevation_offset_rad, PatternRule rule);

/// `angle_rad` brought into (-pi, pi].
[[nodiscard]] double wrapped_angle(double angle_rad);

}  // namespace sarsim::radar
