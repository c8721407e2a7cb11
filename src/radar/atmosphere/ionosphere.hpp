#pragma once

#include "radar/atmosphere/straight_path.hpp"

namespace sarsim::radar {

/// One unit of total electron content (TECU), 1/m^2.
inline constexpr double tec_unit_per_m2 = 1e16;

/// Height at which single-layer models put all electrons, m: 450 km as IGS's maps of the ionosphere (IONEX) have it;
/// 350 km is also in use.
inline constexpr double usual_shell_height_m = 450e3;

/// One-way excess of the group path over a way through electrons, m: +40.3 TEC/f^2 (ITU-R P.531). The phase comes
/// earlier by the same: its excess path is the negative of this. Terms of higher order, f^-3 by the magnetic field, are
/// below 1 % at 1 GHz.
/// @param tec_per_m2  total electron content along the way (slant), 1/m^2
[[nodiscard]] double ionosphere_group_m(double tec_per_m2, double carrier_hz);

/// One-way Faraday rotation of linear polarisation, rad: 2.365e4 B TEC/f^2 (ITU-R P.531). It does not undo itself on
/// the way back: the rotation there and back is twice that. Its sign is that of the field component.
/// @param tec_per_m2  along the way (slant), 1/m^2
/// @param field_t     mean component of the Earth's magnetic field along the way, T
[[nodiscard]] double faraday_rad(double tec_per_m2, double field_t, double carrier_hz);

/// Slant over vertical electron content for a path through a thin shell: 1/sin(elevation of the path at the shell). 0
/// where both ends are on the same side of the shell, because then no electrons are passed; an end on the shell is
/// above it. A radar in orbit above the shell passes all of the given content, one below it nothing.
[[nodiscard]] double shell_factor(const StraightPath& path, double shell_height_m = usual_shell_height_m);

}  // namespace sarsim::radar
