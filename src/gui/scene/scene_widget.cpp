#include "gui/scene/scene_widget.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/text/number_text.hpp"
#include "picture/figure/ticks.hpp"
#include "picture/scene/ground_point.hpp"

namespace sarsim::gui {

namespace {

constexpr double reach_px = 6.0;          // of the mouse, on the screen: ends of the ruler and lines of paths
constexpr double zoom_decade_px = 200.0;  // a right drag of this length zooms ten times
constexpr int words_away_px = 18;         // of the label from the pointer

}  // namespace

SceneWidget::SceneWidget(QWidget* parent) : ScenePicture(parent) {
  hand_words_ = new QLabel(this);
  hand_words_->setObjectName(QStringLiteral("hand_words"));
  hand_words_->setAccessibleName(tr("Where what is dragged is"));
  hand_words_->setAutoFillBackground(true);
  hand_words_->setFrameShape(QFrame::Box);
  hand_words_->setMargin(3);
  hand_words_->setAttribute(Qt::WA_TransparentForMouseEvents);
  hand_words_->hide();
}

bool SceneWidget::event(QEvent* event) {
  // Keys that this widget knows are its own, also where a menu has a shortcut for them.
  if (event->type() == QEvent::ShortcutOverride && knows_key(dynamic_cast<const QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  return ScenePicture::event(event);
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

void SceneWidget::leaveEvent(QEvent*) {
  if (press_.gesture != Gesture::none) return;
  set_hovered(std::nullopt);
  set_hovered_point(std::nullopt);
  set_hovered_handle(std::nullopt);
  emit pointed_at(std::nullopt);
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
  else if (press_.gesture != Gesture::none || (!(knows_key(*event) && camera_key(*event)) && !object_key(*event)))
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

// --- What is moved and turned in the scene: by dragging it, by its handles, by keys

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

// --- What clicks do besides selecting: the ruler, and points behind a path

void SceneWidget::set_tool(Tool tool) {
  if (tool == tool_) return;
  tool_ = tool;
  ruler_open_ = false;
  set_ruler(std::nullopt);
  setCursor(tool == Tool::hand ? Qt::ArrowCursor : Qt::CrossCursor);
  emit tool_changed(tool);
}

void SceneWidget::set_path_end(std::optional<core::Vec3> world_m) {
  path_end_m_ = world_m;
  if (tool_ == Tool::path) set_ruler(std::nullopt);
}

void SceneWidget::set_ruler(std::optional<picture::Ruler> ruler) {
  options_.ruler = ruler;
  options_.ruler_words.clear();
  if (ruler) options_.ruler_words = picture::ruler_words(picture::measured(*ruler, earth_));
  redraw();
}

// On the level where the path ends; over an Earth at the height of its end.
std::optional<core::Vec3> SceneWidget::path_place_at(const QPointF& at_px) const {
  if (!path_end_m_) return std::nullopt;
  const auto level = picture::level_under(camera_, at_px.x(), at_px.y(), *path_end_m_);
  if (!level || !earth_) return level;
  radar::Geodetic place = earth_->geodetic_of(*level);
  place.height_m = earth_->geodetic_of(*path_end_m_).height_m;
  return earth_->world_of(place);
}

std::optional<picture::PathPlace> SceneWidget::path_under_pointer() const {
  return picture::picked_path_place(snapshot_, options_, camera_, pointer_px_.x(), pointer_px_.y(),
                                    reach_px * options_.pixel_scale);
}

void SceneWidget::move_ruler_end(int end, const QPointF& at_px) {
  const auto place = place_at(at_px);
  if (!place || !options_.ruler) return;
  picture::Ruler ruler = *options_.ruler;
  (end == 0 ? ruler.from_world_m : ruler.to_world_m) = *place;
  set_ruler(ruler);
}

// True where the click was the tool's.
bool SceneWidget::tool_click(const QPointF& at_px) {
  if (tool_ == Tool::path) {
    if (const auto place = path_place_at(at_px)) emit path_place_wanted(*place);
    return true;
  }
  if (tool_ != Tool::ruler) return false;
  if (ruler_open_) {
    move_ruler_end(1, at_px);
    ruler_open_ = false;
  } else if (const auto place = place_at(at_px)) {
    set_ruler(picture::Ruler{*place, *place});
    ruler_open_ = true;
  }
  return true;
}

void SceneWidget::tool_hover(const QPointF& at_px) {
  if (tool_ == Tool::ruler && ruler_open_) move_ruler_end(1, at_px);
  if (tool_ != Tool::path || !path_end_m_) return;
  const auto place = path_place_at(at_px);
  set_ruler(place ? std::optional(picture::Ruler{*path_end_m_, *place}) : std::nullopt);
  if (place) emit pointed_at(place);
}

// Escape, and for a path Enter, end the tool; its key begins and ends it.
bool SceneWidget::tool_key(const QKeyEvent& event) {
  const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
  if (tool_ != Tool::hand && (event.key() == Qt::Key_Escape || (enter && tool_ == Tool::path))) {
    set_tool(Tool::hand);
    return true;
  }
  if (!knows_key(event)) return false;
  if (event.key() == Qt::Key_M) {
    set_tool(tool_ == Tool::ruler ? Tool::hand : Tool::ruler);
    return true;
  }
  if (event.key() != Qt::Key_P) return false;
  set_tool(tool_ == Tool::path ? Tool::hand : Tool::path);
  return true;
}

}  // namespace sarsim::gui
