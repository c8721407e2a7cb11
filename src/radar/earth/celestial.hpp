#pragma once

#include "radar/earth/turning_frame.hpp"

namespace sarsim::radar {

// The only header of the room whose source needs ERFA.

/// From GCRF, the celestial reference frame about the Earth's centre, to axes fixed to the Earth (ECEF, ITRF): W
/// R3(ERA) Q with precession and nutation Q of IAU 2006/2000A (IERS Conventions 2010, chapter 5; ERFA's eraC2i06a). The
/// same as eraC2t06a, but the angle of rotation is computed in extended precision: eraEra00 has a rounding of 1e-14
/// rad, 1e-7 m in orbit and different at every moment. Rounding 5e-9 m at 7e6 m.
///
/// The model itself: 0.3 mas of nutation (1 cm), which IERS publishes and this does not take. The velocities are the
/// derivatives of the positions within 1e-8 m/s in low orbit; precession and nutation have 5e-5 m/s of them.
[[nodiscard]] TurningFrame ecef_from_gcrf(const Instant& instant, const EarthOrientation& orientation = {});

/// From EME2000 (J2000), mean equator and equinox of 2000-01-01 12 h TT, as CCSDS has it: `ecef_from_gcrf` behind the
/// bias of the frames (eraBp06), a fixed rotation of 0.023", 0.8 m at 7e6 m.
[[nodiscard]] TurningFrame ecef_from_eme2000(const Instant& instant, const EarthOrientation& orientation = {});

}  // namespace sarsim::radar
