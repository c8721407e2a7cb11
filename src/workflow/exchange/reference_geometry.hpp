#pragma once

#include "raster/cphd/cphd_description.hpp"

namespace sarsim::workflow {

/// Angles of an antenna as seen from a reference point on the Earth, as CPHD and CRSD define them (CPHD 1.1.0, 6.5.2
/// and 6.5.3). What is not defined has the values of the standard: at rest the Doppler cone is 90 degrees and the side
/// L; straight above the point the azimuth is 0 and the graze angle 90 degrees.
/// @param srp_m  ECF, as all places and velocities
[[nodiscard]] raster::PlatformGeometry platform_geometry(double time_s, const core::Vec3& position_m,
                                                         const core::Vec3& velocity_mps, const core::Vec3& srp_m);

/// Angle of the line to the point, seen over the ground below the antenna, ahead of the direction at right angles to
/// its track; degrees (CRSD 1.0, 8.3).
[[nodiscard]] double ground_squint_deg(const core::Vec3& position_m, const core::Vec3& velocity_mps,
                                       const core::Vec3& point_m);

/// ReferenceGeometry of a reference vector, for a receiver at the transmitter or elsewhere; times of dwell and the
/// place in the image area are left as they are made.
[[nodiscard]] raster::ReferenceGeometry reference_geometry(const raster::PhaseVector& vector, bool bistatic);

}  // namespace sarsim::workflow
