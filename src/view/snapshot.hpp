#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "motion/track.hpp"
#include "scene/scene.hpp"
#include "view/object.hpp"

namespace sarsim {

/// Where everything in a scene stands at one time, for drawing. Faulty objects (a half-typed scene) are left out or
/// stand where the rest of them can be understood; nothing throws.
struct Snapshot {
  struct Platform {
    ObjectId id;
    std::string name;
    Pose pose;
    std::vector<Vec3> trail_world_m;  ///< Its path around the time; empty where it does not move.
  };
  struct Target {
    ObjectId id;
    Vec3 position_world_m;
    Vec3 foot_world_m;  ///< Below or above it in the platform's x-y plane.
    Vec3 normal_world;  ///< Unit; of directional ones.
    bool directional = false;
  };
  struct Surface {
    ObjectId id;
    std::array<Vec3, 3> corner_world_m;
    Vec3 normal_world;  ///< Unit; the side that reflects.
  };
  struct Radar {
    ObjectId id;
    std::string name;
    Vec3 position_world_m;
    Vec3 axis_world;           ///< Unit vector along the beam.
    Vec3 across_world;         ///< Unit vector of the antenna's x, for the beam's cross-section.
    double azimuth_width_rad;  ///< Half-power widths of a sin(x)/x pattern; of a user pattern where it falls by 3 dB.
    double elevation_width_rad;
    bool isotropic = true;
    /// Points of the pattern's lobe: gain against direction, for those who draw it: [elevation][azimuth], world
    /// directions times the one-way amplitude (0 to 1).
    std::vector<std::vector<Vec3>> lobe_world;
  };
  double time_s = 0.0;
  std::vector<Platform> platforms;
  std::vector<Target> targets;
  std::vector<Surface> surfaces;
  std::vector<Radar> radars;
};

/// Makes snapshots of one scene at many times; tracks are prepared once.
class SnapshotMaker {
 public:
  /// @param scene  is copied where needed
  explicit SnapshotMaker(const Scene& scene);
  ~SnapshotMaker();
  SnapshotMaker(SnapshotMaker&&) noexcept;
  SnapshotMaker& operator=(SnapshotMaker&&) noexcept;

  /// @param trail_s  length of the trails, half before and half after the time; 0: none
  [[nodiscard]] Snapshot at(double time_s, double trail_s = 0.0) const;
  /// From the first to the last time that a trajectory, rotation or simulation of the scene mentions; 0 to 1 s where
  /// none does.
  [[nodiscard]] std::array<double, 2> time_span_s() const;

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace sarsim
