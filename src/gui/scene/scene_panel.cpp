#include "gui/scene/scene_panel.hpp"

#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "gui/common/palette_colours.hpp"
#include "gui/common/text.hpp"
#include "gui/scene/camera_bar.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/scene/time_bar.hpp"
#include "picture/figure/ticks.hpp"
#include "picture/scene/framing.hpp"
#include "picture/scene/handles.hpp"
#include "scene/edit/edit.hpp"
#include "scene/edit/path_points.hpp"
#include "scene/model/world_frame.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::gui {

namespace {

// A coordinate that does not move keeps all its digits.
core::Vec3 moved(const core::Vec3& from, const core::Vec3& way) {
  const auto along = [](double begin, double by) { return by == 0.0 ? begin : core::tidy(begin + by); };
  return {along(from.x, way.x), along(from.y, way.y), along(from.z, way.z)};
}

// On an Earth its latitude, longitude and height. Lengths are rounded to the pixel.
QString place_text(const core::Vec3& world_m, const std::optional<radar::EarthFrame>& earth, double pixel_m) {
  const double step = picture::round_below(pixel_m);
  const auto length = [&](double m) {
    return read_out(scene::quantity_text(core::rounded_to(m, step), scene::Quantity::length));
  };
  if (!earth) return ScenePanel::tr("x %1  y %2  z %3").arg(length(world_m.x), length(world_m.y), length(world_m.z));
  const radar::Geodetic place = earth->geodetic_of(world_m);
  const double degree_m = 111'000.0;
  const int decimals = std::clamp(static_cast<int>(std::ceil(std::log10(degree_m / pixel_m))), 2, 9);
  const auto angle = [&](double rad, char positive, char negative) {
    return QStringLiteral("%1° %2")
        .arg(std::abs(rad) * core::deg_per_rad, 0, 'f', decimals)
        .arg(QChar::fromLatin1(rad < 0.0 ? negative : positive));
  };
  return ScenePanel::tr("%1  %2  height %3")
      .arg(angle(place.latitude_rad, 'N', 'S'), angle(place.longitude_rad, 'E', 'W'), length(place.height_m));
}

}  // namespace

ScenePanel::ScenePanel(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      scene_(new SceneWidget),
      time_bar_(new TimeBar),
      direction_(new QLabel(scene_)),
      place_(new QLabel(scene_)) {
  setObjectName("scene_panel");
  direction_->setObjectName("view_direction");
  direction_->setAutoFillBackground(true);  // Marks of the scene pass behind the words.
  direction_->setToolTip(tr("Where the scene is seen from: azimuth clockwise from +y, elevation above the x-y plane"));
  // In a corner of the scene, so that the time has the whole width below.
  auto* corner = new QVBoxLayout(scene_);
  corner->setSizeConstraint(QLayout::SetNoConstraint);  // Words do not keep the scene from being narrow.
  top_ = new QBoxLayout(QBoxLayout::LeftToRight);
  cameras_ = new CameraBar(*this);
  cameras_->setAutoFillBackground(true);
  top_->addWidget(cameras_, 0, Qt::AlignLeft | Qt::AlignTop);
  top_->addWidget(direction_, 1, Qt::AlignRight | Qt::AlignTop);
  corner->addLayout(top_);
  corner->addWidget(place_, 0, Qt::AlignRight);
  corner->addStretch();
  place_->setObjectName("place_under_pointer");
  place_->setAutoFillBackground(true);
  place_->setAccessibleName(tr("Place under the pointer"));
  place_->setToolTip(tr("What the pointer is over: an object, or else the ground"));
  place_->setAttribute(Qt::WA_TransparentForMouseEvents);  // The scene below is what is pointed at.
  place_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(scene_, 1);
  layout->addWidget(time_bar_);
  scene_->set_namer([this](scene::ObjectId id) {
    return scene::has_object(session_.scene(), id) ? scene::label_of(session_.scene(), id) : std::string();
  });
  scene_->set_point_namer([this](const picture::PathPointId& point) {
    if (!scene::has_object(session_.scene(), point.platform)) return std::string();
    const scene::Platform& platform = session_.scene().platforms[point.platform.index];
    return scene::label_of(session_.scene(), point.platform) + ": " + scene::path_point_name(platform, point.index);
  });
  connect_gestures();
  scene_->installEventFilter(this);
  shown_ = session_.number();
  connect(&session_, &Session::document_replaced, this, &ScenePanel::leave_document);
  connect(&session_, &Session::document_closed, this, [this](int number) { views_.erase(number); });
  connect(&session_, &Session::scene_changed, this, &ScenePanel::take_scene);
  connect(&session_, &Session::selection_changed, this, [this] {
    if (selected_point_ && session_.selection() != std::set{selected_point_->platform}) selected_point_.reset();
    show_marks();
  });
  connect(&session_, &Session::hidden_changed, this, &ScenePanel::show_marks);
  connect(&session_, &Session::time_changed, this, [this](double time_s) {
    time_bar_->set_time(time_s);
    show_time();
  });
  connect(time_bar_, &TimeBar::time_changed, &session_, &Session::set_time);
  scene::SceneChange first;
  first.everything = true;
  take_scene(first);
  show_camera();
}

ScenePanel::~ScenePanel() = default;

void ScenePanel::connect_gestures() {
  connect(scene_, &SceneWidget::selection_clicked, this,
          [this](scene::ObjectId id, bool add) { add ? session_.select_also(id) : session_.select_only(id); });
  connect(scene_, &SceneWidget::empty_clicked, this, [this] { session_.select({}); });
  connect(scene_, &SceneWidget::point_clicked, this, &ScenePanel::select_point);
  connect(scene_, &SceneWidget::frame_wanted, this, &ScenePanel::zoom_to_selection);
  connect(scene_, &SceneWidget::beam_wanted, this, [this] { look_along_beam(); });
  connect(scene_, &SceneWidget::follow_wanted, this, &ScenePanel::follow_selection);
  connect(scene_, &SceneWidget::own_axes_wanted, this, [this] { set_own_axes(!own_axes_); });
  connect(scene_, &SceneWidget::turned_to, this, &ScenePanel::turn);
  connect(scene_, &SceneWidget::edit_requested, this, &ScenePanel::edit_requested);
  connect(scene_, &SceneWidget::menu_requested, this, [this](std::optional<scene::ObjectId> object, QPoint global) {
    place_of_menu_ = scene_->path_under_pointer();
    emit menu_requested(object, global);
    place_of_menu_.reset();
  });
  connect(scene_, &SceneWidget::tool_changed, this, &ScenePanel::take_tool);
  connect(scene_, &SceneWidget::path_place_wanted, this, &ScenePanel::add_point_behind);
  connect(scene_, &SceneWidget::path_divided, this, &ScenePanel::divide_path);
  connect(scene_, &SceneWidget::point_delete_wanted, this, &ScenePanel::delete_point);
  connect(scene_, &SceneWidget::delete_wanted, this, &ScenePanel::delete_wanted);
  connect(scene_, &SceneWidget::drag_started, this, &ScenePanel::begin_drag);
  connect(scene_, &SceneWidget::dragged_to, this, &ScenePanel::drag);
  connect(scene_, &SceneWidget::path_drag_started, this, &ScenePanel::begin_path_drag);
  connect(scene_, &SceneWidget::path_dragged_to, this, &ScenePanel::drag_path);
  connect(scene_, &SceneWidget::pointed_at, this, &ScenePanel::show_place);
  connect(scene_, &SceneWidget::drag_taken_back, this, &ScenePanel::take_back);
  connect(scene_, &SceneWidget::drag_ended, this, [this] {
    dragged_.reset();
    session_.end_run();
  });
  connect(scene_, &SceneWidget::camera_changed, this, &ScenePanel::take_camera);
}

// The words go below the buttons where there is no room beside them.
void ScenePanel::place_direction() {
  const QMargins edges = scene_->layout()->contentsMargins();
  const int needed =
      cameras_->sizeHint().width() + direction_->sizeHint().width() + edges.left() + edges.right() + top_->spacing();
  top_->setDirection(needed > scene_->width() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

bool ScenePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == scene_ && event->type() == QEvent::Resize) place_direction();
  if (watched != scene_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() != Qt::Key_Space || key->modifiers() != Qt::NoModifier) return QWidget::eventFilter(watched, event);
  if (!key->isAutoRepeat()) time_bar_->set_playing(!time_bar_->playing());
  return true;
}

void ScenePanel::take_scene(const scene::SceneChange& change) {
  if (change.everything)
    maker_ = std::make_unique<picture::SnapshotMaker>(session_.scene());
  else
    maker_->follow(session_.scene(), change);
  follow_ride(change);
  const auto [first_s, last_s] = maker_->time_span_s();
  earth_ = scene::earth_of(session_.scene().world);
  scene_->set_earth(earth_);
  time_bar_->set_epoch(scene::epoch_of(session_.scene().world).instant);
  time_bar_->set_span(first_s, last_s);
  if (new_document_) time_bar_->set_step(picture::round_below((last_s - first_s) / 100.0));
  show_time();
  const auto seen_before = new_document_ ? views_.extract(shown_) : decltype(views_)::node_type();
  if (!new_document_)
    show_what_came(change);
  else if (seen_before.empty())
    show_first();
  else
    show_again(seen_before.mapped());
  new_document_ = false;
}

// Of a scene without a size, a new one, nothing else says how near to look.
void ScenePanel::show_first() {
  picture::Camera camera = picture::Camera::start(1.0, 1.0);
  camera.pixels_per_m *= scene_->pixel_scale();
  camera.azimuth_rad = scene_->camera().azimuth_rad;
  camera.elevation_rad = scene_->camera().elevation_rad;
  camera.perspective = scene_->camera().perspective;
  scene_->set_camera(camera);
  scene_->fit();
}

void ScenePanel::show_time() {
  const auto [first_s, last_s] = maker_->time_span_s();
  picture::Snapshot snapshot = maker_->at(session_.time_s(), last_s - first_s, scene_->options().illuminated);
  scene_->set_snapshot(std::move(snapshot));
  move_camera();
  show_marks();
}

void ScenePanel::show_marks() {
  if (selected_point_ && !picture::handles_of(scene_->snapshot(), *selected_point_)) selected_point_.reset();
  scene_->set_dark(is_dark(palette()));
  if (const QColor ground = colour_of(picture::Role::background, palette());
      direction_->palette().color(QPalette::Window) != ground) {
    QPalette own;  // Only what is set here is the labels' own; the rest follows the theme.
    own.setColor(QPalette::Window, ground);
    direction_->setPalette(own);
    place_->setPalette(own);
    cameras_->setPalette(own);
    scene_->findChild<QLabel*>("hand_words")->setPalette(own);
  }
  scene_->set_marks(session_.selection(), session_.hidden(), selected_point_);
  show_handles();
  show_path_end();
}

void ScenePanel::show_handles() {
  std::optional<picture::Handles> handles;
  if (selected_point_)
    handles = picture::handles_of(scene_->snapshot(), *selected_point_);
  else if (session_.selection().size() == 1 && !session_.hidden().contains(*session_.selection().begin()))
    handles = picture::handles_of(session_.scene(), scene_->snapshot(), *session_.selection().begin(), own_axes_);
  scene_->set_handles(std::move(handles));
}

void ScenePanel::set_own_axes(bool own) {
  if (own == own_axes_) return;
  own_axes_ = own;
  show_handles();
  emit own_axes_changed(own);
}

void ScenePanel::select_point(const std::optional<picture::PathPointId>& point) {
  selected_point_ = point;
  if (point && session_.selection() != std::set{point->platform})
    session_.select_only(point->platform);
  else
    show_marks();
}

void ScenePanel::focus_on(const core::Vec3& world_m) {
  picture::Camera camera = scene_->camera();
  camera.focus_world_m = world_m;
  scene_->set_camera(camera);
}

void ScenePanel::focus_on_selection() {
  const picture::Snapshot& snapshot = scene_->snapshot();
  core::Vec3 sum;
  int count = 0;
  for (const scene::ObjectId id : session_.selection())
    if (const auto place = picture::place_of(snapshot, id)) sum = sum + *place, ++count;
  set_ride(Ride::none, std::nullopt);
  if (count > 0) focus_on((1.0 / count) * sum);
  if (count == 1) follow(*session_.selection().begin());
}

std::set<scene::ObjectId> ScenePanel::with_carried(const std::set<scene::ObjectId>& objects) const {
  std::set<scene::ObjectId> all = objects;
  for (const scene::ObjectId id : objects)
    if (id.kind == scene::ObjectKind::platform)
      for (const scene::ObjectId carried : scene::objects_on(session_.scene(), id.index)) all.insert(carried);
  return all;
}

void ScenePanel::zoom_to_selection() {
  if (session_.selection().empty()) return scene_->fit();
  set_ride(Ride::none, std::nullopt);
  scene_->show_objects(with_carried(session_.selection()));
}

// What is imported or pasted is not lost out of sight, or as a dot.
void ScenePanel::show_what_came(const scene::SceneChange& change) {
  const auto& last = session_.document().last_edit();
  if (!last || !last->forwards || !last->edit->label.starts_with("Add ")) return;
  const bool many = change.inserted.size() > 1 ||
                    (change.inserted.size() == 1 && change.inserted[0].kind == scene::ObjectKind::cloud);
  if (!many) return;
  const std::set<scene::ObjectId> came(change.inserted.begin(), change.inserted.end());
  if (!picture::shows_well(scene_->camera(), picture::points_of(scene_->snapshot(), came))) scene_->show_objects(came);
}

void ScenePanel::show_place(const std::optional<core::Vec3>& world_m) {
  place_->setVisible(world_m.has_value());
  if (world_m) place_->setText(place_text(*world_m, earth_, scene_->pixel_scale() / scene_->camera().pixels_per_m));
}

core::Mat3 ScenePanel::frame_of(const std::string& platform) const {
  const std::size_t carrier = scene::find_platform(session_.scene(), platform);
  for (const auto& p : scene_->snapshot().platforms)
    if (p.id.index == carrier) return core::transposed(p.pose.world_from_platform);
  return {};
}

void ScenePanel::begin_drag(scene::ObjectId id) {
  dragged_.reset();
  if (!scene::has_object(session_.scene(), id)) return;
  session_.end_run();
  // Its properties show where it is.
  if (!session_.selection().contains(id)) session_.select_only(id);
  held_ = id;
  dragged_ = scene::object_of(session_.scene(), id);
  written_ = *dragged_;
  platform_from_world_ = core::Mat3();
  if (id.kind != scene::ObjectKind::platform)
    platform_from_world_ = frame_of(scene::carrier_of(session_.scene(), id));
  else if (const std::string& parent = session_.scene().platforms[id.index].parent; !parent.empty())
    platform_from_world_ = frame_of(parent);
}

void ScenePanel::begin_path_drag(const picture::PathPointId& point) {
  select_point(point);
  begin_drag(point.platform);
  if (!dragged_) return;
  const std::vector<core::Vec3> points =
      scene::path_points(std::get<scene::Platform>(*dragged_), session_.scene().world);
  if (point.index < points.size())
    held_m_ = points[point.index];
  else
    dragged_.reset();
}

// Undone, removed or edited elsewhere meanwhile: what the hand holds is no longer there.
bool ScenePanel::still_held(scene::ObjectId id) {
  if (dragged_ && (!scene::has_object(session_.scene(), id) || scene::object_of(session_.scene(), id) != written_))
    dragged_.reset();
  return dragged_.has_value();
}

void ScenePanel::write_dragged(scene::ObjectId id, scene::AnyObject object, const char* what) {
  session_.perform(scene::replace_object(session_.scene(), id, std::move(object), what,
                                         "drag " + std::string(scene::name_of(id.kind)) + std::to_string(id.index)));
  written_ = scene::object_of(session_.scene(), id);
}

// Also the text is then as it was, byte by byte.
void ScenePanel::take_back() {
  if (dragged_ && still_held(held_) && written_ != *dragged_) session_.take_back();
  dragged_.reset();
}

void ScenePanel::drag(scene::ObjectId id, const core::Vec3& delta_world_m) {
  if (!still_held(id)) return;
  scene::AnyObject object = *dragged_;
  core::Vec3* const position = picture::position_of(object);
  if (position == nullptr) return;
  *position = moved(*position, platform_from_world_ * delta_world_m);
  write_dragged(id, std::move(object), id.kind == scene::ObjectKind::target ? "Move target" : "Move platform");
}

void ScenePanel::turn(scene::ObjectId id, std::size_t ring, double by_rad) {
  if (!still_held(id)) return;
  const std::string what = "Turn " + std::string(scene::name_of(id.kind));
  write_dragged(id, by_rad == 0.0 ? *dragged_ : picture::turned(*dragged_, ring, by_rad), what.c_str());
}

void ScenePanel::drag_path(const picture::PathPointId& point, const core::Vec3& delta_world_m, double resolution_m) {
  if (!still_held(point.platform)) return;
  const auto& platform = std::get<scene::Platform>(*dragged_);
  if (delta_world_m == core::Vec3{}) {
    write_dragged(point.platform, platform, "Move point of path");
    return;
  }
  const core::Vec3 to_m = moved(held_m_, platform_from_world_ * delta_world_m);
  if (auto changed = scene::with_path_point(platform, session_.scene().world, point.index, to_m, resolution_m))
    write_dragged(point.platform, std::move(*changed), "Move point of path");
}

}  // namespace sarsim::gui
