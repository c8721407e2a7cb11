#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>

#include "core/text/number_text.hpp"
#include "gui/scene/scene_widget.hpp"
#include "picture/figure/ticks.hpp"
#include "picture/scene/ground_point.hpp"

namespace sarsim::gui {

namespace {

constexpr double reach_px = 6.0;          // of the mouse, on the screen
constexpr double zoom_decade_px = 200.0;  // a right drag of this length zooms ten times
constexpr double wheel_decade = 1200.0;   // eighths of a degree of the wheel: ten notches zoom ten times
constexpr double key_zoom = 1.25;
constexpr double key_turn_px = 20.0;  // five degrees of azimuth
constexpr double key_pan_px = 40.0;

}  // namespace

std::optional<scene::ObjectId> SceneWidget::picked_at(const QPointF& at_px) {
  refresh_drawing(false);
  return picture::picked(drawing_, snapshot_, camera_, at_px.x(), at_px.y(), reach_px * options_.pixel_scale);
}

std::optional<picture::PathPointId> SceneWidget::path_point_at(const QPointF& at_px) {
  refresh_drawing(false);
  return picture::picked_path_point(drawing_, at_px.x(), at_px.y(), reach_px * options_.pixel_scale);
}

// Targets and platforms; the world itself only where it was selected before.
bool SceneWidget::movable(scene::ObjectId id) const {
  if (id.kind == scene::ObjectKind::target) return true;
  if (id.kind != scene::ObjectKind::platform) return false;
  return options_.selected.contains(id) || !core::equal_ignoring_case(name_of_object(id).toStdString(), "Earth");
}

// --- Mouse ----------------------------------------------------------------------------------------------------------

void SceneWidget::mousePressEvent(QMouseEvent* event) {
  if (in_hand() && press_.button == Qt::NoButton) {  // A grab, which a click ends.
    event->button() == Qt::LeftButton ? end_gesture() : take_gesture_back();
    return;
  }
  if (press_.gesture != Gesture::none) {
    if (event->button() != press_.button) return;
    end_gesture();  // Its release went elsewhere.
  }
  press_ = {};
  press_.button = event->button();
  press_.gesture = Gesture::pressed;
  press_.at_px = device_point(event->position());
  press_.camera = camera_;
  pointer_px_ = press_.at_px;
  press_.point = path_point_at(press_.at_px);
  if (press_.button == Qt::LeftButton && options_.ruler && !ruler_open_)
    press_.ruler_end = picture::ruler_end_at(*options_.ruler, camera_, press_.at_px.x(), press_.at_px.y(),
                                             reach_px * options_.pixel_scale);
  // Rings are large and pass over the points of paths.
  if (press_.button == Qt::LeftButton && !press_.point) press_.handle = handle_at(press_.at_px);
  press_.on = press_.point ? press_.point->platform : picked_at(press_.at_px);
  if (press_.point)
    press_.object_world_m = place_of_point(*press_.point).value_or(core::Vec3{});
  else if (press_.on)
    press_.object_world_m = picture::place_of(snapshot_, *press_.on).value_or(core::Vec3{});
  QToolTip::hideText();
}

SceneWidget::Gesture SceneWidget::gesture_of(Qt::KeyboardModifiers modifiers) const {
  switch (press_.button) {
    case Qt::LeftButton:
      if (press_.ruler_end) return Gesture::measure;
      if (tool_ == Tool::ruler || (tool_ == Tool::path && !press_.point)) return Gesture::turn;
      if (press_.handle)
        return press_.handle->kind == picture::GizmoHandle::Kind::ring ? Gesture::rotate : Gesture::move;
      if (press_.point || (press_.on && movable(*press_.on))) return Gesture::move;
      return modifiers.testFlag(Qt::ShiftModifier) ? Gesture::pan : Gesture::turn;
    case Qt::MiddleButton: return Gesture::pan;
    case Qt::RightButton: return Gesture::zoom;
    default: return Gesture::none;
  }
}

void SceneWidget::begin_gesture(Qt::KeyboardModifiers modifiers) {
  press_.gesture = gesture_of(modifiers);
  if (in_hand() && press_.handle && !hold_subject()) press_.gesture = Gesture::none;
  if (in_hand()) begin_hand();
}

void SceneWidget::follow_gesture(const QPointF& at_px, Qt::KeyboardModifiers modifiers) {
  const QPointF step = at_px - press_.at_px;
  switch (press_.gesture) {
    case Gesture::turn: change_camera(picture::turned(press_.camera, step.x(), step.y(), options_.pixel_scale)); break;
    case Gesture::pan: change_camera(picture::panned(press_.camera, step.x(), step.y())); break;
    case Gesture::zoom: {
      const double factor = std::pow(10.0, -step.y() / (zoom_decade_px * options_.pixel_scale));
      change_camera(picture::zoomed(press_.camera, factor, 0.5 * camera_.width_px, 0.5 * camera_.height_px));
      break;
    }
    case Gesture::move:
    case Gesture::rotate:
      pointer_px_ = at_px;
      snap_ = modifiers.testFlag(Qt::ShiftModifier);
      follow_hand();
      break;
    case Gesture::measure: move_ruler_end(*press_.ruler_end, at_px); break;
    case Gesture::none:
    case Gesture::pressed: break;
  }
}

// Leaves everything as the gesture made it.
void SceneWidget::end_gesture() {
  const bool held = in_hand();
  press_.gesture = Gesture::none;
  if (held) {
    end_hand();
    emit drag_ended();
  }
  redraw();  // With all detail again.
}

void SceneWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at_px = device_point(event->position());
  // A dialog or another window may have taken the release.
  const bool holds = press_.button != Qt::NoButton;
  if (press_.gesture != Gesture::none && holds && !event->buttons().testFlag(press_.button)) end_gesture();
  if (press_.gesture == Gesture::none) {
    pointer_px_ = at_px;
    const auto point = path_point_at(at_px);
    set_hovered_handle(point ? std::nullopt : handle_at(at_px));
    set_hovered_point(point);
    set_hovered(options_.hovered_handle || options_.hovered_point ? std::nullopt : picked_at(at_px));
    tell_place(at_px);
    tool_hover(at_px);
    return;
  }
  const double drag_px = QApplication::startDragDistance() * options_.pixel_scale;
  if (press_.gesture == Gesture::pressed && (at_px - press_.at_px).manhattanLength() >= drag_px)
    begin_gesture(event->modifiers());
  follow_gesture(at_px, event->modifiers());
}

void SceneWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != press_.button || press_.gesture == Gesture::none) return;
  const bool clicked = press_.gesture == Gesture::pressed;
  end_gesture();
  if (clicked) click(event->modifiers(), event->globalPosition().toPoint());
}

void SceneWidget::click(Qt::KeyboardModifiers modifiers, QPoint global) {
  if (press_.button == Qt::RightButton) emit menu_requested(press_.on, global);
  if (press_.button != Qt::LeftButton || tool_click(press_.at_px)) return;
  if (press_.point && !modifiers.testFlag(Qt::ControlModifier))
    emit point_clicked(*press_.point);
  else if (press_.on)
    emit selection_clicked(*press_.on, modifiers.testFlag(Qt::ControlModifier));
  else if (!path_under_pointer())  // A double click on a path puts a point there.
    emit empty_clicked();
}

void SceneWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  press_.gesture = Gesture::none;  // The release that follows is no click.
  if (event->button() != Qt::LeftButton) return;
  const QPointF at_px = device_point(event->position());
  pointer_px_ = at_px;
  if (tool_ != Tool::hand) return;
  if (const auto id = picked_at(at_px))
    emit edit_requested(*id);
  else if (const auto place = path_under_pointer())
    emit path_divided(*place);
}

void SceneWidget::wheelEvent(QWheelEvent* event) {
  const QPointF at_px = device_point(event->position());
  if (event->angleDelta().y() != 0 && press_.gesture == Gesture::none)
    change_camera(
        picture::zoomed(camera_, std::pow(10.0, event->angleDelta().y() / wheel_decade), at_px.x(), at_px.y()));
  event->accept();
}

void SceneWidget::leaveEvent(QEvent*) {
  if (press_.gesture != Gesture::none) return;
  set_hovered(std::nullopt);
  set_hovered_point(std::nullopt);
  set_hovered_handle(std::nullopt);
  emit pointed_at(std::nullopt);
}

void SceneWidget::tell_place(const QPointF& at_px) {
  if (options_.hovered_point)
    emit pointed_at(place_of_point(*options_.hovered_point));
  else if (options_.hovered && picture::place_of(snapshot_, *options_.hovered))
    emit pointed_at(picture::place_of(snapshot_, *options_.hovered));
  else
    emit pointed_at(picture::ground_under(camera_, at_px.x(), at_px.y(), earth_));
}

void SceneWidget::take_gesture_back() {
  const Gesture gesture = press_.gesture;
  press_.gesture = Gesture::none;
  if (gesture == Gesture::move || gesture == Gesture::rotate) {
    emit drag_taken_back();
    gesture == Gesture::move ? move_object({}) : turn_object(0.0);
    end_hand();
    emit drag_ended();
  } else if (gesture != Gesture::pressed) {
    change_camera(press_.camera);
  }
  redraw();
}

// --- Keys -----------------------------------------------------------------------------------------------------------

void SceneWidget::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && press_.gesture != Gesture::none)
    take_gesture_back();
  else if (in_hand() && hand_key(*event))
    return;
  else if (press_.gesture == Gesture::none && tool_key(*event))
    return;
  else if (press_.gesture != Gesture::none || (!camera_key(*event) && !object_key(*event)))
    QWidget::keyPressEvent(event);
}

void SceneWidget::keyReleaseEvent(QKeyEvent* event) {
  if (in_hand() && event->key() == Qt::Key_Shift) hand_key(*event);
  QWidget::keyReleaseEvent(event);
}

bool SceneWidget::knows_key(const QKeyEvent& event) const {
  const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (in_hand() && plain) return true;  // All of them: what is typed is a number.
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down: return !event.modifiers().testFlag(Qt::ControlModifier);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_Home: return true;
    case Qt::Key_1:
    case Qt::Key_2:
    case Qt::Key_3: return plain;
    case Qt::Key_4:
    case Qt::Key_5:
    case Qt::Key_F:
    case Qt::Key_Period:
    case Qt::Key_M:
    case Qt::Key_P:
    case Qt::Key_G:
    case Qt::Key_R:
    case Qt::Key_L: return plain && event.modifiers() != Qt::ShiftModifier;
    case Qt::Key_Escape: return press_.gesture != Gesture::none || tool_ != Tool::hand;
    default: return false;
  }
}

bool SceneWidget::camera_key(const QKeyEvent& event) {
  const auto arrow = [&](double x, double y) {
    const double scale = options_.pixel_scale;
    if (event.modifiers().testFlag(Qt::ShiftModifier))
      change_camera(picture::panned(camera_, key_pan_px * scale * x, key_pan_px * scale * y));
    else
      change_camera(picture::turned(camera_, key_turn_px * x, 0.5 * key_turn_px * y));
    return true;
  };
  if (!knows_key(event)) return false;
  switch (event.key()) {
    case Qt::Key_Left: return arrow(-1.0, 0.0);
    case Qt::Key_Right: return arrow(1.0, 0.0);
    case Qt::Key_Up: return arrow(0.0, -1.0);
    case Qt::Key_Down: return arrow(0.0, 1.0);
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoom(key_zoom); return true;
    case Qt::Key_Minus: zoom(1.0 / key_zoom); return true;
    case Qt::Key_Home: fit(); return true;
    case Qt::Key_1: look(picture::ViewPreset::top); return true;
    case Qt::Key_2: look(picture::ViewPreset::front); return true;
    case Qt::Key_3: look(picture::ViewPreset::side); return true;
    case Qt::Key_4: emit beam_wanted(); return true;
    case Qt::Key_5: emit follow_wanted(); return true;
    case Qt::Key_F:
    case Qt::Key_Period: emit frame_wanted(); return true;
    default: return false;
  }
}

bool SceneWidget::object_key(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (options_.selected.size() != 1) return false;
      emit edit_requested(*options_.selected.begin());
      return true;
    case Qt::Key_G: return knows_key(event) && move_selected();
    case Qt::Key_R: return knows_key(event) && turn_selected();
    case Qt::Key_L:
      if (!knows_key(event)) return false;
      emit own_axes_wanted();
      return true;
    case Qt::Key_Delete:
      if (options_.selected_point) {
        emit point_delete_wanted(*options_.selected_point);
        return true;
      }
      if (options_.selected.empty()) return false;
      emit delete_wanted();
      return true;
    case Qt::Key_Menu: ask_for_menu_by_key(); return true;
    case Qt::Key_F10:
      if (!event.modifiers().testFlag(Qt::ShiftModifier)) return false;
      ask_for_menu_by_key();
      return true;
    default: return false;
  }
}

void SceneWidget::ask_for_menu_by_key() {
  std::optional<scene::ObjectId> id;
  QPointF at = QRectF(rect()).center();
  if (options_.selected.size() == 1) {
    id = *options_.selected.begin();
    const auto position = picture::place_of(snapshot_, *id);
    const auto point = position ? camera_.project(*position) : std::nullopt;
    const QPointF there = point ? QPointF(point->x, point->y) / options_.pixel_scale : at;
    if (rect().contains(there.toPoint())) at = there;
  }
  emit menu_requested(id, mapToGlobal(at.toPoint()));
}

}  // namespace sarsim::gui
