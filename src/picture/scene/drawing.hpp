#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "picture/colour/theme.hpp"
#include "picture/render/rasteriser.hpp"
#include "picture/scene/camera.hpp"
#include "picture/scene/gizmo.hpp"
#include "picture/scene/ruler.hpp"
#include "picture/scene/snapshot.hpp"

namespace sarsim::picture {

/// A point of `Snapshot::Platform::path_points_world_m`.
struct PathPointId {
  scene::ObjectId platform;
  std::size_t index = 0;

  friend bool operator==(const PathPointId&, const PathPointId&) = default;
};

/// What the View menu switches (thesis 4.1.2), and what is set apart.
struct DrawingOptions {
  bool coordinate_systems = true;  ///< Main axes and the platforms' own.
  bool corner_triad = true;
  bool elevation_lines = true;
  bool filled_surfaces = false;
  bool labels = true;
  bool trails = true;
  bool ground_grid = false;  ///< Lines of the plane z = 0 with their distances.
  bool footprints = false;   ///< Beams down to the ground, and the slant ranges that are recorded.
  bool lobes = false;        ///< Pattern lobes instead of cones.
  bool symbols = true;       ///< Solids that stand for moving platforms.
  bool illuminated = false;  ///< The ground that was illuminated so far, which the snapshot must have.
  bool sky = true;           ///< Above the horizon of a perspective view of a plane ground.
  enum class Tracks { plain, by_time, by_speed } tracks = Tracks::plain;  ///< Colours of trails.
  bool dark = false;                                                      ///< Light marks on a dark ground.
  unsigned threads = 1;      ///< For solids; changes nothing in the picture.
  int samples = 1;           ///< For each side of a pixel of solids (RenderControl).
  bool coarse = false;       ///< Less detail while the mouse drags: no labels and drop lines of targets, at most
                             ///< `coarse_targets` discs.
  double pixel_scale = 1.0;  ///< Device pixels per pixel of the screen: sizes are multiplied by it.
  std::set<scene::ObjectId> selected;
  std::optional<scene::ObjectId> hovered;
  std::optional<PathPointId> hovered_point;
  std::set<scene::ObjectId> hidden;
  std::optional<PathPointId> selected_point;
  std::optional<Gizmo> gizmo;  ///< Drawn above everything.
  std::optional<GizmoHandle> hovered_handle;
  std::optional<Ruler> ruler;
  std::vector<std::string> ruler_words;  ///< What stands beside it.
  std::optional<GizmoGuide> guide;       ///< While something is dragged along an axis.
};
inline constexpr std::size_t coarse_targets = 2000;

/// The scene as solids and marks on a picture, back to front. Coordinates in device pixels.
struct Drawing {
  /// A straight line.
  struct Line {
    float x0, y0, x1, y1;
    Role role;
    float width_px;
    bool dotted;
    std::uint8_t tone = 0;  ///< Of Role::track: 0 to 255.
  };
  /// A filled circle, or a ring.
  struct Disc {
    float x, y;
    float diameter_px;
    Role role;
    bool outlined;
  };
  /// What becomes of words where there is no room (`place_labels`).
  enum class Hold {
    fixed,    ///< They stay.
    movable,  ///< They go up or down.
    spare,    ///< They are left out.
  };
  /// Words.
  struct Text {
    float x, y;  ///< Left end of the base line, or its middle.
    std::string text;
    Role role;
    bool bold;
    bool centred;
    Hold hold = Hold::fixed;
  };
  /// What can be picked: an object with a place of it. A platform has a second one at its name, because its radar
  /// covers its origin; the handle of a surface, at its centroid, says only that it was drawn.
  struct Handle {
    scene::ObjectId id;
    float x = 0.0F;
    float y = 0.0F;
    float depth_m = 0.0F;
    std::optional<std::size_t> path_point = std::nullopt;  ///< It moves this point of the platform's path.
  };
  /// The row [px] of the horizon, above which there is sky; nothing: no sky.
  std::optional<double> horizon_px;
  MeshList meshes;          ///< Solids, whose numbers are those of `solids`,
  std::size_t scenery = 0;  ///< of which the first so many hide what is behind them.
  Rendering solids;         ///< Drawn first,
  std::vector<Line> lines;  ///< then lines,
  std::vector<Disc> discs;  ///< discs,
  std::vector<Text> texts;  ///< and words.
  std::vector<Handle> handles;
  std::shared_ptr<Rasteriser> rasteriser;  ///< Keeps its room for the next picture.
};

/// The colour of a line.
[[nodiscard]] raster::Rgb colour_of(const Drawing::Line& line, bool dark);

/// The object under a picture point: the nearest handle within `reach_px`, targets and radars before platforms, the
/// nearer to the viewer first where two are equally near (to half a pixel); else what is solid there; else the nearest
/// surface whose triangle holds the point or has its rim within reach. Only what `draw_scene` put into `drawing`.
[[nodiscard]] std::optional<scene::ObjectId> picked(const Drawing& drawing, const Snapshot& snapshot,
                                                    const Camera& camera, double x_px, double y_px, double reach_px);

/// The point of a platform's path under a picture point: the nearest within `reach_px`, and the one nearer to the
/// viewer where two are equally near.
[[nodiscard]] std::optional<PathPointId> picked_path_point(const Drawing& drawing, double x_px, double y_px,
                                                           double reach_px);

/// The point of a selected platform's path, legs or waypoints, whose line is nearest to a picture point; nothing where
/// none is within `reach_px`.
struct PathPlace {
  scene::ObjectId platform;
  core::Vec3 at_world_m;
};
[[nodiscard]] std::optional<PathPlace> picked_path_place(const Snapshot& snapshot, const DrawingOptions& options,
                                                         const Camera& camera, double x_px, double y_px,
                                                         double reach_px);

/// All points of a snapshot that a fitted view should show: objects and the points of paths, not trails.
[[nodiscard]] std::vector<core::Vec3> points_of(const Snapshot& snapshot);
/// The same of some objects.
[[nodiscard]] std::vector<core::Vec3> points_of(const Snapshot& snapshot,
                                                const std::function<bool(scene::ObjectId)>& wanted);

}  // namespace sarsim::picture
