#pragma once

#include "radar/atmosphere/straight_path.hpp"

namespace sarsim::radar {

/// Specific attenuation k R^alpha of rain, R in mm/h, in dB/km.
struct RainLaw {
  double k = 0.0;
  double alpha = 1.0;

  friend constexpr bool operator==(const RainLaw&, const RainLaw&) = default;
};

/// The laws of one frequency for both linear polarisations (ITU-R P.838-3, equations 2 and 3).
struct RainLaws {
  RainLaw horizontal;
  RainLaw vertical;
};

/// The laws of a frequency; 1 to 1000 GHz, what is beyond counts as the nearest of these.
[[nodiscard]] RainLaws rain_laws(double carrier_hz);

/// The law of any linear polarisation on a path (P.838-3, equations 4 and 5).
/// @param sine      of the path's elevation
/// @param tilt_rad  of the polarisation from the horizontal: 0 horizontal, pi/2 vertical; pi/4 stands for circular
[[nodiscard]] RainLaw rain_law(const RainLaws& laws, double sine, double tilt_rad);

/// What rain costs on a metre of its path, one way, dB/m; 0 without rain.
[[nodiscard]] double rain_loss_db_per_m(const RainLaw& law, double rate_mm_per_h);

/// Rain that is the same everywhere below a height.
struct UniformRain {
  double rate_mm_per_h = 0.0;
  double top_m = 5000.0;  ///< Rain height: the mean 0 degree isotherm and 0.36 km (ITU-R P.839), 5 km in the tropics.
  double tilt_rad = 0.0;  ///< Of the polarisation from the horizontal.
};

/// One-way loss of a path in rain, dB: its part below the top times the specific attenuation at the elevation of the
/// lower end. No reduction factor for the size of rain cells: that belongs to statistics of links.
[[nodiscard]] double rain_loss_db(const UniformRain& rain, const RainLaws& laws, const StraightPath& path);

}  // namespace sarsim::radar
