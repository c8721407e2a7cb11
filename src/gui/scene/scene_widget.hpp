#pragma once

#include <QPoint>
#include <QPointF>

#include <optional>
#include <string>

#include "gui/scene/scene_picture.hpp"
#include "picture/scene/hand_drag.hpp"
#include "picture/scene/handles.hpp"

class QLabel;

namespace sarsim::gui {

/// The scene in three dimensions ("scene_view"). It turns gestures into signals; edits, selection and menus are the
/// owner's.
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
class SceneWidget : public ScenePicture {
  Q_OBJECT

 public:
  explicit SceneWidget(QWidget* parent = nullptr);

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
  void own_axes_wanted();                                        ///< The handles are to take the other axes.
  void path_drag_started(sarsim::picture::PathPointId point);    ///< What follows moves this point.
  /// All the way from where the point was when the drag started, rounded to `resolution_m`.
  void path_dragged_to(sarsim::picture::PathPointId point, sarsim::core::Vec3 delta_world_m, double resolution_m);
  void drag_taken_back();  ///< What is dragged is to be as it was; `drag_ended` follows.
  void drag_ended();       ///< The object, or point, stays where it is.

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  [[nodiscard]] bool is_held() const override { return press_.gesture != Gesture::none; }
  [[nodiscard]] bool is_dragging() const override { return is_held() && press_.gesture != Gesture::pressed; }

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

  [[nodiscard]] bool movable(scene::ObjectId id) const;
  void move_object(const picture::HandMove& move);
  void turn_object(double by_rad);
  [[nodiscard]] bool in_hand() const { return press_.gesture == Gesture::move || press_.gesture == Gesture::rotate; }
  [[nodiscard]] std::optional<picture::GizmoHandle> handle_at(const QPointF& at_px) const;
  bool hold_subject();
  void begin_hand();
  void follow_hand();
  void end_hand();
  bool begin_grab(Gesture gesture);
  bool hand_key(const QKeyEvent& event);
  void lock_axis(std::size_t axis);
  void type(const QKeyEvent& event);
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
  void begin_gesture(Qt::KeyboardModifiers modifiers);
  void follow_gesture(const QPointF& at_px, Qt::KeyboardModifiers modifiers);
  void end_gesture();
  void take_gesture_back();
  void click(Qt::KeyboardModifiers modifiers, QPoint global);
  [[nodiscard]] bool knows_key(const QKeyEvent& event) const;
  bool object_key(const QKeyEvent& event);
  void ask_for_menu_by_key();

  Press press_;
  std::optional<picture::Handles> handles_;
  picture::HandDrag hand_;
  Tool tool_ = Tool::hand;
  bool ruler_open_ = false;               // its second end follows the pointer
  std::optional<core::Vec3> path_end_m_;  // of Tool::path
  QPointF pointer_px_;                    // where the pointer was last
  bool snap_ = false;
  QLabel* hand_words_ = nullptr;
};

}  // namespace sarsim::gui
