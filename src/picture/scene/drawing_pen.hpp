#pragma once

#include <array>
#include <optional>
#include <string>

#include "picture/scene/drawing.hpp"

namespace sarsim::picture {

/// Puts marks of the world and of the picture onto a drawing, clipped to the picture and a margin about it, so that no
/// painter meets endless lines. Lengths named `_px` in arguments are pixels of the screen, before `pixel_scale`.
class Pen {
 public:
  /// Keeps references; all three must outlive it.
  Pen(const Camera& camera, const DrawingOptions& options, Drawing& drawing);

  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const DrawingOptions& options() const { return options_; }
  [[nodiscard]] Drawing& drawing() { return drawing_; }
  /// Pixels of the screen in device pixels.
  [[nodiscard]] double px(double length_px) const { return length_px * options_.pixel_scale; }

  /// Camera::project with the rotation at hand.
  [[nodiscard]] std::optional<PicturePoint> project(const core::Vec3& world_m) const;
  /// True within the picture and its margin.
  [[nodiscard]] bool visible(const PicturePoint& point) const;
  /// Where a mark of `length_px` along a world direction ends that begins at a picture point.
  [[nodiscard]] PicturePoint along(const PicturePoint& start, const core::Vec3& direction_world,
                                   double length_px) const;

  /// A line in the picture; widths are pixels of the screen.
  void line(const PicturePoint& a, const PicturePoint& b, Role role, double width_px, bool dotted = false,
            std::uint8_t tone = 0);
  /// Whether scenery is in front of a point.
  [[nodiscard]] bool hides(const PicturePoint& point) const;
  /// A line in space; of one that passes the viewer of a perspective view the part in front, and of that what no
  /// scenery hides.
  /// @param tone  of Role::track
  void world_line(const core::Vec3& a_world_m, const core::Vec3& b_world_m, Role role, double width_px,
                  bool dotted = false, std::uint8_t tone = 0);
  /// A disc about a point of the picture; its diameter in pixels of the screen.
  void disc(const PicturePoint& at, double diameter_px, Role role, bool outlined);
  /// Words at a place of the picture: the left end of their base line, or its middle.
  void text(double x, double y, const std::string& words, Role role, bool bold, bool centred,
            Drawing::Hold hold = Drawing::Hold::fixed);
  /// Makes an object, or a point of its path, be picked at a point.
  void handle(const scene::ObjectId& id, const PicturePoint& at, std::optional<std::size_t> path_point = std::nullopt);

  [[nodiscard]] bool hidden(const scene::ObjectId& id) const { return options_.hidden.contains(id); }
  [[nodiscard]] bool selected(const scene::ObjectId& id) const { return options_.selected.contains(id); }
  [[nodiscard]] bool hovered(const scene::ObjectId& id) const { return options_.hovered == id; }
  /// `usual`, or the role of what is hovered or selected.
  [[nodiscard]] Role role_of(const scene::ObjectId& id, Role usual) const;

 private:
  [[nodiscard]] core::Vec3 in_picture_axes(const core::Vec3& world_m) const;
  [[nodiscard]] PicturePoint point_of(const core::Vec3& picture_m) const;
  [[nodiscard]] bool hides_at(double x_px, double y_px, double nearness_px) const;
  // Of a line whose depths are nearness.
  void seen_parts(PicturePoint from, PicturePoint to, Role role, double width_px, bool dotted, std::uint8_t tone);

  const Camera& camera_;
  const DrawingOptions& options_;
  Drawing& drawing_;
  core::Mat3 picture_from_world_;
  Viewpoint viewpoint_;
  double nearest_depth_m_;  // of what is drawn in perspective
};

/// Lines of the plane z = 0 at round distances, about 90 pixels apart, under what the camera looks at, with the
/// distances from the origin at their nearer ends.
void draw_ground_grid(Pen& pen);
/// Meridians and parallels at round angles about what the camera looks at, with their degrees.
void draw_graticule(Pen& pen, const radar::EarthFrame& earth);
/// The axes of the world through its origin.
void draw_main_axes(Pen& pen);
/// The directions of the world's axes in a corner of the picture.
void draw_corner_triad(Pen& pen);
/// A bar of a round length at the lower left; true at the focus's depth.
void draw_scale_bar(Pen& pen);
/// Three lines of equal length along the columns of `world_from_frame` with their letters; lines seen nearly end on
/// carry no letter.
void draw_axes(Pen& pen, const PicturePoint& origin, const core::Mat3& world_from_frame, double length_px,
               double width_px, bool letters);
void draw_surfaces(Pen& pen, const std::vector<Snapshot::Surface>& surfaces);
void draw_targets(Pen& pen, const std::vector<Snapshot::Target>& targets);
void draw_radars(Pen& pen, const std::vector<Snapshot::Radar>& radars);
void draw_platforms(Pen& pen, const std::vector<Snapshot::Platform>& platforms);
/// What a hand works with: the handles of what is selected, the guide of a drag, the ruler.
void draw_hands(Pen& pen);

}  // namespace sarsim::picture
