#include "gui/scene/scene_widget.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QToolTip>

#include <utility>

#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "picture/scene/framing.hpp"

namespace sarsim::gui {

namespace {

template <class Objects>
auto* found_in(const Objects& objects, scene::ObjectId id) {
  const auto at = std::ranges::find(objects, id, [](const auto& object) { return object.id; });
  return at == objects.end() ? nullptr : &*at;
}

}  // namespace

SceneWidget::SceneWidget(QWidget* parent) : QWidget(parent) {
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
  hand_words_ = new QLabel(this);
  hand_words_->setObjectName(QStringLiteral("hand_words"));
  hand_words_->setAccessibleName(tr("Where what is dragged is"));
  hand_words_->setAutoFillBackground(true);
  hand_words_->setFrameShape(QFrame::Box);
  hand_words_->setMargin(3);
  hand_words_->setAttribute(Qt::WA_TransparentForMouseEvents);
  hand_words_->hide();
  follow_size();
}

void SceneWidget::set_snapshot(picture::Snapshot snapshot) {
  snapshot_ = std::move(snapshot);
  if (options_.hovered && press_.gesture == Gesture::none && !picture::place_of(snapshot_, *options_.hovered))
    set_hovered(std::nullopt);
  if (options_.hovered_point && press_.gesture == Gesture::none && !place_of_point(*options_.hovered_point))
    set_hovered_point(std::nullopt);
  redraw();
}

void SceneWidget::set_camera(const picture::Camera& camera) {
  perspective_ = camera.perspective;
  change_camera(camera);
}

void SceneWidget::ride(const picture::Camera& camera) { change_camera(camera); }

picture::Camera SceneWidget::usual_camera() const {
  picture::Camera camera = camera_;
  if (camera.heights_away != picture::distance_in_heights) camera.perspective = perspective_;
  camera.heights_away = picture::distance_in_heights;
  return camera;
}

void SceneWidget::set_options(picture::DrawingOptions options) {
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
void SceneWidget::set_marks(const std::set<scene::ObjectId>& selected, const std::set<scene::ObjectId>& hidden,
                            std::optional<picture::PathPointId> point) {
  if (options_.selected != selected) options_.selected = selected;
  if (options_.hidden != hidden) options_.hidden = hidden;
  options_.selected_point = point;
  options_.coarse = false;
  redraw();
}

void SceneWidget::set_dark(bool dark) {
  if (dark == dark_) return;
  dark_ = dark;
  options_.dark = dark;
  redraw();
}

void SceneWidget::set_namer(std::function<std::string(scene::ObjectId)> namer) { namer_ = std::move(namer); }

void SceneWidget::set_point_namer(std::function<std::string(const picture::PathPointId&)> namer) {
  point_namer_ = std::move(namer);
}

void SceneWidget::set_earth(std::optional<radar::EarthFrame> earth) { earth_ = std::move(earth); }

void SceneWidget::fit() {
  follow_size();
  change_camera(picture::showing_all(usual_camera(), snapshot_, options_));
}

void SceneWidget::show_objects(const std::set<scene::ObjectId>& objects) {
  follow_size();
  change_camera(picture::showing(usual_camera(), snapshot_, objects, options_.pixel_scale));
}

void SceneWidget::look(picture::ViewPreset view) { change_camera(picture::preset(usual_camera(), view)); }

void SceneWidget::zoom(double factor) {
  change_camera(picture::zoomed(camera_, factor, 0.5 * camera_.width_px, 0.5 * camera_.height_px));
}

// The camera works in device pixels; a window that moves to a finer screen keeps what it shows.
void SceneWidget::follow_size() {
  const double scale = devicePixelRatioF();
  camera_.pixels_per_m *= scale / options_.pixel_scale;
  options_.pixel_scale = scale;
  camera_.width_px = std::max(1.0, width() * scale);
  camera_.height_px = std::max(1.0, height() * scale);
  drawn_ = false;
}

void SceneWidget::change_camera(const picture::Camera& camera) {
  camera_ = camera;
  follow_size();
  redraw();
  emit camera_changed();
}

// Many targets take a while to paint, which is spent in a turn of its own: what is pressed meanwhile is taken before.
void SceneWidget::redraw() {
  constexpr std::size_t many_targets = 20'000;
  drawn_ = false;
  if (press_.gesture != Gesture::none || snapshot_.targets.size() < many_targets)
    update();
  else if (!debounce_.isActive())
    debounce_.start();
}

void SceneWidget::refresh_drawing(bool dragging) {
  if (drawn_ && drawn_dragging_ == dragging) return;
  // Edges of solids are smooth when the hand rests.
  options_.samples = dragging ? 1 : 2;
  options_.coarse = dragging && snapshot_.targets.size() > picture::coarse_targets;
  picture::draw_scene(snapshot_, camera_, options_, drawing_);
  options_.coarse = false;
  drawn_ = true;
  drawn_dragging_ = dragging;
}

QString SceneWidget::name_of_object(scene::ObjectId id) const {
  if (namer_) return QString::fromStdString(namer_(id));
  if (const auto* platform = found_in(snapshot_.platforms, id)) return QString::fromStdString(platform->name);
  if (const auto* radar = found_in(snapshot_.radars, id)) return QString::fromStdString(radar->name);
  const std::string_view title = scene::visit_kind(id.kind, [](const auto& kind) { return kind.title; });
  return QStringLiteral("%1 %2")
      .arg(QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size())))
      .arg(id.index + 1);
}

void SceneWidget::set_hovered(std::optional<scene::ObjectId> id) {
  if (options_.hovered == id) return;
  options_.hovered = id;
  redraw();
  emit hovered(id);
}

void SceneWidget::set_hovered_point(std::optional<picture::PathPointId> point) {
  if (options_.hovered_point == point) return;
  options_.hovered_point = point;
  redraw();
}

std::optional<core::Vec3> SceneWidget::place_of_point(const picture::PathPointId& point) const {
  const auto* const platform = found_in(snapshot_.platforms, point.platform);
  if (platform == nullptr || point.index >= platform->path_points_world_m.size()) return std::nullopt;
  return platform->path_points_world_m[point.index];
}

void SceneWidget::paintEvent(QPaintEvent*) {
  if (options_.pixel_scale != devicePixelRatioF()) follow_size();
  refresh_drawing(press_.gesture != Gesture::none && press_.gesture != Gesture::pressed);
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

void SceneWidget::resizeEvent(QResizeEvent*) { follow_size(); }

bool SceneWidget::event(QEvent* event) {
  // Keys that this widget knows are its own, also where a menu has a shortcut for them.
  if (event->type() == QEvent::ShortcutOverride && knows_key(dynamic_cast<const QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
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
