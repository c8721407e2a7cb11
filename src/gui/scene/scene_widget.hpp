#pragma once

#include <QPoint>
#include <QPointF>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gui/scene/scene_painter.hpp"
#include "picture/scene/camera.hpp"
#include "picture/scene/drawing.hpp"
#include "picture/scene/hand_drag.hpp"
#include "picture/scene/handles.hpp"
#include "picture/scene/snapshot.hpp"
#include "radar/earth/earth_frame.hpp"

class QLabel;

namespace sarsim::gui {

/// The scene in three dimensions ("scene_view"). It shows a snapshot and turns gestures into signals; edits, selection
/// and menus are the owner's.
///
/// Mouse: left drag turns, on a target, platform or point of a selected platform's path moves it on its level
/// (`picture::hand_move`), on a handle of what is selected moves or turns that; middle drag, or Shift and left drag on
/// empty space, pans; right drag zooms ten times per 200 px upwards; the wheel zooms at the cursor. Left click selects,
/// with Ctrl adds; double click edits; right click asks for a menu.
/// While something is moved or turned: Shift rounds; X, Y and Z lock an axis, again: free it; what is typed is the
/// distance along it, or the angle; Enter leaves it there, Escape takes it back. A label at the pointer says where it
/// is.
/// Keys: arrows turn, with Shift pan; + and - zoom, Home fits, F and . show what is selected; 1, 2 and 3 look from
/// above, the front, the side, 4 along a beam, 5 follows what is selected; M measures and P
/// draws a path, until Escape; G moves what is selected with the pointer, R
/// turns it, L changes the axes of its handles; Enter edits and the menu key asks for the menu of the only selected
/// object; Delete asks that the selected ones be deleted.
class SceneWidget : public QWidget {
  Q_OBJECT

 public:
  explicit SceneWidget(QWidget* parent = nullptr);

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

  /// Handles at what is selected; nothing: none.
  void set_handles(std::optional<picture::Handles> handles);
  [[nodiscard]] const std::optional<picture::Handles>& handles() const { return handles_; }
  /// Moves what is selected with the pointer, no button held, until a click or Enter; false where it has no arrows.
  bool move_selected();
  /// Turns it in the same way, about the last of its rings; false where it has none.
  bool turn_selected();
  /// What clicks and drags do: move things, measure between two places, put points behind a path.
  enum class Tool { hand, ruler, path };
  /// Another tool than the ruler takes the ruler away.
  void set_tool(Tool tool);
  [[nodiscard]] Tool tool() const { return tool_; }
  /// The path that Tool::path goes on with: from this place.
  void set_path_end(std::optional<core::Vec3> world_m);
  /// The line of a selected path under the pointer.
  [[nodiscard]] std::optional<picture::PathPlace> path_under_pointer() const;
  /// What a drag is doing, for those who show it.
  [[nodiscard]] const picture::HandDrag& hand() const { return hand_; }

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
  void selection_clicked(sarsim::scene::ObjectId id, bool add);  ///< An object was clicked; with Ctrl `add`.
  void empty_clicked();                                          ///< Nothing stands where the click was.
  void edit_requested(sarsim::scene::ObjectId id);               ///< A double click, or Enter.
  /// At a place of the screen; nothing: empty space.
  void menu_requested(std::optional<sarsim::scene::ObjectId> id, QPoint global);
  void delete_wanted();                           ///< The selected objects, of which there are some, are to go.
  void drag_started(sarsim::scene::ObjectId id);  ///< What follows moves this object.
  /// All the way from where the object was when the drag started.
  void dragged_to(sarsim::scene::ObjectId id, sarsim::core::Vec3 delta_world_m);
  /// The angle of a ring of the handles is changed by so much since the drag started.
  void turned_to(sarsim::scene::ObjectId id, std::size_t ring, double by_rad);
  void point_clicked(sarsim::picture::PathPointId point);        ///< A point of a path was clicked.
  void point_delete_wanted(sarsim::picture::PathPointId point);  ///< The selected point is to go.
  void tool_changed(sarsim::gui::SceneWidget::Tool tool);        ///< Clicks do something else.
  void path_place_wanted(sarsim::core::Vec3 world_m);            ///< Tool::path clicked there, on the level of its end.
  void path_divided(sarsim::picture::PathPlace place);           ///< A double click on the line of a path.
  void frame_wanted();                                           ///< What is selected is to fill the picture.
  void beam_wanted();                                            ///< The view along a beam is wanted.
  void follow_wanted();                                        ///< The view is to go with what is selected, or to stay.
  void own_axes_wanted();                                      ///< The handles are to take the other axes.
  void path_drag_started(sarsim::picture::PathPointId point);  ///< What follows moves this point.
  /// All the way from where the point was when the drag started, rounded to `resolution_m`.
  void path_dragged_to(sarsim::picture::PathPointId point, sarsim::core::Vec3 delta_world_m, double resolution_m);
  void drag_taken_back();  ///< What is dragged is to be as it was; `drag_ended` follows.
  void drag_ended();       ///< The object, or point, stays where it is.
  /// The pointer is over a point of the world: of an object, of a path, or else of the ground. Nothing where it is over
  /// neither, or has left.
  void pointed_at(std::optional<sarsim::core::Vec3> world_m);
  void hovered(std::optional<sarsim::scene::ObjectId> id);  ///< What the pointer is over.
  void camera_changed();                                    ///< The scene is seen from elsewhere.

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  enum class Gesture { none, pressed, turn, pan, zoom, move, rotate, measure };

  // A mouse button that is held: where and on what it went down.
  struct Press {
    Qt::MouseButton button = Qt::NoButton;
    Gesture gesture = Gesture::none;
    QPointF at_px;
    picture::Camera camera;
    std::optional<scene::ObjectId> on;
    std::optional<picture::PathPointId> point;
    std::optional<picture::GizmoHandle> handle;
    std::optional<int> ruler_end;
    core::Vec3 object_world_m;
    double angle_rad = 0.0;  // that a ring changes, as it was
  };

  [[nodiscard]] QPointF device_point(const QPointF& logical) const { return logical * options_.pixel_scale; }
  [[nodiscard]] std::optional<scene::ObjectId> picked_at(const QPointF& at_px);
  [[nodiscard]] bool movable(scene::ObjectId id) const;
  [[nodiscard]] QString name_of_object(scene::ObjectId id) const;
  [[nodiscard]] std::optional<picture::PathPointId> path_point_at(const QPointF& at_px);
  [[nodiscard]] std::optional<core::Vec3> place_of_point(const picture::PathPointId& point) const;
  void set_hovered_point(std::optional<picture::PathPointId> point);
  void tell_place(const QPointF& at_px);
  void move_object(const picture::HandMove& move);
  void turn_object(double by_rad);
  [[nodiscard]] bool in_hand() const { return press_.gesture == Gesture::move || press_.gesture == Gesture::rotate; }
  [[nodiscard]] std::optional<picture::GizmoHandle> handle_at(const QPointF& at_px) const;
  void set_hovered_handle(std::optional<picture::GizmoHandle> handle);
  bool hold_subject();
  void begin_hand();
  void follow_hand();
  void end_hand();
  bool begin_grab(Gesture gesture);
  bool hand_key(const QKeyEvent& event);
  void lock_axis(std::size_t axis);
  void type(const QKeyEvent& event);
  [[nodiscard]] std::optional<core::Vec3> place_at(const QPointF& at_px);
  [[nodiscard]] std::optional<core::Vec3> path_place_at(const QPointF& at_px) const;
  void set_ruler(std::optional<picture::Ruler> ruler);
  void move_ruler_end(int end, const QPointF& at_px);
  bool tool_click(const QPointF& at_px);
  void tool_hover(const QPointF& at_px);
  bool tool_key(const QKeyEvent& event);
  void show_guide();
  void show_hand_words(const QString& words);
  void place_hand_words();
  [[nodiscard]] Gesture gesture_of(Qt::KeyboardModifiers modifiers) const;
  void follow_size();
  void change_camera(const picture::Camera& camera);
  void redraw();
  void refresh_drawing(bool dragging);
  void set_hovered(std::optional<scene::ObjectId> id);
  void begin_gesture(Qt::KeyboardModifiers modifiers);
  void follow_gesture(const QPointF& at_px, Qt::KeyboardModifiers modifiers);
  void end_gesture();
  void take_gesture_back();
  void click(Qt::KeyboardModifiers modifiers, QPoint global);
  [[nodiscard]] bool knows_key(const QKeyEvent& event) const;
  bool camera_key(const QKeyEvent& event);
  bool object_key(const QKeyEvent& event);
  void ask_for_menu_by_key();

  picture::Snapshot snapshot_;
  picture::Camera camera_ = picture::Camera::start(640.0, 480.0);
  picture::DrawingOptions options_;
  std::function<std::string(scene::ObjectId)> namer_;
  std::function<std::string(const picture::PathPointId&)> point_namer_;
  std::optional<radar::EarthFrame> earth_;
  bool dark_ = false;
  bool perspective_ = false;  // of all views but those of `ride`
  Press press_;
  std::optional<picture::Handles> handles_;
  picture::HandDrag hand_;
  Tool tool_ = Tool::hand;
  bool ruler_open_ = false;               // its second end follows the pointer
  std::optional<core::Vec3> path_end_m_;  // of Tool::path
  QPointF pointer_px_;                    // where the pointer was last
  bool snap_ = false;
  QLabel* hand_words_ = nullptr;
  picture::Drawing drawing_;
  QTimer debounce_;              // begins to paint
  bool drawn_ = false;           // `drawing_` shows the present state
  bool drawn_dragging_ = false;  // ... as it is while the hand moves, with less detail
  ScenePainter painter_;
};

}  // namespace sarsim::gui
