#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "picture/render/mesh.hpp"
#include "picture/render/shapes.hpp"
#include "radar/antenna/beam.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/motion/track.hpp"
#include "scene/model/object.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::picture {

/// What stands for a platform that moves.
struct PlatformSymbol {
  Symbol symbol = Symbol::aircraft;
  core::Mat3 world_from_symbol;  ///< Columns: nose, left, up.
};

/// Where everything in a scene stands at one time, for drawing. Faulty objects (a half-typed scene) are left out or
/// stand where the rest of them can be understood; nothing throws.
struct Snapshot {
  /// Where a platform is and how it is turned.
  struct Platform {
    scene::ObjectId id;
    std::string name;
    radar::Pose pose;
    std::vector<core::Vec3> trail_world_m;  ///< Its path around the time; empty where it does not move.
    std::vector<double> trail_s;            ///< The times at which it is there.
    core::Vec3 foot_world_m;                ///< The ground below it (`ground_below`).
    std::optional<PlatformSymbol> symbol;   ///< Nothing where it is at rest.
    /// Of legs, waypoints and states the points of `scene::path_points`,
    std::vector<core::Vec3> path_points_world_m;
    std::vector<core::Vec3> path_world_m;  ///< and the path, or the arrow, from the first to the last of them.
  };
  /// Where a target is.
  struct Target {
    scene::ObjectId id;
    core::Vec3 position_world_m;  ///< Without the jitter that a target draws for every pulse.
    core::Vec3 foot_world_m;      ///< Below or above it in the platform's x-y plane.
    core::Vec3 normal_world;      ///< Unit; of directional ones.
    bool directional = false;
  };
  /// The corners of a surface.
  struct Surface {
    scene::ObjectId id;
    std::array<core::Vec3, 3> corner_world_m;
    core::Vec3 normal_world;  ///< Unit; the side that reflects. 0 where the triangle has no area.
  };
  /// Where an antenna is, looks, and how wide its beam is.
  struct Radar {
    scene::ObjectId id;
    std::string name;
    core::Vec3 position_world_m;
    core::Vec3 axis_world;    ///< Unit vector along the beam.
    core::Vec3 across_world;  ///< Unit vector of the antenna's x, for the beam's cross-section.
    double azimuth_width_rad =
        0.0;  ///< Half-power widths of a sin(x)/x pattern; of a user pattern where it falls by 3 dB.
    double elevation_width_rad = 0.0;
    bool isotropic = true;
    /// Points of the transmit pattern's lobe: gain against direction, for those who draw it: [elevation][azimuth],
    /// world directions times the one-way amplitude over its largest (0 to 1). Empty where isotropic.
    std::vector<std::vector<core::Vec3>> lobe_world;
    /// The half-power outline of the transmit pattern on the ground (`half_power_outline`, `ground_points`), around the
    /// beam; nothing where it misses the ground. Empty where isotropic.
    std::vector<std::optional<core::Vec3>> footprint_world_m = {};
    /// The ground at both ends of the slant range of the radar's first recording (`range_on_ground`).
    std::array<std::vector<core::Vec3>, 2> swath_world_m = {};
    /// Footprints from the beginning of its first recording to now, where they are asked for.
    std::vector<std::vector<std::optional<core::Vec3>>> illuminated_world_m = {};
    radar::BeamOffset beam_middle = {};  ///< Highest gain, as an offset from the axis (`picture::beam_middle`), rad.
  };
  double time_s = 0.0;
  std::vector<Platform> platforms;
  std::vector<Target> targets;
  std::vector<Target> cloud_points;  ///< At most 5000 of each cloud, evenly chosen, each with the id of its cloud.
  std::vector<Surface> surfaces;
  std::vector<Radar> radars;
  std::optional<radar::EarthFrame> earth;
  std::array<std::shared_ptr<const Mesh>, 2> globe;  ///< `globe_mesh` in light and in dark, where there is an Earth.
};

/// Where an object is: its origin, the middle of a surface's corners, or the first point of a cloud; nothing where the
/// snapshot has no such object.
[[nodiscard]] std::optional<core::Vec3> place_of(const Snapshot& snapshot, scene::ObjectId id);

}  // namespace sarsim::picture
