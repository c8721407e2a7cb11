#include "gui/scene/scene_panel.hpp"

#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "gui/common/palette_colours.hpp"
#include "gui/common/text.hpp"
#include "gui/scene/camera_bar.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/scene/time_bar.hpp"
#include "picture/figure/ticks.hpp"
#include "picture/scene/framing.hpp"
#include "picture/scene/handles.hpp"
#include "picture/scene/scene_view.hpp"
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

// --- Points of paths that are put in, put behind and taken out by hand, and the tools of the hand.

namespace {

constexpr double half_pixel = 0.5;  // Places are rounded to it, so that scripts do not fill up with digits.
constexpr double metres_per_degree = 111'000.0;

const char* added_label(const scene::Platform& platform) {
  return platform.path == scene::Platform::Path::legs ? "Add leg" : "Add waypoint";
}

}  // namespace

void ScenePanel::measure(bool on) {
  if (on == (scene_->tool() == SceneWidget::Tool::ruler)) return;
  scene_->set_tool(on ? SceneWidget::Tool::ruler : SceneWidget::Tool::hand);
  scene_->setFocus();
}

void ScenePanel::draw_path(bool on) {
  if (on == (scene_->tool() == SceneWidget::Tool::path)) return;
  scene_->set_tool(on ? SceneWidget::Tool::path : SceneWidget::Tool::hand);
  scene_->setFocus();
}

// The selected one, or that of what is selected; not the world.
std::optional<scene::ObjectId> ScenePanel::platform_to_draw() const {
  const auto current = session_.current();
  if (!current) return std::nullopt;
  std::size_t index = current->index;
  if (current->kind != scene::ObjectKind::platform)
    index = scene::find_platform(session_.scene(), scene::carrier_of(session_.scene(), *current));
  const auto& platforms = session_.scene().platforms;
  if (index >= platforms.size() || core::equal_ignoring_case(platforms[index].name, "Earth")) return std::nullopt;
  return scene::ObjectId{scene::ObjectKind::platform, index};
}

void ScenePanel::take_tool() {
  drawn_platform_.reset();
  if (scene_->tool() == SceneWidget::Tool::path) {
    drawn_platform_ = platform_to_draw();
    if (!drawn_platform_) {
      session_.log(core::Severity::warning, tr("Select the platform whose path is to be drawn, then draw it."));
      scene_->set_tool(SceneWidget::Tool::hand);
      return;
    }
    session_.select_only(*drawn_platform_);
  }
  show_path_end();
}

// From where the path that is drawn goes on.
void ScenePanel::show_path_end() {
  if (scene_->tool() != SceneWidget::Tool::path || !drawn_platform_) return;
  for (const picture::Snapshot::Platform& platform : scene_->snapshot().platforms) {
    if (platform.id != *drawn_platform_) continue;
    const auto& points = platform.path_points_world_m;
    return scene_->set_path_end(points.empty() ? platform.pose.position_world_m : points.back());
  }
  scene_->set_tool(SceneWidget::Tool::hand);
}

core::Vec3 ScenePanel::in_path_frame(const scene::Platform& platform, const core::Vec3& world_m) const {
  if (platform.parent.empty()) return world_m;
  const std::size_t parent = scene::find_platform(session_.scene(), platform.parent);
  for (const picture::Snapshot::Platform& p : scene_->snapshot().platforms)
    if (p.id.index == parent) return core::transposed(p.pose.world_from_platform) * (world_m - p.pose.position_world_m);
  return world_m;
}

// To half a pixel: x and y, or over an Earth latitude and longitude. The height stays as it is.
core::Vec3 ScenePanel::rounded_place(const core::Vec3& world_m) const {
  const double step_m = picture::round_below(half_pixel * scene_->pixel_scale() / scene_->camera().pixels_per_m);
  if (!earth_) return {core::rounded_to(world_m.x, step_m), core::rounded_to(world_m.y, step_m), world_m.z};
  radar::Geodetic place = earth_->geodetic_of(world_m);
  const double step_deg = picture::round_below(step_m / metres_per_degree);
  const auto rounded = [&](double rad) {
    return core::rounded_to(rad * core::deg_per_rad, step_deg) * core::rad_per_deg;
  };
  place.latitude_rad = rounded(place.latitude_rad);
  place.longitude_rad = rounded(place.longitude_rad);
  return earth_->world_of(place);
}

void ScenePanel::change_path(scene::ObjectId id, scene::PathEdit edit, const char* what) {
  if (!edit.platform) {
    const QString why = tr("%1: %2.").arg(tr(what), QString::fromStdString(edit.refusal));
    session_.log(core::Severity::warning, why);
    QToolTip::showText(scene_->mapToGlobal(scene_->rect().center()), why, scene_);
    return;
  }
  session_.end_run();
  const scene::AnyObject before = scene::object_of(session_.scene(), id);
  session_.perform(scene::replace_object(session_.scene(), id, std::move(*edit.platform), what));
  if (scene::object_of(session_.scene(), id) == before) {
    scene_->set_tool(SceneWidget::Tool::hand);
    return session_.log(core::Severity::warning, tr("%1: a scene in the language of 1998 has no waypoints and legs. "
                                                    "Convert it to format 2 with 'sarsim convert'.")
                                                     .arg(tr(what)));
  }
  select_point(picture::PathPointId{id, edit.point});
}

void ScenePanel::add_point_behind(const core::Vec3& world_m) {
  if (!drawn_platform_ || !scene::has_object(session_.scene(), *drawn_platform_)) return;
  const scene::ObjectId id = *drawn_platform_;
  const scene::Platform& platform = session_.scene().platforms[id.index];
  const double step_m = picture::round_below(half_pixel * scene_->pixel_scale() / scene_->camera().pixels_per_m);
  const core::Vec3 to_m = in_path_frame(platform, rounded_place(world_m));
  change_path(id, scene::with_point_behind(platform, to_m, step_m), added_label(platform));
}

void ScenePanel::divide_path(const picture::PathPlace& place) {
  if (!scene::has_object(session_.scene(), place.platform)) return;
  const scene::Platform& platform = session_.scene().platforms[place.platform.index];
  const core::Vec3 at_m = in_path_frame(platform, rounded_place(place.at_world_m));
  change_path(place.platform, scene::with_point_between(platform, at_m), added_label(platform));
}

void ScenePanel::add_point_here() {
  const auto place = place_of_menu_ ? place_of_menu_ : scene_->path_under_pointer();
  if (place) return divide_path(*place);
  session_.log(core::Severity::warning,
               tr("Select a platform that goes by waypoints or legs and put the pointer on the line of its path."));
}

// Whether the selected point is one of an orbit's state, which cannot lack any.
bool ScenePanel::holds_state() const {
  const auto& platforms = session_.scene().platforms;
  return selected_point_ && selected_point_->platform.index < platforms.size() &&
         platforms[selected_point_->platform.index].path == scene::Platform::Path::state;
}

void ScenePanel::delete_point() {
  if (!selected_point_ || !scene::has_object(session_.scene(), selected_point_->platform)) return;
  const picture::PathPointId point = *selected_point_;
  const scene::Platform& platform = session_.scene().platforms[point.platform.index];
  const bool legs = platform.path == scene::Platform::Path::legs;
  change_path(point.platform, scene::without_path_point(platform, point.index),
              holds_state() ? "Delete point"
              : legs        ? "Delete leg"
                            : "Delete waypoint");
}

void ScenePanel::add_hand_entries(QMenu& menu) {
  if (!menu.isEmpty()) menu.addSeparator();
  const auto add = [&](const QString& text, const char* name, auto&& work) {
    QAction* action = menu.addAction(text);
    action->setObjectName(name);
    connect(action, &QAction::triggered, this, work);
  };
  if (place_of_menu_) add(tr("Add &Waypoint Here"), "hand_add_point", [this] { add_point_here(); });
  if (selected_point_ && !holds_state()) add(tr("Delete Waypoin&t"), "hand_delete_point", [this] { delete_point(); });
  if (platform_to_draw()) add(tr("Draw &Path"), "hand_draw_path", [this] { draw_path(true); });
  if (!session_.selection().empty()) {
    add(tr("&Zoom to Selection"), "hand_zoom", [this] { zoom_to_selection(); });
    add(tr("&Follow"), "hand_follow", [this] { follow_selection(); });
  }
  if (!session_.scene().radars.empty()) add(tr("Along the &Beam"), "hand_beam", [this] { look_along_beam(); });
  add(tr("Show &All"), "hand_all", [this] { scene_->fit(); });
  add(tr("&Measure Distance"), "hand_measure", [this] { measure(true); });
}

// --- From where a scene is seen as time runs: fixed, following an object, along a beam; and the views by their names.

namespace {

constexpr std::size_t max_listed = 20;  // beams or platforms in a menu

}  // namespace

void ScenePanel::set_ride(Ride ride, std::optional<scene::ObjectId> on) {
  if (ride == ride_ && on == rides_on_) return;
  ride_ = ride;
  rides_on_ = on;
  show_camera();
  emit ride_changed();
}

void ScenePanel::follow(std::optional<scene::ObjectId> object) {
  way_to_focus_m_ = {};
  set_ride(object ? Ride::follow : Ride::none, object);
  move_camera();
}

bool ScenePanel::follow_selection() {
  const auto current = session_.current();
  if (ride_ == Ride::follow && (!current || rides_on_ == current)) {
    set_ride(Ride::none, std::nullopt);
    return true;
  }
  const auto place = current ? picture::place_of(scene_->snapshot(), *current) : std::nullopt;
  if (!place) {
    emit ride_changed();  // A switch that was pressed goes back.
    return false;
  }
  const picture::Camera& camera = scene_->camera();
  const auto at = camera.project(*place);
  const bool seen = at && at->x >= 0.0 && at->y >= 0.0 && at->x <= camera.width_px && at->y <= camera.height_px;
  way_to_focus_m_ = seen ? camera.focus_world_m - *place : core::Vec3{};
  set_ride(Ride::follow, current);
  move_camera();
  return true;
}

bool ScenePanel::look_along_beam(std::optional<scene::ObjectId> radar) {
  const auto current = session_.current();
  if (!radar && current && current->kind == scene::ObjectKind::radar) radar = current;
  if (!radar && !session_.scene().radars.empty()) radar = scene::ObjectId{scene::ObjectKind::radar, 0};
  if (!radar || !picture::place_of(scene_->snapshot(), *radar)) {
    session_.log(core::Severity::warning, tr("There is no radar along whose beam the scene could be seen."));
    emit ride_changed();
    return false;
  }
  set_ride(Ride::beam, radar);
  move_camera();
  return true;
}

// As far as to the ground; a beam that misses it, as far as the focus was.
std::optional<picture::Camera> ScenePanel::beam_camera() const {
  const auto& radars = scene_->snapshot().radars;
  if (std::ranges::find(radars, *rides_on_, &picture::Snapshot::Radar::id) == radars.end()) return std::nullopt;
  return picture::beam_camera(scene_->camera(), scene_->snapshot(), rides_on_->index);
}

// Where the ride has come to.
void ScenePanel::move_camera() {
  if (!rides_on_) return;
  moves_camera_ = true;
  if (ride_ == Ride::follow) {
    if (const auto place = picture::place_of(scene_->snapshot(), *rides_on_)) focus_on(*place + way_to_focus_m_);
  } else if (const auto camera = beam_camera()) {
    scene_->ride(*camera);
  }
  moves_camera_ = false;
}

// A hand has changed the view, or the ride has.
void ScenePanel::take_camera() {
  if (!moves_camera_ && ride_ == Ride::beam) set_ride(Ride::none, std::nullopt);
  if (!moves_camera_ && ride_ == Ride::follow)
    if (const auto place = picture::place_of(scene_->snapshot(), *rides_on_))
      way_to_focus_m_ = scene_->camera().focus_world_m - *place;
  show_camera();
}

void ScenePanel::follow_ride(const scene::SceneChange& change) {
  if (!rides_on_) return;
  const auto now = change.moved(*rides_on_);
  set_ride(now ? ride_ : Ride::none, now);
}

// Another document is at hand: this one's view is kept for when it comes back.
void ScenePanel::leave_document() {
  views_[shown_] = {scene_->usual_camera(), ride_, rides_on_, way_to_focus_m_, std::move(kept_views_),
                    time_bar_->step_s()};
  shown_ = session_.number();
  new_document_ = true;
  set_ride(Ride::none, std::nullopt);
  kept_views_.clear();
  dragged_.reset();
  selected_point_.reset();
  scene_->set_tool(SceneWidget::Tool::hand);
  time_bar_->set_playing(false);
}

void ScenePanel::show_again(const View& view) {
  picture::Camera camera = view.camera;
  camera.perspective = scene_->usual_camera().perspective;  // one choice for all
  scene_->set_camera(camera);
  kept_views_ = view.kept;
  way_to_focus_m_ = view.way_to_focus_m;
  time_bar_->set_step(view.step_s);
  set_ride(view.ride, view.rides_on);
  move_camera();
}

void ScenePanel::show_camera() {
  const auto degrees = [](double rad) { return qRound(rad * core::deg_per_rad); };
  QString text = tr("Azimuth %1°  Elevation %2°")
                     .arg(degrees(scene_->camera().azimuth_rad))
                     .arg(degrees(scene_->camera().elevation_rad));
  if (rides_on_ && scene::has_object(session_.scene(), *rides_on_)) {
    const QString name = QString::fromStdString(scene::label_of(session_.scene(), *rides_on_));
    text = (ride_ == Ride::beam ? tr("Along the beam of %1  %2") : tr("Follows %1  %2")).arg(name, text);
  }
  direction_->setText(text);
  place_direction();
}

void ScenePanel::keep_view() { kept_views_.push_back(scene_->camera()); }

void ScenePanel::fill_cameras(QMenu& menu) {
  menu.clear();
  const auto add = [&](const QString& text, auto&& work) {
    connect(menu.addAction(text), &QAction::triggered, this, work);
  };
  for (const auto& [text, view] : {std::pair{tr("From Above"), picture::ViewPreset::top},
                                   std::pair{tr("From the Front"), picture::ViewPreset::front},
                                   std::pair{tr("From the Side"), picture::ViewPreset::side},
                                   std::pair{tr("Default View"), picture::ViewPreset::start}})
    add(text, [this, view = view] { scene_->look(view); });
  const auto each = [&](scene::ObjectKind kind, const QString& words, auto&& work) {
    menu.addSeparator();
    for (std::size_t i = 0; i < std::min(max_listed, scene::count_of(session_.scene(), kind)); ++i)
      add(words.arg(QString::fromStdString(scene::label_of(session_.scene(), {kind, i}))),
          [work, id = scene::ObjectId{kind, i}] { work(id); });
  };
  each(scene::ObjectKind::radar, tr("Along the Beam of %1"), [this](scene::ObjectId id) { look_along_beam(id); });
  each(scene::ObjectKind::platform, tr("Follow %1"), [this](scene::ObjectId id) { follow(id); });
  menu.addSeparator();
  for (std::size_t i = 0; i < kept_views_.size(); ++i)
    add(tr("View %1").arg(i + 1), [this, view = kept_views_[i]] {
      set_ride(Ride::none, std::nullopt);
      scene_->set_camera(view);
    });
  add(tr("Keep This View"), [this] { keep_view(); });
}

}  // namespace sarsim::gui
