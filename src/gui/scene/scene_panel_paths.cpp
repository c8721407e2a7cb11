// Points of paths that are put in, put behind and taken out by hand, and the tools of the hand.

#include <QMenu>
#include <QToolTip>

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"
#include "picture/figure/ticks.hpp"
#include "scene/edit/edit.hpp"

namespace sarsim::gui {

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

}  // namespace sarsim::gui
