#pragma once

#include "picture/render/mesh.hpp"
#include "picture/scene/drawing.hpp"

namespace sarsim::picture {

/// What of a scene is solid, or a veil, as it is drawn: the globe, filled surfaces, ground that was illuminated, beams
/// with their footprints, and last the symbols of platforms, which hide no marks.
struct Solids {
  MeshList meshes;
  std::size_t scenery = 0;  ///< The first so many hide marks behind them.
};
[[nodiscard]] Solids solids_of(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options);

}  // namespace sarsim::picture
