#pragma once

#include <numbers>

namespace sarsim::core {

/// Speed of light in vacuum, exact by the definition of the metre (SI 2019).
inline constexpr double exact_light_speed_mps = 299'792'458.0;

/// The value that the 1998 programs used; the classic profile keeps it (decision 1).
inline constexpr double classic_light_speed_mps = 299'792'500.0;

/// Boltzmann's constant, exact by the definition of the kelvin (SI 2019), J/K.
inline constexpr double boltzmann_j_per_k = 1.380649e-23;

/// The value the thesis prints, used by the classic profile, J/K.
inline constexpr double classic_boltzmann_j_per_k = 1.38e-23;

inline constexpr double pi = std::numbers::pi;

/// Degrees of one radian and radians of one degree.
inline constexpr double deg_per_rad = 180.0 / pi;
inline constexpr double rad_per_deg = pi / 180.0;

}  // namespace sarsim::core
