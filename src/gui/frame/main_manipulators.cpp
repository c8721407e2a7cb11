// Entries of the menu View for hands and cameras: what the scene shows, from where, and how things are taken hold of.

#include <QMenu>

#include "gui/frame/main_window.hpp"
#include "gui/scene/scene_panel.hpp"
#include "gui/scene/scene_widget.hpp"

namespace sarsim::gui {

void MainWindow::make_hand_entries(QMenu* view) {
  add_action(
      view, tr("Orbit About Selectio&n"), "view_focus_selection", {}, [this] { scene_->focus_on_selection(); },
      tr("Put what is selected into the middle, about which the view turns"));
  add_action(
      view, tr("&Zoom to Selection"), "view_zoom_selection", {}, [this] { scene_->zoom_to_selection(); },
      tr("Fill the scene with what is selected; in the scene the key F or ."));
  add_action(
      view, tr("Show &All"), "view_fit", {}, [this] { scene_->scene().fit(); },
      tr("Show everything; in the scene the key Home"));
  add_action(
      view, tr("Along the Bea&m"), "view_beam", {}, [this] { scene_->look_along_beam(); },
      tr("Look along the beam of the selected radar, or of the first; in the scene the key 4"));
  QAction* follow = add_action(
      view, tr("Follow Selection"), "view_follow", {}, [this] { scene_->follow_selection(); },
      tr("The view goes with what is selected as time runs; in the scene the key 5"));
  follow->setCheckable(true);
  connect(scene_, &ScenePanel::ride_changed, follow,
          [this, follow] { follow->setChecked(scene_->ride() == ScenePanel::Ride::follow); });
  QMenu* cameras = view->addMenu(tr("Cameras"));
  cameras->setObjectName("view_cameras");
  cameras->setToolTip(tr("Every view of this scene by its name"));
  connect(cameras, &QMenu::aboutToShow, scene_, [this, cameras] { scene_->fill_cameras(*cameras); });
  QAction* measure = add_action(
      view, tr("Measure Distance"), "view_measure", {}, {[] {}},
      tr("Click two places of the scene: distance, height and angles; Escape ends it; in the scene the key M"));
  measure->setCheckable(true);
  connect(measure, &QAction::toggled, scene_, &ScenePanel::measure);
  QAction* path = add_action(view, tr("Draw Path"), "view_draw_path", {}, {[] {}},
                             tr("Clicks put waypoints or legs behind the path of the selected platform; Enter ends it; "
                                "in the scene the key P"));
  path->setCheckable(true);
  connect(path, &QAction::toggled, scene_, &ScenePanel::draw_path);
  // The tool as it is: one that was refused has gone back already.
  connect(&scene_->scene(), &SceneWidget::tool_changed, this, [this, measure, path] {
    measure->setChecked(scene_->scene().tool() == SceneWidget::Tool::ruler);
    path->setChecked(scene_->scene().tool() == SceneWidget::Tool::path);
  });
  add_action(
      view, tr("Add Waypoint Here"), "view_add_waypoint", {}, [this] { scene_->add_point_here(); },
      tr("Put a point into the path of the selected platform under the pointer; or double click on the path"));
  add_action(
      view, tr("Delete Waypoint"), "view_delete_waypoint", {}, [this] { scene_->delete_point(); },
      tr("Take the selected point out of its path; in the scene the key Delete"));
  QAction* own = add_action(
      view, tr("&Handles Along Own Axes"), "view_own_axes", {}, {[] {}},
      tr("Arrows of what is selected lie along the axes of its platform, not the world's; in the scene the key L"));
  own->setCheckable(true);
  connect(own, &QAction::toggled, scene_, &ScenePanel::set_own_axes);
  connect(scene_, &ScenePanel::own_axes_changed, own, &QAction::setChecked);
}

}  // namespace sarsim::gui
