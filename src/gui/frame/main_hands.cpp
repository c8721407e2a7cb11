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
  QAction* own = add_action(
      view, tr("&Handles Along Own Axes"), "view_own_axes", {}, {[] {}},
      tr("Arrows of what is selected lie along the axes of its platform, not the world's; in the scene the key L"));
  own->setCheckable(true);
  connect(own, &QAction::toggled, scene_, &ScenePanel::set_own_axes);
  connect(scene_, &ScenePanel::own_axes_changed, own, &QAction::setChecked);
}

}  // namespace sarsim::gui
