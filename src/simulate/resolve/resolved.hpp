#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/task/parallel.hpp"
#include "radar/earth/sagnac.hpp"
#include "radar/motion/track.hpp"
#include "scene/model/run_options.hpp"
#include "simulate/resolve/conventions.hpp"
#include "simulate/resolve/link.hpp"
#include "simulate/resolve/scatterers.hpp"

namespace sarsim::scene {
struct Scene;
}

/// A checked scene with its names looked up and its functions ready to evaluate. SI units and radians throughout.
namespace sarsim::simulate {

/// A platform whose motion can be evaluated.
struct ResolvedPlatform {
  std::string name;
  radar::Track track;
  core::Vec3 middle_m;    ///< Of its scatterers, in its frame; the origin where it has none.
  double radius_m = 0.0;  ///< Of a ball around that which holds them.
};

/// A surface as scatterers with a common normal and cross-section, cosine law.
struct ScattererSheet {
  std::uint32_t platform = 0;
  core::Vec3 normal_platform;
  double point_rcs_m2 = 0.0;
  std::vector<core::Vec3> points_m;
};

/// A scene without its radars.
struct ResolvedScene {
  /// Whether the world turns while light is under way.
  [[nodiscard]] bool turns() const { return turning.rotation_rad_per_s != core::Vec3{}; }

  Conventions conventions;
  scene::RunOptions options;
  radar::TurningAxes turning;  ///< How the world turns with the Earth; at rest over a flat one.
  std::vector<ResolvedPlatform> platforms;
  ScattererList scatterers;            ///< One per target, in order, then the points of the clouds.
  std::vector<ScattererSheet> sheets;  ///< One per surface, in order.
  std::vector<core::Interpolator> gain_curves;
};

/// Platforms that carry targets, points of clouds or surfaces, ascending.
[[nodiscard]] std::vector<std::uint32_t> reflecting_platforms(const ResolvedScene& scene);

/// Points per square metre that a `$SURFACE` is filled with (docs/theory/echo-model.md).
inline constexpr double surface_points_per_m2 = 1.0;

/// Resolves everything but the radars. The scene must have passed `check`; a name that is not found is
/// std::invalid_argument, except the platform "Earth", which is the world itself; so is a cloud whose points are not
/// read. A requested stop throws Interrupted.
[[nodiscard]] ResolvedScene resolve(const scene::Scene& scene, const core::WorkControl& control = {});

/// A scene with at most so many points of each of its clouds, evenly chosen: for looks that need not see all of them.
/// The same scene where no cloud has more.
[[nodiscard]] std::shared_ptr<const ResolvedScene> thinned(std::shared_ptr<const ResolvedScene> scene,
                                                           std::size_t max_points);

/// Resolves one radar of a scene.
[[nodiscard]] Link resolve_radar(const scene::Scene& scene, const ResolvedScene& resolved, std::size_t radar);

}  // namespace sarsim::simulate
