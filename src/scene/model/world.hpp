#pragma once

#include <string>

#include "core/maths/angle.hpp"

namespace sarsim::scene {

/// Where and when the scene is (format 2 `[world]`).
struct World {
  /// What the world's coordinates are fixed to.
  enum class Frame {
    flat,   ///< Nothing: a plane that rests.
    earth,  ///< The turning Earth, WGS 84: x east, y north, z up at the anchor, turned by its heading.
  };

  Frame frame = Frame::flat;
  std::string epoch;          ///< UTC of time 0, ISO 8601; empty: none.
  core::Angle latitude;       ///< Geodetic, of the anchor; this and what follows: Frame::earth.
  core::Angle longitude;      ///< Positive to the east.
  double height_m = 0.0;      ///< Above the ellipsoid.
  core::Angle heading;        ///< Of the world's y axis, clockwise from north.
  std::string geoid;          ///< Grid of undulations; empty: `undulation_m` everywhere.
  double undulation_m = 0.0;  ///< Height of the mean sea level above the ellipsoid.
  double dut1_s = 0.0;        ///< UT1 - UTC, for orbits in axes that do not turn with the Earth.

  friend bool operator==(const World&, const World&) = default;
};

/// What lies between radars and what they see (format 2 `[atmosphere]`); nothing as it is made.
struct Atmosphere {
  /// How the refractivity depends on height.
  enum class Refraction { none, exponential, linear };

  Refraction refraction = Refraction::none;
  double refractivity = 315.0;     ///< N at height 0.
  double scale_height_m = 7350.0;  ///< Refraction::exponential.
  double k_factor = 4.0 / 3.0;     ///< Refraction::linear.
  bool gases = false;
  double vapour_g_per_m3 = 7.5;  ///< At height 0.
  double rain_mm_per_h = 0.0;
  double rain_top_m = 5000.0;
  core::Angle polarisation;  ///< From the horizontal, for rain.
  double tec_units = 0.0;    ///< Vertical electron content, 1e16/m^2.
  double shell_height_m = 450e3;
  double field_ut = 0.0;  ///< Magnetic field along the path, uT.

  friend bool operator==(const Atmosphere&, const Atmosphere&) = default;
};

}  // namespace sarsim::scene
