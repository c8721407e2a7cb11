#pragma once

#include <array>
#include <memory>

#include "picture/scene/snapshot.hpp"
#include "scene/edit/scene_change.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::picture {

/// Makes snapshots of one scene at many times; tracks are prepared once.
class SnapshotMaker {
 public:
  /// @param scene  is copied where needed
  explicit SnapshotMaker(const scene::Scene& scene);
  ~SnapshotMaker();
  SnapshotMaker(SnapshotMaker&&) noexcept;
  SnapshotMaker& operator=(SnapshotMaker&&) noexcept;

  /// Takes up what became of the scene that it was made of; moved targets and surfaces cost no look at the others.
  ///
  /// @param scene   after the change
  /// @param change  since the scene that was followed last
  void follow(const scene::Scene& scene, const scene::SceneChange& change);

  /// Poses are those of the pulse that the scene's first radar sent last, random motion errors included.
  /// @param time_s   taken as 0 where it is not a finite number
  /// @param trail_s  length of the trails, half before and half after the time; 0: none. Trails follow the nominal
  /// path.
  /// @param illuminated  the ground that radars illuminated until then is asked for as well
  [[nodiscard]] Snapshot at(double time_s, double trail_s = 0.0, bool illuminated = false) const;
  /// From the first to the last time that a trajectory, rotation, steered beam, simulation or geometry table of the
  /// scene mentions; 1 s from the only one, 0 to 1 s where there is none.
  [[nodiscard]] std::array<double, 2> time_span_s() const;

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace sarsim::picture
