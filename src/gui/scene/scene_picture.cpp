#include "gui/scene/scene_picture.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "picture/scene/draw_scene.hpp"
#include "picture/scene/framing.hpp"
#include "picture/scene/ground_point.hpp"

namespace sarsim::gui {

namespace {

constexpr double pick_reach_px = 6.0;    // of the mouse, on the screen
constexpr double wheel_decade = 1200.0;  // eighths of a degree of the wheel: ten notches zoom ten times
constexpr double key_zoom = 1.25;
constexpr double key_turn_px = 20.0;  // five degrees of azimuth
constexpr double key_pan_px = 40.0;

template <class Objects>
auto* found_in(const Objects& objects, scene::ObjectId id) {
  const auto at = std::ranges::find(objects, id, [](const auto& object) { return object.id; });
  return at == objects.end() ? nullptr : &*at;
}

}  // namespace

ScenePicture::ScenePicture(QWidget* parent) : QWidget(parent) {
  options_.ground_grid = true;
  options_.threads = core::thread_count(0);
  options_.footprints = true;
  setObjectName(QStringLiteral("scene_view"));
  setAccessibleName(tr("Scene"));
  setAccessibleDescription(tr("The scene in three dimensions. Arrows turn it, plus and minus zoom, Home shows all."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setContextMenuPolicy(Qt::PreventContextMenu);  // A right drag zooms: menus open when the button goes up.
  setAttribute(Qt::WA_OpaquePaintEvent);
  debounce_.setSingleShot(true);
  connect(&debounce_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
  follow_size();
}

void ScenePicture::set_snapshot(picture::Snapshot snapshot) {
  snapshot_ = std::move(snapshot);
  if (options_.hovered && !is_held() && !picture::place_of(snapshot_, *options_.hovered)) set_hovered(std::nullopt);
  if (options_.hovered_point && !is_held() && !place_of_point(*options_.hovered_point)) set_hovered_point(std::nullopt);
  redraw();
}

void ScenePicture::set_camera(const picture::Camera& camera) {
  perspective_ = camera.perspective;
  change_camera(camera);
}

void ScenePicture::ride(const picture::Camera& camera) { change_camera(camera); }

picture::Camera ScenePicture::usual_camera() const {
  picture::Camera camera = camera_;
  if (camera.heights_away != picture::distance_in_heights) camera.perspective = perspective_;
  camera.heights_away = picture::distance_in_heights;
  return camera;
}

void ScenePicture::set_options(picture::DrawingOptions options) {
  options.hovered = options_.hovered;
  options.hovered_point = options_.hovered_point;
  options.hovered_handle = options_.hovered_handle;
  options.gizmo = options_.gizmo;
  options.guide = options_.guide;
  options.ruler = options_.ruler;
  options.ruler_words = options_.ruler_words;
  options.pixel_scale = options_.pixel_scale;
  options.coarse = false;
  options.dark = dark_;
  options.threads = options_.threads;
  options.samples = options_.samples;
  options_ = std::move(options);
  redraw();
}

// Sets of many objects are copied only where they differ.
void ScenePicture::set_marks(const std::set<scene::ObjectId>& selected, const std::set<scene::ObjectId>& hidden,
                             std::optional<picture::PathPointId> point) {
  if (options_.selected != selected) options_.selected = selected;
  if (options_.hidden != hidden) options_.hidden = hidden;
  options_.selected_point = point;
  options_.coarse = false;
  redraw();
}

void ScenePicture::set_dark(bool dark) {
  if (dark == dark_) return;
  dark_ = dark;
  options_.dark = dark;
  redraw();
}

void ScenePicture::set_namer(std::function<std::string(scene::ObjectId)> namer) { namer_ = std::move(namer); }

void ScenePicture::set_point_namer(std::function<std::string(const picture::PathPointId&)> namer) {
  point_namer_ = std::move(namer);
}

void ScenePicture::set_earth(std::optional<radar::EarthFrame> earth) { earth_ = std::move(earth); }

void ScenePicture::fit() {
  follow_size();
  change_camera(picture::showing_all(usual_camera(), snapshot_, options_));
}

void ScenePicture::show_objects(const std::set<scene::ObjectId>& objects) {
  follow_size();
  change_camera(picture::showing(usual_camera(), snapshot_, objects, options_.pixel_scale));
}

void ScenePicture::look(picture::ViewPreset view) { change_camera(picture::preset(usual_camera(), view)); }

void ScenePicture::zoom(double factor) {
  change_camera(picture::zoomed(camera_, factor, 0.5 * camera_.width_px, 0.5 * camera_.height_px));
}

// The camera works in device pixels; a window that moves to a finer screen keeps what it shows.
void ScenePicture::follow_size() {
  const double scale = devicePixelRatioF();
  camera_.pixels_per_m *= scale / options_.pixel_scale;
  options_.pixel_scale = scale;
  camera_.width_px = std::max(1.0, width() * scale);
  camera_.height_px = std::max(1.0, height() * scale);
  drawn_ = false;
}

void ScenePicture::change_camera(const picture::Camera& camera) {
  camera_ = camera;
  follow_size();
  redraw();
  emit camera_changed();
}

// Many targets take a while to paint, which is spent in a turn of its own: what is pressed meanwhile is taken before.
void ScenePicture::redraw() {
  constexpr std::size_t many_targets = 20'000;
  drawn_ = false;
  if (is_held() || snapshot_.targets.size() < many_targets)
    update();
  else if (!debounce_.isActive())
    debounce_.start();
}

void ScenePicture::refresh_drawing(bool dragging) {
  if (drawn_ && drawn_dragging_ == dragging) return;
  // Edges of solids are smooth when the hand rests.
  options_.samples = dragging ? 1 : 2;
  options_.coarse = dragging && snapshot_.targets.size() > picture::coarse_targets;
  picture::draw_scene(snapshot_, camera_, options_, drawing_);
  options_.coarse = false;
  drawn_ = true;
  drawn_dragging_ = dragging;
}

QString ScenePicture::name_of_object(scene::ObjectId id) const {
  if (namer_) return QString::fromStdString(namer_(id));
  if (const auto* platform = found_in(snapshot_.platforms, id)) return QString::fromStdString(platform->name);
  if (const auto* radar = found_in(snapshot_.radars, id)) return QString::fromStdString(radar->name);
  const std::string_view title = scene::visit_kind(id.kind, [](const auto& kind) { return kind.title; });
  return QStringLiteral("%1 %2")
      .arg(QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size())))
      .arg(id.index + 1);
}

void ScenePicture::set_hovered(std::optional<scene::ObjectId> id) {
  if (options_.hovered == id) return;
  options_.hovered = id;
  redraw();
  emit hovered(id);
}

void ScenePicture::set_hovered_point(std::optional<picture::PathPointId> point) {
  if (options_.hovered_point == point) return;
  options_.hovered_point = point;
  redraw();
}

std::optional<core::Vec3> ScenePicture::place_of_point(const picture::PathPointId& point) const {
  const auto* const platform = found_in(snapshot_.platforms, point.platform);
  if (platform == nullptr || point.index >= platform->path_points_world_m.size()) return std::nullopt;
  return platform->path_points_world_m[point.index];
}

std::optional<scene::ObjectId> ScenePicture::picked_at(const QPointF& at_px) {
  refresh_drawing(false);
  return picture::picked(drawing_, snapshot_, camera_, at_px.x(), at_px.y(), pick_reach_px * options_.pixel_scale);
}

std::optional<picture::PathPointId> ScenePicture::path_point_at(const QPointF& at_px) {
  refresh_drawing(false);
  return picture::picked_path_point(drawing_, at_px.x(), at_px.y(), pick_reach_px * options_.pixel_scale);
}

void ScenePicture::tell_place(const QPointF& at_px) {
  if (options_.hovered_point)
    emit pointed_at(place_of_point(*options_.hovered_point));
  else if (options_.hovered && picture::place_of(snapshot_, *options_.hovered))
    emit pointed_at(picture::place_of(snapshot_, *options_.hovered));
  else
    emit pointed_at(picture::ground_under(camera_, at_px.x(), at_px.y(), earth_));
}

// Of a point of a path or an object under the pointer, otherwise of the ground.
std::optional<core::Vec3> ScenePicture::place_at(const QPointF& at_px) {
  if (const auto point = path_point_at(at_px)) return place_of_point(*point);
  if (const auto id = picked_at(at_px)) return picture::place_of(snapshot_, *id);
  return picture::ground_under(camera_, at_px.x(), at_px.y(), earth_);
}

void ScenePicture::set_hovered_handle(std::optional<picture::GizmoHandle> handle) {
  if (options_.hovered_handle == handle) return;
  options_.hovered_handle = handle;
  redraw();
}

void ScenePicture::paintEvent(QPaintEvent*) {
  if (options_.pixel_scale != devicePixelRatioF()) follow_size();
  refresh_drawing(is_dragging());
  QPainter painter(this);
  painter.scale(1.0 / options_.pixel_scale, 1.0 / options_.pixel_scale);
  const QRectF area(0.0, 0.0, camera_.width_px, camera_.height_px);
  painter_.paint(painter, area, drawing_, {font(), options_.pixel_scale, dark_});
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), options_.pixel_scale));
  painter.setBrush(Qt::NoBrush);
  const double inset = 0.5 * options_.pixel_scale;
  painter.drawRect(area.adjusted(inset, inset, -inset, -inset));
}

void ScenePicture::wheelEvent(QWheelEvent* event) {
  const QPointF at_px = device_point(event->position());
  if (event->angleDelta().y() != 0 && !is_held())
    change_camera(
        picture::zoomed(camera_, std::pow(10.0, event->angleDelta().y() / wheel_decade), at_px.x(), at_px.y()));
  event->accept();
}

bool ScenePicture::camera_key(const QKeyEvent& event) {
  const auto arrow = [&](double x, double y) {
    const double scale = options_.pixel_scale;
    if (event.modifiers().testFlag(Qt::ShiftModifier))
      change_camera(picture::panned(camera_, key_pan_px * scale * x, key_pan_px * scale * y));
    else
      change_camera(picture::turned(camera_, key_turn_px * x, 0.5 * key_turn_px * y));
    return true;
  };
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

void ScenePicture::resizeEvent(QResizeEvent*) { follow_size(); }

bool ScenePicture::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    if (options_.hovered_point && point_namer_)
      QToolTip::showText(dynamic_cast<const QHelpEvent&>(*event).globalPos(),
                         QString::fromStdString(point_namer_(*options_.hovered_point)), this);
    else if (options_.hovered)
      QToolTip::showText(dynamic_cast<const QHelpEvent&>(*event).globalPos(), name_of_object(*options_.hovered), this);
    else
      QToolTip::hideText();
    return true;
  }
  return QWidget::event(event);
}

}  // namespace sarsim::gui
