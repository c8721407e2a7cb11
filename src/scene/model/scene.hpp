#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/model/platform.hpp"
#include "scene/model/radar.hpp"
#include "scene/model/recording.hpp"
#include "scene/model/run_options.hpp"
#include "scene/model/target.hpp"
#include "scene/model/world.hpp"

/// What a script describes, as plain data. Any values can be stored, so that an editor can hold a
/// half-typed object; `check` (scene/check/check.hpp) says whether they can be simulated. SI units, except
/// that angles and decibels keep what was typed (core/maths/angle.hpp) and that the knots of user-defined
/// functions stay in the units that their name ends in.
namespace sarsim::scene {

/// Everything that a script says, in the script's order within each list.
struct Scene {
  std::vector<Platform> platforms;
  std::vector<Surface> surfaces;
  std::vector<Target> targets;
  std::vector<Cloud> clouds;
  std::vector<Radar> radars;
  std::vector<Simulation> simulations;
  std::vector<GeometryTable> geometries;
  RunOptions options;
  World world;
  Atmosphere atmosphere;

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// True where one of two texts is the beginning of the other, without regard to case, and neither is empty: as the
/// original programs compared (script format, strings).
[[nodiscard]] bool share_prefix(std::string_view a, std::string_view b);

/// Position of the platform that `name` means, or `not_found`: an exact match ignoring case first, otherwise the only
/// platform of which `name` is a prefix (or that is a prefix of `name`). "Earth" where no platform has exactly that
/// name is not found: it is the world itself, which `resolve` (simulate/resolve/resolved.hpp) knows without a
/// definition.
inline constexpr std::size_t not_found = static_cast<std::size_t>(-1);
/// See `not_found`.
[[nodiscard]] std::size_t find_platform(const Scene& scene, std::string_view name);
/// The same for radars.
[[nodiscard]] std::size_t find_radar(const Scene& scene, std::string_view name);

}  // namespace sarsim::scene
