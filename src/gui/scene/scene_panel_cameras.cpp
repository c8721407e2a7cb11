// From where a scene is seen as time runs: fixed, following an object, along a beam; and the views by their names.

#include <QLabel>
#include <QMenu>

#include <algorithm>

#include "core/maths/constants.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "gui/scene/time_bar.hpp"
#include "picture/scene/scene_view.hpp"

namespace sarsim::gui {

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
                                   std::pair{tr("As at the Beginning"), picture::ViewPreset::start}})
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
