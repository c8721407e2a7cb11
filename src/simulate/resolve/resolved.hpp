#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/task/parallel.hpp"
#include "radar/antenna/beam.hpp"
#include "radar/antenna/pattern.hpp"
#include "radar/motion/track.hpp"
#include "radar/target/reflectivity.hpp"
#include "radar/waveform/pulse.hpp"
#include "radar/waveform/schedule.hpp"
#include "scene/model/scene.hpp"
#include "signal/compress/range_compression.hpp"
#include "simulate/resolve/conventions.hpp"

/// A checked scene with its names looked up and its functions ready to evaluate. SI units and radians throughout.
namespace sarsim::simulate {

/// A platform whose motion can be evaluated.
struct ResolvedPlatform {
  std::string name;
  radar::Track track;
  core::Vec3 middle_m;    ///< Of its scatterers, in its frame; the origin where it has none.
  double radius_m = 0.0;  ///< Of a ball around that which holds them.
};

/// A point target.
struct Scatterer {
  std::uint32_t platform = 0;
  std::uint32_t gain_curve = 0;  ///< Index into ResolvedScene::gain_curves; ReflectivityLaw::user.
  radar::ReflectivityLaw law = radar::ReflectivityLaw::isotropic;
  bool jittered = false;  ///< Any standard deviation is not 0.
  core::Vec3 position_m;  ///< In the platform's frame.
  core::Vec3 position_stddev_m;
  double rcs_m2 = 1.0;
  double rcs_stddev_m2 = 0.0;
  double azimuth_rad = 0.0;  ///< Of the normal, in the platform's frame.
  double elevation_rad = 0.0;
  double azimuth_stddev_rad = 0.0;
  double elevation_stddev_rad = 0.0;
};

/// A surface as scatterers with a common normal and cross-section, cosine law.
struct ScattererSheet {
  std::uint32_t platform = 0;
  core::Vec3 normal_platform;
  double point_rcs_m2 = 0.0;
  std::vector<core::Vec3> points_m;
};

/// A radar with its platform by number and its functions ready.
struct ResolvedRadar {
  std::string name;
  std::uint32_t platform = 0;
  radar::Pulse pulse;
  radar::Repetition repetition;
  radar::CarrierPlan carrier;
  double radiated_w = 0.0;  ///< Power times gains over losses: P Gt Gr/L.
  double noise_temperature_k = 0.0;
  radar::AntennaPattern transmit;
  radar::AntennaPattern receive;
  radar::Beam beam;
  signal::WindowFunction window;
  scene::Radar::Stc stc = scene::Radar::Stc::none;
  core::Interpolator stc_gain;
};

/// A scene without its radars.
struct ResolvedScene {
  Conventions conventions;
  scene::RunOptions options;
  std::vector<ResolvedPlatform> platforms;
  std::vector<Scatterer> scatterers;   ///< One per target, in order.
  std::vector<ScattererSheet> sheets;  ///< One per surface, in order.
  std::vector<core::Interpolator> gain_curves;
};

/// Points per square metre that a `$SURFACE` is filled with (docs/theory/echo-model.md).
inline constexpr double surface_points_per_m2 = 1.0;

/// Resolves everything but the radars. The scene must have passed `check`; a name that is not found is
/// std::invalid_argument, except the platform "Earth", which is the world itself. A requested stop throws Interrupted.
[[nodiscard]] ResolvedScene resolve(const scene::Scene& scene, const core::WorkControl& control = {});

/// Resolves one radar of a scene.
[[nodiscard]] ResolvedRadar resolve_radar(const scene::Scene& scene, const ResolvedScene& resolved, std::size_t radar);

}  // namespace sarsim::simulate
