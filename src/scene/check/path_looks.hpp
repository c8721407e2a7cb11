#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Largest error of a path between its points that nobody is told of, in wavelengths.
inline constexpr double tolerated_wavelengths = 1.0 / 16.0;
/// The same of an attitude, in widths of the beam: the gain at the edge of the beam changes by 0.7 dB.
inline constexpr double tolerated_beamwidths = 1.0 / 16.0;

/// A radar that looks: its shortest wavelength and the time of one of its recordings or tables.
struct Look {
  std::string radar;
  double wavelength_m = 0.0;
  double beamwidth_rad = 0.0;  ///< Of its narrowest cut, 3 dB; infinite for isotropic antennas.
  double from_s = 0.0;
  double to_s = 0.0;
};

/// Those of all recordings whose radar has carriers.
[[nodiscard]] std::vector<Look> looks_of(const Scene& scene);

/// Those of recordings and geometry tables that the motion of one platform matters to: of the radars that it carries,
/// itself or as parent or leader of other platforms; of all radars where it carries something that reflects.
[[nodiscard]] std::vector<Look> looks_of(const Scene& scene, std::size_t platform);

/// How far what a platform carries is from its origin: radars and targets of its own and of platforms on it that rest
/// there, m.
[[nodiscard]] double arm_m(const Scene& scene, std::size_t platform);

}  // namespace sarsim::scene
