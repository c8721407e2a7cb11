#pragma once

namespace sarsim::radar {

/// Air at a place.
struct AirState {
  double dry_pressure_pa = 101'325.0;  ///< Without that of the vapour.
  double temperature_k = 288.15;
  double vapour_kg_per_m3 = 7.5e-3;  ///< Density of water vapour.

  /// Pressure of the vapour, Pa: e [hPa] = rho [g/m^3] T/216.7 (ITU-R P.453).
  [[nodiscard]] double vapour_pressure_pa() const { return 1e5 * vapour_kg_per_m3 * temperature_k / 216.7; }
};

/// Density of water vapour at height 0 of the reference atmosphere, kg/m^3.
inline constexpr double reference_vapour_kg_per_m3 = 7.5e-3;

/// Where the reference atmosphere ends, m. There is no air above it.
inline constexpr double reference_top_m = 100e3;

/// The mean annual global reference atmosphere of ITU-R P.835-6 at a height: temperature and pressure of the U.S.
/// Standard Atmosphere 1976 by geopotential height up to 86 km; vapour that falls as exp(-h/2 km), but with no less
/// than 2e-6 of the total pressure. The layers' pressures meet to 2e-5, at 86 km to 1e-3. Below height 0 the same
/// formulas go on; above 100 km there is nothing.
/// @param surface_vapour_kg_per_m3  density of the vapour at height 0, in place of the recommendation's
[[nodiscard]] AirState reference_air(double height_m, double surface_vapour_kg_per_m3 = reference_vapour_kg_per_m3);

/// Refractivity N of air (ITU-R P.453-14): 77.6 p_d/T + 72 e/T + 3.75e5 e/T^2, pressures in hPa.
[[nodiscard]] double refractivity_of(const AirState& air);

/// The next height at which a law of the reference atmosphere changes or which is at most 2 km on (5 km above 22 km);
/// infinity from 100 km on. In between everything is smooth, but for the floor of the vapour.
[[nodiscard]] double next_reference_break_m(double height_m);

}  // namespace sarsim::radar
