#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Largest interpolation error of a path without a warning, in wavelengths: pi/4 in the phase of an echo.
inline constexpr double tolerated_wavelengths = 1.0 / 16.0;
/// The same for an attitude, in -3 dB beamwidths: the gain at the edge of the beam changes by 0.7 dB.
inline constexpr double tolerated_beamwidths = 1.0 / 16.0;

/// Use of a radar: its shortest wavelength, its beamwidth and the time of one of its recordings or geometry tables.
struct Look {
  std::string radar;
  double wavelength_m = 0.0;
  double beamwidth_rad = 0.0;  ///< Of its narrowest cut, 3 dB; infinite for isotropic antennas.
  double from_s = 0.0;         ///< Time of the scene.
  double to_s = 0.0;
};

/// Those of all recordings whose radar has carriers.
[[nodiscard]] std::vector<Look> looks_of(const Scene& scene);

/// Those of recordings and geometry tables that depend on the motion of one platform: of the radars that it carries,
/// itself or as parent or leader of other platforms; of all radars if it carries something that reflects.
[[nodiscard]] std::vector<Look> looks_of(const Scene& scene, std::size_t platform);

/// Largest distance from a platform's origin of the radars and targets that it carries, its own and those of platforms
/// at rest on it, m.
[[nodiscard]] double arm_m(const Scene& scene, std::size_t platform);

}  // namespace sarsim::scene
