#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/maths/vector.hpp"
#include "picture/render/viewpoint.hpp"

namespace sarsim::picture {

/// A point of the picture: x to the right, y down, in device pixels; depth grows away from the viewer [m].
struct PicturePoint {
  double x = 0.0;
  double y = 0.0;
  double depth_m = 0.0;
};

/// How far the viewer of a perspective view usually stands from the focus, in heights of the picture: 28 degrees from
/// the upper edge to the lower.
inline constexpr double distance_in_heights = 2.0;

/// Where the scene is looked at from. A value: every gesture returns or makes another one.
///
/// The view axis is given by azimuth (clockwise from +y, thesis 4.1) and elevation of the viewer as seen from the
/// focus; z is up in the picture. Orthographic by default (thesis 4.1); in perspective the viewer stands
/// `heights_away` picture heights away from the focus, where the scale is that of the orthographic view.
struct Camera {
  core::Vec3 focus_world_m;
  double azimuth_rad = 0.0;
  double elevation_rad = 0.0;
  double pixels_per_m = 0.01;
  bool perspective = false;
  double width_px = 800.0;
  double height_px = 600.0;
  double heights_away = distance_in_heights;

  /// The start view of the thesis: azimuth 60 degrees, elevation 30.
  [[nodiscard]] static Camera start(double width_px, double height_px);

  /// Rows are the picture's axes right, up and towards the viewer, in the world.
  [[nodiscard]] core::Mat3 picture_from_world() const;
  /// Nothing for a point behind the viewer of a perspective view, or so near to the viewer's eye that the scale is
  /// over 1000 times that of the focus, or that is not a finite number.
  [[nodiscard]] std::optional<PicturePoint> project(const core::Vec3& world_m) const;
  /// The world point under a picture point at the focus's depth.
  [[nodiscard]] core::Vec3 unproject(double x_px, double y_px) const;
  /// Pixels per metre at a depth of `project`; 0 behind the viewer of a perspective view.
  [[nodiscard]] double scale_at(double depth_m) const;
  /// Distance of the viewer of a perspective view from the focus [m].
  [[nodiscard]] double viewer_distance_m() const { return heights_away * height_px / pixels_per_m; }
  /// The same for the rasteriser.
  [[nodiscard]] Viewpoint viewpoint() const;
};

/// `Camera::project` of many points: the rotation is found once.
class Projection {
 public:
  /// Keeps a copy of the camera.
  explicit Projection(const Camera& camera);
  /// What `Camera::project` gives for a point.
  [[nodiscard]] std::optional<PicturePoint> operator()(const core::Vec3& world_m) const;

 private:
  Camera camera_;
  core::Mat3 picture_from_world_;
};

inline constexpr double smallest_pixels_per_m = 1e-7;
inline constexpr double largest_pixels_per_m = 1e5;

/// Left drag: four pixels turn one degree in azimuth, two one degree in elevation, which stays within +-90 (thesis
/// 4.1.1). The scene's near side follows the cursor. `scale` is the number of device pixels per pixel of the screen.
[[nodiscard]] Camera turned(Camera camera, double dx_px, double dy_px, double scale = 1.0);
/// Middle drag: the point under the cursor stays under it.
[[nodiscard]] Camera panned(Camera camera, double dx_px, double dy_px);
/// Times `factor` about a picture point, which keeps its place. The scale stays between the two limits above; a factor
/// that is not a positive number changes nothing.
[[nodiscard]] Camera zoomed(Camera camera, double factor, double x_px, double y_px);
/// All points in the picture with a margin; direction kept. One point, or none: the scale is kept.
[[nodiscard]] Camera fitted(Camera camera, const std::vector<core::Vec3>& points_world_m);
/// A mark that keeps its size on the screen, and the room it takes about its point, in device pixels.
struct MarkRoom {
  core::Vec3 at_world_m;
  double left_px = 0.0;
  double right_px = 0.0;
  double above_px = 0.0;
  double below_px = 0.0;
};
/// Moved and, where need be, zoomed out until all marks are whole between the edges of the picture. Marks that take
/// more than two fifths of it count as so large. A mark behind the viewer is passed over.
/// @param edge_px  device pixels that stay free at each edge
[[nodiscard]] Camera with_whole_marks(Camera camera, const std::vector<MarkRoom>& marks, double edge_px);
/// Looks along a beam from its antenna, in perspective: the eye is at the antenna, the beam's middle is the middle of
/// the picture, and its width is a third of the height.
/// @param width_rad  of the beam, the larger of its two; 60 degrees and more, or 0, are taken as 60 degrees
/// @param reach_m    from the antenna to what is looked at; positive
[[nodiscard]] Camera along_beam(Camera camera, const core::Vec3& antenna_world_m, const core::Vec3& axis_world,
                                double width_rad, double reach_m);
enum class ViewPreset { start, top, front, side };
/// Top looks down with +y up in the picture, front along +y, side along -x.
[[nodiscard]] Camera preset(Camera camera, ViewPreset view);

}  // namespace sarsim::picture
