#pragma once

#include <QPointF>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "gui/scene/scene_painter.hpp"
#include "picture/scene/camera.hpp"
#include "picture/scene/drawing.hpp"
#include "picture/scene/snapshot.hpp"
#include "radar/earth/earth_frame.hpp"

namespace sarsim::gui {

/// The scene in three dimensions as it is seen: a snapshot from a camera, and what of it is under the pointer. What
/// hands do with it is said by `SceneWidget`.
class ScenePicture : public QWidget {
  Q_OBJECT

 public:
  explicit ScenePicture(QWidget* parent = nullptr);

  /// Shows another moment, or another scene.
  void set_snapshot(picture::Snapshot snapshot);
  [[nodiscard]] const picture::Snapshot& snapshot() const { return snapshot_; }
  /// The size is that of the widget, whatever the camera says.
  void set_camera(const picture::Camera& camera);
  /// The same for a view that is not kept: what is chosen next, from above or of everything, is seen as before it.
  void ride(const picture::Camera& camera);
  [[nodiscard]] const picture::Camera& camera() const { return camera_; }
  /// The same without what a ride along a beam does to it: the view that is worth keeping.
  [[nodiscard]] picture::Camera usual_camera() const;
  /// What is hovered, the pixel scale and the coarse detail are the widget's own.
  void set_options(picture::DrawingOptions options);
  /// Changes only what is selected and hidden, and which point of a path is selected, if any; draws the scene in full
  /// detail.
  void set_marks(const std::set<scene::ObjectId>& selected, const std::set<scene::ObjectId>& hidden,
                 std::optional<picture::PathPointId> point);
  [[nodiscard]] const picture::DrawingOptions& options() const { return options_; }
  /// Light marks on a dark ground, or the other way round.
  void set_dark(bool dark);
  /// How tooltips name an object; without it by its name, or kind and number.
  void set_namer(std::function<std::string(scene::ObjectId)> namer);
  /// How tooltips name a point of a path.
  void set_point_namer(std::function<std::string(const picture::PathPointId&)> namer);
  /// What is under the pointer: a point of the ground, or of an object.
  void set_earth(std::optional<radar::EarthFrame> earth);

  /// Shows all of the snapshot.
  void fit();
  /// Looks from another side at the same focus.
  void look(picture::ViewPreset view);
  /// Fills the picture with some objects (`picture::showing`).
  void show_objects(const std::set<scene::ObjectId>& objects);
  /// Times `factor` about the middle.
  void zoom(double factor);
  /// Device pixels per pixel of the screen.
  [[nodiscard]] double pixel_scale() const { return options_.pixel_scale; }

  [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

 signals:
  void frame_wanted();   ///< What is selected is to fill the picture.
  void beam_wanted();    ///< The view along a beam is wanted.
  void follow_wanted();  ///< The view is to go with what is selected, or to stay.
  /// The pointer is over a point of the world: of an object, of a path, or else of the ground. Nothing where it is over
  /// neither, or has left.
  void pointed_at(std::optional<sarsim::core::Vec3> world_m);
  void hovered(std::optional<sarsim::scene::ObjectId> id);  ///< What the pointer is over.
  void camera_changed();                                    ///< The scene is seen from elsewhere.

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

  /// Whether a hand holds something: what is hovered then stays, and changes are painted at once.
  [[nodiscard]] virtual bool is_held() const { return false; }
  /// Whether it moves something: it is drawn with less detail.
  [[nodiscard]] virtual bool is_dragging() const { return false; }

  [[nodiscard]] QPointF device_point(const QPointF& logical) const { return logical * options_.pixel_scale; }
  /// What stands at a place of the picture.
  /// @{
  [[nodiscard]] std::optional<scene::ObjectId> picked_at(const QPointF& at_px);
  [[nodiscard]] std::optional<picture::PathPointId> path_point_at(const QPointF& at_px);
  [[nodiscard]] std::optional<core::Vec3> place_at(const QPointF& at_px);
  /// @}
  [[nodiscard]] std::optional<core::Vec3> place_of_point(const picture::PathPointId& point) const;
  [[nodiscard]] QString name_of_object(scene::ObjectId id) const;
  void set_hovered(std::optional<scene::ObjectId> id);
  void set_hovered_point(std::optional<picture::PathPointId> point);
  void set_hovered_handle(std::optional<picture::GizmoHandle> handle);
  void tell_place(const QPointF& at_px);
  /// Turns, pans or zooms by a key, or asks for a view; false for another key.
  bool camera_key(const QKeyEvent& event);
  void change_camera(const picture::Camera& camera);
  void redraw();

  picture::Snapshot snapshot_;
  picture::Camera camera_ = picture::Camera::start(640.0, 480.0);
  picture::DrawingOptions options_;
  std::optional<radar::EarthFrame> earth_;

 private:
  void follow_size();
  void refresh_drawing(bool dragging);

  std::function<std::string(scene::ObjectId)> namer_;
  std::function<std::string(const picture::PathPointId&)> point_namer_;
  bool dark_ = false;
  bool perspective_ = false;  // of all views but those of `ride`
  picture::Drawing drawing_;
  QTimer debounce_;              // begins to paint
  bool drawn_ = false;           // `drawing_` shows the present state
  bool drawn_dragging_ = false;  // ... as it is while the hand moves, with less detail
  ScenePainter painter_;
};

}  // namespace sarsim::gui
