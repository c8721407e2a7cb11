// What clicks do besides selecting: the ruler, and points behind a path.

#include <QKeyEvent>

#include <utility>

#include "gui/scene/scene_widget.hpp"
#include "picture/scene/ground_point.hpp"

namespace sarsim::gui {

namespace {

constexpr double line_reach_px = 6.0;  // of the mouse, on the screen

}  // namespace

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

// Of a point of a path or an object under the pointer, otherwise of the ground.
std::optional<core::Vec3> SceneWidget::place_at(const QPointF& at_px) {
  if (const auto point = path_point_at(at_px)) return place_of_point(*point);
  if (const auto id = picked_at(at_px)) return picture::place_of(snapshot_, *id);
  return picture::ground_under(camera_, at_px.x(), at_px.y(), earth_);
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
                                    line_reach_px * options_.pixel_scale);
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
