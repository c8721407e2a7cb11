#pragma once

#include <array>
#include <optional>
#include <string>

#include "picture/figure/picture_file.hpp"
#include "picture/figure/sheet.hpp"
#include "picture/scene/drawing.hpp"
#include "picture/scene/snapshot_maker.hpp"

namespace sarsim::picture {

/// How a scene is looked at by a command.
struct SceneLook {
  /// The direction; `beam`: along it, from the antenna.
  enum class From { start, top, front, side, beam } from = From::start;
  std::optional<std::array<double, 2>> direction_rad;  ///< Azimuth and elevation of the viewer instead.
  std::optional<std::size_t> radar;     ///< Along whose beam, counted from 0; the first where it is not said.
  std::optional<std::size_t> followed;  ///< The platform, counted from 0, that stays in the middle.
  bool perspective = false;
  DrawingOptions options;
};

/// The pictures of a scene at many times, as the workbench shows them: everything in view, all the time.
class SceneView {
 public:
  /// @param times_s  the first and the last time that will be asked for: what is there then is in view
  SceneView(const scene::Scene& scene, const SceneLook& look, const PictureStyle& style, std::array<double, 2> times_s);

  /// The scene at a time, for `draw_sheet` with the same style.
  [[nodiscard]] Sheet at(double time_s);

 private:
  [[nodiscard]] Camera camera_at(const Snapshot& snapshot) const;

  SnapshotMaker maker_;
  SceneLook look_;
  PictureStyle style_;
  Camera camera_;
  core::Vec3 way_to_focus_m_;  // from the platform that is followed
  double trail_s_ = 0.0;
  Drawing drawing_;
};

/// Where the platform with a number is; nothing where the snapshot does not have it.
[[nodiscard]] std::optional<core::Vec3> platform_place(const Snapshot& snapshot, std::size_t number);

/// The camera that looks along the beam of a radar of a snapshot, as far as the ground; `camera` where there is none.
[[nodiscard]] Camera beam_camera(const Camera& camera, const Snapshot& snapshot, std::size_t radar);

/// A drawing as a sheet.
/// @param scale  of the drawing: its pixels for each one of the sheet
[[nodiscard]] Sheet sheet_of(const Drawing& drawing, bool dark, double scale);

}  // namespace sarsim::picture
