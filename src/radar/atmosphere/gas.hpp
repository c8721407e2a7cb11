#pragma once

#include "radar/atmosphere/reference_atmosphere.hpp"

namespace sarsim::radar {

/// What air costs a wave, by its parts.
struct GasLoss {
  double oxygen_db_per_m = 0.0;  ///< Oxygen's lines, the Debye spectrum of oxygen and nitrogen's pressure absorption.
  double vapour_db_per_m = 0.0;  ///< Lines of water vapour with the continuum.

  [[nodiscard]] double sum_db_per_m() const { return oxygen_db_per_m + vapour_db_per_m; }
};

/// Specific attenuation by gases, one way, line by line: ITU-R P.676-13, annex 1, equations 1 to 9, with 44 lines of
/// oxygen and 35 of water vapour. 1 to 1000 GHz.
[[nodiscard]] GasLoss gas_loss(double carrier_hz, const AirState& air);

/// One-way loss from a height through the whole reference atmosphere to space, dB, as P.676-13 computes it (annex 1,
/// 2.2.1): a ray that is bent as it passes 922 shells of the air in their middles, from 0.1 m thick at the ground to 1
/// km at 100 km, over a sphere of 6371 km. A ray from above the ground begins inside a shell.
/// @param elevation_rad  apparent one of the ray at its beginning, in [0, pi/2]
/// @param height_m       at least 0
[[nodiscard]] double slant_gas_loss_db(double carrier_hz, double elevation_rad, double height_m = 0.0,
                                       double surface_vapour_kg_per_m3 = reference_vapour_kg_per_m3);

}  // namespace sarsim::radar
