// What is moved and turned in the scene: by dragging it, by its handles, by keys.

#include <QKeyEvent>
#include <QLabel>

#include <algorithm>
#include <array>
#include <utility>

#include "gui/scene/scene_widget.hpp"

namespace sarsim::gui {

namespace {

constexpr int words_away_px = 18;  // of the label from the pointer

}  // namespace

void SceneWidget::set_handles(std::optional<picture::Handles> handles) {
  handles_ = std::move(handles);
  options_.gizmo = handles_ ? std::optional(handles_->gizmo) : std::nullopt;
  if (!handles_ && !in_hand()) options_.hovered_handle.reset();
  redraw();
}

std::optional<picture::GizmoHandle> SceneWidget::handle_at(const QPointF& at_px) const {
  if (!handles_) return std::nullopt;
  return picture::gizmo_handle_at(handles_->gizmo, camera_, options_.pixel_scale, at_px.x(), at_px.y());
}

void SceneWidget::set_hovered_handle(std::optional<picture::GizmoHandle> handle) {
  if (options_.hovered_handle == handle) return;
  options_.hovered_handle = handle;
  redraw();
}

// What the handles belong to: the selected point of a path, or the only selected object.
bool SceneWidget::hold_subject() {
  if (!handles_) return false;
  press_.point = options_.selected_point;
  press_.on = press_.point                    ? std::optional(press_.point->platform)
              : options_.selected.size() == 1 ? std::optional(*options_.selected.begin())
                                              : std::nullopt;
  press_.object_world_m = handles_->gizmo.place_world_m;
  return press_.on.has_value();
}

void SceneWidget::begin_hand() {
  hand_ = {};
  hand_.camera = press_.camera;
  hand_.x_px = press_.at_px.x();
  hand_.y_px = press_.at_px.y();
  hand_.pixel_scale = options_.pixel_scale;
  hand_.place_world_m = press_.object_world_m;
  if (press_.point) {
    set_hovered_point(press_.point);
    emit path_drag_started(*press_.point);
  } else {
    set_hovered(press_.on);
    emit drag_started(*press_.on);
  }
  // Its owner may have selected it and given it handles.
  if (handles_) hand_.axes_world = handles_->gizmo.axes_world;
  options_.hovered_handle = press_.handle;
  if (press_.gesture == Gesture::rotate) press_.angle_rad = handles_->angles[press_.handle->index].rad;
  if (!press_.handle || press_.handle->kind == picture::GizmoHandle::Kind::ring) return;
  const bool along = press_.handle->kind == picture::GizmoHandle::Kind::arrow;
  hand_.lock = {along ? picture::HandLock::Kind::axis : picture::HandLock::Kind::plane, press_.handle->index};
  show_guide();
}

void SceneWidget::end_hand() {
  options_.guide.reset();
  options_.hovered_handle.reset();
  hand_.typed.clear();
  hand_words_->hide();
}

void SceneWidget::follow_hand() {
  if (press_.gesture == Gesture::move) {
    const picture::HandMove move = picture::hand_move(hand_, pointer_px_.x(), pointer_px_.y(), snap_);
    move_object(move);
  } else if (handles_ && press_.handle && press_.handle->index < handles_->gizmo.rings.size()) {
    const picture::Gizmo::Ring& ring = handles_->gizmo.rings[press_.handle->index];
    turn_object(picture::hand_turn(hand_, ring.axis_world, press_.angle_rad, pointer_px_.x(), pointer_px_.y(), snap_));
  }
  redraw();
}

void SceneWidget::move_object(const picture::HandMove& move) {
  if (press_.point)
    emit path_dragged_to(*press_.point, move.delta_world_m, move.resolution_m);
  else
    emit dragged_to(*press_.on, move.delta_world_m);
  const core::Vec3 wanted = press_.object_world_m + move.delta_world_m;
  const core::Vec3 now = press_.point ? place_of_point(*press_.point).value_or(wanted)
                                      : picture::place_of(snapshot_, *press_.on).value_or(wanted);
  emit pointed_at(now);
  const bool stuck = !press_.point && now == press_.object_world_m && move.delta_world_m != core::Vec3{} &&
                     press_.on->kind == scene::ObjectKind::platform;
  if (in_hand())
    show_hand_words(stuck ? tr("%1 stays on its path").arg(name_of_object(*press_.on))
                          : QString::fromStdString(picture::move_words(hand_, move, now)));
}

void SceneWidget::turn_object(double by_rad) {
  const std::size_t ring = press_.handle->index;
  emit turned_to(*press_.on, ring, by_rad);
  if (in_hand() && handles_ && ring < handles_->angles.size())
    show_hand_words(
        QString::fromStdString(picture::turn_words(hand_, handles_->angles[ring].name, press_.angle_rad, by_rad)));
}

void SceneWidget::show_guide() {
  options_.guide.reset();
  constexpr std::array roles{picture::Role::x_axis, picture::Role::y_axis, picture::Role::z_axis};
  if (hand_.lock.kind == picture::HandLock::Kind::axis)
    options_.guide = {press_.object_world_m, hand_.axes_world[hand_.lock.axis], roles[hand_.lock.axis]};
}

void SceneWidget::show_hand_words(const QString& words) {
  hand_words_->setText(words);
  hand_words_->adjustSize();
  place_hand_words();
  hand_words_->show();
}

// Beside the pointer, within the picture.
void SceneWidget::place_hand_words() {
  const QPoint at = (pointer_px_ / options_.pixel_scale).toPoint();
  int x = at.x() + words_away_px;
  int y = at.y() + words_away_px;
  if (x + hand_words_->width() > width()) x = at.x() - words_away_px - hand_words_->width();
  if (y + hand_words_->height() > height()) y = at.y() - words_away_px - hand_words_->height();
  hand_words_->move(std::max(0, x), std::max(0, y));
}

// --- Keys -----------------------------------------------------------------------------------------------------------

bool SceneWidget::begin_grab(Gesture gesture) {
  if (press_.gesture != Gesture::none || !hold_subject()) return false;
  press_.button = Qt::NoButton;
  press_.camera = camera_;
  press_.at_px = pointer_px_;
  if (!rect().contains((press_.at_px / options_.pixel_scale).toPoint()))
    press_.at_px = device_point(QRectF(rect()).center());
  pointer_px_ = press_.at_px;
  press_.handle.reset();
  if (gesture == Gesture::rotate)
    press_.handle = picture::GizmoHandle{picture::GizmoHandle::Kind::ring, handles_->gizmo.rings.size() - 1};
  press_.gesture = gesture;
  snap_ = false;
  begin_hand();
  follow_hand();
  return true;
}

bool SceneWidget::move_selected() { return handles_ && handles_->gizmo.moves && begin_grab(Gesture::move); }

bool SceneWidget::turn_selected() { return handles_ && !handles_->gizmo.rings.empty() && begin_grab(Gesture::rotate); }

// The same key again frees it.
void SceneWidget::lock_axis(std::size_t axis) {
  if (press_.gesture == Gesture::rotate) {
    // The ring about that axis, where rings come in the order of the axes.
    if (!handles_ || handles_->gizmo.rings.size() != 3) return;
    turn_object(0.0);
    press_.handle->index = axis;
    press_.angle_rad = handles_->angles[axis].rad;
    options_.hovered_handle = press_.handle;
    return;
  }
  const picture::HandLock lock{picture::HandLock::Kind::axis, axis};
  hand_.lock = hand_.lock == lock ? picture::HandLock{} : lock;
  if (hand_.lock.kind == picture::HandLock::Kind::level) hand_.typed.clear();
  options_.hovered_handle.reset();
  show_guide();
}

void SceneWidget::type(const QKeyEvent& event) {
  const bool starts = hand_.typed.empty();
  if (event.key() == Qt::Key_Backspace) {
    if (!starts) hand_.typed.pop_back();
    return;
  }
  const QString text = event.text();
  if (text.size() != 1 || text[0].unicode() < ' ' || text[0].unicode() > '~') return;
  const QChar letter = text[0];
  if (starts && !letter.isDigit() && letter != '.' && letter != '-') return;
  if (starts && press_.gesture == Gesture::move && hand_.lock.kind != picture::HandLock::Kind::axis) {
    // Along the axis on which it has gone farthest.
    const auto move = picture::hand_move(hand_, pointer_px_.x(), pointer_px_.y(), false);
    lock_axis(picture::main_axis(hand_, move.delta_world_m));
  }
  hand_.typed += letter.toLatin1();
}

bool SceneWidget::hand_key(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  snap_ =
      event.key() == Qt::Key_Shift ? event.type() == QEvent::KeyPress : event.modifiers().testFlag(Qt::ShiftModifier);
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter: end_gesture(); return true;
    case Qt::Key_X: lock_axis(0); break;
    case Qt::Key_Y: lock_axis(1); break;
    case Qt::Key_Z: lock_axis(2); break;
    default: type(event); break;
  }
  follow_hand();
  return true;
}

}  // namespace sarsim::gui
